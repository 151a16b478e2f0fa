// Two ways to bring contact pictures to the screen, and what they are asked to show. By OpenGL in a
// QOpenGLWidget, whose context is current only inside its overridden functions and its destructor,
// on the GUI thread; or by images that OSMesa makes in the background, where no context of Qt is
// current. GUI thread; the widgets belong to their parent.
#pragma once

#include <QSize>
#include <QString>
#include <functional>
#include <memory>

#include "core/run/frame.h"
#include "ui/contact/contact_picture.h"

class QWidget;

namespace asperity {

/// What a canvas shows. Plain values; any thread.
struct PictureRequest {
  std::shared_ptr<const Frame> frame;  // never null
  ContactPictureOptions options;       // but for size and scale, which the canvas knows
  QSize size;                          // device pixels
  double scale = 1;                    // device pixels for one of the window system's
  double textScale = 1;                // of fonts and line widths, beside that
};

/// The options with size and scale.
ContactPictureOptions sizedOptions(const PictureRequest& request);

struct CanvasEvents {
  std::function<void()> painted;               // another picture is on the screen
  std::function<void(const QString&)> failed;  // and nothing more will come; one sentence
};

class CanvasBackend {
 public:
  virtual ~CanvasBackend() = default;
  virtual QWidget* widget() = 0;
  virtual QString name() const = 0;
  /// Size and scale of the request are the widget's own.
  virtual void show(const PictureRequest& request) = 0;
};

/// Whether a window here can have an OpenGL 3.3 core context, and what stands behind it.
enum class OpenGlSupport { None, Software, Hardware };
OpenGlSupport openGlSupport();

CanvasBackend* makeOpenGlCanvas(CanvasEvents events, QWidget* parent);
CanvasBackend* makeSoftwareCanvas(CanvasEvents events, QWidget* parent);

}  // namespace asperity
