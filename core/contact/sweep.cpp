#include "core/contact/sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/contact/flush_denormals.h"
#include "core/contact/force_balance.h"
#include "core/contact/lane_pass.h"
#include "core/contact/nodal_group.h"

namespace asperity {
namespace {

/// The balance of one velocity, in one lane: the bracket found so far and the best pass.
class LaneBalance {
 public:
  void start(double lowest, double highest, double guess) {
    low_ = lowest;
    high_ = highest;
    depth_ = guess > lowest && guess < highest ? guess : highest;
    best_ = std::numeric_limits<double>::infinity();
    passes_ = stalled_ = 0;
    done_ = false;
  }

  bool isDone() const { return done_; }
  double depth() const { return depth_; }
  double bestDepth() const { return bestDepth_; }
  double residual() const { return best_; }
  int passes() const { return passes_; }

  /// Takes the force (per 4G) found at depth(); true where this pass is the best so far.
  bool take(double force, double stiffness, double load) {
    ++passes_;
    const double residual = std::abs(force - load) / load;
    const bool closer = residual < best_;
    stalled_ = closer ? 0 : stalled_ + (best_ < kAcceptedResidual ? 1 : 0);
    if (closer) {
      best_ = residual;
      bestDepth_ = depth_;
    }
    (force > load ? high_ : low_) = depth_;
    done_ = best_ <= kWantedResidual || stalled_ >= kPatience || passes_ >= kMostPasses;
    if (!done_) move(force, stiffness, load);
    return closer;
  }

 private:
  /// In the logarithms F_N(d) is nearly straight: Newton's step first, then the cubic through the
  /// last two passes and their slopes, read at the wanted force.
  void move(double force, double stiffness, double load) {
    const Pass pass{std::log1p((force - load) / load), force / (stiffness * depth_), depth_};
    double step = -pass.excess * pass.slope;
    if (passes_ > 1) {
      const double gap = last_.excess - pass.excess, t = -pass.excess / gap;
      const double climb = std::log1p((last_.depth - pass.depth) / pass.depth);
      const double cubic = t * t * (3 - 2 * t) * climb +
                           gap * t * (1 - t) * ((1 - t) * pass.slope - t * last_.slope);
      if (std::isfinite(cubic) && std::abs(t) < 1) step = cubic;
    }
    last_ = pass;
    double next = depth_ * (1 + std::expm1(step));
    if (!(next >= low_ && next <= high_)) next = 0.5 * (low_ + high_);
    done_ = next == depth_;
    depth_ = next;
  }

  struct Pass {
    double excess;  // ln(F / wanted)
    double slope;   // d ln depth / d ln F
    double depth;   // m
  };

  Pass last_{};
  double low_ = 0, high_ = 0, depth_ = 0, bestDepth_ = 0, best_ = 0;
  int passes_ = 0, stalled_ = 0;
  bool done_ = false;
};

SteadyResult resultOf(const TravelLine& line, double stiffness, double velocity,
                      const LaneSums& sums, std::size_t lane, double depth) {
  constexpr double kNotGathered = std::numeric_limits<double>::quiet_NaN();
  SteadyResult result;
  result.indentation = depth;
  result.normalForce = stiffness * sums.depth[lane];
  result.forceFromDepth = result.normalForce;
  result.forceFromPressure = stiffness * sums.pressure[lane];
  result.tangentialForce = stiffness * sums.dissipation[lane];
  result.mu = sums.dissipation[lane] / sums.depth[lane];
  result.contactFraction = std::min(sums.contactLength[lane] / line.length, 1.0);
  result.rmsSlopeContact = sums.contactLength[lane] > 0
                               ? std::sqrt(sums.slopeSquared[lane] / sums.contactLength[lane])
                               : kNotGathered;
  result.powerDissipated = result.tangentialForce * velocity;
  result.powerIn = kNotGathered;
  return result;
}

/// A few neighbouring velocities, solved side by side until the last balance is met. A finished
/// lane goes along at its depth, but its result stays as it was.
class LaneGroup {
 public:
  LaneGroup(const TravelLine& line, const SlidingConditions& conditions, const Load& load)
      : line_(line),
        stiffness_(4 * conditions.shearModulus),
        tau_(conditions.relaxationTime),
        byForce_(load.kind == LoadKind::Force),
        load_(load.normalForce / stiffness_),
        depth_(load.depth) {}

  /// False where `stop` was requested in between.
  bool solve(std::span<const double> velocities, std::span<SteadyResult> results,
             const LaneValues& guesses, const std::stop_token& stop) {
    const std::size_t used = velocities.size();
    LaneValues depth{}, memory{};
    const double lowest = load_ / line_.length;
    for (std::size_t lane = 0; lane < kMostLanes; ++lane) {
      memory[lane] = velocities[std::min(lane, used - 1)] * tau_;
      balances_[lane].start(lowest, lowest + line_.meanRise, guesses[std::min(lane, used - 1)]);
    }
    if (!byForce_) {
      once(velocities, results, memory);
      return true;
    }
    for (bool open = true; open;) {
      if (stop.stop_requested()) return false;
      for (std::size_t lane = 0; lane < kMostLanes; ++lane)
        depth[lane] = balances_[std::min(lane, used - 1)].depth();
      lanePass(line_, depth, memory, sums_);
      open = false;
      for (std::size_t lane = 0; lane < used; ++lane) {
        takePass(lane, velocities[lane], results[lane]);
        open |= !balances_[lane].isDone();
      }
    }
    return true;
  }

 private:
  void takePass(std::size_t lane, double velocity, SteadyResult& result) {
    LaneBalance& balance = balances_[lane];
    if (balance.isDone()) return;
    if (balance.take(sums_.depth[lane], sums_.stiffness[lane], load_))
      result = resultOf(line_, stiffness_, velocity, sums_, lane, balance.bestDepth());
    result.passes = balance.passes();
    result.residual = balance.residual();
    result.status = statusOf(result);
  }

  void once(std::span<const double> velocities, std::span<SteadyResult> results,
            const LaneValues& memory) {
    LaneValues depth;
    depth.fill(depth_);
    lanePass(line_, depth, memory, sums_);
    for (std::size_t lane = 0; lane < velocities.size(); ++lane) {
      results[lane] = resultOf(line_, stiffness_, velocities[lane], sums_, lane, depth_);
      results[lane].passes = 1;
    }
  }

  const TravelLine& line_;
  double stiffness_, tau_;
  bool byForce_;
  double load_, depth_;
  LaneSums sums_;
  std::array<LaneBalance, kMostLanes> balances_;
};

/// Force at rest, looked up in the blocks: those above the depth carry nothing, those below it
/// their mean, and only those that it cuts are opened. Single segments count by their mean.
ForceSums forceAtRest(const TravelLine& line, double depth) {
  ForceSums sums;
  const auto carry = [&](const SegmentBounds& block, double length) {
    if (depth * length <= block.riseIntegral) return;
    sums.depth += depth * length - block.riseIntegral;
    sums.stiffness += length;
  };
  const std::size_t top = line.blocks.size() - 1;
  std::size_t level = top;
  for (std::size_t i = 0, end = line.segments() - 2; i < end;) {
    const std::size_t size = std::size_t{1} << (2 * level), block = i >> (2 * level);
    const bool fits = (i & (size - 1)) == 0 && block < line.blocks[level].size();
    const SegmentBounds& bounds = line.blocks[level][fits ? block : 0];
    if (fits && (level == 0 || depth <= bounds.lowest || depth >= bounds.highest)) {
      if (depth > bounds.lowest) carry(bounds, line.spacing * static_cast<double>(size));
      i += size;
      level = std::min(level + 1, top);
    } else {
      --level;
    }
  }
  return sums;
}

/// A depth close to that which carries the load (m^2, per 4G) at rest. Sliding carries more.
double depthAtRest(const TravelLine& line, double load) {
  constexpr int kMostSteps = 12;
  constexpr double kCloseEnough = 1e-3;
  double depth = load / line.length + line.meanRise;
  for (int step = 0; step < kMostSteps; ++step) {
    const ForceSums sums = forceAtRest(line, depth);
    if (!(sums.stiffness > 0)) break;
    const double next = depth - (sums.depth - load) / sums.stiffness;
    const bool close = std::abs(next - depth) <= kCloseEnough * depth;
    depth = next;
    if (close) break;
  }
  return depth;
}

/// Depths to start from: the trend of the last two answers, which fall with velocity.
LaneValues guessesFor(double first, std::span<const double> velocities,
                      std::span<const double> known, std::span<const SteadyResult> answers) {
  LaneValues guesses;
  guesses.fill(first);
  if (answers.empty()) return guesses;
  const std::size_t n = answers.size();
  const double last = answers[n - 1].indentation;
  double trend = 0;  // d ln depth / d ln v
  if (n > 1 && known[n - 1] > known[n - 2])
    trend = std::log(last / answers[n - 2].indentation) / std::log(known[n - 1] / known[n - 2]);
  for (std::size_t lane = 0; lane < velocities.size(); ++lane) {
    const double ahead = std::log(velocities[lane] / known[n - 1]);
    const double guess = last * std::exp(std::clamp(trend, -1.0, 0.0) * ahead);
    guesses[lane] = std::isfinite(guess) ? guess : last;
  }
  return guesses;
}

/// Neighbouring velocities go side by side, group after group.
template <class Group>
bool sweepInGroups(Group group, double first, std::span<const double> velocities,
                   std::span<SteadyResult> results, const std::stop_token& stop) {
  const FlushDenormals flush;
  const std::size_t lanes = laneCount();
  for (std::size_t i = 0; i < velocities.size(); i += lanes) {
    const std::size_t count = std::min(lanes, velocities.size() - i);
    const auto now = velocities.subspan(i, count);
    const LaneValues guesses = guessesFor(first, now, velocities.first(i), results.first(i));
    if (!group.solve(now, results.subspan(i, count), guesses, stop)) return false;
  }
  return true;
}

}  // namespace

bool slideSweep(const TravelLine& line, const SlidingConditions& conditions, const Load& load,
                std::span<const double> velocities, std::span<SteadyResult> results,
                const std::stop_token& stop) {
  if (line.scheme == Scheme::Nodal)
    return sweepInGroups(NodalGroup(line, conditions, load), 0, velocities, results, stop);
  const double first = load.kind == LoadKind::Force
                           ? depthAtRest(line, load.normalForce / (4 * conditions.shearModulus))
                           : 0;
  return sweepInGroups(LaneGroup(line, conditions, load), first, velocities, results, stop);
}

}  // namespace asperity
