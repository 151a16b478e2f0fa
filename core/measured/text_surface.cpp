// Decides which of the three forms a text table has, and reads profiles: positions and heights, or
// heights alone.
#include "core/measured/text_surface.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/base/column_units.h"
#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/text_clause.h"
#include "core/base/text_header.h"
#include "core/base/text_number.h"
#include "core/measured/grid_numbers.h"
#include "core/measured/height_table.h"
#include "core/measured/reading_notes.h"
#include "core/measured/text_columns.h"
#include "core/measured/text_lengths.h"
#include "core/measured/uniform_positions.h"
#include "core/measured/word_reader.h"

namespace asperity {
namespace {

enum class Form { Profile, Matrix, Points };

/// Returns whether the first column is uniform and none of the next two is: these are positions of
/// several profiles, and no matrix.
bool beginsWithPositions(const TextBlock& block) {
  if (!uniformSpacing(block.column(0))) return false;
  for (std::size_t i = 1; i < std::min<std::size_t>(block.columns.size(), 3); ++i)
    if (uniformSpacing(block.column(i))) return false;
  return true;
}

constexpr std::size_t kMaxPointColumns = 12;  // positions, height, and what else a point has

/// Returns whether the columns after the heights are colours, intensities or normals, and no two
/// points are at the same position: these are points and no matrix.
bool hasPointAttributes(const TextBlock& block) {
  for (std::size_t column = 3; column < block.columns.size(); ++column) {
    bool areColours = true, areNormals = true;
    for (std::size_t i = 0; i < block.rows; ++i) {
      constexpr double kBrightest = 255;
      const double value = block.at(i, column);
      areColours = areColours && value >= 0 && value <= kBrightest && value == std::floor(value);
      areNormals = areNormals && std::abs(value) <= 1;
    }
    if (!areColours && !areNormals) return false;
  }
  std::vector<std::pair<double, double>> positions;
  for (std::size_t i = 0; i < block.rows; ++i)
    positions.emplace_back(block.at(i, 0), block.at(i, 1));
  std::ranges::sort(positions);
  return std::ranges::adjacent_find(positions) == positions.end();
}

/// The middle of the numbers of a column and the range of half of them around it.
struct Spread {
  double middle = 0, range = 0;
};

Spread spreadOf(std::vector<double> numbers) {
  std::erase_if(numbers, [](double number) { return std::isnan(number); });
  if (numbers.empty()) return {};
  std::ranges::sort(numbers);
  const std::size_t count = numbers.size();
  return {numbers[count / 2], numbers[count - 1 - count / 4] - numbers[count / 4]};
}

/// Throws InputError for a long matrix of few columns whose neighbours differ by orders of
/// magnitude: such columns hold different quantities, such as the positions of points.
void refuseUnlikeColumns(const TextBlock& block, const SurfaceSource& source) {
  constexpr std::size_t kLong = 4;  // rows per column
  constexpr double kUnlikeRange = 1e3, kFarOff = 100;
  const std::size_t columns = block.columns.size();
  if (source.choices.format != "auto" && source.choices.format != "text") return;
  if (columns > kMaxPointColumns || block.rows < kLong * columns) return;
  Spread last = spreadOf(block.column(0));
  for (std::size_t i = 1; i < columns; ++i) {
    const Spread next = spreadOf(block.column(i));
    const double larger = std::max(last.range, next.range),
                 smaller = std::min(last.range, next.range);
    const bool isUnlike = smaller > 0 && larger > kUnlikeRange * smaller;
    const bool isFarOff = larger > 0 && std::abs(next.middle - last.middle) > kFarOff * larger;
    if (isUnlike || isFarOff)
      throw InputError(source.name, "surface.format",
                       message("is needed (profile, matrix or points): "
                               "columns {} and {} of {} are too different for heights "
                               "of one matrix",
                               i, i + 1, columns));
    last = next;
  }
}

Form detectForm(const SurfaceText& in) {
  const TextBlock& block = in.block;
  const SurfaceSource& source = in.source;
  const std::string& format = source.choices.format;
  if (format == "profile") return Form::Profile;
  if (format == "matrix") return Form::Matrix;
  if (format == "points") return Form::Points;
  const std::size_t columns = block.columns.size();
  if (columns < 3) return Form::Profile;
  // The first column holds dates.
  constexpr std::size_t kFew = 4;
  if (columns <= kFew && !block.hasNumber(0)) return Form::Profile;
  if (readFrame(block).hasColumn) return Form::Matrix;
  const ColumnRoles roles = columnRoles(block, source);
  if (gridNumbers(in, roles)) return Form::Points;
  if (roles.x >= 0 && roles.y >= 0 && roles.z >= 0) {
    // The table may be a profile with a second lateral coordinate that does not change, or points.
    return Form::Points;
  }
  if (source.choices.positionColumn > 0 || source.choices.heightColumn > 0) return Form::Profile;
  if (columns <= kMaxPointColumns && !roles.named && isPointsOfGrid(block, roles) &&
      (columns <= 5 || hasPointAttributes(block)))
    return Form::Points;
  if (roles.named || roles.validity >= 0) return Form::Profile;
  const bool hasNames = std::ranges::any_of(block.columns, [&in](const TextColumn& column) {
    double number = 0;
    return !column.name.empty() && !readTextNumber(column.name, in.table.dialect.decimal, number);
  });
  if (hasNames && columns <= 8 && roles.x >= 0) return Form::Profile;
  if (roles.x >= 0 && block.rows > columns && beginsWithPositions(block)) return Form::Profile;
  // The columns are row numbers, positions and heights.
  if (columns == 3 && countsRows(block, 0) && roles.x == 1) return Form::Profile;
  refuseUnlikeColumns(block, source);
  return Form::Matrix;
}

// ---- Profiles

/// Throws InputError for heights that no surface can have: some files write such a number for a
/// missing point.
void requireHeights(const std::vector<double>& heights, const TextBlock& block,
                    const SurfaceSource& source) {
  constexpr double kNoHeight = 1e30;  // in any unit
  for (std::size_t i = 0; i < heights.size(); ++i)
    if (!std::isnan(heights[i]) && std::abs(heights[i]) > kNoHeight)
      source.fail(message("line {}: {} is not a height; a missing point is left empty or is NaN",
                          block.lines[i], plain(heights[i])));
}

/// Makes rows of heights that follow each other in one column where the header states how many
/// points a row has and how many rows there are, as NanoScope writes them. Throws InputError where
/// the column has another number of heights.
void takeRows(const SurfaceText& in, SurfaceDraft& draft) {
  Topography& grid = draft.grid;
  const auto columns = statedCount(in, Counted::Columns);
  const auto rows = statedCount(in, Counted::Rows);
  // "columns: 1" and "rows: 400" are of the table.
  if (!columns || !rows || *rows < 2 || *columns <= std::ssize(in.block.columns)) return;
  if (in.source.choices.format == "profile") return;
  if (*columns > grid.columns || *columns * *rows != grid.columns)
    in.source.fail(
        message("the header states {} rows of {} points; the file has {} heights in one "
                "column",
                *rows, *columns, grid.columns));
  grid.columns = *columns;
  grid.rows = *rows;
  draft.facts.format = "matrix";
  draft.facts.notes.emplace_back(
      "The rows follow each other in one column; the header states their length.");
  takeSpacings(in, draft);
}

/// Makes gaps of the heights that are not valid by a column of the file.
void makeGaps(const TextBlock& block, const ColumnRoles& roles, std::vector<double>& heights,
              std::vector<Message>& notes) {
  for (std::size_t i = 0; i < block.rows; ++i) {
    const double valid = block.at(i, static_cast<std::size_t>(roles.validity));
    if (std::isnan(valid) || (valid == 1) != roles.validIsOne) heights[i] = kMissingHeight;
  }
  notes.push_back(message("{} says which points are valid; the others are gaps.",
                          columnText(block, roles.validity)));
}

/// Returns the step between the points that the lines above the numbers state.
std::optional<HeaderLength> statedStep(const SurfaceText& in) {
  if (auto step = headerLength(in, LengthKind::Step, 'x')) return step;
  if (auto step = countedStep(in, static_cast<std::int64_t>(in.block.rows), 'x')) return step;
  return sampledStep(in);
}

SurfaceDraft readTextProfile(const SurfaceText& in) {
  const TextBlock& block = in.block;
  const SurfaceSource& source = in.source;
  ColumnRoles roles = columnRoles(block, source);
  if (roles.z < 0) source.fail("has no column of heights");
  SurfaceDraft draft;
  const auto spacing = statedStep(in);
  const bool isGiven = source.choices.spacing > 0 && source.choices.positionUnit == "auto";
  const bool isInPixelsAlone =
      roles.x >= 0 && isInPixels(columnAt(block, roles.x)) && !spacing && !isGiven;
  if ((spacing || isGiven || isInPixelsAlone) && mayNumberPoints(block, roles, source)) {
    draft.facts.notes.push_back(
        isInPixelsAlone ? message("{} numbers the points.", columnText(block, roles.x))
                        : message("The points are as far apart as is stated: {} numbers them.",
                                  columnText(block, roles.x)));
    roles.x = -1;
  }
  draft.facts.format = "profile";
  draft.facts.heightColumn = columnText(block, roles.z).english();
  std::vector<double> heights = block.column(static_cast<std::size_t>(roles.z));
  requireHeights(heights, block, source);
  requireHeightName(block, roles.z, source, draft.facts.notes);
  if (roles.validity >= 0) makeGaps(block, roles, heights, draft.facts.notes);
  draft.heightUnit = columnUnit(in, roles.z, true);
  if (!draft.heightUnit) draft.unknownHeightUnit = unknownUnit(in, roles.z, true);
  if (roles.candidates > 1 && source.choices.heightColumn == 0)
    draft.facts.notes.push_back(
        message("Heights are {}, one of {} columns that could be; surface.height_column chooses "
                "another.",
                columnText(block, roles.z), roles.candidates));
  noteFactor(block, roles.z, draft.facts.notes);
  Topography& grid = draft.grid;
  grid.rows = 1;
  if (roles.x >= 0) {
    noteFactor(block, roles.x, draft.facts.notes);
    draft.facts.positionColumn = columnText(block, roles.x).english();
    draft.facts.notes.insert(draft.facts.notes.begin(),
                             message("Positions are {}, heights {}.", columnText(block, roles.x),
                                     columnText(block, roles.z)));
    draft.positionUnit = columnUnit(in, roles.x, false);
    if (!draft.positionUnit) draft.unknownPositionUnit = unknownUnit(in, roles.x, false);
    resampleUniformly(block.column(static_cast<std::size_t>(roles.x)), std::move(heights),
                      block.lines, source, draft);
  } else {
    grid.height = std::move(heights);
    grid.columns = static_cast<std::int64_t>(grid.height.size());
    if (spacing && spacing->note) draft.facts.notes.push_back(*spacing->note);
    draft.hasPositions = spacing.has_value();
    grid.columnSpacing = spacing ? spacing->value : 1;
    // The entry "Unit" may be the unit of the heights, which tells nothing about a step.
    draft.positionUnit =
        spacing && spacing->unit
            ? spacing->unit
            : headerUnit(in, false, spacing ? UnitEntries::AndCommon : UnitEntries::Own);
    takeRows(in, draft);
  }
  return draft;
}

/// Removes the first number of a single column where it is the number of those below it. Returns
/// its line, 0 where there is none.
std::uint32_t takeCount(TextBlock& block) {
  constexpr std::size_t kMin = 5;
  if (block.columns.size() != 1 || block.rows <= kMin ||
      block.values.front() != static_cast<double>(block.rows - 1))
    return 0;
  const std::uint32_t line = block.lines.front();
  block.values.erase(block.values.begin());
  block.lines.erase(block.lines.begin());
  --block.rows;
  return line;
}

/// Makes an entry of each statement of a line with several: "Points: 400, Step: 0.5 um".
void splitEntries(TextTable& table) {
  for (TextBlock& block : table.blocks) {
    std::vector<TextEntry> entries;
    for (TextEntry& entry : block.header) {
      const auto clauses = splitClauses(entry.written);
      const bool areStatements = std::ranges::all_of(clauses, [](std::string_view clause) {
        return keyEnd(clause) != std::string_view::npos;
      });
      if (clauses.size() < 2 || !areStatements) {
        entries.push_back(std::move(entry));
        continue;
      }
      for (const std::string_view clause : clauses)
        entries.push_back(parseEntry({clause, entry.line}, table.dialect));
    }
    block.header = std::move(entries);
  }
}

/// Reads the table. Where that fails, its numbers may have units in their cells, and dates beside
/// them.
TextTable readTable(const SurfaceSource& source) {
  TextTableOptions options;
  options.blankLinesAreGaps = true;
  options.progress = [&source](double part) { source.report(0.9 * part); };
  try {
    return readTextTable(source.bytes, source.name, options);
  } catch (const InputError&) {
    options.readsCells = options.datesAreMissing = true;
    try {
      TextTable table = readTextTable(source.bytes, source.name, options);
      for (TextBlock& block : table.blocks) unifyUnits(block, source.name);
      return table;
    } catch (const InputError&) {  // the first error says what is usual
    }
    throw;
  }
}

/// Returns whether a table has the positions of another one, number by number.
bool hasPositionsOf(const TextBlock& one, const TextBlock& other, int x) {
  if (one.rows != other.rows) return false;
  if (x < 0) return true;
  const auto column = static_cast<std::size_t>(x);
  for (std::size_t row = 0; row < one.rows; ++row) {
    const double a = one.at(row, column), b = other.at(row, column);
    if (std::isnan(a) != std::isnan(b) || (!std::isnan(a) && a != b)) return false;
  }
  return true;
}

/// Adds the profiles of further tables to a draft of the first one, as rows.
/// Returns false where they are none, or at other positions.
bool addProfiles(std::span<const TextBlock> tables, const TextTable& table,
                 const SurfaceSource& source, SurfaceDraft& draft) {
  Topography& grid = draft.grid;
  const int x = columnRoles(tables.front(), source).x;
  std::vector<double> heights = grid.height;
  for (const TextBlock& next : tables.subspan(1)) {
    if (grid.rows > 1 || !hasPositionsOf(next, tables.front(), x)) return false;
    const SurfaceDraft further = readTextProfile({{table, next}, source});
    if (further.grid.height.size() != grid.height.size()) return false;
    heights.insert(heights.end(), further.grid.height.begin(), further.grid.height.end());
  }
  grid.height = std::move(heights);
  grid.rows = static_cast<std::int64_t>(tables.size());
  grid.rowSpacing = 0;
  draft.facts.format = "matrix";
  return true;
}

/// Adds the profiles that stand side by side to a draft of the first one, as rows, and a note that
/// says so. Does nothing where there are none, or where they have other positions.
void addProfilesSideBySide(const SurfaceText& in, SurfaceDraft& draft) {
  const auto [columns, leftOut] =
      profilesSideBySide(in.block, columnRoles(in.block, in.source), in.source);
  if (columns.empty() || in.source.choices.format == "profile" || draft.grid.rows > 1) return;
  SurfaceDraft all;
  for (const int column : columns) {
    ReadingChoices choices = in.source.choices;
    choices.heightColumn = column + 1;
    const SurfaceSource changed{in.source.bytes, in.source.name, choices, in.source.stop,
                                in.source.progress};
    SurfaceDraft one = readTextProfile({{in.table, in.block}, changed});
    if (column == columns.front()) {
      all = std::move(one);
      continue;
    }
    if (one.grid.columns != all.grid.columns || one.grid.columnSpacing != all.grid.columnSpacing)
      return;
    all.grid.height.insert(all.grid.height.end(), one.grid.height.begin(), one.grid.height.end());
  }
  all.grid.rows = std::ssize(columns);
  all.grid.rowSpacing = 0;
  all.facts.format = "matrix";
  all.facts.notes.push_back(message(
      "The file has {} profiles side by side, {} to {}, which are the rows of the surface: "
      "surface.row chooses one.",
      columns.size(), columnText(in.block, columns.front()), columnText(in.block, columns.back())));
  for (const int column : leftOut)
    all.facts.notes.push_back(
        message("{} is left out: a height is missing in its first or its last row.",
                columnText(in.block, column)));
  draft = std::move(all);
}

/// Throws InputError where blank lines separate parts of a matrix, or several matrices, and nothing
/// says which: neither a comment between them, nor a first column that begins anew, nor the header.
void requireOneMatrix(std::span<const TextBlock> parts, const TextTable& table,
                      const SurfaceSource& source) {
  const TextBlock &first = parts.front(), &second = parts[1];
  const bool isCommented = second.blanks.front().second == 0;
  if (isCommented || hasPositionsOf(second, first, 0) ||
      statedCount({table, first}, Counted::Rows) == static_cast<std::int64_t>(first.rows))
    return;
  throw InputError(source.name, "surface.format",
                   message("is needed: blank lines separate {} parts of {} rows; say matrix where "
                           "they are one, and leave only one of them in the file where they are "
                           "several",
                           parts.size(), first.rows));
}

/// Adds what there is to say about parts of the file. parts: the table that was read and those that
/// followed it, behind blank lines if they are no rows.
void noteParts(std::span<const TextBlock> parts, bool areRows, Form form,
               std::vector<Message>& notes) {
  const TextBlock& read = parts.front();
  if (areRows)
    notes.push_back(
        message("The file has {} profiles, which are the rows of the surface: surface.row chooses "
                "one.",
                parts.size()));
  else if (parts.size() > 1)
    notes.push_back(
        message("Blank lines separate {} tables; the first one, up to line {}, is read.",
                parts.size(), read.lines.back()));
  else if (form == Form::Matrix && !read.blanks.empty() && read.blanks.size() + 1 < read.rows)
    notes.push_back(
        message("Blank lines stand between the rows, the first one above line {}: all rows are "
                "taken for one table.",
                read.lines[read.blanks.front().first]));
}

}  // namespace

std::string_view detectRoadFormat(std::string_view bytes) {
  constexpr std::size_t kHeader = 4096;  // bytes
  if (bytes.starts_with("ERDFILE")) return "ERD";
  const bool isOpen = bytes.substr(0, kHeader).find("$ROAD_CRG") != std::string_view::npos;
  return isOpen ? "OpenCRG" : "";
}

SurfaceDraft readTextSurface(const SurfaceSource& source) {
  const std::string& format = source.choices.format;
  if (const std::string_view kind = detectRoadFormat(source.bytes);
      !kind.empty() && (format == "auto" || format == "text"))
    source.fail(
        message("is a road file ({}), a kind that is not read; the heights of one track as "
                "text are, with their distance as surface.point_spacing",
                Message::name(std::string(kind))));
  const bool isEsri =
      format != "profile" && format != "points" && isEsriGrid(withoutByteOrderMark(source.bytes));
  TextTable table = isEsri ? readEsriGrid(source) : readTable(source);
  splitEntries(table);
  const std::size_t joined = joinContinued(table);
  const HeightTable chosen = chooseHeightTable(table);
  const std::uint32_t lineOfCount = isEsri ? 0 : takeCount(table.blocks[chosen.index]);
  std::size_t parts = 1;
  const auto chosenForm = [&] { return detectForm({{table, table.blocks[chosen.index]}, source}); };
  Form form = isEsri ? Form::Matrix : chosenForm();
  // The second table of SPIP says where heights are missing.
  const bool hasVoids = !table.entry("voidpixels", table.blocks[chosen.index]).empty();
  if (!isEsri && !hasVoids && form != Form::Points) {
    parts = splitIntoParts(table, chosen.index, source);
    if (parts > 1) form = chosenForm();
  }
  const TextBlock& block = table.blocks[chosen.index];
  const std::size_t headed =
      parts == 1 && form == Form::Profile ? countHeadedProfiles(table, chosen.index) : 1;
  const SurfaceText text{{table, block}, source};
  SurfaceDraft draft = form == Form::Profile  ? readTextProfile(text)
                       : form == Form::Matrix ? readTextMatrix(text)
                                              : readTextPoints(text);
  const std::span<const TextBlock> tables(&block, std::max(parts, headed));
  if (parts > 1 && form == Form::Matrix) requireOneMatrix(tables, table, source);
  const bool areRows =
      tables.size() > 1 && form == Form::Profile && addProfiles(tables, table, source, draft);
  if (form == Form::Profile && !areRows) addProfilesSideBySide(text, draft);
  if (joined > 1)
    draft.facts.notes.push_back(
        message("{} tables of the file follow each other along x: they are read as one.", joined));
  noteParts(areRows ? tables : tables.first(parts), areRows, form, draft.facts.notes);
  if (chosen.note && !(areRows && headed > 1)) draft.facts.notes.push_back(*chosen.note);
  noteStatements(text, lineOfCount, draft);
  return draft;
}

}  // namespace asperity
