#include "ui/chart/chart_items.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/chart/diagram_series.h"

namespace asperity {

namespace {

constexpr double kBar = 1.3;      // width of an error bar, times the scale
constexpr double kCap = 3.5;      // half the width of an error bar's caps, times the scale
constexpr float kCell = 4;        // pixels, resolution of what curves cover
constexpr double kAside = 4;      // pixels between a shade's edges and its name
constexpr double kNumberGap = 7;  // from the numbers of the y-axis to the frame
constexpr double kTickMark = 4;   // length of a tick mark outside of the frame
constexpr double kLeft = 6;       // from the edge to a title on the left
constexpr double kBelow = 8;      // from the frame to the title below it, including the labels
constexpr double kBeside = 8;     // from the frame to a title on its right

constexpr int kWrapped = Qt::AlignTop | Qt::TextWordWrap;
constexpr int kSentence = Qt::AlignCenter | Qt::TextWordWrap;

/// Returns the name of a shade, in which a last word does not stand alone in a line.
QString shadeText(const DiagramSpan& shade) {
  QString text = QString::fromStdString(shade.label.text);
  if (const qsizetype last = text.lastIndexOf(' '); text.count(' ') > 1) text[last] = QChar::Nbsp;
  return text;
}

/// Returns a title that is not broken within its unit: Qt would break "(m/s)" after the stroke.
QString withHardBlankUnit(QString title) {
  return title.replace('/', QStringLiteral("/\u2060"));
}

}  // namespace

OccupancyGrid coveredBySeries(const Diagram& diagram, const ChartGeometry& map,
                              const ChartStyle& style) {
  DiagramAxes axes;
  axes.box = toBox(map.area);
  axes.xAxis.scale = map.xScale;
  axes.xAxis.range = map.x;
  axes.yAxis.scale = map.yScale;
  axes.yAxis.range = map.y;
  OccupancyGrid covered(axes.box, kCell);
  coverSeries(covered, diagram,
              seriesStyles(diagram, tickSizes(style), style.theme, axes.box.width), axes);
  return covered;
}

void ChartBackground::show(const Diagram& diagram, const ChartGeometry& map,
                           const ChartStyle& style, const TickedAxis& xAxis,
                           const TickedAxis& yAxis, const AxisTitles& titles) {
  prepareGeometryChange();
  spans_ = diagram.spans;
  shades_ = diagram.shades;
  map_ = map;
  style_ = style;
  // Only names of shades avoid the series.
  covered_ = shades_.empty() ? OccupancyGrid({}, 1) : coveredBySeries(diagram, map, style);
  xAxis_ = xAxis;
  yAxis_ = yAxis;
  if (hasNoValues(diagram)) yAxis_.ticks.clear();
  titles_ = titles;
  frame_ = map.frame();
  update();
}

QRectF ChartBackground::boundingRect() const {
  return frame_.adjusted(-frame_.left(), -map_.names - 2, titles_.beside + kBeside + 2,
                         3 * style_.line() + kBelow);
}

void ChartBackground::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  painter->setFont(style_.font);
  // Tints over the grid leave it equally strong in all regions.
  paintGrid(*painter);
  paintFrame(*painter);
  paintSpans(*painter);
  for (const DiagramSpan& shade : shades_) {
    painter->setOpacity(shade.isFaded ? kFadedOpacity : 1);
    painter->fillRect(spanRect(shade), style_.shade());
  }
  painter->setOpacity(1);
  paintShadeNames(*painter);
  paintNumbers(*painter);
  paintTitles(*painter);
}

void ChartBackground::avoid(double x) {
  if (x == line_ || (std::isnan(x) && std::isnan(line_))) return;
  const QList<QRectF> before = namesInside();
  line_ = x;
  if (namesInside() != before) update();
}

QList<QRectF> ChartBackground::namesInside() const {
  QList<QRectF> boxes;
  for (const DiagramSpan& shade : shades_)
    if (const QRectF box = shadeName(shade).box; !box.isEmpty()) boxes += box;
  return boxes;
}

QString ChartBackground::elidedTitle() const {
  const bool isShort = titles_.hasX && titles_.hasXLabels && xTitle().text != xAxis_.title;
  return isShort ? QString::fromStdString(xAxis_.title) : QString();
}

QRectF ChartBackground::spanRect(const DiagramSpan& span) const {
  const auto clamped = [this](double x) { return std::clamp(x, frame_.left(), frame_.right()); };
  const double left = clamped(map_.mapX(span.from)), right = clamped(map_.mapX(span.to));
  return {left, frame_.top(), right - left, frame_.height()};
}

void ChartBackground::paintSpans(QPainter& painter) const {
  const QFontMetricsF metrics(style_.font);
  bool isShaded = true;
  for (const DiagramSpan& span : spans_) {
    const QRectF box = spanRect(span).adjusted(0, -map_.names, 0, 0);
    painter.setOpacity(span.isFaded ? kFadedOpacity : 1);
    if (isShaded) painter.fillRect(box, style_.span());
    isShaded = !isShaded;
    painter.setPen(style_.faintText());
    for (const std::string& form : {span.label.text, span.shortLabel}) {
      const QString label = QString::fromStdString(form);
      if (metrics.horizontalAdvance(label) + 4 > box.width()) continue;
      painter.drawText(QRectF(box.left(), box.top(), box.width(), map_.names), Qt::AlignCenter,
                       label);
      break;
    }
  }
  painter.setOpacity(1);
}

void ChartBackground::paintShadeNames(QPainter& painter) const {
  for (const DiagramSpan& shade : shades_) {
    const Name name = shadeName(shade);
    if (name.box.isEmpty()) continue;
    painter.setOpacity(shade.isFaded ? kFadedOpacity : 1);
    painter.setPen(style_.faintText());
    painter.drawText(name.area, name.alignment, shadeText(shade));
  }
  painter.setOpacity(1);
}

/// Places a name in its shade where no curve and not the line of the marker passes through it: in
/// the whole width, otherwise on either side of that line, otherwise in more lines in a part of the
/// width. There is none where no place is free.
ChartBackground::Name ChartBackground::shadeName(const DiagramSpan& shade) const {
  const QRectF whole = spanRect(shade).adjusted(kAside, kAside, -kAside, -kAside);
  QRectF left = whole, right = whole;
  const bool isSplit = line_ > whole.left() && line_ < whole.right();
  const double middle = isSplit ? line_ : whole.center().x(), apart = isSplit ? 2 * kAside : 0;
  left.setRight(middle - apart);
  right.setLeft(middle + apart);
  const bool prefersRight = right.width() > left.width();
  const auto isCrossed = [&](const QRectF& box) {
    return line_ > box.left() - kAside && line_ < box.right() + kAside;
  };
  for (const QRectF& area : {whole, prefersRight ? right : left, prefersRight ? left : right})
    for (const int side : {Qt::AlignHCenter, Qt::AlignLeft, Qt::AlignRight})
      if (const Name name = nameIn(area, side, shade); !name.box.isEmpty() && !isCrossed(name.box))
        return name;
  return {};
}

/// Places a name at this side of a rectangle without a curve: at its foot, otherwise as high as
/// possible; its box is empty where there is no such place.
ChartBackground::Name ChartBackground::nameIn(const QRectF& area, int side,
                                              const DiagramSpan& shade) const {
  if (!area.isValid()) return {};
  const QRectF head = labelBox(area, side | kWrapped, shade);
  if (head.isEmpty()) return {};
  const auto placed = [&](double top) {
    QRectF part = area;
    part.setTop(top);
    return Name{part, side | kWrapped, head.translated(0, top - area.top())};
  };
  const auto isFree = [&](const Name& name) { return covered_.under(toBox(name.box)) <= 0; };
  const double lowest = area.bottom() - head.height();
  if (const Name foot = placed(lowest); isFree(foot)) return foot;
  const double step = QFontMetricsF(style_.font).height() / 2;
  for (double top = area.top(); top < lowest; top += step)
    if (const Name name = placed(top); isFree(name)) return name;
  return {};
}

/// Returns the box of a name inside a rectangle; empty where it does not fit.
QRectF ChartBackground::labelBox(const QRectF& area, int alignment,
                                 const DiagramSpan& shade) const {
  const QRectF box = QFontMetricsF(style_.font).boundingRect(area, alignment, shadeText(shade));
  return area.contains(box) ? box : QRectF();
}

QLineF ChartBackground::upright(double position, double from, double to) const {
  const double x = std::floor(map_.pixelX(position)) + 0.5;
  return {x, from, x, to};
}

QLineF ChartBackground::level(double position, double from, double to) const {
  const double y = std::floor(map_.pixelY(position)) + 0.5;
  return {from, y, to, y};
}

/// Paints lines on whole pixels: smoothed lines between pixels would be faint, and take most of
/// the time that painting a diagram takes.
void ChartBackground::paintGrid(QPainter& painter) const {
  const auto addX = [this](QList<QLineF>& lines, double position) {
    lines += upright(position, frame_.top(), frame_.bottom());
  };
  const auto addY = [this](QList<QLineF>& lines, double position) {
    lines += level(position, frame_.left(), frame_.right());
  };
  QList<QLineF> fine, whole;
  for (const double position : xAxis_.minor) addX(fine, position);
  if (yAxis_.scale == AxisScale::Logarithmic)
    for (const double position : yAxis_.minor) addY(fine, position);
  for (const Tick& tick : xAxis_.ticks) addX(whole, tick.value);
  for (const Tick& tick : yAxis_.ticks) addY(whole, tick.value);
  const bool wasSmooth = painter.testRenderHint(QPainter::Antialiasing);
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setPen(QPen(style_.fineGrid(), 1));
  painter.drawLines(fine);
  painter.setPen(QPen(style_.grid(), 1));
  painter.drawLines(whole);
  painter.setRenderHint(QPainter::Antialiasing, wasSmooth);
}

/// Paints the frame with its tick marks, all lines alike.
void ChartBackground::paintFrame(QPainter& painter) const {
  const QRect frame = frame_.toRect();
  QList<QLineF> marks;
  for (const Tick& tick : xAxis_.ticks)
    marks += upright(tick.value, frame.bottom() + 1, frame.bottom() + 1 + kTickMark);
  for (const Tick& tick : yAxis_.ticks)
    marks += level(tick.value, frame.left(), frame.left() - kTickMark);
  const bool wasSmooth = painter.testRenderHint(QPainter::Antialiasing);
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setPen(style_.showsFocus ? QPen(toQColor(seriesColour(0, style_.theme)), 2)
                                   : QPen(style_.axis(), 1));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(frame);
  painter.drawLines(marks);
  painter.setRenderHint(QPainter::Antialiasing, wasSmooth);
}

/// Paints the numbers of the y-axis.
void ChartBackground::paintNumbers(QPainter& painter) const {
  const double line = style_.line();
  painter.setPen(style_.faintText());
  for (const Tick& tick : yAxis_.ticks) {
    const double middle = map_.pixelY(tick.value);
    painter.drawText(QRectF(0, middle - line / 2, frame_.left() - kNumberGap, line),
                     Qt::AlignRight | Qt::AlignVCenter | Qt::TextDontClip,
                     QString::fromStdString(tick.label));
  }
}

FittedTitle ChartBackground::xTitle() const {
  return fittedTitle(xAxis_.title, tickSizes(style_).axis, static_cast<float>(frame_.width()));
}

void ChartBackground::paintTitles(QPainter& painter) const {
  const double line = style_.line();
  painter.setPen(style_.text());
  const auto paintTitle = [&](const FittedTitle& title, const QRectF& place) {
    QFont font = style_.font;
    font.setPixelSize(static_cast<int>(title.size));
    painter.setFont(font);
    paintText(painter, place, Qt::AlignCenter | Qt::TextDontClip,
              QString::fromStdString(title.text));
    painter.setFont(style_.font);
  };
  if (titles_.hasX && titles_.hasXLabels)
    paintTitle(xTitle(),
               QRectF(frame_.left(), frame_.bottom() + kBelow + line, frame_.width(), line));
  if (!titles_.hasY) return;
  if (titles_.beside > 0)
    return painter.drawText(QRectF(frame_.right() + kBeside, frame_.top() - line, titles_.beside,
                                   frame_.height() + 2 * line),
                            Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap,
                            withHardBlankUnit(QString::fromStdString(yAxis_.title)));
  if (titles_.isAbove)
    return paintText(painter, QRectF(frame_.left(), frame_.top() - line - 1, frame_.width(), line),
                     Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip,
                     QString::fromStdString(yAxis_.title));
  const FittedTitle title =
      fittedTitle(yAxis_.title, tickSizes(style_).axis, static_cast<float>(frame_.height()));
  painter.save();
  painter.translate(kLeft, frame_.center().y());
  painter.rotate(-90);
  paintTitle(title, QRectF(-frame_.height() / 2, 0, frame_.height(), line));
  painter.restore();
}

// ---- Over the series

void ChartForeground::show(const Diagram& diagram, const ChartGeometry& map,
                           const ChartStyle& style) {
  prepareGeometryChange();
  map_ = map;
  style_ = style;
  blank_ = QString::fromStdString(diagram.blank.text);
  bars_.clear();
  for (const DiagramSeries& series : diagram.series) {
    if (series.isBand) continue;
    Bars bars{style.curve(series), series.isFaded ? kFadedOpacity : 1, {}};
    for (const DiagramPoint& point : series.points) {
      if (!hasPosition(diagram, point) || !(point.high > point.low)) continue;
      const double x = map.columnAt(point.x);
      bars.lines += QLineF(x, map.mapY(point.high), x, map.mapY(point.low));
    }
    if (!bars.lines.isEmpty()) bars_.push_back(std::move(bars));
  }
  update();
}

QRectF ChartForeground::boundingRect() const {
  return map_.frame();
}

void ChartForeground::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  painter->save();
  painter->setClipRect(boundingRect());
  for (const Bars& bars : bars_) {
    painter->setOpacity(bars.opacity);
    painter->setPen(QPen(bars.colour, kBar * map_.scale));
    for (const QLineF& bar : bars.lines)
      paintErrorBar(*painter, bar.x1(), bar.y1(), bar.y2(), kCap * map_.scale);
  }
  painter->restore();
  if (blank_.isEmpty()) return;
  painter->fillRect(sentence(), style_.background());
  painter->setFont(style_.font);
  painter->setPen(style_.text());
  painter->drawText(sentenceArea(), kSentence, blank_);
}

QRectF ChartForeground::sentence() const {
  if (blank_.isEmpty()) return {};
  return QFontMetricsF(style_.font)
      .boundingRect(sentenceArea(), kSentence, blank_)
      .adjusted(-10, -6, 10, 6);
}

QRectF ChartForeground::sentenceArea() const {
  return map_.area.adjusted(12, 8, -12, -8);
}

}  // namespace asperity
