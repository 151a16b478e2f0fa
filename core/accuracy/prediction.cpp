#include "core/accuracy/prediction.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "core/accuracy/pilot.h"
#include "core/accuracy/target_curve.h"
#include "core/base/jobs.h"
#include "core/base/number_text.h"
#include "core/base/statistics.h"
#include "core/base/stop.h"
#include "core/contact/steady_solver.h"
#include "core/friction/ensemble.h"
#include "core/friction/line_mean.h"
#include "core/friction/parameter_map.h"
#include "core/surface/line_source.h"

namespace asperity {
namespace {

/// Relative slowdown for each doubling of the length: a longer line no longer fits the caches, and
/// a transform has more steps.
constexpr double kSlowdownOfDoubling = 0.08;
constexpr std::int64_t kTargetVelocities = 9;
/// Operations per point of a target curve's pilot: some lines on two levels at kTargetVelocities.
constexpr double kOperationsOfTarget = 5;
constexpr std::int64_t kMaxMeasuredNodes = std::int64_t{1} << 26;  // of the line used as reference

/// One resolution of a scene's lines: slides them and measures the time.
class Pilot {
 public:
  /// profile: replaces the one in the scene's file if it is not null.
  Pilot(const Scene& scene, const Profile* profile, std::vector<double> velocities)
      : scene_(scene),
        source_(scene, curvePointsPerElement(scene), profile),
        sliding_(scene),
        velocities_(std::move(velocities)),
        row_(velocities_.size()),
        complete_(velocities_.size()) {}

  const LineSource& source() const { return source_; }

  /// Slides one line; returns mu at each velocity.
  std::vector<double> slide(std::int64_t realization) {
    const double begin = threadSeconds();
    source_.makeInto(line_, realization);
    prepareProfileInto(prepared_, line_, scene_.accuracy.scheme);
    const double made = threadSeconds();
    sliding_.sweep(prepared_, scene_.load, velocities_, row_);
    making_.push_back(made - begin);
    sweeping_.push_back(threadSeconds() - made);
    std::vector<double> mu;
    for (std::size_t i = 0; i < row_.size(); ++i) {
      const SteadyResult& result = row_[i];
      mu.push_back(result.mu);
      residual_ = std::max(residual_, result.residual);
      if (result.contactFraction >= 1) addComplete(i);
    }
    return mu;
  }

  double largestResidual() const { return residual_; }
  /// Returns whether half of the lines or more were in complete contact at every velocity, some of
  /// them with hardly more than the indentation that they need for it.
  bool isJustComplete() const {
    return !isClear_ && 2 * std::ranges::min(complete_) >= making_.size();
  }
  /// Return the processor time to make one line, and to slide it at one velocity: medians.
  double secondsOfLine() const { return median(making_); }
  double secondsOfBalance() const {
    return median(sweeping_) / static_cast<double>(velocities_.size());
  }
  double secondsOfLastBalance() const {
    return sweeping_.back() / static_cast<double>(velocities_.size());
  }

 private:
  /// Counts a state of the last line in complete contact, and finds whether it would also be at a
  /// clearly smaller indentation.
  void addComplete(std::size_t velocity) {
    ++complete_[velocity];
    if (!isClear_) return;
    constexpr double kClear = 1.5;  // the indentation that lines need for it varies less
    const double depth = row_[velocity].indentation / kClear;
    const bool isNodal = scene_.accuracy.scheme == Scheme::Nodal;
    isClear_ = sliding_.isComplete(isNodal ? prepareProfile(line_, Scheme::Linear) : prepared_,
                                   depth, velocities_[velocity]);
  }

  Scene scene_;
  LineSource source_;
  SteadySolver sliding_;
  std::vector<double> velocities_;
  std::vector<SteadyResult> row_;
  Line line_;
  PreparedProfile prepared_;
  double residual_ = 0;
  std::vector<std::size_t> complete_;  // number of lines in complete contact at each velocity
  bool isClear_ = true;
  std::vector<double> making_, sweeping_;  // s, for each line
};

/// Returns the scene with a finer resolution; its own where there is no finer one.
Scene refined(const Scene& scene, std::int64_t factor) {
  Scene fine = scene;
  fine.accuracy = {
      scene.accuracy.scheme == Scheme::Linear ? Scheme::Linear : Scheme::Cubic,
      scene.accuracy.scheme == Scheme::Nodal ? 4 : factor * curvePointsPerElement(scene), 0};
  return fine;
}

/// Returns the factor from the difference to a line with `factor` times the points to the full
/// error.
double remainder(const Scene& scene, std::int64_t factor) {
  if (scene.accuracy.scheme == Scheme::Nodal) return 1;
  const double order = scene.accuracy.scheme == Scheme::Linear ? 2 : 4;
  return 1 / (1 - std::pow(static_cast<double>(factor), -order));
}

/// Returns means of mu at each velocity over these lines.
std::vector<RunningMean> meansOver(Pilot& pilot, std::size_t velocities,
                                   const std::vector<std::int64_t>& lines,
                                   const std::stop_token& stop) {
  std::vector<RunningMean> means(velocities);
  for (const std::int64_t r : lines) {
    throwIfStopped(stop);
    const std::vector<double> mu = pilot.slide(r);
    for (std::size_t i = 0; i < velocities; ++i) means[i].add(mu[i]);
  }
  return means;
}

/// Returns the root mean square over the velocities of the coarser means' relative errors.
double differenceOf(const std::vector<RunningMean>& low, const std::vector<RunningMean>& high,
                    double remainder) {
  std::vector<double> differences;
  for (std::size_t i = 0; i < high.size(); ++i)
    if (high[i].mean() != 0)
      differences.push_back((low[i].mean() / high[i].mean() - 1) * remainder);
  return differences.empty() ? 0 : rms(differences);
}

/// Returns the relative difference of mean friction between the scene and a finer one over the same
/// lines.
double resolutionDifference(const Scene& scene, const std::vector<double>& velocities,
                            std::int64_t lines, std::int64_t factor, const std::stop_token& stop) {
  Pilot coarse(scene, nullptr, velocities), fine(refined(scene, factor), nullptr, velocities);
  const std::vector<std::int64_t> sampled = sampledLines(coarse.source(), lines);
  const auto low = meansOver(coarse, velocities.size(), sampled, stop);
  const auto high = meansOver(fine, velocities.size(), sampled, stop);
  return differenceOf(low, high, remainder(scene, factor));
}

/// Returns how many times finer the reference line is: 4, or less where memory limits it; 1: none.
std::int64_t measuringFactor(const Scene& scene) {
  const std::int64_t nodes = lineExtent(scene).elements * curvePointsPerElement(scene);
  return std::clamp<std::int64_t>(kMaxMeasuredNodes / nodes, 1, 4);
}

/// Returns the errors from the pilot's lines: the coarse ones give spread and force balance;
/// together with the finer ones they give the resolution.
ErrorBudget errorOf(const PilotPlan& plan, const Profile* profile, Pilot& pilot, double lines,
                    const std::stop_token& stop) {
  const Scene& scene = plan.sample.scene;
  const std::size_t velocities = plan.velocities.size();
  ErrorBudget error;
  const std::vector<std::int64_t> sampled = sampledLines(pilot.source(), plan.lines);
  const std::vector<std::int64_t> refinedLines(sampled.begin(),
                                               sampled.begin() + plan.refinedLines);
  std::vector<std::vector<double>> ofLines(velocities);
  std::vector<RunningMean> means(velocities), coarse(velocities);
  for (const std::int64_t r : sampled) {
    throwIfStopped(stop);
    const std::vector<double> mu = pilot.slide(r);
    for (std::size_t i = 0; i < velocities; ++i) {
      means[i].add(mu[i]);
      ofLines[i].push_back(mu[i]);
      if (means[i].count() <= plan.refinedLines) coarse[i].add(mu[i]);
    }
  }
  error.forceBalance = pilot.largestResidual();
  if (isFrictionless(scene)) return error;
  if (lines > 1) {
    std::vector<double> errors;
    for (std::size_t i = 0; i < velocities; ++i)
      if (means[i].mean() != 0)
        errors.push_back(std::sqrt(varianceOfMean(ofLines[i], pilot.source(), lines)) /
                         means[i].mean());
    if (!errors.empty()) error.standardError = rms(errors);
    if (static_cast<double>(plan.lines) < lines && pilot.isJustComplete()) {
      error.standardError = kNotApplicable;
      error.isStandardErrorUnknown = true;
    }
  }
  Pilot finer(refined(scene, 2), profile, plan.velocities);
  const auto fine = meansOver(finer, velocities, refinedLines, stop);
  const double difference = differenceOf(coarse, fine, remainder(scene, 2));
  (scene.accuracy.scheme == Scheme::Nodal ? error.modelDifference : error.resolution) = difference;
  return error;
}

/// Predicts a run with a target. The run's own pilot is tried with fewer velocities, and with
/// shorter lines where they are long. For a given line the run itself is the pilot, of which a
/// small part is tried.
Prediction predictTarget(const Scene& scene, int threads, const std::stop_token& stop) {
  const PilotPlan pilot = planPilot(scene, threads);
  const bool isAveraged = pilot.run.lines > 1;
  const auto points = static_cast<double>(curvePointsPerElement(scene));
  PilotScene sample =
      isAveraged ? sampleWithin(pilot.run, kOperationsOfTarget, points, kMaxPilot) : pilot.sample;
  sample.scene.accuracy = scene.accuracy;
  sample.scene.sweep.points = isAveraged
                                  ? std::min<std::int64_t>(scene.sweep.points, kTargetVelocities)
                                  : static_cast<std::int64_t>(pilot.velocities.size());
  const double begin = threadSeconds();
  const std::unique_ptr<const Profile> profile = sample.profile();
  const double reading = threadSeconds() - begin;
  const TargetPlan plan = planTarget(sample.scene, stop, profile.get());
  const double longer = pilot.run.elements() / sample.elements();
  const double more =
      static_cast<double>(scene.sweep.points) / static_cast<double>(sample.scene.sweep.points);
  Prediction prediction;
  prediction.threads = threads;
  const double sliding = plan.secondsOfPilot - plan.secondsOfSources +
                         (plan.secondsOfRows + plan.operations * plan.secondsOfOperation) / threads;
  prediction.seconds = longer * (reading + plan.secondsOfSources + more * sliding);
  prediction.lines = plan.mostLines;
  prediction.simulations = plan.simulations * more;
  prediction.error.standardError = plan.standardError;
  prediction.error.resolution = plan.resolutionError;
  prediction.error.forceBalance = plan.largestResidual;
  prediction.memory = curveMemory(pilot.run, threads, plan.finest);
  return prediction;
}

}  // namespace

std::optional<Message> warningOf(const Scene& scene, const Prediction& prediction) {
  if (prediction.error.isStandardErrorUnknown)
    return message(
        "the standard error is not known before the run: most of the lines that were tried "
        "are just in complete contact, where all have the same friction; other lines may not be");
  constexpr double kMany = 1e5;  // lines; a mean over so many of them is rarely meant
  if (!choosesAccuracy(scene) || prediction.lines < kMany) return {};
  const PrintedNumber lines = printed(prediction.lines, 2);
  if (prediction.lines > kMaxLines)
    return message(
        "accuracy.target_relative_error needs about {} lines at one velocity, and at most {} are "
        "computed: the run takes about {} and may miss the target",
        lines, printed(static_cast<double>(kMaxLines)), printed(prediction.seconds, "s", 2));
  return message(
      "accuracy.target_relative_error needs about {} lines at one velocity, and the run takes "
      "about {}; half the error needs four times as many lines",
      lines, printed(prediction.seconds, "s", 2));
}

double ErrorBudget::total() const {
  if (isStandardErrorUnknown) return kNotApplicable;
  double squares = 0;
  for (const double part : {resolution, standardError, forceBalance, timeStep, settling})
    if (std::isfinite(part)) squares += part * part;
  return std::sqrt(squares);
}

Prediction predictCurve(const Scene& scene, int threads, const std::stop_token& stop) {
  if (choosesAccuracy(scene)) return predictTarget(scene, threadCount(threads), stop);
  Prediction prediction;
  prediction.threads = threadCount(threads);
  const PilotPlan plan = planPilot(scene, prediction.threads);
  const double begin = threadSeconds();
  const std::unique_ptr<const Profile> profile = plan.sample.profile();
  const double reading = threadSeconds() - begin;
  // The first transform of a process takes longer than all others, so the second one is timed.
  LineSource(plan.sample.scene, 1, profile.get());
  const double planned = threadSeconds();
  Pilot pilot(plan.sample.scene, profile.get(), plan.velocities);
  const double planning = reading + threadSeconds() - planned;
  const auto lines = static_cast<double>(plan.run.lines);
  prediction.operations = plan.operations;
  prediction.runOperations = plan.runOperations;
  prediction.error = errorOf(plan, profile.get(), pilot, lines, stop);
  const double parallel = std::min(static_cast<double>(prediction.threads), lines);
  prediction.lines = lines;
  prediction.simulations = lines * static_cast<double>(scene.sweep.points);
  double balance = pilot.secondsOfBalance();
  if (!plan.timedVelocities.empty()) {
    Pilot timed(plan.sample.scene, profile.get(), plan.timedVelocities);
    timed.slide(0);  // fills the memory that the next one uses
    timed.slide(lines > 1 ? 1 : 0);
    balance = timed.secondsOfLastBalance();
  }
  const double slower = 1 + kSlowdownOfDoubling * std::log2(plan.shortening);
  const double making = pilot.secondsOfLine() * plan.shortening * slower;
  const double line = making + balance * plan.shortening * static_cast<double>(scene.sweep.points);
  // The first line is slid alone, so that its result appears at once.
  prediction.seconds = planning * plan.shortening * slower + line * (1 + (lines - 1) / parallel);
  prediction.memory = curveMemory(plan.run, prediction.threads, curvePointsPerElement(scene));
  return prediction;
}

ErrorBudget measureError(const Scene& scene, std::int64_t lines, int threads) {
  CurveOptions options;
  options.threads = threads;
  ErrorBudget error;
  std::vector<CurvePoint> points;
  std::map<std::int64_t, std::vector<double>> velocities;  // by the number of points per element
  if (choosesAccuracy(scene)) {
    const TargetCurve result = targetCurve(scene, options);
    error.forceBalance = result.curve.largestResidual;
    points = result.curve.points;
    for (std::size_t i = 0; i < points.size(); ++i)
      velocities[result.achieved[i].oversampling].push_back(points[i].velocity);
  } else {
    const Curve curve = frictionCurve(scene, options);
    error.forceBalance = curve.largestResidual;
    points = curve.points;
    velocities[curvePointsPerElement(scene)] = sweepVelocities(scene.sweep);
  }
  if (isFrictionless(scene)) return error;
  std::vector<double> standard, differences;
  std::int64_t least = lines;
  for (const CurvePoint& point : points) {
    least = std::min(least, point.realizations);
    if (std::isfinite(point.muStandardError) && point.mu != 0)
      standard.push_back(point.muStandardError / point.mu);
  }
  if (!standard.empty()) error.standardError = rms(standard);
  for (const auto& [oversampling, some] : velocities) {
    Scene used = scene;
    if (choosesAccuracy(scene)) used.accuracy = {Scheme::Cubic, oversampling, 0};
    const std::int64_t factor = measuringFactor(used);
    if (factor == 1) continue;
    const double difference = resolutionDifference(used, some, least, factor, {});
    differences.insert(differences.end(), some.size(), difference);
  }
  if (differences.empty()) return error;
  (scene.accuracy.scheme == Scheme::Nodal ? error.modelDifference : error.resolution) =
      rms(differences);
  return error;
}

namespace {

constexpr double kMaxTrial = 0.5;        // s, of one line in all cells
constexpr double kMaxSecondTrial = 0.1;  // s, of one line, where more lines are tried, too

/// A stage of a map on one thread.
struct MapTrial {
  ParameterMap map;
  double seconds = 0;  // of the processor

  double cells() const { return static_cast<double>(map.points.size()); }
};

MapTrial runTrial(MapStage stage, const Scene& scene, const MapAxis& x, const MapAxis& y) {
  const double begin = threadSeconds();
  MapTrial trial{mapStage(stage, scene, x, y, {.threads = 1})};
  trial.seconds = threadSeconds() - begin;
  return trial;
}

}  // namespace

MapCost predictMap(const Scene& scene, const MapAxis& x, const MapAxis& y, int threads) {
  MapCost cost{x.values.size(), y.values.size()};
  cost.threads = threadCount(threads);
  const auto cells = static_cast<double>(cost.columns * cost.rows);
  MapTrial trial = runTrial(MapStage::Coarse, scene, x, y);
  // Which cells are equal is known only where all are tried.
  if (trial.cells() < cells && trial.seconds * cells / trial.cells() < kMaxTrial)
    trial = runTrial(MapStage::OneLine, scene, x, y);
  if (trial.cells() == cells) cost.different = trial.map.computed;
  cost.lines = static_cast<double>(planPilot(scene, cost.threads).run.lines);
  double perLine = trial.seconds * cells / trial.cells();
  double once = 0;  // to find equal states and to gather them, whatever the number of lines is
  if (cost.lines > 1 && trial.cells() == cells && trial.seconds < kMaxSecondTrial) {
    const MapTrial few = runTrial(MapStage::FewLines, scene, x, y);
    const auto more = static_cast<double>(few.map.lines - trial.map.lines);
    perLine = std::clamp((few.seconds - trial.seconds) / more, 0.0, trial.seconds);
    once = trial.seconds - perLine;
  }
  cost.seconds = once + perLine * cost.lines / cost.threads;
  return cost;
}

}  // namespace asperity
