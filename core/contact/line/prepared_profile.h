// A line prepared for contact: its segments in the order in which material meets them, starting at
// the lowest point, where contact is certain, so that one pass closes the period. The line slides
// towards +x. Made once per line and scheme; then read by any number of threads.
//
// s is the distance that the material has travelled under the line (m). Heights are measured from
// the lowest point, z >= 0, so at indentation d a point of the line presses the material to the
// depth w = d - z.
#pragma once

#include <algorithm>
#include <cstddef>
#include <stop_token>
#include <vector>

#include "core/contact/line/polynomial.h"
#include "core/contact/line/segment_bounds.h"
#include "core/scene/scene.h"
#include "core/surface/line.h"

namespace asperity {

struct PreparedProfile {
  Scheme scheme = Scheme::Cubic;
  double length = 0;  // m, period
  // m, of all segments except perhaps the first and the last
  double spacing = 0;
  double firstLength = 0, lastLength = 0;  // m, of those two
  std::vector<double> heightAboveMinimum;  // m, at nodes, n + 1; 0 at both ends
  std::vector<double> slopeIn;   // dz/ds at the start of each segment, n (nodal: at the nodes)
  std::vector<double> slopeOut;  // at its end, n; cubic only
  double lowestHeight = 0;       // m, of the lowest point in the coordinates of the Line
  SegmentBounds firstBounds{}, lastBounds{};  // of the first and the last segment; cubic only
  /// blocks[k][b] bounds and integrates the 4^k whole segments from segment 1 + b 4^k on; the first
  /// and the last segment, which may be parts, are not included. For nodal, the same for nodes.
  /// blocks[0] is empty for linear: block() computes one straight segment.
  std::vector<BlockLevel> blocks;
  /// Starts of segments near low points, ascending, where a pass may be cut if they are in contact;
  /// cubic only.
  struct Cut {
    std::size_t segment;
    double clear;  // m, distance before it in which only the previous segment may be lower
  };
  std::vector<Cut> cuts;
  double meanHeight = 0;               // m, mean of z in the scheme's line
  double slopeSquaredIntegral = 0;     // m, of (dz/ds)^2 over the period; 0 for nodal
  double rmsHeight = 0, rmsSlope = 0;  // of the line itself

  std::size_t firstNode = 0;  // node of the Line at or just before s = 0, in order of travel
  // whether the lowest point is no node, so that the first and the last segment are parts of one
  bool startsInsideSegment = false;
  double startFraction = 0;  // position in that segment, 0 at a node

  std::size_t segments() const { return slopeIn.size(); }
  /// Returns s of node i, m; i <= segments().
  double position(std::size_t i) const {
    if (i == 0) return 0;
    return i == segments() ? length : (static_cast<double>(i) - startFraction) * spacing;
  }
  /// Returns the length of segment i. It is not the difference of two positions, which loses digits
  /// in a line of many segments.
  double segmentLength(std::size_t i) const {
    if (i == 0) return firstLength;
    return i + 1 == segments() ? lastLength : spacing;
  }
  /// Returns whether the end of the segment is its lower end. Contact there may be far shorter than
  /// the segment and far lower than its start; measured from the start, both would lose their
  /// digits.
  bool isMeasuredBack(std::size_t i) const {
    return heightAboveMinimum[i + 1] < heightAboveMinimum[i] || i + 1 == segments();
  }
  double slopeAtEnd(std::size_t i) const { return slopeOut.empty() ? slopeIn[i] : slopeOut[i]; }
  SegmentBounds bounds(std::size_t i) const {
    if (scheme == Scheme::Linear) return straightBounds(i);
    if (i == 0) return firstBounds;
    return i + 1 == segments() ? lastBounds : blocks[0][i - 1];
  }
  /// Returns the number of a resolved line's blocks, including single segments.
  std::size_t blockCount(std::size_t level) const {
    return level == 0 ? segments() - 2 : blocks[level].size();
  }
  SegmentBounds block(std::size_t level, std::size_t i) const {
    return level == 0 ? bounds(i + 1) : blocks[level][i];
  }
  /// Calls take(level, block) for the fewest blocks that together are the whole segments, in order;
  /// ends where it returns false, and returns whether it never did.
  template <class Take>
  bool forLargestBlocks(const Take& take) const {
    std::size_t first = 0;  // block of the level that follows those of the levels above
    for (std::size_t level = blocks.size(); level-- > 0;) {
      const std::size_t count = blockCount(level);
      for (std::size_t i = first; i < count; ++i)
        if (!take(level, i)) return false;
      first = 4 * count;
    }
    return true;
  }
  /// Returns the height over segment i as a function of t = (s - s_i) / segmentLength(i).
  Cubic segment(std::size_t i) const;
  /// Returns the same measured back from the segment's end: t = (s_{i+1} - s) / segmentLength(i).
  Cubic segmentBackwards(std::size_t i) const;

 private:
  SegmentBounds straightBounds(std::size_t i) const {
    const double begin = heightAboveMinimum[i], end = heightAboveMinimum[i + 1];
    const double slope = slopeIn[i];
    return {std::min(begin, end), std::max(begin, end), slope, 0.5 * spacing * (begin + end),
            slope * slope * spacing};
  }
};

/// Returns values at the segments' starts (NodeShape) as values at the Line's nodes, in order of x.
std::vector<double> inLineOrder(const PreparedProfile& profile, const std::vector<double>& values);

PreparedProfile prepareProfile(const Line& line, Scheme scheme);

/// Prepares a profile in memory that is used again. Returns false where `stop` was requested, which
/// is checked between steps of about ten numbers per node; the profile is then incomplete.
bool prepareProfileInto(PreparedProfile& profile, const Line& line, Scheme scheme,
                        const std::stop_token& stop = {});

}  // namespace asperity
