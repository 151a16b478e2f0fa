// One way to bring contact pictures to the screen: a widget and what it tells its owner.
// GUI thread; the widget belongs to its parent.
#pragma once

#include <QString>
#include <functional>

#include "ui/window/main/picture_request.h"

class QWidget;

namespace asperity {

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
