#include "ui/charts/chart_plot_view.h"

#include <QGraphicsLayout>
#include <QVBoxLayout>
#include <QtCharts/QCategoryAxis>
#include <QtCharts/QLegend>
#include <QtCharts/QLineSeries>
#include <algorithm>
#include <cmath>

#include "ui/charts/decade_range.h"
#include "ui/charts/plot_legend.h"

namespace asperity {

namespace {

constexpr double kFineGridDepth = 1.5;  // between background and grid of a chart
constexpr double kOverlayDepth = 100;   // over everything in it
constexpr double kLabelWidth = 44;      // a decade label needs this much of its axis
constexpr double kLabelHeight = 24;

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
      fineGrid_(new FineGridItem(chart_)),
      overlay_(new OverlayItem(chart_)) {
  chart_->legend()->hide();
  chart_->setMargins(QMargins(10, 9, 18, 4));
  chart_->layout()->setContentsMargins(0, 0, 0, 0);
  chart_->setBackgroundRoundness(0);
  view_->setRenderHint(QPainter::Antialiasing);
  view_->setFrameShape(QFrame::NoFrame);
  view_->setFocusPolicy(Qt::NoFocus);
  view_->viewport()->setFocusPolicy(Qt::NoFocus);
  fineGrid_->setZValue(kFineGridDepth);
  overlay_->setZValue(kOverlayDepth);
  connect(chart_, &QChart::plotAreaChanged, this, [this] { updateItems(); });

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
  chart_->addAxis(axis, side);
  return axis;
}

void ChartPlotView::setPlot(const Plot& plot) {
  plot_ = plot;
  showAll();
}

void ChartPlotView::setColours(const PlotColours& colours) {
  colours_ = colours;
  chart_->setBackgroundBrush(colours.background);
  view_->setBackgroundBrush(colours.background);
  paintAxis(*x_);
  paintAxis(*y_);
  for (QLineSeries* line : lines_) line->setPen(QPen(colours_.line, 2));
  updateItems();
}

QPointF ChartPlotView::positionOf(double x, double y) const {
  const PlotGeometry map = geometry();
  const QPoint corner = view_->mapTo(this, view_->mapFromScene(chart_->mapToScene(QPointF())));
  return QPointF(map.xOf(x), map.yOf(y)) + corner;
}

void ChartPlotView::resizeEvent(QResizeEvent* event) {
  PlotView::resizeEvent(event);
  showAll();
}

void ChartPlotView::showAll() {
  showAxis(*x_, plot_.x, (width() - 90.0) / kLabelWidth);
  showAxis(*y_, plot_.y, (height() - 90.0) / kLabelHeight);
  showSeries();
  updateItems();
}

/// Labels at whole decades, at every second (third...) where they would not fit.
void ChartPlotView::showAxis(QCategoryAxis& axis, const PlotAxis& plotAxis, double room) {
  const DecadeRange range = plotAxis.range;
  if (range.isEmpty()) return;
  const double decades = range.to - range.from;
  const int every = std::max(1, static_cast<int>(std::ceil(decades / std::max(1.0, room))));
  QStringList labels;
  for (int decade = range.from; decade <= range.to; ++decade)
    if (decade % every == 0) labels += decadeLabel(decade);
  if (axis.titleText() != plotAxis.title) axis.setTitleText(plotAxis.title);
  if (axis.categoriesLabels() == labels && axis.min() == range.from && axis.max() == range.to)
    return;
  for (const QString& label : axis.categoriesLabels()) axis.remove(label);
  axis.setRange(range.from, range.to);
  axis.setStartValue(range.from - 1);
  for (int decade = range.from; decade <= range.to; ++decade)
    if (decade % every == 0) axis.append(decadeLabel(decade), decade);
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
  line->setPen(QPen(colours_.line, 2));
  return line;
}

void ChartPlotView::paintAxis(QCategoryAxis& axis) const {
  QFont font = this->font();
  axis.setLabelsFont(font);
  axis.setTitleFont(font);
  axis.setLabelsColor(colours_.text);
  axis.setTitleBrush(colours_.text);
  axis.setLinePen(QPen(colours_.axis, 1));
  axis.setGridLinePen(QPen(colours_.grid, 1));
}

PlotGeometry ChartPlotView::geometry() const {
  return {chart_->plotArea(), plot_.x.range, plot_.y.range};
}

void ChartPlotView::updateItems() {
  legend_->show(plot_, colours_);
  fineGrid_->update(geometry(), plot_, colours_);
  overlay_->update(geometry(), plot_, colours_);
}

}  // namespace asperity
