#include "core/friction/ensemble.h"

#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>

#include "core/contact/steady_sliding.h"
#include "core/contact/sweep.h"
#include "core/friction/law.h"
#include "core/surface/line_source.h"

namespace asperity {
namespace {

/// Mean and spread of a stream of numbers (Welford's recurrence).
class RunningMean {
 public:
  void add(double value) {
    ++count_;
    const double step = value - mean_;
    mean_ += step / static_cast<double>(count_);
    squares_ += step * (value - mean_);
  }
  double mean() const { return count_ > 0 ? mean_ : kNotApplicable; }
  double standardError() const {
    const auto n = static_cast<double>(count_);
    return count_ > 1 ? std::sqrt(squares_ / (n * (n - 1))) : kNotApplicable;
  }
  std::int64_t count() const { return count_; }

 private:
  std::int64_t count_ = 0;
  double mean_ = 0, squares_ = 0;
};

struct VelocityAverage {
  RunningMean mu, contactFraction, rmsSlopeContact, indentation, normalForce;
};

/// One realization: a result for each velocity done.
using Row = std::vector<SteadyResult>;

/// What a thread uses again for one realization after another.
struct Memory {
  Line line;
  TravelLine travel;
};

std::string failureOf(const SteadyResult& result, double velocity, std::int64_t realization) {
  const std::string where =
      fmt::format("at velocity {:.4g} m/s on realization {}", velocity, realization);
  if (result.residual <= kAcceptedResidual)
    return "contact is too short for the digits that numbers have, " + where;
  return fmt::format("the force balance is not met {}: relative residual {:.2g}", where,
                     result.residual);
}

class Averaging {
 public:
  Averaging(const Scene& scene, const CurveOptions& options)
      : scene_(scene),
        options_(options),
        source_(scene, pointsPerElement(scene)),
        velocities_(sweepVelocities(scene.sweep)),
        total_(source_.isRandom() ? scene.ensemble.realizations : 1),
        averages_(velocities_.size()),
        arena_(options.threads > 0 ? options.threads : tbb::task_arena::automatic) {}

  Curve run() {
    // The first curve comes at once; later batches are large enough to keep all threads busy.
    for (std::int64_t done = 0, batch = 1; done < total_ && !stopped();) {
      batch = std::min(batch, total_ - done);
      const std::vector<Row> rows = compute(done, batch);
      if (stopped()) break;
      for (const Row& row : rows) add(row);
      done += batch;
      batch = std::min<std::int64_t>(2 * batch, 32);
      curve_.isComplete = done == total_;
      report(done);
    }
    curve_.points = points();
    const auto solves = std::max(1.0, static_cast<double>(solves_));
    curve_.meanPasses = static_cast<double>(passes_) / solves;
    curve_.marginalFraction = static_cast<double>(marginal_) / solves;
    return curve_;
  }

 private:
  bool stopped() const { return options_.stop.stop_requested(); }

  std::vector<Row> compute(std::int64_t first, std::int64_t count) {
    std::vector<Row> rows(static_cast<std::size_t>(count));
    arena_.execute([&] {
      tbb::parallel_for(std::int64_t{0}, count, [&](std::int64_t i) {
        if (!stopped()) rows[static_cast<std::size_t>(i)] = sweep(first + i);
      });
    });
    return rows;
  }

  Row sweep(std::int64_t realization) {
    Memory& memory = memory_.local();
    const Scheme scheme = scene_.accuracy.scheme;
    source_.makeInto(memory.line, realization,
                     scheme == Scheme::Linear ? Slopes::NotWanted : Slopes::Wanted);
    if (stopped()) return {};  // a long line takes as long as all the rest
    prepareTravelInto(memory.travel, memory.line, scheme);
    const TravelLine& line = memory.travel;
    Row row(velocities_.size());
    if (!slideSweep(line, conditionsOf(scene_, 0), scene_.load, velocities_, row, options_.stop))
      return {};
    for (std::size_t i = 0; i < row.size(); ++i)
      if (row[i].status != SteadyStatus::Balanced)
        throw std::runtime_error(failureOf(row[i], velocities_[i], realization));
    return row;
  }

  void add(const Row& row) {
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
  tbb::task_arena arena_;
  tbb::enumerable_thread_specific<Memory> memory_;
  Curve curve_;
  std::int64_t solves_ = 0, passes_ = 0, marginal_ = 0;
};

}  // namespace

std::vector<double> sweepVelocities(const Sweep& sweep) {
  std::vector<double> velocities;
  for (std::int64_t i = 0; i < sweep.points; ++i) {
    const double part =
        sweep.points > 1 ? static_cast<double>(i) / static_cast<double>(sweep.points - 1) : 0;
    velocities.push_back(sweep.velocityFrom *
                         std::pow(sweep.velocityTo / sweep.velocityFrom, part));
  }
  if (sweep.points > 1) velocities.back() = sweep.velocityTo;  // to the last bit
  return velocities;
}

Curve frictionCurve(const Scene& scene, const CurveOptions& options) {
  return Averaging(scene, options).run();
}

}  // namespace asperity
