#include "core/friction/ensemble.h"

#include <algorithm>
#include <cmath>

#include "core/contact/steady_sliding.h"
#include "core/friction/law.h"
#include "core/friction/realizations.h"
#include "core/friction/running_mean.h"
#include "core/surface/line_source.h"

namespace asperity {
namespace {

struct VelocityAverage {
  RunningMean mu, contactFraction, rmsSlopeContact, indentation, normalForce;
};

class Averaging {
 public:
  Averaging(const Scene& scene, const CurveOptions& options)
      : scene_(scene),
        options_(options),
        source_(scene, pointsPerElement(scene)),
        velocities_(sweepVelocities(scene.sweep)),
        total_(source_.isRandom() ? scene.ensemble.realizations : 1),
        averages_(velocities_.size()) {}

  Curve run() {
    const LoadCase sweep{scene_.load, velocities_};
    const RealizationTask task{scene_, source_, {&sweep, 1}, 0};
    curve_.isComplete = slideRealizations(
        task, total_, options_.threads, options_.stop,
        [this](std::span<const SteadyResult> row) { add(row); },
        [this](std::int64_t done) { report(done); });
    curve_.points = points();
    const auto solves = std::max(1.0, static_cast<double>(solves_));
    curve_.meanPasses = static_cast<double>(passes_) / solves;
    curve_.marginalFraction = static_cast<double>(marginal_) / solves;
    return curve_;
  }

 private:
  void add(std::span<const SteadyResult> row) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      // Pressed by nothing there is no coefficient; what is averaged is counted.
      if (std::isfinite(row[i].mu)) averages_[i].mu.add(row[i].mu);
      averages_[i].contactFraction.add(row[i].contactFraction);
      averages_[i].indentation.add(row[i].indentation);
      averages_[i].normalForce.add(row[i].normalForce);
      if (std::isfinite(row[i].rmsSlopeContact))
        averages_[i].rmsSlopeContact.add(row[i].rmsSlopeContact);
      curve_.largestResidual = std::max(curve_.largestResidual, row[i].residual);
      passes_ += row[i].passes;
      marginal_ += row[i].marginalShare < 1 ? 1 : 0;
      ++solves_;
    }
  }

  void report(std::int64_t done) const {
    if (options_.progress) options_.progress({done, total_, points()});
  }

  std::vector<CurvePoint> points() const {
    std::vector<CurvePoint> points;
    for (std::size_t i = 0; i < velocities_.size(); ++i)
      points.push_back(point(velocities_[i], averages_[i]));
    return points;
  }

  CurvePoint point(double velocity, const VelocityAverage& average) const {
    CurvePoint point;
    point.velocity = velocity;
    point.mu = average.mu.mean();
    point.muStandardError = average.mu.standardError();
    point.contactFraction = average.contactFraction.mean();
    point.rmsSlopeContact = average.rmsSlopeContact.mean();
    point.indentation = average.indentation.mean();
    point.realizations = average.mu.count();
    addLaw(point, scene_.load.kind == LoadKind::Force ? scene_.load.normalForce
                                                      : average.normalForce.mean());
    return point;
  }

  void addLaw(CurvePoint& point, double normalForce) const {
    const LineStatistics& line = source_.statistics();
    const SlidingConditions conditions = conditionsOf(scene_, point.velocity);
    const LawInput in{
        conditions.shearModulus, conditions.relaxationTime, source_.length(), line.rmsHeight,
        line.rmsSlope,           scene_.surface.hurst,      normalForce,      point.velocity};
    if (!(line.rmsHeight > 0)) return;
    point.normalizedMu = point.mu / line.rmsSlope;
    point.dimensionlessVelocity = dimensionlessVelocity(in);
    point.dimensionlessForce = dimensionlessForce(in);
    if (source_.isRandom()) point.muLaw = frictionLaw(in);
  }

  const Scene& scene_;
  const CurveOptions& options_;
  LineSource source_;
  std::vector<double> velocities_;
  std::int64_t total_;
  std::vector<VelocityAverage> averages_;
  Curve curve_;
  std::int64_t solves_ = 0, passes_ = 0, marginal_ = 0;
};

}  // namespace

std::vector<double> logSpaced(double from, double to, std::int64_t points) {
  std::vector<double> values;
  for (std::int64_t i = 0; i < points; ++i) {
    const double part = points > 1 ? static_cast<double>(i) / static_cast<double>(points - 1) : 0;
    values.push_back(from * std::pow(to / from, part));
  }
  if (points > 1) values.back() = to;
  return values;
}

std::vector<double> sweepVelocities(const Sweep& sweep) {
  return logSpaced(sweep.velocityFrom, sweep.velocityTo, sweep.points);
}

Curve frictionCurve(const Scene& scene, const CurveOptions& options) {
  return Averaging(scene, options).run();
}

}  // namespace asperity
