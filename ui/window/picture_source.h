// What a canvas shows, and how a frame becomes its draw list: the view is fitted to the frame and
// kept steady from one to the next. Used by one thread at a time.
#pragma once

#include <QSize>
#include <memory>
#include <optional>

#include "core/run/frame.h"
#include "ui/picture/contact_picture.h"

namespace asperity {

struct PictureRequest {
  std::shared_ptr<const Frame> frame;  // never null
  QSize size;                          // device pixels
  double scale = 1;                    // device pixels for one of the window system's
  Theme theme;
};

class PictureSource {
 public:
  DrawList compose(const PictureRequest& request);

 private:
  std::optional<ContactView> view_;
};

}  // namespace asperity
