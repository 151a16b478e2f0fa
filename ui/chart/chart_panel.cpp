#include "ui/chart/chart_panel.h"

#include <QFontInfo>
#include <QFontMetricsF>
#include <QGraphicsLayout>
#include <QGraphicsScene>
#include <QPainter>
#include <QtCharts/QAreaSeries>
#include <QtCharts/QCategoryAxis>
#include <QtCharts/QChart>
#include <QtCharts/QLegend>
#include <QtCharts/QLineSeries>
#include <QtCharts/QScatterSeries>
#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/chart/diagram_series.h"
#include "ui/chart/diagram_style.h"
#include "ui/draw/fonts.h"

namespace asperity {

namespace {

// Depths between the grid (2), the axes (3) and the series (4) of a chart.
constexpr double kUnderDepth = 1.5, kOverDepth = 3.5;

constexpr double kMarkSize = 8, kSmallestMark = 3;  // pixels across, times the scale
constexpr double kBar = 1.3;                        // width of an error bar
constexpr double kCap = 3.5;                        // half the width of an error bar's caps
constexpr float kCell = 4;                          // pixels, resolution of what curves cover
constexpr double kAside = 4;                        // pixels between a shade's edges and its name
constexpr double kLeft = 6;                         // from the edge to a title on the left
constexpr double kBelow = 8;   // from the frame to the title below it, including the labels
constexpr double kBeside = 8;  // from the frame to a title on its right
constexpr double kBandOpacity = 0.2;

/// Returns the font sizes of the ticks, in the form that the layout of pictures uses.
DiagramSizes tickSizes(const ChartStyle& style) {
  DiagramSizes sizes;
  sizes.unit = static_cast<float>(style.scale());
  sizes.tick = sizes.axis = static_cast<float>(QFontInfo(style.font).pixelSize());
  return sizes;
}

/// Returns the size of a curve's marks at which they do not touch each other.
double curveMarkSize(const DiagramSeries& series, double width, const ChartStyle& style) {
  const double apart =
      width / static_cast<double>(std::max<std::size_t>(series.points.size(), 2) - 1);
  return style.scale() * std::clamp(0.84 * apart / style.scale(), kSmallestMark, kMarkSize);
}

/// Returns a mark with its rim as an image for a QScatterSeries.
QImage markImage(SeriesMark mark, double size, const QColor& colour, const QColor& rim,
                 double* side) {
  constexpr int kFiner = 4;  // image pixels per screen pixel
  const int across = static_cast<int>(std::ceil(1.5 * size)) + 4;
  *side = across;
  QImage image(kFiner * across, kFiner * across, QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::transparent);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.scale(kFiner, kFiner);
  painter.setPen(QPen(rim, 1));
  painter.setBrush(colour);
  paintMark(painter, mark, {across / 2.0, across / 2.0}, size);
  return image;
}

QPointF chartPosition(const Diagram& diagram, double x, double y) {
  return {axisPosition(diagram.x.scale, x), axisPosition(diagram.y.scale, y)};
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

/// Paints regions with their names, shades, the grid and the titles of the axes.
class ChartPanel::UnderItem : public QGraphicsItem {
 public:
  using QGraphicsItem::QGraphicsItem;

  void show(const Diagram& diagram, const ChartGeometry& map, const ChartStyle& style,
            const TickedAxis& xAxis, const TickedAxis& yAxis, bool hasXLabels, double titleBeside,
            bool titleAbove) {
    prepareGeometryChange();
    spans_ = diagram.spans;
    shades_ = diagram.shades;
    map_ = map;
    style_ = style;
    // Only names of shades avoid the series.
    covered_ = shades_.empty() ? OccupancyGrid({}, 1) : coveredBySeries(diagram, map, style);
    xAxis_ = xAxis;
    yAxis_ = yAxis;
    hasXLabels_ = hasXLabels;
    titleBeside_ = titleBeside;
    titleAbove_ = titleAbove;
    const double edge = kFrameEdge * map.scale;
    frame_ = map.area.adjusted(-edge, 0, edge, 0);
    update();
  }

  QRectF boundingRect() const override {
    return frame_.adjusted(-frame_.left(), -map_.names - 2, titleBeside_ + kBeside + 2,
                           3 * style_.line() + kBelow);
  }

  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
    painter->setFont(style_.font);
    paintSpans(*painter);
    for (const DiagramSpan& shade : shades_) {
      painter->setOpacity(shade.isFaded ? kFadedOpacity : 1);
      painter->fillRect(spanRect(shade), style_.shade());
    }
    painter->setOpacity(1);
    paintGrid(*painter);
    paintShadeNames(*painter);
    paintTitles(*painter);
  }

  /// Keeps the names of shades away from an upright line; NaN: there is none.
  void avoid(double x) {
    if (x == line_ || (std::isnan(x) && std::isnan(line_))) return;
    const QList<QRectF> before = namesInside();
    line_ = x;
    if (namesInside() != before) update();
  }

  QList<QRectF> namesInside() const {
    QList<QRectF> boxes;
    for (const DiagramSpan& shade : shades_)
      if (const QRectF box = shadeName(shade).box; !box.isEmpty()) boxes += box;
    return boxes;
  }

  QString elidedTitle() const {
    const QString title = QString::fromStdString(xAxis_.title);
    return hasXLabels_ && xTitle() != title ? title : QString();
  }

 private:
  static constexpr int kFoot = Qt::AlignHCenter | Qt::AlignBottom | Qt::TextWordWrap;
  static constexpr int kHead = Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap;

  /// The position of the name of a shade.
  struct Name {
    QRectF area;
    int alignment = kFoot;
    QRectF box{};       // empty where it does not fit
    float covered = 0;  // the part of the box that curves cover
  };

  QRectF spanRect(const DiagramSpan& span) const {
    const auto held = [this](double x) { return std::clamp(x, frame_.left(), frame_.right()); };
    const double left = held(map_.mapX(span.from)), right = held(map_.mapX(span.to));
    return {left, frame_.top(), right - left, frame_.height()};
  }

  void paintSpans(QPainter& painter) const {
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

  void paintShadeNames(QPainter& painter) const {
    for (const DiagramSpan& shade : shades_) {
      const Name name = shadeName(shade);
      if (name.box.isEmpty()) continue;
      painter.setOpacity(shade.isFaded ? kFadedOpacity : 1);
      painter.setPen(style_.faintText());
      painter.drawText(name.area, name.alignment, QString::fromStdString(shade.label.text));
    }
    painter.setOpacity(1);
  }

  /// Places a name at the foot of its shade, or at the highest position where the fewest curves
  /// pass through it; in the whole width, or on the wider side where the line of the marker would
  /// go through it.
  Name shadeName(const DiagramSpan& shade) const {
    const QRectF whole = spanRect(shade).adjusted(kAside, kAside, -kAside, -kAside);
    const Name name = nameIn(whole, shade);
    const bool isCrossed = !name.box.isEmpty() && line_ > name.box.left() - kAside &&
                           line_ < name.box.right() + kAside;
    if (!isCrossed) return name;
    QRectF side = whole;
    if (line_ < whole.center().x())
      side.setLeft(line_ + 2 * kAside);
    else
      side.setRight(line_ - 2 * kAside);
    const Name beside = nameIn(side, shade);
    return beside.box.isEmpty() ? name : beside;
  }

  /// Places a name in a rectangle, as shadeName() describes.
  Name nameIn(const QRectF& area, const DiagramSpan& shade) const {
    const auto placed = [&](const QRectF& part, int alignment) {
      const QRectF box = labelBox(part, alignment, shade);
      return Name{part, alignment, box, coveredIn(box)};
    };
    Name best = placed(area, kFoot);
    const double step = QFontMetricsF(style_.font).height() / 2;
    for (QRectF part = area; best.covered > 0; part.setTop(part.top() + step)) {
      const Name other = placed(part, kHead);
      if (other.box.isEmpty()) break;
      if (other.covered < best.covered) best = other;
    }
    // In a low frame a name over the curves hides them.
    if (3 * best.box.height() > area.height() && best.covered > 0) best.box = {};
    return best;
  }

  /// Returns the box of a name inside a rectangle; empty where it does not fit.
  QRectF labelBox(const QRectF& area, int alignment, const DiagramSpan& shade) const {
    const QRectF box = QFontMetricsF(style_.font)
                           .boundingRect(area, alignment, QString::fromStdString(shade.label.text));
    return area.contains(box) ? box : QRectF();
  }

  /// Returns the part of a box that curves and marks cover.
  float coveredIn(const QRectF& box) const { return covered_.under(toBox(box)); }

  /// Paints lines on whole pixels: smoothed lines between pixels would be faint, and take most of
  /// the time that painting a diagram takes.
  void paintGrid(QPainter& painter) const {
    const auto upright = [this](double position) {
      const double part = (position - map_.x.from) / map_.x.size();
      const double x = std::floor(map_.area.left() + part * map_.area.width()) + 0.5;
      return QLineF(x, frame_.top(), x, frame_.bottom());
    };
    const auto level = [this](double position) {
      const double part = (position - map_.y.from) / map_.y.size();
      const double y = std::floor(map_.area.bottom() - part * map_.area.height()) + 0.5;
      return QLineF(frame_.left(), y, frame_.right(), y);
    };
    QList<QLineF> fine, whole;
    for (const double position : xAxis_.minor) fine += upright(position);
    if (yAxis_.scale == AxisScale::Logarithmic)
      for (const double position : yAxis_.minor) fine += level(position);
    for (const Tick& tick : xAxis_.ticks) whole += upright(tick.value);
    for (const Tick& tick : yAxis_.ticks) whole += level(tick.value);
    const bool wasSmooth = painter.testRenderHint(QPainter::Antialiasing);
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(QPen(style_.fineGrid(), 1));
    painter.drawLines(fine);
    painter.setPen(QPen(style_.grid(), 1));
    painter.drawLines(whole);
    painter.setPen(QPen(style_.axis(), 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(frame_.toRect());
    painter.setRenderHint(QPainter::Antialiasing, wasSmooth);
  }

  QString xTitle() const {
    return QFontMetricsF(style_.font)
        .elidedText(QString::fromStdString(xAxis_.title), Qt::ElideRight, frame_.width());
  }

  void paintTitles(QPainter& painter) const {
    const double line = style_.line();
    painter.setPen(style_.text());
    if (hasXLabels_)
      painter.drawText(QRectF(frame_.left(), frame_.bottom() + kBelow + line, frame_.width(), line),
                       Qt::AlignCenter | Qt::TextDontClip, xTitle());
    if (titleBeside_ > 0)
      return painter.drawText(QRectF(frame_.right() + kBeside, frame_.top() - line, titleBeside_,
                                     frame_.height() + 2 * line),
                              Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap,
                              QString::fromStdString(yAxis_.title));
    if (titleAbove_)
      return painter.drawText(QRectF(frame_.left(), frame_.top() - line - 1, frame_.width(), line),
                              Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip,
                              QString::fromStdString(yAxis_.title));
    const FittedTitle title =
        fittedTitle(yAxis_.title, tickSizes(style_).axis, static_cast<float>(frame_.height()));
    painter.save();
    QFont font = style_.font;
    font.setPixelSize(static_cast<int>(title.size));
    painter.setFont(font);
    painter.translate(kLeft, frame_.center().y());
    painter.rotate(-90);
    painter.drawText(QRectF(-frame_.height() / 2, 0, frame_.height(), line),
                     Qt::AlignCenter | Qt::TextDontClip, QString::fromStdString(title.text));
    painter.restore();
  }

  std::vector<DiagramSpan> spans_, shades_;
  OccupancyGrid covered_{{}, 1};  // the area that the series cover
  ChartGeometry map_;
  ChartStyle style_;
  TickedAxis xAxis_, yAxis_;
  bool hasXLabels_ = true;
  double titleBeside_ = 0;
  bool titleAbove_ = false;
  double line_ = std::numeric_limits<double>::quiet_NaN();
  QRectF frame_;
};

/// Paints error bars, or the reason why there are no curves.
class ChartPanel::OverItem : public QGraphicsItem {
 public:
  using QGraphicsItem::QGraphicsItem;

  void show(const Diagram& diagram, const ChartGeometry& map, const ChartStyle& style) {
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
        // The low end may be outside the axis; the bar then reaches the end of the axis.
        const double low = map.mapY(point.low);
        bars.lines += QLineF(map.mapX(point.x), map.mapY(point.high), map.mapX(point.x),
                             std::isfinite(low) ? low : map.area.bottom() + kCap * map.scale + 1);
      }
      if (!bars.lines.isEmpty()) bars_.push_back(std::move(bars));
    }
    update();
  }

  QRectF boundingRect() const override {
    const double edge = kFrameEdge * map_.scale;
    return map_.area.adjusted(-edge, 0, edge, 0);
  }

  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
    painter->save();
    painter->setClipRect(boundingRect());
    for (const Bars& bars : bars_) {
      painter->setOpacity(bars.opacity);
      painter->setPen(QPen(bars.colour, kBar * map_.scale));
      for (const QLineF& bar : bars.lines)
        paintErrorBar(*painter, bar.x1(), bar.y1(), bar.y2(), kCap * map_.scale);
    }
    painter->restore();
    if (!blank_.isEmpty()) paintSentence(*painter);
  }

  QRectF sentence() const {
    if (blank_.isEmpty()) return {};
    return QFontMetricsF(style_.font)
        .boundingRect(sentenceArea(), kSentence, blank_)
        .adjusted(-10, -6, 10, 6);
  }

 private:
  static constexpr int kSentence = Qt::AlignCenter | Qt::TextWordWrap;

  QRectF sentenceArea() const { return map_.area.adjusted(12, 8, -12, -8); }

  void paintSentence(QPainter& painter) const {
    painter.fillRect(sentence(), style_.background());
    painter.setFont(style_.font);
    painter.setPen(style_.text());
    painter.drawText(sentenceArea(), kSentence, blank_);
  }

  struct Bars {
    QColor colour;
    double opacity = 1;
    QList<QLineF> lines;  // from the high end to the low end
  };
  std::vector<Bars> bars_;
  ChartGeometry map_;
  ChartStyle style_;
  QString blank_;
};

ChartPanel::ChartPanel(QGraphicsScene& scene)
    : chart_(new QChart),
      x_(new QCategoryAxis),
      y_(new QCategoryAxis),
      under_(new UnderItem(chart_)),
      over_(new OverItem(chart_)) {
  scene.addItem(chart_);
  chart_->legend()->hide();
  chart_->layout()->setContentsMargins(0, 0, 0, 0);
  chart_->setBackgroundVisible(false);
  chart_->addAxis(x_, Qt::AlignBottom);
  chart_->addAxis(y_, Qt::AlignLeft);
  for (QCategoryAxis* axis : {x_, y_}) {
    axis->setLabelsPosition(QCategoryAxis::AxisLabelsPositionOnValue);
    axis->setTruncateLabels(false);
    axis->setGridLineVisible(false);
  }
  under_->setZValue(kUnderDepth);
  over_->setZValue(kOverDepth);
}

ChartPanel::~ChartPanel() {
  delete chart_;
}

QList<QRectF> ChartPanel::namesInside() const {
  return under_->namesInside();
}

QRectF ChartPanel::sentence() const {
  return over_->sentence();
}

void ChartPanel::avoidLine(double x) {
  under_->avoid(x);
}

QString ChartPanel::elidedTitle() const {
  return under_->elidedTitle();
}

void ChartPanel::show(const Diagram& diagram, const ChartGeometry& map, const ChartStyle& style,
                      bool hasXLabels, double titleBeside, bool titleAbove, Titled isTitled) {
  const double edge = kFrameEdge * map.scale;
  const QRectF frame = map.area.adjusted(-edge, 0, edge, 0);
  const QRectF whole(chart_->scene()->sceneRect());
  if (chart_->geometry() != whole || chart_->plotArea() != frame) {
    chart_->setGeometry(whole);
    chart_->setPlotArea(frame);
    // Qt Charts moves its axes only with the next layout.
    chart_->layout()->invalidate();
    chart_->layout()->activate();
  }
  const DiagramSizes sizes = tickSizes(style);
  TickedAxis xAxis = tickedXAxis(diagram.x, map.x, static_cast<float>(map.area.width()), sizes);
  TickedAxis yAxis = tickedYAxis(diagram.y, map.y, static_cast<float>(map.area.height()), sizes);
  xTitle_ = QString::fromStdString(xAxis.title);
  yTitle_ = QString::fromStdString(yAxis.title);
  if (!isTitled.x) xAxis.title.clear();
  if (!isTitled.y) yAxis.title.clear();
  x_->setLabelsVisible(hasXLabels);
  for (QCategoryAxis* axis : {x_, y_}) applyStyle(*axis, style);
  const double beyond = map.x.size() * edge / std::max(1.0, map.area.width());
  showAxis(*x_, xAxis, {map.x.from - beyond, map.x.to + beyond});
  showAxis(*y_, yAxis, map.y);
  showSeries(diagram, map, style);
  under_->show(diagram, map, style, xAxis, yAxis, hasXLabels, titleBeside, titleAbove);
  over_->show(diagram, map, style);
}

void ChartPanel::applyStyle(QCategoryAxis& axis, const ChartStyle& style) {
  if (axis.labelsFont() != style.font) axis.setLabelsFont(style.font);
  if (axis.labelsColor() != style.text()) axis.setLabelsColor(style.text());
  const QColor focus = toQColor(seriesColour(0, style.theme));
  const QPen pen = style.showsFocus ? QPen(focus, 2) : QPen(style.axis(), 1);
  if (axis.linePen() != pen) axis.setLinePen(pen);
}

/// Updates only what has changed: the layout of an axis takes much time.
void ChartPanel::showAxis(QCategoryAxis& axis, const TickedAxis& ticked, const AxisRange& range) {
  QStringList labels;
  for (const Tick& tick : ticked.ticks) labels += QString::fromStdString(tick.label);
  if (axis.categoriesLabels() == labels && axis.min() == range.from && axis.max() == range.to)
    return;
  // The library lays the axis out at once where its range changes, and later where its labels do:
  // without labels in between, a range that changes in every frame would never show any.
  axis.setRange(range.from, range.to);
  for (const QString& label : axis.categoriesLabels()) axis.remove(label);
  axis.setStartValue(range.from - range.size());
  for (std::size_t i = 0; i < ticked.ticks.size(); ++i)
    axis.append(labels[static_cast<qsizetype>(i)], ticked.ticks[i].value);
}

/// Shows bands first, then theory, then the data, as in pictures.
void ChartPanel::showSeries(const Diagram& diagram, const ChartGeometry& map,
                            const ChartStyle& style) {
  linesUsed_ = marksUsed_ = bandsUsed_ = 0;
  for (const DiagramSeries& series : diagram.series)
    if (series.isBand) showBand(series, diagram, style);
  for (const bool theory : {true, false})
    for (const DiagramSeries& series : diagram.series) {
      if (series.isTheory != theory) continue;
      QList<QPointF> run, all;
      for (const DiagramPoint& point : series.points) {
        if (hasPosition(diagram, point)) {
          run += chartPosition(diagram, point.x, point.y);
          all += run.back();
          continue;
        }
        showRun(series, run, style);
        run.clear();
      }
      showRun(series, run, style);
      showMarks(series, all, map.area.width(), style);
    }
  for (std::size_t i = linesUsed_; i < lines_.size(); ++i) lines_[i]->hide();
  for (std::size_t i = marksUsed_; i < marks_.size(); ++i) marks_[i]->hide();
  for (std::size_t i = bandsUsed_; i < bands_.size(); ++i) bands_[i]->hide();
}

/// Shows one part of a curve without gaps.
void ChartPanel::showRun(const DiagramSeries& series, const QList<QPointF>& run,
                         const ChartStyle& style) {
  if (series.stroke == SeriesStroke::None || run.size() < 2) return;
  QLineSeries& line = nextLine();
  const QPen pen = curvePen(series, style);
  if (line.pen() != pen) line.setPen(pen);
  if (line.points() != run) line.replace(run);
  line.setOpacity(series.isFaded ? kFadedOpacity : 1);
  line.show();
}

void ChartPanel::showMarks(const DiagramSeries& series, const QList<QPointF>& positions,
                           double width, const ChartStyle& style) {
  if (series.mark == SeriesMark::None || positions.isEmpty()) return;
  QScatterSeries& marks = nextMarks();
  const double size = curveMarkSize(series, width, style);
  const QString name = QStringLiteral("%1 %2 %3 %4")
                           .arg(static_cast<int>(series.mark))
                           .arg(size)
                           .arg(style.curve(series).name(), style.background().name());
  if (marks.name() != name) {
    double side = 0;
    const QImage image =
        markImage(series.mark, size, style.curve(series), style.background(), &side);
    marks.setName(name);
    marks.setLightMarker(image);
    marks.setMarkerSize(side);
  }
  if (marks.points() != positions) marks.replace(positions);
  marks.setOpacity(series.isFaded ? kFadedOpacity : 1);
  marks.show();
}

void ChartPanel::showBand(const DiagramSeries& series, const Diagram& diagram,
                          const ChartStyle& style) {
  QList<QPointF> low, high;
  for (const DiagramPoint& point : series.points) {
    const QPointF below = chartPosition(diagram, point.x, point.low);
    const QPointF above = chartPosition(diagram, point.x, point.high);
    if (!std::isfinite(below.x() + below.y() + above.y())) continue;
    low += below;
    high += above;
  }
  if (low.size() < 2) return;
  QAreaSeries& band = nextBand();
  QColor fill = style.curve(series);
  fill.setAlphaF(static_cast<float>(kBandOpacity));
  if (band.brush().color() != fill) band.setBrush(fill);
  band.lowerSeries()->replace(low);
  band.upperSeries()->replace(high);
  band.setOpacity(series.isFaded ? kFadedOpacity : 1);
  band.show();
}

template <class Series>
Series* ChartPanel::addToChart(Series* series) {
  chart_->addSeries(series);
  series->attachAxis(x_);
  series->attachAxis(y_);
  return series;
}

QLineSeries& ChartPanel::nextLine() {
  if (linesUsed_ == lines_.size()) lines_.push_back(addToChart(new QLineSeries));
  return *lines_[linesUsed_++];
}

/// Returns an unused series of marks. The image of a mark is drawn for all points at once, and the
/// library's own items, one for each point, are hidden.
QScatterSeries& ChartPanel::nextMarks() {
  if (marksUsed_ == marks_.size()) {
    marks_.push_back(addToChart(new QScatterSeries));
    marks_.back()->setPointsVisible(false);
  }
  return *marks_[marksUsed_++];
}

QAreaSeries& ChartPanel::nextBand() {
  if (bandsUsed_ == bands_.size()) {
    auto* band = new QAreaSeries(new QLineSeries, new QLineSeries);
    for (QLineSeries* edge : {band->upperSeries(), band->lowerSeries()}) edge->setParent(band);
    bands_.push_back(addToChart(band));
    band->setPen(Qt::NoPen);
  }
  return *bands_[bandsUsed_++];
}

}  // namespace asperity
