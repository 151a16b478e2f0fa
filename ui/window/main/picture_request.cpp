#include "ui/window/main/picture_request.h"

namespace asperity {

ContactPictureOptions sizedOptions(const PictureRequest& request) {
  ContactPictureOptions options = request.options;
  options.width = request.size.width();
  options.height = request.size.height();
  options.scale = static_cast<float>(request.scale * request.textScale);
  return options;
}

DrawList composePicture(const PictureRequest& request) {
  return composeContact(*request.frame, sizedOptions(request));
}

}  // namespace asperity
