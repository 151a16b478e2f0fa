#include "core/accuracy/prediction.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <thread>

#include "core/accuracy/processor_time.h"
#include "core/accuracy/target_curve.h"
#include "core/contact/scene_sliding.h"
#include "core/friction/ensemble.h"
#include "core/friction/running_mean.h"
#include "core/friction/study.h"
#include "core/surface/line_source.h"

namespace asperity {
namespace {

constexpr std::int64_t kErrorLines = 24;  // the spread of so many is known to 15 %
constexpr std::int64_t kTimedLines = 3;
constexpr std::int64_t kRefinedLines = 12;
constexpr std::int64_t kErrorVelocities = 9;
constexpr std::int64_t kMostMeasuredNodes = std::int64_t{1} << 26;  // of the line measured against

/// One resolution of a scene's lines: slides them and takes the time.
class Pilot {
 public:
  Pilot(const Scene& scene, std::vector<double> velocities)
      : scene_(scene),
        source_(scene, pointsPerElement(scene)),
        sliding_(scene),
        velocities_(std::move(velocities)),
        row_(velocities_.size()) {}

  /// mu at each velocity.
  std::vector<double> slide(std::int64_t realization) {
    source_.makeInto(line_, realization);
    prepareTravelInto(travel_, line_, scene_.accuracy.scheme);
    sliding_.sweep(travel_, scene_.load, velocities_, row_);
    std::vector<double> mu;
    for (const SteadyResult& result : row_) {
      mu.push_back(result.mu);
      residual_ = std::max(residual_, result.residual);
    }
    return mu;
  }

  bool isRandom() const { return source_.isRandom(); }
  double largestResidual() const { return residual_; }
  double memoryOfLine() const {
    double bytes = 0;
    for (const auto* values : {&line_.height, &line_.slopeAfter, &line_.slopeBefore, &travel_.rise,
                               &travel_.slopeIn, &travel_.slopeOut})
      bytes += static_cast<double>(values->capacity() * sizeof(double));
    for (const BlockLevel& level : travel_.blocks)
      bytes += static_cast<double>(level.size() * sizeof(SegmentBounds));
    return bytes;
  }

 private:
  Scene scene_;
  LineSource source_;
  SceneSliding sliding_;
  std::vector<double> velocities_;
  std::vector<SteadyResult> row_;
  Line line_;
  TravelLine travel_;
  double residual_ = 0;
};

void throwIfStopped(const std::stop_token& stop) {
  if (stop.stop_requested()) throw StudyStopped{};
}

/// The scene on another resolution; its own where that is none.
Scene refined(const Scene& scene, std::int64_t factor) {
  Scene fine = scene;
  fine.accuracy = {scene.accuracy.scheme == Scheme::Linear ? Scheme::Linear : Scheme::Cubic,
                   scene.accuracy.scheme == Scheme::Nodal ? 4 : factor * pointsPerElement(scene),
                   0};
  return fine;
}

/// What is left of the error at `factor` times the points, to be added again.
double remainder(const Scene& scene, std::int64_t factor) {
  if (scene.accuracy.scheme == Scheme::Nodal) return 1;
  const double order = scene.accuracy.scheme == Scheme::Linear ? 2 : 4;
  return 1 / (1 - std::pow(static_cast<double>(factor), -order));
}

double rms(const std::vector<double>& values) {
  double squares = 0;
  for (const double value : values) squares += value * value;
  return std::sqrt(squares / static_cast<double>(values.size()));
}

/// Means of mu at each velocity over the first `lines` lines.
std::vector<RunningMean> meansOver(Pilot& pilot, std::size_t velocities, std::int64_t lines,
                                   const std::stop_token& stop) {
  std::vector<RunningMean> means(velocities);
  for (std::int64_t r = 0; r < lines; ++r) {
    throwIfStopped(stop);
    const std::vector<double> mu = pilot.slide(r);
    for (std::size_t i = 0; i < velocities; ++i) means[i].add(mu[i]);
  }
  return means;
}

/// Relative difference of mean friction between the scene and a finer one over the same lines.
double resolutionDifference(const Scene& scene, const std::vector<double>& velocities,
                            std::int64_t lines, std::int64_t factor, const std::stop_token& stop) {
  Pilot coarse(scene, velocities), fine(refined(scene, factor), velocities);
  const auto low = meansOver(coarse, velocities.size(), lines, stop);
  const auto high = meansOver(fine, velocities.size(), lines, stop);
  std::vector<double> differences;
  for (std::size_t i = 0; i < velocities.size(); ++i)
    if (high[i].mean() != 0)
      differences.push_back((low[i].mean() / high[i].mean() - 1) * remainder(scene, factor));
  return differences.empty() ? 0 : rms(differences);
}

/// How many times finer the line is that an error is measured against: 4, or what memory allows; 1:
/// nothing finer.
std::int64_t measuringFactor(const Scene& scene) {
  const std::int64_t nodes = LineSource(scene, 1).elements() * pointsPerElement(scene);
  return std::clamp<std::int64_t>(kMostMeasuredNodes / nodes, 1, 4);
}

struct LineSeconds {
  double first;  // with what is planned once
  double later;
};

LineSeconds secondsOfLine(const Scene& scene, const std::stop_token& stop) {
  const double begin = threadSeconds();
  Pilot pilot(scene, sweepVelocities(scene.sweep));
  pilot.slide(0);
  const double first = threadSeconds() - begin;
  std::vector<double> seconds;
  for (std::int64_t r = 1; r <= kTimedLines; ++r) {
    throwIfStopped(stop);
    const double start = threadSeconds();
    pilot.slide(pilot.isRandom() ? r : 0);
    seconds.push_back(threadSeconds() - start);
  }
  std::sort(seconds.begin(), seconds.end());
  return {first, seconds[seconds.size() / 2]};
}

int threadsOf(int threads) {
  return threads > 0 ? threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

ErrorBudget errorOf(const Scene& scene, Pilot& pilot, const std::vector<double>& velocities,
                    std::int64_t lines, std::int64_t pilotLines, const std::stop_token& stop) {
  ErrorBudget error;
  const auto means = meansOver(pilot, velocities.size(), pilotLines, stop);
  error.forceBalance = pilot.largestResidual();
  if (isFrictionless(scene)) return error;
  if (lines > 1) {
    std::vector<double> errors;
    for (const RunningMean& mean : means)
      if (mean.mean() != 0)
        errors.push_back(std::sqrt(mean.variance() / static_cast<double>(lines)) / mean.mean());
    if (!errors.empty()) error.standardError = rms(errors);
  }
  const double difference =
      resolutionDifference(scene, velocities, std::min(kRefinedLines, pilotLines), 2, stop);
  (scene.accuracy.scheme == Scheme::Nodal ? error.modelDifference : error.resolution) = difference;
  return error;
}

Prediction predictTarget(const Scene& scene, int threads, const std::stop_token& stop) {
  const TargetPlan plan = planTarget(scene, stop);
  Prediction prediction;
  prediction.threads = threads;
  prediction.seconds = plan.secondsOfPilot +
                       plan.operations * plan.secondsOfOperation / static_cast<double>(threads);
  prediction.lines = plan.mostLines;
  prediction.simulations = plan.simulations;
  prediction.pilotLines = kPilotLines;
  prediction.error.standardError = plan.standardError;
  prediction.error.resolution = plan.resolutionError;
  prediction.error.forceBalance = plan.largestResidual;
  Pilot finest(refined(scene, 1), {scene.sweep.velocityFrom});
  finest.slide(0);
  prediction.memory = finest.memoryOfLine() * static_cast<double>(threads);
  return prediction;
}

}  // namespace

double ErrorBudget::total() const {
  double squares = 0;
  for (const double part : {resolution, standardError, forceBalance, timeStep, settling})
    if (std::isfinite(part)) squares += part * part;
  return std::sqrt(squares);
}

Prediction predictCurve(const Scene& scene, int threads, const std::stop_token& stop) {
  if (choosesAccuracy(scene)) return predictTarget(scene, threadsOf(threads), stop);
  Prediction prediction;
  prediction.threads = threadsOf(threads);
  const std::vector<double> velocities = logSpaced(scene.sweep.velocityFrom, scene.sweep.velocityTo,
                                                   std::min(scene.sweep.points, kErrorVelocities));
  Pilot pilot(scene, velocities);
  const std::int64_t lines = pilot.isRandom() ? scene.ensemble.realizations : 1;
  prediction.pilotLines = std::min(lines, kErrorLines);
  prediction.error = errorOf(scene, pilot, velocities, lines, prediction.pilotLines, stop);
  const double parallel =
      std::min(static_cast<double>(prediction.threads), static_cast<double>(lines));
  prediction.lines = static_cast<double>(lines);
  prediction.simulations = static_cast<double>(lines * scene.sweep.points);
  // The first line is slid alone; it is to be seen at once.
  const LineSeconds line = secondsOfLine(scene, stop);
  prediction.seconds = line.first + line.later * static_cast<double>(lines - 1) / parallel;
  // Results of a batch of 32 lines wait for their turn.
  prediction.memory = pilot.memoryOfLine() * parallel +
                      static_cast<double>(std::min<std::int64_t>(lines, 32) * scene.sweep.points) *
                          sizeof(SteadyResult);
  return prediction;
}

ErrorBudget measureError(const Scene& scene, std::int64_t lines, int threads) {
  CurveOptions options;
  options.threads = threads;
  ErrorBudget error;
  std::vector<CurvePoint> points;
  std::map<std::int64_t, std::vector<double>> velocities;  // by the points per element used
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
    velocities[pointsPerElement(scene)] = sweepVelocities(scene.sweep);
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

}  // namespace asperity
