// The two backends that draw contact pictures on the screen, and the request for a picture. One
// uses OpenGL in a QOpenGLWidget, whose context is current only inside its overridden functions and
// its destructor, on the GUI thread. The other shows images that the program's own rasterizer draws
// in the background. GUI thread; the widgets belong to their parent.
#pragma once

#include <QSize>
#include <QString>
#include <functional>
#include <memory>
#include <vector>

#include "core/run/frame.h"
#include "ui/contact/contact_picture.h"
#include "ui/language/language.h"

class QWidget;

namespace asperity {

/// The content of a canvas. Plain values; any thread.
struct PictureRequest {
  std::shared_ptr<const Frame> frame;  // null: nothing is drawn
  ContactPictureOptions options;       // without size and scale, which the canvas knows; a backend
                                       // keeps the labels where its last picture had them
  QSize size;                          // device pixels
  double scale = 1;                    // device pixels per logical pixel
  double textScale = 1;                // extra factor of fonts and line widths
};

/// Returns the options with size and scale.
ContactPictureOptions sizedOptions(const PictureRequest& request);

struct CanvasEvents {
  /// Called when the picture of this frame is ready: it is painted together with all that changes
  /// now.
  std::function<void(const std::shared_ptr<const Frame>&)> ready;
  /// Called when another picture is on the screen, with the places of its labels.
  std::function<void(const std::vector<LabelPlace>&)> painted;
  /// Called with one sentence when no more pictures will come.
  std::function<void(const LiveText&)> failed;
};

class CanvasBackend {
 public:
  virtual ~CanvasBackend() = default;
  virtual QWidget* widget() = 0;
  virtual QString name() const = 0;
  /// Shows a picture; size and scale of the request are those of the widget.
  virtual void show(const PictureRequest& request) = 0;
};

/// Returns whether a window can have an OpenGL 3.3 core context here, and what implements it.
enum class OpenGlSupport { None, Software, Hardware };
OpenGlSupport openGlSupport();

CanvasBackend* makeOpenGlCanvas(CanvasEvents events, QWidget* parent);
CanvasBackend* makeSoftwareCanvas(CanvasEvents events, QWidget* parent);

}  // namespace asperity
