// What a person does with a plot: reading, dragging the marker, choosing points, moving the view.
#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "ui/charts/chart_plot_view.h"

namespace asperity {

namespace {

constexpr double kWheel = 1.25;  // for one notch of the wheel
constexpr double kKeyZoom = 1.5;
constexpr double kKeyStep = 0.05;  // decades for a key

double notches(const QWheelEvent& event) {
  return event.angleDelta().y() / 120.0;
}

}  // namespace

void ChartPlotView::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return PlotView::mousePressEvent(event);
  const QPointF place = event->position() - corner();
  pressed_ = targetAt(geometry(), plot_, place);
  pressedAt_ = panAt_ = place;
  gesture_ = Gesture::Press;
  if (pressed_.isMarker) grip_ = geometry().xOf(plot_.marker->x) - place.x();
}

void ChartPlotView::mouseMoveEvent(QMouseEvent* event) {
  const QPointF place = event->position() - corner();
  hover_ = place;
  if (gesture_ == Gesture::None) return read(place);
  const bool isFar =
      (place - pressedAt_).manhattanLength() >= QApplication::startDragDistance() / 2.0;
  if (gesture_ == Gesture::Press && isFar) {
    gesture_ = pressed_.isMarker ? Gesture::Marker : Gesture::Pan;
    tip_->clear();
    setCursor(pressed_.isMarker ? Qt::SizeHorCursor : Qt::ClosedHandCursor);
  }
  if (gesture_ == Gesture::Marker) dragMarker(place);
  if (gesture_ == Gesture::Pan) {
    setZoom(panned(geometry(), place - panAt_));
    panAt_ = place;
  }
}

void ChartPlotView::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return PlotView::mouseReleaseEvent(event);
  const Gesture ended = std::exchange(gesture_, Gesture::None);
  if (ended == Gesture::Press && pressed_.isPoint()) {
    const PlotSeries& series = plot_.series[static_cast<std::size_t>(pressed_.series)];
    emit pointChosen(series.id, series.points[static_cast<std::size_t>(pressed_.point)].row);
  }
  read(event->position() - corner());
}

void ChartPlotView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return PlotView::mouseDoubleClickEvent(event);
  const PlotTarget target = targetAt(geometry(), plot_, event->position() - corner());
  if (!target.isPoint() && !target.isMarker) fit();
}

void ChartPlotView::wheelEvent(QWheelEvent* event) {
  const QPointF place = event->position() - corner();
  const ZoomAxes axes = axesAt(geometry(), place);
  if ((!axes.x && !axes.y) || event->angleDelta().y() == 0) return event->ignore();
  setZoom(zoomed(geometry(), place, std::pow(kWheel, -notches(*event)), axes));
  event->accept();
}

void ChartPlotView::leaveEvent(QEvent* event) {
  PlotView::leaveEvent(event);
  hover_.reset();
  tip_->clear();
}

void ChartPlotView::keyPressEvent(QKeyEvent* event) {
  const bool isRight = event->key() == Qt::Key_Right;
  if (isRight || event->key() == Qt::Key_Left) {
    if (event->modifiers() & Qt::ControlModifier) return chooseNextPoint(isRight);
    if (!plot_.marker || !isPlottable(plot_.marker->x, 1)) return;
    const double step = event->modifiers() & Qt::ShiftModifier ? kKeyStep / 10 : kKeyStep;
    const double from = std::isfinite(wantedX_) ? wantedX_ : plot_.marker->x;
    return moveMarker(from * std::pow(10, isRight ? step : -step));
  }
  if (event->key() == Qt::Key_Plus || event->key() == Qt::Key_Equal) return zoom(1 / kKeyZoom);
  if (event->key() == Qt::Key_Minus) return zoom(kKeyZoom);
  if (event->key() == Qt::Key_Home) return fit();
  PlotView::keyPressEvent(event);
}

void ChartPlotView::zoom(double factor) {
  setZoom(zoomed(geometry(), geometry().area.center(), factor, {true, true}));
}

void ChartPlotView::fit() {
  setZoom(std::nullopt);
}

void ChartPlotView::setZoom(const std::optional<PlotWindow>& window) {
  if (window == zoom_) return;
  const bool was = isZoomed();
  zoom_ = window;
  showAll();
  if (was != isZoomed()) emit zoomChanged(isZoomed());
}

/// What lies under the pointer, in words, and the shape of the pointer that goes with it.
void ChartPlotView::read(QPointF place) {
  const PlotGeometry map = geometry();
  const PlotTarget target = targetAt(map, plot_, place);
  setCursor(target.isMarker    ? Qt::SizeHorCursor
            : target.isPoint() ? Qt::PointingHandCursor
                               : Qt::ArrowCursor);
  QString text;
  QPointF at = place;
  if (target.isPoint()) {
    const PlotSeries& series = plot_.series[static_cast<std::size_t>(target.series)];
    const PlotPoint& point = series.points[static_cast<std::size_t>(target.point)];
    at = {map.xOf(point.x), map.yOf(point.y)};
    if (describe_) text = describe_(series.id, point.row);
  } else if (target.stripPoint >= 0) {
    const PlotPoint& point = plot_.strip->points[static_cast<std::size_t>(target.stripPoint)];
    at = stripPositionOf(point.x, std::clamp(point.y, plot_.strip->from, plot_.strip->to)) -
         corner();
    if (describe_) text = describe_(kStripCurve, point.row);
  } else if (target.span >= 0) {
    text = plot_.spans[static_cast<std::size_t>(target.span)].tip;
  }
  if (text.isEmpty()) return tip_->clear();
  tip_->show(text, at, target.span < 0, chart_->rect(), colours_, font());
}

void ChartPlotView::dragMarker(QPointF place) {
  const PlotGeometry map = geometry();
  moveMarker(map.valueAt(std::clamp(place.x() + grip_, map.area.left(), map.area.right())));
}

void ChartPlotView::moveMarker(double x) {
  wantedX_ = x;
  updateMarker();
  emit markerMoved(x);
}

/// Of the present curve; where there is none, nothing.
void ChartPlotView::chooseNextPoint(bool forward) {
  if (!plot_.marker) return;
  const double from = std::isfinite(wantedX_) ? wantedX_ : plot_.marker->x;
  const PlotPoint* best = nullptr;
  for (const PlotSeries& series : plot_.series) {
    if (series.id != kPresentCurve) continue;
    for (const PlotPoint& point : series.points) {
      const bool isBeyond = forward ? point.x > from * (1 + 1e-9) : point.x < from * (1 - 1e-9);
      if (isBeyond && (!best || (point.x < best->x) == forward)) best = &point;
    }
  }
  if (!best) return;
  wantedX_ = best->x;
  updateMarker();
  emit pointChosen(kPresentCurve, best->row);
}

}  // namespace asperity
