#include "core/accuracy/work_precision.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/jobs.h"
#include "core/base/statistics.h"
#include "core/base/stop.h"
#include "core/contact/steady_sliding.h"
#include "core/contact/steady_solver.h"
#include "core/friction/curve_features.h"
#include "core/friction/ensemble.h"
#include "core/material/element_law.h"
#include "core/paper/literal_march.h"
#include "core/surface/line_source.h"

namespace asperity {
namespace {

constexpr std::size_t kVelocities = 8;  // per region: as many as fill a vector
constexpr std::int64_t kMaxDiagramNodes = std::int64_t{1} << 22;
// points per element of the reference, also used doubled
constexpr std::int64_t kReference = 32;
constexpr std::int64_t kLongestMarch = 20000;  // elements; a part of a longer march is timed
constexpr std::int64_t kTimedSteps = 50;       // of a longer march that are timed
constexpr std::int64_t kLinesOfMarch = 2;
constexpr std::int64_t kMaxLinesOfSpread = 512;

/// Adds median and quartiles of repeated runs (s).
void addSeconds(WorkPrecisionPoint& point, std::vector<double> seconds) {
  std::ranges::sort(seconds);
  point.seconds = quantile(seconds, 0.5);
  point.lowerQuartile = quantile(seconds, 0.25);
  point.upperQuartile = quantile(seconds, 0.75);
}

/// All lines at one resolution, prepared for sliding.
struct Prepared {
  Scene scene;  // with the scheme of the method
  std::vector<PreparedProfile> lines;
  double lineSeconds = 0;
};

Prepared prepare(const Scene& scene, const MethodChoice& choice, std::int64_t lines) {
  Prepared prepared{scene, {}, 0};
  prepared.scene.accuracy.targetRelativeError = 0;
  prepared.scene.accuracy.oversampling = choice.oversampling;
  prepared.scene.accuracy.scheme = choice.method == Method::Nodal    ? Scheme::Nodal
                                   : choice.method == Method::Linear ? Scheme::Linear
                                                                     : Scheme::Cubic;
  const LineSource source(prepared.scene, choice.oversampling);
  Line line;
  source.makeInto(line, 0);  // the first one plans the transform
  std::vector<double> seconds;
  for (std::int64_t r = 0; r < lines; ++r) {
    const double start = threadSeconds();
    source.makeInto(line, r);
    prepared.lines.push_back(prepareProfile(line, prepared.scene.accuracy.scheme));
    seconds.push_back(threadSeconds() - start);
  }
  prepared.lineSeconds = median(seconds);
  return prepared;
}

/// Returns mu of every line and velocity: [line * velocities + i].
std::vector<double> slideAll(const Prepared& prepared, const std::vector<double>& velocities) {
  const SteadySolver sliding(prepared.scene);
  std::vector<double> mu;
  std::vector<SteadyResult> row(velocities.size());
  for (const PreparedProfile& line : prepared.lines) {
    sliding.sweep(line, prepared.scene.load, velocities, row);
    for (std::size_t i = 0; i < row.size(); ++i) {
      requireBalance(row[i], velocities[i]);
      mu.push_back(row[i].mu);
    }
  }
  return mu;
}

struct Errors {
  double rms = 0, largest = 0;
};

Errors errorsOf(const std::vector<double>& mu, const std::vector<double>& reference) {
  Errors errors;
  double squares = 0;
  for (std::size_t k = 0; k < mu.size(); ++k) {
    const double error = std::abs(mu[k] / reference[k] - 1);
    squares += error * error;
    errors.largest = std::max(errors.largest, error);
  }
  errors.rms = std::sqrt(squares / static_cast<double>(mu.size()));
  return errors;
}

class Comparison {
 public:
  Comparison(const Scene& scene, const WorkPrecisionOptions& options)
      : scene_(scene), options_(options), source_(scene, 1) {
    lines_ = std::min(options.lines, source_.lines());
    if (source_.elements() * 2 * kReference > kMaxDiagramNodes) lines_ = 1;
    for (const MethodChoice& choice : allMethods())
      if (isPossible(choice)) choices_.push_back(choice);
  }

  WorkPrecision run() {
    WorkPrecision result{scene_, presentChoice(), lines_, {}};
    const std::vector<CurveRegion> regions = regionsOfSweep();
    for (const CurveRegion& region : regions)
      result.regions.push_back({region.name, velocitiesOf(region), 0, {}, {}, {}});
    total_ = static_cast<double>(regions.size()) * (static_cast<double>(choices_.size()) + 3);
    for (const MethodChoice& choice : choices_)
      if (choice.method != Method::Literal) prepared_.push_back(prepare(scene_, choice, lines_));
    for (RegionPrecision& region : result.regions) compare(region);
    return result;
  }

 private:
  bool isPossible(const MethodChoice& choice) const {
    if (source_.elements() * choice.oversampling > kMaxDiagramNodes) return false;
    if (elementLaw(scene_.elastomer).kind() == ElementKind::Arms)
      return choice.method == Method::Cubic;
    if (choice.method == Method::Literal)
      return scene_.load.kind != LoadKind::Indentation &&
             elementLaw(scene_.elastomer).kind() == ElementKind::Kelvin;
    return true;
  }

  MethodChoice presentChoice() const {
    switch (scene_.accuracy.scheme) {
      case Scheme::Nodal:
        return {Method::Nodal, 1};
      case Scheme::Linear:
        return {Method::Linear, curvePointsPerElement(scene_)};
      case Scheme::Cubic:
        break;
    }
    return {Method::Cubic, curvePointsPerElement(scene_)};
  }

  void step(double cost = 1) {
    throwIfStopped(options_.stop);
    done_ += cost;
    if (options_.progress) options_.progress(std::min(1.0, done_ / total_));
  }

  /// Returns the regions of a curve over few lines; the whole sweep where it has no regions.
  std::vector<CurveRegion> regionsOfSweep() const {
    Scene scene = scene_;
    scene.accuracy = {};
    scene.ensemble.realizations = std::min<std::int64_t>(20, scene.ensemble.realizations);
    scene.sweep.points = std::max<std::int64_t>(scene.sweep.points, 33);
    CurveOptions options;
    options.stop = options_.stop;
    const Curve curve = frictionCurve(scene, options);
    if (!curve.isComplete) throw StopRequested{};
    std::vector<double> velocities, mu;
    for (const CurvePoint& point : curve.points)
      if (point.mu > 0) {
        velocities.push_back(point.velocity);
        mu.push_back(point.mu);
      }
    if (velocities.size() < 3) return {{"all", scene.sweep.velocityFrom, scene.sweep.velocityTo}};
    return regionsWithin(regionBorders(velocities, mu), velocities.front(), velocities.back());
  }

  /// Returns velocities with equal logarithmic spacing in the middle of the region, over at most
  /// two decades.
  static std::vector<double> velocitiesOf(const CurveRegion& region) {
    const double middle = std::sqrt(region.from * region.to);
    const double half = std::min(10.0, std::pow(region.to / region.from, 0.4));
    return logSpaced(middle / half, middle * half, kVelocities);
  }

  void compare(RegionPrecision& region) {
    const std::vector<double> reference = referenceOf(region);
    step(2);
    std::vector<std::vector<double>> seconds(prepared_.size());
    // Methods take turns, so that a load of the machine affects all of them.
    for (int repeat = 0; repeat < options_.repeats; ++repeat)
      for (std::size_t k = 0; k < prepared_.size(); ++k) {
        const double start = threadSeconds();
        const std::vector<double> mu = slideAll(prepared_[k], region.velocities);
        seconds[k].push_back((threadSeconds() - start) / static_cast<double>(mu.size()));
        throwIfStopped(options_.stop);
      }
    std::size_t next = 0;
    for (const MethodChoice& choice : choices_) {
      if (choice.method == Method::Literal) {
        region.points.push_back(march(region, reference));
      } else {
        region.points.push_back(point(choice, prepared_[next], seconds[next], region, reference));
        ++next;
      }
      step();
    }
    for (WorkPrecisionPoint& point : region.points)
      point.secondsWithLine =
          point.seconds + point.lineSeconds / static_cast<double>(scene_.sweep.points);
    markFront(region.points);
    addSpread(region);
    step();
  }

  std::vector<double> referenceOf(RegionPrecision& region) const {
    std::int64_t finest = kReference;
    while (finest > 2 && source_.elements() * 2 * finest > 2 * kMaxDiagramNodes) finest /= 2;
    const std::vector<double> low =
        slideAll(prepare(scene_, {Method::Cubic, finest}, lines_), region.velocities);
    std::vector<double> high =
        slideAll(prepare(scene_, {Method::Cubic, 2 * finest}, lines_), region.velocities);
    double squares = 0;
    for (std::size_t k = 0; k < high.size(); ++k) {
      const double correction = (high[k] - low[k]) / 15;  // fourth order
      squares += correction * correction / (high[k] * high[k]);
      high[k] += correction;
    }
    region.referenceError = std::sqrt(squares / static_cast<double>(high.size()));
    return high;
  }

  WorkPrecisionPoint point(const MethodChoice& choice, const Prepared& prepared,
                           const std::vector<double>& seconds, const RegionPrecision& region,
                           const std::vector<double>& reference) const {
    const Errors errors = errorsOf(slideAll(prepared, region.velocities), reference);
    WorkPrecisionPoint point{choice, errors.rms, errors.largest, choice.method == Method::Nodal};
    addSeconds(point, seconds);
    point.lineSeconds = prepared.lineSeconds;
    return point;
  }

  /// Runs the literal march on some of the lines and two of the velocities.
  WorkPrecisionPoint march(const RegionPrecision& region,
                           const std::vector<double>& reference) const {
    WorkPrecisionPoint point{{Method::Literal, 1}, 0, 0, true};
    LiteralOptions options;
    point.isExtrapolated = source_.elements() > kLongestMarch;
    if (point.isExtrapolated) options.steps = kTimedSteps;
    std::vector<double> seconds, lineSeconds, found, expected;
    Line line;
    for (std::int64_t r = 0; r < std::min(lines_, kLinesOfMarch); ++r) {
      const double start = threadSeconds();
      source_.makeInto(line, r);
      lineSeconds.push_back(threadSeconds() - start);
      for (const std::size_t i : {std::size_t{1}, kVelocities - 2}) {
        const double begin = threadSeconds();
        const LiteralResult result =
            literalMarch(line, slidingConditions(scene_, region.velocities[i]),
                         loadOn(scene_.load, source_.length()).normalForce, options);
        const double share = static_cast<double>(source_.elements()) /
                             static_cast<double>(std::max<std::int64_t>(1, result.steps));
        seconds.push_back((threadSeconds() - begin) * share);
        found.push_back(result.mu);
        expected.push_back(reference[static_cast<std::size_t>(r) * kVelocities + i]);
      }
    }
    const Errors errors = errorsOf(found, expected);
    point.error = point.isExtrapolated ? kNotApplicable : errors.rms;
    point.largest = point.isExtrapolated ? kNotApplicable : errors.largest;
    addSeconds(point, std::move(seconds));
    point.lineSeconds = median(lineSeconds);
    return point;
  }

  static void markFront(std::vector<WorkPrecisionPoint>& points) {
    for (WorkPrecisionPoint& point : points)
      point.isOnFront =
          !point.isDifference &&
          std::none_of(points.begin(), points.end(), [&](const WorkPrecisionPoint& other) {
            return !other.isDifference && other.secondsWithLine < point.secondsWithLine &&
                   other.error < point.error;
          });
  }

  /// Adds the standard error of the mean over n lines, from the spread of means over groups of n.
  void addSpread(RegionPrecision& region) const {
    if (!source_.isRandom()) return;
    Scene scene = scene_;
    scene.accuracy.targetRelativeError = 0;
    scene.accuracy.oversampling = curvePointsPerElement(scene_);
    const LineSource source(scene, curvePointsPerElement(scene));
    const SteadySolver sliding(scene);
    const std::vector<double> velocity{region.middleVelocity()};
    const std::int64_t count =
        std::min({kMaxLinesOfSpread, std::max<std::int64_t>(scene.ensemble.realizations, 64),
                  std::max<std::int64_t>(16, kMaxDiagramNodes * 4 / source.elements())});
    std::vector<double> mu;
    Line line;
    PreparedProfile profile;
    std::vector<SteadyResult> row(1);
    RunningMean all;
    for (std::int64_t r = 0; r < count; ++r) {
      throwIfStopped(options_.stop);
      source.makeInto(line, r);
      prepareProfileInto(profile, line, scene.accuracy.scheme);
      sliding.sweep(profile, scene.load, velocity, row);
      mu.push_back(row[0].mu);
      all.add(row[0].mu);
    }
    constexpr std::size_t kMinGroups = 16;
    for (std::size_t group = 1; mu.size() / group >= kMinGroups; group *= 2) {
      RunningMean means;
      for (std::size_t first = 0; first + group <= mu.size(); first += group) {
        RunningMean mean;
        for (std::size_t k = first; k < first + group; ++k) mean.add(mu[k]);
        means.add(mean.mean());
      }
      region.lineCounts.push_back(static_cast<std::int64_t>(group));
      region.standardErrors.push_back(std::sqrt(means.variance()) / all.mean());
    }
  }

  Scene scene_;
  const WorkPrecisionOptions& options_;
  LineSource source_;
  std::int64_t lines_ = 1;
  std::vector<MethodChoice> choices_;
  std::vector<Prepared> prepared_;  // for all choices except for the literal one, in their order
  double done_ = 0, total_ = 1;
};

}  // namespace

std::string_view methodWord(Method method) {
  constexpr std::array<std::string_view, 4> kWords{"literal march", "nodal", "linear", "cubic"};
  return kWords[static_cast<std::size_t>(method)];
}

std::string methodName(const MethodChoice& choice) {
  const std::string_view word = methodWord(choice.method);
  const bool isResolved = choice.method == Method::Linear || choice.method == Method::Cubic;
  return isResolved ? fmt::format("{} x{}", word, choice.oversampling) : std::string(word);
}

std::vector<MethodChoice> allMethods() {
  std::vector<MethodChoice> choices{{Method::Literal, 1}, {Method::Nodal, 1}};
  for (const Method method : {Method::Linear, Method::Cubic})
    for (const std::int64_t oversampling : {1, 2, 4, 8, 16})
      choices.push_back({method, oversampling});
  return choices;
}

WorkPrecision workPrecision(const Scene& scene, const WorkPrecisionOptions& options) {
  return Comparison(scene, options).run();
}

}  // namespace asperity
