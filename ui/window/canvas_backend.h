// One way to bring contact pictures to the screen: a widget and what it tells its owner.
// GUI thread; the widget belongs to its parent.
#pragma once

#include <QString>
#include <functional>
#include <memory>

#include "core/run/frame.h"
#include "ui/picture/contact_picture.h"

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
  virtual void show(std::shared_ptr<const Frame> frame, const Theme& theme) = 0;
};

/// Whether a window here can have an OpenGL 3.3 core context, and what stands behind it.
enum class OpenGlSupport { None, Software, Hardware };
OpenGlSupport openGlSupport();

CanvasBackend* makeOpenGlCanvas(CanvasEvents events, QWidget* parent);
CanvasBackend* makeSoftwareCanvas(CanvasEvents events, QWidget* parent);

}  // namespace asperity
