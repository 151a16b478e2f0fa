#include "ui/window/figures/diagram_view.h"

#include <QEvent>
#include <QPainter>
#include <QTimer>
#include <exception>
#include <utility>

#include "core/base/input_error.h"
#include "ui/chart/chart_panel.h"
#include "ui/chart/diagram_picture.h"
#include "ui/draw/fonts.h"
#include "ui/draw/pixel_context.h"

namespace asperity {

namespace {

constexpr int kPause = 400;          // ms between two pictures
constexpr float kLeastText = 0.85F;  // views are low, which would make their texts small

DiagramSheet sheetOf(const DiagramView::Maker& maker) {
  try {
    return maker();
  } catch (const std::exception& error) {
    DiagramSheet sheet;
    sheet.title = messageOf(error);
    return sheet;
  }
}

}  // namespace

DiagramView::DiagramView(QWidget* parent) : QWidget(parent), pause_(new QTimer(this)) {
  setAttribute(Qt::WA_OpaquePaintEvent);
  pause_->setSingleShot(true);
  pause_->setInterval(kPause);
  connect(pause_, &QTimer::timeout, this, [this] {
    if (isDue_) request();
  });
}

void DiagramView::show(Maker maker) {
  maker_ = std::move(maker);
  requestSoon();
}

void DiagramView::setTheme(const Theme& theme) {
  theme_ = theme;
  requestSoon();
}

void DiagramView::requestSoon() {
  isDue_ = true;
  if (!pause_->isActive()) request();
}

/// Requests a picture. A hidden view waits until it is visible.
void DiagramView::request() {
  if (!isVisible() || !maker_ || size().isEmpty()) return;
  isDue_ = false;
  pause_->start();
  const double scale = devicePixelRatioF();
  const QSize pixels = size() * scale;
  const DiagramOptions options{pixels.width(), pixels.height(),
                               static_cast<float>(scale * markScale(font())), theme_, kLeastText};
  ++asked_;
  pictures_.request(
      [maker = maker_, options, scale](const BackgroundWork::Run&) {
        QImage image = renderImage(contextOfThread(), composeDiagrams(sheetOf(maker), options));
        image.setDevicePixelRatio(scale);
        return image;
      },
      [this, number = asked_](const QImage& image) {
        shown_ = number;
        image_ = image;
        update();
        emit painted();
      },
      [this](const QString& reason) { emit failed(reason); });
}

void DiagramView::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  emit visibilityChanged(true);
  requestSoon();
}

void DiagramView::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  emit visibilityChanged(false);
}

void DiagramView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  requestSoon();
}

/// The texts of the picture have the font and language of the window.
void DiagramView::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange || event->type() == QEvent::LanguageChange) requestSoon();
}

/// Stretches the last picture until one of the new size is ready.
void DiagramView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), colourOf(theme_.background));
  if (image_.isNull()) return;
  painter.setRenderHint(QPainter::SmoothPixmapTransform,
                        image_.size() != size() * devicePixelRatioF());
  painter.drawImage(rect(), image_);
}

}  // namespace asperity
