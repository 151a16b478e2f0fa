// PlotView by Qt Charts. The axes hold decimal logarithms under decade labels, so that the
// library's own logarithmic axis, which drops ticks, is not needed. GUI thread.
#pragma once

#include <QtCharts/QChart>
#include <QtCharts/QChartView>

#include "ui/charts/plot_overlay.h"
#include "ui/charts/plot_view.h"

class QCategoryAxis;
class QLineSeries;

namespace asperity {

class PlotLegend;

class ChartPlotView : public PlotView {
 public:
  explicit ChartPlotView(QWidget* parent = nullptr);

  void setPlot(const Plot& plot) override;
  const Plot& plot() const override { return plot_; }
  void setColours(const PlotColours& colours) override;
  QPointF positionOf(double x, double y) const override;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QCategoryAxis* makeAxis(Qt::Alignment side);
  void showAxis(QCategoryAxis& axis, const PlotAxis& plotAxis, double room);
  void showSeries();
  QLineSeries* addLine();
  void showAll();
  void paintAxis(QCategoryAxis& axis) const;
  void updateItems();
  PlotGeometry geometry() const;

  Plot plot_;
  PlotColours colours_;
  PlotLegend* legend_;
  QChart* chart_;
  QChartView* view_;
  QCategoryAxis* x_;
  QCategoryAxis* y_;
  std::vector<QLineSeries*> lines_;  // owned by the chart, one for each line of plot_.series
  FineGridItem* fineGrid_;
  OverlayItem* overlay_;
};

}  // namespace asperity
