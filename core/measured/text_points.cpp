// Reads points x, y, z of a topography in a text table, in any order.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/text_table.h"
#include "core/measured/grid_numbers.h"
#include "core/measured/height_table.h"
#include "core/measured/reading_notes.h"
#include "core/measured/text_columns.h"
#include "core/measured/text_lengths.h"
#include "core/measured/text_surface.h"
#include "core/measured/uniform_positions.h"

namespace asperity {
namespace {

struct PointColumns {
  int x = 0, y = 1, z = 2;
};

PointColumns pointColumns(const TextBlock& block, const ColumnRoles& roles) {
  PointColumns columns;
  // The first column numbers the rows.
  if (block.columns.size() > 3 && countsRows(block, 0)) columns = {1, 2, 3};
  if (roles.y >= 0 && roles.x >= 0 && roles.z >= 0) columns = {roles.x, roles.y, roles.z};
  return columns;
}

/// Returns the axis of a grid on which the positions in a column lie, if only nearly; nothing where
/// there is none.
std::optional<GridAxis> columnAxis(const TextBlock& block, int column) {
  std::vector<double> values;
  values.reserve(block.rows);
  for (std::size_t i = 0; i < block.rows; ++i)
    if (const double value = block.at(i, static_cast<std::size_t>(column)); !std::isnan(value))
      values.push_back(value);
  const auto most = static_cast<std::int64_t>(block.rows);
  if (const auto axis = findGridAxis(values, most)) return axis;
  return findNearGridAxis(std::move(values), most);
}

/// The height of a point at the position of an earlier one, its row, and its index in the grid.
struct RepeatedHeight {
  std::size_t at = 0, row = 0;
  double height = 0;
};

/// Replaces the heights at positions that occur several times by their mean.
void takeMeans(std::vector<RepeatedHeight> repeats, std::vector<double>& heights) {
  std::ranges::sort(repeats, {},
                    [](const RepeatedHeight& one) { return std::pair(one.at, one.row); });
  for (std::size_t i = 0; i < repeats.size();) {
    double& height = heights[repeats[i].at];
    double sum = 0, count = 0;
    const auto add = [&](double one) {
      if (std::isnan(one)) return;
      sum += one;
      count += 1;
    };
    add(height);
    const std::size_t at = repeats[i].at;
    for (; i < repeats.size() && repeats[i].at == at; ++i) add(repeats[i].height);
    if (count > 0) height = sum / count;
  }
}

/// Returns whether the positions number the points: they are in pixels, or count by one without a
/// unit where the user states the spacing alone.
bool numberPoints(const SurfaceText& in, const PointColumns& columns,
                  const std::array<GridAxis, 2>& axes) {
  if (std::ranges::any_of(axes, [](const GridAxis& axis) {
        return axis.count > 1 && std::abs(axis.spacing - 1) > 1e-9;
      }))
    return false;
  const TextColumn& x = columnAt(in.block, columns.x);
  const TextColumn& y = columnAt(in.block, columns.y);
  if (isInPixels(x) && isInPixels(y)) return true;
  return in.source.choices.spacing > 0 && in.source.choices.positionUnit == "auto" &&
         (axes[0].first == 0 || axes[0].first == 1) && axes[1].first == axes[0].first &&
         x.unit.empty() && y.unit.empty() && !headerUnit(in, false);
}

constexpr const char* kNoGrid = "the points do not lie on a grid of uniform rows and columns";

/// Returns the index of a position along an axis; nothing where it lies beyond the ends. A number
/// of few digits may be anywhere as far as its rounding goes.
std::optional<std::int64_t> gridIndex(double position, const GridAxis& axis) {
  if (axis.count == 1) return 0;
  const double index = (position - axis.first) / axis.spacing;
  if (!(index >= -1 && index <= static_cast<double>(axis.count))) return {};
  return std::clamp<std::int64_t>(std::llround(index), 0, axis.count - 1);
}

/// Takes the height of each point of the grid; where several points have one position, their mean.
void takeHeights(const TextBlock& block, const PointColumns& columns, const GridAxis& x,
                 const GridAxis& y, const SurfaceSource& source, SurfaceDraft& draft) {
  Topography& grid = draft.grid;
  const double all = static_cast<double>(grid.columns) * static_cast<double>(grid.rows);
  if (all > 4 * static_cast<double>(block.rows)) source.fail(kNoGrid);
  requireSize(source, grid.columns, grid.rows, 0, 0);
  grid.height.assign(static_cast<std::size_t>(grid.columns * grid.rows), kMissingHeight);
  std::vector<bool> isTaken(grid.height.size());
  std::vector<RepeatedHeight> repeats;
  // More points may be those of another surface.
  constexpr std::size_t kMaxRepeats = 10;  // one of so many points
  for (std::size_t i = 0; i < block.rows; ++i) {
    const double px = block.at(i, static_cast<std::size_t>(columns.x));
    const double py = block.at(i, static_cast<std::size_t>(columns.y));
    if (std::isnan(px) || std::isnan(py))
      source.fail(message("line {}: the position is missing", block.lines[i]));
    const auto row = gridIndex(py, y), column = gridIndex(px, x);
    if (!row || !column) source.fail(kNoGrid);
    const auto at = static_cast<std::size_t>(*row * grid.columns + *column);
    const double height = block.at(i, static_cast<std::size_t>(columns.z));
    if (isTaken[at]) {
      repeats.push_back({at, i, height});
      if (kMaxRepeats * repeats.size() > block.rows)
        source.fail(message("line {}: there is a point at this position already",
                            block.lines[repeats.front().row]));
      continue;
    }
    isTaken[at] = true;
    grid.height[at] = height;
  }
  if (!repeats.empty()) {
    draft.facts.notes.push_back(repeatsNote(repeats.size()));
    takeMeans(std::move(repeats), grid.height);
  }
}

/// Takes the units of the columns. areNumbers: there are no positions, but numbers of columns and
/// rows. Returns the unit of y over that of x.
double takeColumnUnits(const SurfaceText& in, const PointColumns& columns, bool areNumbers,
                       SurfaceDraft& draft) {
  std::optional<StatedUnit> rowUnit;
  if (!areNumbers) {
    draft.positionUnit = columnUnit(in, columns.x, false);
    rowUnit = columnUnit(in, columns.y, false);
  }
  draft.heightUnit = columnUnit(in, columns.z, true);
  if (!draft.positionUnit && !areNumbers)
    draft.unknownPositionUnit = unknownUnit(in, columns.x, false);
  if (!draft.heightUnit) draft.unknownHeightUnit = unknownUnit(in, columns.z, true);
  requireHeightName(in.block, columns.z, in.source, draft.facts.notes);
  for (const int column : {columns.x, columns.y, columns.z})
    noteFactor(in.block, column, draft.facts.notes);
  return (rowUnit ? rowUnit->metres : 1) / (draft.positionUnit ? draft.positionUnit->metres : 1);
}

}  // namespace

bool isPointsOfGrid(const TextBlock& block, const ColumnRoles& roles) {
  if (block.columns.size() < 3 || block.rows < 4) return false;
  const PointColumns columns = pointColumns(block, roles);
  const auto x = columnAxis(block, columns.x), y = columnAxis(block, columns.y);
  if (!x || !y || x->count < 2 || y->count < 2) return false;
  const double all = static_cast<double>(x->count) * static_cast<double>(y->count);
  return all <= 2 * static_cast<double>(block.rows) && all >= static_cast<double>(block.rows);
}

std::optional<GridNumbers> gridNumbers(const SurfaceText& in, const ColumnRoles& roles) {
  const bool isStepKnown =
      (in.source.choices.spacing > 0 && in.source.choices.positionUnit == "auto") ||
      headerLength(in, LengthKind::Step, 'x');
  return findGridNumbers(in.block, roles, in.source, isStepKnown);
}

SurfaceDraft readTextPoints(const SurfaceText& in) {
  const TextBlock& block = in.block;
  const SurfaceSource& source = in.source;
  if (block.columns.size() < 3) source.fail("points need three columns: x, y and z");
  const ColumnRoles roles = columnRoles(block, source);
  PointColumns columns = pointColumns(block, roles);
  const auto numbers = gridNumbers(in, roles);
  if (numbers) columns = {numbers->column, numbers->row, numbers->height};
  const auto x = columnAxis(block, columns.x), y = columnAxis(block, columns.y);
  // Numbers of columns and rows are positions only where the user says in which unit.
  const bool areOfGrid =
      numbers && (source.choices.spacing > 0 || source.choices.positionUnit == "auto");
  const auto countsByOne = [](const GridAxis& axis) {
    constexpr double kRounding = 1e-3;
    return std::abs(axis.spacing - 1) < kRounding;
  };
  if (!x || !y || (areOfGrid && !(countsByOne(*x) && countsByOne(*y)))) source.fail(kNoGrid);
  const bool areNumbers = areOfGrid || numberPoints(in, columns, {*x, *y});
  SurfaceDraft draft;
  draft.facts.format = "points";
  draft.facts.positionColumn = columnText(block, columns.x).english();
  draft.facts.heightColumn = columnText(block, columns.z).english();
  draft.facts.notes.push_back(
      areNumbers ? message("Columns of the grid are numbered by {}, rows by {}; heights are {}.",
                           columnText(block, columns.x), columnText(block, columns.y),
                           columnText(block, columns.z))
                 : message("Positions are {} and {}, heights {}.", columnText(block, columns.x),
                           columnText(block, columns.y), columnText(block, columns.z)));
  const double ofRows = takeColumnUnits(in, columns, areNumbers, draft);
  // A single row may also run along y.
  Topography& grid = draft.grid;
  grid.columns = x->count;
  grid.rows = y->count;
  if (areNumbers) {
    takeSpacings(in, draft);
  } else {
    grid.columnSpacing = x->spacing;
    grid.rowSpacing = y->spacing * ofRows;
  }
  takeHeights(block, columns, *x, *y, source, draft);
  if (const double deviation = std::max(x->deviation, y->deviation); deviation > 0)
    draft.facts.notes.push_back(
        message("Positions are up to {:.2g} % of a step off an even grid, on which they are taken.",
                100 * deviation));
  if (grid.columns == 1 && grid.rows > 1) {
    std::swap(grid.columns, grid.rows);
    grid.columnSpacing = grid.rowSpacing;
  }
  return draft;
}

}  // namespace asperity
