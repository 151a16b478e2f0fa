#include "ui/window/main/session.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "core/scene/sweep.h"

namespace asperity {

namespace {

constexpr int kSilentWait = 200;  // ms, until the window says that it waits
constexpr int kCalm = 1000;       // ms without an order or a frame, until the session rests

bool sameOrBothMissing(double a, double b) {
  return a == b || (!std::isfinite(a) && !std::isfinite(b));
}

/// Returns whether two frames put the diagram's marker at the same place.
bool sameMark(const Frame* before, const Frame& now) {
  return before && !before->transient && !now.transient &&
         before->scene->sliding.velocity == now.scene->sliding.velocity &&
         before->scene->sweep.key == now.scene->sweep.key &&
         ownSweptValue(*before->scene) == ownSweptValue(*now.scene) &&
         sameOrBothMissing(before->muSteady, now.muSteady);
}

bool areFinite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

}  // namespace

QString troubleOf(const Frame& frame) {
  const bool finite =
      std::ranges::all_of(std::initializer_list<double>{frame.length, frame.indentation,
                                                        frame.normalForce, frame.contactFraction},
                          [](double v) { return std::isfinite(v); }) &&
      areFinite(frame.lineHeight) && areFinite(frame.surfaceHeight) && areFinite(frame.pressure);
  if (!finite) return Session::tr("The numbers of this scene leave what a computer can hold.");
  if (!std::isfinite(frame.muSteady) && !frame.transient)
    return Session::tr("No steady sliding was found at this load and velocity.");
  return {};
}

Session::Session(const Scene& scene, RunnerOptions options, QObject* parent)
    : QObject(parent), scene_(scene), runner_(withNews(std::move(options))) {
  friction_.expect(scene_);
}

void Session::begin() {
  setScene(scene_);
  runner_.play();
}

/// Returns options that take a curve when it arrives, not at the next step of the window's timer.
RunnerOptions Session::withNews(RunnerOptions options) {
  options.curveUpdated = [this] {
    if (hasNews_.exchange(true)) return;
    QMetaObject::invokeMethod(
        this, [this] { takeCurves(); }, Qt::QueuedConnection);
  };
  return options;
}

void Session::editCurve(const std::function<void(FrictionChartModel&)>& edit) {
  edit(friction_);
  emit plotChanged();
}

void Session::setScene(const Scene& scene, Begin begin) {
  const bool sameCurve = sceneTime_.isValid() && haveSameCurve(scene, scene_);
  scene_ = scene;
  sceneTime_.start();
  if (!sameCurve) {
    curveTime_.start();
    isStopped_ = false;
  }
  const bool wasStale = friction_.isStale();
  friction_.expect(scene_);
  if (begin == Begin::Opened && !sameCurve) friction_.beginAxesAnew();
  sceneNumber_ = begin == Begin::Opened ? runner_.open(scene_) : runner_.post(scene_);
  // Names of pinned curves contain their differences from the scene.
  if (wasStale != friction_.isStale() || !friction_.pinned().empty()) emit plotChanged();
  stir();
}

void Session::stir() {
  stirTime_.start();
  emit stirred();
}

bool Session::isResting() const {
  return !isPlaying() && averaging() != Averaging::Running &&
         (runningNumber_ == sceneNumber_ || brokenNumber_ == sceneNumber_) && stirTime_.isValid() &&
         stirTime_.elapsed() > kCalm;
}

void Session::setPace(double secondsPerPeriod) {
  runner_.setPace(secondsPerPeriod);
}

void Session::seek(double time) {
  if (runner_.isPlaying()) setPlaying(false);
  runner_.seek(time);
  stir();
}

void Session::wantFields(const FrameFields& fields) {
  runner_.requestFields(fields);
  stir();
}

void Session::setPlaying(bool playing) {
  playing ? runner_.play() : runner_.pause();
  stir();
  emit playingChanged(playing);
}

void Session::singleStep(double part) {
  if (runner_.isPlaying()) setPlaying(false);
  runner_.singleStep(part);
  stir();
}

void Session::setSeen(bool seen) {
  isSeen_ = seen;
  runner_.setVisible(seen);
}

void Session::reset() {
  runner_.reset();
  stir();
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
  stir();
}

bool Session::isWaiting() const {
  return runningNumber_ != sceneNumber_ && brokenNumber_ != sceneNumber_ &&
         sceneTime_.elapsed() > kSilentWait;
}

/// Measures the rate. The same curve may come again under another scene's number.
void Session::measureRate(const CurveUpdate& update) {
  const bool isNews = !curve() || update.realizationsDone > curve_->realizationsDone;
  if (!isNews || curveTime_.nsecsElapsed() == 0) return;
  rate_ = 1e9 * static_cast<double>(update.realizationsDone) *
          static_cast<double>(update.points.size()) /
          static_cast<double>(curveTime_.nsecsElapsed());
}

void Session::poll() {
  takeMessages();
  takeCurves();
  takeFrame();
  tellWaiting();
}

/// Fades the marker of the chart while it still belongs to the previous scene.
void Session::tellWaiting() {
  const bool waits = isWaiting();
  if (std::exchange(wasWaiting_, waits) == waits) return;
  friction_.fadeMark(waits);
  emit markChanged();
  emit waitingChanged(waits);
}

void Session::takeMessages() {
  for (const RunnerMessage& message : runner_.takeMessages()) {
    if (message.sceneNumber != sceneNumber_) continue;
    brokenNumber_ = sceneNumber_;
    emit complained(QString::fromStdString(message.key), message.text);
  }
}

void Session::takeCurves() {
  hasNews_ = false;
  bool changed = false;
  for (const CurveUpdate& update : runner_.takeCurveUpdates()) {
    if (!friction_.take(update)) continue;
    measureRate(update);
    curve_ = update;
    changed = true;
  }
  if (changed) emit plotChanged();
  const bool isSound = runningNumber_ == sceneNumber_ && trouble_.isEmpty();
  if (brokenNumber_ == sceneNumber_ && isSound && changed && curve_->isComplete) {
    brokenNumber_ = 0;  // the curve was computed again without an error
    emit sceneRuns();
  }
}

void Session::takeFrame() {
  std::shared_ptr<const Frame> newest = runner_.newestFrame();
  if (!newest || newest == frame_) return;
  stirTime_.start();
  const bool marked = sameMark(frame_.get(), *newest);
  frame_ = std::move(newest);
  if (!marked) {
    if (friction_.mark(*frame_))
      emit markChanged();
    else
      emit plotChanged();
  }
  emit frameArrived();
  if (frame_->sceneNumber == sceneNumber_) judgeFrame();
}

void Session::judgeFrame() {
  const QString trouble = troubleOf(*frame_);
  const bool isNews = runningNumber_ != sceneNumber_ || trouble != trouble_;
  runningNumber_ = sceneNumber_;
  trouble_ = trouble;
  if (!isNews) return;
  if (!trouble.isEmpty())
    emit complained({}, Message::name(trouble.toStdString()));
  else if (brokenNumber_ != sceneNumber_)  // the curve may fail where the present velocity is fine
    emit sceneRuns();
}

}  // namespace asperity
