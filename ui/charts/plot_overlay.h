// What Qt Charts does not draw on logarithmic axes, or not where it belongs (its points sit a pixel
// or two beside their values): the fine grid inside the decades, points with error bars, and the
// marker. Two graphics items that share one geometry; owned by the chart, GUI thread.
#pragma once

#include <QGraphicsItem>
#include <QRectF>

#include "ui/charts/plot.h"
#include "ui/charts/plot_view.h"

namespace asperity {

/// Maps values to positions inside the plot area, both axes logarithmic.
struct PlotGeometry {
  QRectF area;
  DecadeRange x, y;

  double xOf(double value) const;
  double yOf(double value) const;
};

/// Opacity of what belongs to an older scene.
inline constexpr double kFadedOpacity = 0.3;

class PlotItem : public QGraphicsItem {
 public:
  using QGraphicsItem::QGraphicsItem;

  void update(const PlotGeometry& geometry, const Plot& plot, const PlotColours& colours);
  QRectF boundingRect() const override;

 protected:
  PlotGeometry geometry_;
  Plot plot_;
  PlotColours colours_;
};

class FineGridItem : public PlotItem {
 public:
  using PlotItem::PlotItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;
};

class OverlayItem : public PlotItem {
 public:
  using PlotItem::PlotItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

 private:
  void paintErrorBars(QPainter& painter, const PlotSeries& series) const;
  void paintPoints(QPainter& painter, const PlotSeries& series) const;
  void paintMarker(QPainter& painter, const PlotMarker& marker) const;
  void paintBlank(QPainter& painter) const;
};

}  // namespace asperity
