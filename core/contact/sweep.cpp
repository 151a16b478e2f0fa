#include "core/contact/sweep.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/flush_denormals.h"
#include "core/contact/complete_contact.h"
#include "core/contact/depth_at_rest.h"
#include "core/contact/initial_guess.h"
#include "core/contact/kernels/cubic_kernel.h"
#include "core/contact/kernels/lane_pass.h"
#include "core/contact/kernels/linear_kernel.h"
#include "core/contact/kernels/nodal_group.h"
#include "core/contact/kernels/stream_balance.h"
#include "core/scene/plan.h"

namespace asperity {
namespace {

SteadyResult resultOf(const PreparedProfile& line, double stiffness, double velocity,
                      const PassSums& sums, double depth) {
  constexpr double kNotGathered = std::numeric_limits<double>::quiet_NaN();
  SteadyResult result;
  result.indentation = depth;
  result.normalForce = stiffness * sums.depth;
  result.forceFromDepth = result.normalForce;
  result.forceFromPressure = stiffness * sums.pressure;
  result.tangentialForce = stiffness * sums.dissipation;
  result.mu = sums.dissipation / sums.depth;
  result.contactFraction = std::min(sums.contactLength / line.length, 1.0);
  result.rmsSlopeContact =
      sums.contactLength > 0 ? std::sqrt(sums.slopeSquared / sums.contactLength) : kNotGathered;
  result.powerDissipated = result.tangentialForce * velocity;
  result.powerIn = kNotGathered;
  return result;
}

/// Whether contact is complete, and then what a pass would find: no edge of contact is sought.
bool takeComplete(const PreparedProfile& line, double depth, double memory, PassSums& sums) {
  if (!isContactComplete(line, depth, memory)) return false;
  const StateSums state = completeState(line, depth, memory);
  sums = {state.depth,
          state.stiffness,
          state.pressure,
          state.dissipation,
          state.contactLength,
          state.slopeSquared,
          0};
  return true;
}

/// All balances of a table, each in the first lane that is free.
class SweepQueue final : public PassQueue {
 public:
  SweepQueue(const PreparedProfile& line, const SlidingConditions& conditions,
             const InitialGuess& table, const std::stop_token& stop)
      : line_(line),
        stiffness_(4 * conditions.shearModulus),
        tau_(conditions.relaxationTime),
        table_(table),
        stop_(stop) {}

  bool isStopped() const override { return stop_.stop_requested(); }

  bool begin(std::size_t lane, PassRequest& task) override {
    Lane& one = lanes_[lane];
    do {
      if (begun_ == table_.results.size() || isStopped()) return false;
      startNext(one);
    } while (isComplete(one));
    hasSearched_ = true;
    const double lowest = one.load / line_.length;
    one.balance.start(lowest, lowest + line_.meanRise, table_.guess(one.row, one.column));
    task = taskOf(one);
    return true;
  }

  bool hasSearched() const { return hasSearched_; }

  bool next(std::size_t lane, const PassSums& sums, PassRequest& task) override {
    Lane& one = lanes_[lane];
    one.balance.take(sums, one.load);
    looksOf(one.column) = sums.segmentsInspected;
    if (!one.balance.isDone()) {
      task = taskOf(one);
      return !isStopped();
    }
    finish(one, one.balance.bestSums(), one.balance.bestDepth(), one.balance.passes(),
           one.balance.residual());
    return begin(lane, task);
  }

 private:
  struct Lane {
    std::size_t row, column;
    double load;  // m^2, per 4G
    double rest;  // m
    StreamBalance balance;
  };

  void startNext(Lane& one) {
    const std::size_t columns = table_.velocities.size();
    one.row = begun_ / columns;
    one.column = columnInOrder(begun_ % columns, columns);
    ++begun_;
    one.load = table_.forces[one.row] / stiffness_;
    double& rest = table_.rests[one.row % InitialGuess::kRests];
    if (one.row != restRow_) {
      rest = depthAtRest(line_, one.load, stop_);
      restRow_ = one.row;
    }
    one.rest = rest;
  }

  bool isComplete(const Lane& one) {
    const double depth = depthOfComplete(line_, one.load);
    PassSums sums;
    if (!takeComplete(line_, depth, memoryOf(one), sums)) return false;
    finish(one, sums, depth, 1, std::abs(sums.depth / one.load - 1));
    return true;
  }

  void finish(const Lane& one, const PassSums& sums, double depth, int passes, double residual) {
    SteadyResult& result = table_.at(one.row, one.column);
    result = resultOf(line_, stiffness_, table_.velocities[one.column], sums, depth);
    result.passes = passes;
    result.residual = residual;
    result.depthAtRest = one.rest;
    result.status = statusOf(result);
  }

  double memoryOf(const Lane& one) const { return table_.velocities[one.column] * tau_; }

  /// Long passes are cut, by what the last one at this velocity cost, or might.
  PassRequest taskOf(const Lane& one) {
    constexpr double kLooksOfPart = 48, kMostParts = 4096, kSegmentsToALook = 1024;
    double& segmentsInspected = looksOf(one.column);
    if (segmentsInspected == 0)
      segmentsInspected = static_cast<double>(line_.segments()) / kSegmentsToALook;
    const double parts = std::clamp(segmentsInspected / kLooksOfPart, 1.0, kMostParts);
    return {one.balance.depth(), memoryOf(one), static_cast<int>(parts)};
  }
  double& looksOf(std::size_t column) { return looks_[column % looks_.size()]; }

  const PreparedProfile& line_;
  double stiffness_, tau_;
  InitialGuess table_;
  std::stop_token stop_;
  std::size_t begun_ = 0, restRow_ = std::numeric_limits<std::size_t>::max();
  bool hasSearched_ = false;
  std::array<Lane, kMostStreams> lanes_;
  std::array<double, 64> looks_{};
};

/// One pass for each velocity at a given depth.
class DepthQueue final : public PassQueue {
 public:
  DepthQueue(const PreparedProfile& line, const SlidingConditions& conditions, double depth,
             std::span<const double> velocities, std::span<SteadyResult> results,
             const std::stop_token& stop)
      : line_(line),
        conditions_(conditions),
        depth_(depth),
        velocities_(velocities),
        results_(results),
        stop_(stop) {}

  bool isStopped() const override { return stop_.stop_requested(); }

  bool begin(std::size_t lane, PassRequest& task) override {
    for (; begun_ < velocities_.size() && !isStopped(); ++begun_) {
      const double memory = velocities_[begun_] * conditions_.relaxationTime;
      PassSums sums;
      if (takeComplete(line_, depth_, memory, sums)) {
        finish(begun_, sums);
        continue;
      }
      task = {depth_, memory, 1};
      columns_[lane] = begun_++;
      hasSearched_ = true;
      return true;
    }
    return false;
  }

  bool next(std::size_t lane, const PassSums& sums, PassRequest& task) override {
    finish(columns_[lane], sums);
    return begin(lane, task);
  }

  bool hasSearched() const { return hasSearched_; }

 private:
  void finish(std::size_t column, const PassSums& sums) {
    results_[column] =
        resultOf(line_, 4 * conditions_.shearModulus, velocities_[column], sums, depth_);
    results_[column].passes = 1;
  }

  const PreparedProfile& line_;
  SlidingConditions conditions_;
  double depth_;
  std::span<const double> velocities_;
  std::span<SteadyResult> results_;
  std::stop_token stop_;
  std::size_t begun_ = 0;
  bool hasSearched_ = false;
  std::array<std::size_t, kMostStreams> columns_{};
};

void runPasses(const PreparedProfile& line, PassQueue& queue) {
  line.scheme == Scheme::Linear ? passStraight(line, queue) : passLanes(line, queue);
}

/// Depths to start from: the trend of the last two answers, which fall with velocity.
LaneValues guessesFor(std::span<const double> velocities, std::span<const double> known,
                      std::span<const SteadyResult> answers) {
  LaneValues guesses{};
  const std::size_t n = answers.size();
  const double last = answers[n - 1].indentation;
  if (!(last > 0 && known[n - 1] > 0)) return guesses;
  double trend = 0;  // d ln depth / d ln v
  if (n > 1 && known[n - 2] > 0 && known[n - 1] > known[n - 2] && answers[n - 2].indentation > 0)
    trend = std::log(last / answers[n - 2].indentation) / std::log(known[n - 1] / known[n - 2]);
  for (std::size_t lane = 0; lane < velocities.size(); ++lane) {
    const double ahead = std::log(velocities[lane] / known[n - 1]);
    const double guess = last * std::exp(std::clamp(trend, -1.0, 0.0) * ahead);
    guesses[lane] = std::isfinite(guess) ? guess : last;
  }
  return guesses;
}

/// Neighbouring velocities of the separate elements go side by side, group after group.
bool sweepNodal(const PreparedProfile& line, const SlidingConditions& conditions, const Load& load,
                std::span<const double> velocities, std::span<SteadyResult> results,
                const std::stop_token& stop) {
  NodalGroup group(line, conditions, load);
  const std::size_t lanes = laneCount();
  LaneValues guesses{};
  for (std::size_t i = 0; i < velocities.size(); i += lanes) {
    const std::size_t count = std::min(lanes, velocities.size() - i);
    if (i > 0)
      guesses = guessesFor(velocities.subspan(i, count), velocities.first(i), results.first(i));
    if (!group.solve(velocities.subspan(i, count), results.subspan(i, count), guesses, stop))
      return false;
  }
  return true;
}

}  // namespace

bool slideAtForces(const PreparedProfile& line, const SlidingConditions& conditions,
                   std::span<const double> forces, std::span<const double> velocities,
                   std::span<SteadyResult> results, const std::stop_token& stop,
                   std::span<const SteadyResult> others) {
  const FlushDenormals flush;
  for (SteadyResult& result : results) result.passes = 0;
  if (line.scheme != Scheme::Nodal) {
    SweepQueue queue(line, conditions, {forces, velocities, results, others}, stop);
    runPasses(line, queue);
    if (queue.hasSearched()) countStage(Stage::ContactSearch);
    return !stop.stop_requested();
  }
  countStage(Stage::ContactSearch);
  for (std::size_t row = 0; row < forces.size(); ++row) {
    Load load;
    load.normalForce = forces[row];
    if (!sweepNodal(line, conditions, load, velocities,
                    results.subspan(row * velocities.size(), velocities.size()), stop))
      return false;
  }
  return true;
}

bool slideSweep(const PreparedProfile& line, const SlidingConditions& conditions, const Load& load,
                std::span<const double> velocities, std::span<SteadyResult> results,
                const std::stop_token& stop, std::span<const SteadyResult> others) {
  if (load.kind == LoadKind::Force)
    return slideAtForces(line, conditions, {&load.normalForce, 1}, velocities, results, stop,
                         others);
  const FlushDenormals flush;
  if (line.scheme == Scheme::Nodal) {
    countStage(Stage::ContactSearch);
    return sweepNodal(line, conditions, load, velocities, results, stop);
  }
  DepthQueue queue(line, conditions, load.depth, velocities, results, stop);
  runPasses(line, queue);
  if (queue.hasSearched()) countStage(Stage::ContactSearch);
  return !stop.stop_requested();
}

}  // namespace asperity
