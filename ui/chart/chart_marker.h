// What lies over a chart and moves with the pointer, apart from the rest so that it costs little:
// the marker, and the reading of what is pointed at. Graphics items; GUI thread.
#pragma once

#include <QGraphicsItem>
#include <QPainterPath>
#include <QString>
#include <optional>

#include "ui/chart/chart_panel.h"

namespace asperity {

class MarkerItem : public QGraphicsItem {
 public:
  using QGraphicsItem::QGraphicsItem;

  /// lineX: where the line stands while it is dragged, ahead of its dot; NaN: at the marker.
  void update(const ChartGeometry& geometry, const std::optional<DiagramMarker>& marker,
              double lineX, const ChartLook& look);
  QRectF boundingRect() const override { return bounds_; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

 private:
  void layTrace();
  void paintTrace(QPainter& painter) const;

  ChartGeometry geometry_;
  std::optional<DiagramMarker> marker_;
  QPainterPath trace_;
  double lineX_ = 0;
  ChartLook look_;
  QRectF bounds_, label_;
};

/// A few lines of text beside a place, which gets a ring where it is a point.
class TipItem : public QGraphicsItem {
 public:
  using QGraphicsItem::QGraphicsItem;

  void show(const QString& text, QPointF place, bool ringed, const QRectF& room,
            const ChartLook& look);
  void clear();
  QString text() const { return text_; }
  QRectF boundingRect() const override { return bounds_; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

 private:
  QString text_;
  QPointF place_;
  bool isRinged_ = false;
  ChartLook look_;
  QRectF bounds_, box_;
};

}  // namespace asperity
