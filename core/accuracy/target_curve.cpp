#include "core/accuracy/target_curve.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/accuracy/level_sampler.h"
#include "core/accuracy/processor_time.h"
#include "core/friction/study.h"

namespace asperity {
namespace {

class Targeting {
 public:
  Targeting(const Scene& scene, const CurveOptions& options)
      : scene_(resolved(scene)),
        options_(options),
        sampler_(scene_, options_),
        columns_(scene_, sampler_.source(0)),
        isRandom_(sampler_.source(0).isRandom()) {
    for (const double velocity : sweepVelocities(scene_.sweep))
      states_.emplace_back().velocity = velocity;
  }

  TargetCurve run() {
    const bool isWhole = isRandom_ ? runRandom() : runSingle();
    return result(isWhole);
  }

  TargetPlan plan() {
    TargetPlan plan;
    const double start = threadSeconds();
    const bool isWhole = isRandom_ ? runPilot() && planAll() : runSingle();
    if (!isWhole) throw StudyStopped{};
    plan.secondsOfPilot = threadSeconds() - start;
    plan.secondsOfOperation = plan.secondsOfPilot / std::max(1.0, sampler_.cost().operations);
    plan.largestResidual = sampler_.cost().largestResidual;
    const double target = scene_.accuracy.targetRelativeError;
    double standard = 0, resolution = 0;
    for (const VelocityState& state : states_) {
      plan.operations += state.plan.operations;
      double lines = 0;
      for (const std::int64_t count : state.plan.lines) lines += static_cast<double>(count);
      plan.mostLines = std::max(plan.mostLines, lines);
      plan.simulations += lines;
      const double mu = sampledValue(state);
      const double relative = state.plan.resolutionError / mu;
      resolution += relative * relative;
      standard += isRandom_ ? std::max(0.0, target * target - relative * relative) : 0;
    }
    const auto count = static_cast<double>(states_.size());
    plan.standardError = isRandom_ ? std::sqrt(standard / count) : kNotApplicable;
    plan.resolutionError = std::sqrt(resolution / count);
    return plan;
  }

 private:
  static Scene resolved(Scene scene) {
    scene.accuracy.scheme = Scheme::Cubic;
    return scene;
  }

  bool stopped() const { return options_.stop.stop_requested(); }

  States allStates() {
    States all;
    for (VelocityState& state : states_) all.push_back(&state);
    return all;
  }

  // ---- A random line: pilot, plan, lines until it is met -------------------------------------

  bool runPilot() {
    States all = allStates();
    if (!sampler_.sampleDirect(0, all, kPilotLines)) return false;
    if (!sampler_.sampleCorrection(1, all, kPilotLines)) return false;
    for (VelocityState* state : all) state->known = 2;
    return true;
  }

  bool runRandom() {
    if (!runPilot()) return false;
    report();
    for (;;) {
      if (!planAll()) return false;
      if (!sampleWanted()) return !stopped();
      report();
    }
  }

  /// A plan for every velocity, sampling finer levels where the resolution asks for it.
  bool planAll() {
    for (;;) {
      States unresolved;
      int level = kMostLevels;
      for (VelocityState& state : states_) {
        if (state.isExhausted) continue;
        const std::optional<LevelPlan> plan = planLevels(state.levels, state.known, allowed(state));
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
      if (!sampler_.sampleCorrection(level, unresolved, kPilotLines / 2)) return false;
      for (VelocityState* state : unresolved) ++state->known;
    }
  }

  double allowed(const VelocityState& state) const {
    const LevelSums& sums = state.levels[static_cast<std::size_t>(state.known - 1)];
    return scene_.accuracy.targetRelativeError * std::abs(sums.value.mean());
  }

  /// Where all the lines of the plan are there, their own spread decides: variances were guesses.
  void adopt(VelocityState& state, const LevelPlan& plan) const {
    state.plan = plan;
    state.isPlanned = true;
    bool isComplete = true;
    for (int level = plan.first; level <= plan.last; ++level)
      isComplete &= missing(state, level) <= 0;
    if (isComplete) {
      const LevelEstimate estimate = estimateOf(state.levels, plan);
      const double error = scene_.accuracy.targetRelativeError * std::abs(estimate.mean);
      const double tooLarge = estimate.standardError * estimate.standardError /
                              (error * error - plan.resolutionError * plan.resolutionError);
      if (tooLarge > 1)
        for (int level = plan.first; level <= plan.last; ++level)
          state.plan.lines[static_cast<std::size_t>(level - plan.first)] =
              static_cast<std::int64_t>(
                  std::ceil(1.05 * tooLarge * static_cast<double>(sampled(state, level).count())));
    }
    for (std::int64_t& lines : state.plan.lines)
      if (lines > kMostLines) {
        lines = kMostLines;
        state.isExhausted = true;
      }
  }

  /// The finest line there may be does not do: the best that can be had, as it is.
  void exhaust(VelocityState& state) {
    const int last = state.known - 2;
    state.plan = {last, last, {kPilotLines}, 0, 0, *resolutionErrorOf(state.levels, last)};
    state.isPlanned = state.isExhausted = true;
  }

  static double sampledValue(const VelocityState& state) {
    return state.levels[static_cast<std::size_t>(state.plan.last)].value.mean();
  }

  static const RunningMean& sampled(const VelocityState& state, int level) {
    const LevelSums& sums = state.levels[static_cast<std::size_t>(level)];
    return level == state.plan.first ? sums.direct : sums.correction;
  }

  static std::int64_t missing(const VelocityState& state, int level) {
    if (level < state.plan.first || level > state.plan.last) return 0;
    const auto place = static_cast<std::size_t>(level - state.plan.first);
    return state.plan.lines[place] - sampled(state, level).count();
  }

  /// One batch for each level and purpose, as many lines as the velocity next to its goal needs;
  /// at most twice what is there, because variances are known better then. False: nothing is
  /// wanted.
  bool sampleWanted() {
    bool any = false;
    for (int level = 0; level < sampler_.levelsAllowed(); ++level)
      for (const bool direct : {true, false}) {
        States wanting;
        std::int64_t lines = kMostLines;
        for (VelocityState& state : states_) {
          if ((level == state.plan.first) != direct) continue;
          const std::int64_t still = missing(state, level);
          if (still <= 0) continue;
          wanting.push_back(&state);
          const std::int64_t twice = std::max(kPilotLines, sampled(state, level).count());
          lines = std::min(lines, std::min(still, twice));
        }
        if (wanting.empty()) continue;
        any = true;
        lines = std::max<std::int64_t>(lines, 4);  // not a round for every single line
        const bool done = direct ? sampler_.sampleDirect(level, wanting, lines)
                                 : sampler_.sampleCorrection(level, wanting, lines);
        if (!done) return false;
      }
    return any;
  }

  // ---- A single line: finer and finer ---------------------------------------------------------

  bool runSingle() {
    States open = allStates();
    std::vector<std::vector<SteadyResult>> coarse, fine;
    if (!sampler_.slide(0, open, 0, 1, coarse)) return false;
    for (int level = 1; level < sampler_.levelsAllowed() && !open.empty(); ++level) {
      if (!sampler_.slide(level, open, 0, 1, fine)) return false;
      States still;
      std::vector<SteadyResult> left;
      for (std::size_t i = 0; i < open.size(); ++i) {
        VelocityState& state = *open[i];
        const SteadyResult& now = fine[0][i];
        LevelSums& sums = state.levels[static_cast<std::size_t>(level)];
        sums.direct = RunningMean{};
        sums.direct.add(now.mu);
        sampler_.count(sums, now, level);
        state.facts = {};
        state.facts.add(now);
        // Of the finer one: a third of the last difference at second order.
        const double error = std::abs(now.mu - coarse[0][i].mu) / 3;
        state.plan = {level, level, {1}, 0, 0, error};
        state.isPlanned = true;
        if (error <= scene_.accuracy.targetRelativeError * std::abs(now.mu)) continue;
        still.push_back(&state);
        left.push_back(now);
      }
      open = std::move(still);
      coarse = {std::move(left)};
    }
    for (VelocityState* state : open) state->isExhausted = true;
    return true;
  }

  // ---- The answer -------------------------------------------------------------------------------

  AchievedAccuracy achievedBy(const VelocityState& state) const {
    const LevelPlan& plan = state.plan;
    AchievedAccuracy achieved;
    achieved.oversampling = oversamplingOf(plan.last);
    achieved.coarsest = oversamplingOf(plan.first);
    achieved.resolutionError = plan.resolutionError;
    double mean = sampled(state, plan.first).mean(), half = plan.resolutionError;
    achieved.lines = 1;
    if (isRandom_) {
      const LevelEstimate estimate = estimateOf(state.levels, plan);
      mean = estimate.mean;
      achieved.standardError = estimate.standardError;
      half = std::hypot(studentQuantile(estimate.freedom) * estimate.standardError,
                        plan.resolutionError);
      achieved.lines = 0;
      for (int l = plan.first; l <= plan.last; ++l) achieved.lines += sampled(state, l).count();
    }
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
    return point;
  }

  TargetCurve result(bool isWhole) {
    TargetCurve result;
    result.isReached = isWhole;
    for (const VelocityState& state : states_) {
      if (!state.isPlanned) continue;
      const AchievedAccuracy& achieved = result.achieved.emplace_back(achievedBy(state));
      const CurvePoint& point = result.curve.points.emplace_back(pointOf(state, achieved));
      const double error =
          std::hypot(achieved.standardError, achieved.resolutionError) / std::abs(point.mu);
      if (std::isfinite(error)) result.worst = std::max(result.worst, error);
      result.plainOperations += state.plan.plainOperations;
    }
    // The last lines are drawn for a variance that they still change a little.
    result.isReached &= result.worst <= 1.05 * scene_.accuracy.targetRelativeError;
    const SamplingCost& cost = sampler_.cost();
    result.operations = cost.operations;
    result.curve.isComplete = isWhole;
    result.curve.achievedError = result.worst;
    result.curve.isTargetMet = result.isReached;
    result.curve.largestResidual = cost.largestResidual;
    result.curve.meanPasses = static_cast<double>(cost.passes) /
                              static_cast<double>(std::max<std::int64_t>(1, cost.solves));
    return result;
  }

  /// Lines drawn so far, of those that the plans ask for.
  void report() {
    if (!options_.progress) return;
    std::int64_t done = 0, total = 0;
    std::vector<CurvePoint> points;
    for (VelocityState& state : states_) {
      if (!state.isPlanned) {
        state.plan = {0, 0, {kPilotLines}, 0, 0, 0};
      }
      for (int l = state.plan.first; l <= state.plan.last; ++l) {
        const std::int64_t wanted =
            state.plan.lines[static_cast<std::size_t>(l - state.plan.first)];
        done = std::max(done, std::min(wanted, sampled(state, l).count()));
        total = std::max(total, wanted);
      }
      points.push_back(pointOf(state, achievedBy(state)));
    }
    options_.progress({done, std::max(done, total), points});
  }

  Scene scene_;
  const CurveOptions& options_;
  LevelSampler sampler_;
  LawColumns columns_;
  std::vector<VelocityState> states_;
  bool isRandom_;
};

}  // namespace

TargetPlan planTarget(const Scene& scene, const std::stop_token& stop) {
  CurveOptions options;
  options.threads = 1;  // its processor time is this thread's
  options.stop = stop;
  return Targeting(scene, options).plan();
}

TargetCurve targetCurve(const Scene& scene, const CurveOptions& options) {
  return Targeting(scene, options).run();
}

Curve curveOf(const Scene& scene, const CurveOptions& options) {
  return choosesAccuracy(scene) ? targetCurve(scene, options).curve : frictionCurve(scene, options);
}

}  // namespace asperity
