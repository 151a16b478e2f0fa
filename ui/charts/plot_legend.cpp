#include "ui/charts/plot_legend.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>

#include "ui/charts/plot_overlay.h"

namespace asperity {

namespace {

constexpr double kSample = 22;    // width of a sample of a mark, pixels
constexpr double kGap = 18;       // between entries
constexpr double kBarWidth = 72;  // of the progress bar
constexpr double kBarHeight = 4;

bool hasErrors(const PlotSeries& series) {
  return std::any_of(series.points.begin(), series.points.end(),
                     [](const PlotPoint& point) { return point.error > 0; });
}

void paintErrorBar(QPainter& painter, QPointF centre) {
  painter.drawLine(centre - QPointF(0, 7), centre + QPointF(0, 7));
  for (const double y : {-7.0, 7.0})
    painter.drawLine(centre + QPointF(-3.5, y), centre + QPointF(3.5, y));
}

}  // namespace

PlotLegend::PlotLegend(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
}

void PlotLegend::show(const Plot& plot, const PlotColours& colours) {
  plot_ = plot;
  colours_ = colours;
  update();
}

QSize PlotLegend::sizeHint() const {
  return {400, fontMetrics().height() + 14};
}

void PlotLegend::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), colours_.background);
  const double end = paintNote(painter);
  const QFontMetricsF metrics(font());
  const double middle = height() / 2.0;
  const double baseline = middle + (metrics.ascent() - metrics.descent()) / 2;
  double x = 16;

  const auto entry = [&](const QString& name, auto&& sample) {
    const double width = kSample + 6 + metrics.horizontalAdvance(name);
    if (x + width > end - kGap) return;
    sample(QPointF(x + kSample / 2, middle));
    painter.setPen(colours_.text);
    painter.drawText(QPointF(x + kSample + 6, baseline), name);
    x += width + kGap;
  };
  for (auto series = plot_.series.rbegin(); series != plot_.series.rend(); ++series)
    if (!series->points.empty())
      entry(series->name, [&](QPointF centre) { paintSample(painter, *series, centre); });
  if (!plot_.marker || plot_.marker->name.isEmpty()) return;
  entry(plot_.marker->name, [&](QPointF centre) {
    painter.setPen(QPen(colours_.marker, 1.4));
    painter.drawLine(centre - QPointF(0, 8), centre + QPointF(0, 8));
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours_.marker);
    painter.drawEllipse(centre, 4.5, 4.5);
  });
}

/// At the right end; returns where it begins.
double PlotLegend::paintNote(QPainter& painter) const {
  const QFontMetricsF metrics(font());
  const double middle = height() / 2.0;
  double x = width() - 16.0;
  if (plot_.progress > 0 && plot_.progress < 1) {
    x -= kBarWidth;
    const QRectF bar(x, middle - kBarHeight / 2, kBarWidth, kBarHeight);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours_.grid);
    painter.drawRoundedRect(bar, 2, 2);
    painter.setBrush(colours_.points);
    painter.drawRoundedRect(QRectF(bar.topLeft(), QSizeF(kBarWidth * plot_.progress, kBarHeight)),
                            2, 2);
    x -= 10;
  }
  x -= metrics.horizontalAdvance(plot_.note);
  painter.setPen(colours_.faintText);
  painter.drawText(QPointF(x, middle + (metrics.ascent() - metrics.descent()) / 2), plot_.note);
  return x;
}

void PlotLegend::paintSample(QPainter& painter, const PlotSeries& series, QPointF centre) const {
  painter.setOpacity(series.faded ? kFadedOpacity : 1);
  if (series.style == PlotStyle::Line) {
    painter.setPen(QPen(colours_.line, 2));
    painter.drawLine(centre - QPointF(kSample / 2, 0), centre + QPointF(kSample / 2, 0));
  } else {
    painter.setPen(QPen(colours_.points, 1.3));
    if (hasErrors(series)) paintErrorBar(painter, centre);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours_.points);
    painter.drawEllipse(centre, 3.5, 3.5);
  }
  painter.setOpacity(1);
}

}  // namespace asperity
