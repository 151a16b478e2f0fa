#include "core/contact/complete_contact.h"

#include <algorithm>
#include <limits>

namespace asperity {
namespace {

/// take(level, block) for the largest blocks that together are the whole segments; ends where it
/// returns false.
template <class Take>
bool forLargestBlocks(const PreparedProfile& line, const Take& take) {
  for (std::size_t place = 0; place < line.blockCount(0);) {
    std::size_t level = line.blocks.size() - 1;
    const auto fits = [&] {
      const std::size_t size = std::size_t{1} << (2 * level);
      return (place & (size - 1)) == 0 && (place >> (2 * level)) < line.blockCount(level);
    };
    while (!fits()) --level;
    if (!take(level, place >> (2 * level))) return false;
    place += std::size_t{1} << (2 * level);
  }
  return true;
}

/// Looks for depth that the line needs beyond what is known: p / 4G = d - rise - c rise'.
class Needed {
 public:
  Needed(const PreparedProfile& line, double memory, double known)
      : line_(line), memory_(memory), most_(known) {}

  double most() const { return most_; }

  /// Ends at the first place that needs more.
  bool isEnough() const {
    return segmentNeed(0) < most_ && segmentNeed(line_.segments() - 1) < most_ &&
           forLargestBlocks(line_, [this](std::size_t level, std::size_t block) {
             return isEnoughFor(level, block);
           });
  }

  /// Goes on to the largest.
  void raise() {
    most_ = std::max({most_, segmentNeed(0), segmentNeed(line_.segments() - 1)});
    forLargestBlocks(line_, [this](std::size_t level, std::size_t block) {
      raise(level, block);
      return true;
    });
  }

 private:
  bool isBounded(std::size_t level, std::size_t block) const {
    const SegmentBounds bounds = line_.block(level, block);
    return bounds.highest + memory_ * bounds.steepest < most_;
  }

  bool isEnoughFor(std::size_t level, std::size_t block) const {
    if (isBounded(level, block)) return true;
    if (level == 0) return segmentNeed(block + 1) < most_;
    for (std::size_t i = 0; i < 4; ++i)
      if (!isEnoughFor(level - 1, 4 * block + i)) return false;
    return true;
  }

  void raise(std::size_t level, std::size_t block) {
    if (isBounded(level, block)) return;
    if (level == 0) {
      most_ = std::max(most_, segmentNeed(block + 1));
      return;
    }
    for (std::size_t i = 0; i < 4; ++i) raise(level - 1, 4 * block + i);
  }

  double segmentNeed(std::size_t i) const {
    const Cubic rise = line_.segment(i);
    const double k = memory_ / line_.segmentLength(i);
    const Cubic need{rise.c0 + k * rise.c1, rise.c1 + 2 * k * rise.c2, rise.c2 + 3 * k * rise.c3,
                     rise.c3};
    double most = std::max(need(0), need(1));
    for (const double t : stationaryPoints(need)) most = std::max(most, need(t));
    return most;
  }

  const PreparedProfile& line_;
  double memory_, most_;
};

}  // namespace

bool isContactComplete(const PreparedProfile& line, double depth, double memoryLength) {
  return Needed(line, memoryLength, depth).isEnough();
}

double completeAbove(const PreparedProfile& line, double memoryLength) {
  Needed needed(line, memoryLength, 0);
  needed.raise();
  return needed.most();
}

StateSums completeState(const PreparedProfile& line, double depth, double memoryLength) {
  double slopes = line.bounds(0).slopeSquared + line.bounds(line.segments() - 1).slopeSquared;
  forLargestBlocks(line, [&](std::size_t level, std::size_t block) {
    slopes += line.block(level, block).slopeSquared;
    return true;
  });
  StateSums sums;
  // What the dashpots add to the pressure is as much below 0 as above over the period.
  sums.depth = sums.pressure = (depth - line.meanRise) * line.length;
  sums.work = sums.dissipation = memoryLength * slopes;
  sums.stiffness = sums.contactLength = line.length;
  sums.slopeSquared = slopes;
  sums.absoluteSlope = std::numeric_limits<double>::quiet_NaN();
  return sums;
}

}  // namespace asperity
