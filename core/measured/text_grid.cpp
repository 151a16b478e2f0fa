// Reads topographies in text tables: a matrix of heights, or points x, y, z in any order.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/number_text.h"
#include "core/base/text_number.h"
#include "core/base/text_units.h"
#include "core/measured/grid_numbers.h"
#include "core/measured/height_table.h"
#include "core/measured/reading_notes.h"
#include "core/measured/text_columns.h"
#include "core/measured/text_lengths.h"
#include "core/measured/text_surface.h"
#include "core/measured/uniform_positions.h"

namespace asperity {
namespace {

// ---- Matrix ------------------------------------------------------------------------------------

/// The text of SPIP: lengths are in nanometres without a unit; heights are in the unit of "z-unit",
/// or times Bit2nm in nanometres. With "voidpixels" a second matrix follows, which is 1 where there
/// is a height and 0 where there is none.
struct SpipHeader {
  std::int64_t columns = 0, rows = 0;
  bool hasVoids = false;
};

std::optional<SpipHeader> spipHeader(const TextPart& in) {
  const auto number = [&](std::string_view key) {
    const auto quantity = parseQuantity(in.entry(key));
    return quantity ? wholeNumber(quantity->number).value_or(0) : 0;
  };
  const SpipHeader header{number("x-pixels"), number("y-pixels"), number("voidpixels") > 0};
  return header.columns > 0 && header.rows > 0 ? std::optional(header) : std::nullopt;
}

std::optional<double> nanometresPerHeight(const TextPart& in) {
  const auto bit = parseQuantity(in.entry("bit2nm"));
  return bit && bit->number > 0 ? std::optional(bit->number) : std::nullopt;
}

/// Checks the size and removes the matrix of voids from the heights.
void applySpipHeader(const SpipHeader& header, const SurfaceSource& source, Topography& grid) {
  const std::int64_t rows = header.hasVoids ? 2 * header.rows : header.rows;
  if (grid.columns != header.columns || grid.rows != rows)
    source.fail(header.hasVoids
                    ? message("the header says {} x {} pixels and as many that mark those without "
                              "a height; the file has {} x {} numbers",
                              header.columns, header.rows, grid.columns, grid.rows)
                    : message("the header says {} x {} pixels; the file has {} x {} numbers",
                              header.columns, header.rows, grid.columns, grid.rows));
  const auto points = static_cast<std::size_t>(header.columns * header.rows);
  for (std::size_t i = 0; points + i < grid.height.size(); ++i)
    if (!(grid.height[points + i] > 0)) grid.height[i] = kMissingHeight;
  grid.height.resize(points);
  grid.rows = header.rows;
}

void flip(Topography& grid, bool columns, bool rows) {
  const auto width = static_cast<std::ptrdiff_t>(grid.columns);
  if (columns)
    for (std::int64_t row = 0; row < grid.rows; ++row)
      std::reverse(grid.height.begin() + row * width, grid.height.begin() + (row + 1) * width);
  if (rows)
    for (std::int64_t row = 0; row < grid.rows / 2; ++row)
      std::swap_ranges(grid.height.begin() + row * width, grid.height.begin() + (row + 1) * width,
                       grid.height.begin() + (grid.rows - 1 - row) * width);
}

/// What the lines above the numbers state about the steps along one axis.
struct AxisSteps {
  std::optional<HeaderLength> step{}, extent{};

  const std::optional<HeaderLength>& length() const { return step ? step : extent; }
};

/// Throws InputError where the step and the extent contradict each other: the extent reaches from
/// the first point to the last one, or one step farther.
void requireAgreement(const AxisSteps& axis, std::int64_t count, const SurfaceSource& source) {
  if (!axis.step || !axis.extent || !axis.step->unit != !axis.extent->unit) return;
  constexpr double kRounding = 0.01;
  const double step = axis.step->metres(), extent = axis.extent->metres();
  if (std::abs(extent - step * static_cast<double>(count)) > step + kRounding * extent)
    throw InputError(source.name, "surface.point_spacing",
                     message("is needed (in m): the file states a step of {} and an extent of {}, "
                             "which do not fit {} points",
                             printed(step, "m"), printed(extent, "m"), count));
}

/// The steps of both axes.
struct FieldSteps {
  AxisSteps x, y;
};

/// Returns the steps that the lines above the numbers state, without numbers that count points.
FieldSteps statedSteps(const SurfaceText& in, SurfaceDraft& draft) {
  const Topography& grid = draft.grid;
  AxisSteps x, y;
  for (auto* axis : {&x, &y}) {
    const char letter = axis == &x ? 'x' : 'y';
    axis->step = headerLength(in, LengthKind::Step, letter);
    axis->extent = headerLength(in, LengthKind::Extent, letter);
    if (spipHeader(in) && axis->extent && !axis->extent->unit)
      axis->extent->unit = StatedUnit{"nm", 1e-9};
  }
  if (!x.step && !y.step && !y.extent)
    if (const auto sides = widthAndLength(in.block)) {
      x.extent = sides->first;
      y.extent = sides->second;
    }
  // A width without a unit that is the number of columns counts them.
  const auto isCount = [](const AxisSteps& axis, std::int64_t count) {
    return axis.extent && !axis.extent->unit && axis.extent->value == static_cast<double>(count);
  };
  if (isCount(x, grid.columns) || isCount(y, grid.rows))
    for (auto* axis : {&x, &y})
      if (axis->extent && !axis->extent->unit) axis->extent.reset();
  const auto countedX = countedStep(in, grid.columns, 'x');
  const auto countedY = countedStep(in, grid.rows, 'y');
  if (countedX && countedY) {
    x = {countedX, {}};
    y = {countedY, {}};
    if (countedX->note) draft.facts.notes.push_back(*countedX->note);
  }
  if (!x.length()) y.extent.reset();  // a height alone may be any
  return {x, y};
}

/// Takes the spacing of `count` points along an axis. Returns whether one is stated.
bool takeSpacing(const AxisSteps& axis, std::int64_t count, SurfaceDraft& draft, double& spacing) {
  const auto& length = axis.length();
  if (!length) return false;
  double factor = 1;
  // The first length states the unit of both.
  if (length->unit && draft.positionUnit)
    factor = length->unit->metres / draft.positionUnit->metres;
  else if (length->unit)
    draft.positionUnit = length->unit;
  spacing = length->value / (axis.step ? 1 : static_cast<double>(count)) * factor;
  return true;
}

}  // namespace

void takeSpacings(const SurfaceText& in, SurfaceDraft& draft) {
  Topography& grid = draft.grid;
  const auto [x, y] = statedSteps(in, draft);
  const bool isChosen = in.source.choices.spacing > 0;
  if (!isChosen) {
    requireAgreement(x, grid.columns, in.source);
    requireAgreement(y, grid.rows, in.source);
  }
  const bool hasX = takeSpacing(x, grid.columns, draft, grid.columnSpacing);
  const bool hasY = takeSpacing(y, grid.rows, draft, grid.rowSpacing);
  if (hasX && !hasY) {
    const bool isOfX = x.length()->hasAxis;
    grid.rowSpacing = isOfX ? 0 : grid.columnSpacing;
    if (!isOfX && !isChosen && grid.rows > 1)
      draft.facts.notes.emplace_back(
          "The header states one length without an axis: rows are taken to be as far apart as "
          "points.");
  }
  if (hasY && !hasX) {
    grid.columnSpacing = grid.rowSpacing;
    if (!isChosen)
      draft.facts.notes.emplace_back(
          "The header states the length along y alone: points are taken to be as far apart as "
          "rows.");
  }
  draft.hasPositions = (hasX || hasY) && !isChosen;
  if ((hasX || hasY) && isChosen)
    draft.facts.notes.emplace_back(
        "surface.point_spacing replaces the lengths above the numbers of the file.");
  if (!draft.hasPositions) grid.columnSpacing = grid.rowSpacing = 1;
  // The entry "Unit" may be the unit of the heights, which tells nothing about a step.
  if (!draft.positionUnit)
    draft.positionUnit =
        headerUnit(in, false, draft.hasPositions ? UnitEntries::AndCommon : UnitEntries::Own);
}

namespace {

/// Returns the unit of length that the cells of a matrix have; nothing where they have none, or
/// several.
std::optional<StatedUnit> unitOfCells(const TextBlock& block, std::size_t firstColumn) {
  const std::string& unit = block.columns.back().unit;
  for (std::size_t i = firstColumn; i < block.columns.size(); ++i)
    if (i >= block.cells.size() || block.cells[i].empty() || block.columns[i].unit != unit)
      return {};
  const auto metres = metresPer(unit);
  return metres ? std::optional(StatedUnit{unit, *metres}) : std::nullopt;
}

/// Returns the numbers from a row and a column on, row by row.
std::vector<double> numbersFrom(const TextBlock& block, std::size_t firstRow,
                                std::size_t firstColumn) {
  if (firstColumn == 0 && firstRow == 0) return block.values;
  std::vector<double> numbers;
  for (std::size_t row = firstRow; row < block.rows; ++row)
    for (std::size_t column = firstColumn; column < block.columns.size(); ++column)
      numbers.push_back(block.at(row, column));
  return numbers;
}

void noteNumbering(const Numbering& numbering, std::vector<Message>& notes) {
  if (numbering.row && numbering.column)
    notes.emplace_back("The first row and the first column number the points.");
  else if (numbering.row)
    notes.emplace_back("The first row numbers the points.");
  else if (numbering.column)
    notes.emplace_back("The first column numbers the points.");
}

/// Takes the spacings and the unit of the positions in the first row and the first column.
void takeFramePositions(const MatrixFrame& frame, const CornerUnits& corner, const TextPart& in,
                        SurfaceDraft& draft) {
  Topography& grid = draft.grid;
  const double x = *uniformSpacing(frame.x), y = *uniformSpacing(frame.y);
  grid.columnSpacing = std::abs(x);
  grid.rowSpacing = std::abs(y);
  flip(grid, x < 0, y < 0);
  draft.positionUnit = corner.x ? corner.x : corner.y;
  if (corner.x && corner.y) grid.rowSpacing *= corner.y->metres / corner.x->metres;
  if (!draft.positionUnit) draft.unknownPositionUnit = corner.unknownPosition;
  if (!draft.positionUnit && draft.unknownPositionUnit.empty())
    draft.positionUnit = headerUnit(in, false);
  if (frame.corner) {
    draft.facts.notes.push_back(message(
        "The first row and the first column are evenly spaced and are taken as positions; the "
        "number {} in the corner is left out.",
        plain(*frame.corner)));
  } else {
    draft.facts.notes.emplace_back("The first row and the first column are positions.");
  }
}

}  // namespace

SurfaceDraft readTextMatrix(const SurfaceText& in) {
  const TextBlock& block = in.block;
  const SurfaceSource& source = in.source;
  SurfaceDraft draft;
  draft.facts.format = "matrix";
  Topography& grid = draft.grid;
  const auto spip = spipHeader(in);
  // A grid of ESRI states how many heights it has: there are no other numbers.
  const bool isEsri = !in.entry("ncols").empty();
  const MatrixFrame frame = isEsri ? MatrixFrame{} : readFrame(block);
  const CornerUnits corner = frame.hasColumn && !frame.hasRow ? cornerUnits(block) : CornerUnits{};
  // Numbers 0, 1, 2, ... are positions only where their unit is stated, and no other step.
  const bool hasUnit = corner.x || corner.y || !corner.unknownPosition.empty() ||
                       headerUnit(in, false, UnitEntries::Own);
  const bool isNumbered = frame.hasColumn && countByOne(frame.x) && countByOne(frame.y) &&
                          (!hasUnit || headerLength(in, LengthKind::Step, 'x'));
  const Numbering numbering = frame.hasColumn  ? Numbering{isNumbered, isNumbered}
                              : spip || isEsri ? Numbering{}
                                               : findNumbering(block, source);
  const std::size_t firstColumn = frame.hasColumn || numbering.column ? 1 : 0;
  const std::size_t firstRow = frame.hasRow || (!frame.hasColumn && numbering.row) ? 1 : 0;
  grid.columns = static_cast<std::int64_t>(block.columns.size() - firstColumn);
  grid.rows = static_cast<std::int64_t>(block.rows - firstRow);
  requireSize(source, grid.columns, grid.rows, 0, 0);
  grid.height = numbersFrom(block, firstRow, firstColumn);
  if (spip && !frame.hasColumn) applySpipHeader(*spip, source, grid);
  draft.heightUnit = corner.z ? corner.z : headerUnit(in, true);
  if (!draft.heightUnit) draft.heightUnit = unitOfCells(block, firstColumn);
  if (!draft.heightUnit) draft.unknownHeightUnit = corner.unknownHeight;
  requireHeightName(block, -1, source, draft.facts.notes);
  noteNumbering(numbering, draft.facts.notes);
  if (frame.hasColumn && !isNumbered)
    takeFramePositions(frame, corner, in, draft);
  else
    takeSpacings(in, draft);
  if (const auto size = nanometresPerHeight(in); size && !draft.heightUnit)
    draft.heightUnit = StatedUnit{*size == 1 ? "nm" : plainNumber(*size) + " nm", 1e-9 * *size};
  if (!draft.heightUnit && draft.unknownHeightUnit.empty())
    draft.unknownHeightUnit = unknownUnit(in, -1, true);
  if (!draft.positionUnit && draft.unknownPositionUnit.empty())
    draft.unknownPositionUnit = unknownUnit(in, -1, false);
  // These numbers stand for a missing value in grids of ESRI.
  const auto none = parseQuantity(in.entry("nodata_value"));
  if (none)
    for (double& height : grid.height)
      if (!std::isnan(height) && height == none->number) height = kMissingHeight;
  return draft;
}

// ---- Points ------------------------------------------------------------------------------------

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
