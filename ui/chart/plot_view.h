// A widget that shows a Plot and lets a person read and move in it. The interface hides the library
// that draws it, so that the library can be replaced: makePlotView() is the only place that knows
// which one it is.
// Pointer: the marker is dragged (with Shift at a tenth of the pace); a click takes a point; the
// wheel zooms (over an axis' labels that axis alone), dragging pans, a double click fits. Keys:
// left and right move the marker by a part of a decade (with Shift a tenth of it, with Control to
// the next point), + and - zoom, Home fits. GUI thread; owned by its parent like any widget. Cannot
// fail: what has no place is not drawn.
#pragma once

#include <QColor>
#include <QPointF>
#include <QWidget>
#include <array>
#include <functional>

#include "ui/chart/plot.h"

namespace asperity {

struct PlotColours {
  QColor background, text, faintText, axis;
  QColor grid, fineGrid;  // at whole decades, and between them
  QColor points, line, marker;
  QColor span;        // over the background, where a region is shaded
  QColor shade;       // of a tint, with its transparency
  QColor difference;  // in the strip
  std::array<QColor, 6> pinned;
};

class PlotView : public QWidget {
  Q_OBJECT

 public:
  using QWidget::QWidget;

  virtual void setPlot(const Plot& plot) = 0;
  virtual const Plot& plot() const = 0;
  /// The marker alone, which costs little.
  virtual void setMarker(const std::optional<PlotMarker>& marker) = 0;
  virtual void setColours(const PlotColours& colours) = 0;

  /// Where a point of the plot is in the widget's pixels; the point has to be plottable. In the
  /// strip y counts linearly.
  virtual QPointF positionOf(double x, double y) const = 0;
  virtual QPointF stripPositionOf(double x, double y) const = 0;

  /// What is shown: the plot's ranges unless zoomed.
  virtual PlotWindow window() const = 0;
  virtual bool isZoomed() const = 0;
  virtual void zoom(double factor) = 0;  // about the middle; below 1: nearer
  virtual void fit() = 0;
  /// Shows this part; none: all, as fit().
  virtual void setZoom(const std::optional<PlotWindow>& window) = 0;

  /// The reading of a point: its series' number and its row. May be empty.
  using Describe = std::function<QString(int id, int row)>;
  void setDescribe(Describe describe) { describe_ = std::move(describe); }

  /// What is read at the pointer now; empty where nothing is.
  virtual QString reading() const = 0;

 signals:
  /// The marker is to stand at x, once for each step of a drag and each key. finely: all digits of
  /// it are meant.
  void markerMoved(double x, bool finely);
  void pointChosen(int id, int row);
  void unpinWanted(int id);
  void zoomChanged(bool isZoomed);

 protected:
  Describe describe_;
};

PlotView* makePlotView(QWidget* parent = nullptr);

}  // namespace asperity
