#include "ui/draw/polyline.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace asperity {
namespace {

struct Piece {
  DrawPoint from, to;
};

DrawPoint between(const DrawPoint& a, const DrawPoint& b, double t) {
  return {static_cast<float>(a.x + t * (static_cast<double>(b.x) - a.x)),
          static_cast<float>(a.y + t * (static_cast<double>(b.y) - a.y))};
}

/// Clips a segment by the method of Liang and Barsky (1984).
std::optional<Piece> inside(const Box& box, const DrawPoint& a, const DrawPoint& b) {
  double first = 0, last = 1;
  const double dx = static_cast<double>(b.x) - a.x, dy = static_cast<double>(b.y) - a.y;
  const double steps[4][2] = {{-dx, static_cast<double>(a.x) - box.x},
                              {dx, static_cast<double>(box.right()) - a.x},
                              {-dy, static_cast<double>(a.y) - box.y},
                              {dy, static_cast<double>(box.bottom()) - a.y}};
  for (const auto& [change, distance] : steps) {
    if (change == 0) {
      if (distance < 0) return std::nullopt;
    } else if (change < 0) {
      first = std::max(first, distance / change);
    } else {
      last = std::min(last, distance / change);
    }
  }
  if (first > last) return std::nullopt;
  return Piece{first > 0 ? between(a, b, first) : a, last < 1 ? between(a, b, last) : b};
}

}  // namespace

std::vector<Polyline> clippedTo(const Box& box, const Polyline& line) {
  std::vector<Polyline> parts;
  if (line.size() == 1 && isFinite(line[0]) && inside(box, line[0], line[0])) return {line};
  bool joined = false;  // whether the last part ends where the next segment begins
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    if (!isFinite(line[i]) || !isFinite(line[i + 1])) {
      joined = false;
      continue;
    }
    const auto piece = inside(box, line[i], line[i + 1]);
    if (!piece) {
      joined = false;
      continue;
    }
    if (!joined || !isSamePoint(parts.back().back(), piece->from)) parts.push_back({piece->from});
    parts.back().push_back(piece->to);
    joined = isSamePoint(piece->to, line[i + 1]);
  }
  return parts;
}

std::vector<Polyline> dashed(const Polyline& line, float on, float off) {
  std::vector<Polyline> pieces;
  if (line.empty() || !(on >= 0) || !(off > 0)) return pieces;
  const double period = static_cast<double>(on) + off;
  pieces.push_back({line[0]});
  bool drawing = on > 0;
  double left = drawing ? on : period;  // rest of the dash or the gap
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double length = std::hypot(line[i + 1].x - line[i].x, line[i + 1].y - line[i].y);
    double at = 0;
    while (length - at >= left) {
      at += left;
      const DrawPoint here = between(line[i], line[i + 1], at / length);
      if (drawing)
        pieces.back().push_back(here);
      else
        pieces.push_back({here});
      drawing = on > 0 && !drawing;
      left = on == 0 ? period : drawing ? on : off;
    }
    left -= length - at;
    if (drawing && length > at) pieces.back().push_back(line[i + 1]);
  }
  // The line ended at the beginning of a dash.
  if (on > 0 && pieces.size() > 1 && pieces.back().size() == 1) pieces.pop_back();
  return pieces;
}

}  // namespace asperity
