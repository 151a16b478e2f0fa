#include "ui/chart/chart_plot_view.h"

#include <QEvent>
#include <QFocusEvent>
#include <QFontMetricsF>
#include <QGraphicsLayout>
#include <QVBoxLayout>
#include <QtCharts/QCategoryAxis>
#include <QtCharts/QLegend>
#include <QtCharts/QLineSeries>
#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/chart/plot_legend.h"
#include "ui/chart/plot_marks.h"
#include "ui/draw/log_ticks.h"

namespace asperity {

namespace {

constexpr double kSpanDepth = 1, kGridDepth = 1.5;  // between background and grid of a chart
constexpr double kOverlayDepth = 100;               // over everything in it
constexpr double kLabelWidth = 44;                  // a label needs this much of its axis
constexpr double kLabelHeight = 24;
constexpr double kStripGap = 6;   // between the plot and the name of the strip below
constexpr double kSlim = 0.32;    // height of the strip, of the whole
constexpr double kSlimmer = 0.4;  // and at most of the room for plot and strip

}  // namespace

PlotView* makePlotView(QWidget* parent) {
  return new ChartPlotView(parent);
}

ChartPlotView::ChartPlotView(QWidget* parent)
    : PlotView(parent),
      legend_(new PlotLegend),
      chart_(new QChart),
      view_(new QChartView(chart_)),
      x_(makeAxis(Qt::AlignBottom)),
      y_(makeAxis(Qt::AlignLeft)),
      spans_(new SpanItem(chart_)),
      grid_(new GridItem(chart_)),
      points_(new PointsItem(chart_)),
      titles_(new TitlesItem(chart_)),
      strip_(new StripItem(chart_)),
      marker_(new MarkerItem(chart_)),
      tip_(new TipItem(chart_)),
      wantedX_(std::numeric_limits<double>::quiet_NaN()) {
  chart_->legend()->hide();
  chart_->layout()->setContentsMargins(0, 0, 0, 0);
  chart_->setBackgroundRoundness(0);
  view_->setRenderHint(QPainter::Antialiasing);
  view_->setFrameShape(QFrame::NoFrame);
  view_->setFocusPolicy(Qt::NoFocus);
  view_->viewport()->setFocusPolicy(Qt::NoFocus);
  view_->setAttribute(Qt::WA_TransparentForMouseEvents);  // gestures are this widget's
  setMouseTracking(true);
  spans_->setZValue(kSpanDepth);
  grid_->setZValue(kGridDepth);
  points_->setZValue(kOverlayDepth);
  titles_->setZValue(kOverlayDepth);
  strip_->setZValue(kOverlayDepth);
  marker_->setZValue(kOverlayDepth + 1);
  tip_->setZValue(kOverlayDepth + 2);
  connect(chart_, &QChart::plotAreaChanged, this, [this] { updateItems(); });
  connect(legend_, &PlotLegend::unpinWanted, this, &PlotView::unpinWanted);
  connect(legend_, &PlotLegend::entered, this, [this] {
    hover_.reset();
    tip_->clear();
  });

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(legend_);
  layout->addWidget(view_, 1);
}

QCategoryAxis* ChartPlotView::makeAxis(Qt::Alignment side) {
  auto* axis = new QCategoryAxis;
  axis->setLabelsPosition(QCategoryAxis::AxisLabelsPositionOnValue);
  axis->setTruncateLabels(false);
  axis->setGridLineVisible(false);  // GridItem's
  chart_->addAxis(axis, side);
  return axis;
}

void ChartPlotView::setPlot(const Plot& plot) {
  const bool isNewX = !plot_.marker || !plot.marker || plot.marker->x != plot_.marker->x;
  if (isNewX && gesture_ != Gesture::Marker) wantedX_ = std::numeric_limits<double>::quiet_NaN();
  plot_ = plot;
  if (zoom_) zoom_ = heldWithin(*zoom_, {plot_.x.range, plot_.y.range});
  showAll();
}

void ChartPlotView::setMarker(const std::optional<PlotMarker>& marker) {
  const bool isNewX = !plot_.marker || !marker || marker->x != plot_.marker->x;
  if (isNewX && gesture_ != Gesture::Marker) wantedX_ = std::numeric_limits<double>::quiet_NaN();
  const auto nameOf = [](const auto& shown) { return shown ? shown->name : QString(); };
  const bool isNamedAnew = nameOf(plot_.marker) != nameOf(marker);
  plot_.marker = marker;
  updateMarker();
  if (isNamedAnew) legend_->show(plot_, colours_);
}

void ChartPlotView::setColours(const PlotColours& colours) {
  colours_ = colours;
  chart_->setBackgroundBrush(colours.background);
  view_->setBackgroundBrush(colours.background);
  paintAxis(*x_);
  paintAxis(*y_);
  paintLines();
  legend_->show(plot_, colours_);
  updateItems();
}

QPointF ChartPlotView::corner() const {
  return view_->mapTo(this, view_->mapFromScene(chart_->mapToScene(QPointF())));
}

QPointF ChartPlotView::positionOf(double x, double y) const {
  const PlotGeometry map = geometry();
  return QPointF(map.xOf(x), map.yOf(y)) + corner();
}

QPointF ChartPlotView::stripPositionOf(double x, double y) const {
  const PlotGeometry map = geometry();
  if (!plot_.strip) return {};
  const double part = (y - plot_.strip->from) / (plot_.strip->to - plot_.strip->from);
  return QPointF(map.xOf(x), map.strip.bottom() - part * map.strip.height()) + corner();
}

PlotWindow ChartPlotView::window() const {
  return zoom_ ? *zoom_ : PlotWindow{held_.value_or(plot_.x.range), plot_.y.range};
}

void ChartPlotView::resizeEvent(QResizeEvent* event) {
  PlotView::resizeEvent(event);
  showAll();
}

void ChartPlotView::changeEvent(QEvent* event) {
  PlotView::changeEvent(event);
  if (event->type() != QEvent::FontChange) return;
  paintAxis(*x_);
  paintAxis(*y_);
  paintLines();
  showAll();
}

void ChartPlotView::focusInEvent(QFocusEvent* event) {
  PlotView::focusInEvent(event);
  const Qt::FocusReason reason = event->reason();
  showsFocus_ = reason == Qt::TabFocusReason || reason == Qt::BacktabFocusReason;
  paintAxis(*x_);
  paintAxis(*y_);
}

void ChartPlotView::focusOutEvent(QFocusEvent* event) {
  PlotView::focusOutEvent(event);
  showsFocus_ = false;
  paintAxis(*x_);
  paintAxis(*y_);
}

void ChartPlotView::showAll() {
  legend_->show(plot_, colours_);
  layout()->activate();  // what the legend takes is not the chart's any more
  placeArea();
  x_->setLabelsVisible(!plot_.strip);
  const PlotWindow shown = window();
  const double scale = markScale(font());
  showAxis(*x_, shown.x, (width() - 90.0 * scale) / (kLabelWidth * scale));
  showAxis(*y_, shown.y, (height() - 90.0 * scale - stripHeight()) / (kLabelHeight * scale));
  showSeries();
  updateItems();
}

/// Fixed by the size of the texts that may come, so that the plot does not move while it is zoomed.
void ChartPlotView::placeArea() {
  const QFontMetricsF metrics(font());
  const double line = metrics.height();
  const double left = 12 + line + metrics.horizontalAdvance(QStringLiteral("5×10⁻⁵")) + 12;
  // The strip and the labels of the common axis stand below the chart.
  const double below = alongHeight() + (plot_.strip ? stripHeight() + stripGap() : 0);
  // Half of the label at the end of the axis.
  const double right = std::max(18.0, metrics.horizontalAdvance(QStringLiteral("10⁻⁵")) / 2 + 4);
  const QRectF area(left, aboveHeight(), view_->width() - left - right,
                    view_->height() - aboveHeight() - below);
  const QRectF wanted =
      area.width() > 20 && area.height() > 20 ? area : QRectF(left, aboveHeight(), 20, 20);
  if (chart_->plotArea() == wanted) return;
  chart_->setPlotArea(wanted);
  // The library leaves its axes behind until something else makes it lay them out.
  chart_->layout()->invalidate();
  chart_->layout()->activate();
}

/// Labels at whole decades, at every second (third...) where they would not fit, and between them
/// where fewer than two are seen.
void ChartPlotView::showAxis(QCategoryAxis& axis, const DecadeRange& range, double room) {
  if (range.isEmpty()) return;
  const std::vector<LogTick> ticks =
      logTicks(range.from, range.to, std::max(2, static_cast<int>(room)));
  QStringList labels;
  for (const LogTick& tick : ticks) labels += QString::fromStdString(tick.label);
  if (axis.categoriesLabels() == labels && axis.min() == range.from && axis.max() == range.to)
    return;
  for (const QString& label : axis.categoriesLabels()) axis.remove(label);
  axis.setRange(range.from, range.to);
  axis.setStartValue(range.from - 1);
  for (std::size_t i = 0; i < ticks.size(); ++i)
    axis.append(labels[static_cast<qsizetype>(i)], ticks[i].decade);
}

/// Lines are the chart's own; points are the overlay's.
void ChartPlotView::showSeries() {
  std::vector<const PlotSeries*> wanted;
  for (const PlotSeries& series : plot_.series)
    if (series.style == PlotStyle::Line) wanted.push_back(&series);
  while (lines_.size() > wanted.size()) {
    chart_->removeSeries(lines_.back());
    delete lines_.back();
    lines_.pop_back();
  }
  while (lines_.size() < wanted.size()) lines_.push_back(addLine());
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    QList<QPointF> points;
    for (const PlotPoint& point : plottable(wanted[i]->points))
      points += QPointF(std::log10(point.x), std::log10(point.y));
    if (lines_[i]->points() != points) lines_[i]->replace(points);
    lines_[i]->setOpacity(wanted[i]->faded ? kFadedOpacity : 1);
  }
}

QLineSeries* ChartPlotView::addLine() {
  auto* line = new QLineSeries;
  chart_->addSeries(line);
  line->attachAxis(x_);
  line->attachAxis(y_);
  line->setPen(linePen());
  return line;
}

QPen ChartPlotView::linePen() const {
  return QPen(colours_.line, 2 * markScale(font()));
}

void ChartPlotView::paintLines() const {
  for (QLineSeries* line : lines_) line->setPen(linePen());
}

void ChartPlotView::paintAxis(QCategoryAxis& axis) const {
  const QFont font = this->font();
  axis.setLabelsFont(font);
  axis.setLabelsColor(colours_.text);
  axis.setLinePen(showsFocus_ ? QPen(colours_.points, 2) : QPen(colours_.axis, 1));
}

double ChartPlotView::namesHeight() const {
  return std::max(kSpanNames, std::ceil(QFontMetricsF(font()).height()));
}

double ChartPlotView::aboveHeight() const {
  return plot_.spans.empty() ? 9 : namesHeight() + 2;
}

double ChartPlotView::alongHeight() const {
  return 2 * QFontMetricsF(font()).height() + 20;
}

/// Less than the plot that it belongs to, however low both are.
double ChartPlotView::stripHeight() const {
  if (!plot_.strip) return 0;
  const double room = view_->height() - aboveHeight() - alongHeight() - stripGap();
  return std::max(1.0, std::round(std::min(kSlim * height(), kSlimmer * room)));
}

double ChartPlotView::stripGap() const {
  return kStripGap + std::ceil(QFontMetricsF(font()).height());
}

PlotGeometry ChartPlotView::geometry() const {
  PlotGeometry map{chart_->plotArea(), window().x,       window().y, {},
                   namesHeight(),      markScale(font())};
  if (plot_.strip)
    map.strip =
        QRectF(map.area.left(), map.area.bottom() + stripGap(), map.area.width(), stripHeight());
  return map;
}

void ChartPlotView::updateItems() {
  const PlotGeometry map = geometry();
  for (PlotItem* item : {static_cast<PlotItem*>(spans_), static_cast<PlotItem*>(grid_),
                         static_cast<PlotItem*>(points_), static_cast<PlotItem*>(titles_),
                         static_cast<PlotItem*>(strip_)})
    item->update(map, plot_, colours_);
  updateMarker();
  if (hover_ && gesture_ == Gesture::None)
    read(*hover_);  // what lies there may be another now
  else
    tip_->clear();
}

void ChartPlotView::updateMarker() {
  marker_->update(geometry(), plot_.marker, wantedX_, colours_, font());
}

}  // namespace asperity
