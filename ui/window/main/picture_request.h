// What a canvas shows, and how it becomes a draw list. Plain values; any thread.
#pragma once

#include <QSize>
#include <memory>

#include "core/run/frame.h"
#include "ui/contact/contact_picture.h"

namespace asperity {

struct PictureRequest {
  std::shared_ptr<const Frame> frame;  // never null
  ContactPictureOptions options;       // but for size and scale, which the canvas knows
  QSize size;                          // device pixels
  double scale = 1;                    // device pixels for one of the window system's
  double textScale = 1;                // of fonts and line widths, beside that
};

/// The options with size and scale.
ContactPictureOptions sizedOptions(const PictureRequest& request);

DrawList composePicture(const PictureRequest& request);

}  // namespace asperity
