#include "tests/stability/reference_line.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace asperity {
namespace {

/// The lowest point itself, where the line is at 0 and, inside a segment, level.
Polynomial level(Polynomial p, bool smooth) {
  p.a0 = 0;
  if (smooth) p.a1 = 0;
  return p;
}

}  // namespace

Wide Piece::lowest() const {
  Wide lowest = std::min(rise(from), rise(to));
  for (const Wide x : turningPoints(rise, from, to)) lowest = std::min(lowest, rise(x));
  return lowest;
}

Wide bisect(Wide low, Wide high, const std::function<Wide(Wide)>& function) {
  const bool rising = function(low) < 0;
  while (true) {
    const Wide middle = low + (high - low) / 2;
    if (middle <= low || middle >= high) return middle;
    ((function(middle) < 0) == rising ? low : high) = middle;
  }
}

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

/// Newton's method for the zeros of Legendre's polynomial.
template <int Count>
GaussPoints<Count>::GaussPoints() {
  for (int i = 0; i < Count; ++i) {
    Wide x = std::cos(std::numbers::pi_v<Wide> * (i + 0.75L) / (Count + 0.5L)), slope = 0;
    for (int step = 0; step < 20; ++step) {
      Wide last = 1, now = x;
      for (int n = 2; n <= Count; ++n)
        last = std::exchange(now, ((2 * n - 1) * x * now - (n - 1) * last) / n);
      slope = Count * (x * now - last) / (x * x - 1);
      x -= now / slope;
    }
    place[static_cast<std::size_t>(i)] = x;
    weight[static_cast<std::size_t>(i)] = 2 / ((1 - x * x) * slope * slope);
  }
}
template struct GaussPoints<4>;
template struct GaussPoints<10>;

Polynomial ReferenceNodes::after(std::size_t i, Scheme scheme) const {
  const std::size_t to = next(i);
  const Wide h = spacing(), climb = Wide(line_.height[to]) - line_.height[i];
  if (scheme == Scheme::Linear) return {0, climb / h, 0, 0};
  const Wide in = slopeAfter(i), out = slopeBefore(to), mean = climb / h;
  return {0, in, (3 * mean - 2 * in - out) / h, (in + out - 2 * mean) / (h * h)};
}

ReferenceLine::ReferenceLine(const Line& line, Scheme scheme) : length(line.length) {
  const ReferenceNodes nodes(line);
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
  Piece last{};
  length = h * static_cast<Wide>(line.nodes());
  const auto count = line.nodes();
  std::size_t node = start;
  for (std::size_t k = 0; k < count; ++k, node = nodes.next(node)) {
    const Polynomial p = nodes.after(node, scheme);
    const Wide origin = h * static_cast<Wide>(k) - inside;
    if (k == 0) {
      const Polynomial here = level(p.about(inside), inside > 0);
      pieces.push_back({here, 0, h - inside, 0});
      if (inside > 0) last = {here, -inside, 0, length};
    } else if (k + 1 == count && inside == 0) {
      last = {level(p.about(h), false), -h, 0, length};
    } else {
      // From the lower end, next to which contact is.
      const bool back = line.height[nodes.next(node)] < line.height[node];
      Polynomial rise = back ? p.about(h) : p;
      rise.a0 = above(back ? nodes.next(node) : node);
      pieces.push_back({rise, back ? -h : 0, back ? 0 : h, back ? origin + h : origin});
    }
  }
  pieces.push_back(last);
  for (const Piece& piece : pieces) meanRise += integral(piece.from, piece.to, piece.rise) / length;
}

}  // namespace asperity
