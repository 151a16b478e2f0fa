#include "core/accuracy/target_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/accuracy/levels.h"
#include "core/base/jobs.h"
#include "core/base/number_text.h"
#include "core/base/statistics.h"
#include "core/base/stop.h"
#include "core/contact/steady_sliding.h"
#include "core/friction/line_mean.h"
#include "core/material/element_law.h"

namespace asperity {
namespace {

/// The first level that can be accepted: two levels do not determine the error of a line, because
/// they may agree by chance.
constexpr int kFirstAccepted = 2;

/// The relative rounding error of friction at best.
constexpr double kRounding = 1e-13;

/// Factor for the number of additional lines, so that further rounds are rare.
constexpr double kSurplus = 1.02;

constexpr std::int64_t kMinAtOnce = 4;

class TargetSampling {
 public:
  TargetSampling(const Scene& scene, const CurveOptions& options, const Profile* profile = nullptr)
      : scene_(resolved(scene)),
        options_(options),
        sampler_(scene_, options_, profile),
        columns_(scene_, sampler_.source(0)),
        isRandom_(sampler_.source(0).isRandom() && sampler_.source(0).lines() > 1),
        isFrictionless_(isFrictionless(scene_)) {
    for (const double velocity : velocitiesOfCurve(scene_.sweep, options_))
      states_.emplace_back().velocity = velocity;
  }

  TargetCurve run() {
    const bool isWhole = isFrictionless_ ? runFrictionless()
                         : isRandom_     ? findErrorOfRows() && runRandom()
                                         : runSingle();
    return result(isWhole);
  }

  TargetPlan plan() {
    TargetPlan plan;
    if (isRandom_ && !isFrictionless_) plan.secondsOfRows = predictErrorOfRows();
    const double start = threadSeconds() - sampler_.secondsOfSources();
    const bool isWhole = isFrictionless_ ? runFrictionless()
                         : isRandom_     ? runPilot() && planAll()
                                         : runSingle();
    if (!isWhole) throw StopRequested{};
    plan.secondsOfPilot = threadSeconds() - start;
    plan.secondsOfSources = sampler_.secondsOfSources();
    plan.secondsOfOperation = plan.secondsOfPilot / std::max(1.0, sampler_.cost().operations);
    plan.largestResidual = sampler_.cost().largestResidual;
    double standard = 0, resolution = 0;
    for (const VelocityState& state : states_) {
      addWork(state.plan, plan);
      if (isFrictionless_) continue;
      const double relative = state.plan.resolutionError / std::abs(sampledValue(state));
      resolution += relative * relative;
      if (isRandom_) standard += squaredStandardError(state, relative);
    }
    const auto count = static_cast<double>(states_.size());
    if (isRandom_ && !isFrictionless_) plan.standardError = std::sqrt(standard / count);
    if (!isFrictionless_) plan.resolutionError = std::sqrt(resolution / count);
    return plan;
  }

 private:
  static void addWork(const LevelPlan& ofVelocity, TargetPlan& plan) {
    plan.operations += ofVelocity.operations;
    double lines = 0;
    for (const auto& half : ofVelocity.lines)
      for (const std::int64_t count : half) lines += static_cast<double>(count);
    plan.mostLines = std::max(plan.mostLines, lines);
    plan.simulations += lines;
    plan.finest = std::max(plan.finest, levelOversampling(ofVelocity.last));
  }

  /// Returns the square of the relative standard error that the planned lines will have; both
  /// errors are relative.
  double squaredStandardError(const VelocityState& state, double resolutionError) const {
    const double drawn = drawnError(state), ofRows = state.ofRows.standardError;
    double random = std::sqrt(std::max(0.0, drawn * drawn - resolutionError * resolutionError));
    if (isComplete(state)) {  // the fewest lines are already better than the target
      const LevelEstimate estimate = estimateMean(state.halves, state.plan);
      random = std::min(random, estimate.standardError / std::abs(estimate.mean));
    }
    return random * random + ofRows * ofRows;
  }

  static Scene resolved(Scene scene) {
    scene.accuracy.scheme = Scheme::Cubic;
    return scene;
  }

  bool stopped() const { return options_.stop.stop_requested(); }
  double target() const { return scene_.accuracy.targetRelativeError; }

  /// Returns the relative error that is left for the lines drawn and their resolution. Where the
  /// rows of a topography are too few for the target, more lines hardly help; where they are almost
  /// too few, 16 times the lines are worth it.
  double drawnError(const VelocityState& state) const {
    constexpr double kShareWhereHopeless = 0.5, kMinShare = 0.25;
    const double ofRows = state.ofRows.standardError;
    if (ofRows == 0) return target();
    if (!(ofRows < target())) return kShareWhereHopeless * target();
    return std::sqrt(std::max(target() * target() - ofRows * ofRows,
                              kMinShare * kMinShare * target() * target()));
  }

  States allStates() {
    States all;
    for (VelocityState& state : states_) all.push_back(&state);
    return all;
  }

  // ---- A random line: pilot, plan, lines until the target is met ------------------------------

  bool sampleBoth(int level, bool isDirect, const States& states, std::int64_t linesOfEach) {
    return sampler_.sample({level, isDirect, 0}, states, linesOfEach) &&
           sampler_.sample({level, isDirect, 1}, states, linesOfEach);
  }

  bool hasRows() { return sampler_.source(0).hasRows(); }

  std::vector<double> velocities() const {
    std::vector<double> velocities;
    for (const VelocityState& state : states_) velocities.push_back(state.velocity);
    return velocities;
  }

  /// Returns false where stopped.
  bool findErrorOfRows() {
    if (!hasRows()) return true;
    const auto errors = errorsOfRows(scene_, velocities(), options_.threads, options_.stop);
    for (std::size_t i = 0; i < errors.size(); ++i) states_[i].ofRows = errors[i];
    return !errors.empty();
  }

  /// Returns the seconds that findErrorOfRows would take.
  double predictErrorOfRows() {
    if (!hasRows()) return 0;
    const PredictedRowErrors predicted = predictErrorsOfRows(scene_, velocities(), options_.stop);
    for (std::size_t i = 0; i < states_.size(); ++i)
      states_[i].ofRows.standardError = predicted.standardErrors[i];
    return predicted.seconds;
  }

  bool runPilot() {
    States all = allStates();
    if (!sampleBoth(0, true, all, kMinDirect)) return false;
    if (!sampleBoth(1, false, all, kMinCorrections)) return false;
    for (VelocityState* state : all) {
      state->known = 2;
      state->plan.lines = {{{kMinDirect}, {kMinDirect}}};
    }
    return true;
  }

  bool runRandom() {
    if (!runPilot()) return false;
    report();
    while (!stopped() && planAll()) {
      const bool isDone = std::all_of(states_.begin(), states_.end(), isComplete);
      report(isDone);
      if (isDone) return true;
      if (!sampleMissing()) return false;
    }
    return false;
  }

  /// Makes a plan for every velocity, and samples finer levels where the resolution needs them.
  bool planAll() {
    for (;;) {
      States unresolved;
      int level = kMaxLevels;
      for (VelocityState& state : states_) {
        if (state.isExhausted) continue;
        const std::optional<LevelPlan> plan =
            planLevels(state.halves, state.known, drawnError(state));
        if (plan) {
          adopt(state, *plan);
        } else if (state.known < sampler_.levelsAllowed()) {
          level = std::min(level, state.known);
          unresolved.push_back(&state);
        } else {
          exhaust(state);
        }
      }
      std::erase_if(unresolved, [&](const VelocityState* state) { return state->known != level; });
      if (unresolved.empty()) return true;
      if (!sampleBoth(level, false, unresolved, kMinCorrections)) return false;
      for (VelocityState* state : unresolved) ++state->known;
    }
  }

  /// Adopts a plan. Where all its lines have been drawn and their error is still too large, both
  /// halves get proportionally more lines: a difference between the spreads of the halves gives no
  /// information on their common mean.
  void adopt(VelocityState& state, const LevelPlan& plan) const {
    const bool isSame =
        state.isPlanned && state.plan.first == plan.first && state.plan.last == plan.last;
    if (!isSame)
      for (auto& least : state.least)
        least.assign(static_cast<std::size_t>(plan.last - plan.first + 1), 0);
    state.plan = plan;
    state.isPlanned = true;
    addLeast(state);
    const double excess =
        isComplete(state) ? excessVariance(state.halves, plan, drawnError(state)) : 1;
    if (excess > 1) {
      for (const std::size_t half : {0U, 1U})
        for (int level = plan.first; level <= plan.last; ++level) {
          const auto lines = static_cast<double>(state.sampled(half, level).count());
          state.least[half][static_cast<std::size_t>(level - plan.first)] =
              static_cast<std::int64_t>(std::min(std::ceil(kSurplus * excess * lines), 1e15));
        }
      addLeast(state);
    }
    for (auto& half : state.plan.lines)
      for (std::int64_t& lines : half)
        if (lines > kMaxLines / 2) {
          lines = kMaxLines / 2;
          state.isExhausted = true;
        }
  }

  static void addLeast(VelocityState& state) {
    for (const std::size_t half : {0U, 1U})
      for (std::size_t k = 0; k < state.least[half].size(); ++k)
        state.plan.lines[half][k] = std::max(state.plan.lines[half][k], state.least[half][k]);
  }

  /// Accepts the best possible result where even the finest allowed line is not sufficient.
  void exhaust(VelocityState& state) const {
    const int last = state.known - 1;
    state.plan = {.first = last,
                  .last = last,
                  .resolutionError = estimateResolutionError(state.halves, last)};
    for (auto& lines : state.plan.lines) lines = {kMinDirect};
    state.isPlanned = state.isExhausted = true;
  }

  double sampledValue(const VelocityState& state) const {
    if (!isRandom_) return state.friction.back();
    const auto last = static_cast<std::size_t>(state.plan.last);
    return 0.5 * (state.halves[0][last].value.mean() + state.halves[1][last].value.mean());
  }

  static std::int64_t missing(const VelocityState& state, std::size_t half, int level) {
    if (level < state.plan.first || level > state.plan.last) return 0;
    const auto index = static_cast<std::size_t>(level - state.plan.first);
    return std::max<std::int64_t>(
        0, state.plan.lines[half][index] - state.sampled(half, level).count());
  }

  static bool isComplete(const VelocityState& state) {
    for (const std::size_t half : {0U, 1U})
      for (int level = state.plan.first; level <= state.plan.last; ++level)
        if (missing(state, half, level) > 0) return false;
    return true;
  }

  /// Draws one batch for each level, purpose and half, with as many lines as the velocity nearest
  /// to its goal needs; at most twice the present number, because variances are known better then.
  /// Returns false where stopped.
  bool sampleMissing() {
    for (int level = 0; level < sampler_.levelsAllowed(); ++level)
      for (const bool isDirect : {true, false})
        for (const std::size_t half : {0U, 1U}) {
          States wanting;
          std::int64_t lines = kMaxLines;
          for (VelocityState& state : states_) {
            if ((level == state.plan.first) != isDirect) continue;
            const std::int64_t still = missing(state, half, level);
            if (still <= 0) continue;
            wanting.push_back(&state);
            const std::int64_t twice = std::max(kMinDirect, state.sampled(half, level).count());
            lines = std::min(lines, std::min(still, twice));
          }
          if (wanting.empty()) continue;
          // A minimum batch avoids a round for every single line.
          if (!sampler_.sample({level, isDirect, half}, wanting, std::max(lines, kMinAtOnce)))
            return false;
        }
    return true;
  }

  // ---- A single line, with increasing resolution ------------------------------------------------

  bool runSingle() {
    States open = allStates();
    std::vector<std::vector<SteadyResult>> results;
    for (int level = 0; level < sampler_.levelsAllowed() && !open.empty(); ++level) {
      if (!sampler_.slide(level, open, 0, 1, results)) return false;
      for (std::size_t i = 0; i < open.size(); ++i) setLevel(*open[i], level, results[0][i]);
      if (level >= kFirstAccepted)
        std::erase_if(open, [&](const VelocityState* state) {
          return state->plan.resolutionError <= target() * std::abs(state->friction.back());
        });
      report();
    }
    report(true);
    return true;
  }

  void setLevel(VelocityState& state, int level, const SteadyResult& result) {
    sampler_.count(result, level);
    state.friction.push_back(result.mu);
    state.facts = {};
    state.facts.add(result);
    // Where a body has no friction, its only level is not the coarsest one.
    const std::size_t levels = state.friction.size();
    const double last = levels > 1 ? state.friction[levels - 2] : 0;
    const double resolution =
        levels > kFirstAccepted ? lineError(state.friction) : std::abs(result.mu - last);
    const double digits = (kRounding + result.residual) * std::abs(result.mu);
    // All waves of a sine are alike. Where only some of them touch, the points do not resolve their
    // heights, and friction of these few may converge to another value on the way.
    const bool isUneven = scene_.surface.kind == SurfaceKind::Sine && result.contactFraction < 1 &&
                          result.contactSpots < static_cast<double>(scene_.surface.waves);
    const double few = isUneven ? std::abs(result.mu) : 0;
    state.plan = {
        .first = level, .last = level, .resolutionError = std::max({resolution, digits, few})};
    state.plan.lines[0] = {1};
    state.isPlanned = true;
  }

  // ---- No friction at all ---------------------------------------------------------------------

  /// Computes a body whose friction is 0 by the law of its elements: the results are rounding
  /// errors.
  bool runFrictionless() {
    const int level = std::min(kFirstAccepted, sampler_.levelsAllowed() - 1);
    States all = allStates();
    if (isRandom_) {
      if (!sampleBoth(level, true, all, kMinDirect)) return false;
    } else {
      std::vector<std::vector<SteadyResult>> results;
      if (!sampler_.slide(level, all, 0, 1, results)) return false;
      for (std::size_t i = 0; i < all.size(); ++i) setLevel(*all[i], level, results[0][i]);
    }
    for (VelocityState* state : all) {
      state->plan = {.first = level, .last = level};
      state->plan.lines[0] = {isRandom_ ? kMinDirect : 1};
      if (isRandom_) state->plan.lines[1] = state->plan.lines[0];
      state->isPlanned = true;
    }
    report(true);
    return true;
  }

  // ---- The result -------------------------------------------------------------------------------

  /// Adds the error of the rows to that of the draws (Welch and Satterthwaite).
  static LevelEstimate withErrorOfRows(LevelEstimate estimate, const VelocityState& state) {
    const double ofRows = state.ofRows.standardError * estimate.mean;
    if (ofRows == 0) return estimate;
    const double drawn = estimate.standardError * estimate.standardError, rows = ofRows * ofRows;
    estimate.standardError = std::sqrt(drawn + rows);
    estimate.degreesOfFreedom =
        (drawn + rows) * (drawn + rows) /
        (drawn * drawn / estimate.degreesOfFreedom + rows * rows / state.ofRows.degreesOfFreedom);
    return estimate;
  }

  AchievedAccuracy achievedBy(const VelocityState& state) const {
    const LevelPlan& plan = state.plan;
    AchievedAccuracy achieved{.resolutionError = plan.resolutionError,
                              .oversampling = levelOversampling(plan.last)};
    double mean = 0, random = 0;
    if (isRandom_) {
      const LevelEstimate estimate = withErrorOfRows(estimateMean(state.halves, plan), state);
      mean = estimate.mean;
      achieved.standardError = estimate.standardError;
      random = studentQuantile(estimate.degreesOfFreedom) * estimate.standardError;
      achieved.lines = 0;
      for (const std::size_t half : {0U, 1U})
        for (int l = plan.first; l <= plan.last; ++l)
          achieved.lines += state.sampled(half, l).count();
    } else {
      mean = state.friction.back();
    }
    if (isFrictionless_) achieved.resolutionError = std::abs(mean);
    const double half = std::hypot(random, achieved.resolutionError);
    achieved.low = mean - half;
    achieved.high = mean + half;
    return achieved;
  }

  CurvePoint pointOf(const VelocityState& state, const AchievedAccuracy& achieved) const {
    CurvePoint point = state.facts.point(state.velocity);
    point.mu = 0.5 * (achieved.low + achieved.high);
    point.muStandardError = isRandom_ ? achieved.standardError : kNotApplicable;
    point.muLow = achieved.low;
    point.muHigh = achieved.high;
    point.realizations = achieved.lines;
    columns_.addTo(point, state.facts);
    point.notes.add(
        Note::FewIndependentRows,
        state.ofRows.standardError > 0 && state.ofRows.degreesOfFreedom < kFewDegreesOfFreedom);
    return point;
  }

  /// Returns the relative error; a friction of 0 by law has none.
  double relativeError(const AchievedAccuracy& achieved, double mu) const {
    if (isFrictionless_) return 0;
    const double error = std::hypot(achieved.standardError, achieved.resolutionError);
    return mu != 0 ? error / std::abs(mu) : std::numeric_limits<double>::infinity();
  }

  TargetCurve result(bool isWhole) {
    TargetCurve result;
    Curve& curve = result.curve;
    curve.isComplete = curve.isTargetMet = isWhole;
    curve.achievedError = 0;
    for (const VelocityState& state : states_) {
      if (!state.isPlanned) continue;
      const AchievedAccuracy& achieved = result.achieved.emplace_back(achievedBy(state));
      const CurvePoint& point = curve.points.emplace_back(pointOf(state, achieved));
      const double error = relativeError(achieved, point.mu);
      curve.achievedError = std::max(curve.achievedError, error);
      curve.errorOfRows = std::max(curve.errorOfRows, state.ofRows.standardError);
      curve.isTargetMet &= error <= target();
      // Two levels of a line may agree by chance, and the allowed nodes do not suffice for a third
      // one.
      curve.isTargetMet &= isRandom_ || isFrictionless_ || state.plan.last >= kFirstAccepted;
      result.plainOperations += state.plan.plainOperations;
    }
    const SamplingCost& cost = sampler_.cost();
    result.operations = cost.operations;
    curve.largestResidual = cost.largestResidual;
    curve.meanPasses = static_cast<double>(cost.passes) /
                       static_cast<double>(std::max<std::int64_t>(1, cost.solves));
    return result;
  }

  /// Returns whether there is an estimate. A new plan may begin at a level with too few lines for a
  /// spread.
  bool hasEstimate(const VelocityState& state) const {
    if (!isRandom_) return true;
    for (const std::size_t half : {0U, 1U})
      for (int l = state.plan.first; l <= state.plan.last; ++l)
        if (state.sampled(half, l).count() < 2) return false;
    return true;
  }

  /// Returns the mean over all lines drawn, on any level.
  CurvePoint sampledSoFar(const VelocityState& state) const {
    CurvePoint point = state.facts.point(state.velocity);
    columns_.addTo(point, state.facts);
    return point;
  }

  /// Reports the lines drawn so far and those that the plans still need: none in the last report,
  /// else at least one. A given line counts as one line, which is finished with the last level.
  void report(bool isLast = false) {
    if (!options_.progress) return;
    std::vector<CurvePoint> points;
    std::int64_t still = isLast ? 0 : 1;
    for (const VelocityState& state : states_) {
      points.push_back(hasEstimate(state) ? pointOf(state, achievedBy(state))
                                          : sampledSoFar(state));
      if (!isRandom_) continue;
      std::int64_t lines = 0;
      for (const std::size_t half : {0U, 1U})
        for (int l = state.plan.first; l <= state.plan.last; ++l) lines += missing(state, half, l);
      still = std::max(still, lines);
    }
    const std::int64_t done = isRandom_ ? sampler_.lines() : 1 - still;
    options_.progress({done, done + still, points});
  }

  Scene scene_;
  const CurveOptions& options_;
  LevelSampler sampler_;
  LawColumns columns_;
  std::vector<VelocityState> states_;
  bool isRandom_, isFrictionless_;
};

}  // namespace

TargetPlan planTarget(const Scene& scene, const std::stop_token& stop, const Profile* profile) {
  CurveOptions options;
  options.threads = 1;  // its processor time is measured on this thread
  options.stop = stop;
  return TargetSampling(scene, options, profile).plan();
}

TargetCurve targetCurve(const Scene& scene, const CurveOptions& options) {
  return TargetSampling(scene, options).run();
}

bool isFrictionless(const Scene& scene) {
  return elementLaw(scene.elastomer).kind() == ElementKind::Elastic;
}

}  // namespace asperity
