// Canvas by QOpenGLWidget and the shared Renderer. Its context is current only inside the
// overridden functions and the destructor, all on the GUI thread.
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QOpenGLWidget>
#include <QPainter>
#include <QSurfaceFormat>
#include <QTimer>
#include <exception>

#include "ui/draw/fonts.h"
#include "ui/draw/renderer.h"
#include "ui/window/main/canvas_backend.h"

namespace asperity {

namespace {

QSurfaceFormat coreFormat() {
  QSurfaceFormat format;
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  return format;
}

class GlCanvas : public QOpenGLWidget, public CanvasBackend {
 public:
  GlCanvas(CanvasEvents events, QWidget* parent)
      : QOpenGLWidget(parent), events_(std::move(events)) {
    setFormat(coreFormat());
    setObjectName("openGlCanvas");
  }

  ~GlCanvas() override {
    makeCurrent();
    renderer_.reset();
    doneCurrent();
  }

  QWidget* widget() override { return this; }
  QString name() const override { return QStringLiteral("OpenGL"); }

  void show(const PictureRequest& request) override {
    request_ = request;
    update();
  }

 protected:
  void initializeGL() override {
    try {
      renderer_ = std::make_unique<Renderer>([](const char* name) {
        return reinterpret_cast<void*>(QOpenGLContext::currentContext()->getProcAddress(name));
      });
    } catch (const std::exception& error) {
      fail(QString::fromUtf8(error.what()));
    }
  }

  void paintGL() override {
    QPainter painter(this);
    if (!renderer_ || !request_.frame) return painter.fillRect(rect(), palette().window());
    request_.scale = devicePixelRatioF();
    request_.size = size() * request_.scale;
    const DrawList list = composePicture(request_);
    painter.beginNativePainting();
    renderer_->draw(list, defaultFramebufferObject());
    painter.endNativePainting();
    painter.scale(1 / request_.scale, 1 / request_.scale);
    paintTexts(painter, list);
    if (events_.painted) events_.painted();
  }

 private:
  void fail(const QString& reason) {
    // Not from inside initializeGL: the owner will replace this widget.
    QTimer::singleShot(0, this, [this, reason] {
      if (events_.failed) events_.failed(reason);
    });
  }

  CanvasEvents events_;
  std::unique_ptr<Renderer> renderer_;
  PictureRequest request_;
};

}  // namespace

OpenGlSupport openGlSupport() {
  QOpenGLContext context;
  context.setFormat(coreFormat());
  if (!context.create() || context.format().version() < qMakePair(3, 3)) return OpenGlSupport::None;
  QOffscreenSurface surface;
  surface.setFormat(context.format());
  surface.create();
  if (!surface.isValid() || !context.makeCurrent(&surface)) return OpenGlSupport::None;
  const auto* text = reinterpret_cast<const char*>(context.functions()->glGetString(GL_RENDERER));
  const QByteArray renderer = text ? QByteArray(text).toLower() : QByteArray();
  context.doneCurrent();
  for (const char* name : {"llvmpipe", "softpipe", "swrast", "software"})
    if (renderer.contains(name)) return OpenGlSupport::Software;
  return OpenGlSupport::Hardware;
}

CanvasBackend* makeOpenGlCanvas(CanvasEvents events, QWidget* parent) {
  return new GlCanvas(std::move(events), parent);
}

}  // namespace asperity
