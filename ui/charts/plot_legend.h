// The line above a plot: what each mark means, and how far the plot is. GUI thread.
#pragma once

#include <QWidget>

#include "ui/charts/plot.h"
#include "ui/charts/plot_view.h"

namespace asperity {

class PlotLegend : public QWidget {
 public:
  explicit PlotLegend(QWidget* parent = nullptr);

  void show(const Plot& plot, const PlotColours& colours);
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  double paintNote(QPainter& painter) const;
  void paintSample(QPainter& painter, const PlotSeries& series, QPointF centre) const;

  Plot plot_;
  PlotColours colours_;
};

}  // namespace asperity
