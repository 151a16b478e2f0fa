// Bounds and integrals over blocks of segments, one array for each quantity, so that neighbouring
// blocks are compared in one vector. A plain value inside a TravelLine.
#pragma once

#include <algorithm>
#include <cstddef>
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

  std::size_t size() const { return lowest.size() - kPadding; }
  void resize(std::size_t blocks) {
    for (std::vector<double>* values : {&lowest, &highest, &steepest, &riseIntegral, &slopeSquared})
      values->resize(blocks + kPadding);
  }
  void resizeForNodal(std::size_t blocks) {
    lowest.resize(blocks + kPadding);
    for (std::vector<double>* values : {&highest, &steepest, &riseIntegral, &slopeSquared})
      values->clear();
  }
  SegmentBounds operator[](std::size_t i) const {
    return {lowest[i], highest[i], steepest[i], riseIntegral[i], slopeSquared[i]};
  }
  /// Makes this the level of blocks of four of a finer one, as far as whole ones go.
  void merge(const BlockLevel& finer) {
    const std::size_t count = finer.size() / 4;
    if (finer.highest.empty()) {
      resizeForNodal(count);
      each(finer.lowest, lowest, count, least);
      return;
    }
    resize(count);
    each(finer.lowest, lowest, count, least);
    each(finer.highest, highest, count, most);
    each(finer.steepest, steepest, count, most);
    each(finer.riseIntegral, riseIntegral, count, sum);
    each(finer.slopeSquared, slopeSquared, count, sum);
  }

 private:
  static double least(double a, double b) { return std::min(a, b); }
  static double most(double a, double b) { return std::max(a, b); }
  static double sum(double a, double b) { return a + b; }

  template <class Merge>
  static void each(const std::vector<double>& four, std::vector<double>& one, std::size_t count,
                   const Merge& merge) {
    for (std::size_t i = 0; i < count; ++i) {
      const double* from = four.data() + 4 * i;
      one[i] = merge(merge(from[0], from[1]), merge(from[2], from[3]));
    }
  }
};

}  // namespace asperity
