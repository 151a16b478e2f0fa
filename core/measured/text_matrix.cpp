// Reads a matrix of heights in a text table, and the steps that its header states.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/number_text.h"
#include "core/base/text.h"
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

void takeSpacings(const SurfaceText& in, SurfaceDraft& draft, bool areLines) {
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
    const bool isOfX = areLines || x.length()->hasAxis;
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

/// Returns the number of lines that the header states.
std::optional<std::int64_t> statedLines(const TextPart& in) {
  constexpr WordList kLines(
      "lines, number of lines, scan lines, number of scan lines, traces, number of traces, "
      "profiles, "
      "number of profiles, tracks, number of tracks, anzahl linien, anzahl profile, anzahl spuren",
      ',');
  for (const std::string_view key : kLines)
    if (const auto number = parseQuantity(in.entry(key)); number && number->number > 0)
      if (const auto count = wholeNumber(number->number)) return count;
  return {};
}

/// Makes rows of the columns of a matrix where these are the lines along which a step is stated: by
/// their number, or because few of them are far longer than the rows. Returns whether they are.
bool turnLines(const SurfaceText& in, SurfaceDraft& draft) {
  constexpr std::int64_t kFew = 12, kLong = 4;  // columns, and rows per column
  Topography& grid = draft.grid;
  const auto step = headerLength(in, LengthKind::Step, 'x');
  if (in.source.choices.format == "matrix" || !step || step->hasAxis) return false;
  const auto lines = statedLines(in);
  const bool areCounted = lines == grid.columns && lines != grid.rows;
  const bool areLong =
      !lines && statesLineSpacing(in) && grid.columns <= kFew && grid.rows > kLong * grid.columns;
  if (!areCounted && !areLong) return false;
  draft.facts.notes.push_back(message(
      "The {} columns are taken for the lines whose number or spacing the header states: they are "
      "the rows of the surface, unless surface.format is matrix.",
      grid.columns));
  grid = transposed(grid);
  return true;
}

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
  if (frame.hasColumn && !isNumbered) {
    takeFramePositions(frame, corner, in, draft);
  } else {
    const bool areLines = !spip && !isEsri && turnLines(in, draft);
    takeSpacings(in, draft, areLines);
  }
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

}  // namespace asperity
