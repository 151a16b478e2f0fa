// Bounds and integrals over blocks of segments, one array for each quantity, so that neighbouring
// blocks are compared in one vector; segment_bounds.h fills them. A plain value inside a
// PreparedProfile.
#pragma once

#include <cstddef>
#include <stop_token>
#include <vector>

namespace asperity {

/// What a pass needs to know of a whole segment to decide without looking inside.
struct SegmentBounds {
  double lowest, highest;  // m, bounds of the rise
  double steepest;         // bound of d rise / d s: pressure is lowest there
  double riseIntegral;     // m^2
  double slopeSquared;     // m, integral of (d rise / ds)^2
};

/// Blocks of one size along the line. Each array has kPadding numbers more than blocks, to be read
/// but not used.
class BlockLevel {
 public:
  static constexpr std::size_t kPadding = 8;

  std::vector<double> lowest;                                         // all there is for nodal
  std::vector<double> highest, steepest, riseIntegral, slopeSquared;  // as in SegmentBounds

  std::size_t size() const { return lowest.empty() ? 0 : lowest.size() - kPadding; }
  /// Returns false where `stop` was requested: fresh memory of long lines takes milliseconds.
  bool resize(std::size_t blocks, const std::stop_token& stop = {}) {
    for (std::vector<double>* values :
         {&lowest, &highest, &steepest, &riseIntegral, &slopeSquared}) {
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
    for (std::vector<double>* values : {&lowest, &highest, &steepest, &riseIntegral, &slopeSquared})
      values->clear();
  }
  SegmentBounds operator[](std::size_t i) const {
    return {lowest[i], highest[i], steepest[i], riseIntegral[i], slopeSquared[i]};
  }
};

}  // namespace asperity
