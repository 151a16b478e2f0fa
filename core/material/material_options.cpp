#include "core/material/material_options.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/base/input_error.h"
#include "core/base/named_choices.h"
#include "core/base/number_text.h"
#include "core/base/regular_file.h"
#include "core/base/text.h"
#include "core/base/text_number.h"
#include "core/base/units.h"
#include "core/material/dma_columns.h"
#include "core/material/temperature_shift.h"
#include "core/material/text_quantities.h"

namespace asperity {
namespace {

constexpr NamedChoices<std::optional<ShiftKind>, 4> kShifts{
    {{"auto", std::nullopt},
     {shiftName(ShiftKind::Wlf), ShiftKind::Wlf},
     {shiftName(ShiftKind::Arrhenius), ShiftKind::Arrhenius},
     {shiftName(ShiftKind::Table), ShiftKind::Table}}};
constexpr NamedChoices<ModulusKind, 3> kModulusKinds{{{"auto", ModulusKind::Unknown},
                                                      {"shear", ModulusKind::Shear},
                                                      {"tension", ModulusKind::Tension}}};

struct Option {
  std::string name, value;
};

/// Returns a temperature in K, such as 20C, 293.15K or 68F. A number alone is in K, so that 20 is
/// refused.
double kelvins(const Option& option) {
  constexpr double kHottest = 2000;
  const auto temperature = parseTemperature(option.value);
  if (!temperature || !(*temperature >= kColdestTest && *temperature <= kHottest))
    throw InputError(
        "", option.name,
        message("'{}' is not a temperature such as 20C, 293.15K or 68F", option.value));
  return *temperature;
}

/// Returns a modulus in Pa; the text may have a unit: 2.3MPa.
double pascals(const Option& option) {
  const auto quantity = parseQuantity(option.value);
  const auto unit = quantity ? unitSize(quantity->unit.empty() ? "Pa" : quantity->unit, "Pa")
                             : std::optional<double>();
  if (!unit || !(quantity->number > 0) || !std::isfinite(quantity->number * *unit))
    throw InputError("", option.name,
                     message("'{}' is not a modulus such as 2.3MPa", option.value));
  return quantity->number * *unit;
}

double numberWithin(const Option& option, double least, double most) {
  double number = 0;
  if (!readNumber(option.value, number) || !std::isfinite(number))
    throw InputError("", option.name,
                     message("'{}' is not a number; allowed is {}", shortened(option.value),
                             rangeText(least, most)));
  if (number < least || number > most)
    throw InputError("", option.name,
                     message("{} is outside {}", shortened(option.value), rangeText(least, most)));
  return number;
}

std::string knownUnit(const Option& option, bool isKnown, const std::string& allowed) {
  if (!isKnown)
    throw InputError("", option.name,
                     message("'{}' is not one of {}", shortened(option.value), allowed));
  return option.value;
}

bool isTrue(const Option& option) {
  return option.value == "true";
}

/// Sets the name of the column that has a quantity.
template <std::string DmaChoices::*column>
void setColumn(const Option& option, MaterialChoices& choices) {
  choices.columns.*column = option.value;
}

/// The effect of an option on the choices.
struct Row {
  std::string_view name;
  void (*set)(const Option& option, MaterialChoices& choices);
};

constexpr std::array<Row, 26> kRows{{
    {"--reference-temperature",
     [](const Option& o, MaterialChoices& c) { c.referenceTemperature = kelvins(o); }},
    {"--terms",
     [](const Option& o, MaterialChoices& c) {
       const double terms = numberWithin(o, 1, kMaxTerms);
       if (terms != std::round(terms))
         throw InputError("", o.name,
                          message("{} is not a whole number; allowed is {}", shortened(o.value),
                                  rangeText(1, kMaxTerms)));
       c.series.terms = static_cast<int>(terms);
     }},
    {"--vertical-shifts", [](const Option& o, MaterialChoices& c) { c.isVertical = isTrue(o); }},
    {"--shift",
     [](const Option& o, MaterialChoices& c) { c.shift = chosen(kShifts, o.value, o.name); }},
    {"--modulus",
     [](const Option& o, MaterialChoices& c) {
       c.columns.modulus = chosen(kModulusKinds, o.value, o.name);
     }},
    {"--poisson-ratio",
     [](const Option& o, MaterialChoices& c) {
       c.columns.poissonRatio = numberWithin(o, 0, kMaxPoissonRatio);
     }},
    {"--temperature",
     [](const Option& o, MaterialChoices& c) { c.columns.temperature = kelvins(o); }},
    {"--temperature-tolerance",
     [](const Option& o, MaterialChoices& c) {
       c.temperatureTolerance = numberWithin(o, kMinTemperatureTolerance, kMaxTemperatureTolerance);
     }},
    {"--leave-out", [](const Option& o, MaterialChoices& c) { c.leftOut.push_back(kelvins(o)); }},
    {"--equilibrium-modulus",
     [](const Option& o, MaterialChoices& c) { c.series.equilibriumModulus = pascals(o); }},
    {"--instantaneous-modulus",
     [](const Option& o, MaterialChoices& c) { c.instantaneousModulus = pascals(o); }},
    {"--liquid", [](const Option& o, MaterialChoices& c) { c.series.isLiquid = isTrue(o); }},
    {"--frequency-column", setColumn<&DmaChoices::frequencyColumn>},
    {"--temperature-column", setColumn<&DmaChoices::temperatureColumn>},
    {"--storage-column", setColumn<&DmaChoices::storageColumn>},
    {"--loss-column", setColumn<&DmaChoices::lossColumn>},
    {"--tan-delta-column", setColumn<&DmaChoices::lossTangentColumn>},
    {"--magnitude-column", setColumn<&DmaChoices::magnitudeColumn>},
    {"--phase-column", setColumn<&DmaChoices::phaseColumn>},
    {"--strain-column", setColumn<&DmaChoices::strainColumn>},
    {"--strain",
     [](const Option& o, MaterialChoices& c) {
       c.strainAmplitude = parseStrain(o.value);
       if (!c.strainAmplitude)
         throw InputError("", o.name,
                          message("'{}' is not a strain such as 1%", shortened(o.value)));
     }},
    {"--frequency-unit",
     [](const Option& o, MaterialChoices& c) {
       c.columns.frequencyUnit =
           knownUnit(o, frequencyUnit(o.value, false).has_value(), "rad/s, " + unitNames("Hz"));
     }},
    {"--temperature-unit",
     [](const Option& o, MaterialChoices& c) {
       c.columns.temperatureUnit =
           knownUnit(o, temperatureUnit(o.value).has_value(), unitNames("K"));
     }},
    {"--modulus-unit",
     [](const Option& o, MaterialChoices& c) {
       c.columns.modulusUnit = knownUnit(o, unitSize(o.value, "Pa").has_value(), unitNames("Pa"));
     }},
    {"--name", [](const Option& o, MaterialChoices& c) { c.name = o.value; }},
    {"--source", [](const Option& o, MaterialChoices& c) { c.source = o.value; }},
}};

/// Returns whether the option labels the material but does not change it.
bool isLabel(std::string_view name) {
  return name == "--name" || name == "--source";
}

}  // namespace

std::span<const std::string_view> materialOptionNames() {
  static const std::array<std::string_view, kRows.size()> names = [] {
    std::array<std::string_view, kRows.size()> all;
    std::ranges::transform(kRows, all.begin(), &Row::name);
    return all;
  }();
  return names;
}

MaterialChoices materialChoices(const WrittenOptions& options) {
  MaterialChoices choices;
  for (const auto& [name, value] : options) {
    std::ranges::find(kRows, std::string_view(name), &Row::name)->set({name, value}, choices);
    if (!isLabel(name)) choices.options.emplace_back(name, value);
  }
  return choices;
}

Material readMaterial(const std::string& file, const MaterialChoices& choices) {
  constexpr std::size_t kLargest = std::size_t{64} << 20;  // bytes of measurements
  return makeMaterial(readRegularFile(file, kLargest), file, choices);
}

}  // namespace asperity
