// A widget that shows a Plot. The interface hides the library that draws it, so that the library
// can be replaced: makePlotView() is the only place that knows which one it is.
// GUI thread; owned by its parent like any widget. Cannot fail: what has no place is not drawn.
#pragma once

#include <QColor>
#include <QPointF>
#include <QWidget>

#include "ui/charts/plot.h"

namespace asperity {

struct PlotColours {
  QColor background, text, faintText, grid, axis;
  QColor points, line, marker;
};

class PlotView : public QWidget {
 public:
  using QWidget::QWidget;

  virtual void setPlot(const Plot& plot) = 0;
  virtual const Plot& plot() const = 0;
  virtual void setColours(const PlotColours& colours) = 0;

  /// Where a point of the plot is in the widget's pixels; the point has to be plottable.
  virtual QPointF positionOf(double x, double y) const = 0;
};

PlotView* makePlotView(QWidget* parent = nullptr);

}  // namespace asperity
