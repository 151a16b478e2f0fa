// Items over a chart that move with the pointer. They are separate from the chart, so that a
// movement repaints little: the marker, and the reading of a point. Graphics items; GUI thread.
#pragma once

#include <QGraphicsItem>
#include <QList>
#include <QPainterPath>
#include <QStaticText>
#include <QString>
#include <optional>

#include "ui/chart/chart_geometry.h"
#include "ui/chart/chart_style.h"

namespace asperity {

class MarkerItem : public QGraphicsItem {
 public:
  using QGraphicsItem::QGraphicsItem;

  /// Updates marker, trace and text, and returns what must be painted. The item's bounds stay, so
  /// that the scene does not report the change in a later event: who calls this asks the view to
  /// paint, in the event in which the contact is painted. lineX: position of the line while it is
  /// dragged and the dot has not followed yet; NaN: at the marker. taken: rectangles of other
  /// texts, which the marker's own text avoids. sentence: a rectangle that interrupts the line.
  QRectF update(const ChartGeometry& geometry, const std::optional<DiagramMarker>& marker,
                double lineX, const ChartStyle& style, const QList<QRectF>& taken,
                const QRectF& sentence);
  /// Returns the rectangle of the label; empty where there is none.
  QRectF label() const { return label_; }
  QRectF boundingRect() const override { return bounds_; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

 private:
  QRectF labelRect(const QList<QRectF>& taken) const;
  void makeTrace();
  void placeLine(double lineX, const QList<QRectF>& taken);
  void paintLine(QPainter& painter) const;
  void paintTrace(QPainter& painter) const;

  ChartGeometry geometry_;
  std::optional<DiagramMarker> marker_;
  QPainterPath trace_;
  double lineX_ = 0;
  ChartStyle style_;
  QRectF bounds_, drawn_, label_, sentence_;
};

/// Shows a few lines of text beside a position; a point also gets a ring.
class TipItem : public QGraphicsItem {
 public:
  using QGraphicsItem::QGraphicsItem;

  /// avoided: what the text covers only where it has no other place.
  void show(const QString& text, QPointF position, bool ringed, const QRectF& bounds,
            const ChartStyle& style, const QList<QRectF>& avoided);
  void clear();
  QString text() const { return text_; }
  QRectF boundingRect() const override { return bounds_; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

 private:
  QString text_;
  QStaticText lines_;  // the text as it is drawn
  QPointF position_;
  bool isRinged_ = false;
  ChartStyle style_;
  QRectF bounds_, box_;
};

}  // namespace asperity
