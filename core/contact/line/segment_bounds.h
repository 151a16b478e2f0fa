// Bounds and integrals of whole segments of one length and of blocks of them, many at a time; the
// same bits on every instruction set. Heights are above the line's lowest point. Pure functions.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <stop_token>
#include <vector>

namespace asperity {

/// The properties of a whole segment with which a pass can treat it without examining its inside.
struct SegmentBounds {
  double lowest, highest;  // m, bounds of the height
  double steepest;         // upper bound of dz/ds: pressure is lowest there
  double heightIntegral;   // m^2
  double slopeSquared;     // m, integral of (dz/ds)^2
};

/// Blocks of one size along the line, with one array for each quantity, so that adjacent blocks are
/// compared in one vector. Each array has kPadding more numbers than there are blocks, which may be
/// read but not used.
class BlockLevel {
 public:
  static constexpr std::size_t kPadding = 8;

  std::vector<double> lowest;                                           // the only array for nodal
  std::vector<double> highest, steepest, heightIntegral, slopeSquared;  // as in SegmentBounds

  std::size_t size() const { return lowest.empty() ? 0 : lowest.size() - kPadding; }
  /// Returns false where `stop` was requested: new memory for long lines takes milliseconds.
  bool resize(std::size_t blocks, const std::stop_token& stop = {}) {
    for (std::vector<double>* values : all()) {
      if (stop.stop_requested()) return false;
      values->resize(blocks + kPadding);
    }
    return true;
  }
  void resizeForNodal(std::size_t blocks) {
    clear();
    lowest.resize(blocks + kPadding);
  }
  void clear() {
    for (std::vector<double>* values : all()) values->clear();
  }
  SegmentBounds operator[](std::size_t i) const {
    return {lowest[i], highest[i], steepest[i], heightIntegral[i], slopeSquared[i]};
  }

 private:
  std::array<std::vector<double>*, 5> all() {
    return {&lowest, &highest, &steepest, &heightIntegral, &slopeSquared};
  }
};

/// Bounds segments. Segment k has the heights height[k] and height[k + 1] (m) at its ends and the
/// slopes slopeIn[k] and slopeOut[k] there; it becomes block k of `blocks`, which has the same
/// number. length: m, of each. Bounds come from control points (a cubic lies within theirs),
/// integrals are exact.
void boundSegments(const double* height, const double* slopeIn, const double* slopeOut,
                   std::size_t count, double length, BlockLevel& blocks);

/// Bounds one segment; height: at its two ends.
SegmentBounds boundSegment(const double* height, double slopeIn, double slopeOut, double length);

/// Bounds blocks of four straight segments each, for whole blocks: from the heights at all ends and
/// the slope of each.
void boundStraightFours(const double* height, const double* slope, std::size_t count, double length,
                        BlockLevel& blocks);

/// Merges four blocks of a finer level into one, for whole groups.
void mergeFours(const BlockLevel& finer, BlockLevel& blocks);

/// Returns the index of the first of the lowest of some values; there is at least one.
std::size_t lowestIndex(std::span<const double> values);

}  // namespace asperity
