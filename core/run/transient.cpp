#include "core/run/transient.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "core/contact/steady_sliding.h"
#include "core/material/temperature_shift.h"
#include "core/scene/plan.h"
#include "core/scene/scene_check.h"

namespace asperity {

namespace {

constexpr double kRounding = 1e-9;  // of a step
constexpr double kOrder = 1.8;  // order of friction in the spacing, as measured at 1 to 16 points
constexpr std::size_t kMinNodes = 8;
/// Factors from the differences to the error that is not exceeded in 95 of 100 random scenes: with
/// lines of two coarser spacings, and with one line.
constexpr double kFactorOfTwo = 1.9, kFactorOfOne = 1.6;
constexpr std::size_t kRecent = 16;  // samples

TimeMarch beginning(const Scene& scene, const RigidLine& rigid) {
  checkEffects(scene);
  if (needsStage(scene, Purpose::Picture, Stage::StartFromRest)) {
    countStage(Stage::StartFromRest);
    return restingMarch(rigid, scene);
  }
  const SteadySolver sliding(scene);
  const SteadyState state = sliding.at(rigid.prepared, scene.sliding.velocity);
  requireBalance(state.result, scene.sliding.velocity);
  return steadyMarch(rigid, sliding, scene.sliding.velocity, state);
}

/// Returns the relaxation time of Kelvin elements, s; NaN for elements with another law.
double relaxationOf(const ElementLaw& law) {
  return law.kind() == ElementKind::Kelvin ? law.relaxationTime : kNotApplicable;
}

}  // namespace

/// Sums over several steps.
class Transient::Means {
 public:
  void add(const MarchStep& step, double dt, double distance) {
    time_ += dt;
    distance_ += distance;
    tangential_ += step.slopeForce * dt;
    force_ += step.normalForce * dt;
    dissipated_ += step.dissipated + step.gapWork;
    contact_ += step.contactLength * dt;
    contactSpots_ += static_cast<double>(step.contacts) * dt;
  }

  TransientSample sample(double length) const {
    TransientSample sample;
    if (!(time_ > 0)) return sample;
    sample.velocity = distance_ / time_;
    sample.normalForce = force_ / time_;
    sample.tangentialForce = tangential_ / time_;
    if (force_ > 0) sample.mu = std::abs(tangential_) / force_;
    sample.powerDissipated = dissipated_ / time_;
    sample.contactFraction = contact_ / time_ / length;
    // Sums over steps have rounding errors; a count that does not change stays a whole number.
    const double spots = contactSpots_ / time_, whole = std::round(spots);
    sample.contactSpots = std::abs(spots - whole) < kRounding * whole ? whole : spots;
    if (contactSpots_ > 0) sample.contactLength = contact_ / contactSpots_;
    return sample;
  }

 private:
  double time_ = 0, distance_ = 0, tangential_ = 0, force_ = 0, dissipated_ = 0, contact_ = 0,
         contactSpots_ = 0;
};

Transient::Transient(const Scene& scene, std::shared_ptr<const RigidLine> rigid,
                     std::int64_t leastSteps, int division)
    : load_(scene.load),
      interface_(scene.interface),
      temperatureShift_(temperatureShift(scene.elastomer)),
      hasInterface_(needsStage(scene, Purpose::Picture, Stage::Interface)),
      startsAtRest_(needsStage(scene, Purpose::Picture, Stage::StartFromRest)),
      motion_(scene.sliding),
      longestStep_(motion_.longestStep(leastSteps)),
      division_(division),
      rigid_(std::move(rigid)),
      march_(beginning(scene, *rigid_)),
      relaxation_(relaxationOf(march_.law())) {
  countStage(Stage::TimeMarch);
}

void Transient::estimateErrors(const Scene& scene) {
  const std::size_t nodes = rigid_->line->nodes();
  if (!coarser_.empty() || scene.accuracy.scheme == Scheme::Nodal) return;
  for (const std::size_t every : {2U, 3U, 5U, 7U}) {
    if (nodes % every != 0 || nodes / every < kMinNodes) continue;
    const std::size_t square = every * every;
    const bool hasTwo = nodes % square == 0 && nodes / square >= kMinNodes;
    addCoarser(scene, every, 1);
    if (hasTwo) addCoarser(scene, square, square);
    errorFactor_ = hasTwo ? kFactorOfTwo : kFactorOfOne;
    return;
  }
}

/// Adds marches on every `every`-th node, which begin at this many different nodes.
void Transient::addCoarser(const Scene& scene, std::size_t every, std::size_t offsets) {
  const auto spacing = static_cast<double>(every);
  const double order = std::pow(spacing, kOrder) - 1;
  for (std::size_t i = 0; i < offsets; ++i) {
    try {
      Transient coarse(
          scene, std::make_shared<const RigidLine>(rigid_->coarser(every, i * every / offsets)));
      coarse.division_ = division_;
      coarse.longestStep_ = spacing * longestStep_;
      coarser_.push_back({std::move(coarse), 1 / (static_cast<double>(offsets) * order * order)});
    } catch (const std::runtime_error&) {
      // A line that is too coarse for its own balance gives no difference.
    }
  }
}

/// Starts the records. Before its first step a motion that began in steady sliding knows the times
/// of contact.
void Transient::record(MarchRecords wanted) {
  const bool isSteady = steps_ == 0 && !startsAtRest_;
  startRecords(march_, wanted, isSteady ? motion_.velocityAt(0) : 0);
}

double Transient::stepAt(double time) const {
  return motion_.stepAt(time, rigid_->line->spacing, longestStep_) / division_;
}

/// Returns the time of the next jump of the velocity, or of the motion's end, s.
double Transient::markAfter(double time) const {
  return time < motion_.jump() ? motion_.jump() : motion_.duration();
}

double Transient::countSteps() const {
  constexpr double kMostCounted = 2e5;
  double steps = 0;
  for (double time = time_; time < motion_.duration(); ++steps) {
    if (steps > kMostCounted) return estimateSteps();
    const double mark = markAfter(time), dt = stepAt(time);
    time = dt >= (mark - time) * (1 - kRounding) ? mark : time + dt;
  }
  return steps;
}

/// Estimates the number of steps from times at multiples of the golden section, which are in step
/// with no oscillation.
double Transient::estimateSteps() const {
  constexpr int kMoments = 4096;
  constexpr double kGoldenSection = 0.6180339887498949;
  const double left = motion_.duration() - time_;
  double perSecond = 0;
  for (int i = 0; i < kMoments; ++i) {
    const double part = std::fmod((i + 0.5) * kGoldenSection, 1);
    perSecond += 1 / stepAt(time_ + part * left) / kMoments;
  }
  return std::ceil(perSecond * left);
}

double Transient::shortestStep() const {
  if (!motion_.isSmooth()) return std::min(stepAt(0), stepAt(motion_.jump()));
  const double fastest = motion_.fastest(0, motion_.duration());
  if (!(fastest > 0)) return stepAt(0);
  return std::min(longestStep_, rigid_->line->spacing / fastest) / division_;
}

/// Counts equal steps as integers, because sums of them drift.
double Transient::timeAfter(double dt) {
  if (dt != runStep_) {
    run_ = 0;
    runStep_ = dt;
    runBegin_ = time_;
  }
  ++run_;
  return runBegin_ + run_ * runStep_;
}

void Transient::stepOnce(double dt, Means& means) {
  const double before = time_, next = timeAfter(dt);
  const double distance = motion_.distanceAt(next) - motion_.distanceAt(time_);
  last_ = march_.step(marchLoad(load_, rigid_->line->length), dt, distance);
  means.add(last_, dt, distance);
  time_ = next;
  ++steps_;
  for (Coarser& coarser : coarser_) follow(coarser, before);
}

/// Marches a coarser line up to the end of the step that began at the time `before` (s), and
/// compares friction over each of its steps with that of this march over the same time.
void Transient::follow(Coarser& coarser, double before) const {
  double from = before;
  const auto addUntil = [&](double time) {
    const double dt = std::max(time - from, 0.0);
    coarser.tangential += last_.slopeForce * dt;
    coarser.normal += last_.normalForce * dt;
    from += dt;
  };
  while (coarser.march.canReach(time_)) {
    const double begin = coarser.march.time();
    const TransientSample other = coarser.march.singleStep();
    addUntil(std::min(coarser.march.time(), time_));
    const double dt = coarser.march.time() - begin;
    coarser.difference +=
        dt * (other.tangentialForce / other.normalForce - coarser.tangential / coarser.normal);
    coarser.time += dt;
    coarser.tangential = coarser.normal = 0;
  }
  addUntil(time_);
}

/// Returns the next step: a whole one, except before a jump of the velocity and the motion's end.
double Transient::nextStep() const {
  if (isOver()) return 0;
  const double dt = stepAt(time_), left = markAfter(time_) - time_;
  return endsAtMark(dt) ? left : dt;
}

bool Transient::endsAtMark(double dt) const {
  const double left = markAfter(time_) - time_;
  return left > 0 && dt >= left * (1 - kRounding);
}

bool Transient::canReach(double time) const {
  const double dt = nextStep();
  return !isOver() && time_ + dt <= time + kRounding * dt;
}

TransientSample Transient::marchTo(double time) {
  Means means;
  const std::uint64_t before = steps_;
  while (time_ < time || steps_ == before) {
    const double mark = markAfter(time_), dt = stepAt(time_);
    if (endsAtMark(dt)) {
      stepOnce(mark - time_, means);
      time_ = mark;  // exactly
      runStep_ = 0;
    } else if (steps_ > before && !canReach(time)) {
      break;
    } else {
      stepOnce(dt, means);
    }
  }
  TransientSample sample = means.sample(rigid_->line->length);
  sample.time = time_;
  sample.distance = march_.distance();
  sample.indentation = march_.indentation();
  if (hasInterface_ && sample.velocity != 0) {
    countStage(Stage::Interface);
    sample.muInterface =
        localFriction(interfaceAt(interface_, temperatureShift_, sample.velocity),
                      sample.normalForce, sample.contactFraction * rigid_->line->length);
  }
  addError(sample);
  // At rest friction is of second order in the recovery behind the contacts: it has no such rate.
  if (sample.contactLength > 0 && std::isfinite(relaxation_) && relaxation_ > 0 &&
      sample.velocity != 0)
    sample.predictedRate = 1 / relaxation_ + std::abs(sample.velocity) / sample.contactLength;
  return sample;
}

void Transient::addError(TransientSample& sample) {
  double squares = 0;
  bool isKnown = false;
  for (Coarser& coarser : coarser_) {
    if (coarser.time > 0) coarser.lastDifference = coarser.difference / coarser.time;
    coarser.difference = coarser.time = 0;
    if (!std::isfinite(coarser.lastDifference)) continue;
    isKnown = true;
    squares += coarser.weight * coarser.lastDifference * coarser.lastDifference;
  }
  if (isKnown) sample.muError = errorFactor_ * std::sqrt(squares);
}

TransientSample Transient::singleStep() {
  return marchTo(time_);
}

double recentError(const std::vector<TransientSample>& samples) {
  double squares = 0, count = 0;
  for (std::size_t i = samples.size(); i > 0 && samples.size() - i < kRecent; --i) {
    if (!std::isfinite(samples[i - 1].muError)) continue;
    squares += samples[i - 1].muError * samples[i - 1].muError;
    ++count;
  }
  return count > 0 ? std::sqrt(squares / count) : kNotApplicable;
}

namespace {

// Samples of a motion, at least: as many as its march has steps.
constexpr double kSamplesOfMotion = Transient::kMinSteps;

// States of a motion that are kept for jumps in time: how many, and their size in bytes together.
constexpr double kMaxKept = 32, kKeptBytes = 64e6;

}  // namespace

void PlayedMotion::marchTo(double time) {
  if (samples_.empty()) {
    const TransientSample first = transient_.singleStep();
    samples_.push_back(first);
    samples_.front().time = samples_.front().distance = 0;
    add(first);
  } else {
    add(sampleUpTo(time));
  }
  while (transient_.canReach(time)) add(sampleUpTo(time));
}

/// Adds a sample, which replaces those that were made of the same time before. A kept state has a
/// sample of its own time: those that now lie between two samples are forgotten.
void PlayedMotion::add(const TransientSample& sample) {
  const double last = samples_.empty() ? 0 : samples_.back().time;
  std::erase_if(kept_, [&](const Transient& state) {
    return state.time() > last && state.time() < sample.time;
  });
  samples_.push_back(sample);
  const auto isOver = [&](const TransientSample& other) { return other.time <= sample.time; };
  later_.erase(later_.begin(), std::ranges::partition_point(later_, isOver));
}

/// Marches to this time, or to the next multiple of the longest distance of samples. The present
/// time is near its own multiple, because steps are whole.
TransientSample PlayedMotion::sampleUpTo(double time) {
  const double longest = motion().duration() / kSamplesOfMotion;
  return transient_.marchTo(
      std::min(time, (std::round(transient_.time() / longest) + 1) * longest));
}

void PlayedMotion::keepState() {
  const TimeMarch& march = transient_.march();
  const double numbers = 4 + static_cast<double>(march.modes().modes());  // of an element
  // The coarser lines that estimate the error have one and a half times as many elements together.
  const double bytes = 2.5 * sizeof(double) * numbers * static_cast<double>(march.depth().size());
  const double most = std::clamp(std::floor(kKeptBytes / bytes), 1.0, kMaxKept);
  const double between = motion().duration() / (most + 1);
  const double last = kept_.empty() ? 0 : kept_.back().time();
  if (transient_.time() >= last + between) kept_.push_back(transient_);
}

bool PlayedMotion::goTo(double time, const Transient& beginning) {
  const auto isReached = [&](const Transient& state) { return state.time() <= time; };
  const auto after = std::ranges::partition_point(kept_, isReached);
  const Transient& nearest = after == kept_.begin() ? beginning : *std::prev(after);
  if (isReached(transient_) && nearest.time() <= transient_.time()) return false;
  transient_ = nearest;
  samples_.insert(samples_.end(), later_.begin(), later_.end());
  const bool isBeginning = transient_.steps() == 0;
  const auto next = std::ranges::find_if(samples_, [&](const TransientSample& sample) {
    return isBeginning || sample.time > transient_.time();
  });
  later_.assign(next, samples_.end());
  samples_.erase(next, samples_.end());
  return true;
}

}  // namespace asperity
