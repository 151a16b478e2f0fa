#include "ui/window/figures/figure_picture.h"

#include <QEvent>
#include <QPainter>

#include "ui/chart/chart_panel.h"
#include "ui/language/translated.h"
#include "ui/chart/figure_drawing.h"
#include "ui/window/main/appearance.h"

namespace asperity {

FigurePicture::FigurePicture(QWidget* parent) : QWidget(parent) {
  setObjectName("figurePicture");
  setAttribute(Qt::WA_OpaquePaintEvent);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void FigurePicture::showFigure(std::shared_ptr<const MadeFigure> made) {
  if (made == made_) return;
  made_ = std::move(made);
  setAccessibleName(translatedText(made_->figure.sheet.title));
  setAccessibleDescription(translatedText(made_->figure.sheet.note));
  first_ = asked_ + 1;
  requestPicture();
}

void FigurePicture::showText(const QString& text) {
  made_.reset();
  image_ = {};
  text_ = text;
  setAccessibleName(text);
  setAccessibleDescription({});
  update();
}

void FigurePicture::setTheme(const Theme& theme) {
  theme_ = theme;
  requestPicture();
  update();
}

void FigurePicture::setLeastText(float part) {
  leastText_ = part;
  requestPicture();
}

bool FigurePicture::isPainted() const {
  return made_ && shown_ == asked_ && image_.size() == size() * devicePixelRatioF();
}

void FigurePicture::requestPicture() {
  if (!made_ || size().isEmpty()) return;
  const double scale = devicePixelRatioF();
  const QSize pixels = size() * scale;
  DiagramOptions options{pixels.width(), pixels.height(),
                         static_cast<float>(scale * markScale(font())), theme_, leastText_};
  ++asked_;
  worker().request({[this, number = asked_, made = made_, options] {
                      composed_ = number;
                      return composeFigure(made->figure, made->contact.get(), options);
                    },
                    scale});
}

/// Made when it is first needed: it has a thread and an OSMesa context. Its events arrive on that
/// thread and go on here; dropped once this widget is gone.
PictureWorker& FigurePicture::worker() {
  if (worker_) return *worker_;
  PictureWorkerEvents events;
  events.finished = [this](QImage image) {
    QMetaObject::invokeMethod(
        this, [this, number = composed_, image = std::move(image)] { take(number, image); });
  };
  events.failed = [this](const QString& reason) {
    QMetaObject::invokeMethod(this, [this, reason] { emit failed(reason); });
  };
  worker_ = std::make_unique<PictureWorker>(std::move(events));
  return *worker_;
}

void FigurePicture::take(std::uint64_t number, const QImage& image) {
  if (!made_ || number < first_) return;
  shown_ = number;
  image_ = image;
  update();
  emit painted();
}

/// Its texts follow those of the window.
void FigurePicture::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange) requestPicture();
}

void FigurePicture::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  requestPicture();
}

/// While a picture of the new size is being made the last one is stretched.
void FigurePicture::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (!image_.isNull()) {
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(rect(), image_);
    return;
  }
  painter.fillRect(rect(), colourOf(theme_.background));
  painter.setPen(colourOf(theme_.faintText));
  if (!made_)
    painter.drawText(rect().adjusted(40, 20, -40, -20), Qt::AlignCenter | Qt::TextWordWrap, text_);
}

}  // namespace asperity
