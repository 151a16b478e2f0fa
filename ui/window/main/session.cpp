#include "ui/window/main/session.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/scene/sweep.h"

namespace asperity {

namespace {

constexpr int kWaitingDelay = 200;  // ms, until waitingChanged() reports a missing first frame
constexpr int kIdleDelay = 1000;    // ms without a command or a frame, until the session is idle

bool sameOrBothMissing(double a, double b) {
  return a == b || (!std::isfinite(a) && !std::isfinite(b));
}

/// Returns whether two frames put the diagram's marker at the same position, with the same name.
bool haveSameMark(const Frame* before, const Frame& now) {
  return before && !before->transient && !now.transient && before->isSettling == now.isSettling &&
         before->scene->sliding.velocity == now.scene->sliding.velocity &&
         before->scene->sweep.key == now.scene->sweep.key &&
         ownSweptValue(*before->scene) == ownSweptValue(*now.scene) &&
         sameOrBothMissing(before->state.mu, now.state.mu);
}

/// Returns whether a frame is the one of this moment of its motion, s. A motion advances in steps,
/// so that a frame stands for all moments before its next one.
bool isAt(const Frame& frame, double moment) {
  constexpr double kRounding = 1e-9;
  const double end = frame.scene->sliding.duration;
  const double away = std::abs(std::clamp(moment, 0.0, end) - frame.time);
  return away <= frame.nextStep + kRounding * end;
}

template <class Values>
bool areFinite(const Values& values) {
  return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

}  // namespace

Message frameError(const Frame& frame) {
  const bool isFinite =
      areFinite(std::array{frame.length, frame.state.indentation, frame.state.normalForce,
                           frame.state.contactFraction}) &&
      areFinite(frame.lineHeight) && areFinite(frame.surfaceHeight) && areFinite(frame.pressure);
  if (!isFinite) return "The numbers of this scene exceed the range of a computer's numbers.";
  if (!std::isfinite(frame.state.mu) && !frame.transient)
    return "No steady sliding was found at this load and velocity.";
  return {};
}

Session::Session(const Scene& scene, RunnerOptions options, QObject* parent)
    : QObject(parent), scene_(scene), runner_(withCurveNotification(std::move(options))) {
  friction_.expect(scene_);
}

void Session::begin() {
  setScene(scene_);
  runner_.play();
}

/// Returns the options with a callback that takes a curve when it arrives, not at the next step of
/// the window's timer.
RunnerOptions Session::withCurveNotification(RunnerOptions options) {
  options.curveUpdated = [this] {
    if (hasCurveUpdate_.exchange(true)) return;
    QMetaObject::invokeMethod(
        this, [this] { takeCurves(); }, Qt::QueuedConnection);
  };
  return options;
}

void Session::editCurve(const std::function<void(FrictionChartModel&)>& edit) {
  const CurveQuantity before = friction_.quantity();
  edit(friction_);
  if (frame_ && friction_.quantity() != before) friction_.mark(*frame_);
  emit plotChanged();
}

void Session::setScene(const Scene& scene, Begin begin) {
  const bool sameCurve = sceneTime_.isValid() && haveSameCurve(scene, scene_);
  const bool sameSweep = scene.sweep == scene_.sweep;
  scene_ = scene;
  sceneTime_.start();
  if (!sameCurve) {
    curveTime_.start();
    isStopped_ = false;
  }
  const bool wasStale = friction_.isStale();
  friction_.expect(scene_);
  if (begin == Begin::Restart && !sameCurve) friction_.resetAxes();
  requestedMoment_.reset();
  sceneNumber_ = begin == Begin::Restart ? runner_.open(scene_) : runner_.post(scene_);
  if (begin == Begin::Restart) openedNumber_ = sceneNumber_;
  // Names of pinned curves contain their differences from the scene.
  if (wasStale != friction_.isStale() || !sameSweep || !friction_.pinned().empty())
    emit plotChanged();
  notifyCommandSent();
}

void Session::notifyCommandSent() {
  activityTime_.start();
  emit commandSent();
}

bool Session::isIdle() const {
  return !isPlaying() && averaging() != Averaging::Running &&
         (runningNumber_ == sceneNumber_ || brokenNumber_ == sceneNumber_) &&
         activityTime_.isValid() && activityTime_.elapsed() > kIdleDelay;
}

void Session::setPace(std::optional<double> secondsPerPeriod) {
  runner_.setPace(secondsPerPeriod);
}

void Session::seek(double time) {
  if (runner_.isPlaying()) setPlaying(false);
  runner_.seek(time);
  if (scene_.sliding.kind != SlidingKind::Steady) requestedMoment_ = time;
  notifyCommandSent();
}

void Session::requestFields(const FrameFields& fields) {
  runner_.requestFields(fields);
  notifyCommandSent();
}

void Session::setPlaying(bool playing) {
  if (playing)
    runner_.play();
  else
    runner_.pause();
  notifyCommandSent();
  emit playingChanged(playing);
}

void Session::singleStep(double part) {
  if (runner_.isPlaying()) setPlaying(false);
  requestedMoment_.reset();
  runner_.singleStep(part);
  notifyCommandSent();
}

void Session::setVisible(bool visible) {
  isVisible_ = visible;
  runner_.setVisible(visible);
}

void Session::reset() {
  requestedMoment_.reset();
  runner_.reset();
  notifyCommandSent();
}

Session::Averaging Session::averaging() const {
  const CurveUpdate* present = curve();
  if (present && present->isComplete) return Averaging::Done;
  return isStopped_ || brokenNumber_ == sceneNumber_ ? Averaging::Stopped : Averaging::Running;
}

void Session::stopCurve() {
  isStopped_ = true;
  runner_.stopCurve();
}

void Session::startCurve() {
  isStopped_ = false;
  curve_.reset();
  curveTime_.start();
  runner_.startCurve();
  notifyCommandSent();
}

bool Session::isWaiting() const {
  return runningNumber_ != sceneNumber_ && brokenNumber_ != sceneNumber_ &&
         sceneTime_.elapsed() > kWaitingDelay;
}

/// Measures the rate. The same curve may come again under another scene's number.
void Session::measureRate(const CurveUpdate& update) {
  const bool isNew = !curve() || update.realizationsDone > curve_->realizationsDone;
  if (!isNew || curveTime_.nsecsElapsed() == 0) return;
  rate_ = 1e9 * static_cast<double>(update.realizationsDone) *
          static_cast<double>(update.points.size()) /
          static_cast<double>(curveTime_.nsecsElapsed());
}

void Session::poll() {
  takeMessages();
  takeCurves();
  takeFrame();
  updateWaiting();
}

/// Fades the marker of the chart while it belongs to the previous scene.
void Session::updateWaiting() {
  const bool waits = isWaiting();
  if (friction_.fadeMark(waits || isRefused())) emit markChanged();
  if (std::exchange(wasWaiting_, waits) == waits) return;
  emit waitingChanged(waits);
}

void Session::takeMessages() {
  for (const RunnerMessage& message : runner_.takeMessages()) {
    requestedMoment_.reset();  // a failure ends the way to it
    if (message.sceneNumber != sceneNumber_) continue;
    brokenNumber_ = sceneNumber_;
    if (taken_ && taken_->sceneNumber < openedNumber_) loseFrame();
    emit errorOccurred(QString::fromStdString(message.key), message.text);
  }
}

void Session::takeCurves() {
  hasCurveUpdate_ = false;
  bool changed = false;
  for (const CurveUpdate& update : runner_.takeCurveUpdates()) {
    if (!friction_.take(update)) continue;
    measureRate(update);
    curve_ = update;
    changed = true;
  }
  if (changed) emit plotChanged();
  const bool isSound = runningNumber_ == sceneNumber_ && frameError_.empty();
  if (brokenNumber_ == sceneNumber_ && isSound && changed && curve_->isComplete) {
    brokenNumber_ = 0;  // the curve was computed again without an error
    emit sceneRuns();
  }
}

void Session::takeFrame() {
  std::shared_ptr<const Frame> newest = runner_.newestFrame();
  if (!newest || newest == taken_) return;
  // The runner goes on with the scene before one that cannot be computed.
  if (!frame_ && newest->sceneNumber < openedNumber_) return;
  activityTime_.start();
  taken_ = std::move(newest);
  if (draw_)
    draw_(taken_);
  else
    show(taken_);
}

void Session::show(std::shared_ptr<const Frame> frame) {
  const bool marked = haveSameMark(frame_.get(), *frame);
  frame_ = std::move(frame);
  if (requestedMoment_ && frame_->sceneNumber == sceneNumber_ && isAt(*frame_, *requestedMoment_))
    requestedMoment_.reset();
  if (!marked) {
    if (friction_.mark(*frame_))
      emit markChanged();
    else
      emit axesChanged();
  }
  emit frameArrived();
  if (frame_->sceneNumber == sceneNumber_) checkFrame();
}

/// Forgets the frame of an unrelated scene, also one whose picture is not ready yet.
void Session::loseFrame() {
  taken_.reset();
  frame_.reset();
  friction_.unmark();
  emit markChanged();
  emit frameLost();
}

void Session::checkFrame() {
  const Message error = frameError(*frame_);
  const bool isNew = runningNumber_ != sceneNumber_ || error != frameError_;
  runningNumber_ = sceneNumber_;
  frameError_ = error;
  if (!isNew) return;
  if (!error.empty())
    emit errorOccurred({}, error);
  else if (brokenNumber_ != sceneNumber_)  // the curve may fail where the present velocity is fine
    emit sceneRuns();
}

}  // namespace asperity
