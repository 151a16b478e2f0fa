#include "core/run/simulation.h"

#include <algorithm>
#include <cmath>

#include "core/contact/steady_sliding.h"
#include "core/contact/steady_solver.h"
#include "core/run/rigid_line.h"
#include "core/run/steady_frames.h"
#include "core/scene/plan.h"

namespace asperity {
namespace {

// In the time march a contact spot is a whole number of elements long, at least one. Measured
// against the steady pass on rough lines at 1e-6 to 10 N and 0.01 to 1000 m/s: the friction of
// contacts four elements long is off by 5 %, of two by up to a third, of one by any factor. Waves
// as short as two elements, which a rough line has without points between its elements, cost up to
// 17 % in long contacts, too.
constexpr double kMinElements = 3.5;
constexpr double kContactsKept =
    0.99;  // previous weight in the next step, so that contact borders do not flicker

// Limits of a single step: this many times the element-steps of a frame, and for a motion at most
// this part of its duration.
constexpr double kBudgetByHand = 10, kMotionByHand = 0.005;

}  // namespace

void Settling::begin(double latestEnd) {
  latestEnd_ = latestEnd;
  first_ = 0;
  framesNoNearer_ = 0;
}

void Settling::take(double distance) {
  if (first_ == 0) first_ = smallest_ = distance;
  // With a slow arm the state creeps closer by more than rounding.
  const bool isNearer = std::abs(distance) < (1 - 1e-9) * std::abs(smallest_);
  if (isNearer) smallest_ = distance;
  framesNoNearer_ = isNearer ? 0 : framesNoNearer_ + 1;
  if (isNear(distance)) end();
}

bool Settling::isNear(double distance) const {
  constexpr double kSettled = 0.02;  // in indentation and normal force
  constexpr int kFramesOfRipple = 60;
  return std::abs(distance) <= kSettled || distance * first_ < 0 ||
         framesNoNearer_ > kFramesOfRipple;
}

namespace {

/// Returns the contact of the elements as they are drawn, without their friction.
ContactState pressedIn(const Frame& frame) {
  const auto touching = std::ranges::count_if(frame.pressure, [](double load) { return load > 0; });
  return {.normalForce = normalForce(frame.pressure, frame.spacing),
          .contactFraction =
              static_cast<double>(touching) / static_cast<double>(frame.pressure.size())};
}

/// Returns the local friction in this contact of the frame.
double frictionOfInterface(const Frame& frame, const ContactState& contact) {
  return localFriction(interfaceAt(*frame.scene, frame.velocity), contact.normalForce,
                       contact.contactFraction * frame.length);
}

std::shared_ptr<const RigidLine> rigidOf(const Scene& scene, const Scene* last,
                                         const std::shared_ptr<const RigidLine>& known) {
  const bool same = last && last->surface == scene.surface && last->accuracy == scene.accuracy &&
                    last->folder == scene.folder &&
                    static_cast<std::int64_t>(known->line->nodes()) ==
                        known->elements * pointsPerElement(scene, known->size());
  return same ? known : std::make_shared<RigidLine>(scene);
}

/// Returns whether two scenes of the same line slide in the same way: texts, sweep, realizations
/// and comparisons may differ.
bool haveSameSliding(const Scene& a, const Scene& b) {
  return a.elastomer == b.elastomer && a.load == b.load && a.sliding == b.sliding &&
         a.interface == b.interface;
}

}  // namespace

struct Simulation::Ready {
  Ready(std::shared_ptr<const Scene> wanted, std::uint64_t itsNumber, const Ready* last)
      : scene(std::move(wanted)),
        number(itsNumber),
        rigid(rigidOf(*scene, last ? last->scene.get() : nullptr, last ? last->rigid : nullptr)),
        isSteady(scene->sliding.kind == SlidingKind::Steady) {
    if (!isSteady) {
      transient.emplace(*scene, rigid);  // throws if it cannot run
      transient->estimateErrors(*scene);
      return;
    }
    sliding.emplace(*scene);
    steady = sliding->at(rigid->prepared, scene->sliding.velocity);
    requireBalance(steady.result, velocity());
    if (!std::isfinite(steady.result.mu)) throw balanceError(steady.result, velocity());
    const SteadyShape shape = sliding->shape(rigid->prepared, velocity(), steady);
    greatestPressure = asperity::greatestPressure(shape, line().spacing, steady.result.normalForce);
  }

  const Line& line() const { return *rigid->line; }
  double velocity() const { return scene->sliding.velocity; }

  std::shared_ptr<const Scene> scene;
  std::uint64_t number;
  std::shared_ptr<const RigidLine> rigid;
  bool isSteady;
  std::optional<SteadySolver> sliding;  // with `steady`, in steady sliding
  SteadyState steady;
  double greatestPressure = 0;         // N/m, in the steady state, as in Frame
  std::optional<Transient> transient;  // of other motions, at their beginning
};

Simulation::Simulation(std::shared_ptr<const Scene> scene, std::uint64_t number,
                       double stepsPerFrame)
    : ready_(std::make_shared<Ready>(std::move(scene), number, nullptr)),
      stepsPerFrame_(stepsPerFrame) {
  reset();
}

void Simulation::update(std::shared_ptr<const Scene> scene, std::uint64_t number, Shape shape) {
  const auto next = std::make_shared<Ready>(std::move(scene), number, ready_.get());
  const bool goesOn = next->isSteady && ready_->isSteady &&
                      next->line().nodes() == ready_->line().nodes() &&
                      next->line().length == ready_->line().length;
  const bool isSameLine = next->rigid == ready_->rigid;
  const bool hasThatShape = shape == Shape::Present || !next->isSteady || showsSteadyState();
  const bool isSamePicture =
      isSameLine && hasThatShape && haveSameSliding(*next->scene, *ready_->scene);
  // A march continues with the visible state.
  if (!isSamePicture && goesOn && showsSteadyState()) settle(march_->distance());
  ready_ = next;
  still_.reset();
  if (isSamePicture) return;
  if (!goesOn) return reset();
  if (shape == Shape::Steady) return settle(march_->distance());
  TimeMarch march(ready_->rigid->line, ready_->rigid->prepared.lowestHeight,
                  ready_->sliding->law());
  march.continueFrom(*march_);
  march_ = std::move(march);
  settling_.begin(time_ + settlingTime());
  isChanged_ = true;
  recordFields();
  // Another line may penetrate the present shape, or be above it: the load presses it in before it
  // is shown.
  if (!isSameLine) {
    const double velocity = ready_->velocity();
    march_->step(marchLoad(ready_->scene->load, ready_->line().length),
                 velocity > 0 ? stepDistance() / velocity : restTimeStep(), 0);
  }
  clearReading();
}

void Simulation::reset() {
  steps_ = 0;
  time_ = 0;
  if (ready_->isSteady)
    settle(0);
  else
    begin();
}

void Simulation::settle(double distance) {
  still_.reset();
  motion_.reset();
  // At rest the elements' own balance holds: from that of the line between them they would creep to
  // it.
  march_ = ready_->velocity() > 0 ? steadyMarch(*ready_->rigid, *ready_->sliding,
                                                ready_->velocity(), ready_->steady, distance)
                                  : restingMarch(*ready_->rigid, *ready_->scene, distance);
  timeScale_ = touching_ = contactSpots_ = 0;
  settling_.end();
  isChanged_ = false;
  recordFields();
  clearReading();
}

void Simulation::begin() {
  still_.reset();
  march_.reset();
  motion_.emplace(*ready_->transient);
  timeScale_ = 0;
  recordFields();
  clearReading();
}

void Simulation::requestFields(const FrameFields& fields) {
  fields_ = fields;
  still_.reset();
  recordFields();
}

/// Starts the records; in steady sliding the time before is known, too.
void Simulation::recordFields() {
  const MarchRecords records{fields_.sinceContact, fields_.power};
  if (motion_)
    motion_->record(records);
  else
    startRecords(*march_, records, ready_->velocity());
}

void Simulation::addFields(Frame& frame) const {
  if (fields_.lineSlope) frame.lineSlope = march().lineSlope();
  frame.sinceContact = march().sinceContact();
  frame.power = march().power();
  addLocalFriction(frame.power, frame.pressure, interfaceAt(*ready_->scene, frame.velocity),
                   frame.velocity);
}

void Simulation::clearReading() {
  lineWork_ = normalWork_ = 0;
  resolves_ = false;
}

/// Returns the distance (m) that the line moves in a step: one node, or less where that resolves
/// the relaxation.
double Simulation::stepDistance() const {
  const RetardationModes& modes = march_->modes();
  const double spacing = ready_->line().spacing;
  if (modes.modes() == 0) return spacing;
  const double relaxationLength = ready_->velocity() / modes.rate.back();
  // An element without a dashpot of its own follows at once everything faster than a step.
  if (modes.glassyCompliance > 0) return spacing;
  return std::clamp(relaxationLength / 2, spacing / 8, spacing);
}

/// Returns the time step (s) where nothing slides: a part of the middle relaxation time.
double Simulation::restTimeStep() const {
  const RetardationModes& modes = march_->modes();
  const double relaxation = modes.modes() == 0 ? 0 : 1 / modes.rate[modes.modes() / 2];
  return std::max(relaxation, 1e-6) / 30;
}

void Simulation::stepOnce(double dt, double distance) {
  const MarchStep step =
      march_->step(marchLoad(ready_->scene->load, ready_->line().length), dt, distance);
  lineWork_ += step.lineWork;
  normalWork_ += step.normalForce * distance;
  const RetardationModes& modes = march_->modes();
  const double shortestLength = modes.modes() == 0 ? 0 : ready_->velocity() / modes.rate.back();
  const bool instant = modes.glassyCompliance > 0 && modes.modes() > 0;
  resolves_ = distance > 0 && (instant || distance <= 2 * shortestLength);
  time_ += dt;
  ++steps_;
  isChanged_ = false;
  touching_ = kContactsKept * touching_ + step.contactLength / ready_->line().spacing;
  contactSpots_ = kContactsKept * contactSpots_ + static_cast<double>(step.contacts);
}

bool Simulation::resolvesContacts() const {
  const RigidLine& rigid = *ready_->rigid;
  if (isRough(ready_->scene->surface) &&
      static_cast<std::int64_t>(rigid.line->nodes()) < 2 * rigid.elements)
    return false;
  return touching_ >= kMinElements * contactSpots_;
}

void Simulation::advance(double part, double wallSeconds) {
  if (motion_ && awaitsStep(part, wallSeconds)) return;
  clearReading();
  const double before = time_;
  if (motion_) return advanceMotion(part, wallSeconds, motion_->motion().duration());
  advanceSteadily(part);
  timeScale_ = std::max(time_ - before, 0.0) / wallSeconds;
}

double Simulation::mostSteps() const {
  return std::max(1.0, std::floor(stepsPerFrame_ / static_cast<double>(ready_->line().nodes())));
}

void Simulation::advanceSteadily(double part) {
  const double velocity = ready_->velocity();
  if (velocity > 0) {
    const double most = mostSteps();
    const double wanted = part * ready_->line().length;
    const double finest = std::ceil(wanted / stepDistance());
    // Where the budget is the limit, steps grow up to one node; only then the line slows down.
    const double steps = std::min(finest, most);
    const double distance = std::min(wanted / steps, ready_->line().spacing);
    for (double i = 0; i < steps; ++i) stepOnce(distance / velocity, distance);
  } else {
    stepOnce(restTimeStep(), 0);
  }
  settling_.take(awayFromSteady());
}

bool Simulation::beginsAnew() {
  if (!motion_->transient().isOver()) return false;
  begin();
  steps_ = 0;
  time_ = 0;
  return true;
}

void Simulation::marchMotion(double time) {
  motion_->marchTo(time);
  takeTime();
}

/// Takes time and steps from the motion.
void Simulation::takeTime() {
  time_ = motion_->transient().time();
  steps_ = motion_->transient().steps();
}

/// Advances a motion, which begins again after its end. Frames have equal distances in time through
/// the whole motion, which are limited by its fastest part, so fast parts appear fast.
void Simulation::advanceMotion(double part, double wallSeconds, double end) {
  if (beginsAnew()) return;
  const double interval = std::min(part * motion_->motion().duration(),
                                   mostSteps() * motion_->transient().shortestStep());
  const double next = (std::round(time_ / interval) + 1) * interval;
  marchMotion(std::min(next, end));
  timeScale_ = interval / wallSeconds;
  motion_->keepState();
}

/// Returns whether the next step of a motion is not yet due: at a slow pace a step lasts several
/// frames, which show the same moment.
bool Simulation::awaitsStep(double part, double wallSeconds) {
  const double step = motion_->transient().nextStep();
  const double interval = part * motion_->motion().duration();
  if (interval >= step) {
    towardsStep_ = 0;
    return false;
  }
  towardsStep_ += interval;
  timeScale_ = interval / wallSeconds;
  if (towardsStep_ < step) return true;
  towardsStep_ -= step;
  return false;
}

/// Goes to the nearest known state at or before a time.
void Simulation::goTo(double time) {
  if (!motion_->goTo(time, *ready_->transient)) return;
  takeTime();
  recordFields();  // what is wanted may have changed since
  clearReading();
}

bool Simulation::seek(double time, double part, double wallSeconds) {
  if (!motion_) return true;
  const double end = std::clamp(time, 0.0, motion_->motion().duration());
  goTo(end);
  if (!motion_->transient().canReach(end)) return true;
  clearReading();
  advanceMotion(part, wallSeconds, end);
  return !motion_->transient().canReach(end);
}

void Simulation::advanceTo(double time, double part, double wallSeconds) {
  while (motion_ && motion_->transient().canReach(time)) {
    clearReading();
    advanceMotion(part, wallSeconds, time);
  }
}

void Simulation::singleStep(double part) {
  clearReading();
  const double velocity = ready_->velocity();
  const double distance = part * ready_->line().length;
  if (motion_) return stepMotion(distance);
  if (!(velocity > 0)) return stepOnce(restTimeStep(), 0);
  const double wanted = std::max(distance, stepDistance());
  const double steps =
      std::min(std::ceil(wanted / stepDistance() - 1e-9), kBudgetByHand * mostSteps());
  if (wanted > steps * ready_->line().spacing && !isSettling()) {
    const double timeScale = timeScale_;
    settle(march_->distance() + wanted);
    timeScale_ = timeScale;
    time_ += wanted / velocity;
    ++steps_;
    return;
  }
  const double each = std::min(wanted / steps, ready_->line().spacing);
  for (double i = 0; i < steps; ++i) stepOnce(each / velocity, each);
}

/// Advances a motion by the time in which the line covers this distance at its highest velocity.
void Simulation::stepMotion(double distance) {
  if (beginsAnew()) return;
  const Transient& transient = motion_->transient();
  const double duration = transient.motion().duration();
  const double fastest = transient.motion().fastest(0, duration);
  const double most =
      std::min(kMotionByHand * duration, kBudgetByHand * mostSteps() * transient.shortestStep());
  const double time = fastest > 0 ? std::min(distance / fastest, most) : most;
  marchMotion(transient.time() + time);
}

bool Simulation::showsSteadyState() const {
  return ready_->isSteady && ready_->velocity() > 0 && !isChanged_ && !isSettling();
}

/// Returns the steady state itself after settling, at the node nearest to the line: the march of
/// the same line has its own error, and the picture must not contradict its numbers.
Frame Simulation::steadyFrame() const {
  if (!still_)
    still_ = stillFrame(ready_->scene, *ready_->rigid, *ready_->sliding, ready_->steady,
                        ready_->steady.result, fields_);
  Frame frame = *still_;
  const double nodes = march_->distance() / frame.spacing;
  moveByPoints(frame, std::llround(std::fmod(nodes, static_cast<double>(ready_->line().nodes()))));
  return frame;
}

const Scene& Simulation::scene() const {
  return *ready_->scene;
}

double Simulation::spacing() const {
  return ready_->line().spacing;
}

Frame Simulation::frame() const {
  Frame frame = showsSteadyState() ? steadyFrame() : marchedFrame();
  frame.sceneNumber = ready_->number;
  frame.step = steps_;
  frame.time = time_;
  frame.distance = march().distance();
  frame.timeScale = timeScale_;
  if (motion_)
    addMotion(frame);
  else
    addSteady(frame);
  return frame;
}

Frame Simulation::marchedFrame() const {
  Frame frame;
  frame.scene = ready_->scene;
  frame.velocity = motion_ ? motion_->motion().velocityAt(time_) : ready_->velocity();
  // At its beginning the contact of a start is still the one at rest.
  if (motion_ && time_ == 0 && needsStage(*ready_->scene, Purpose::Picture, Stage::StartFromRest))
    frame.velocity = 0;
  frame.length = ready_->line().length;
  frame.elements = ready_->rigid->elements;
  frame.spacing = ready_->line().spacing;
  frame.pressure = march().pressure();
  for (const double depth : march().depth()) frame.surfaceHeight.push_back(-depth);
  for (const double height : march().heightAboveMinimum())
    frame.lineHeight.push_back(height - march().indentation());
  frame.rmsHeight = ready_->line().rmsHeight;
  frame.rmsSlope = ready_->line().rmsSlope;
  addFields(frame);
  return frame;
}

/// Sets all results to those of the steady state; the march adds its own friction.
void Simulation::addSteady(Frame& frame) const {
  frame.state = ready_->steady.result;
  if (resolves_ && resolvesContacts() && normalWork_ > 0) frame.muMarch = lineWork_ / normalWork_;
  if (frame.velocity == 0) frame.muMarch = 0;  // nothing is worked, also while the contact relaxes
  // On the way there, the points of the picture still bear the load.
  frame.steadyPressure =
      isSettling() && std::isnan(ready_->greatestPressure) ? 0 : ready_->greatestPressure;
  frame.isSettling = isSettling();
  if (frame.isSettling) frame.marched = marchedState(frame);
}

ContactState Simulation::marchedState(const Frame& frame) const {
  ContactState state = pressedIn(frame);
  state.indentation = march_->indentation();
  state.mu = frame.muMarch;
  state.tangentialForce = std::abs(state.mu) * state.normalForce;
  if (hasLocalFriction(*frame.scene)) state.muInterface = frictionOfInterface(frame, state);
  return state;
}

/// Returns the time (s) after which the initial state no longer matters: ten of the longest
/// relaxation times of an element, more where it was pressed far deeper, and at least one period of
/// sliding.
double Simulation::settlingTime() const {
  const RetardationModes& modes = march_->modes();
  const double deeper = march_->indentation() / ready_->steady.result.indentation;
  const double times = 10 + (deeper > 1 && std::isfinite(deeper) ? std::log(deeper) : 0);
  const double element = modes.modes() == 0 ? 0 : times / modes.rate.front();
  const double velocity = ready_->velocity();
  return element + (velocity > 0 ? ready_->line().length / velocity : 0);
}

/// Returns whether the picture is settling. At the end the steady state invisibly replaces the
/// march in the picture.
bool Simulation::isSettling() const {
  return settling_.isOn(time_) && !settling_.isNear(awayFromSteady());
}

/// Returns the distance to the steady state. Either indentation or normal force is held constant
/// and has its value at once: the distance is that of the other one, relative to its final value.
double Simulation::awayFromSteady() const {
  const SteadyResult& steady = ready_->steady.result;
  if (ready_->scene->load.kind != LoadKind::Indentation)
    return march_->indentation() / steady.indentation - 1;
  return normalForce(march_->pressure(), ready_->line().spacing) / steady.normalForce - 1;
}

void Simulation::addMotion(Frame& frame) const {
  const std::vector<TransientSample>& samples = motion_->samples();
  frame.nextStep = motion_->transient().nextStep();
  frame.transient = std::make_shared<const std::vector<TransientSample>>(samples);
  if (const auto& later = motion_->later(); !later.empty())
    frame.later = std::make_shared<const std::vector<TransientSample>>(later);
  ContactState& state = frame.state;
  if (samples.empty()) {  // the force is balanced from the beginning
    state = pressedIn(frame);
    // Without sliding there is no tangential force; a remainder is the error of the elements.
    state.tangentialForce = frame.velocity == 0 ? 0 : std::abs(march().slopeForce());
    if (state.normalForce > 0) state.mu = state.tangentialForce / state.normalForce;
    if (frame.velocity != 0) state.muInterface = frictionOfInterface(frame, state);
  } else {
    state = samples.back();
    state.tangentialForce = std::abs(state.tangentialForce);
    frame.muError = recentError(samples);
  }
  state.indentation = march().indentation();
}

}  // namespace asperity
