#include "core/measured/text_notes.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/number_text.h"
#include "core/base/text.h"
#include "core/base/text_header.h"
#include "core/base/text_number.h"
#include "core/base/text_units.h"
#include "core/measured/reading_notes.h"
#include "core/measured/text_columns.h"
#include "core/measured/text_lengths.h"
#include "core/measured/text_steps.h"

namespace asperity {
namespace {

/// Adds a note where the header states another number of points than there are.
void noteOtherCounts(const TextTable& table, const TextBlock& block, SurfaceDraft& draft) {
  const Topography& grid = draft.grid;
  const auto points = statedCount(table, block, Counted::Points);
  const auto columns = statedCount(table, block, Counted::Columns);
  const auto rows = statedCount(table, block, Counted::Rows);
  const auto lines = static_cast<std::int64_t>(block.rows);
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
              PrintedNumber{printedNumber(factor, 6)}, Message::name(shortened(statement))));
}

/// Adds a note where a line of the header states a factor, of which it does not say what it
/// multiplies.
void noteFactors(const TextTable& table, const TextBlock& block, SurfaceDraft& draft) {
  constexpr WordList kFactors(
      "scaling factor, scale factor, scaling, z scaling, z scale, z-scale, z factor, z-factor, "
      "height scale, height factor, vertical scale, multiplier, skalierung, skalierungsfaktor, "
      "faktor, z-faktor, h\u00F6henfaktor, facteur d'\u00E9chelle, fattore di scala, factor de "
      "escala",
      ',');
  for (const std::string_view key : kFactors)
    if (const auto factor = parseQuantity(table.entry(key, block));
        factor && factor->number != 1 && factor->number > 0)
      addFactor(factor->number, key, draft.facts.notes);
  if (draft.facts.format != "matrix") return;
  // The name of the table stands above it.
  for (const TextEntry& entry : block.header) {
    const std::string name = parseColumnName(entry.value).name;
    if (const auto factor = factorIn(name);
        factor && entry.key.empty() && isHeightName(lowerCase(name)))
      addFactor(*factor, name, draft.facts.notes);
  }
}

/// Adds notes where the header states another unit or another step than the columns that are read.
void noteContradictions(const TextTable& table, const TextBlock& block, const SurfaceSource& source,
                        SurfaceDraft& draft) {
  std::vector<Message>& notes = draft.facts.notes;
  const auto otherUnit = [&](const std::optional<StatedUnit>& unit, const std::string& column,
                             const std::string& choice, bool ofHeights) -> std::string {
    if (!unit || column.empty() || choice != "auto") return {};
    const auto stated = headerUnit(table, block, ofHeights, UnitEntries::Own);
    return stated && stated->metres != unit->metres ? printedUnit(stated->text) : "";
  };
  if (const std::string other = otherUnit(draft.positionUnit, draft.facts.positionColumn,
                                          source.choices.positionUnit, false);
      !other.empty())
    notes.push_back(
        message("The header states {} for positions, and their column {}, which is taken.", other,
                printedUnit(draft.positionUnit->text)));
  if (const std::string other =
          otherUnit(draft.heightUnit, draft.facts.heightColumn, source.choices.heightUnit, true);
      !other.empty())
    notes.push_back(
        message("The header states {} for heights, and their column {}, which is taken.", other,
                printedUnit(draft.heightUnit->text)));
  if (!draft.hasPositions || !draft.positionUnit || source.choices.positionUnit != "auto") return;
  constexpr double kRounding = 0.02;
  const double spacing = draft.grid.columnSpacing * draft.positionUnit->metres;
  const auto step = headerLength(table, block, LengthKind::Step, 'x', source);
  if (step && step->unit &&
      std::abs(step->value * step->unit->metres - spacing) > kRounding * spacing)
    notes.push_back(message(
        "The header states a step of {}, and the positions are {} apart: the positions are taken.",
        PrintedNumber{printedQuantity(step->value * step->unit->metres, "m")},
        PrintedNumber{printedQuantity(spacing, "m")}));
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
  const std::string& name = block.columns[static_cast<std::size_t>(column)].name;
  if (const auto factor = factorIn(name)) addFactor(*factor, name, notes);
}

void noteStatements(const TextTable& table, const TextBlock& block, const SurfaceSource& source,
                    std::uint32_t lineOfCount, SurfaceDraft& draft) {
  noteOtherCounts(table, block, draft);
  noteFactors(table, block, draft);
  noteContradictions(table, block, source, draft);
  addAssumptions(table, lineOfCount, draft.facts.notes);
}

}  // namespace asperity
