#include "ui/window/import/topography_picture.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/number_text.h"
#include "ui/language/language.h"

namespace asperity {

namespace {

/// Shades that stay apart in print and for colour-blind eyes: from dark blue over green to yellow.
QRgb shadeOf(double part) {
  static constexpr struct {
    double red, green, blue;
  } kStops[] = {{45, 20, 80}, {50, 80, 140}, {35, 140, 140}, {95, 200, 100}, {250, 230, 60}};
  constexpr int kLast = 4;
  const double position = std::clamp(part, 0.0, 1.0) * kLast;
  const int below = std::min(static_cast<int>(position), kLast - 1);
  const double share = position - below;
  const auto mix = [&](double a, double b) { return static_cast<int>(a + (b - a) * share + 0.5); };
  const auto &a = kStops[below], &b = kStops[below + 1];
  return qRgb(mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue));
}

/// Returns the mean height of each patch of the grid; NaN where nothing was measured.
std::vector<double> patches(const Topography& topography, int width, int height) {
  std::vector<double> means;
  means.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y) {
    const std::int64_t top = y * topography.rows / height;
    const std::int64_t bottom = std::max(top + 1, (y + 1) * topography.rows / height);
    for (int x = 0; x < width; ++x) {
      const std::int64_t left = x * topography.columns / width;
      const std::int64_t right = std::max(left + 1, (x + 1) * topography.columns / width);
      double sum = 0;
      int count = 0;
      for (std::int64_t row = top; row < bottom; ++row)
        for (std::int64_t column = left; column < right; ++column)
          if (const double value = topography.at(row, column); !std::isnan(value)) {
            sum += value;
            ++count;
          }
      means.push_back(count > 0 ? sum / count : std::nan(""));
    }
  }
  return means;
}

QString lengthText(double metres) {
  return inLanguage(QString::fromStdString(printedQuantity(metres, "m", 3)));
}

}  // namespace

TopographyImage topographyImage(const Topography& topography, bool isTurned, int maxPixels) {
  TopographyImage made;
  if (topography.isProfile()) return made;
  const int width = static_cast<int>(std::min<std::int64_t>(topography.columns, maxPixels));
  const int height = static_cast<int>(std::min<std::int64_t>(topography.rows, maxPixels));
  const std::vector<double> means = patches(topography, width, height);
  std::vector<double> sorted;
  for (const double value : means)
    if (!std::isnan(value)) sorted.push_back(value);
  if (sorted.empty()) return made;
  std::ranges::sort(sorted);
  const std::size_t edge = sorted.size() / 100;
  made.lowest = sorted[edge];
  made.highest = sorted[sorted.size() - 1 - edge];
  const double range = made.highest > made.lowest ? made.highest - made.lowest : 1;
  QImage image(width, height, QImage::Format_ARGB32);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double value = means[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                 static_cast<std::size_t>(x)];
      image.setPixel(
          x, y, std::isnan(value) ? qRgba(0, 0, 0, 0) : shadeOf((value - made.lowest) / range));
    }
  made.isTurned = isTurned;
  made.image = isTurned ? image.transformed(QTransform(0, 1, 1, 0, 0, 0)) : image;
  made.width = isTurned ? topography.width() : topography.length();
  made.height = isTurned ? topography.length() : topography.width();
  return made;
}

TopographyPicture::TopographyPicture(QWidget* parent) : QWidget(parent) {
  setObjectName("topographyPicture");
}

void TopographyPicture::show(const TopographyImage& image, double row) {
  shown_ = image;
  row_ = row;
  setAccessibleName(tr("topography"));
  if (!image.image.isNull())
    setToolTip(tr("%1 × %2, heights over %3")
                   .arg(lengthText(image.width), lengthText(image.height),
                        lengthText(image.highest - image.lowest)));
  setVisible(!image.image.isNull());
  update();
}

void TopographyPicture::paintEvent(QPaintEvent*) {
  if (shown_.image.isNull()) return;
  QPainter painter(this);
  const QString text =
      QStringLiteral("%1 × %2").arg(lengthText(shown_.width), lengthText(shown_.height));
  const int line = fontMetrics().height();
  // Very long and narrow surfaces are shown less narrow than they are.
  constexpr double kNarrowest = 4;
  const QRectF available = QRectF(rect()).adjusted(1, 1, -1, -line - 4);
  const double ratio = std::clamp(shown_.width / shown_.height, 1 / kNarrowest, kNarrowest);
  QSizeF frame(available.width(), available.width() / ratio);
  if (frame.height() > available.height()) frame = {available.height() * ratio, available.height()};
  const QRectF imageRect({available.left(), available.top()}, frame);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(imageRect, shown_.image);
  painter.setPen(palette().color(QPalette::Mid));
  painter.drawRect(imageRect);
  const QColor mark(255, 60, 60);
  if (row_ >= 0) {
    painter.setPen(QPen(mark, 2));
    if (shown_.isTurned) {
      const double x = imageRect.left() + row_ * imageRect.width();
      painter.drawLine(QPointF(x, imageRect.top()), QPointF(x, imageRect.bottom()));
    } else {
      const double y = imageRect.top() + row_ * imageRect.height();
      painter.drawLine(QPointF(imageRect.left(), y), QPointF(imageRect.right(), y));
    }
  } else {
    painter.setPen(QPen(mark, 2));
    painter.drawRect(imageRect.adjusted(1, 1, -1, -1));
  }
  painter.setPen(palette().color(QPalette::WindowText));
  painter.drawText(QRectF(0, height() - line - 2, width(), line + 2),
                   Qt::AlignLeft | Qt::AlignVCenter,
                   fontMetrics().elidedText(text, Qt::ElideRight, width()));
}

}  // namespace asperity
