#include "ui/chart/transient_strips.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/run/minimum_span.h"
#include "ui/chart/decade_range.h"
#include "ui/chart/plot_marks.h"
#include "ui/chart/relaxation_guide.h"
#include "ui/chart/tick_label.h"
#include "ui/draw/ticks.h"
#include "ui/language/language.h"

namespace asperity {

namespace {

constexpr double kLeft = 78, kRight = 34;  // margins of the strips, pixels, at least
constexpr double kGap = 8;                 // between strips
constexpr double kNameGap = 8;             // on either side of the names beside them
constexpr double kMostForNames = 0.2;      // of the width
constexpr double kTickWidth = 90;          // that a label of a time needs, times the letters' scale

/// Where a strip begins and ends, with some air; never empty.
AxisEnds rangeOf(const std::vector<QPointF>& line, double least) {
  if (line.empty()) return {0, 1};
  const auto [low, high] = std::ranges::minmax_element(line, {}, &QPointF::y);
  return axisEnds(low->y(), high->y(), std::max(least, 0.02));
}

QPainterPath pathOf(const std::vector<QPointF>& line, auto&& place) {
  QPainterPath path;
  for (const QPointF& point : line)
    path.elementCount() == 0 ? path.moveTo(place(point)) : path.lineTo(place(point));
  return path;
}

}  // namespace

TransientStrips::TransientStrips(QWidget* parent) : QWidget(parent) {
  setObjectName("transientStrips");
  setAttribute(Qt::WA_OpaquePaintEvent);
  keepTranslated(*this, [this] {
    setAccessibleName(tr("friction, indentation and contact length in time"));
    setAccessibleDescription(note());
    update();
  });
}

void TransientStrips::show(const Sliding& sliding,
                           std::shared_ptr<const std::vector<TransientSample>> samples,
                           double spacing, double period) {
  sliding_ = sliding;
  spacing_ = spacing;
  period_ = period;
  samples_ = std::move(samples);
  guide_.clear();
  if (samples_)
    for (const GuidePoint& point : relaxationGuide(sliding_, *samples_))
      guide_.emplace_back(point.time, point.mu);
  setAccessibleDescription(note());
  update();
}

void TransientStrips::setColours(const PlotColours& colours) {
  colours_ = colours;
  update();
}

QString TransientStrips::note() const {
  if (sampleCount() == 0) return tr("nothing has moved yet");
  if (!hasGuide()) return {};
  const double rate = samples_->back().predictedRate;
  return tr("predicted rate 1/τ + v/ℓ = %1 (exact for one contact, a guide on rough lines)")
      .arg(readingLabel(rate) + " s⁻¹");
}

TransientStrips::Line TransientStrips::lineOf(
    const std::function<double(const TransientSample&)>& value) const {
  Line line;
  if (!samples_) return line;
  for (const TransientSample& sample : *samples_)
    if (std::isfinite(value(sample))) line.emplace_back(sample.time, value(sample));
  return line;
}

void TransientStrips::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), colours_.background);
  const double text = fontMetrics().height();
  const double left = std::max(kLeft, fontMetrics().horizontalAdvance("8.88×10⁻⁵") + 14.0);
  const QStringList names{tr("friction μ"), tr("indentation d"), tr("contact length ℓ")};
  const double right = std::max(kRight, nameWidth(names) + 2 * kNameGap);
  const QRectF area(left, text + 14, width() - left - right, height() - 2 * text - 26);
  paintLegend(painter, {16, 0, width() - 32.0, text + 14});
  const double each = (area.height() - 2 * kGap) / 3;
  QRectF strip(area.left(), area.top(), area.width(), each);
  const MinimumSpan floors = samples_ ? minimumSpan(*samples_, spacing_, period_) : MinimumSpan{};
  const auto next = [&](const QString& name, const char* unit, const Line& line, const Line& over,
                        double least) {
    paintStrip(painter, strip, unit, line, over, least);
    painter.setPen(colours_.text);
    painter.drawText(nameRoom(strip), Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap, name);
    strip.translate(0, each + kGap);
  };
  next(names[0], "", lineOf([](const auto& s) { return s.mu; }), guide_, floors.friction);
  next(names[1], "m", lineOf([](const auto& s) { return s.indentation; }), {}, floors.indentation);
  next(names[2], "m", lineOf([](const auto& s) { return s.contactLength; }), {},
       floors.contactLength);
  paintTimes(painter, area);
}

/// What the dashes mean, and the rate now.
void TransientStrips::paintLegend(QPainter& painter, const QRectF& room) const {
  const double scale = markScale(font());
  if (hasGuide()) {
    painter.setPen(QPen(colours_.marker, 1.6 * scale, Qt::DashLine));
    painter.drawLine(QPointF(room.left(), room.center().y()),
                     QPointF(room.left() + 22 * scale, room.center().y()));
  }
  painter.setPen(colours_.text);
  const QRectF place = room.adjusted(hasGuide() ? 28 * scale : 0, 0, 0, 0);
  painter.drawText(
      place, Qt::AlignVCenter,
      fontMetrics().elidedText(note(), Qt::ElideRight, static_cast<int>(place.width())));
}

void TransientStrips::paintStrip(QPainter& painter, const QRectF& room, const char* unit,
                                 const Line& line, const Line& guide, double least) const {
  const auto [low, high] = rangeOf(line, least);
  const auto place = [&, low = low, high = high](const QPointF& point) {
    return QPointF(room.left() + room.width() * point.x() / sliding_.duration,
                   room.bottom() - room.height() * (point.y() - low) / (high - low));
  };
  if (!line.empty())
    paintValues(painter, room, unit, {low, high}, [&](double y) { return place({0, y}).y(); });
  painter.setPen(colours_.axis);
  painter.drawRect(room);
  painter.save();
  painter.setClipRect(room);
  const double scale = markScale(font());
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colours_.points, 1.8 * scale));
  painter.drawPath(pathOf(line, place));
  painter.setPen(QPen(colours_.marker, 1.6 * scale, Qt::DashLine));
  painter.drawPath(pathOf(guide, place));
  painter.restore();
}

/// On one line each where that leaves most of the width to the strips, else word by word.
double TransientStrips::nameWidth(const QStringList& names) const {
  double whole = 0, words = 0;
  for (const QString& name : names) {
    whole = std::max<double>(whole, fontMetrics().horizontalAdvance(name));
    for (const QString& word : name.split(' '))
      words = std::max<double>(words, fontMetrics().horizontalAdvance(word));
  }
  return whole < kMostForNames * width() ? whole : words;
}

/// Beside the strip, where no curve comes; the last line of a name in a low one reaches beyond it.
QRectF TransientStrips::nameRoom(const QRectF& strip) const {
  const double left = strip.right() + kNameGap;
  return {left, strip.top() - kGap, width() - left, strip.height() + 2 * kGap};
}

/// Labels at the ends would meet those of the next strip: they stay away where two others are left.
void TransientStrips::paintValues(QPainter& painter, const QRectF& room, const char* unit,
                                  const AxisEnds& ends,
                                  const std::function<double(double)>& yOf) const {
  const double letters = fontMetrics().height();
  const int most = std::max(2, static_cast<int>(room.height() / (letters + 3)));
  AxisTicks axis = linearTicks(ends.from, ends.to, most, unit);
  for (int more = most + 1; axis.ticks.size() < 2 && more < most + 4; ++more)
    axis = linearTicks(ends.from, ends.to, more, unit);  // one alone gives no scale
  const auto hasRoom = [&](const Tick& tick) {
    const double y = yOf(tick.value);
    return std::min(y - room.top(), room.bottom() - y) > 0.4 * letters;
  };
  const bool areEnough = std::ranges::count_if(axis.ticks, hasRoom) >= 2;
  for (const Tick& tick : axis.ticks) {
    const double y = std::floor(yOf(tick.value)) + 0.5;
    painter.setPen(colours_.grid);
    painter.drawLine(QPointF(room.left(), y), QPointF(room.right(), y));
    if (areEnough && !hasRoom(tick)) continue;
    painter.setPen(colours_.text);
    painter.drawText(QRectF(0, y - letters, room.left() - 6, 2 * letters),
                     Qt::AlignRight | Qt::AlignVCenter, labelWithUnit(tick, axis));
  }
}

void TransientStrips::paintTimes(QPainter& painter, const QRectF& room) const {
  const double wide = kTickWidth * markScale(font());
  const int most = std::max(2, static_cast<int>(room.width() / wide));
  const AxisTicks axis = linearTicks(0, sliding_.duration, most, "s");
  painter.setPen(colours_.text);
  for (const Tick& tick : axis.ticks) {
    const double x = room.left() + room.width() * tick.value / sliding_.duration;
    painter.drawText(QRectF(x - wide / 2, room.bottom() + 4, wide, fontMetrics().height()),
                     Qt::AlignHCenter | Qt::AlignTop, labelWithUnit(tick, axis));
  }
}

}  // namespace asperity
