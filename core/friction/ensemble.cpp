#include "core/friction/ensemble.h"

#include <algorithm>

#include "core/contact/force_balance.h"
#include "core/contact/steady_solver.h"
#include "core/friction/realizations.h"
#include "core/surface/line_source.h"

namespace asperity {
namespace {

class Averaging {
 public:
  Averaging(const Scene& scene, const CurveOptions& options)
      : scene_(scene),
        options_(options),
        source_(scene, curvePointsPerElement(scene)),
        velocities_(velocitiesOfCurve(scene.sweep, options)),
        total_(source_.lines()),
        columns_(scene, source_),
        averages_(velocities_.size(), CurveAverages(source_.orderedRows())) {}

  Curve run() {
    countStage(Stage::Line);
    if (total_ > 1) countStage(Stage::Averaging);
    const LoadCase sweep{scene_.load, velocities_};
    const RealizationPart part{scene_, {&sweep, 1}};
    curve_.isComplete = slideRealizations(
        {source_, {&part, 1}}, total_, options_.threads, options_.stop,
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
    if (options_.eachLine) options_.eachLine(added_, row);
    ++added_;
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
  std::int64_t added_ = 0, solves_ = 0, passes_ = 0, marginal_ = 0;
};

constexpr std::int64_t kLongLine = std::int64_t{1} << 15;  // points

/// Returns the velocities at which the purpose needs steady sliding.
std::vector<double> velocitiesOf(const Scene& scene, Purpose purpose) {
  return purpose == Purpose::Picture ? std::vector<double>{scene.sliding.velocity}
                                     : sweepVelocities(scene.sweep);
}

}  // namespace

std::vector<double> logVelocitiesBeside(const Sweep& sweep) {
  if (!sweep.isOfVelocity() || sweep.scale != SweepScale::Linear) return {};
  return logSpaced(sweep.velocityFrom, sweep.velocityTo, sweep.points);
}

std::vector<double> velocitiesOfCurve(const Sweep& sweep, const CurveOptions& options) {
  std::vector<double> velocities = sweepVelocities(sweep);
  if (!options.addsLogVelocities) return velocities;
  const std::vector<double> beside = logVelocitiesBeside(sweep);
  velocities.insert(velocities.end(), beside.begin(), beside.end());
  std::ranges::sort(velocities);
  velocities.erase(std::unique(velocities.begin(), velocities.end()), velocities.end());
  return velocities;
}

Curve frictionCurve(const Scene& scene, const CurveOptions& options) {
  return Averaging(scene, options).run();
}

std::vector<PlanStage> planOnLine(const Scene& scene, Purpose purpose) {
  std::vector<PlanStage> stages = planStages(scene, purpose);
  PlanStage& search = stages[static_cast<std::size_t>(Stage::ContactSearch)];
  if (!search.runs || scene.accuracy.scheme == Scheme::Nodal) return stages;
  const SteadySolver sliding(scene);
  const std::int64_t points =
      purpose == Purpose::Curve ? curvePointsPerElement(scene) : pointsPerElement(scene);
  // A sweep of another parameter has other lines, loads or elastomers.
  if (purpose != Purpose::Picture && !scene.sweep.isOfVelocity()) return stages;
  // For a long line, this information costs as much as sliding it.
  const LineExtent extent = lineExtent(scene);
  if (std::max(extent.rows, extent.elements * points) > kLongLine) return stages;
  const PreparedProfile line =
      prepareProfile(LineSource(scene, points).make(0), scene.accuracy.scheme);
  const double depth =
      scene.load.kind == LoadKind::Indentation
          ? scene.load.depth
          : completeContactDepth(line, loadOn(scene.load, line.length).normalForce /
                                           (4 * sliding.law().equilibriumModulus));
  const std::vector<double> velocities = velocitiesOf(scene, purpose);
  // The higher the velocity, the greater the necessary indentation.
  const auto complete = static_cast<std::size_t>(
      std::partition_point(
          velocities.begin(), velocities.end(),
          [&](double velocity) { return sliding.isComplete(line, depth, velocity); }) -
      velocities.begin());
  const auto above = [&](double velocity) {
    return message("contact is complete above d = {:.3g} m at {:.3g} m/s",
                   sliding.completeAbove(line, velocity), velocity);
  };
  if (complete == velocities.size()) {
    search.runs = false;
    search.reason = message("{}, and it is {:.3g} m", above(velocities.back()), depth);
  } else if (complete > 0) {
    const std::size_t searched = velocities.size() - complete;
    search.reason = complete == 1
                        ? message(
                              "at {} of {} velocities; at the other contact is complete, and "
                              "depth and friction are known",
                              searched, velocities.size())
                        : message(
                              "at {} of {} velocities; at the others contact is complete, and "
                              "depth and friction are known",
                              searched, velocities.size());
  } else {
    search.reason =
        message("edges of contact are found inside the segments: {}", above(velocities.front()));
  }
  return stages;
}

}  // namespace asperity
