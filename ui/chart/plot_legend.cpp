#include "ui/chart/plot_legend.h"
#include "ui/language/language.h"

#include <QEnterEvent>
#include <QEvent>
#include <QFontMetricsF>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

#include "ui/chart/plot_marks.h"
#include "ui/language/language.h"

namespace asperity {

namespace {

constexpr double kSide = 16;
constexpr double kSample = 22;    // width of a sample of a mark, pixels
constexpr double kSampleGap = 6;  // between it and its name
constexpr double kCross = 16;     // that lets a pinned curve go
constexpr double kGap = 18;       // between entries
constexpr int kMostRows = 3;
constexpr int kMostLines = 2;  // of one entry

/// A text that is too long for its room, broken after commas.
QStringList brokenInto(const QString& text, double room, const QFontMetricsF& metrics) {
  QStringList lines(1);
  const QStringList parts = text.split(QStringLiteral(", "));
  for (qsizetype i = 0; i < parts.size(); ++i) {
    const QString part = i + 1 < parts.size() ? parts[i] + ',' : parts[i];
    const QString longer = lines.last().isEmpty() ? part : lines.last() + ' ' + part;
    const bool fits = metrics.horizontalAdvance(longer) <= room || lines.last().isEmpty();
    if (fits || lines.size() == kMostLines)
      lines.last() = longer;
    else
      lines += part;
  }
  for (QString& line : lines) line = metrics.elidedText(line, Qt::ElideRight, room);
  return lines;
}

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
  keepTranslated(*this, [this] { setAccessibleName(tr("legend of the plot")); });
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

double PlotLegend::scale() const {
  return markScale(font());
}

double PlotLegend::samples() const {
  return (kSample + kSampleGap) * scale();
}

double PlotLegend::noteWidth() const {
  return QFontMetricsF(font()).horizontalAdvance(plot_.note);
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
    const double room = std::max(40.0, width() - 2 * kSide - samples() - extra);
    entry.lines = brokenInto(entry.text, room, metrics);
    double widest = 0;
    for (const QString& part : entry.lines)
      widest = std::max(widest, metrics.horizontalAdvance(part));
    const double wide = samples() + widest + extra;
    if (x + wide > end() && (x > kSide || row == 0)) {
      if (row + 1 >= kMostRows || missing > 0) {
        ++missing;
        return;
      }
      ++row;
      x = kSide;
      y += height;
    }
    const auto more = static_cast<int>(entry.lines.size()) - 1;
    entry.box = QRectF(x, y, wide, height * (more + 1));
    row += more;
    y += more * height;
    x += wide + kGap * scale();
    entries_.push_back(std::move(entry));
  };
  const std::vector<int> order = orderOf(plot_);
  const auto addSeries = [&](int i) {
    const PlotSeries& series = plot_.series[static_cast<std::size_t>(i)];
    add({series.name, {}, i, false, {}}, series.isPinned() ? kCross * scale() : 0);
  };
  for (const int i : order)
    if (!plot_.series[static_cast<std::size_t>(i)].isPinned()) addSeries(i);
  if (plot_.marker && !plot_.marker->name.isEmpty()) add({plot_.marker->name, {}, -1, true, {}}, 0);
  for (const int i : order)
    if (plot_.series[static_cast<std::size_t>(i)].isPinned()) addSeries(i);
  if (missing > 0) {
    const QString text = tr("and %n more", nullptr, missing);
    entries_.push_back({text, {text}, -1, false, QRectF(x, y, 120, height)});
  }
  const int all = static_cast<int>(y + height + 4);
  if (minimumHeight() != all || maximumHeight() != all) setFixedHeight(all);
}

QStringList PlotLegend::linesOf(int id) const {
  for (const Entry& entry : entries_)
    if (entry.series >= 0 && plot_.series[static_cast<std::size_t>(entry.series)].id == id)
      return entry.lines;
  return {};
}

/// The whole of a name, which may be shortened, and what a click does.
QString PlotLegend::tipAt(QPointF place) const {
  for (const Entry& entry : entries_) {
    if (!entry.box.contains(place)) continue;
    if (pinAt(place)) return entry.text + '\n' + tr("Click to unpin this curve");
    if (entry.lines.join(' ') != entry.text) return entry.text;
  }
  return {};
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
  setToolTip(tipAt(event->position()));
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
  painter.setPen(colours_.faintText);
  painter.drawText(QRectF(0, 4, width() - kSide, metrics.height() + 6),
                   Qt::AlignRight | Qt::AlignVCenter, plot_.note);
}

void PlotLegend::paintEntry(QPainter& painter, const Entry& entry) const {
  const QRectF& box = entry.box;
  const double height = box.height() / static_cast<double>(entry.lines.size());
  const QPointF centre(box.left() + kSample * scale() / 2, box.top() + height / 2);
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
    painter.setOpacity(plot_.marker->faded ? kFadedOpacity : 1);
    painter.setPen(QPen(colours_.marker, 1.4 * scale()));
    painter.drawLine(centre - QPointF(0, 8 * scale()), centre + QPointF(0, 8 * scale()));
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours_.marker);
    painter.drawEllipse(centre, 4.5 * scale(), 4.5 * scale());
    painter.setOpacity(1);
  }
  painter.setPen(entry.series < 0 && !entry.isMarker ? colours_.faintText : colours_.text);
  for (qsizetype i = 0; i < entry.lines.size(); ++i)
    painter.drawText(QRectF(box.left() + samples(), box.top() + static_cast<double>(i) * height,
                            box.width(), height),
                     Qt::AlignLeft | Qt::AlignVCenter, entry.lines[i]);
  if (!isPinned) return;
  painter.setPen(isUnder ? colours_.text : colours_.faintText);
  painter.drawText(QRectF(box.left(), box.top(), box.width(), height),
                   Qt::AlignRight | Qt::AlignVCenter, QStringLiteral("✕"));
}

void PlotLegend::paintSample(QPainter& painter, const PlotSeries& series, QPointF centre) const {
  const QColor colour = colourOf(series, colours_);
  painter.setOpacity(series.faded ? kFadedOpacity : 1);
  if (series.style == PlotStyle::Line || series.isPinned()) {
    painter.setPen(QPen(colour, (series.isPinned() ? 1.2 : 2) * scale()));
    painter.drawLine(centre - QPointF(kSample * scale() / 2, 0),
                     centre + QPointF(kSample * scale() / 2, 0));
  }
  if (series.style == PlotStyle::Points) {
    painter.setPen(QPen(colour, 1.3 * scale()));
    if (hasErrors(series) && !series.isPinned())
      paintErrorBar(painter, centre.x(), centre.y() - 7 * scale(), centre.y() + 7 * scale(),
                    kErrorCap * scale());
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    paintMark(painter, series.mark, centre, 3.6 * scale());
  }
  painter.setOpacity(1);
}

}  // namespace asperity
