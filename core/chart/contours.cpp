#include "core/chart/contours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <unordered_map>

namespace asperity {
namespace {

/// The sides of all cells are numbered: those along x first.
class Grid {
 public:
  Grid(std::span<const double> x, std::span<const double> y, std::span<const double> values,
       double level)
      : x_(x), y_(y), values_(values), level_(level) {}

  std::size_t columns() const { return x_.size(); }
  std::size_t rows() const { return y_.size(); }
  double at(std::size_t i, std::size_t j) const { return values_[j * columns() + i]; }

  std::size_t alongX(std::size_t i, std::size_t j) const { return j * columns() + i; }
  std::size_t alongY(std::size_t i, std::size_t j) const {
    return columns() * rows() + j * columns() + i;
  }

  /// Returns the point at which a side crosses the level.
  ContourPoint pointOn(std::size_t side) const {
    const bool isAlongY = side >= columns() * rows();
    const std::size_t node = isAlongY ? side - columns() * rows() : side;
    const std::size_t i = node % columns(), j = node / columns();
    const double a = at(i, j), b = isAlongY ? at(i, j + 1) : at(i + 1, j);
    const double t = (level_ - a) / (b - a);
    return isAlongY ? ContourPoint{x_[i], y_[j] + t * (y_[j + 1] - y_[j])}
                    : ContourPoint{x_[i] + t * (x_[i + 1] - x_[i]), y_[j]};
  }

 private:
  std::span<const double> x_, y_, values_;
  double level_;
};

/// A piece of a contour line between two sides of one cell.
struct Piece {
  std::size_t from = 0, to = 0;
};

std::vector<Piece> findPieces(const Grid& grid, double level) {
  std::vector<Piece> pieces;
  for (std::size_t j = 0; j + 1 < grid.rows(); ++j)
    for (std::size_t i = 0; i + 1 < grid.columns(); ++i) {
      // The corners are counter-clockwise, and each side follows its corner.
      const std::array<double, 4> corner{grid.at(i, j), grid.at(i + 1, j), grid.at(i + 1, j + 1),
                                         grid.at(i, j + 1)};
      if (std::ranges::any_of(corner, [](double value) { return !std::isfinite(value); })) continue;
      const std::array<std::size_t, 4> side{grid.alongX(i, j), grid.alongY(i + 1, j),
                                            grid.alongX(i, j + 1), grid.alongY(i, j)};
      std::array<std::size_t, 4> crossed{};
      std::size_t count = 0;
      for (std::size_t k = 0; k < 4; ++k)
        if ((corner[k] >= level) != (corner[(k + 1) % 4] >= level)) crossed[count++] = k;
      if (count == 2) pieces.push_back({side[crossed[0]], side[crossed[1]]});
      if (count != 4) continue;
      // In a saddle the corners on the same side of the level as the middle are connected through
      // it; the two others are cut off.
      const bool isHigh = (corner[0] + corner[1] + corner[2] + corner[3]) / 4 >= level;
      const std::size_t first = (corner[0] >= level) == isHigh ? 1 : 0;  // a corner cut off
      pieces.push_back({side[(first + 3) % 4], side[first]});
      pieces.push_back({side[(first + 1) % 4], side[(first + 2) % 4]});
    }
  return pieces;
}

/// Joins the pieces that meet on a side to lines.
class Joining {
 public:
  explicit Joining(const std::vector<Piece>& pieces) : pieces_(pieces), isUsed_(pieces.size()) {
    for (std::size_t k = 0; k < pieces.size(); ++k)
      for (const std::size_t side : {pieces[k].from, pieces[k].to}) {
        auto& [first, second] = at_.try_emplace(side, kNone, kNone).first->second;
        (first == kNone ? first : second) = k;
      }
  }

  std::vector<std::vector<std::size_t>> lines() {
    std::vector<std::vector<std::size_t>> lines;
    // Lines that end at the edge of the grid begin there; the remaining lines are closed.
    for (const bool closed : {false, true})
      for (std::size_t k = 0; k < pieces_.size(); ++k) {
        if (isUsed_[k]) continue;
        if (closed || isEnd(pieces_[k].from))
          lines.push_back(follow(k, pieces_[k].from));
        else if (isEnd(pieces_[k].to))
          lines.push_back(follow(k, pieces_[k].to));
      }
    return lines;
  }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  bool isEnd(std::size_t side) const { return at_.at(side).second == kNone; }

  std::vector<std::size_t> follow(std::size_t piece, std::size_t side) {
    std::vector<std::size_t> line{side};
    while (piece != kNone && !isUsed_[piece]) {
      isUsed_[piece] = true;
      side = pieces_[piece].from == side ? pieces_[piece].to : pieces_[piece].from;
      line.push_back(side);
      const auto& [first, second] = at_.at(side);
      piece = first == piece ? second : first;
    }
    return line;
  }

  const std::vector<Piece>& pieces_;
  std::vector<bool> isUsed_;
  std::unordered_map<std::size_t, std::pair<std::size_t, std::size_t>> at_;  // pieces on a side
};

}  // namespace

std::vector<ContourLine> contourLines(std::span<const double> x, std::span<const double> y,
                                      std::span<const double> values, double level) {
  const Grid grid(x, y, values, level);
  const std::vector<Piece> pieces = findPieces(grid, level);
  std::vector<ContourLine> lines;
  for (const std::vector<std::size_t>& sides : Joining(pieces).lines()) {
    ContourLine line;
    for (const std::size_t side : sides) {
      const ContourPoint point = grid.pointOn(side);
      // A level that runs through a node is crossed on several sides in the same place.
      if (line.empty() || !(point == line.back())) line.push_back(point);
    }
    if (line.size() > 1) lines.push_back(std::move(line));
  }
  return lines;
}

std::vector<double> contourLevels(double from, double to, bool isLogarithmic, int count) {
  std::vector<double> levels;
  if (!(from < to) || count < 1 || (isLogarithmic && !(from > 0))) return levels;
  if (isLogarithmic) {
    const double decades = std::log10(to / from);
    constexpr double kThree = 2, kTwoFive = 3;
    const double perDecade = count / decades;
    // With fewer than one level per decade, whole powers of ten have equal steps.
    const int step = std::max(1, static_cast<int>(std::lround(1 / perDecade)));
    std::vector<double> factors{1};
    if (perDecade >= kTwoFive)
      factors = {1, 2, 5};
    else if (perDecade >= kThree)
      factors = {1, 3};
    if (perDecade < 2 * kTwoFive || decades > 1.5) {
      const int last = static_cast<int>(std::floor(std::log10(to)));
      for (int decade = static_cast<int>(std::floor(std::log10(from))); decade <= last; ++decade) {
        if (decade % step != 0) continue;
        for (const double factor : factors) {
          const double level = factor * std::pow(10.0, decade);
          if (level > from && level < to) levels.push_back(level);
        }
      }
      return levels;
    }
  }
  const double raw = (to - from) / count;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  double step = 10 * power;
  for (const double factor : {5.0, 2.0, 1.0})
    if (factor * power >= raw) step = factor * power;
  // Where the range is a few roundings wide, a multiple of the step may equal the next one. A loop
  // up to the end of the range would then never end, so the number of steps ends it.
  const double first = std::floor(from / step);
  for (int i = 0; i <= count + 1; ++i) {
    const double level = (first + i) * step;
    if (level > (levels.empty() ? from : levels.back()) && level < to) levels.push_back(level);
  }
  return levels;
}

}  // namespace asperity
