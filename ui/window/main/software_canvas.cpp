// Canvas without OpenGL in the window: shows the images that a PictureWorker makes.
#include <QPainter>
#include <QResizeEvent>
#include <QWidget>
#include <utility>

#include "ui/window/main/canvas_backend.h"
#include "ui/window/main/contact_canvas.h"
#include "ui/window/tasks/picture_worker.h"

namespace asperity {

namespace {

class SoftwareCanvas : public QWidget, public CanvasBackend {
 public:
  SoftwareCanvas(CanvasEvents events, QWidget* parent)
      : QWidget(parent), events_(std::move(events)), worker_(workerEvents()) {
    setObjectName("softwareCanvas");
    setAttribute(Qt::WA_OpaquePaintEvent);
  }

  QWidget* widget() override { return this; }
  QString name() const override { return ContactCanvas::tr("software (OSMesa)"); }

  void show(const PictureRequest& request) override {
    request_ = request;
    requestPicture();
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
    if (std::exchange(isNew_, false) && events_.painted) events_.painted();
  }

 private:
  bool isFitting() const { return image_.size() == size() * devicePixelRatioF(); }

  QColor colour() const {
    const Rgba& c = request_.options.theme.background;
    return request_.frame ? QColor::fromRgbF(c.r, c.g, c.b) : palette().color(QPalette::Window);
  }

  void requestPicture() {
    request_.scale = devicePixelRatioF();
    request_.size = size() * request_.scale;
    if (!request_.frame || request_.size.isEmpty()) return;
    worker_.request({[request = request_] { return composePicture(request); }, request_.scale});
  }

  /// Both arrive on the worker's thread and go on here; dropped once this widget is gone.
  PictureWorkerEvents workerEvents() {
    PictureWorkerEvents events;
    events.finished = [this](QImage image) {
      QMetaObject::invokeMethod(this, [this, image] {
        image_ = image;
        isNew_ = true;
        update();
      });
    };
    events.failed = [this](const QString& reason) {
      QMetaObject::invokeMethod(this, [this, reason] {
        if (events_.failed) events_.failed(reason);
      });
    };
    return events;
  }

  CanvasEvents events_;
  PictureRequest request_;
  QImage image_;
  bool isNew_ = false;    // not painted yet
  PictureWorker worker_;  // last: its thread ends before anything else here goes
};

}  // namespace

CanvasBackend* makeSoftwareCanvas(CanvasEvents events, QWidget* parent) {
  return new SoftwareCanvas(std::move(events), parent);
}

}  // namespace asperity
