#include "ui/window/contact/contact_canvas.h"

#include <QContextMenuEvent>
#include <QFontInfo>
#include <QGestureEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QNativeGestureEvent>
#include <QPinchGesture>
#include <QToolTip>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/language/language.h"
#include "ui/panels/controls.h"
#include "ui/window/contact/contact_tips.h"
#include "ui/window/contact/contact_veil.h"

namespace asperity {

namespace {

constexpr double kKeyPan = 0.1;  // part of the plot per key press
constexpr int kManyElements = 10;
constexpr double kDragThreshold = 5;  // pixels after which a drag of the body has its direction
constexpr double kNudge = 1 / 80.0;   // part of the plot by which a key drags

double zoomSteps(double factor) {
  return factor > 0 ? std::log(factor) / std::log(ContactViewer::kZoomStep) : 0;
}

bool prefersOpenGl() {
  const QString choice = qEnvironmentVariable("ASPERITY_CANVAS");
  if (choice == QStringLiteral("software")) return false;
  const OpenGlSupport support = openGlSupport();
  if (choice == QStringLiteral("opengl")) return support != OpenGlSupport::None;
  return support == OpenGlSupport::Hardware;
}

}  // namespace

ContactCanvas::ContactCanvas(QWidget* parent)
    : QWidget(parent), layout_(marginless<QVBoxLayout>(this)), veil_(new ContactVeil(*this)) {
  setMinimumSize(320, 160);
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setContextMenuPolicy(Qt::ActionsContextMenu);
  grabGesture(Qt::PinchGesture);
  clock_.start();
  if (prefersOpenGl())
    useOpenGl();
  else
    useSoftware();
  keepTranslated(*this, [this] {
    setAccessibleName(tr("contact view"));
    setAccessibleDescription({});  // the last description, in the previous language
    refresh();                     // the picture contains texts
  });
}

void ContactCanvas::setFrame(std::shared_ptr<const Frame> frame) {
  viewer_.setFrame(std::move(frame));
  giveLabelsSpace();
  refresh();
  if (!backend_) takeReady(viewer_.frame());
}

/// Keeps the place of the labels free in a low picture, too.
void ContactCanvas::giveLabelsSpace() {
  if (!viewer_.frame()) return;
  viewer_.setLabelSpace(labelSpace(*viewer_.frame(), sizedOptions(request())));
}

void ContactCanvas::setTheme(const Theme& theme) {
  theme_ = theme;
  veil_->setTheme(theme);
  refresh();
}

void ContactCanvas::setVeil(const QString& reason) {
  veil_->showReason(reason);
}

void ContactCanvas::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  veil_->setGeometry(rect());
  giveLabelsSpace();
  refresh();
}

void ContactCanvas::setTextScale(double scale) {
  textScale_ = scale;
  giveLabelsSpace();
  refresh();
}

QString ContactCanvas::backendName() const {
  return backend_ ? backend_->name() : QString();
}

int ContactCanvas::framesPerSecond() const {
  while (!pictures_.empty() && pictures_.front() < clock_.elapsed() - 1000) pictures_.pop_front();
  return static_cast<int>(pictures_.size());
}

CanvasEvents ContactCanvas::eventsOfPictures() {
  CanvasEvents events;
  events.ready = [this](const std::shared_ptr<const Frame>& frame) { takeReady(frame); };
  events.painted = [this](const std::vector<LabelPlace>& labels) { takePainted(labels); };
  return events;
}

void ContactCanvas::useOpenGl() {
  CanvasEvents events = eventsOfPictures();
  events.failed = [this](const LiveText&) { useSoftware(); };
  setBackend(makeOpenGlCanvas(std::move(events), this));
}

void ContactCanvas::useSoftware() {
  CanvasEvents events = eventsOfPictures();
  events.failed = [this](const LiveText& reason) { showFailure(reason); };
  setBackend(makeSoftwareCanvas(std::move(events), this));
}

void ContactCanvas::setBackend(CanvasBackend* backend) {
  removeBackend();
  backend_ = backend;
  backend_->widget()->setAttribute(Qt::WA_TransparentForMouseEvents);  // this widget handles them
  layout_->addWidget(backend_->widget());
  veil_->raise();
  refresh();
}

void ContactCanvas::removeBackend() {
  if (!backend_) return;
  backend_->widget()->hide();
  backend_->widget()->deleteLater();
  backend_ = nullptr;
}

/// Shows a message in place of pictures, which nothing can draw.
void ContactCanvas::showFailure(const LiveText& reason) {
  removeBackend();
  auto* label = new QLabel;
  keepTranslated(*label, [label, reason] {
    label->setText(tr("The contact cannot be drawn here: %1").arg(QString(reason)));
  });
  label->setAlignment(Qt::AlignCenter);
  label->setWordWrap(true);
  layout_->addWidget(label);
  emit failed(reason);
  takeReady(viewer_.frame());
}

void ContactCanvas::takeReady(const std::shared_ptr<const Frame>& frame) {
  if (std::exchange(shown_, frame) != frame && frame) emit frameShown(frame);
}

void ContactCanvas::takePainted(const std::vector<LabelPlace>& labels) {
  labels_ = labels;
  pictures_.push_back(clock_.elapsed());
  emit painted();
}

void ContactCanvas::refresh() {
  if (backend_) backend_->show(viewer_.frame() ? request() : PictureRequest());
}

float ContactCanvas::fontSize() const {
  return textScale_ > 1 ? static_cast<float>(QFontInfo(font()).pixelSize() * devicePixelRatioF())
                        : 0;
}

/// Returns a request for the picture on the screen; the backend fills this widget.
PictureRequest ContactCanvas::request() const {
  PictureRequest request;
  request.frame = viewer_.frame();
  request.options = viewer_.options();
  request.options.theme = theme_;
  request.options.lastLabels = labels_;
  request.textScale = textScale_;
  request.scale = devicePixelRatioF();
  request.size = size() * request.scale;
  request.options.fontSize = fontSize();
  return request;
}

// ---- Wheel, buttons, gestures and keys

QRectF ContactCanvas::plotArea() const {
  if (!viewer_.frame()) return {};
  const PictureRequest shown = request();
  const Box plot = contactPlotArea(*shown.frame, sizedOptions(shown));
  return QRectF(plot.x / shown.scale, plot.y / shown.scale, plot.width / shown.scale,
                plot.height / shown.scale);
}

std::optional<ViewPosition> ContactCanvas::viewPositionAt(const QPointF& position) const {
  const QRectF plot = plotArea();
  if (plot.isEmpty() || !plot.contains(position)) return std::nullopt;
  return ViewPosition{(position.x() - plot.left()) / plot.width(),
                      (plot.bottom() - position.y()) / plot.height()};
}

/// Returns the centre of a zoom by keys: the crosshair's element and the surface there, otherwise
/// the middle.
ViewPosition ContactCanvas::zoomCentre() const {
  const auto reading = viewer_.reading();
  if (!reading) return {};
  const ContactView view = viewer_.options().view;
  const double x = (*viewer_.pointer() - view.left) / view.width;
  const double y = (reading->surface - view.bottom) / (view.top - view.bottom);
  return {std::clamp(x, 0.0, 1.0), std::clamp(y, 0.0, 1.0)};
}

/// Draws again and informs others. It must be called after every change of the view.
void ContactCanvas::changed() {
  if (const FrameFields fields = viewer_.fields(); fields != requestedFields_) {
    requestedFields_ = fields;
    emit fieldsChanged(fields);
  }
  refresh();
  emit viewChanged();
}

void ContactCanvas::zoom(double steps) {
  viewer_.zoom(zoomCentre(), steps);
  changed();
}

void ContactCanvas::exaggerate(double steps) {
  viewer_.exaggerate(zoomCentre(), steps);
  changed();
}

void ContactCanvas::fit() {
  viewer_.fit();
  changed();
}

void ContactCanvas::fitHeights() {
  viewer_.fitHeights();
  changed();
}

void ContactCanvas::follow(bool follows) {
  viewer_.follow(follows);
  changed();
}

void ContactCanvas::magnify(bool magnifies) {
  viewer_.magnify(magnifies);
  changed();
}

void ContactCanvas::setOverlay(ContactOverlay overlay) {
  viewer_.setOverlay(overlay);
  changed();
}

void ContactCanvas::setNavigation(const ViewNavigation& navigation) {
  viewer_.setNavigation(navigation);
  changed();
}

void ContactCanvas::showCrosshair(const QPointF& position) {
  viewer_.pointAt(viewPositionAt(position));
  changed();
}

void ContactCanvas::hideCrosshair() {
  viewer_.pointAt(std::nullopt);
  changed();
}

/// Moves the crosshair. The reading is the accessible description, because the picture itself has
/// no text for screen readers.
void ContactCanvas::movePointer(int elements) {
  viewer_.movePointer(elements);
  QStringList words;
  if (const auto reading = viewer_.reading())
    for (const ProbeLine& line : probeLines(*reading))
      words += QString::fromStdString(line.label + " " + line.value);
  setAccessibleDescription(words.join(QStringLiteral(", ")));
  changed();
}

void ContactCanvas::wheelEvent(QWheelEvent* event) {
  const auto position = viewPositionAt(event->position());
  if (!position) return event->ignore();
  event->accept();
  const QPointF turned = QPointF(event->angleDelta()) / QWheelEvent::DefaultDeltasPerStep;
  // Some systems turn the wheel sideways themselves while a modifier is held.
  const double steps = turned.y() != 0 ? turned.y() : turned.x();
  if (event->modifiers() & Qt::ControlModifier)
    viewer_.exaggerate(*position, steps);
  else if ((event->modifiers() & Qt::ShiftModifier) || turned.y() == 0)
    viewer_.pan(kKeyPan * steps, 0);
  else
    viewer_.zoom(*position, steps);
  changed();
}

void ContactCanvas::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !viewPositionAt(event->position()))
    return event->ignore();
  startDrag(event->position());
}

void ContactCanvas::mouseMoveEvent(QMouseEvent* event) {
  if (isPinching_) return;  // Qt sends the first finger as a cursor, too
  if (dragged_) return continueDrag(event->position());
  showHandle(handleUnder(event->position()));
  showCrosshair(event->position());
}

void ContactCanvas::mouseReleaseEvent(QMouseEvent* event) {
  endDrag();
  showHandle(handleUnder(event->position()));
}

// ---- Drags that change the scene

/// Returns what a drag from here would change.
ContactHandle ContactCanvas::handleUnder(const QPointF& position) const {
  if (!scene_ || !viewer_.frame()) return ContactHandle::None;
  const PictureRequest shown = request();
  return contactHandleAt(*shown.frame, sizedOptions(shown), position * shown.scale, scene_);
}

/// Gives the cursor the shape of what a drag would do.
void ContactCanvas::showHandle(ContactHandle handle) {
  if (handle == ContactHandle::None)
    unsetCursor();
  else
    setCursor(handle == ContactHandle::Velocity ? Qt::SizeHorCursor : Qt::SizeVerCursor);
}

void ContactCanvas::startDrag(const QPointF& position) {
  dragged_ = position;
  // The hint is for somebody who has not begun, and the status line has the result of the drag.
  if (std::exchange(hasHint_, false)) emit statusMessage({});
  const ContactHandle handle = handleUnder(position);
  if (handle == ContactHandle::None) return setCursor(Qt::ClosedHandCursor);
  const ContactView view = viewer_.options().view;
  grip_ = Grip{handle, position, *scene_, view.top - view.bottom, handle != ContactHandle::Body};
}

void ContactCanvas::continueDrag(const QPointF& position) {
  const QRectF plot = plotArea();
  if (grip_ && !grip_->isDecided) {
    const QPointF moved = position - grip_->from;
    if (moved.manhattanLength() < kDragThreshold) return;
    grip_->isDecided = true;
    if (std::abs(moved.x()) > std::abs(moved.y())) {
      grip_.reset();
      setCursor(Qt::ClosedHandCursor);
    }
  }
  if (!grip_) {
    const QPointF moved = position - *dragged_;
    dragged_ = position;
    viewer_.pan(moved.x() / plot.width(), -moved.y() / plot.height());
    return showCrosshair(position);
  }
  dragged_ = position;
  if (viewer_.pointer()) hideCrosshair();  // its readout would hide what moves
  const QPointF moved = position - grip_->from;
  const Scene after =
      asperity::dragged(grip_->scene, grip_->handle,
                        {moved.x() / plot.width(), moved.y() / plot.height(), grip_->height});
  emit sceneEdited(after);
  QToolTip::showText(mapToGlobal(position.toPoint()) + QPoint(14, 10),
                     draggedText(grip_->handle, after), this);
}

void ContactCanvas::endDrag() {
  if (grip_ && grip_->isDecided) QToolTip::hideText();
  grip_.reset();
  dragged_.reset();
  unsetCursor();
}

void ContactCanvas::nudge(ContactHandle handle, double steps) {
  if (!scene_ || !viewer_.frame()) return;
  const ContactView view = viewer_.options().view;
  const double part = kNudge * steps;
  const Scene after = asperity::dragged(*scene_, handle, {part, part, view.top - view.bottom});
  if (after == *scene_) return;
  setAccessibleDescription(draggedText(handle, after));
  emit sceneEdited(after);
}

void ContactCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) fit();
}

void ContactCanvas::leaveEvent(QEvent* event) {
  QWidget::leaveEvent(event);
  if (!dragged_) hideCrosshair();
}

void ContactCanvas::keyPressEvent(QKeyEvent* event) {
  const bool isInX = event->key() == Qt::Key_Left || event->key() == Qt::Key_Right;
  const bool isInY = event->key() == Qt::Key_Up || event->key() == Qt::Key_Down;
  const int sign = event->key() == Qt::Key_Right || event->key() == Qt::Key_Up ? 1 : -1;
  const bool control = event->modifiers() & Qt::ControlModifier;
  const bool shift = event->modifiers() & Qt::ShiftModifier;
  if (event->key() == Qt::Key_Escape && grip_) {
    const Scene before = grip_->scene;
    endDrag();
    emit sceneEdited(before);
  } else if (event->key() == Qt::Key_Escape && viewer_.pointer()) {
    hideCrosshair();
  } else if (isInX && control) {
    movePointer(sign * (shift ? kManyElements : 1));
  } else if (isInY && shift) {
    exaggerate(sign);
  } else if (isInX || isInY) {
    viewer_.pan(isInX ? -kKeyPan * sign : 0, isInY ? -kKeyPan * sign : 0);
    changed();
  } else {
    QWidget::keyPressEvent(event);
  }
}

ContactTip ContactCanvas::tipAt(const QPointF& position) const {
  if (!viewer_.frame()) return {};
  const PictureRequest shown = request();
  ContactTip tip = contactTipAt(*shown.frame, sizedOptions(shown), position * shown.scale, scene_);
  tip.explained = {tip.explained.topLeft() / shown.scale, tip.explained.size() / shown.scale};
  return tip;
}

/// Returns where to show a tip so that it does not cover what it explains: below a line of text; to
/// the right of a vertical axis and its numbers, in the plot.
QPoint ContactCanvas::tipPlace(const QRectF& explained, const QPoint& pointer) const {
  constexpr double kBelow = 16;  // pixels from a place to its tip, at least; from QTipLabel
  if (explained.height() > explained.width())
    return {static_cast<int>(std::max(explained.right(), plotArea().left())), pointer.y()};
  return {pointer.x(),
          std::max(pointer.y(), static_cast<int>(std::ceil(explained.bottom() - kBelow)))};
}

/// Shows one box at a time. Over the body the readout stays and the hint goes to the status line;
/// a tooltip hides the readout until the pointer moves on, which hides the tooltip.
void ContactCanvas::explain(const QPoint& position) {
  constexpr int kReach = 4;  // pixels
  const auto [html, anchor, explained] = tipAt(position);
  if (viewer_.pointer() && anchor.isEmpty() && handleUnder(position) == ContactHandle::Body) {
    QToolTip::hideText();
    emit statusMessage(dragHint(ContactHandle::Body, *scene_));
    hasHint_ = true;
    return;
  }
  if (!html.isEmpty() && viewer_.pointer()) hideCrosshair();
  const QRect around(position - QPoint(kReach, kReach), QSize(2 * kReach, 2 * kReach));
  const QPoint place = explained.isEmpty() ? position : tipPlace(explained, position);
  QToolTip::showText(mapToGlobal(place), html, this, around);  // an empty one hides it
}

void ContactCanvas::readAbout() {
  emit guideRequested(guideAnchor_.isEmpty() ? QStringLiteral("foundation") : guideAnchor_);
}

void ContactCanvas::pinch(const QPointF& position, double factor) {
  viewer_.zoom(viewPositionAt(position).value_or(ViewPosition{}), zoomSteps(factor));
  changed();
}

bool ContactCanvas::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    explain(static_cast<QHelpEvent*>(event)->pos());
    return true;
  }
  // The menu, which Qt shows, has an entry that leads to what is under the pointer.
  if (event->type() == QEvent::ContextMenu)
    guideAnchor_ = tipAt(static_cast<QContextMenuEvent*>(event)->pos()).guideAnchor;
  if (event->type() == QEvent::NativeGesture) {
    auto* native = static_cast<QNativeGestureEvent*>(event);
    if (native->gestureType() == Qt::ZoomNativeGesture) {
      pinch(native->position(), 1 + native->value());
      return true;
    }
  } else if (event->type() == QEvent::Gesture) {
    auto* gestures = static_cast<QGestureEvent*>(event);
    if (auto* gesture = static_cast<QPinchGesture*>(gestures->gesture(Qt::PinchGesture))) {
      isPinching_ =
          gesture->state() == Qt::GestureStarted || gesture->state() == Qt::GestureUpdated;
      endDrag();
      if (gesture->changeFlags() & QPinchGesture::ScaleFactorChanged)
        pinch(mapFromGlobal(gesture->centerPoint()), gesture->scaleFactor());
      gestures->accept(gesture);
      return true;
    }
  }
  return QWidget::event(event);
}

}  // namespace asperity
