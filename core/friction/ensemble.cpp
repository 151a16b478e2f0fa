#include "core/friction/ensemble.h"

#include <algorithm>
#include <cmath>

#include "core/friction/curve_averages.h"
#include "core/friction/realizations.h"
#include "core/scene/plan.h"
#include "core/surface/line_source.h"

namespace asperity {
namespace {

class Averaging {
 public:
  Averaging(const Scene& scene, const CurveOptions& options)
      : scene_(scene),
        options_(options),
        source_(scene, pointsPerElementOfCurve(scene)),
        velocities_(sweepVelocities(scene.sweep)),
        total_(source_.isRandom() ? scene.ensemble.realizations : 1),
        columns_(scene, source_),
        averages_(velocities_.size()) {}

  Curve run() {
    countStage(Stage::Line);
    if (total_ > 1) countStage(Stage::Averaging);
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
      averages_[i].add(row[i]);
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
    for (std::size_t i = 0; i < velocities_.size(); ++i) {
      points.push_back(averages_[i].point(velocities_[i]));
      columns_.addTo(points.back(), averages_[i]);
    }
    return points;
  }

  const Scene& scene_;
  const CurveOptions& options_;
  LineSource source_;
  std::vector<double> velocities_;
  std::int64_t total_;
  LawColumns columns_;
  std::vector<CurveAverages> averages_;
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
