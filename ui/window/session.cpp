#include "ui/window/session.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace asperity {

namespace {

bool sameOrBothMissing(double a, double b) {
  return a == b || (!std::isfinite(a) && !std::isfinite(b));
}

/// Whether two frames put the diagram's marker at the same place.
bool sameMark(const Frame* before, const Frame& now) {
  return before && before->scene->sliding.velocity == now.scene->sliding.velocity &&
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
    : QObject(parent), runner_(options) {
  setScene(scene);
  runner_.play();
}

void Session::setScene(const Scene& scene) {
  scene_ = scene;
  const bool wasStale = friction_.isStale();
  friction_.expect(scene_);
  sceneNumber_ = runner_.post(scene_);
  if (wasStale != friction_.isStale()) emit plotChanged();
}

void Session::setPlaying(bool playing) {
  playing ? runner_.play() : runner_.pause();
  emit playingChanged(playing);
}

void Session::singleStep() {
  if (runner_.isPlaying()) setPlaying(false);
  runner_.singleStep();
}

void Session::reset() {
  runner_.reset();
}

void Session::poll() {
  takeMessages();
  takeCurves();
  takeFrame();
}

void Session::takeMessages() {
  for (const RunnerMessage& message : runner_.takeMessages()) {
    if (message.sceneNumber != sceneNumber_) continue;
    brokenNumber_ = sceneNumber_;
    emit complained(QString::fromStdString(message.key), QString::fromStdString(message.text));
  }
}

void Session::takeCurves() {
  bool changed = false;
  for (const CurveUpdate& update : runner_.takeCurveUpdates()) {
    if (!friction_.take(update)) continue;
    curve_ = update;
    changed = true;
  }
  if (changed) emit plotChanged();
}

void Session::takeFrame() {
  std::shared_ptr<const Frame> newest = runner_.newestFrame();
  if (!newest || newest == frame_) return;
  const bool marked = sameMark(frame_.get(), *newest);
  frame_ = std::move(newest);
  if (!marked) {
    friction_.mark(*frame_);
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
    emit complained({}, trouble);
  else if (brokenNumber_ != sceneNumber_)  // the curve may fail where the present velocity is fine
    emit sceneRuns();
}

}  // namespace asperity
