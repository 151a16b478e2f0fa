#include "core/friction/ensemble.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <utility>
#include <vector>

#include "core/base/jobs.h"
#include "core/contact/force_balance.h"
#include "core/contact/steady_solver.h"

namespace asperity {
namespace {

using Results = std::vector<SteadyResult>;

/// Memory that a thread uses again for one realization after another, also in later ensembles: the
/// system needs more time to allocate and free the pages of a long line than it takes to fill them,
/// and a cancelled ensemble would wait for that. Lines far shorter than the last one get new
/// memory. A line that several chunks of work need is kept.
struct Buffers {
  Line line;
  PreparedProfile profile;
  std::uint64_t owner = 0;  // the work that the profile belongs to; 0: none
  std::int64_t realization = 0;

  static Buffers& forNodes(std::int64_t nodes) {
    constexpr std::int64_t kMaxSpare = 16;
    thread_local Buffers buffers;
    if (static_cast<std::int64_t>(buffers.line.height.capacity()) > kMaxSpare * nodes) buffers = {};
    return buffers;
  }
};

std::size_t stateCount(const RealizationPart& part) {
  std::size_t count = 0;
  for (const LoadCase& one : part.cases) count += one.velocities.size();
  return count;
}

class Realizations {
 public:
  Realizations(const RealizationWork& work, int threads, const std::stop_token& stop)
      : work_(work), stop_(stop), jobs_(threads) {
    static std::atomic<std::uint64_t> owners{0};
    owner_ = ++owners;
    const Scene* last = nullptr;
    for (std::size_t i = 0; i < work.parts.size(); ++i) {
      const RealizationPart& part = work.parts[i];
      // Parts of one scene share its tables.
      if (&part.scene != last) solvers_.push_back(std::make_unique<SteadySolver>(part.scene));
      last = &part.scene;
      if (part.beginsChunk || chunks_.empty()) chunks_.push_back({i, i, states_});
      chunks_.back().end = i + 1;
      solverOf_.push_back(solvers_.size() - 1);
      states_ += stateCount(part);
    }
  }

  /// Computes realizations. The first call is for one realization, from whose depths the others
  /// begin.
  std::vector<Results> compute(std::int64_t first, std::int64_t count) {
    std::vector<Results> batch(static_cast<std::size_t>(count), Results(states_));
    const auto chunks = static_cast<std::int64_t>(chunks_.size());
    jobs_.run(count * chunks, [&](std::int64_t job) {
      const Chunk& chunk = chunks_[static_cast<std::size_t>(job % chunks)];
      Results& results = batch[static_cast<std::size_t>(job / chunks)];
      if (!stop_.stop_requested())
        slide(work_.first + first + job / chunks, chunk,
              std::span(results).subspan(chunk.firstState));
    });
    if (first_.empty()) first_ = batch.front();
    return batch;
  }

 private:
  /// Parts that one job slides on a line.
  struct Chunk {
    std::size_t begin = 0, end = 0, firstState = 0;
  };

  /// Makes the line of a realization; returns null where stop was requested.
  const PreparedProfile* lineOf(std::int64_t realization) const {
    Buffers& buffers = Buffers::forNodes(work_.source.nodes());
    if (buffers.owner == owner_ && buffers.realization == realization) return &buffers.profile;
    buffers.owner = 0;
    // The making of a long line takes as long as everything else.
    const Slopes slopes = work_.scheme() == Scheme::Linear ? Slopes::Omitted : Slopes::Computed;
    if (!work_.source.makeInto(buffers.line, realization, slopes, stop_) ||
        !prepareProfileInto(buffers.profile, buffers.line, work_.scheme(), stop_))
      return nullptr;
    buffers.owner = owner_;
    buffers.realization = realization;
    return &buffers.profile;
  }

  /// Slides one realization; stops early where stop is requested.
  void slide(std::int64_t realization, const Chunk& chunk, std::span<SteadyResult> left) {
    const PreparedProfile* profile = lineOf(realization);
    if (!profile) return;
    std::span<const SteadyResult> others(first_);
    if (!others.empty()) others = others.subspan(chunk.firstState);
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const RealizationPart& part = work_.parts[i];
      const SteadySolver& solver = *solvers_[solverOf_[i]];
      const auto takeRows = [&](std::size_t size) {
        const std::span<SteadyResult> rows = left.first(size);
        left = left.subspan(size);
        const auto other = others.first(others.empty() ? 0 : size);
        others = others.subspan(other.size());
        return std::pair{rows, other};
      };
      if (part.sharesForces) {
        const auto [rows, other] = takeRows(stateCount(part));
        std::vector<double> forces;
        for (const LoadCase& one : part.cases)
          forces.push_back(loadOn(one.load, profile->length).normalForce);
        const std::span<const double> velocities = part.cases.front().velocities;
        if (!solver.sweepForces(*profile, forces, velocities, rows, stop_, other)) return;
        for (std::size_t k = 0; k < part.cases.size(); ++k)
          check(part.cases[k], rows.subspan(k * velocities.size(), velocities.size()), *profile,
                realization);
        continue;
      }
      for (const LoadCase& one : part.cases) {
        const auto [row, other] = takeRows(one.velocities.size());
        if (!solver.sweep(*profile, one.load, one.velocities, row, stop_, other)) return;
        check(one, row, *profile, realization);
      }
    }
  }

  /// Completes the results of a case, and throws where a balance is not met.
  static void check(const LoadCase& one, std::span<SteadyResult> row,
                    const PreparedProfile& profile, std::int64_t realization) {
    for (SteadyResult& result : row) result.rmsSlopeLine = profile.rmsSlope;
    const Message where = message("on realization {}", realization);
    for (std::size_t i = 0; i < row.size(); ++i) requireBalance(row[i], one.velocities[i], where);
  }

  const RealizationWork& work_;
  std::vector<std::unique_ptr<SteadySolver>> solvers_;
  std::vector<std::size_t> solverOf_;  // [part]
  std::vector<Chunk> chunks_;
  std::size_t states_ = 0;
  Results first_;
  const std::stop_token& stop_;
  Jobs jobs_;
  std::uint64_t owner_ = 0;
};

}  // namespace

bool slideRealizations(const RealizationWork& work, std::int64_t count, int threads,
                       const std::stop_token& stop, const TakeRealization& take,
                       const BatchDone& batchDone) {
  Realizations realizations(work, threads, stop);
  // The first result comes at once; later batches are large enough to keep all threads busy.
  for (std::int64_t done = 0, batch = 1; done < count;
       batch = std::min<std::int64_t>(2 * batch, 32)) {
    batch = std::min(batch, count - done);
    const std::vector<Results> finished = realizations.compute(done, batch);
    if (stop.stop_requested()) return false;
    for (const Results& results : finished) take(results);
    done += batch;
    if (batchDone) batchDone(done);
  }
  return true;
}

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
