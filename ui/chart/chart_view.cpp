#include "ui/chart/chart_view.h"

#include <QApplication>
#include <QEvent>
#include <QFocusEvent>
#include <QGraphicsScene>
#include <QGraphicsView>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPaintEvent>
#include <QPainter>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/statistics.h"
#include "core/chart/curve_diagram.h"
#include "ui/chart/chart_legend.h"
#include "ui/chart/chart_marker.h"
#include "ui/chart/chart_panel.h"
#include "ui/chart/chart_reading.h"
#include "ui/chart/diagram_axes.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"

namespace asperity {

namespace {

constexpr double kOverlayDepth = 100;  // above everything in the charts
constexpr double kLegend = 0.25;       // part of the height, at which names are shortened
constexpr double kWheel = 1.25;        // factor of one step of the wheel
constexpr double kKeyZoom = 1.5;
constexpr double kKeyStep = 0.05;  // decades per key press
constexpr double kFinely = 0.1;    // factor of a drag or key step with Shift

}  // namespace

ChartView::ChartView(QWidget* parent)
    : QWidget(parent),
      head_(new QHBoxLayout),
      foot_(new QHBoxLayout),
      legend_(new ChartLegend),
      view_(new QGraphicsView),
      marker_(new MarkerItem),
      tip_(new TipItem),
      targetX_(kNaN) {
  auto* scene = new QGraphicsScene(this);
  scene->addItem(marker_);
  scene->addItem(tip_);
  marker_->setZValue(kOverlayDepth);
  tip_->setZValue(kOverlayDepth + 1);
  view_->setScene(scene);
  view_->setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
  view_->setFrameShape(QFrame::NoFrame);
  view_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  view_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  view_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  view_->setFocusPolicy(Qt::NoFocus);
  view_->viewport()->setFocusPolicy(Qt::NoFocus);
  view_->setAttribute(Qt::WA_TransparentForMouseEvents);  // this widget handles gestures
  view_->installEventFilter(this);
  setMouseTracking(true);
  connect(legend_, &ChartLegend::unpinRequested, this, &ChartView::unpinRequested);
  connect(legend_, &ChartLegend::pointedAt, this,
          [this](const QString& anchor) { anchor_ = anchor; });
  connect(legend_, &ChartLegend::entered, this, [this] {
    hover_.reset();
    tip_->clear();
  });
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  head_->addWidget(legend_, 1, Qt::AlignTop);
  layout->addLayout(head_);
  layout->addWidget(view_, 1);
  layout->addLayout(foot_);
  keepTranslated(*this, [this] {
    sheet_ = translated(english_);
    showAll();
  });
}

ChartView::~ChartView() = default;

void ChartView::setChoosers(QWidget* x, QWidget* y) {
  hasChoosers_ = true;
  head_->setContentsMargins(8, 4, 0, 0);
  head_->insertWidget(0, y, 0, Qt::AlignTop);
  foot_->setContentsMargins(8, 0, 8, 4);
  foot_->addStretch(1);
  foot_->addWidget(x);
  foot_->addStretch(1);
  showAll();
}

void ChartView::setSheet(const DiagramSheet& english) {
  const std::pair before = markerPosition();
  english_ = english;
  sheet_ = translated(english);
  if (markerPosition().first != before.first && gesture_ != Gesture::Marker) targetX_ = kNaN;
  if (zoom_) zoom_ = clampedTo(*zoom_, whole());
  showAll();
  // The scene reports its changes in a later event, in which a marker that comes with other axes
  // would be painted after the contact that shows the same moment.
  if (markerPosition() != before) view_->viewport()->update();
}

void ChartView::setMarker(const std::optional<DiagramMarker>& english) {
  if (sheet_.diagrams.empty()) return;
  std::optional<DiagramMarker>& marker = sheet_.diagrams[0].marker;
  const double before = markerPosition().first;
  const std::string name = marker ? marker->name.text : "";
  english_.diagrams[0].marker = english;
  marker.reset();
  if (english) marker = translated(*english);
  if (markerPosition().first != before && gesture_ != Gesture::Marker) targetX_ = kNaN;
  updateMarker();
  if (name != (marker ? marker->name.text : "")) showLegend();
}

void ChartView::setTheme(const Theme& theme) {
  style_.theme = theme;
  view_->setBackgroundBrush(style_.background());
  showAll();
}

QString ChartView::guideAnchor() const {
  return anchor_.isEmpty() ? QStringLiteral("regions") : anchor_;
}

QString ChartView::reading() const {
  return tip_->text();
}

QPointF ChartView::corner() const {
  return view_->mapTo(this, view_->mapFromScene(QPointF()));
}

QPointF ChartView::mapToPosition(double x, double y, std::size_t diagram) const {
  return diagram < layout_.frames.size() ? layout_.frames[diagram].at(x, y) + corner() : QPointF();
}

bool ChartView::hasMarker() const {
  return !sheet_.diagrams.empty() && sheet_.diagrams[0].marker;
}

/// Returns x and y of the marker; NaN where there is none.
std::pair<double, double> ChartView::markerPosition() const {
  if (!hasMarker()) return {kNaN, kNaN};
  return {sheet_.diagrams[0].marker->x, sheet_.diagrams[0].marker->y};
}

std::optional<ChartGeometry> ChartView::frame() const {
  if (layout_.frames.empty()) return std::nullopt;
  ChartGeometry frame = layout_.frames[0];
  frame.area.translate(corner());
  return frame;
}

OccupancyGrid ChartView::covered() const {
  const std::optional<ChartGeometry> map = frame();
  if (!map || panels_.empty()) return {{}, 1};
  OccupancyGrid covered = coveredBySeries(sheet_.diagrams[0], *map, style_);
  const auto x = static_cast<float>(map->mapX(lineValue()));
  const Box& area = covered.area();
  covered.addLine({{x, area.y}, {x, area.bottom()}}, 1);
  for (const QRectF& name : panels_[0]->namesInside())
    covered.addBox(toBox(name.translated(corner())), 1);
  if (const QRectF label = marker_->label(); !label.isEmpty())
    covered.addBox(toBox(label.translated(corner())), 1);
  return covered;
}

/// Returns the axes of the first diagram as its sheet has them, without zoom.
VisibleRange ChartView::whole() const {
  if (sheet_.diagrams.empty()) return {};
  const AxisRange x = xRange(sheet_.diagrams[0]);
  return {x, yRange(sheet_.diagrams[0], x)};
}

VisibleRange ChartView::visibleRange() const {
  if (zoom_) return *zoom_;
  VisibleRange all = whole();
  if (held_) all.x = *held_;
  return all;
}

/// Fills the space beside the choosers with the background of the charts.
void ChartView::paintEvent(QPaintEvent* event) {
  QPainter(this).fillRect(event->rect(), style_.background());
}

void ChartView::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (isDue_) showAll();
}

void ChartView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  showAll();
}

/// Updates the charts, once the layout is done, where the choosers or the legend change their size:
/// with other texts, or more lines.
bool ChartView::eventFilter(QObject* watched, QEvent* event) {
  if (watched == view_ && event->type() == QEvent::Resize) {
    const auto update = [this] {
      if (view_->scene()->sceneRect().size() != QSizeF(view_->size())) showAll();
    };
    QMetaObject::invokeMethod(this, update, Qt::QueuedConnection);
  }
  return QWidget::eventFilter(watched, event);
}

void ChartView::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange) showAll();
}

void ChartView::focusInEvent(QFocusEvent* event) {
  QWidget::focusInEvent(event);
  const Qt::FocusReason reason = event->reason();
  showFocus(reason == Qt::TabFocusReason || reason == Qt::BacktabFocusReason);
}

void ChartView::focusOutEvent(QFocusEvent* event) {
  QWidget::focusOutEvent(event);
  showFocus(false);
}

void ChartView::showFocus(bool shows) {
  if (std::exchange(style_.showsFocus, shows) != shows) showAll();
}

void ChartView::showLegend() {
  legend_->show(sheet_, english_, style_, kLegend * height());
}

/// Updates everything. A hidden view waits until it is visible again.
void ChartView::showAll() {
  isDue_ = !isVisible();
  if (isDue_) return;
  style_.font = font();
  showLegend();
  layout()->activate();  // the charts must not cover the legend
  view_->scene()->setSceneRect(0, 0, view_->width(), view_->height());
  layout_ = layOutChart(sheet_, visibleRange(), view_->size(), style_, hasChoosers_);
  const std::vector<ChartGeometry>& frames = layout_.frames;
  while (panels_.size() > frames.size()) panels_.pop_back();
  while (panels_.size() < frames.size())
    panels_.push_back(std::make_unique<ChartPanel>(*view_->scene()));
  update();
  for (std::size_t i = 0; i < frames.size(); ++i)
    panels_[i]->show(sheet_.diagrams[i], frames[i], style_,
                     {!hasChoosers_, i > 0 || !hasChoosers_, i + 1 == frames.size(),
                      layout_.titleBeside, i > 0 && layout_.hasTitlesAbove});
  if (!frames.empty() &&
      (xTitle_ != panels_.back()->xTitle() || yTitle_ != panels_.front()->yTitle())) {
    xTitle_ = panels_.back()->xTitle();
    yTitle_ = panels_.front()->yTitle();
    emit titlesChanged(xTitle_, yTitle_);
  }
  updateMarker();
  if (hover_ && gesture_ == Gesture::None)
    read(*hover_);  // another object may be there now
  else
    tip_->clear();
}

void ChartView::updateMarker() {
  ChartGeometry frame;
  std::optional<DiagramMarker> marker;
  QList<QRectF> taken;
  QRectF sentence;
  if (!layout_.frames.empty()) {
    frame = layout_.frames[0];
    marker = sheet_.diagrams[0].marker;
    if (!panels_.empty()) {
      panels_[0]->avoidLine(frame.mapX(lineValue()));
      taken = panels_[0]->namesInside();
      sentence = panels_[0]->sentence();
      if (!sentence.isEmpty()) taken += sentence;
    }
  }
  const QRectF changed = marker_->update(frame, marker, targetX_, style_, taken, sentence);
  view_->viewport()->update(view_->mapFromScene(changed).boundingRect().adjusted(-2, -2, 2, 2));
}

void ChartView::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return QWidget::mousePressEvent(event);
  const QPointF position = event->position() - corner();
  const ChartTarget target = targetAt(layout_.frames, sheet_, position);
  pressesMarker_ = target.isMarker;
  pressedPoint_.reset();
  if (target.isPoint() && target.diagram == 0)
    pressedPoint_ = {targetSeries(sheet_, target).id, targetPoint(sheet_, target).row};
  pressedAt_ = panAt_ = position;
  gesture_ = Gesture::Press;
  if (!pressesMarker_) return;
  grippedX_ = layout_.frames[0].mapX(sheet_.diagrams[0].marker->x);
  gripMarker(position, event->modifiers() & Qt::ShiftModifier);
}

void ChartView::mouseMoveEvent(QMouseEvent* event) {
  const QPointF position = event->position() - corner();
  hover_ = position;
  if (gesture_ == Gesture::None) return read(position);
  const bool isFar =
      (position - pressedAt_).manhattanLength() >= QApplication::startDragDistance() / 2.0;
  if (gesture_ == Gesture::Press && isFar) {
    gesture_ = pressesMarker_ ? Gesture::Marker : Gesture::Pan;
    if (pressesMarker_ && !zoom_) held_ = whole().x;
    tip_->clear();
    setCursor(pressesMarker_ ? Qt::SizeHorCursor : Qt::ClosedHandCursor);
  }
  if (gesture_ == Gesture::Marker) dragMarker(position, event->modifiers() & Qt::ShiftModifier);
  if (gesture_ == Gesture::Pan) {
    pan(position - panAt_);
    panAt_ = position;
  }
}

/// Pans on both axes or on one, as long as a curve stays visible.
void ChartView::pan(QPointF by) {
  if (layout_.frames.empty()) return;
  const ChartGeometry map = layout_.frames[0];
  const Diagram& diagram = sheet_.diagrams[0];
  const bool isEmpty = !showsCurves(visibleRange(), diagram);
  for (const QPointF displacement : {by, QPointF(by.x(), 0), QPointF(0, by.y())}) {
    const VisibleRange next = clampedTo(panned(map, displacement), whole());
    if (isEmpty || showsCurves(next, diagram)) return setZoom(next);
  }
}

void ChartView::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return QWidget::mouseReleaseEvent(event);
  const Gesture ended = std::exchange(gesture_, Gesture::None);
  if (ended == Gesture::Press && pressedPoint_)
    emit pointChosen(pressedPoint_->first, pressedPoint_->second);
  if (std::exchange(held_, std::nullopt)) showAll();
  read(event->position() - corner());
}

void ChartView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return QWidget::mouseDoubleClickEvent(event);
  const ChartTarget target = targetAt(layout_.frames, sheet_, event->position() - corner());
  if (target.isPoint() || target.isMarker) return;
  fit();
  emit fitRequested();
}

void ChartView::wheelEvent(QWheelEvent* event) {
  const QPointF position = event->position() - corner();
  if (layout_.frames.empty()) return event->ignore();
  const ZoomAxes axes = axesAt(layout_.frames[0], position);
  if ((!axes.x && !axes.y) || event->angleDelta().y() == 0) return event->ignore();
  const double steps = event->angleDelta().y() / double{QWheelEvent::DefaultDeltasPerStep};
  setZoom(zoomed(layout_.frames[0], position, std::pow(kWheel, -steps), axes));
  event->accept();
}

void ChartView::leaveEvent(QEvent* event) {
  QWidget::leaveEvent(event);
  hover_.reset();
  tip_->clear();
}

void ChartView::keyPressEvent(QKeyEvent* event) {
  const bool isRight = event->key() == Qt::Key_Right;
  if (isRight || event->key() == Qt::Key_Left) {
    if (event->modifiers() & Qt::ControlModifier) return chooseNextPoint(isRight);
    if (!hasMarker()) return;
    const DiagramMarker& marker = *sheet_.diagrams[0].marker;
    const bool isLinear = sheet_.diagrams[0].x.scale == AxisScale::Linear;
    if (marker.isFixed || (!isLinear && !(marker.x > 0))) return;
    const bool finely = event->modifiers() & Qt::ShiftModifier;
    const double step = finely ? kFinely * kKeyStep : kKeyStep;
    const double from = lineValue();
    const double displacement = isRight ? step : -step;
    // On a linear axis, the step is a part of the visible range.
    return moveMarker(isLinear ? from + displacement * visibleRange().x.size()
                               : from * std::pow(10, displacement),
                      finely);
  }
  if (event->key() == Qt::Key_Plus || event->key() == Qt::Key_Equal) return zoom(1 / kKeyZoom);
  if (event->key() == Qt::Key_Minus) return zoom(kKeyZoom);
  if (event->key() == Qt::Key_Home) {
    fit();
    return emit fitRequested();
  }
  QWidget::keyPressEvent(event);
}

void ChartView::zoom(double factor) {
  if (!layout_.frames.empty())
    setZoom(zoomed(layout_.frames[0], layout_.frames[0].area.center(), factor, {true, true}));
}

void ChartView::fit() {
  setZoom(std::nullopt);
}

void ChartView::setZoom(const std::optional<VisibleRange>& requested) {
  const bool isZoomable =
      !sheet_.diagrams.empty() && sheet_.diagrams[0].x.scale == AxisScale::Logarithmic;
  std::optional<VisibleRange> range = isZoomable ? requested : std::nullopt;
  if (range) range = clampedTo(*range, whole());
  if (range == zoom_) return;
  zoom_ = range;
  showAll();
}

/// Shows a reading of the object under the pointer, and the matching shape of the pointer.
void ChartView::read(QPointF position) {
  const ChartTarget target = targetAt(layout_.frames, sheet_, position);
  ReadableChart chart{english_, sheet_, layout_.frames};
  if (!panels_.empty()) {
    chart.shadeNames = panels_.front()->namesInside();
    chart.cutTitle = panels_.back()->elidedTitle();
  }
  const auto explanation = explanationAt(chart, target, position);
  anchor_ = explanation ? anchorText(*explanation) : QString();
  if (target.isMarker)
    setCursor(Qt::SizeHorCursor);
  else
    setCursor(target.isPoint() && target.diagram == 0 ? Qt::PointingHandCursor : Qt::ArrowCursor);
  // A number keeps its sign where a sentence is broken.
  const QString text = tipText(chart, target, position, describe_)
                           .replace(QStringLiteral(" %"), QStringLiteral("\u00A0%"));
  if (text.isEmpty()) return tip_->clear();
  QPointF at = position;
  if (target.isPoint()) {
    const DiagramPoint& point = targetPoint(sheet_, target);
    at = layout_.frames[static_cast<std::size_t>(target.diagram)].at(point.x, point.y);
  }
  tip_->show(text, at, target.isPoint(), view_->sceneRect(), style_, neighbours(chart, target));
}

void ChartView::gripMarker(QPointF position, bool finely) {
  gripAt_ = position;
  gripsFinely_ = finely;
}

/// Moves the marker. With `finely` it moves by a part of the pointer's distance, from its present
/// position.
void ChartView::dragMarker(QPointF position, bool finely) {
  if (layout_.frames.empty()) return;
  const ChartGeometry map = layout_.frames[0];
  if (finely != gripsFinely_) {
    if (std::isfinite(targetX_)) grippedX_ = map.mapX(targetX_);
    gripMarker(position, finely);
  }
  const double displacement = (position.x() - gripAt_.x()) * (finely ? kFinely : 1);
  moveMarker(map.xAt(std::clamp(grippedX_ + displacement, map.area.left(), map.area.right())),
             finely);
}

void ChartView::moveMarker(double x, bool finely) {
  targetX_ = x;
  updateMarker();
  emit markerMoved(x, finely);
}

double ChartView::lineValue() const {
  return hasMarker() && std::isfinite(targetX_) ? targetX_ : markerPosition().first;
}

void ChartView::releaseMarker() {
  targetX_ = kNaN;
  updateMarker();
}

/// Moves the marker to the next point of the present curve; does nothing without a curve.
void ChartView::chooseNextPoint(bool forward) {
  if (!hasMarker()) return;
  const DiagramPoint* next = nextPoint(sheet_.diagrams[0], kPresentCurve, lineValue(), forward);
  if (!next) return;
  targetX_ = next->x;
  const int row = next->row;
  updateMarker();
  emit pointChosen(kPresentCurve, row);
}

}  // namespace asperity
