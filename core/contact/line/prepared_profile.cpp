#include "core/contact/line/prepared_profile.h"

#include <algorithm>

namespace asperity {
namespace {

/// Nodes and slopes of a line in the order in which material meets them. The line slides towards
/// +x, so its right end comes first: s runs against x.
class TravelOrder {
 public:
  explicit TravelOrder(const Line& line) : line_(line) {}

  std::size_t next(std::size_t node) const { return node == 0 ? line_.nodes() - 1 : node - 1; }
  double slopeAfter(std::size_t node) const { return -line_.slopeLeftOf(node); }
  double slopeBefore(std::size_t node) const { return -line_.slopeAfter[node]; }
  /// Returns the cubic over the segment after a node, with heights above `level`.
  Cubic cubicAfter(std::size_t node, double level) const {
    const std::size_t to = next(node);
    const double h = line_.spacing;
    return hermiteCubic(line_.height[node] - level, line_.height[to] - level, slopeAfter(node) * h,
                        slopeBefore(to) * h);
  }

 private:
  const Line& line_;
};

struct Lowest {
  double height;
  std::size_t node;     // at or before the point, in order of travel
  double fraction = 0;  // part of the segment after that node
};

Lowest findLowest(const Line& line, const TravelOrder& order, Scheme scheme) {
  const std::size_t node = lowestIndex(line.height);
  Lowest lowest{line.height[node], node};
  if (scheme != Scheme::Cubic) return lowest;
  const double third = line.spacing / 3;
  for (std::size_t i = 0; i < line.nodes(); ++i) {
    // A cubic lies above the lowest of its control points, two of which are its ends.
    const std::size_t to = order.next(i);
    const double control = std::min(line.height[i] + third * order.slopeAfter(i),
                                    line.height[to] - third * order.slopeBefore(to));
    if (control >= lowest.height) continue;
    const Cubic cubic = order.cubicAfter(i, 0);
    for (const double t : stationaryPoints(cubic))
      if (cubic(t) < lowest.height) lowest = {cubic(t), i, t};
  }
  return lowest;
}

void setSegment(PreparedProfile& profile, std::size_t i, double height, double slopeIn,
                double slopeOut) {
  profile.heightAboveMinimum[i] = height;
  profile.slopeIn[i] = slopeIn;
  profile.slopeOut[i] = slopeOut;
}

/// Sets heights and slopes of `count` whole segments from `node` on, as segments `first` and on;
/// returns the node after them. Between the ends of the Line the nodes are consecutive.
std::size_t setWholeSegments(PreparedProfile& profile, const Line& line, const TravelOrder& order,
                             std::size_t node, std::size_t first, std::size_t count) {
  const double perSpacing = 1 / line.spacing, level = profile.lowestHeight;
  const bool isLinear = profile.scheme == Scheme::Linear;
  double* height = profile.heightAboveMinimum.data();
  double *in = profile.slopeIn.data(), *out = profile.slopeOut.data();
  const auto take = [&](std::size_t i, std::size_t from, std::size_t to) {
    const double straight = (line.height[to] - line.height[from]) * perSpacing;
    height[i] = line.height[from] - level;
    in[i] = isLinear ? straight : order.slopeAfter(from);
    if (!isLinear) out[i] = order.slopeBefore(to);
  };
  for (std::size_t i = first, end = first + count; i < end;) {
    const std::size_t run = std::min(node, end - i);  // to the end of the Line, which is node 0
    for (std::size_t k = 0; k < run; ++k) take(i + k, node - k, node - k - 1);
    i += run;
    node -= run;
    if (i == end) break;
    const std::size_t to = order.next(node);  // across the end of the Line
    take(i, node, to);
    node = to;
    ++i;
  }
  return node;
}

/// Adds a level of blocks with four times as many segments as the last one, for whole blocks.
bool addBlocksOver(PreparedProfile& profile, std::size_t level, const std::stop_token& stop) {
  while (profile.blocks[level].size() >= 4) {
    if (stop.stop_requested()) return false;
    if (profile.blocks.size() == level + 1) profile.blocks.emplace_back();
    mergeFours(profile.blocks[level], profile.blocks[level + 1]);
    ++level;
  }
  profile.blocks.resize(level + 1);
  return true;
}

/// Finds a cut in each of equal parts of the line except for the first, at its lowest node. Parts
/// of long lines fit the cache of a core.
void addCuts(PreparedProfile& profile) {
  constexpr std::size_t kMinSegments = 16, kMaxSegments = 8192, kMinParts = 16;
  profile.cuts.clear();
  const std::size_t parts = std::max(kMinParts, profile.segments() / kMaxSegments);
  const std::size_t size = profile.segments() / parts;
  if (size < kMinSegments) return;
  for (std::size_t k = 1; k < parts; ++k) {
    const std::size_t segment =
        k * size + lowestIndex({&profile.heightAboveMinimum[k * size], size});
    const double lowest = profile.heightAboveMinimum[segment];
    std::size_t back = segment - 2;  // blocks[0][back - 1] belongs to segment `back`
    while (back > 0 && segment - back < size && profile.blocks[0].lowest[back - 1] >= lowest)
      --back;
    profile.cuts.push_back({segment, profile.position(segment) - profile.position(back + 1)});
  }
}

bool resizeFor(PreparedProfile& profile, std::size_t segments, const std::stop_token& stop) {
  profile.heightAboveMinimum.resize(segments + 1);
  if (stop.stop_requested()) return false;
  profile.slopeIn.resize(segments);
  if (stop.stop_requested()) return false;
  profile.slopeOut.resize(profile.scheme == Scheme::Cubic ? segments : 0);
  return !stop.stop_requested();
}

bool addCubicBlocks(PreparedProfile& profile, const std::stop_token& stop) {
  const std::size_t last = profile.segments() - 1;
  const auto bounds = [&profile](std::size_t i) {
    return boundSegment(&profile.heightAboveMinimum[i], profile.slopeIn[i], profile.slopeOut[i],
                        profile.segmentLength(i));
  };
  profile.firstBounds = bounds(0);
  profile.lastBounds = bounds(last);
  if (!profile.blocks[0].resize(last - 1, stop)) return false;
  boundSegments(&profile.heightAboveMinimum[1], &profile.slopeIn[1], &profile.slopeOut[1], last - 1,
                profile.spacing, profile.blocks[0]);
  return addBlocksOver(profile, 0, stop);
}

/// Adds the blocks of a straight line; its lowest level would be as large as all others and contain
/// nothing new.
bool addStraightBlocks(PreparedProfile& profile, const std::stop_token& stop) {
  const std::size_t inner = profile.segments() - 2;
  profile.blocks[0].clear();
  profile.blocks.resize(inner < 4 ? 1 : std::max<std::size_t>(profile.blocks.size(), 2));
  if (inner < 4) return true;
  boundStraightFours(&profile.heightAboveMinimum[1], &profile.slopeIn[1], inner, profile.spacing,
                     profile.blocks[1]);
  return addBlocksOver(profile, 1, stop);
}

/// Returns the integral of the height, in steps of the largest whole blocks.
double integralOf(const PreparedProfile& profile) {
  double integral = profile.bounds(0).heightIntegral;
  const std::size_t fours = profile.blocks.size() > 1 ? profile.blocks[1].size() : 0;
  for (std::size_t i = 0; i < fours; ++i) integral += profile.blocks[1].heightIntegral[i];
  for (std::size_t i = 4 * fours + 1; i < profile.segments(); ++i)
    integral += profile.bounds(i).heightIntegral;
  return integral;
}

double slopeSquaredIntegralOf(const PreparedProfile& profile) {
  double integral =
      profile.bounds(0).slopeSquared + profile.bounds(profile.segments() - 1).slopeSquared;
  profile.forLargestBlocks([&](std::size_t level, std::size_t block) {
    integral += profile.block(level, block).slopeSquared;
    return true;
  });
  return integral;
}

bool addBounds(PreparedProfile& profile, const std::stop_token& stop) {
  profile.blocks.resize(std::max<std::size_t>(profile.blocks.size(), 1));
  const bool isCubic = profile.scheme == Scheme::Cubic;
  if (!(isCubic ? addCubicBlocks(profile, stop) : addStraightBlocks(profile, stop))) return false;
  profile.meanHeight = integralOf(profile) / profile.length;
  profile.slopeSquaredIntegral = slopeSquaredIntegralOf(profile);
  if (stop.stop_requested()) return false;
  if (isCubic)
    addCuts(profile);
  else
    profile.cuts.clear();
  return true;
}

bool addResolvedSegments(PreparedProfile& profile, const Line& line, const TravelOrder& order,
                         const Lowest& lowest, const std::stop_token& stop) {
  const double h = line.spacing, t = lowest.fraction;
  const std::size_t count = line.nodes(), split = t > 0 ? 1 : 0;
  profile.startsInsideSegment = t > 0;
  profile.startFraction = t;
  profile.firstLength = (1 - t) * h;
  profile.lastLength = t > 0 ? t * h : h;
  if (!resizeFor(profile, count + split, stop)) return false;
  std::size_t node = lowest.node;
  if (split > 0) node = order.next(node);
  node = setWholeSegments(profile, line, order, node, split, count - split);
  if (split > 0) {
    // The segment of the lowest point is split into two parts, level at that point. They are
    // expanded about it, because the difference of two heights would lose the small rise next to
    // it.
    const Cubic whole = order.cubicAfter(node, lowest.height).about(t);
    const Cubic level{0, 0, whole.c2, whole.c3};
    setSegment(profile, 0, 0, 0, level.derivative(1 - t) / h);
    setSegment(profile, count, level(-t), level.derivative(-t) / h, 0);
    profile.heightAboveMinimum[1] = level(1 - t);
  }
  profile.heightAboveMinimum.back() = 0;
  return !stop.stop_requested() && addBounds(profile, stop);
}

bool addNodes(PreparedProfile& profile, const Line& line, const TravelOrder& order,
              const Lowest& lowest, const std::stop_token& stop) {
  const std::size_t count = line.nodes();
  profile.heightAboveMinimum.resize(count + 1);
  profile.slopeIn.resize(count);
  profile.slopeOut.clear();
  profile.startsInsideSegment = false;
  profile.startFraction = 0;
  profile.firstLength = profile.lastLength = line.spacing;
  profile.meanHeight = profile.slopeSquaredIntegral = 0;
  std::size_t node = lowest.node;
  for (std::size_t i = 0; i < count; ++i) {
    profile.heightAboveMinimum[i] = line.height[node] - lowest.height;
    // At a corner the element takes the mean of both sides.
    profile.slopeIn[i] = 0.5 * (order.slopeBefore(node) + order.slopeAfter(node));
    profile.meanHeight += profile.heightAboveMinimum[i];
    node = order.next(node);
  }
  profile.heightAboveMinimum[count] = 0;
  profile.meanHeight /= static_cast<double>(count);
  profile.blocks.resize(std::max<std::size_t>(profile.blocks.size(), 1));
  profile.blocks[0].resizeForNodal(count - 1);
  std::copy_n(profile.heightAboveMinimum.begin() + 1, count - 1, profile.blocks[0].lowest.begin());
  return addBlocksOver(profile, 0, stop);
}

}  // namespace

Cubic PreparedProfile::segment(std::size_t i) const {
  const double h = segmentLength(i);
  return hermiteCubic(heightAboveMinimum[i], heightAboveMinimum[i + 1], slopeIn[i] * h,
                      slopeAtEnd(i) * h);
}

Cubic PreparedProfile::segmentBackwards(std::size_t i) const {
  const double h = segmentLength(i);
  return hermiteCubic(heightAboveMinimum[i + 1], heightAboveMinimum[i], -slopeAtEnd(i) * h,
                      -slopeIn[i] * h);
}

std::vector<double> inLineOrder(const PreparedProfile& profile, const std::vector<double>& values) {
  // the lowest point is not a node
  const std::size_t skipped = profile.startsInsideSegment ? 1 : 0;
  const std::size_t count = values.size() - skipped;
  std::vector<double> ordered(count);
  for (std::size_t k = skipped; k < values.size(); ++k) {
    ordered[(profile.firstNode + count - k % count) % count] = values[k];
  }
  return ordered;
}

bool prepareProfileInto(PreparedProfile& profile, const Line& line, Scheme scheme,
                        const std::stop_token& stop) {
  profile.scheme = scheme;
  profile.length = line.length;
  profile.spacing = line.spacing;
  profile.rmsHeight = line.rmsHeight;
  profile.rmsSlope = line.rmsSlope;
  const TravelOrder order(line);
  const Lowest lowest = findLowest(line, order, scheme);
  profile.firstNode = lowest.node;
  profile.lowestHeight = lowest.height;
  if (stop.stop_requested()) return false;
  return scheme == Scheme::Nodal ? addNodes(profile, line, order, lowest, stop)
                                 : addResolvedSegments(profile, line, order, lowest, stop);
}

PreparedProfile prepareProfile(const Line& line, Scheme scheme) {
  PreparedProfile profile;
  prepareProfileInto(profile, line, scheme);
  return profile;
}

}  // namespace asperity
