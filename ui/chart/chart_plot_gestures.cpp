// What a person does with a plot: reading, dragging the marker, choosing points, moving the view.
#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "ui/chart/chart_plot_view.h"

namespace asperity {

namespace {

constexpr double kWheel = 1.25;  // for one notch of the wheel
constexpr double kKeyZoom = 1.5;
constexpr double kKeyStep = 0.05;  // decades for a key
constexpr double kFinely = 0.1;    // of a drag or a key's step, with Shift

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
  if (!pressed_.isMarker) return;
  grippedX_ = geometry().xOf(plot_.marker->x);
  gripMarker(place, event->modifiers() & Qt::ShiftModifier);
}

void ChartPlotView::mouseMoveEvent(QMouseEvent* event) {
  const QPointF place = event->position() - corner();
  hover_ = place;
  if (gesture_ == Gesture::None) return read(place);
  const bool isFar =
      (place - pressedAt_).manhattanLength() >= QApplication::startDragDistance() / 2.0;
  if (gesture_ == Gesture::Press && isFar) {
    gesture_ = pressed_.isMarker ? Gesture::Marker : Gesture::Pan;
    if (pressed_.isMarker && !zoom_) held_ = plot_.x.range;
    tip_->clear();
    setCursor(pressed_.isMarker ? Qt::SizeHorCursor : Qt::ClosedHandCursor);
  }
  if (gesture_ == Gesture::Marker) dragMarker(place, event->modifiers() & Qt::ShiftModifier);
  if (gesture_ == Gesture::Pan) {
    pan(place - panAt_);
    panAt_ = place;
  }
}

/// On both axes or on one, as long as there is something to see.
void ChartPlotView::pan(QPointF by) {
  const PlotGeometry map = geometry();
  const PlotWindow whole{plot_.x.range, plot_.y.range};
  const bool isEmpty = !showsCurves(window(), plot_);
  for (const QPointF way : {by, QPointF(by.x(), 0), QPointF(0, by.y())}) {
    const PlotWindow next = heldWithin(panned(map, way), whole);
    if (isEmpty || showsCurves(next, plot_)) return setZoom(next);
  }
}

void ChartPlotView::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return PlotView::mouseReleaseEvent(event);
  const Gesture ended = std::exchange(gesture_, Gesture::None);
  if (ended == Gesture::Press && pressed_.isPoint()) {
    const PlotSeries& series = plot_.series[static_cast<std::size_t>(pressed_.series)];
    emit pointChosen(series.id, series.points[static_cast<std::size_t>(pressed_.point)].row);
  }
  if (std::exchange(held_, std::nullopt)) showAll();
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
    if (!plot_.marker || plot_.marker->isFixed || !isPlottable(plot_.marker->x, 1)) return;
    const bool finely = event->modifiers() & Qt::ShiftModifier;
    const double step = finely ? kFinely * kKeyStep : kKeyStep;
    const double from = std::isfinite(wantedX_) ? wantedX_ : plot_.marker->x;
    return moveMarker(from * std::pow(10, isRight ? step : -step), finely);
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

void ChartPlotView::setZoom(const std::optional<PlotWindow>& wanted) {
  std::optional<PlotWindow> window = wanted;
  if (window) window = heldWithin(*window, {plot_.x.range, plot_.y.range});
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
  } else if (place.y() > std::max(map.area.bottom(), map.strip.bottom()) &&
             TitlesItem::alongWithin(plot_, font(), map.area.width()) != plot_.x.title) {
    text = plot_.x.title;  // which is cut there
  }
  if (text.isEmpty()) return tip_->clear();
  tip_->show(text, at, target.span < 0, chart_->rect(), colours_, font());
}

void ChartPlotView::gripMarker(QPointF place, bool finely) {
  gripAt_ = place;
  gripsFinely_ = finely;
}

/// Finely the marker goes a part of the pointer's way, from where it is.
void ChartPlotView::dragMarker(QPointF place, bool finely) {
  const PlotGeometry map = geometry();
  if (finely != gripsFinely_) {
    if (std::isfinite(wantedX_)) grippedX_ = map.xOf(wantedX_);
    gripMarker(place, finely);
  }
  const double way = (place.x() - gripAt_.x()) * (finely ? kFinely : 1);
  moveMarker(map.valueAt(std::clamp(grippedX_ + way, map.area.left(), map.area.right())), finely);
}

void ChartPlotView::moveMarker(double x, bool finely) {
  wantedX_ = x;
  updateMarker();
  emit markerMoved(x, finely);
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
