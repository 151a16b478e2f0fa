#include "core/material/dma_units.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "core/base/input_error.h"
#include "core/base/intervals.h"
#include "core/base/statistics.h"
#include "core/base/text.h"
#include "core/base/text_clause.h"
#include "core/base/text_number.h"
#include "core/material/dma_columns.h"
#include "core/material/text_quantities.h"

namespace asperity {
namespace {

/// Returns the text in brackets, or after a slash, at the end of a name that is neither a
/// quantity nor a word for the kind of modulus: "furlongs" of "G' (furlongs)". It is refused as a
/// unit.
std::string unknownUnitIn(const std::string& name) {
  const std::string unit = unitText(name);
  const DmaColumn meaning = dmaColumn(unit, {});
  const bool isNone = unit.empty() || meaning.quantity != DmaQuantity::None ||
                      meaning.temperature || firstFrequency(unit) ||
                      meaning.kind != ModulusKind::Unknown;
  constexpr WordList kOtherWords(
      "real imaginary imag in-phase out-of-phase elastic viscous dynamic mean average measured "
      "corrected smoothed abs complex at shifted reference linear absolute");
  return isNone || isOneOf(lowerCase(unit), kOtherWords) ? std::string() : unit;
}

/// Returns name and unit of a column; the user's choice of a unit overrides that of the file.
DmaColumnFact columnFact(const DmaBlock& in, std::size_t column, const std::string& choice) {
  DmaColumnFact fact;
  fact.name = in.block.label(column);
  fact.unit = choice.empty() ? in.block.columns[column].unit : choice;
  // The brackets of "G' [20 °C]" contain a temperature and no unit.
  const TextColumn& written = in.block.columns[column];
  if (choice.empty() && dmaColumn(written).isUnitOfState) fact.unit.clear();
  if (fact.unit.empty()) fact.unit = unknownUnitIn(written.name);
  fact.isUnitAssumed = fact.unit.empty();
  return fact;
}

[[noreturn]] void refuseUnit(const DmaBlock& in, const DmaColumnFact& fact,
                             const std::string& allowed, const char* option) {
  throw InputError(in.fileName, fact.name,
                   message("has the unit {}, which is not one of {}; {} says which is meant",
                           shortened(fact.unit), allowed, option));
}

/// Throws InputError for a unit that would be assumed where a line above or below the block names
/// another one.
void refuseUnitElsewhere(const DmaBlock& in, const DmaColumnFact& fact, const char* option,
                         const std::function<bool(const std::string&)>& isOther) {
  if (!fact.isUnitAssumed) return;
  if (const auto found = unitOfNoNumber(in, isOther))
    throw InputError(in.fileName, fact.name,
                     message("has no unit, and line {} names '{}'; {} says which is meant",
                             found->line, shortened(found->word), option));
}

/// Returns whether a word beside a table names another frequency than one in units of this size.
bool namesOtherFrequency(const std::string& word, bool isAngular, double size) {
  const std::string lower = lowerCase(word);
  // "Rectangular" and "radius" are words of the shape of a sample.
  if (!isAngular && beginsWithOneOf(lower, "angular kreisfreq omega \u03C9")) return true;
  if (lower.starts_with("rad") && lower != "rad" &&
      !beginsWithOneOf(lower, "rad/ rad* rad. rad\u00B7 rads"))
    return false;
  const auto other = word.size() > 1 ? frequencyUnit(word, isAngular) : std::nullopt;
  return other && *other != size;
}

/// Returns whether a word beside a table names a unit of moduli other than the pascal.
bool namesOtherModulus(const std::string& word) {
  // A sample may be a bar, and nobody measures rubber in bar.
  if (word.size() < 2 || lowerCase(word) == "bar") return false;
  const auto size = unitSize(word, "Pa");
  return size && *size != 1;
}

std::optional<double> tangentSize(const std::string& unit) {
  if (unit.empty() || unit == "1" || unit == "-") return 1;
  return unitSize(unit == "percent" ? "%" : unit, "");
}

/// Returns the unit of a viscosity or a compliance beside a unit of moduli: "MPa s", "1/MPa",
/// "1/(N/mm2)".
std::string unitInForm(MeasuredForm form, const std::string& ofModuli) {
  switch (form) {
    case MeasuredForm::Viscosity:
      return ofModuli + " s";
    case MeasuredForm::Compliance:
      return "1/" + (ofModuli.find('/') == std::string::npos ? ofModuli : "(" + ofModuli + ")");
    default:
      return ofModuli;
  }
}

/// Returns the size of a unit that a file states, in Pa s, 1/Pa or Pa.
std::optional<double> sizeInForm(MeasuredForm form, const std::string& unit) {
  switch (form) {
    case MeasuredForm::Viscosity:
      return viscosityUnit(unit);
    case MeasuredForm::Compliance:
      return complianceUnit(unit);
    default:
      return unitSize(unit, "Pa");
  }
}

/// Returns the same for the unit beside a unit of moduli that a user chose. It is computed from the
/// latter: "N/mm2 s" is no unit that could be read.
std::optional<double> chosenSize(MeasuredForm form, const std::string& ofModuli) {
  const auto size = unitSize(ofModuli, "Pa");
  return size && form == MeasuredForm::Compliance ? 1 / *size : size;
}

std::string allowedUnits(MeasuredForm form) {
  return form == MeasuredForm::Compliance ? "1/Pa, 1/kPa, 1/MPa, mm\u00B2/N"
                                          : unitNames(unitInForm(form, "Pa"));
}

}  // namespace

SizedColumn frequencyColumn(const DmaBlock& in, std::size_t column) {
  SizedColumn found{columnFact(in, column, in.choices.frequencyUnit)};
  const bool isAngular = dmaColumn(in.block.columns[column]).isAngular;
  const auto size = frequencyUnit(found.fact.unit, isAngular);
  if (!size) refuseUnit(in, found.fact, "rad/s, " + unitNames("Hz"), "--frequency-unit");
  refuseUnitElsewhere(in, found.fact, "--frequency-unit", [&](const std::string& word) {
    return namesOtherFrequency(word, isAngular, *size);
  });
  if (found.fact.unit.empty()) found.fact.unit = isAngular ? "rad/s" : "Hz";
  found.size = *size;
  return found;
}

SizedColumn modulusColumn(const DmaBlock& in, std::size_t column) {
  const MeasuredForm form = dmaColumn(in.block.columns[column]).form;
  const std::string& chosen = in.choices.modulusUnit;
  SizedColumn found{columnFact(in, column, chosen.empty() ? chosen : unitInForm(form, chosen))};
  refuseUnitElsewhere(in, found.fact, "--modulus-unit", namesOtherModulus);
  std::string& unit = found.fact.unit;
  if (unit.empty()) unit = unitInForm(form, "Pa");
  const auto size = chosen.empty() ? sizeInForm(form, unit) : chosenSize(form, chosen);
  if (!size) refuseUnit(in, found.fact, allowedUnits(form), "--modulus-unit");
  found.size = *size;
  return found;
}

std::optional<double> lossTangentSize(const DmaBlock& in, std::size_t column) {
  return tangentSize(columnFact(in, column, {}).unit);
}

SizedColumn lossTangentColumn(const DmaBlock& in, std::size_t column) {
  const DmaColumnFact fact = columnFact(in, column, {});
  std::vector<double> values = in.block.column(column);
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  constexpr double kLargest = 3;  // median of a rubber
  const double median = values.empty() ? 0 : upperMedian(std::move(values));
  if (fact.unit.empty() && median > kLargest)
    throw InputError(in.fileName, fact.name,
                     message("has no unit, and its median is {:.3g}, more than that of a rubber; "
                             "write its unit after the name, as in \"tan delta (%)\" or \"tan "
                             "delta (1)\"",
                             median));
  if (const auto size = tangentSize(fact.unit)) return {{fact.name, {}, false}, *size};
  throw InputError(in.fileName, fact.name,
                   message("has the unit {}; a loss factor has none, or %", shortened(fact.unit)));
}

SizedColumn phaseColumn(const DmaBlock& in, std::size_t column) {
  SizedColumn found{columnFact(in, column, {})};
  DmaColumnFact& fact = found.fact;
  if (const auto size = angleUnit(in.block.columns[column].unit)) return {fact, *size};
  if (!fact.unit.empty())
    throw InputError(in.fileName, fact.name,
                     message("has the unit {}; an angle is in rad or deg", shortened(fact.unit)));
  double largest = 0;
  for (const double value : in.block.column(column))
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  const bool isInDegrees = largest > std::numbers::pi / 2;
  fact.unit = isInDegrees ? "deg" : "rad";
  found.size = isInDegrees ? std::numbers::pi / 180 : 1;
  return found;
}

TemperatureColumn temperatureColumn(const DmaBlock& in, std::size_t column) {
  DmaColumnFact fact = columnFact(in, column, in.choices.temperatureUnit);
  const auto [lowest, highest] = extentOf(in.block.column(column));
  if (!fact.unit.empty()) {
    const auto unit = temperatureUnit(fact.unit);
    if (!unit) refuseUnit(in, fact, unitNames("K"), "--temperature-unit");
    TemperatureColumn found{fact, *unit};
    constexpr double kHighestKelvins = 500;
    const bool isInCelsius = *unit == *temperatureUnit("C");
    if (isInCelsius && in.choices.temperatureUnit.empty() && lowest >= kLowestKelvins &&
        highest <= kHighestKelvins)
      found.note = message(
          "{} runs from {} to {} \u00B0C, where most rubbers are destroyed; these "
          "look like kelvins: say --temperature-unit K if they are",
          Message::name(fact.name), lowest, highest);
    return found;
  }
  if (lowest < kLowestKelvins && highest > 250)
    throw InputError(in.fileName, fact.name,
                     message("runs from {} to {} without a unit: kelvins and degrees Celsius seem "
                             "to be mixed; say which with --temperature-unit, or correct the "
                             "column",
                             lowest, highest));
  fact.unit = assumedTemperatureUnit(lowest);
  return {fact, *temperatureUnit(fact.unit)};
}

double strainAt(const DmaBlock& in, std::size_t row, std::size_t column) {
  const double value = in.block.at(row, column);
  if (!std::isfinite(value) || value <= 0) return kNaN;
  const TextColumn& strain = in.block.columns[column];
  const bool isPercent = strain.unit.empty() && lowerCase(strain.name).ends_with("pct");
  const auto unit = strainUnit(isPercent ? "%" : strain.unit);
  if (!unit)
    throw InputError(in.fileName, "--strain-column",
                     message("the unit '{}' is not a unit of strain; known are %, ppm, mm/mm",
                             shortened(strain.unit)));
  return value * *unit;
}

}  // namespace asperity
