// Reads the shift that a text states: constants of Williams, Landel and Ferry, the activation
// energy of Arrhenius, or a table of shift factors.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <string_view>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/text.h"
#include "core/base/text_clause.h"
#include "core/base/text_number.h"
#include "core/base/text_units.h"
#include "core/base/units.h"
#include "core/material/dma_columns.h"
#include "core/material/isotherms.h"
#include "core/material/prony_table.h"
#include "core/material/stated_temperature.h"
#include "core/material/temperature_shift.h"

namespace asperity {
namespace {

/// The columns of a table of shift factors.
struct ShiftColumns {
  std::size_t temperature = 0, factor = 0;
  ShiftNotation notation{};
};

std::optional<ShiftColumns> shiftColumns(const TextBlock& block) {
  std::optional<std::size_t> temperature, factor;
  ShiftColumns found;
  for (std::size_t i = 0; i < block.columns.size(); ++i) {
    const DmaQuantity quantity = dmaColumn(block.columns[i]).quantity;
    if (quantity == DmaQuantity::Frequency || quantity == DmaQuantity::Storage) return {};
    if (quantity == DmaQuantity::Temperature && !temperature) temperature = i;
    const auto notation = shiftNotation(block.columns[i].name);
    if (factor || !notation) continue;
    factor = i;
    found.notation = *notation;
  }
  if (!temperature || !factor) return {};
  found.temperature = *temperature;
  found.factor = *factor;
  return found;
}

/// Reads the rows in rising temperature; empty where they are no table of a scene.
std::vector<ShiftPoint> shiftRows(const TextBlock& block, const ShiftColumns& columns,
                                  const std::string& chosenUnit) {
  std::string unit = chosenUnit.empty() ? block.columns[columns.temperature].unit : chosenUnit;
  const std::vector<double> temperatures = block.column(columns.temperature);
  const std::vector<double> factors = block.column(columns.factor);
  for (const auto* values : {&temperatures, &factors})
    if (!std::ranges::all_of(*values, [](double value) { return std::isfinite(value); })) return {};
  if (unit.empty()) unit = assumedTemperatureUnit(std::ranges::min(temperatures));
  const auto scale = temperatureUnit(unit);
  if (!scale) return {};
  std::vector<ShiftPoint> rows;
  for (std::size_t row = 0; row < block.rows; ++row) {
    if (!columns.notation.isLogarithm && !(factors[row] > 0)) return {};
    const double decades = columns.notation.log10Shift(factors[row]);
    const double kelvin = scale->toSi(temperatures[row]);
    if (!(kelvin >= kColdestTest && std::abs(decades) <= kMaxDecades)) return {};
    rows.push_back({kelvin, decades});
  }
  std::ranges::sort(rows, {}, &ShiftPoint::temperature);
  const auto isSame = [](const ShiftPoint& one, const ShiftPoint& other) {
    return one.temperature == other.temperature;
  };
  return std::ranges::adjacent_find(rows, isSame) == rows.end() ? rows : std::vector<ShiftPoint>{};
}

/// Returns the shift of a table at its reference temperature.
void readShiftTable(const TextBlock& block, double temperature, const std::string& unit,
                    StatedShift& stated) {
  const std::size_t line = block.lines.front();
  TemperatureShift shift;
  shift.kind = ShiftKind::Table;
  shift.table = shiftRows(block, *shiftColumns(block), unit);
  if (shift.table.size() < 2) {
    stated.notes.push_back(
        message("the shift factors from line {} on are not read: they are no rising table", line));
    return;
  }
  // Degrees that were converted differ in the last digit.
  for (ShiftPoint& row : shift.table)
    if (std::abs(row.temperature - temperature) < 1e-6) row.temperature = temperature;
  constexpr double kNoShift = 0.05;  // decades
  if (temperature < shift.table.front().temperature ||
      temperature > shift.table.back().temperature ||
      !(std::abs(log10ShiftFactor(shift, temperature)) <= kNoShift)) {
    stated.notes.push_back(message(
        "the shift factors from line {} on are not read: they are not those of {}, where log aT "
        "would be 0",
        line, celsius(temperature)));
    return;
  }
  if (shift.table.back().log10Shift > shift.table.front().log10Shift)
    stated.notes.push_back(
        message("the shift factors from line {} on rise with temperature, and those of a rubber "
                "fall; check their sign",
                line));
  stated.shift = tableShift(shift.table, temperature);
  stated.notes.push_back(message("shift factors from line {} on: {} from {} to {}", line,
                                 shift.table.size(), celsius(shift.table.front().temperature),
                                 celsius(shift.table.back().temperature)));
}

/// The constants of Williams, Landel and Ferry, or of Arrhenius, as a header states them.
struct ShiftConstants {
  std::optional<double> c1{}, c2{};
  std::string unitOfC2{};
  std::optional<double> energy{};            // J/mol
  std::optional<double> reference{};         // K
  std::optional<std::size_t> line{};         // of the last line with words about a shift
  std::optional<std::size_t> naturalLine{};  // of a line with constants of ln aT
};

ShiftConstants shiftConstants(const TextTable& table, const std::string& unit) {
  ShiftConstants found;
  for (const TextBlock& block : table.blocks) {
    for (const TextEntry& entry : block.header) {
      const std::string line = joinEntry(entry);
      const std::vector<std::string> ofLine = wordsIn(line);
      if (hasOneOf(ofLine, "wlf arrhenius activation aktivierungsenergie")) found.line = entry.line;
      // The formula may stand in another line than the values.
      const bool isNatural = isOneOf("ln", ofLine) || containsOneOf(lowerCase(line), "exp( exp[");
      if (isNatural && hasOneOf(ofLine, "c1 c2 c\u2081 c\u2082")) found.naturalLine = entry.line;
      std::vector<std::string_view> statements;
      for (const std::string_view clause : splitClauses(line))
        std::ranges::copy(splitStatements(clause), std::back_inserter(statements));
      for (const std::string_view statement : statements) {
        // "C2 (K)"
        const auto stated = parseStatement(statement);
        const auto words = stated ? wordsIn(stated->name.name) : std::vector<std::string>();
        if (words.empty()) continue;
        const bool isC1 = isOneOf(words.back(), "c1 c\u2081");
        if (isC1) found.c1 = stated->quantity.number;
        if (isOneOf(words.back(), "c2 c\u2082")) {
          found.c2 = stated->quantity.number;
          found.unitOfC2 = stated->unit();
        }
        const bool isEnergy = isOneOf(words.back(), "ea e_a eact aktivierungsenergie") ||
                              hasOneOf(words, "activation");
        if (const auto size = unitSize(withoutBrackets(stated->unit()), "J/mol"); isEnergy && size)
          found.energy = stated->quantity.number * *size;
      }
    }
  }
  // The universal constants are those of the glass transition.
  const bool isUniversal =
      found.c1 && found.c2 && std::abs(*found.c1 - 17.44) < 0.1 && std::abs(*found.c2 - 51.6) < 0.5;
  found.reference = statedShiftReference(table, unit, isUniversal);
  return found;
}

/// Returns the size in K of a unit of a difference of temperatures; what stands after it does not
/// count: "K) at 20 \u00B0C". Throws InputError where it is none.
double differenceSize(const std::string& unit, const std::string& name) {
  if (unit.empty()) return 1;
  for (const std::string_view text :
       {std::string_view(unit), std::string_view(unit).substr(0, unit.find_first_of(" ,;)]"))})
    if (const auto scale = temperatureUnit(text)) return scale->size;
  throw InputError(name, "WLF",
                   message("C2 has the unit {}, which is none of a difference of temperatures, "
                           "such as K, \u00B0C or \u00B0F",
                           shortened(unit)));
}

void readWlf(const ShiftConstants& constants, double temperature, const std::string& name,
             StatedShift& stated) {
  const double c1 = *constants.c1, c2 = *constants.c2 * differenceSize(constants.unitOfC2, name);
  if (!(c1 > 0 && c1 <= kMaxC1 && c2 >= kMinC2 && c2 <= kMaxC2))
    throw InputError(name, "WLF",
                     message("C1 is {} and C2 is {} K; allowed is C1 above 0 to {}, C2 from {} to "
                             "{} K",
                             plain(c1), plain(c2), plain(kMaxC1), plain(kMinC2), plain(kMaxC2)));
  if (constants.naturalLine) {
    stated.notes.push_back(
        message("the constants C1 and C2 are not read: line {} is about ln aT, and C1 is expected "
                "to be that of log10 aT, which is C1 / 2.303",
                *constants.naturalLine));
    return;
  }
  if (!constants.reference)
    stated.notes.push_back(
        message("the constants C1 and C2 are taken as those at {}, the temperature of the curve: "
                "no reference temperature is stated for them",
                celsius(temperature)));
  TemperatureShift shift;
  shift.referenceTemperature = temperature;
  // The same curve from another reference: C2' = C2 + T - T_r, C1' = C1 C2 / C2'.
  const double apart = temperature - constants.reference.value_or(temperature);
  const bool isApart = std::abs(apart) > kIsothermTolerance;
  shift.c2 = isApart ? c2 + apart : c2;
  shift.c1 = isApart ? c1 * c2 / shift.c2 : c1;
  if (!(shift.c2 >= kMinC2)) {
    stated.notes.push_back(message("the constants C1 and C2 are not read: they hold above {}",
                                   celsius(temperature - shift.c2)));
    return;
  }
  stated.shift = shift;
  stated.notes.push_back(
      message("shift of the file: Williams, Landel and Ferry with C1 = {}, C2 = "
              "{} K at {}",
              printed(shift.c1), printed(shift.c2), celsius(temperature)));
}

/// The activation energy is the same from every reference temperature.
void readArrhenius(double energy, double temperature, const std::string& name,
                   StatedShift& stated) {
  if (!(energy > 0 && energy <= kMaxActivationEnergy))
    throw InputError(name, "Arrhenius",
                     message("the activation energy is {} J/mol; allowed is above 0 to {} J/mol",
                             plain(energy), plain(kMaxActivationEnergy)));
  TemperatureShift shift;
  shift.kind = ShiftKind::Arrhenius;
  shift.referenceTemperature = temperature;
  shift.activationEnergy = energy;
  stated.shift = shift;
  stated.notes.push_back(message("shift of the file: Arrhenius with {} at {}",
                                 printed(energy, "J/mol"), celsius(temperature)));
}

}  // namespace

double ShiftNotation::log10Shift(double number) const {
  return decades * (isLogarithm ? number : std::log10(number));
}

std::optional<ShiftNotation> shiftNotation(std::string_view column) {
  const std::string word = plainWord(column);
  const bool isTen = isOneOf(word,
                             "logat log10at lgat logshiftfactor log10shift logshift "
                             "log10shiftfactor logat10");
  const bool isNatural = isOneOf(word, "lnat lnshiftfactor");
  if (!isTen && !isNatural &&
      !isOneOf(word, "at shiftfactor shiftfactors shiftfactorat horizontalshiftfactor"))
    return {};
  ShiftNotation notation{isTen || isNatural, isNatural ? std::numbers::log10e : 1};
  if (beginsWithOneOf(trimmedBlanks(column), "- \u2212 \u2013")) notation.decades *= -1;
  return notation;
}

bool isShiftTable(const TextBlock& block) {
  return shiftColumns(block).has_value();
}

bool statesShift(const TextTable& table) {
  const ShiftConstants constants = shiftConstants(table, {});
  return (constants.c1 && constants.c2) || constants.energy ||
         std::ranges::any_of(table.blocks, isShiftTable);
}

std::string temperatureNamed(const std::string& name, const std::string& unit) {
  const bool isNamed = isOneOf(
      name, "t temp temperature temperatur testtemperature messtemperatur isotherm isotherme");
  return (name.empty() || isNamed) && temperatureUnit(unit) ? "temperature" : "";
}

void moveLinesAbove(TextTable& table, const std::string& name) {
  const auto isOther = [](const TextBlock& block) { return !isShiftTable(block); };
  TextBlock& block = table.blocks.back();
  if (!isOther(block) || std::ranges::count_if(table.blocks, isOther) != 1) return;
  bool hasTemperature = false;
  const auto quantityOf = [&](const std::string& word, const std::string& unit) {
    const bool isReference = isOneOf(
        word, "tref referencetemperature reftemperature referenztemperatur bezugstemperatur");
    const bool isTemperature = isReference ? temperatureUnit(unit).has_value()
                                           : !word.empty() && !temperatureNamed(word, unit).empty();
    hasTemperature = hasTemperature || isTemperature;
    const bool isConstant =
        (isOneOf(word, "c1 c\u2081") && unit.empty()) ||
        (isOneOf(word, "c2 c\u2082") && (unit.empty() || temperatureUnit(unit))) ||
        (isOneOf(word, "ea eact activationenergy aktivierungsenergie") && unitSize(unit, "J/mol"));
    const std::string ofSeries = seriesWord(word);
    const bool isModulus = isEquilibrium(ofSeries) || isInstantaneous(ofSeries);
    return isTemperature || isConstant || isModulus ? word : std::string();
  };
  const std::vector<TextEntry> lines = statedBelow(table, quantityOf);
  const ShiftConstants above = shiftConstants(table, {});
  if (above.c1 || above.c2 || above.energy) return;
  // A line with another temperature or about a shift may change what these mean.
  const auto isUnclear = [&](const TextEntry& entry) {
    if (std::ranges::find(lines, entry.line, &TextEntry::line) != lines.end()) return false;
    const auto stated = parseStatement(joinEntry(entry));
    return !stated || !isKnownUnit(stated->unit()) || temperatureUnit(stated->unit());
  };
  if (std::ranges::any_of(table.trailer, isUnclear)) return;
  // The lines above the table precede them, and so does the name of the file.
  const std::size_t linesAbove = block.header.size();
  bool agrees = true;
  try {
    if (hasTemperature && statedTemperature({table, block}, {}, {}, true)) return;
    std::ranges::copy(lines, std::back_inserter(block.header));
    if (hasTemperature) {
      const auto ofName = temperatureInName(name);
      const auto below = statedTemperature({table, block}, {}, {}, true);
      constexpr double kSame = 0.01;  // K
      agrees = !ofName || (below && std::abs(ofName->kelvin - below->kelvin) < kSame);
    }
  } catch (const InputError&) {
    agrees = false;
  }
  if (!agrees) {
    block.header.resize(linesAbove);
    return;
  }
  std::erase_if(table.trailer, [&](const TextEntry& entry) {
    return std::ranges::find(lines, entry.line, &TextEntry::line) != lines.end();
  });
}

StatedShift statedShift(const TextTable& table, double temperature, const std::string& name,
                        const std::string& unit) {
  StatedShift stated;
  for (const TextBlock& block : table.blocks)
    if (isShiftTable(block) && !stated.shift) readShiftTable(block, temperature, unit, stated);
  const ShiftConstants constants = shiftConstants(table, unit);
  const bool hasConstants = constants.c1 && constants.c2;
  if (hasConstants && stated.shift)
    stated.notes.push_back("the constants C1 and C2 are not read: the file has shift factors");
  else if (hasConstants)
    readWlf(constants, temperature, name, stated);
  else if (constants.energy && !stated.shift)
    readArrhenius(*constants.energy, temperature, name, stated);
  else if (constants.line && !stated.shift)
    stated.notes.push_back(
        message("line {} is about a shift and is not read: C1 and C2 with values, an activation "
                "energy as Ea = 80 kJ/mol, or a table of temperature and log aT, would be",
                *constants.line));
  return stated;
}

}  // namespace asperity
