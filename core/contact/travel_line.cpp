#include "core/contact/travel_line.h"

#include <algorithm>

namespace asperity {
namespace {

/// The Hermite cubic through two heights with two end slopes (times the segment's length).
Cubic hermite(double h0, double h1, double m0, double m1) {
  const double step = h1 - h0;
  return {h0, m0, 3 * step - 2 * m0 - m1, m0 + m1 - 2 * step};
}

/// One segment in travel order: heights (m) and d z / d s at both ends.
struct Piece {
  double heightIn, heightOut, slopeIn, slopeOut;
};

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
  double slopeAfter(std::size_t node) const {
    return forward_ ? -line_.slopeLeftOf(node) : line_.slopeAfter[node];
  }
  double slopeBefore(std::size_t node) const {
    return forward_ ? -line_.slopeAfter[node] : line_.slopeLeftOf(node);
  }
  Piece piece(std::size_t from, Scheme scheme) const {
    const std::size_t to = next(from);
    Piece piece{line_.height[from], line_.height[to], slopeAfter(from), slopeBefore(to)};
    if (scheme == Scheme::Linear)
      piece.slopeIn = piece.slopeOut = (piece.heightOut - piece.heightIn) / line_.spacing;
    return piece;
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
  const auto node = std::min_element(line.height.begin(), line.height.end());
  Lowest lowest{*node, static_cast<std::size_t>(node - line.height.begin())};
  if (scheme != Scheme::Cubic) return lowest;
  for (std::size_t i = 0; i < line.nodes(); ++i) {
    const Piece piece = traveller.piece(i, scheme);
    // Only where it first falls or at last rises can a segment dip below its ends.
    if (piece.slopeIn >= 0 && piece.slopeOut <= 0) continue;
    const Cubic cubic = hermite(piece.heightIn, piece.heightOut, piece.slopeIn * line.spacing,
                                piece.slopeOut * line.spacing);
    for (const double t : stationaryPoints(cubic))
      if (cubic(t) < lowest.height) lowest = {cubic(t), i, t};
  }
  return lowest;
}

SegmentBounds boundsOf(const Cubic& rise, double length) {
  SegmentBounds bounds{};
  bounds.lowest = std::min(rise(0), rise(1));
  bounds.highest = std::max(rise(0), rise(1));
  for (const double t : stationaryPoints(rise)) {
    bounds.lowest = std::min(bounds.lowest, rise(t));
    bounds.highest = std::max(bounds.highest, rise(t));
  }
  double steepest = std::max(rise.derivative(0), rise.derivative(1));
  const double inflection = rise.c3 != 0 ? -rise.c2 / (3 * rise.c3) : -1;
  if (inflection > 0 && inflection < 1) steepest = std::max(steepest, rise.derivative(inflection));
  bounds.steepest = steepest / length;
  bounds.riseIntegral = rise.integral(1) * length;
  bounds.slopeSquared = rise.integralOfSlopeSquared(1) / length;
  return bounds;
}

void addSegment(TravelLine& travel, const Cubic& rise, double length) {
  travel.rise.push_back(rise(0));
  travel.slopeIn.push_back(rise.derivative(0) / length);
  travel.slopeOut.push_back(rise.derivative(1) / length);
}

/// The parts of `whole` (length h) before and after the fraction t, where its rise and slope are 0.
void addFirstPart(TravelLine& travel, const Cubic& whole, double t, double h) {
  const double length = (1 - t) * h;
  addSegment(travel, hermite(0, whole(1), 0, whole.derivative(1) * (1 - t)), length);
}
void addLastPart(TravelLine& travel, const Cubic& whole, double t, double h) {
  const double length = t * h;
  addSegment(travel, hermite(whole(0), 0, whole.derivative(0) * t, 0), length);
}

SegmentBounds merged(const SegmentBounds* four) {
  SegmentBounds all = four[0];
  for (int i = 1; i < 4; ++i) {
    all.lowest = std::min(all.lowest, four[i].lowest);
    all.highest = std::max(all.highest, four[i].highest);
    all.steepest = std::max(all.steepest, four[i].steepest);
    all.riseIntegral += four[i].riseIntegral;
    all.slopeSquared += four[i].slopeSquared;
  }
  return all;
}

/// Blocks of 1, 4, 16, ... segments, as far as whole ones go.
void addBlocks(TravelLine& travel, std::vector<SegmentBounds> inner) {
  while (!inner.empty()) {
    std::vector<SegmentBounds> coarser(inner.size() / 4);
    for (std::size_t i = 0; i < coarser.size(); ++i) coarser[i] = merged(&inner[4 * i]);
    travel.blocks.push_back(std::move(inner));
    inner = std::move(coarser);
  }
}

void addResolvedSegments(TravelLine& travel, const Line& line, const Traveller& traveller,
                         const Lowest& lowest) {
  const double h = line.spacing;
  const auto cubicFrom = [&](std::size_t node) {
    const Piece piece = traveller.piece(node, travel.scheme);
    return hermite(piece.heightIn - lowest.height, piece.heightOut - lowest.height,
                   piece.slopeIn * h, piece.slopeOut * h);
  };
  const double t = lowest.fraction;
  const std::size_t count = line.nodes();
  std::size_t node = lowest.node;
  travel.startsInsideSegment = t > 0;
  if (travel.startsInsideSegment) {
    addFirstPart(travel, cubicFrom(node), t, h);
    node = traveller.next(node);
  }
  for (std::size_t i = travel.startsInsideSegment ? 1 : 0; i < count; ++i) {
    addSegment(travel, cubicFrom(node), h);
    node = traveller.next(node);
  }
  if (travel.startsInsideSegment) addLastPart(travel, cubicFrom(node), t, h);
  travel.rise.push_back(0);
  for (std::size_t i = 0; i < travel.rise.size(); ++i)
    travel.position.push_back(std::clamp((static_cast<double>(i) - t) * h, 0.0, travel.length));
  travel.position.back() = travel.length;
  for (std::size_t i = 0; i < travel.segments(); ++i) {
    travel.bounds.push_back(boundsOf(travel.segment(i), travel.segmentLength(i)));
    travel.meanRise += travel.bounds.back().riseIntegral / travel.length;
  }
  addBlocks(travel, {travel.bounds.begin() + 1, travel.bounds.end() - 1});
}

void addNodes(TravelLine& travel, const Line& line, const Traveller& traveller,
              const Lowest& lowest) {
  const std::size_t count = line.nodes();
  std::size_t node = lowest.node;
  for (std::size_t i = 0; i <= count; ++i) {
    travel.position.push_back(static_cast<double>(i) * line.spacing);
    travel.rise.push_back(line.height[node] - lowest.height);
    if (i < count) {
      // At a corner the element takes the mean of both sides.
      travel.slopeIn.push_back(0.5 * (traveller.slopeBefore(node) + traveller.slopeAfter(node)));
      travel.meanRise += travel.rise.back() / static_cast<double>(count);
    }
    node = traveller.next(node);
  }
  std::vector<SegmentBounds> inner(count - 1);
  for (std::size_t i = 1; i < count; ++i) inner[i - 1].lowest = travel.rise[i];
  addBlocks(travel, std::move(inner));
}

}  // namespace

Cubic TravelLine::segment(std::size_t i) const {
  const double h = segmentLength(i);
  return hermite(rise[i], rise[i + 1], slopeIn[i] * h, slopeOut[i] * h);
}

std::vector<double> inLineOrder(const TravelLine& travel, const std::vector<double>& values,
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

TravelLine prepareTravel(const Line& line, Scheme scheme, Direction direction) {
  TravelLine travel;
  travel.scheme = scheme;
  travel.length = line.length;
  travel.spacing = line.spacing;
  travel.rmsHeight = line.rmsHeight;
  travel.rmsSlope = line.rmsSlope;
  const Traveller traveller(line, direction);
  const Lowest lowest = findLowest(line, traveller, scheme);
  travel.firstNode = lowest.node;
  travel.lowestHeight = lowest.height;
  if (scheme == Scheme::Nodal)
    addNodes(travel, line, traveller, lowest);
  else
    addResolvedSegments(travel, line, traveller, lowest);
  return travel;
}

}  // namespace asperity
