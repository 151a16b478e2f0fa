#include "ui/window/contact/canvas_backend.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QOpenGLWidget>
#include <QPainter>
#include <QResizeEvent>
#include <QSurfaceFormat>
#include <QTimer>
#include <exception>
#include <tuple>
#include <utility>
#include <vector>

#include "ui/draw/fonts.h"
#include "ui/draw/pixel_context.h"
#include "ui/draw/renderer.h"
#include "ui/window/contact/contact_canvas.h"
#include "ui/window/tasks/background_work.h"

namespace asperity {

namespace {

QSurfaceFormat coreFormat() {
  QSurfaceFormat format;
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  return format;
}

/// Composes one picture after the other, with the labels where the last picture of the same size
/// had them. One thread at a time.
class PictureSequence {
 public:
  DrawList compose(const PictureRequest& request) {
    ContactPictureOptions options = sizedOptions(request);
    if (options.width == width_ && options.height == height_ && options.scale == scale_)
      options.lastLabels = labels_;
    else
      options.lastLabels.clear();
    width_ = options.width;
    height_ = options.height;
    scale_ = options.scale;
    return composeContact(*request.frame, options, &labels_);
  }

  /// Returns the places of the labels in the last picture.
  const std::vector<LabelPlace>& labels() const { return labels_; }

 private:
  int width_ = 0, height_ = 0;
  float scale_ = 0;
  std::vector<LabelPlace> labels_;
};

/// Draws with the shared Renderer.
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
    if (events_.ready) events_.ready(request_.frame);
  }

 protected:
  void initializeGL() override {
    try {
      renderer_ = std::make_unique<Renderer>([](const char* name) {
        return reinterpret_cast<void*>(QOpenGLContext::currentContext()->getProcAddress(name));
      });
    } catch (const std::exception& error) {
      fail(liveError(error));
    }
  }

  void paintGL() override {
    QPainter painter(this);
    if (!renderer_ || !request_.frame) return painter.fillRect(rect(), palette().window());
    request_.scale = devicePixelRatioF();
    request_.size = size() * request_.scale;
    const DrawList list = sequence_.compose(request_);
    painter.beginNativePainting();
    renderer_->draw(list, defaultFramebufferObject());
    painter.endNativePainting();
    painter.scale(1 / request_.scale, 1 / request_.scale);
    paintTexts(painter, list);
    if (events_.painted) events_.painted(sequence_.labels());
  }

 private:
  void fail(const LiveText& reason) {
    // The failure is reported after initializeGL, because the owner will replace this widget.
    QTimer::singleShot(0, this, [this, reason] {
      if (events_.failed) events_.failed(reason);
    });
  }

  CanvasEvents events_;
  std::unique_ptr<Renderer> renderer_;
  PictureRequest request_;
  PictureSequence sequence_;
};

/// Shows the images that are drawn in the background.
class SoftwareCanvas : public QWidget, public CanvasBackend {
 public:
  SoftwareCanvas(CanvasEvents events, QWidget* parent)
      : QWidget(parent), events_(std::move(events)) {
    setObjectName("softwareCanvas");
    setAttribute(Qt::WA_OpaquePaintEvent);
  }

  QWidget* widget() override { return this; }
  QString name() const override { return ContactCanvas::tr("software"); }

  void show(const PictureRequest& request) override {
    request_ = request;
    if (request_.frame) return requestPicture();
    pictures_.cancel();
    image_ = {};
    update();
  }

 protected:
  void resizeEvent(QResizeEvent* event) override {
    QWidget::resizeEvent(event);
    requestPicture();
  }

  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    if (image_.isNull() || !isFitting()) painter.fillRect(rect(), colour());
    if (!image_.isNull()) painter.drawImage(0, 0, image_);
    if (std::exchange(isNew_, false) && events_.painted) events_.painted(labels_);
  }

 private:
  bool isFitting() const { return image_.size() == size() * devicePixelRatioF(); }

  QColor colour() const {
    return request_.frame ? toQColor(request_.options.theme.background)
                          : palette().color(QPalette::Window);
  }

  void requestPicture() {
    request_.scale = devicePixelRatioF();
    request_.size = size() * request_.scale;
    if (hasFailed_ || !request_.frame || request_.size.isEmpty()) return;
    pictures_.request(
        [this, request = request_](const BackgroundWork::Run&) {
          QImage image = renderImage(contextOfThread(), sequence_.compose(request));
          image.setDevicePixelRatio(request.scale);
          return std::pair{image, sequence_.labels()};
        },
        [this, frame = request_.frame](const std::pair<QImage, std::vector<LabelPlace>>& made) {
          std::tie(image_, labels_) = made;
          isNew_ = true;
          update();
          if (events_.ready) events_.ready(frame);
        },
        [this](const LiveText& reason) { fail(reason); });
  }

  void fail(const LiveText& reason) {
    if (std::exchange(hasFailed_, true)) return;
    if (events_.failed) events_.failed(reason);
  }

  CanvasEvents events_;
  PictureRequest request_;
  QImage image_;
  std::vector<LabelPlace> labels_;  // of the image
  bool isNew_ = false;              // not painted yet
  bool hasFailed_ = false;
  PictureSequence sequence_;  // used by the thread of the pictures alone
  // Last: its thread ends before other members are destroyed.
  BackgroundWork pictures_{RequestPolicy::ReplaceWaiting};
};

}  // namespace

ContactPictureOptions sizedOptions(const PictureRequest& request) {
  ContactPictureOptions options = request.options;
  options.width = request.size.width();
  options.height = request.size.height();
  options.scale = static_cast<float>(request.scale * request.textScale);
  return options;
}

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

CanvasBackend* makeSoftwareCanvas(CanvasEvents events, QWidget* parent) {
  return new SoftwareCanvas(std::move(events), parent);
}

}  // namespace asperity
