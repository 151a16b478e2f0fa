#include "ui/window/figures/figure_picture.h"

#include <QEvent>
#include <QPainter>
#include <utility>

#include "ui/chart/chart_style.h"
#include "ui/chart/figure_drawing.h"
#include "ui/draw/fonts.h"
#include "ui/draw/pixel_context.h"
#include "ui/language/translated.h"

namespace asperity {

FigurePicture::FigurePicture(QWidget* parent) : QWidget(parent) {
  setObjectName("figurePicture");
  setAttribute(Qt::WA_OpaquePaintEvent);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void FigurePicture::showFigure(std::shared_ptr<const ComputedFigure> made) {
  if (made == figure_) return;
  figure_ = std::move(made);
  describe();
  pictures_.cancel();
  requestPicture();
}

void FigurePicture::describe() {
  setAccessibleName(translatedText(figure_->figure.sheet.title));
  setAccessibleDescription(translatedText(figure_->figure.sheet.note));
}

void FigurePicture::showText(const QString& text) {
  pictures_.cancel();
  figure_.reset();
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

void FigurePicture::setMinTextSize(float part) {
  minTextSize_ = part;
  requestPicture();
}

bool FigurePicture::isPainted() const {
  return figure_ && !pictures_.isBusy() && image_.size() == size() * devicePixelRatioF();
}

void FigurePicture::requestPicture() {
  if (!figure_ || size().isEmpty()) return;
  const double scale = devicePixelRatioF();
  const QSize pixels = size() * scale;
  DiagramOptions options{pixels.width(), pixels.height(),
                         static_cast<float>(scale * markScale(font())), theme_, minTextSize_};
  pictures_.request(
      [made = figure_, options, scale](const BackgroundWork::Run&) {
        QImage image = renderImage(contextOfThread(),
                                   composeFigure(made->figure, made->contact.get(), options));
        image.setDevicePixelRatio(scale);
        return image;
      },
      [this](const QImage& image) {
        image_ = image;
        update();
        emit painted();
      },
      [this](const LiveText& reason) { emit failed(reason); });
}

/// The texts of the picture have the font and language of the window.
void FigurePicture::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LanguageChange && figure_) describe();
  if (event->type() == QEvent::FontChange || event->type() == QEvent::LanguageChange)
    requestPicture();
}

void FigurePicture::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  requestPicture();
}

/// Stretches the last picture until one of the new size is ready.
void FigurePicture::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (!image_.isNull()) {
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(rect(), image_);
    return;
  }
  painter.fillRect(rect(), toQColor(theme_.background));
  painter.setPen(toQColor(theme_.faintText));
  if (!figure_)
    painter.drawText(rect().adjusted(40, 20, -40, -20), Qt::AlignCenter | Qt::TextWordWrap, text_);
}

}  // namespace asperity
