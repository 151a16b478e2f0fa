// What Qt Charts does not draw on logarithmic axes, or not where it belongs (its points sit a pixel
// or two beside their values): names and shades of regions, the grid, points with error bars,
// the strip below, the marker and the reading at the pointer. Graphics items that share one
// geometry; owned by the chart, GUI thread.
#pragma once

#include <QGraphicsItem>
#include <QPainterPath>
#include <QRectF>
#include <QString>

#include "ui/chart/plot.h"
#include "ui/chart/plot_geometry.h"
#include "ui/chart/plot_view.h"

namespace asperity {

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

class SpanItem : public PlotItem {
 public:
  using PlotItem::PlotItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;
};

class GridItem : public PlotItem {
 public:
  using PlotItem::PlotItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;
};

class PointsItem : public PlotItem {
 public:
  using PlotItem::PlotItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

 private:
  void paintErrorBars(QPainter& painter, const PlotSeries& series) const;
  void paintPoints(QPainter& painter, const PlotSeries& series) const;
  void paintBlank(QPainter& painter) const;
};

/// The titles of the axes, which the library cuts where it does not have to: along the line below
/// the labels, and upright at the left edge, the longest form that has room.
class TitlesItem : public PlotItem {
 public:
  using PlotItem::PlotItem;
  QRectF boundingRect() const override;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

  /// Of the axis along, with `width` pixels for it; shorter than the title where that does not fit.
  static QString alongWithin(const Plot& plot, const QFont& font, double width);
  static QString uprightWithin(const Plot& plot, const QFont& font, double height);
};

/// The slim plot below; labels and title of the common axis stand under it.
class StripItem : public PlotItem {
 public:
  using PlotItem::PlotItem;
  QRectF boundingRect() const override;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

 private:
  double yOf(double value) const;
  void paintAxis(QPainter& painter) const;
  void paintAlong(QPainter& painter) const;
  void paintPoints(QPainter& painter) const;
  void paintName(QPainter& painter) const;
};

/// Apart from the rest, so that dragging it paints little.
class MarkerItem : public QGraphicsItem {
 public:
  using QGraphicsItem::QGraphicsItem;

  /// lineX: where the line stands while it is dragged, ahead of its dot; NaN: at the marker.
  void update(const PlotGeometry& geometry, const std::optional<PlotMarker>& marker, double lineX,
              const PlotColours& colours, const QFont& font);
  QRectF boundingRect() const override { return bounds_; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

 private:
  void layTrace();
  void paintTrace(QPainter& painter) const;

  PlotGeometry geometry_;
  std::optional<PlotMarker> marker_;
  QPainterPath trace_;
  double lineX_ = 0;
  PlotColours colours_;
  QFont font_;
  QRectF bounds_, label_;
};

/// A few lines of text beside a place, which gets a ring where it is a point.
class TipItem : public QGraphicsItem {
 public:
  using QGraphicsItem::QGraphicsItem;

  void show(const QString& text, QPointF place, bool ringed, const QRectF& room,
            const PlotColours& colours, const QFont& font);
  void clear();
  QString text() const { return text_; }
  QRectF boundingRect() const override { return bounds_; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

 private:
  QString text_;
  QPointF place_;
  bool isRinged_ = false;
  double scale_ = 1;  // of the ring, as of marks
  PlotColours colours_;
  QFont font_;
  QRectF bounds_, box_;
};

}  // namespace asperity
