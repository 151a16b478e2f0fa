#include "core/measured/reading_notes.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/intervals.h"
#include "core/base/number_text.h"
#include "core/base/text.h"
#include "core/base/text_header.h"
#include "core/base/text_number.h"
#include "core/base/text_units.h"
#include "core/measured/text_columns.h"
#include "core/measured/text_lengths.h"

namespace asperity {
namespace {

// Beyond these limits a file may state a wrong unit.
constexpr double kLongestUsual = 10;   // m
constexpr double kHighestUsual = 0.1;  // m, from the lowest to the highest height

Message formText(const ReadingFacts& facts) {
  if (facts.format == "profile") return "a profile as text";
  if (facts.format == "matrix") return "a matrix of heights as text";
  if (facts.format == "points") return "points x, y, z as text";
  if (facts.format == "zygo") return "a file of Zygo";
  if (facts.format == "wyko") return "a text file of Wyko";
  if (facts.format == "surfer") return "a grid of Surfer";
  if (facts.format == "npy") return "an array of NumPy";
  if (facts.format == "gwyddion") return "a file that Gwyddion has converted";
  std::string name = facts.format;
  for (char& letter : name)
    if (letter >= 'a' && letter <= 'z') letter = static_cast<char>(letter - 'a' + 'A');
  return Message::name(name);
}

/// Returns a unit of the file as people write it: "um" is "\u00B5m".
std::string printedUnit(const std::string& unit) {
  // The second one was written in Shift-JIS and read as Latin-1.
  return unit == "um" || unit == "\u0192\u00CAm" ? "\u00B5m" : unit;
}

/// Returns the unit that the file states, where the user's choice replaces it by another one.
std::string replacedUnit(const UnitFact& chosen, const std::optional<StatedUnit>& stated,
                         const std::string& unknown) {
  if (chosen.source != UnitSource::Choice) return {};
  if (!stated) return unknown;
  return stated->metres != chosen.metres ? printedUnit(stated->text) : "";
}

/// Returns whether programs write this number where nothing was measured: 9999, -999.99, -32768.
bool isVoidCode(double number) {
  const std::string digits = plainNumber(std::abs(number));
  return digits == "32767" || digits == "32768" ||
         (digits.size() > 2 && digits.find_first_not_of("9.") == std::string::npos);
}

/// Adds a note where the lowest or highest height is far from all others, as numbers for missing
/// points are: where it occurs several times, or is a number that is known for it.
void noteVoids(const Topography& grid, const UnitFact& unit, std::vector<Message>& notes) {
  constexpr double kFar = 3;  // times the range of all others
  constexpr int kDigits = 8;
  for (const double sign : {1.0, -1.0}) {
    double lowest = INFINITY, second = INFINITY, highest = -INFINITY;
    std::int64_t count = 0, others = 0;
    for (const double height : grid.height) {
      const double z = sign * height;
      if (std::isnan(z)) continue;
      if (z < lowest) {
        second = lowest;
        others += std::exchange(count, 0);
        lowest = z;
      }
      (z == lowest ? count : others) += 1;
      if (z > lowest) second = std::min(second, z);
      highest = std::max(highest, z);
    }
    const double number = roundedToDigits(sign * lowest / unit.metres, kDigits);
    const bool isFar = highest > second && second - lowest > kFar * (highest - second);
    if (!isFar || count >= others || (count == 1 && !isVoidCode(number))) continue;
    const PrintedNumber text = plain(number);
    const std::string printed = printedUnit(unit.unit);
    notes.push_back(
        count == 1
            ? message(
                  "The height {} (in {}) is far from all others: if it means a missing point, it "
                  "has to be left empty, or surface.outliers has to be set.",
                  text, printed)
            : message("The height {} (in {}) stands {} times, far from all others: if it means "
                      "missing points, they have to be left empty, or surface.outliers has to be "
                      "set.",
                      text, printed, count));
  }
}

/// Adds notes where a unit that the file states makes the surface unusually large: the unit may be
/// that of other numbers.
void noteLargeSizes(const Topography& grid, const ReadingFacts& facts,
                    std::vector<Message>& notes) {
  const double length = std::max(grid.length(), grid.width());
  if (facts.positionUnit.source == UnitSource::File && length > kLongestUsual)
    notes.push_back(
        message("The surface is {:.3g} m long: if the file states a wrong unit of positions, "
                "surface.position_unit replaces it.",
                length));
  if (facts.heightUnit.source != UnitSource::File) return;
  if (const double span = extentOf(grid.height).size(); span > kHighestUsual)
    notes.push_back(
        message("The heights span {:.3g} m: if the file states a wrong unit of heights, "
                "surface.height_unit replaces it.",
                span));
}

}  // namespace

void addReadingNotes(SurfaceDraft& draft) {
  const Topography& grid = draft.grid;
  ReadingFacts& facts = draft.facts;
  std::vector<Message> notes;
  const PrintedNumber spacing = printed(grid.columnSpacing, "m");
  if (grid.isProfile())
    notes.push_back(
        message("Read as {}: {} points, {} apart.", formText(facts), grid.columns, spacing));
  else if (grid.rowSpacing == 0)
    notes.push_back(message(
        "Read as {}: {} x {} points. Points are {} apart; how far the rows are apart is not "
        "known.",
        formText(facts), grid.columns, grid.rows, spacing));
  else
    notes.push_back(message("Read as {}: {} x {} points, {} and {} apart.", formText(facts),
                            grid.columns, grid.rows, spacing, printed(grid.rowSpacing, "m")));
  notes.insert(notes.end(), facts.notes.begin(), facts.notes.end());
  const UnitFact& position = facts.positionUnit;
  if (draft.isSpacingChosen)
    notes.push_back(message("The points are {} apart, as surface.point_spacing says.", spacing));
  else if (position.source == UnitSource::File)
    notes.push_back(
        message("Positions are in {}, as the file states.", printedUnit(position.unit)));
  else if (position.source == UnitSource::Choice)
    notes.push_back(
        message("Positions are in {}, as surface.position_unit says.", printedUnit(position.unit)));
  else
    notes.emplace_back("The file states no unit of positions: they are taken as metres.");
  const UnitFact& height = facts.heightUnit;
  if (height.source == UnitSource::File)
    notes.push_back(message("Heights are in {}, as the file states.", printedUnit(height.unit)));
  else if (height.source == UnitSource::Choice)
    notes.push_back(
        message("Heights are in {}, as surface.height_unit says.", printedUnit(height.unit)));
  else
    notes.emplace_back("The file states no unit of heights: they are taken as metres.");
  if (!draft.hasPositions)
    notes.push_back(
        message("The file does not say how far its points are apart: {} is assumed.", spacing));
  if (const std::string other =
          replacedUnit(position, draft.positionUnit, draft.unknownPositionUnit);
      !other.empty() && !draft.isSpacingChosen)
    notes.push_back(
        message("The file states positions in {}: surface.position_unit replaces it.", other));
  if (const std::string other = replacedUnit(height, draft.heightUnit, draft.unknownHeightUnit);
      !other.empty())
    notes.push_back(
        message("The file states heights in {}: surface.height_unit replaces it.", other));
  noteLargeSizes(grid, facts, notes);
  noteVoids(grid, height, notes);
  if (extentOf(grid.height).size() == 0)
    notes.emplace_back("All heights are the same: the surface is flat.");
  if (facts.gaps == 1) notes.emplace_back("One point has no height.");
  if (facts.gaps > 1) notes.push_back(message("{} points have no height.", facts.gaps));
  facts.notes = std::move(notes);
}

namespace {

/// Adds a note where the header states another number of points than there are.
void noteOtherCounts(const TextPart& in, SurfaceDraft& draft) {
  const Topography& grid = draft.grid;
  const auto points = statedCount(in, Counted::Points);
  const auto columns = statedCount(in, Counted::Columns);
  const auto rows = statedCount(in, Counted::Rows);
  const auto lines = static_cast<std::int64_t>(in.block.rows);
  std::vector<Message>& notes = draft.facts.notes;
  if (grid.rows == 1) {
    if (points && *points != lines && *points != grid.columns)
      notes.push_back(
          message("The header states {} points, and the table has {}: the file may be cut off.",
                  *points, lines));
  } else if (columns && rows) {
    const bool isSame = *columns == grid.columns && *rows == grid.rows;
    const bool isTurned = *columns == grid.rows && *rows == grid.columns;
    if (!isSame && !isTurned)
      notes.push_back(
          message("The header states {} x {} points, and the table has {} x {}: the "
                  "file may be cut off.",
                  *columns, *rows, grid.columns, grid.rows));
  }
}

/// Returns the factor in a text that is nothing else: "100", "0,01", "10^-2".
std::optional<double> numberAlone(std::string_view text) {
  double number = 0;
  if (readTextNumber(text, '.', number) || readTextNumber(text, ',', number)) return number;
  const auto power = powerOfTenIn(text);
  return power ? std::optional(power->value) : std::nullopt;
}

/// Returns the factor that a name states: "z x100", "z * 0.01", "z (\u00D710)", "10*z", "z/100";
/// nothing where there is none. "x 2" is a second x.
std::optional<double> factorIn(std::string_view name) {
  constexpr double kMin = 10;
  if (const auto front = parseQuantity(name);
      front && isOneOf(front->unit.substr(0, 1), WordList("* /")) && front->number > 0)
    return front->number;
  while (name.ends_with(')') || name.ends_with(']')) name.remove_suffix(1);
  for (const std::string_view mark : WordList("x X * \u00D7 \u00B7 /")) {
    const std::size_t at = name.rfind(mark);
    if (at == name.npos || at == 0) continue;
    const bool isLetter = mark == "x" || mark == "X";
    if (isLetter && !isOneOf(name.substr(at - 1, 1), WordList("( [ _")) && name[at - 1] != ' ')
      continue;
    const auto factor = numberAlone(trimmedBlanks(name.substr(at + mark.size())));
    if (!factor || !(*factor > 0) || *factor == 1) continue;
    if (mark == "/") return 1 / *factor;
    if (!isLetter || *factor < 1 || *factor >= kMin) return factor;
  }
  return {};
}

void addFactor(double factor, std::string_view statement, std::vector<Message>& notes) {
  notes.push_back(
      message("The header states a factor of {} ({}), which is not applied: multiply the "
              "numbers of the file where they have to be.",
              printed(factor, 6), Message::name(shortened(statement))));
}

/// Adds a note where a line of the header states a factor, of which it does not say what it
/// multiplies.
void noteFactors(const TextPart& in, SurfaceDraft& draft) {
  constexpr WordList kFactors(
      "scaling factor, scale factor, scaling, z scaling, z scale, z-scale, z factor, z-factor, "
      "height scale, height factor, vertical scale, multiplier, skalierung, skalierungsfaktor, "
      "faktor, z-faktor, h\u00F6henfaktor, facteur d'\u00E9chelle, fattore di scala, factor de "
      "escala",
      ',');
  for (const std::string_view key : kFactors)
    if (const auto factor = parseQuantity(in.entry(key));
        factor && factor->number != 1 && factor->number > 0)
      addFactor(factor->number, key, draft.facts.notes);
  if (draft.facts.format != "matrix") return;
  // The name of the table stands above it.
  for (const TextEntry& entry : in.block.header) {
    const std::string name = parseColumnName(entry.value).name;
    if (const auto factor = factorIn(name);
        factor && entry.key.empty() && isHeightName(lowerCase(name)))
      addFactor(*factor, name, draft.facts.notes);
  }
}

/// Adds notes where the header states another unit or another step than the columns that are read.
void noteContradictions(const SurfaceText& in, SurfaceDraft& draft) {
  std::vector<Message>& notes = draft.facts.notes;
  const auto otherUnit = [&](const std::optional<StatedUnit>& unit, const std::string& column,
                             const std::string& choice, bool ofHeights) -> std::string {
    if (!unit || column.empty() || choice != "auto") return {};
    const auto stated = headerUnit(in, ofHeights, UnitEntries::Own);
    return stated && stated->metres != unit->metres ? printedUnit(stated->text) : "";
  };
  if (const std::string other = otherUnit(draft.positionUnit, draft.facts.positionColumn,
                                          in.source.choices.positionUnit, false);
      !other.empty())
    notes.push_back(
        message("The header states {} for positions, and their column {}, which is taken.", other,
                printedUnit(draft.positionUnit->text)));
  if (const std::string other =
          otherUnit(draft.heightUnit, draft.facts.heightColumn, in.source.choices.heightUnit, true);
      !other.empty())
    notes.push_back(
        message("The header states {} for heights, and their column {}, which is taken.", other,
                printedUnit(draft.heightUnit->text)));
  if (!draft.hasPositions || !draft.positionUnit || in.source.choices.positionUnit != "auto")
    return;
  constexpr double kRounding = 0.02;
  const double spacing = draft.grid.columnSpacing * draft.positionUnit->metres;
  const auto step = headerLength(in, LengthKind::Step, 'x');
  if (step && step->unit &&
      std::abs(step->value * step->unit->metres - spacing) > kRounding * spacing)
    notes.push_back(message(
        "The header states a step of {}, and the positions are {} apart: the positions are taken.",
        printed(step->value * step->unit->metres, "m"), printed(spacing, "m")));
}

/// Adds what the reader can only suppose about the notation of the numbers.
void addAssumptions(const TextTable& table, std::uint32_t lineOfCount,
                    std::vector<Message>& notes) {
  if (lineOfCount > 0)
    notes.push_back(
        message("Line {} is left out: it is the number of the heights below it.", lineOfCount));
  std::ranges::move(doubtsAbout(table), std::back_inserter(notes));
  if (table.dialect.isUnclear) notes.push_back(unclearMark(table.dialect.decimal));
}

}  // namespace

void noteFactor(const TextBlock& block, int column, std::vector<Message>& notes) {
  const std::string& name = columnAt(block, column).name;
  if (const auto factor = factorIn(name)) addFactor(*factor, name, notes);
}

void noteStatements(const SurfaceText& in, std::uint32_t lineOfCount, SurfaceDraft& draft) {
  noteOtherCounts(in, draft);
  noteFactors(in, draft);
  noteContradictions(in, draft);
  addAssumptions(in.table, lineOfCount, draft.facts.notes);
}

}  // namespace asperity
