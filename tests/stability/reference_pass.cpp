#include "tests/stability/reference_pass.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace asperity {
namespace {

struct Sums {
  Wide depth = 0, stiffness = 0, dissipation = 0, contact = 0;
};

class ResolvedReference {
 public:
  ResolvedReference(const Line& line, Scheme scheme) : line_(line, scheme) {}

  Wide length() const { return line_.length; }
  Wide meanRise() const { return line_.meanRise; }

  Sums at(Wide depth, Wide memory) {
    depth_ = depth;
    memory_ = memory;
    sums_ = {};
    touching_ = true;
    for (const Piece& piece : line_.pieces) take(piece);
    if (!touching_) close(line_.length);
    return sums_;
  }

 private:
  void take(const Piece& piece) {
    const Polynomial& z = piece.rise;
    if (!touching_ &&
        piece.lowest() > leftRise_ + (depth_ - leftRise_) * lost(piece.origin + piece.to))
      return;  // the surface is below it all along
    const Polynomial p{depth_ - z.a0 - memory_ * z.a1, -z.a1 - 2 * memory_ * z.a2,
                       -z.a2 - 3 * memory_ * z.a3, -z.a3};
    Wide from = piece.from;
    for (const Wide to : signChanges(p, piece.from, piece.to)) {
      if (p(from + (to - from) / 2) > 0)
        press(piece, from, to);
      else if (touching_)
        leave(z(from), piece.origin + from);
      from = to;
    }
  }

  void leave(Wide rise, Wide position) {
    touching_ = false;
    leftRise_ = rise;
    leftPosition_ = position;
  }

  Wide lost(Wide position) const {
    return memory_ > 0 ? -std::expm1(-(position - leftPosition_) / memory_)
                       : Wide(position > leftPosition_ ? 1 : 0);
  }

  /// How far the line is below the surface that comes back.
  Wide gap(const Piece& piece, Wide x) const {
    return (leftRise_ - piece.rise(x)) + (depth_ - leftRise_) * lost(piece.origin + x);
  }

  void press(const Piece& piece, Wide from, Wide to) {
    if (!touching_) {
      const Wide middle = from + (to - from) / 2;
      if (!(gap(piece, to) > 0 || gap(piece, middle) > 0)) return;
      const Wide reached = gap(piece, to) > 0 ? to : middle;
      if (gap(piece, from) < 0) from = bisect(from, reached, [&](Wide x) { return gap(piece, x); });
      close(piece.origin + from);
      touching_ = true;
    }
    const Wide squares =
        integral(from, to, [&](Wide x) { return piece.rise.slope(x) * piece.rise.slope(x); });
    sums_.depth += integral(from, to, [&](Wide x) { return depth_ - piece.rise(x); });
    sums_.dissipation += memory_ * squares;
    sums_.stiffness += to - from;
    sums_.contact += to - from;
  }

  void close(Wide position) {
    const Wide forgotten = lost(position), start = depth_ - leftRise_;
    sums_.depth += start * memory_ * forgotten;
    sums_.stiffness += memory_ * forgotten;
    sums_.dissipation += start * start / 2 * forgotten * (2 - forgotten);
  }

  ReferenceLine line_;
  Wide depth_ = 0, memory_ = 0, leftRise_ = 0, leftPosition_ = 0;
  bool touching_ = true;
  Sums sums_;
};

ReferenceResult resolvedSliding(const Line& line, Scheme scheme, Wide memory, Wide load, Wide depth,
                                Wide guess) {
  ResolvedReference reference(line, scheme);
  Sums sums;
  if (load > 0) {
    Wide low = load / reference.length(), high = low + reference.meanRise();
    depth = guess > low && guess < high ? guess : high;
    for (int i = 0; i < 300; ++i) {
      sums = reference.at(depth, memory);
      const Wide excess = sums.depth - load;
      if (std::abs(excess) <= 4e-19L * load) break;
      (excess > 0 ? high : low) = depth;
      Wide next = depth - excess / sums.stiffness;
      if (!(next >= low && next <= high)) next = low + (high - low) / 2;
      if (next == depth) break;
      depth = next;
    }
  } else {
    sums = reference.at(depth, memory);
  }
  return {depth, sums.dissipation / sums.depth, sums.contact / reference.length()};
}

class NodalReference {
 public:
  NodalReference(const Line& line, Wide memory) : spacing_(line.spacing), memory_(memory) {
    const ReferenceNodes nodes(line);
    const auto lowest = std::min_element(line.height.begin(), line.height.end());
    auto node = static_cast<std::size_t>(lowest - line.height.begin());
    for (std::size_t k = 0; k < line.nodes(); ++k, node = nodes.next(node)) {
      rise_.push_back(Wide(line.height[node]) - *lowest);
      slope_.push_back((nodes.slopeBefore(node) + nodes.slopeAfter(node)) / 2);
    }
    lost_ = memory > 0 ? -std::expm1(-spacing_ / memory) : 1;
  }

  struct State {
    Wide force = 0, work = 0, loaded = 0;
  };

  State at(Wide depth) const {
    State state;
    if (depth < 0) return state;
    Wide surface = depth;  // height above the line's lowest point of what reaches the next node
    for (std::size_t i = 0; i < rise_.size(); ++i) {
      if (rise_[i] <= surface) {
        surface = rise_[i];
        const Wide p = depth - rise_[i] - memory_ * slope_[i];
        if (p > 0) {
          state.force += p * spacing_;
          state.work -= p * slope_[i] * spacing_;
          state.loaded += 1;
        }
      }
      surface += (depth - surface) * lost_;
    }
    return state;
  }

  ReferenceResult underLoad(Wide load) const {
    // What is loaded as soon as anything touches jumps at 0.
    const bool atOnce = at(0).force >= load;
    Wide low = atOnce ? -1 : 0, high = atOnce ? 0 : load / spacing_;
    while (at(high).force < load) high *= 2;
    while (!atOnce) {
      const Wide middle = low + (high - low) / 2;
      if (middle <= low || middle >= high) break;
      (at(middle).force < load ? low : high) = middle;
    }
    const State less = at(low), more = at(high);
    const Wide share = (load - less.force) / (more.force - less.force);
    const bool jumps = less.loaded != more.loaded;
    return {high, (less.work + share * (more.work - less.work)) / load,
            (less.loaded + share * (more.loaded - less.loaded)) / static_cast<Wide>(rise_.size()),
            jumps ? share : 1};
  }
  ReferenceResult atDepth(Wide depth) const {
    const State state = at(depth);
    return {depth, state.work / state.force, state.loaded / static_cast<Wide>(rise_.size()), 1};
  }

 private:
  std::vector<Wide> rise_, slope_;
  Wide spacing_, memory_, lost_;
};

}  // namespace

ReferenceResult referenceSliding(const Line& line, Scheme scheme,
                                 const SlidingConditions& conditions, const Load& load,
                                 double guess) {
  const Wide memory = Wide(conditions.velocity) * conditions.relaxationTime;
  const bool byForce = load.kind == LoadKind::Force;
  const Wide perStiffness = byForce ? load.normalForce / (4 * Wide(conditions.shearModulus)) : 0;
  if (scheme != Scheme::Nodal)
    return resolvedSliding(line, scheme, memory, perStiffness, load.depth, guess);
  const NodalReference reference(line, memory);
  return byForce ? reference.underLoad(perStiffness) : reference.atDepth(load.depth);
}

}  // namespace asperity
