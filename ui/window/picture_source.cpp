#include "ui/window/picture_source.h"

namespace asperity {

DrawList PictureSource::compose(const PictureRequest& request) {
  view_ = fittedView(*request.frame, view_);
  ContactPictureOptions options;
  options.width = request.size.width();
  options.height = request.size.height();
  options.scale = static_cast<float>(request.scale);
  options.theme = request.theme;
  options.view = *view_;
  return composeContact(*request.frame, options);
}

}  // namespace asperity
