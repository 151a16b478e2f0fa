#include "core/contact/steady_sweep.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/flush_denormals.h"
#include "core/contact/force_balance.h"
#include "core/contact/kernels/kernels.h"
#include "core/contact/kernels/nodal_balance.h"
#include "core/scene/plan.h"

namespace asperity {
namespace {

constexpr std::size_t kCoarsest = 4;
/// Where the logarithm of the sinking is smaller, this line may be in complete contact.
constexpr double kNegligibleSinking = 1e-3;

/// Depths found so far at several forces and velocities of one line, and a guess of the next one
/// from them. They change the cost of a balance, but not its result beyond the residual.
///
/// results[row * velocities.size() + column], a row for each force (N, ascending), a column for
/// each velocity (m/s, ascending); passes is 0 where a result is still to come.
struct InitialGuess {
  std::span<const double> forces, velocities;
  std::span<SteadyResult> results;
  /// Results of another line with the same spectrum, or none: the ratios of depth to depth at rest
  /// are similar.
  std::span<const SteadyResult> others;
  /// Depths (m) of the line at rest, for the last few rows, row k at k % kRests.
  static constexpr std::size_t kRests = 4;
  std::array<double, kRests> rests{};

  SteadyResult& at(std::size_t row, std::size_t column) const {
    return results[row * velocities.size() + column];
  }
  bool isKnown(std::size_t row, std::size_t column) const { return at(row, column).passes > 0; }

  /// Returns a depth (m) near the solution.
  double guess(std::size_t row, std::size_t column) const;

 private:
  double expected(std::size_t row, std::size_t column) const;
  double excess(std::size_t row, std::size_t column) const;
  double fromForces(std::size_t row, std::size_t column) const;
};

/// Returns ln(depth / depth at rest) of the other line: 0 at rest and in complete contact, negative
/// in between.
double InitialGuess::expected(std::size_t row, std::size_t column) const {
  if (others.empty()) return 0;
  const SteadyResult& other = others[row * velocities.size() + column];
  if (!(other.depthAtRest > 0)) return 0;
  const double sinking = std::log(other.indentation / other.depthAtRest);
  return sinking < -kNegligibleSinking ? sinking : 0;
}

/// Returns this line's deviation from the expected value.
double InitialGuess::excess(std::size_t row, std::size_t column) const {
  return std::log(at(row, column).indentation / rests[row % kRests]) - expected(row, column);
}

/// Returns the deviation by Lagrange's polynomial in the logarithm of the force, through the
/// previous rows.
double InitialGuess::fromForces(std::size_t row, std::size_t column) const {
  constexpr std::size_t kMaxRows = kRests - 1;
  std::size_t rows = 0;
  double x[kMaxRows], y[kMaxRows];
  while (rows < std::min(row, kMaxRows) && isKnown(row - 1 - rows, column)) {
    x[rows] = std::log(forces[row - 1 - rows]);
    y[rows] = excess(row - 1 - rows, column);
    ++rows;
  }
  return lagrangePolynomial({x, rows}, {y, rows}, std::log(forces[row]));
}

double InitialGuess::guess(std::size_t row, std::size_t column) const {
  const std::size_t count = velocities.size();
  std::size_t left = column, right = column;
  while (left > 0 && !isKnown(row, left - 1)) --left;
  while (right + 1 < count && !isKnown(row, right + 1)) ++right;
  const auto error = [&](std::size_t known) { return excess(row, known) - fromForces(row, known); };
  const bool hasLeft = left > 0, hasRight = right + 1 < count;
  double correction = 0;
  if (hasLeft && hasRight) {
    const double low = std::log(velocities[left - 1]), high = std::log(velocities[right + 1]);
    const double t = (std::log(velocities[column]) - low) / (high - low);
    correction = (1 - t) * error(left - 1) + t * error(right + 1);
  } else if (hasLeft || hasRight) {
    correction = error(hasLeft ? left - 1 : right + 1);
  }
  const double sinking = expected(row, column) + fromForces(row, column) + correction;
  return rests[row % kRests] * std::exp(std::min(sinking, 0.0));
}

/// Returns the n-th of `count` columns in an efficient order: every fourth, then those halfway, and
/// so on, so that most lie between known ones.
std::size_t columnInOrder(std::size_t n, std::size_t count) {
  const std::size_t first = (count + kCoarsest - 1) / kCoarsest;
  if (n < first) return n * kCoarsest;
  n -= first;
  for (std::size_t stride = kCoarsest; stride > 1; stride /= 2) {
    const std::size_t half = stride / 2;
    const std::size_t here = count > half ? (count - half + stride - 1) / stride : 0;
    if (n < here) return half + n * stride;
    n -= here;
  }
  return count - 1;
}

/// Returns whether contact is complete, and then fills the sums of a pass without computing edges.
bool takeComplete(const PreparedProfile& line, double depth, double relaxationLength,
                  PassSums& sums) {
  if (!isContactComplete(line, depth, relaxationLength)) return false;
  sums = completeContactSums(line, depth, relaxationLength);
  return true;
}

/// The passes of one line at many velocities (m/s).
class SteadyQueue : public PassQueue {
 public:
  SteadyQueue(const PreparedProfile& line, const SlidingConditions& conditions,
              std::span<const double> velocities, const std::stop_token& stop)
      : line_(line), conditions_(conditions), velocities_(velocities), stop_(stop) {}

  bool isStopped() const override { return stop_.stop_requested(); }
  /// Returns whether any pass searched for contact, because contact was not complete.
  bool hasSearched() const { return hasSearched_; }

 protected:
  SlidingConditions at(std::size_t column) const { return conditions_.at(velocities_[column]); }

  const PreparedProfile& line_;
  SlidingConditions conditions_;
  std::span<const double> velocities_;
  std::stop_token stop_;
  bool hasSearched_ = false;
};

/// All balances of a table, each in the first free lane.
class SweepQueue final : public SteadyQueue {
 public:
  SweepQueue(const PreparedProfile& line, const SlidingConditions& conditions,
             const InitialGuess& table, const std::stop_token& stop)
      : SteadyQueue(line, conditions, table.velocities, stop), table_(table) {}

  bool begin(std::size_t lane, PassRequest& request) override {
    Lane& one = lanes_[lane];
    do {
      if (begun_ == table_.results.size() || isStopped()) return false;
      startNext(one);
    } while (isComplete(one));
    hasSearched_ = true;
    one.balance.start(line_, one.load, table_.guess(one.row, one.column));
    request = requestFor(one);
    return true;
  }

  bool next(std::size_t lane, const PassSums& sums, PassRequest& request) override {
    Lane& one = lanes_[lane];
    one.balance.take(sums);
    segmentsInspected(one.column) = sums.segmentsInspected;
    if (!one.balance.isDone()) {
      request = requestFor(one);
      return !isStopped();
    }
    finish(one, one.balance.balance(), one.balance.sums());
    return begin(lane, request);
  }

 private:
  struct Lane {
    std::size_t row, column;
    double load;  // m^2, per 4G
    double rest;  // m
    ForceBalance balance;
  };

  void startNext(Lane& one) {
    const std::size_t columns = table_.velocities.size();
    one.row = begun_ / columns;
    one.column = columnInOrder(begun_ % columns, columns);
    ++begun_;
    one.load = table_.forces[one.row] / (4 * conditions_.shearModulus);
    double& rest = table_.rests[one.row % InitialGuess::kRests];
    if (one.row != restRow_) {
      rest = depthAtRest(line_, one.load, stop_);
      restRow_ = one.row;
    }
    one.rest = rest;
  }

  bool isComplete(const Lane& one) {
    const double depth = completeContactDepth(line_, one.load);
    PassSums sums;
    if (!takeComplete(line_, depth, at(one.column).relaxationLength(), sums)) return false;
    finish(one, {depth, 1, std::abs(sums.depth / one.load - 1)}, sums);
    return true;
  }

  void finish(const Lane& one, const Balance& balance, const PassSums& sums) {
    SteadyResult& result = table_.at(one.row, one.column);
    result = steadyResult(line_, at(one.column), balance, sums);
    result.depthAtRest = one.rest;
  }

  /// Returns the request. Long passes are cut according to the cost of the last one at this
  /// velocity, or its estimate.
  PassRequest requestFor(const Lane& one) {
    constexpr double kInspectedByPart = 48, kMaxParts = 4096, kSegmentsToOneInspected = 1024;
    double& inspected = segmentsInspected(one.column);
    if (inspected == 0) inspected = static_cast<double>(line_.segments()) / kSegmentsToOneInspected;
    const double parts = std::clamp(inspected / kInspectedByPart, 1.0, kMaxParts);
    return {one.balance.depth(), at(one.column).relaxationLength(), static_cast<int>(parts)};
  }
  double& segmentsInspected(std::size_t column) { return inspected_[column % inspected_.size()]; }

  InitialGuess table_;
  std::size_t begun_ = 0, restRow_ = std::numeric_limits<std::size_t>::max();
  std::array<Lane, kMaxStreams> lanes_;
  std::array<double, 64> inspected_{};  // in the last pass at each velocity
};

/// One pass for each velocity at a given depth.
class DepthQueue final : public SteadyQueue {
 public:
  DepthQueue(const PreparedProfile& line, const SlidingConditions& conditions, double depth,
             std::span<const double> velocities, std::span<SteadyResult> results,
             const std::stop_token& stop)
      : SteadyQueue(line, conditions, velocities, stop), depth_(depth), results_(results) {}

  bool begin(std::size_t lane, PassRequest& request) override {
    for (; begun_ < velocities_.size() && !isStopped(); ++begun_) {
      const double c = at(begun_).relaxationLength();
      PassSums sums;
      if (takeComplete(line_, depth_, c, sums)) {
        finish(begun_, sums);
        continue;
      }
      request = {depth_, c, 1};
      columns_[lane] = begun_++;
      hasSearched_ = true;
      return true;
    }
    return false;
  }

  bool next(std::size_t lane, const PassSums& sums, PassRequest& request) override {
    finish(columns_[lane], sums);
    return begin(lane, request);
  }

 private:
  void finish(std::size_t column, const PassSums& sums) {
    results_[column] = steadyResult(line_, at(column), depth_, sums);
  }
  double depth_;
  std::span<SteadyResult> results_;
  std::size_t begun_ = 0;
  std::array<std::size_t, kMaxStreams> columns_{};
};

/// Runs the passes of a queue with the kernel of the line's scheme, linear or cubic.
void runPasses(const PreparedProfile& line, PassQueue& queue) {
  if (line.scheme == Scheme::Linear)
    runLinearPasses(line, queue);
  else
    runCubicPasses(line, queue);
}

/// Returns initial depths: the trend of the last two solutions, which decrease with velocity.
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

/// Solves adjacent velocities of the separate elements side by side, group after group.
bool sweepNodal(const PreparedProfile& line, const SlidingConditions& conditions,
                double normalForce, std::span<const double> velocities,
                std::span<SteadyResult> results, const std::stop_token& stop) {
  const double load = normalForce / (4 * conditions.shearModulus);
  const std::size_t lanes = laneCount();
  LaneValues guesses{}, relaxationLengths{};
  std::array<NodalBalance, kMaxLanes> balances;
  for (std::size_t i = 0; i < velocities.size(); i += lanes) {
    const std::size_t count = std::min(lanes, velocities.size() - i);
    const std::span<const double> group = velocities.subspan(i, count);
    if (i > 0) guesses = guessesFor(group, velocities.first(i), results.first(i));
    for (std::size_t lane = 0; lane < count; ++lane)
      relaxationLengths[lane] = group[lane] * conditions.relaxationTime;
    if (!balanceNodalLanes(line, {relaxationLengths.data(), count}, load, guesses, stop,
                           {balances.data(), count}))
      return false;
    for (std::size_t lane = 0; lane < count; ++lane)
      results[i + lane] = steadyResult(line, conditions.at(group[lane]), balances[lane]);
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
  for (std::size_t row = 0; row < forces.size(); ++row)
    if (!sweepNodal(line, conditions, forces[row], velocities,
                    results.subspan(row * velocities.size(), velocities.size()), stop))
      return false;
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
    // At a given depth no search is needed.
    for (std::size_t i = 0; i < velocities.size(); ++i)
      results[i] = slideAtDepth(line, conditions.at(velocities[i]), load.depth);
    return true;
  }
  DepthQueue queue(line, conditions, load.depth, velocities, results, stop);
  runPasses(line, queue);
  if (queue.hasSearched()) countStage(Stage::ContactSearch);
  return !stop.stop_requested();
}

}  // namespace asperity
