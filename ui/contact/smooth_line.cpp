#include "ui/contact/smooth_line.h"

#include <algorithm>
#include <cmath>

#include "core/contact/line/polynomial.h"

namespace asperity {

std::vector<LinePoint> sampledLine(const Line& line, std::size_t atLeast) {
  const std::size_t n = line.nodes();
  std::vector<LinePoint> points;
  if (n == 0) return points;
  const bool smooth = line.slopeAfter.size() == n;
  const std::size_t pieces = smooth ? std::max<std::size_t>(1, (atLeast + n - 1) / n) : 1;
  points.reserve(n * pieces + 1);
  for (std::size_t i = 0; i < n; ++i) {
    const double x = static_cast<double>(i) * line.spacing;
    points.push_back({x, line.height[i]});
    const std::size_t next = (i + 1) % n;
    const double step = line.height[next] - line.height[i];
    for (std::size_t k = 1; k < pieces; ++k) {
      const double t = static_cast<double>(k) / static_cast<double>(pieces);
      const double rise =
          hermiteRise(t, step, line.spacing, line.slopeAfter[i], line.slopeLeftOf(next));
      points.push_back({x + t * line.spacing, line.height[i] + rise});
    }
  }
  points.push_back({line.length, line.height.front()});
  return points;
}

std::vector<Place> thinned(const std::vector<Place>& places) {
  std::vector<Place> kept;
  if (places.empty()) return kept;
  kept.push_back(places.front());
  for (std::size_t first = 1, end = first; first + 1 < places.size(); first = end) {
    const float column = std::floor(places[first].x);
    std::size_t low = first, high = first;
    for (end = first; end + 1 < places.size() && std::floor(places[end].x) == column; ++end) {
      if (places[end].y < places[low].y) low = end;
      if (places[end].y > places[high].y) high = end;
    }
    kept.push_back(places[std::min(low, high)]);
    if (low != high) kept.push_back(places[std::max(low, high)]);
  }
  if (places.size() > 1) kept.push_back(places.back());
  return kept;
}

}  // namespace asperity
