#include "core/contact/line/prepared_profile.h"

#include <algorithm>

#include "core/contact/line/segment_bounds.h"

namespace asperity {
namespace {

/// The Hermite cubic through two heights with two end slopes (times the segment's length).
Cubic hermite(double h0, double h1, double m0, double m1) {
  const double step = h1 - h0;
  return {h0, m0, 3 * step - 2 * m0 - m1, m0 + m1 - 2 * step};
}

/// Nodes and slopes of a line as material meets them, for either direction. Sliding towards +x,
/// the line's right end comes first: s runs against x.
class Traveller {
 public:
  Traveller(const Line& line, Direction direction)
      : line_(line), count_(line.nodes()), forward_(direction == Direction::Forward) {}

  std::size_t next(std::size_t node) const {
    if (forward_) return node == 0 ? count_ - 1 : node - 1;
    return node + 1 == count_ ? 0 : node + 1;
  }
  /// Segments from this node to the end of the Line in the way of travel.
  std::size_t nodesAhead(std::size_t node) const { return forward_ ? node : count_ - 1 - node; }
  std::size_t moved(std::size_t node, std::size_t by) const {
    return forward_ ? node - by : node + by;
  }
  /// take(k, node k, node k + 1) for a run of segments that does not leave the Line.
  template <class Take>
  void forRun(std::size_t node, std::size_t run, const Take& take) const {
    if (forward_)
      for (std::size_t k = 0; k < run; ++k) take(k, node - k, node - k - 1);
    else
      for (std::size_t k = 0; k < run; ++k) take(k, node + k, node + k + 1);
  }
  double slopeAfter(std::size_t node) const {
    return forward_ ? -line_.slopeLeftOf(node) : line_.slopeAfter[node];
  }
  double slopeBefore(std::size_t node) const {
    return forward_ ? -line_.slopeAfter[node] : line_.slopeLeftOf(node);
  }
  /// The cubic over the segment after a node, heights above `level`.
  Cubic cubicAfter(std::size_t node, double level) const {
    const std::size_t to = next(node);
    const double h = line_.spacing;
    return hermite(line_.height[node] - level, line_.height[to] - level, slopeAfter(node) * h,
                   slopeBefore(to) * h);
  }

 private:
  const Line& line_;
  std::size_t count_;
  bool forward_;
};

struct Lowest {
  double height;
  std::size_t node;     // at or before it, in travel order
  double fraction = 0;  // of the segment after that node
};

Lowest findLowest(const Line& line, const Traveller& traveller, Scheme scheme) {
  const std::size_t node = placeOfLowest(line.height);
  Lowest lowest{line.height[node], node};
  if (scheme != Scheme::Cubic) return lowest;
  const double third = line.spacing / 3;
  for (std::size_t i = 0; i < line.nodes(); ++i) {
    // A cubic lies above the lowest of its control points, two of which are its ends.
    const std::size_t to = traveller.next(i);
    const double control = std::min(line.height[i] + third * traveller.slopeAfter(i),
                                    line.height[to] - third * traveller.slopeBefore(to));
    if (control >= lowest.height) continue;
    const Cubic cubic = traveller.cubicAfter(i, 0);
    for (const double t : stationaryPoints(cubic))
      if (cubic(t) < lowest.height) lowest = {cubic(t), i, t};
  }
  return lowest;
}

void setSegment(PreparedProfile& travel, std::size_t i, double rise, double slopeIn,
                double slopeOut) {
  travel.rise[i] = rise;
  travel.slopeIn[i] = slopeIn;
  travel.slopeOut[i] = slopeOut;
}

/// Rises and slopes of `count` whole segments from `node` on, as segments `first` and on; returns
/// the node behind them. Between the ends of the Line nodes follow each other without a look.
std::size_t setWholeSegments(PreparedProfile& travel, const Line& line, const Traveller& traveller,
                             std::size_t node, std::size_t first, std::size_t count) {
  const double perSpacing = 1 / line.spacing, level = travel.lowestHeight;
  const bool isLinear = travel.scheme == Scheme::Linear;
  double *rise = travel.rise.data(), *in = travel.slopeIn.data(), *out = travel.slopeOut.data();
  for (std::size_t i = first, end = first + count; i < end;) {
    const std::size_t run = std::min(traveller.nodesAhead(node), end - i);
    const auto take = [&](std::size_t k, std::size_t from, std::size_t to) {
      const double straight = (line.height[to] - line.height[from]) * perSpacing;
      rise[i + k] = line.height[from] - level;
      in[i + k] = isLinear ? straight : traveller.slopeAfter(from);
      if (!isLinear) out[i + k] = traveller.slopeBefore(to);
    };
    traveller.forRun(node, run, take);
    i += run;
    if (i == end) return traveller.moved(node, run);
    node = traveller.moved(node, run);
    const std::size_t to = traveller.next(node);  // over the end of the Line
    take(0, node, to);
    node = to;
    ++i;
  }
  return node;
}

/// Blocks of four times as many segments each over those of a level, as far as whole ones go.
bool addBlocksOver(PreparedProfile& travel, std::size_t level, const std::stop_token& stop) {
  while (travel.blocks[level].size() >= 4) {
    if (stop.stop_requested()) return false;
    if (travel.blocks.size() == level + 1) travel.blocks.emplace_back();
    mergeFours(travel.blocks[level], travel.blocks[level + 1]);
    ++level;
  }
  travel.blocks.resize(level + 1);
  return true;
}

/// Finds a cut in each of equal parts of the line but the first, at its lowest node. Parts of long
/// lines are no longer than what the cache of a core holds of them.
void addCuts(PreparedProfile& travel) {
  constexpr std::size_t kFewestSegments = 16, kMostSegments = 8192, kFewestParts = 16;
  travel.cuts.clear();
  const std::size_t parts = std::max(kFewestParts, travel.segments() / kMostSegments);
  const std::size_t size = travel.segments() / parts;
  if (size < kFewestSegments) return;
  for (std::size_t k = 1; k < parts; ++k) {
    const std::size_t segment = k * size + placeOfLowest({&travel.rise[k * size], size});
    const double lowest = travel.rise[segment];
    std::size_t back = segment - 2;  // blocks[0][back - 1] is of segment `back`
    while (back > 0 && segment - back < size && travel.blocks[0].lowest[back - 1] >= lowest) --back;
    travel.cuts.push_back({segment, travel.position(segment) - travel.position(back + 1)});
  }
}

bool resizeFor(PreparedProfile& travel, std::size_t segments, const std::stop_token& stop) {
  travel.rise.resize(segments + 1);
  if (stop.stop_requested()) return false;
  travel.slopeIn.resize(segments);
  if (stop.stop_requested()) return false;
  travel.slopeOut.resize(travel.scheme == Scheme::Cubic ? segments : 0);
  return !stop.stop_requested();
}

bool addCubicBlocks(PreparedProfile& travel, const std::stop_token& stop) {
  const std::size_t last = travel.segments() - 1;
  const auto bounds = [&travel](std::size_t i) {
    return boundSegment(&travel.rise[i], travel.slopeIn[i], travel.slopeOut[i],
                        travel.segmentLength(i));
  };
  travel.firstBounds = bounds(0);
  travel.lastBounds = bounds(last);
  if (!travel.blocks[0].resize(last - 1, stop)) return false;
  boundSegments(&travel.rise[1], &travel.slopeIn[1], &travel.slopeOut[1], last - 1, travel.spacing,
                travel.blocks[0]);
  return addBlocksOver(travel, 0, stop);
}

/// The lowest level of straight segments would be as large as all the rest and say nothing new.
bool addStraightBlocks(PreparedProfile& travel, const std::stop_token& stop) {
  const std::size_t inner = travel.segments() - 2;
  travel.blocks[0].clear();
  travel.blocks.resize(inner < 4 ? 1 : std::max<std::size_t>(travel.blocks.size(), 2));
  if (inner < 4) return true;
  boundStraightFours(&travel.rise[1], &travel.slopeIn[1], inner, travel.spacing, travel.blocks[1]);
  return addBlocksOver(travel, 1, stop);
}

/// Of the rise, by fours as far as they go.
double integralOf(const PreparedProfile& travel) {
  double integral = travel.bounds(0).riseIntegral;
  const std::size_t fours = travel.blocks.size() > 1 ? travel.blocks[1].size() : 0;
  for (std::size_t i = 0; i < fours; ++i) integral += travel.blocks[1].riseIntegral[i];
  for (std::size_t i = 4 * fours + 1; i < travel.segments(); ++i)
    integral += travel.bounds(i).riseIntegral;
  return integral;
}

bool addBounds(PreparedProfile& travel, const std::stop_token& stop) {
  travel.blocks.resize(std::max<std::size_t>(travel.blocks.size(), 1));
  const bool isCubic = travel.scheme == Scheme::Cubic;
  if (!(isCubic ? addCubicBlocks(travel, stop) : addStraightBlocks(travel, stop))) return false;
  travel.meanRise = integralOf(travel) / travel.length;
  if (stop.stop_requested()) return false;
  isCubic ? addCuts(travel) : travel.cuts.clear();
  return true;
}

bool addResolvedSegments(PreparedProfile& travel, const Line& line, const Traveller& traveller,
                         const Lowest& lowest, const std::stop_token& stop) {
  const double h = line.spacing, t = lowest.fraction;
  const std::size_t count = line.nodes(), split = t > 0 ? 1 : 0;
  travel.startsInsideSegment = t > 0;
  travel.startFraction = t;
  travel.firstLength = (1 - t) * h;
  travel.lastLength = t > 0 ? t * h : h;
  if (!resizeFor(travel, count + split, stop)) return false;
  std::size_t node = lowest.node;
  if (split > 0) node = traveller.next(node);
  node = setWholeSegments(travel, line, traveller, node, split, count - split);
  if (split > 0) {
    // The segment of the lowest point: its two parts, level at that point. About it, because the
    // difference of two heights would lose what rises next to it.
    const Cubic whole = traveller.cubicAfter(node, lowest.height).about(t);
    const Cubic level{0, 0, whole.c2, whole.c3};
    setSegment(travel, 0, 0, 0, level.derivative(1 - t) / h);
    setSegment(travel, count, level(-t), level.derivative(-t) / h, 0);
    travel.rise[1] = level(1 - t);
  }
  travel.rise.back() = 0;
  return !stop.stop_requested() && addBounds(travel, stop);
}

bool addNodes(PreparedProfile& travel, const Line& line, const Traveller& traveller,
              const Lowest& lowest, const std::stop_token& stop) {
  const std::size_t count = line.nodes();
  travel.rise.resize(count + 1);
  travel.slopeIn.resize(count);
  travel.slopeOut.clear();
  travel.startsInsideSegment = false;
  travel.startFraction = 0;
  travel.firstLength = travel.lastLength = line.spacing;
  travel.meanRise = 0;
  std::size_t node = lowest.node;
  for (std::size_t i = 0; i < count; ++i) {
    travel.rise[i] = line.height[node] - lowest.height;
    // At a corner the element takes the mean of both sides.
    travel.slopeIn[i] = 0.5 * (traveller.slopeBefore(node) + traveller.slopeAfter(node));
    travel.meanRise += travel.rise[i];
    node = traveller.next(node);
  }
  travel.rise[count] = 0;
  travel.meanRise /= static_cast<double>(count);
  travel.blocks.resize(std::max<std::size_t>(travel.blocks.size(), 1));
  travel.blocks[0].resizeForNodal(count - 1);
  std::copy_n(travel.rise.begin() + 1, count - 1, travel.blocks[0].lowest.begin());
  return addBlocksOver(travel, 0, stop);
}

}  // namespace

Cubic PreparedProfile::segment(std::size_t i) const {
  const double h = segmentLength(i);
  return hermite(rise[i], rise[i + 1], slopeIn[i] * h, slopeAtEnd(i) * h);
}

Cubic PreparedProfile::segmentBackwards(std::size_t i) const {
  const double h = segmentLength(i);
  return hermite(rise[i + 1], rise[i], -slopeAtEnd(i) * h, -slopeIn[i] * h);
}

std::vector<double> inLineOrder(const PreparedProfile& travel, const std::vector<double>& values,
                                Direction direction) {
  const std::size_t skipped = travel.startsInsideSegment ? 1 : 0;  // the lowest point is no node
  const std::size_t count = values.size() - skipped;
  std::vector<double> ordered(count);
  for (std::size_t k = skipped; k < values.size(); ++k) {
    const std::size_t away = k % count;
    const std::size_t node = direction == Direction::Forward
                                 ? (travel.firstNode + count - away) % count
                                 : (travel.firstNode + away) % count;
    ordered[node] = values[k];
  }
  return ordered;
}

bool prepareProfileInto(PreparedProfile& travel, const Line& line, Scheme scheme,
                        Direction direction, const std::stop_token& stop) {
  travel.scheme = scheme;
  travel.length = line.length;
  travel.spacing = line.spacing;
  travel.rmsHeight = line.rmsHeight;
  travel.rmsSlope = line.rmsSlope;
  const Traveller traveller(line, direction);
  const Lowest lowest = findLowest(line, traveller, scheme);
  travel.firstNode = lowest.node;
  travel.lowestHeight = lowest.height;
  if (stop.stop_requested()) return false;
  return scheme == Scheme::Nodal ? addNodes(travel, line, traveller, lowest, stop)
                                 : addResolvedSegments(travel, line, traveller, lowest, stop);
}

PreparedProfile prepareProfile(const Line& line, Scheme scheme, Direction direction) {
  PreparedProfile travel;
  prepareProfileInto(travel, line, scheme, direction);
  return travel;
}

}  // namespace asperity
