// PlotView by Qt Charts. The axes hold decimal logarithms under labels of our own, so that the
// library's own logarithmic axis, which drops ticks, is not needed. GUI thread.
#pragma once

#include <QtCharts/QChart>
#include <QtCharts/QChartView>

#include "ui/chart/plot_items.h"
#include "ui/chart/plot_view.h"

class QCategoryAxis;
class QLineSeries;

namespace asperity {

class PlotLegend;

class ChartPlotView : public PlotView {
  Q_OBJECT

 public:
  explicit ChartPlotView(QWidget* parent = nullptr);

  void setPlot(const Plot& plot) override;
  const Plot& plot() const override { return plot_; }
  void setMarker(const std::optional<PlotMarker>& marker) override;
  void setColours(const PlotColours& colours) override;
  QPointF positionOf(double x, double y) const override;
  QPointF stripPositionOf(double x, double y) const override;
  PlotWindow window() const override;
  bool isZoomed() const override { return zoom_.has_value(); }
  void zoom(double factor) override;
  void fit() override;
  void setZoom(const std::optional<PlotWindow>& window) override;
  QString reading() const override { return tip_->text(); }

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

  // In chart_plot_gestures.cpp.
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QCategoryAxis* makeAxis(Qt::Alignment side);
  void showAxis(QCategoryAxis& axis, const DecadeRange& range, double room);
  void placeArea();
  void showSeries();
  QLineSeries* addLine();
  void showAll();
  void paintAxis(QCategoryAxis& axis) const;
  QPen linePen() const;
  void paintLines() const;
  void updateItems();
  void updateMarker();
  double namesHeight() const;
  double aboveHeight() const;  // of what stands there, pixels
  double alongHeight() const;  // of labels and title of the axis along
  double stripHeight() const;
  double stripGap() const;
  PlotGeometry geometry() const;
  QPointF corner() const;

  // In chart_plot_gestures.cpp.
  void pan(QPointF by);
  void read(QPointF place);
  void gripMarker(QPointF place, bool finely);
  void dragMarker(QPointF place, bool finely);
  void moveMarker(double x, bool finely);
  void chooseNextPoint(bool forward);

  Plot plot_;
  PlotColours colours_;
  std::optional<PlotWindow> zoom_;
  bool showsFocus_ = false;  // that came by a key
  PlotLegend* legend_;
  QChart* chart_;
  QChartView* view_;
  QCategoryAxis* x_;
  QCategoryAxis* y_;
  std::vector<QLineSeries*> lines_;  // owned by the chart, one for each line of plot_.series
  SpanItem* spans_;
  GridItem* grid_;
  PointsItem* points_;
  TitlesItem* titles_;
  StripItem* strip_;
  MarkerItem* marker_;
  TipItem* tip_;

  enum class Gesture { None, Press, Marker, Pan };
  Gesture gesture_ = Gesture::None;
  PlotTarget pressed_;  // what lay under the pointer
  QPointF pressedAt_, panAt_;
  std::optional<QPointF> hover_;  // where the pointer is, over the plot
  QPointF gripAt_;                // where the pointer took the marker, and
  double grippedX_ = 0;           // where that was then, pixels
  bool gripsFinely_ = false;
  std::optional<DecadeRange> held_;  // axis along, while the marker is dragged on it
  double wantedX_;  // of the marker while it is moved, until it is there; NaN: not moved
};

}  // namespace asperity
