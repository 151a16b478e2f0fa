#include "ui/charts/plot_legend.h"

#include <QEnterEvent>
#include <QEvent>
#include <QFontMetricsF>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

#include "ui/charts/plot_marks.h"

namespace asperity {

namespace {

constexpr double kSide = 16;
constexpr double kSample = 22;    // width of a sample of a mark, pixels
constexpr double kSampleGap = 6;  // between it and its name
constexpr double kCross = 16;     // that lets a pinned curve go
constexpr double kGap = 18;       // between entries
constexpr double kBarWidth = 72;  // of the progress bar
constexpr double kBarHeight = 4;
constexpr int kMostRows = 3;

bool hasErrors(const PlotSeries& series) {
  return std::any_of(series.points.begin(), series.points.end(),
                     [](const PlotPoint& point) { return point.error > 0; });
}

/// The present curve's, then its law, then the pinned in their order.
std::vector<int> orderOf(const Plot& plot) {
  std::vector<int> order;
  const auto add = [&](auto&& belongs) {
    for (std::size_t i = 0; i < plot.series.size(); ++i)
      if (!plot.series[i].points.empty() && belongs(plot.series[i]))
        order.push_back(static_cast<int>(i));
  };
  add([](const PlotSeries& series) { return series.id == kPresentCurve; });
  add([](const PlotSeries& series) { return series.id < kPresentCurve; });
  add([](const PlotSeries& series) { return series.isPinned(); });
  return order;
}

}  // namespace

PlotLegend::PlotLegend(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  setMouseTracking(true);
  setObjectName("plotLegend");
  setAccessibleName(tr("legend of the plot"));
  arrange();
}

void PlotLegend::show(const Plot& plot, const PlotColours& colours) {
  plot_ = plot;
  colours_ = colours;
  arrange();
  update();
}

QRectF PlotLegend::placeOf(int id) const {
  for (const Entry& entry : entries_)
    if (entry.series >= 0 && plot_.series[static_cast<std::size_t>(entry.series)].id == id)
      return entry.box;
  return {};
}

double PlotLegend::noteWidth() const {
  const bool hasBar = plot_.progress > 0 && plot_.progress < 1;
  return QFontMetricsF(font()).horizontalAdvance(plot_.note) + (hasBar ? kBarWidth + 10 : 0);
}

/// Entries in rows; the first one ends at the note. The last place says how many found none.
void PlotLegend::arrange() {
  const QFontMetricsF metrics(font());
  const double height = metrics.height() + 6;
  entries_.clear();
  double x = kSide, y = 4;
  int row = 0, missing = 0;
  const auto end = [&] { return width() - kSide - (row == 0 ? noteWidth() + kGap : 0); };
  const auto add = [&](Entry entry, double extra) {
    const double room = width() - 2 * kSide - kSample - kSampleGap - extra;
    entry.text = metrics.elidedText(entry.text, Qt::ElideRight, std::max(40.0, room));
    const double wide = kSample + kSampleGap + metrics.horizontalAdvance(entry.text) + extra;
    if (x + wide > end() && (x > kSide || row == 0)) {
      if (row + 1 >= kMostRows || missing > 0) {
        ++missing;
        return;
      }
      ++row;
      x = kSide;
      y += height;
    }
    entry.box = QRectF(x, y, wide, height);
    x += wide + kGap;
    entries_.push_back(std::move(entry));
  };
  const std::vector<int> order = orderOf(plot_);
  const auto addSeries = [&](int i) {
    const PlotSeries& series = plot_.series[static_cast<std::size_t>(i)];
    add({series.name, i, false, {}}, series.isPinned() ? kCross : 0);
  };
  for (const int i : order)
    if (!plot_.series[static_cast<std::size_t>(i)].isPinned()) addSeries(i);
  if (plot_.marker && !plot_.marker->name.isEmpty()) add({plot_.marker->name, -1, true, {}}, 0);
  for (const int i : order)
    if (plot_.series[static_cast<std::size_t>(i)].isPinned()) addSeries(i);
  if (missing > 0)
    entries_.push_back({tr("and %n more", nullptr, missing), -1, false, QRectF(x, y, 120, height)});
  const int all = static_cast<int>(y + height + 4);
  if (minimumHeight() != all || maximumHeight() != all) setFixedHeight(all);
}

void PlotLegend::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  arrange();
}

void PlotLegend::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange) arrange();
}

std::optional<int> PlotLegend::pinAt(QPointF place) const {
  for (const Entry& entry : entries_) {
    if (entry.series < 0 || !entry.box.contains(place)) continue;
    const PlotSeries& series = plot_.series[static_cast<std::size_t>(entry.series)];
    if (series.isPinned()) return series.id;
  }
  return std::nullopt;
}

void PlotLegend::mouseMoveEvent(QMouseEvent* event) {
  const std::optional<int> pin = pinAt(event->position());
  const int under = pin.value_or(0);
  setCursor(pin ? Qt::PointingHandCursor : Qt::ArrowCursor);
  setToolTip(pin ? tr("Click to unpin this curve") : QString());
  if (under == under_) return;
  under_ = under;
  update();
}

void PlotLegend::enterEvent(QEnterEvent* event) {
  QWidget::enterEvent(event);
  emit entered();
}

void PlotLegend::leaveEvent(QEvent* event) {
  QWidget::leaveEvent(event);
  under_ = 0;
  update();
}

void PlotLegend::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return QWidget::mouseReleaseEvent(event);
  if (const std::optional<int> pin = pinAt(event->position())) emit unpinWanted(*pin);
}

void PlotLegend::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), colours_.background);
  paintNote(painter);
  for (const Entry& entry : entries_) paintEntry(painter, entry);
}

/// At the right end of the first row.
void PlotLegend::paintNote(QPainter& painter) const {
  const QFontMetricsF metrics(font());
  const double height = metrics.height() + 6, middle = 4 + height / 2;
  double x = width() - kSide;
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
  painter.setPen(colours_.faintText);
  painter.drawText(QRectF(0, 4, x, height), Qt::AlignRight | Qt::AlignVCenter, plot_.note);
}

void PlotLegend::paintEntry(QPainter& painter, const Entry& entry) const {
  const QRectF& box = entry.box;
  const QPointF centre(box.left() + kSample / 2, box.center().y());
  const bool isPinned =
      entry.series >= 0 && plot_.series[static_cast<std::size_t>(entry.series)].isPinned();
  const bool isUnder =
      isPinned && plot_.series[static_cast<std::size_t>(entry.series)].id == under_;
  if (isUnder) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours_.span);
    painter.drawRoundedRect(box.adjusted(-4, 0, 4, 0), 4, 4);
  }
  if (entry.series >= 0)
    paintSample(painter, plot_.series[static_cast<std::size_t>(entry.series)], centre);
  if (entry.isMarker) {
    painter.setPen(QPen(colours_.marker, 1.4));
    painter.drawLine(centre - QPointF(0, 8), centre + QPointF(0, 8));
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours_.marker);
    painter.drawEllipse(centre, 4.5, 4.5);
  }
  painter.setPen(entry.series < 0 && !entry.isMarker ? colours_.faintText : colours_.text);
  painter.drawText(box.adjusted(kSample + kSampleGap, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                   entry.text);
  if (!isPinned) return;
  painter.setPen(isUnder ? colours_.text : colours_.faintText);
  painter.drawText(QRectF(box.right() - kCross, box.top(), kCross, box.height()),
                   Qt::AlignRight | Qt::AlignVCenter, QStringLiteral("✕"));
}

void PlotLegend::paintSample(QPainter& painter, const PlotSeries& series, QPointF centre) const {
  const QColor colour = colourOf(series, colours_);
  painter.setOpacity(series.faded ? kFadedOpacity : 1);
  if (series.style == PlotStyle::Line || series.isPinned()) {
    painter.setPen(QPen(colour, series.isPinned() ? 1.2 : 2));
    painter.drawLine(centre - QPointF(kSample / 2, 0), centre + QPointF(kSample / 2, 0));
  }
  if (series.style == PlotStyle::Points) {
    painter.setPen(QPen(colour, 1.3));
    if (hasErrors(series) && !series.isPinned())
      paintErrorBar(painter, centre.x(), centre.y() - 7, centre.y() + 7);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    paintMark(painter, series.mark, centre, 3.6);
  }
  painter.setOpacity(1);
}

}  // namespace asperity
