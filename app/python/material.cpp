// Materials from measured moduli for Python, with the options of `asperity material` as arguments.
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "app/material_values.h"
#include "app/python/call.h"
#include "app/python/module.h"
#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/regular_file.h"
#include "core/base/text.h"
#include "core/base/text_number.h"
#include "core/base/units.h"
#include "core/material/material_model.h"
#include "core/scene/material_tables.h"

namespace asperity {
namespace {

namespace py = pybind11;
using Texts = std::vector<std::string>;

constexpr std::size_t kLargestFile = std::size_t{64} << 20;  // bytes of measurements

/// An option of the program, as it is written there: "--terms" and "12".
struct Option {
  std::string name, value;
};

double kelvins(const Option& option) {
  return kelvinsFrom(option.value, option.name);
}

double pascals(const Option& option) {
  return pascalsFrom(option.value, option.name);
}

double numberWithin(const Option& option, double least, double most) {
  double number = 0;
  if (!readNumber(option.value, number) || !std::isfinite(number))
    throw InputError("", option.name,
                     message("'{}' is not a number; allowed is {} to {}", shortened(option.value),
                             plain(least), plain(most)));
  if (number < least || number > most)
    throw InputError(
        "", option.name,
        message("{} is outside {} to {}", shortened(option.value), plain(least), plain(most)));
  return number;
}

std::string unitOf(const Option& option, bool isKnown, const std::string& allowed) {
  if (!isKnown)
    throw InputError("", option.name,
                     message("'{}' is not one of {}", shortened(option.value), allowed));
  return option.value;
}

bool isTrue(const Option& option) {
  return option.value == "true";
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
       const double terms = numberWithin(o, 1, 64);
       if (terms != std::round(terms))
         throw InputError("", o.name, message("{} is not a whole number", shortened(o.value)));
       c.series.terms = static_cast<int>(terms);
     }},
    {"--vertical-shifts", [](const Option& o, MaterialChoices& c) { c.isVertical = isTrue(o); }},
    {"--shift",
     [](const Option& o, MaterialChoices& c) { c.shift = chosen(kShiftChoices, o.value, o.name); }},
    {"--modulus",
     [](const Option& o, MaterialChoices& c) {
       c.columns.modulus = chosen(kModulusChoices, o.value, o.name);
     }},
    {"--poisson-ratio",
     [](const Option& o, MaterialChoices& c) { c.columns.poissonRatio = numberWithin(o, 0, 0.5); }},
    {"--temperature",
     [](const Option& o, MaterialChoices& c) { c.columns.temperature = kelvins(o); }},
    {"--temperature-tolerance",
     [](const Option& o, MaterialChoices& c) {
       c.temperatureTolerance = numberWithin(o, 0.001, 100);
     }},
    {"--leave-out", [](const Option& o, MaterialChoices& c) { c.leftOut.push_back(kelvins(o)); }},
    {"--equilibrium-modulus",
     [](const Option& o, MaterialChoices& c) { c.series.equilibriumModulus = pascals(o); }},
    {"--instantaneous-modulus",
     [](const Option& o, MaterialChoices& c) { c.instantaneousModulus = pascals(o); }},
    {"--liquid", [](const Option& o, MaterialChoices& c) { c.series.isLiquid = isTrue(o); }},
    {"--frequency-column",
     [](const Option& o, MaterialChoices& c) { c.columns.frequencyColumn = o.value; }},
    {"--temperature-column",
     [](const Option& o, MaterialChoices& c) { c.columns.temperatureColumn = o.value; }},
    {"--storage-column",
     [](const Option& o, MaterialChoices& c) { c.columns.storageColumn = o.value; }},
    {"--loss-column", [](const Option& o, MaterialChoices& c) { c.columns.lossColumn = o.value; }},
    {"--tan-delta-column",
     [](const Option& o, MaterialChoices& c) { c.columns.lossTangentColumn = o.value; }},
    {"--magnitude-column",
     [](const Option& o, MaterialChoices& c) { c.columns.magnitudeColumn = o.value; }},
    {"--phase-column",
     [](const Option& o, MaterialChoices& c) { c.columns.phaseColumn = o.value; }},
    {"--strain-column",
     [](const Option& o, MaterialChoices& c) { c.columns.strainColumn = o.value; }},
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
           unitOf(o, frequencyUnit(o.value, false).has_value(), "rad/s, " + unitNames("Hz"));
     }},
    {"--temperature-unit",
     [](const Option& o, MaterialChoices& c) {
       c.columns.temperatureUnit = unitOf(o, temperatureUnit(o.value).has_value(), unitNames("K"));
     }},
    {"--modulus-unit",
     [](const Option& o, MaterialChoices& c) {
       c.columns.modulusUnit = unitOf(o, unitSize(o.value, "Pa").has_value(), unitNames("Pa"));
     }},
    {"--name", [](const Option& o, MaterialChoices& c) { c.name = o.value; }},
    {"--source", [](const Option& o, MaterialChoices& c) { c.source = o.value; }},
}};

/// Options that label the material but do not change it; the origin leaves them out.
bool isLabel(std::string_view name) {
  return name == "--name" || name == "--source";
}

/// The options are in the order of the program, not of the arguments.
MaterialChoices choicesOf(std::vector<std::pair<std::string, std::string>> options) {
  std::ranges::stable_sort(options, {}, [](const auto& option) {
    return std::ranges::find(kRows, std::string_view(option.first), &Row::name) - kRows.begin();
  });
  MaterialChoices choices;
  for (const auto& [name, value] : options) {
    const auto row = std::ranges::find(kRows, std::string_view(name), &Row::name);
    if (row == kRows.end()) {
      std::array<std::string_view, kRows.size()> names;
      std::ranges::transform(kRows, names.begin(), &Row::name);
      const std::string_view nearest = nearestWord(name, names);
      std::string argument(nearest.empty() ? nearest : nearest.substr(2));
      std::ranges::replace(argument, '-', '_');
      throw InputError("", name,
                       argument.empty() ? message("unknown argument of asperity.material")
                                        : message("unknown argument of asperity.material; did you "
                                                  "mean {}?",
                                                  argument));
    }
    row->set({name, value}, choices);
    if (!isLabel(name)) choices.options.emplace_back(name, value);
  }
  return choices;
}

}  // namespace

void addMaterial(py::module_& module) {
  py::class_<Material, std::shared_ptr<Material>>(module, "Material")
      .def("json", &materialJson)
      .def("summary",
           [](const Material& material) {
             Texts lines;
             for (const Message& line : materialSummary(material)) lines.push_back(line.english());
             return lines;
           })
      .def("is_measured", &Material::isMeasured)
      .def("prony_csv", &pronyCsv)
      .def("isotherms_csv", &isothermsCsv)
      .def("shifts_csv", &shiftsCsv);
  module.def("material", [](const std::string& file,
                            const std::vector<std::pair<std::string, std::string>>& options,
                            const py::object& progress) {
    const MaterialChoices choices = choicesOf(options);
    return compute(progress, [file, choices](const Call&) {
      return std::make_shared<Material>(
          makeMaterial(readRegularFile(file, kLargestFile), file, choices));
    });
  });
}

}  // namespace asperity
