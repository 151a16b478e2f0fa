#include "ui/chart/chart_panel.h"

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

namespace asperity {

namespace {

// Depths between the grid (2), the axes (3) and the series (4) of a chart.
constexpr double kUnderDepth = 1.5, kOverDepth = 3.5;

constexpr double kLargestCurveMark = 8, kSmallestCurveMark = 3;  // pixels across, times the scale

/// Returns the size of a curve's marks at which they do not touch each other.
double curveMarkSize(const DiagramSeries& series, double width, const ChartStyle& style) {
  const double apart =
      width / static_cast<double>(std::max<std::size_t>(series.points.size(), 2) - 1);
  return style.scale() *
         std::clamp(0.84 * apart / style.scale(), kSmallestCurveMark, kLargestCurveMark);
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

ChartPanel::ChartPanel(QGraphicsScene& scene)
    : chart_(new QChart),
      x_(new QCategoryAxis),
      y_(new QCategoryAxis),
      under_(new ChartBackground(chart_)),
      over_(new ChartForeground(chart_)) {
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
    axis->setLineVisible(false);
  }
  // The library leaves out numbers of a low axis that are not far apart; `under_` paints them.
  y_->setLabelsVisible(false);
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
                      const AxisTitles& titles) {
  const QRectF frame = map.frame();
  const QRectF whole(chart_->scene()->sceneRect());
  if (chart_->geometry() != whole || chart_->plotArea() != frame) {
    chart_->setGeometry(whole);
    chart_->setPlotArea(frame);
    // Qt Charts moves its axes only with the next layout.
    chart_->layout()->invalidate();
    chart_->layout()->activate();
  }
  const DiagramSizes sizes = tickSizes(style);
  const TickedAxis xAxis =
      tickedXAxis(diagram.x, map.x, static_cast<float>(map.area.width()), sizes);
  const TickedAxis yAxis =
      tickedYAxis(diagram.y, map.y, static_cast<float>(map.area.height()), sizes);
  xTitle_ = QString::fromStdString(xAxis.title);
  yTitle_ = QString::fromStdString(yAxis.title);
  x_->setLabelsVisible(titles.hasXLabels);
  for (QCategoryAxis* axis : {x_, y_}) applyStyle(*axis, style);
  const double beyond = map.x.size() * kFrameEdge * map.scale / std::max(1.0, map.area.width());
  showAxis(*x_, xAxis, {map.x.from - beyond, map.x.to + beyond});
  showAxis(*y_, yAxis, map.y);
  showSeries(diagram, map, style);
  under_->show(diagram, map, style, xAxis, yAxis, titles);
  over_->show(diagram, map, style);
}

void ChartPanel::applyStyle(QCategoryAxis& axis, const ChartStyle& style) {
  if (axis.labelsFont() != style.font) axis.setLabelsFont(style.font);
  if (axis.labelsColor() != style.faintText()) axis.setLabelsColor(style.faintText());
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
      QList<QPointF> run, marks;
      for (const DiagramPoint& point : series.points) {
        if (hasPosition(diagram, point)) {
          run += chartPosition(diagram, point.x, point.y);
          marks += chartPosition(diagram, map.xAt(map.columnAt(point.x)), point.y);
          continue;
        }
        if (const QPointF at = map.at(point.x, point.y); isFinite(at)) {  // below the axis
          run += QPointF(map.positionX(at.x()), map.positionY(at.y()));
          continue;
        }
        showRun(series, run, style);
        run.clear();
      }
      showRun(series, run, style);
      showMarks(series, marks, map.area.width(), style);
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
  fill.setAlphaF(kBandOpacity);
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
