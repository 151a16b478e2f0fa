#include "tests/stability/reference_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

namespace asperity {
namespace {

/// a0 + a1 x + a2 x^2 + a3 x^3, x in m.
struct Polynomial {
  Wide a0, a1, a2, a3;

  Wide operator()(Wide x) const { return a0 + x * (a1 + x * (a2 + x * a3)); }
  Wide slope(Wide x) const { return a1 + x * (2 * a2 + x * 3 * a3); }
  Polynomial about(Wide x) const { return {(*this)(x), slope(x), a2 + 3 * a3 * x, a3}; }
};

/// The rise over [from, to], measured in x from `origin` (all in m along the travel).
struct Piece {
  Polynomial rise;
  Wide from, to, origin;
};

/// The zero of a function that changes sign once in [low, high], to the last bit.
Wide bisect(Wide low, Wide high, const std::function<Wide(Wide)>& function) {
  const bool rising = function(low) < 0;
  while (true) {
    const Wide middle = low + (high - low) / 2;
    if (middle <= low || middle >= high) return middle;
    ((function(middle) < 0) == rising ? low : high) = middle;
  }
}

/// Zeros of the slope, ascending, inside (from, to).
std::vector<Wide> turningPoints(const Polynomial& p, Wide from, Wide to) {
  const Wide a = 3 * p.a3, b = p.a2, c = p.a1;
  const Wide discriminant = b * b - a * c;
  std::vector<Wide> points;
  if (discriminant < 0) return points;
  const Wide q = -(b + std::copysign(std::sqrt(discriminant), b));
  if (a != 0) points.push_back(q / a);
  if (q != 0) points.push_back(c / q);
  std::erase_if(points, [&](Wide x) { return !(x > from && x < to); });
  std::sort(points.begin(), points.end());
  return points;
}

/// Ends of the stretches of [from, to] on which `p` keeps its sign.
std::vector<Wide> signChanges(const Polynomial& p, Wide from, Wide to) {
  std::vector<Wide> stops = turningPoints(p, from, to), ends;
  stops.push_back(to);
  Wide last = from;
  for (const Wide stop : stops) {
    if ((p(last) < 0) != (p(stop) < 0)) ends.push_back(bisect(last, stop, p));
    last = stop;
  }
  ends.push_back(to);
  return ends;
}

/// Integral over [from, to] of a polynomial up to degree 7.
template <class Function>
Wide integral(Wide from, Wide to, const Function& function) {
  static const Wide inner = std::sqrt(Wide(3) / 7 - Wide(2) / 7 * std::sqrt(Wide(6) / 5));
  static const Wide outer = std::sqrt(Wide(3) / 7 + Wide(2) / 7 * std::sqrt(Wide(6) / 5));
  static const Wide heavy = (18 + std::sqrt(Wide(30))) / 36;
  const Wide half = (to - from) / 2, middle = from + half;
  const auto pair = [&](Wide place) {
    return function(middle - place * half) + function(middle + place * half);
  };
  return half * (heavy * pair(inner) + (1 - heavy) * pair(outer));
}

/// Nodes as material meets them when the line slides towards +x: from right to left.
class Nodes {
 public:
  explicit Nodes(const Line& line) : line_(line) {}
  std::size_t next(std::size_t i) const { return i == 0 ? line_.nodes() - 1 : i - 1; }
  Wide slopeAfter(std::size_t i) const { return -Wide(line_.slopeLeftOf(i)); }
  Wide slopeBefore(std::size_t i) const { return -Wide(line_.slopeAfter[i]); }
  Wide spacing() const { return line_.spacing; }

  /// Over the segment after node i, x from that node, heights from that node's.
  Polynomial after(std::size_t i, Scheme scheme) const {
    const std::size_t to = next(i);
    const Wide h = spacing(), climb = Wide(line_.height[to]) - line_.height[i];
    if (scheme == Scheme::Linear) return {0, climb / h, 0, 0};
    const Wide in = slopeAfter(i), out = slopeBefore(to), mean = climb / h;
    return {0, in, (3 * mean - 2 * in - out) / h, (in + out - 2 * mean) / (h * h)};
  }

 private:
  const Line& line_;
};

struct Sums {
  Wide depth = 0, stiffness = 0, dissipation = 0, contact = 0;
};

class ResolvedReference {
 public:
  ResolvedReference(const Line& line, Scheme scheme) : length_(line.length) {
    const Nodes nodes(line);
    std::size_t start = 0;
    Wide drop = 0, inside = 0;  // of the lowest point below its node, and its way from there
    const auto above = [&](std::size_t node) {
      return (Wide(line.height[node]) - line.height[start]) - drop;
    };
    for (std::size_t i = 0; i < line.nodes(); ++i) {
      const Polynomial p = nodes.after(i, scheme);
      std::vector<Wide> places{0};
      if (scheme == Scheme::Cubic)
        for (const Wide x : turningPoints(p, 0, nodes.spacing())) places.push_back(x);
      for (const Wide x : places)
        if (above(i) + p(x) < 0) {
          start = i;
          drop = p(x);
          inside = x;
        }
    }
    const Wide h = nodes.spacing();
    length_ = h * static_cast<Wide>(line.nodes());
    const auto count = line.nodes();
    std::size_t node = start;
    for (std::size_t k = 0; k < count; ++k, node = nodes.next(node)) {
      const Polynomial p = nodes.after(node, scheme);
      const Wide origin = h * static_cast<Wide>(k) - inside;
      if (k == 0) {
        const Polynomial here = level(p.about(inside), inside > 0);
        pieces_.push_back({here, 0, h - inside, 0});
        if (inside > 0) last_ = {here, -inside, 0, length_};
      } else if (k + 1 == count && inside == 0) {
        last_ = {level(p.about(h), false), -h, 0, length_};
      } else {
        // From the lower end, next to which contact is.
        const bool back = line.height[nodes.next(node)] < line.height[node];
        Polynomial rise = back ? p.about(h) : p;
        rise.a0 = above(back ? nodes.next(node) : node);
        pieces_.push_back({rise, back ? -h : 0, back ? 0 : h, back ? origin + h : origin});
      }
    }
    pieces_.push_back(last_);
    for (const Piece& piece : pieces_)
      meanRise_ += integral(piece.from, piece.to, piece.rise) / length_;
  }

  Wide length() const { return length_; }
  Wide meanRise() const { return meanRise_; }

  Sums at(Wide depth, Wide memory) {
    depth_ = depth;
    memory_ = memory;
    sums_ = {};
    touching_ = true;
    for (const Piece& piece : pieces_) take(piece);
    if (!touching_) close(length_);
    return sums_;
  }

 private:
  static Polynomial level(Polynomial p, bool smooth) {
    p.a0 = 0;
    if (smooth) p.a1 = 0;
    return p;
  }

  void take(const Piece& piece) {
    const Polynomial& z = piece.rise;
    if (!touching_ &&
        lowestOf(piece) > leftRise_ + (depth_ - leftRise_) * lost(piece.origin + piece.to))
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

  static Wide lowestOf(const Piece& piece) {
    Wide lowest = std::min(piece.rise(piece.from), piece.rise(piece.to));
    for (const Wide x : turningPoints(piece.rise, piece.from, piece.to))
      lowest = std::min(lowest, piece.rise(x));
    return lowest;
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

  std::vector<Piece> pieces_;
  Piece last_{};
  Wide length_, meanRise_ = 0;
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
  return {depth, sums.dissipation / sums.depth, sums.contact / reference.length(), 1};
}

class NodalReference {
 public:
  NodalReference(const Line& line, Wide memory) : spacing_(line.spacing), memory_(memory) {
    const Nodes nodes(line);
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
