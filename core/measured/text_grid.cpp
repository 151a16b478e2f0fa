// Reads topographies in text tables: a matrix of heights, or points x, y, z in any order.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/number_text.h"
#include "core/base/text_number.h"
#include "core/base/units.h"
#include "core/measured/text_surface.h"
#include "core/measured/uniform_positions.h"

namespace asperity {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// ---- Matrix ------------------------------------------------------------------------------------

/// The width and the height of the whole field.
struct Extent {
  std::optional<HeaderLength> width, height;
};

/// Returns the extent by the keys that Gwyddion writes in each of its languages, and by others.
Extent findExtent(const TextTable& table, const TextBlock& block) {
  Extent extent;
  extent.width = headerLength(
      table, block,
      WordList("width, breite, largeur, \u0160\u00ED\u0159ka, \u0161\u00ED\u0159ka, larghezza, "
               "anchura, ancho, largura, \u0448\u0438\u0440\u0438\u043D\u0430, "
               "\u0428\u0438\u0440\u0438\u043D\u0430, \u5E45, x size, x range, x length, size x, "
               "xreal, scan size, scansize",
               ','));
  extent.height = headerLength(
      table, block,
      WordList("height, h\u00F6he, hauteur, v\u00FD\u0161ka, altezza, altura, "
               "\u0432\u044B\u0441\u043E\u0442\u0430, \u0412\u044B\u0441\u043E\u0442\u0430, "
               "\u9AD8\u3055, y size, y range, y length, size y, yreal",
               ','));
  return extent;
}

/// The text of SPIP: lengths are in nanometres without a unit; heights are in the unit of "z-unit",
/// or times Bit2nm in nanometres. With "voidpixels" a second matrix follows, which is 1 where there
/// is a height and 0 where there is none.
struct SpipHeader {
  std::int64_t columns = 0, rows = 0;
  bool hasVoids = false;
};

std::optional<SpipHeader> spipHeader(const TextTable& table, const TextBlock& block) {
  const auto number = [&](std::string_view key) {
    const auto quantity = parseQuantity(table.entry(key, block));
    return quantity ? wholeNumber(quantity->number).value_or(0) : 0;
  };
  const SpipHeader header{number("x-pixels"), number("y-pixels"), number("voidpixels") > 0};
  return header.columns > 0 && header.rows > 0 ? std::optional(header) : std::nullopt;
}

std::optional<double> nanometresPerHeight(const TextTable& table, const TextBlock& block) {
  const auto bit = parseQuantity(table.entry("bit2nm", block));
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
    if (!(grid.height[points + i] > 0)) grid.height[i] = kNone;
  grid.height.resize(points);
  grid.rows = header.rows;
}

Extent spipExtent(const TextTable& table, const TextBlock& block) {
  Extent extent;
  extent.width = headerLength(table, block, WordList("x-length", ','));
  extent.height = headerLength(table, block, WordList("y-length", ','));
  for (auto* length : {&extent.width, &extent.height})
    if (*length && !(*length)->unit) (*length)->unit = StatedUnit{"nm", 1e-9};
  return extent;
}

/// Returns the extent where no key is known: the only two lengths above the numbers.
Extent unnamedExtent(const TextBlock& block) {
  Extent extent;
  constexpr std::size_t kShortHeader = 5;
  if (block.header.size() > kShortHeader) return extent;
  std::vector<HeaderLength> lengths;
  for (const TextEntry& entry : block.header)
    if (const auto quantity = parseQuantity(entry.value); quantity && quantity->number > 0)
      if (const auto metres = metresPer(quantity->unit))
        lengths.push_back({quantity->number, StatedUnit{quantity->unit, *metres}});
  if (lengths.size() == 2) {
    extent.width = lengths[0];
    extent.height = lengths[1];
  }
  return extent;
}

/// The first row and the first column of a matrix where they hold positions; the corner is empty or
/// a text.
struct Frame {
  bool hasColumn = false, hasRow = false;
  std::vector<double> x, y;
};

Frame readFrame(const TextBlock& block) {
  Frame frame;
  const std::size_t columns = block.columns.size();
  if (columns < 4 || block.rows < 3) return frame;
  // All names but the first are numbers.
  std::vector<double> named;
  for (std::size_t i = 1; i < columns; ++i) {
    double number = 0;
    if (readTextNumber(block.columns[i].name, '.', number) ||
        readTextNumber(block.columns[i].name, ',', number))
      named.push_back(number);
  }
  std::vector<double> first;
  for (std::size_t i = 1; i < columns; ++i) first.push_back(block.at(0, i));
  const bool inNames = named.size() + 1 == columns && uniformSpacing(named).has_value();
  const bool inRow = !inNames && std::isnan(block.at(0, 0)) &&
                     std::ranges::none_of(first, [](double x) { return std::isnan(x); }) &&
                     uniformSpacing(first).has_value();
  if (!inNames && !inRow) return frame;
  std::vector<double> y;
  for (std::size_t i = inRow ? 1 : 0; i < block.rows; ++i) y.push_back(block.at(i, 0));
  if (y.size() < 2 || !uniformSpacing(y)) return frame;
  frame.hasColumn = true;
  frame.hasRow = inRow;
  frame.x = inNames ? named : first;
  frame.y = std::move(y);
  return frame;
}

}  // namespace

bool hasPositionFrame(const TextBlock& block) {
  return readFrame(block).hasColumn;
}

namespace {

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

void takeSpacings(const TextTable& table, const TextBlock& block, SurfaceDraft& draft) {
  Topography& grid = draft.grid;
  const auto set = [&draft](const std::optional<HeaderLength>& length, double count,
                            double& spacing) {
    if (!length) return false;
    double factor = 1;
    // The first length states the unit of both.
    if (length->unit && draft.positionUnit)
      factor = length->unit->metres / draft.positionUnit->metres;
    else if (length->unit)
      draft.positionUnit = length->unit;
    spacing = length->value / count * factor;
    return true;
  };
  Extent extent = spipHeader(table, block) ? spipExtent(table, block) : findExtent(table, block);
  const auto columnStep = headerLength(
      table, block,
      WordList("cellsize, dx, x spacing, spacing x, x step, pixel size x, x pixel size, pixel "
               "size, pixelsize, spacing, lateral resolution, xy calibration, xy-justierung, "
               "xy-kalibrierung, xy\uCE98\uB9AC\uBE0C\uB808\uC774\uC158",
               ','));
  const auto rowStep = headerLength(
      table, block,
      WordList("cellsize, dy, y spacing, spacing y, y step, pixel size y, y pixel size", ','));
  const auto countedX = countedStep(table, block, grid.columns, true);
  const auto countedY = countedStep(table, block, grid.rows, false);
  const bool isCounted = countedX && countedY;
  if (!extent.width && !extent.height && !columnStep && !rowStep && !isCounted)
    extent = unnamedExtent(block);
  const bool hasX = (isCounted && set(countedX, 1, grid.columnSpacing)) ||
                    set(extent.width, static_cast<double>(grid.columns), grid.columnSpacing) ||
                    set(columnStep, 1, grid.columnSpacing);
  const bool hasY = (isCounted && set(countedY, 1, grid.rowSpacing)) ||
                    set(extent.height, static_cast<double>(grid.rows), grid.rowSpacing) ||
                    set(rowStep, 1, grid.rowSpacing);
  if (hasX && !hasY) grid.rowSpacing = grid.columnSpacing;
  if (hasY && !hasX) grid.columnSpacing = grid.rowSpacing;
  draft.hasPositions = hasX || hasY;
  if (!draft.hasPositions) grid.columnSpacing = grid.rowSpacing = 1;
}

}  // namespace

SurfaceDraft readTextMatrix(const TextTable& table, const TextBlock& block,
                            const SurfaceSource& source) {
  SurfaceDraft draft;
  draft.facts.format = "matrix";
  Topography& grid = draft.grid;
  const Frame frame = readFrame(block);
  const std::size_t firstColumn = frame.hasColumn ? 1 : 0, firstRow = frame.hasRow ? 1 : 0;
  grid.columns = static_cast<std::int64_t>(block.columns.size() - firstColumn);
  grid.rows = static_cast<std::int64_t>(block.rows - firstRow);
  requireSize(source, grid.columns, grid.rows, 0, 0);
  if (firstColumn == 0 && firstRow == 0) {
    grid.height = block.values;
  } else {
    for (std::size_t row = firstRow; row < block.rows; ++row)
      for (std::size_t column = firstColumn; column < block.columns.size(); ++column)
        grid.height.push_back(block.at(row, column));
  }
  if (const auto spip = spipHeader(table, block); spip && !frame.hasColumn)
    applySpipHeader(*spip, source, grid);
  draft.heightUnit = headerUnit(table, block, true);
  if (frame.hasColumn) {
    const double x = *uniformSpacing(frame.x), y = *uniformSpacing(frame.y);
    grid.columnSpacing = std::abs(x);
    grid.rowSpacing = std::abs(y);
    flip(grid, x < 0, y < 0);
    draft.positionUnit = headerUnit(table, block, false);
    draft.facts.notes.emplace_back("The first row and the first column are positions.");
  } else {
    takeSpacings(table, block, draft);
    // The entry "Unit" may be the unit of the heights, which tells nothing about a step.
    if (!draft.positionUnit)
      draft.positionUnit = headerUnit(
          table, block, false, draft.hasPositions ? UnitEntries::AndCommon : UnitEntries::Own);
  }
  if (const auto size = nanometresPerHeight(table, block); size && !draft.heightUnit)
    draft.heightUnit = StatedUnit{*size == 1 ? "nm" : plainNumber(*size) + " nm", 1e-9 * *size};
  if (!draft.heightUnit) draft.unknownHeightUnit = unknownUnit(table, block, -1, true);
  if (!draft.positionUnit) draft.unknownPositionUnit = unknownUnit(table, block, -1, false);
  // These numbers stand for a missing value in grids of ESRI.
  const auto none = parseQuantity(table.entry("nodata_value", block));
  if (none)
    for (double& height : grid.height)
      if (!std::isnan(height) && height == none->number) height = kNone;
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

std::vector<double> columnValues(const TextBlock& block, int column) {
  std::vector<double> values;
  values.reserve(block.rows);
  for (std::size_t i = 0; i < block.rows; ++i)
    if (const double value = block.at(i, static_cast<std::size_t>(column)); !std::isnan(value))
      values.push_back(value);
  return values;
}

}  // namespace

bool isPointsOfGrid(const TextBlock& block, const ColumnRoles& roles) {
  if (block.columns.size() < 3 || block.rows < 4) return false;
  const PointColumns columns = pointColumns(block, roles);
  const std::vector<double> xs = columnValues(block, columns.x),
                            ys = columnValues(block, columns.y);
  if (xs.empty() || ys.empty()) return false;
  const auto most = static_cast<std::int64_t>(block.rows);
  const auto x = findGridAxis(xs, most), y = findGridAxis(ys, most);
  if (!x || !y || x->count < 2 || y->count < 2) return false;
  const double all = static_cast<double>(x->count) * static_cast<double>(y->count);
  return all <= 2 * static_cast<double>(block.rows) && all >= static_cast<double>(block.rows);
}

SurfaceDraft readTextPoints(const TextTable& table, const TextBlock& block,
                            const SurfaceSource& source) {
  if (block.columns.size() < 3) source.fail("points need three columns: x, y and z");
  const PointColumns columns = pointColumns(block, columnRoles(block, source));
  SurfaceDraft draft;
  draft.facts.format = "points";
  draft.facts.positionColumn = columnText(block, columns.x).english();
  draft.facts.heightColumn = columnText(block, columns.z).english();
  draft.facts.notes.push_back(message("Positions are {} and {}, heights {}.",
                                      columnText(block, columns.x), columnText(block, columns.y),
                                      columnText(block, columns.z)));
  draft.positionUnit = columnUnit(source, table, block, columns.x, false);
  const auto rowUnit = columnUnit(source, table, block, columns.y, false);
  draft.heightUnit = columnUnit(source, table, block, columns.z, true);
  if (!draft.positionUnit) draft.unknownPositionUnit = unknownUnit(table, block, columns.x, false);
  if (!draft.heightUnit) draft.unknownHeightUnit = unknownUnit(table, block, columns.z, true);
  const double ofRows =
      (rowUnit ? rowUnit->metres : 1) / (draft.positionUnit ? draft.positionUnit->metres : 1);

  const std::vector<double> xs = columnValues(block, columns.x),
                            ys = columnValues(block, columns.y);
  const auto most = static_cast<std::int64_t>(block.rows);
  const auto x = xs.empty() ? std::nullopt : findGridAxis(xs, most);
  const auto y = ys.empty() ? std::nullopt : findGridAxis(ys, most);
  if (!x || !y) source.fail("the points do not lie on a grid of uniform rows and columns");
  // A single row may also run along y.
  Topography& grid = draft.grid;
  grid.columns = x->count;
  grid.rows = y->count;
  grid.columnSpacing = x->spacing;
  grid.rowSpacing = y->spacing * ofRows;
  const double all = static_cast<double>(grid.columns) * static_cast<double>(grid.rows);
  if (all > 4 * static_cast<double>(block.rows))
    source.fail("the points do not lie on a grid of uniform rows and columns");
  requireSize(source, grid.columns, grid.rows, 0, 0);
  grid.height.assign(static_cast<std::size_t>(grid.columns * grid.rows), kNone);
  std::vector<bool> isTaken(grid.height.size());
  const auto gridIndex = [](double value, const GridAxis& axis) {
    return axis.count > 1 ? std::llround((value - axis.first) / axis.spacing) : 0;
  };
  for (std::size_t i = 0; i < block.rows; ++i) {
    const double px = block.at(i, static_cast<std::size_t>(columns.x));
    const double py = block.at(i, static_cast<std::size_t>(columns.y));
    if (std::isnan(px) || std::isnan(py))
      source.fail(message("line {}: the position is missing", block.lines[i]));
    const auto at = static_cast<std::size_t>(
        std::clamp<std::int64_t>(gridIndex(py, *y), 0, grid.rows - 1) * grid.columns +
        std::clamp<std::int64_t>(gridIndex(px, *x), 0, grid.columns - 1));
    if (isTaken[at])
      source.fail(message("line {}: there is a point at this position already", block.lines[i]));
    isTaken[at] = true;
    grid.height[at] = block.at(i, static_cast<std::size_t>(columns.z));
  }
  if (grid.columns == 1 && grid.rows > 1) {
    std::swap(grid.columns, grid.rows);
    grid.columnSpacing = grid.rowSpacing;
  }
  return draft;
}

}  // namespace asperity
