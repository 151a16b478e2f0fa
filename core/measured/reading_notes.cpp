#include "core/measured/reading_notes.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/base/number_text.h"

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

/// Returns the distance from the lowest to the highest height, m.
double heightSpan(const Topography& grid) {
  double lowest = INFINITY, highest = -INFINITY;
  for (const double height : grid.height) {
    lowest = std::fmin(lowest, height);
    highest = std::fmax(highest, height);
  }
  return highest - lowest;
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
  if (const double span = heightSpan(grid); span > kHighestUsual)
    notes.push_back(
        message("The heights span {:.3g} m: if the file states a wrong unit of heights, "
                "surface.height_unit replaces it.",
                span));
}

}  // namespace

std::string printedUnit(const std::string& unit) {
  // The second one was written in Shift-JIS and read as Latin-1.
  return unit == "um" || unit == "\u0192\u00CAm" ? "\u00B5m" : unit;
}

void addReadingNotes(SurfaceDraft& draft) {
  const Topography& grid = draft.grid;
  ReadingFacts& facts = draft.facts;
  std::vector<Message> notes;
  const PrintedNumber spacing{printedQuantity(grid.columnSpacing, "m")};
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
                            grid.columns, grid.rows, spacing,
                            PrintedNumber{printedQuantity(grid.rowSpacing, "m")}));
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
  if (heightSpan(grid) == 0) notes.emplace_back("All heights are the same: the surface is flat.");
  if (facts.gaps == 1) notes.emplace_back("One point has no height.");
  if (facts.gaps > 1) notes.push_back(message("{} points have no height.", facts.gaps));
  facts.notes = std::move(notes);
}

}  // namespace asperity
