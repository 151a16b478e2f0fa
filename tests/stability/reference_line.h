// The line of the references: its rise above the lowest point in pieces as material meets them, in
// the widest numbers of the machine, and what finds edges and integrals on it. Made apart from
// core/contact, which it is to check. Pure functions and plain values.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "core/scene/scene.h"
#include "core/surface/line.h"

namespace asperity {

using Wide = long double;

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

  Wide lowest() const;
};

/// The zero of a function that changes sign once in [low, high], to the last bit.
Wide bisect(Wide low, Wide high, const std::function<Wide(Wide)>& function);

/// Zeros of the slope, ascending, inside (from, to).
std::vector<Wide> turningPoints(const Polynomial& p, Wide from, Wide to);

/// Ends of the stretches of [from, to] on which `p` keeps its sign.
std::vector<Wide> signChanges(const Polynomial& p, Wide from, Wide to);

/// Gauss's points and weights on [-1, 1].
template <int Count>
struct GaussPoints {
  GaussPoints();
  std::array<Wide, Count> place, weight;
};
extern template struct GaussPoints<4>;
extern template struct GaussPoints<10>;

/// Integral over [from, to] of what ten points do: polynomials up to degree 19, an exponential over
/// half of its decay; or of what four do: degree 7, a hundredth of a decay.
template <int Count = 10, class Function>
Wide integral(Wide from, Wide to, const Function& function) {
  static const GaussPoints<Count> points;
  const Wide half = (to - from) / 2, middle = from + half;
  Wide sum = 0;
  for (std::size_t i = 0; i < points.place.size(); ++i)
    sum += points.weight[i] * function(middle + half * points.place[i]);
  return half * sum;
}

/// Nodes as material meets them when the line slides towards +x: from right to left.
class ReferenceNodes {
 public:
  explicit ReferenceNodes(const Line& line) : line_(line) {}
  std::size_t next(std::size_t i) const { return i == 0 ? line_.nodes() - 1 : i - 1; }
  Wide slopeAfter(std::size_t i) const { return -Wide(line_.slopeLeftOf(i)); }
  Wide slopeBefore(std::size_t i) const { return -Wide(line_.slopeAfter[i]); }
  Wide spacing() const { return line_.spacing; }

  /// Over the segment after node i, x from that node, heights from that node's.
  Polynomial after(std::size_t i, Scheme scheme) const;

 private:
  const Line& line_;
};

/// A resolved line from its lowest point around to it.
struct ReferenceLine {
  ReferenceLine(const Line& line, Scheme scheme);

  std::vector<Piece> pieces;
  Wide length, meanRise = 0;  // m
};

}  // namespace asperity
