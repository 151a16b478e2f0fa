#include "core/paper/element_curves.h"

#include <cmath>
#include <memory>

#include "core/base/jobs.h"
#include "core/base/stop.h"
#include "core/contact/march/time_march.h"
#include "core/friction/curve_features.h"
#include "core/paper/literal_march.h"
#include "core/surface/line_source.h"

namespace asperity {
namespace {

constexpr std::int64_t kLiteralSteps = 200;

struct Reading {
  double mu = 0, jumpFraction = 0;
};

/// The lines of a scene, with one element at each node, and the marches over them.
class Marches {
 public:
  Marches(const Scene& scene, std::int64_t lines, const StateOptions& options)
      : options_(options), jobs_(options.threads) {
    const LineSource source(scene, 1);
    rmsSlope_ = source.statistics().rmsSlope;
    for (std::int64_t r = 0; r < lines; ++r)
      lines_.push_back(std::make_shared<const Line>(source.make(r)));
  }

  /// Calls read(line) for each line, several at a time.
  template <class Read>
  ElementPoint point(double velocity, const Read& read) {
    std::vector<Reading> readings(lines_.size());
    jobs_.run(static_cast<std::int64_t>(lines_.size()), [&](std::int64_t r) {
      const auto index = static_cast<std::size_t>(r);
      if (!options_.stop.stop_requested()) readings[index] = read(lines_[index]);
    });
    throwIfStopped(options_.stop);
    ElementPoint point{velocity};
    for (const Reading& reading : readings) {
      point.normalizedMu.push_back(reading.mu / rmsSlope_);
      point.jumpFraction += reading.jumpFraction / static_cast<double>(readings.size());
    }
    return point;
  }

  void report(std::size_t done, std::size_t total) const {
    if (options_.progress)
      options_.progress(static_cast<double>(done) / static_cast<double>(total));
  }

 private:
  const StateOptions& options_;
  Jobs jobs_;
  double rmsSlope_ = 0;
  std::vector<std::shared_ptr<const Line>> lines_;
};

/// The beginning of a march: depths at the line's nodes, and the indentation.
struct Start {
  std::vector<double> depth;  // m
  double indentation = 0;     // m
  double lowest = 0;          // m, height of the line's lowest point
};

Start steadyStart(const Line& line, Scheme scheme, const SlidingConditions& conditions,
                  double force) {
  const PreparedProfile profile = prepareProfile(line, scheme);
  const SteadyResult steady = slideAtForce(profile, conditions, force);
  const NodeShape shape = shapeAt(profile, conditions, steady.indentation);
  return {inLineOrder(profile, shape.depth), steady.indentation, profile.lowestHeight};
}

Reading literal(const Line& line, const Scene& scene, double velocity) {
  const SlidingConditions conditions = slidingConditions(scene, velocity);
  const double force = scene.load.normalForce;
  const Start start = steadyStart(line, Scheme::Nodal, conditions, force);
  LiteralOptions march;
  for (const LiteralVectors vectors : {LiteralVectors::Avx2, LiteralVectors::Avx512})
    if (isSupported(vectors)) march.vectors = vectors;
  march.steps = kLiteralSteps;
  march.startDepth = start.depth;
  march.startIndentation = start.indentation;
  const LiteralResult result = literalMarch(line, conditions, force, march);
  return {result.mu, result.jumpFraction};
}

Reading fineSteps(const std::shared_ptr<const Line>& line, const Scene& scene, double velocity,
                  std::int64_t perSpacing, const FineSteps& steps) {
  const double force = scene.load.normalForce;
  const Start start = steadyStart(*line, Scheme::Cubic, slidingConditions(scene, velocity), force);
  TimeMarch march(line, start.lowest, elementLaw(scene.elastomer));
  march.setState(start.depth, start.indentation);
  const MarchLoad load{LoadKind::Force, force, 0};
  const double advance = line->spacing / static_cast<double>(perSpacing);
  double work = 0;
  for (std::int64_t k = 0; k < steps.spacings * perSpacing; ++k) {
    const MarchStep step = march.step(load, advance / velocity, advance);
    if (k >= (steps.spacings - steps.averaged) * perSpacing) work += step.lineWork;
  }
  return {work / (force * static_cast<double>(steps.averaged) * line->spacing), 0};
}

/// Returns the mean over the lines of |a - b| / b.
double relativeChange(const ElementPoint& a, const ElementPoint& b) {
  double sum = 0;
  for (std::size_t r = 0; r < b.normalizedMu.size(); ++r)
    sum += std::abs(a.normalizedMu[r] / b.normalizedMu[r] - 1);
  return sum / static_cast<double>(b.normalizedMu.size());
}

}  // namespace

double ElementPoint::mean(int leftOut) const {
  double sum = 0;
  int count = 0;
  for (std::size_t r = 0; r < normalizedMu.size(); ++r) {
    if (static_cast<int>(r) == leftOut) continue;
    sum += normalizedMu[r];
    ++count;
  }
  return sum / count;
}

Estimate ElementPoint::estimate() const {
  return jackknife(static_cast<int>(normalizedMu.size()), [this](int out) { return mean(out); });
}

Estimate exponentFrom(std::span<const ElementPoint> points, double velocity) {
  std::vector<ElementPoint> fitted;
  for (const ElementPoint& point : points)
    if (point.velocity * (1 + 1e-9) >= velocity) fitted.push_back(point);
  if (fitted.size() < 2) return {};
  return jackknife(static_cast<int>(fitted.front().normalizedMu.size()), [&](int out) {
    std::vector<double> velocities, mu;
    for (const ElementPoint& point : fitted) {
      velocities.push_back(point.velocity);
      mu.push_back(point.mean(out));
    }
    return fitPower(velocities, mu).slope;
  });
}

std::vector<ElementPoint> literalCurve(const Scene& scene, std::span<const double> velocities,
                                       std::int64_t lines, const StateOptions& options) {
  Marches marches(scene, lines, options);
  std::vector<ElementPoint> points;
  for (const double velocity : velocities) {
    points.push_back(marches.point(velocity, [&](const std::shared_ptr<const Line>& line) {
      return literal(*line, scene, velocity);
    }));
    marches.report(points.size(), velocities.size());
  }
  return points;
}

std::vector<ElementPoint> fineStepCurve(const Scene& scene, std::span<const double> velocities,
                                        std::int64_t lines, const FineSteps& steps,
                                        const StateOptions& options) {
  Marches marches(scene, lines, options);
  const auto computePoint = [&](double velocity, std::int64_t perSpacing) {
    ElementPoint point = marches.point(velocity, [&](const std::shared_ptr<const Line>& line) {
      return fineSteps(line, scene, velocity, perSpacing, steps);
    });
    point.stepsPerSpacing = perSpacing;
    return point;
  };
  std::vector<ElementPoint> points;
  std::int64_t perSpacing = steps.first;  // faster sliding never needs fewer
  for (const double velocity : velocities) {
    ElementPoint coarse = computePoint(velocity, perSpacing);
    ElementPoint fine = computePoint(velocity, 2 * perSpacing);
    while (relativeChange(coarse, fine) > steps.tolerance && 4 * perSpacing <= steps.most) {
      perSpacing *= 2;
      coarse = std::move(fine);
      fine = computePoint(velocity, 2 * perSpacing);
    }
    if (relativeChange(coarse, fine) > steps.tolerance) break;
    points.push_back(std::move(fine));
    marches.report(points.size(), velocities.size());
  }
  marches.report(velocities.size(), velocities.size());
  return points;
}

}  // namespace asperity
