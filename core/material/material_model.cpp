#include "core/material/material_model.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/base/file_digest.h"
#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/text_encoding.h"
#include "core/material/stray_points.h"
#include "core/material/temperature_drift.h"

namespace asperity {
namespace {

constexpr std::size_t kMaxRows = 20000;  // of measurements; the fit takes a few seconds then
constexpr std::size_t kLargestSeries = std::size_t{4} << 20;  // bytes of a file with a ready series

/// Reads a table; returns nothing, and the error, where the file is none, because it may still be a
/// ready Prony series of a finite-element program.
std::optional<TextTable> readTable(std::string_view bytes, const std::string& name,
                                   std::optional<InputError>& failure) {
  try {
    TextTableOptions options;
    options.keepsTexts = options.readsCells = true;
    TextTable table = readTextTable(bytes, name, options);
    moveListsAbove(table);
    return table;
  } catch (const InputError& error) {
    failure = error;
    return {};
  }
}

/// Returns the temperature that the user states for a ready series: both options mean the same.
std::optional<double> chosenTemperature(const MaterialChoices& choices) {
  if (choices.columns.temperature) return choices.columns.temperature;
  if (std::isfinite(choices.referenceTemperature)) return choices.referenceTemperature;
  return {};
}

std::optional<PronyFile> readReadySeries(std::string_view bytes, const TextTable* table,
                                         const std::string& name, const MaterialChoices& choices) {
  if (bytes.size() > kLargestSeries) return {};
  const DecodedText decoded(bytes, name);
  PronyChoices series;
  series.instantaneousModulus = choices.instantaneousModulus;
  series.equilibriumModulus = choices.series.equilibriumModulus;
  series.modulusUnit = choices.columns.modulusUnit;
  series.modulus = choices.columns.modulus;
  series.poissonRatio = choices.columns.poissonRatio;
  series.isLiquid = choices.series.isLiquid;
  series.temperatureUnit = choices.columns.temperatureUnit;
  series.temperature = chosenTemperature(choices);
  series.temperatureTolerance = choices.temperatureTolerance;
  return readPronyFile(decoded.text, table, name, series);
}

/// A material without a shift of its own is known at one temperature only.
TemperatureShift shiftAt(double temperature) {
  TemperatureShift shift;
  shift.kind = ShiftKind::Table;
  shift.referenceTemperature = temperature;
  shift.table = {{temperature, 0}};
  return shift;
}

Material readySeries(const PronyFile& file, const std::string& name,
                     const MaterialChoices& choices) {
  Material material;
  material.format = file.format;
  material.series.equilibriumModulus = file.equilibriumModulus;
  material.series.arms = file.arms;
  material.notes = file.notes;
  material.series.terms = static_cast<int>(file.arms.size());
  const std::optional<double> chosen = chosenTemperature(choices);
  if (file.shift) {
    material.shift = *file.shift;
    if (chosen && *chosen != file.shift->referenceTemperature)
      throw InputError(
          name, "temperature",
          message("is {} K in the file's shift; leave {} out", file.shift->referenceTemperature,
                  Message::name(choices.columns.temperature ? "--temperature"
                                                            : "--reference-temperature")));
  } else {
    const std::optional<double> known = chosen ? chosen : file.temperature;
    if (!known)
      throw InputError(name, "temperature",
                       "is stated nowhere; say at which the series holds with --temperature, such "
                       "as --temperature 20C");
    material.shift = shiftAt(*known);
  }
  material.referenceTemperature = material.shift.referenceTemperature;
  return material;
}

void leaveOut(std::vector<Isotherm>& isotherms, const MaterialChoices& choices) {
  for (const double temperature : choices.leftOut) {
    const auto nearest = std::ranges::min_element(isotherms, {}, [&](const Isotherm& isotherm) {
      return std::abs(isotherm.temperature - temperature);
    });
    if (nearest == isotherms.end() || std::abs(nearest->temperature - temperature) > 1)
      throw InputError("", "--leave-out",
                       message("no isotherm is within 1 K of {}", celsius(temperature)));
    isotherms.erase(nearest);
  }
  if (isotherms.empty()) throw InputError("", "--leave-out", "leaves no isotherm");
}

MeasuredRange measuredRange(const Material& material) {
  MeasuredRange range;
  range.frequencyFrom = material.curve.lowestFrequency();
  range.frequencyTo = material.curve.highestFrequency();
  range.temperatureFrom = material.isotherms.front().temperature;
  range.temperatureTo = material.isotherms.back().temperature;
  if (std::isfinite(material.strainAmplitude)) range.strainAmplitude = material.strainAmplitude;
  return range;
}

TemperatureShift shiftOfKind(std::optional<ShiftKind> wanted, const Material& material,
                             const std::vector<ShiftPoint>& table) {
  if (table.size() == 1) return shiftAt(material.referenceTemperature);
  if (!wanted) return chosenShift(table, material.referenceTemperature);
  if (*wanted == ShiftKind::Table) return tableShift(table, material.referenceTemperature);
  const TemperatureFit& fit = *wanted == ShiftKind::Wlf ? material.wlf : material.arrhenius;
  if (!fit.isDefined)
    throw InputError("", "--shift",
                     message("{} needs more isotherms than {}", shiftName(*wanted), table.size()));
  return fit.shift;
}

/// Fits both formulas to a table of shifts and takes the shift that the user wants, or the good
/// one.
void fitShift(Material& material, const std::vector<ShiftPoint>& table,
              std::optional<ShiftKind> wanted) {
  material.wlf = fitWlf(table, material.referenceTemperature);
  material.arrhenius = fitArrhenius(table, material.referenceTemperature);
  material.shift = shiftOfKind(wanted, material, table);
}

/// Takes the shift that the file states beside a master curve.
void takeShift(Material& material, const TemperatureShift& stated,
               std::optional<ShiftKind> wanted) {
  if (stated.kind == ShiftKind::Table) {
    fitShift(material, stated.table, wanted);
    material.measured.temperatureFrom = stated.table.front().temperature;
    material.measured.temperatureTo = stated.table.back().temperature;
    return;
  }
  if (wanted && *wanted != stated.kind)
    throw InputError("", "--shift",
                     message("{} is not what the file states, the constants of {}",
                             shiftName(*wanted), shiftName(stated.kind)));
  material.shift = stated;
  // Within which temperatures the constants hold is not known.
  material.measured.temperatureFrom = material.measured.temperatureTo = 0;
}

/// Returns whether vertical shifts explain what neighbours differ by, and leave one horizontal
/// shift that serves both moduli.
bool isExplainedByVertical(const Material& material, const std::stop_token& stop) {
  if (material.isVertical || !material.curve.vertical.isSignificant) return false;
  try {
    return masterCurve(material.isotherms, material.referenceTemperature, true, stop)
        .isThermorheologicallySimple;
  } catch (const InputError&) {
    return false;
  }
}

/// Returns by how much (decades) a shift to a neighbour changes without a stray point, where that
/// is more than its error; else 0.
double changeWithout(const StrayPoint& stray, const Material& material) {
  constexpr double kVisible = 0.02;  // decades
  const std::vector<Isotherm>& isotherms = material.isotherms;
  const Isotherm rest =
      withoutStrays(isotherms[stray.isotherm], stray.isotherm, std::span(&stray, 1));
  double largest = 0;
  const auto compare = [&](std::size_t colder, const Isotherm& cold, const Isotherm& warm) {
    try {
      const Overlap without = neighbourShifts(cold, warm, material.isVertical).both;
      const double change =
          std::abs(without.log10Shift - material.curve.overlaps[colder].log10Shift);
      if (!std::isfinite(without.standardError)) return;
      if (change > std::max(kVisible, 2 * without.standardError))
        largest = std::max(largest, change);
    } catch (const InputError&) {
      // Too few points are left to compare.
    }
  };
  if (stray.isotherm > 0) compare(stray.isotherm - 1, isotherms[stray.isotherm - 1], rest);
  if (stray.isotherm + 1 < isotherms.size())
    compare(stray.isotherm, rest, isotherms[stray.isotherm + 1]);
  return largest;
}

std::vector<Message> describeStrays(const Material& material,
                                    const std::vector<StrayPoint>& strays) {
  constexpr std::size_t kMax = 3;
  std::vector<Message> lines;
  for (const StrayPoint& stray : strays) {
    if (lines.size() == kMax) {
      lines.push_back(
          message("more points leave the curve of their neighbours: {}", strays.size() - kMax));
      break;
    }
    const Message point = describe(stray, material.isotherms);
    const double change = changeWithout(stray, material);
    lines.push_back(change > 0
                        ? message("{}; without it a shift changes by {} decades: correct its row, "
                                  "or take it out",
                                  point, printed(change, 2))
                        : message("{}: correct its row, or take it out", point));
  }
  return lines;
}

/// Takes what the isotherms say about superposition without their stray points, of which nothing is
/// to be concluded.
void judgeWithout(const std::vector<StrayPoint>& strays, Material& material,
                  const std::stop_token& stop) {
  std::vector<Isotherm> rest;
  for (std::size_t i = 0; i < material.isotherms.size(); ++i)
    rest.push_back(withoutStrays(material.isotherms[i], i, strays));
  try {
    const MasterCurve curve =
        masterCurve(rest, material.referenceTemperature, material.isVertical, stop);
    material.curve.isThermorheologicallySimple = curve.isThermorheologicallySimple;
    material.curve.largestStep = curve.largestStep;
    material.curve.largestDifference = curve.largestDifference;
    material.curve.shapeMisfit = curve.shapeMisfit;
    material.curve.vertical = curve.vertical;
  } catch (const InputError&) {
    // Without them too little is left; what they say remains.
  }
}

}  // namespace

Material fitMaterial(std::vector<Isotherm> isotherms, const MaterialChoices& choices) {
  leaveOut(isotherms, choices);
  Material material;
  material.isVertical = choices.isVertical;
  material.poissonRatio = choices.columns.poissonRatio;
  material.isotherms = std::move(isotherms);
  const bool isChosen = std::isfinite(choices.referenceTemperature);
  material.referenceTemperature =
      isChosen ? choices.referenceTemperature : usualReference(material.isotherms);
  material.curve = masterCurve(material.isotherms, material.referenceTemperature,
                               choices.isVertical, choices.stop);
  const std::vector<StrayPoint> strays = strayPoints(material.isotherms);
  material.strays = describeStrays(material, strays);
  if (!strays.empty()) judgeWithout(strays, material, choices.stop);
  material.isExplainedByVertical = isExplainedByVertical(material, choices.stop);
  std::vector<DynamicModulus> points;
  for (const MasterPoint& point : material.curve.points) points.push_back(point.modulus);
  PronyOptions series = choices.series;
  series.stop = choices.stop;
  material.series = fitPronySeries(points, series);
  fitShift(material, shiftTable(material.curve), choices.shift);
  material.measured = measuredRange(material);
  return material;
}

Material makeMaterial(std::string_view bytes, const std::string& fileName,
                      const MaterialChoices& choices) {
  std::optional<InputError> failure;
  const std::optional<TextTable> table = readTable(bytes, fileName, failure);
  const auto series = readReadySeries(bytes, table ? &*table : nullptr, fileName, choices);
  Material material;
  if (series) {
    material = readySeries(*series, fileName, choices);
  } else {
    if (!table) throw *failure;
    DmaFile file = readDmaFile(*table, fileName, choices.columns);
    if (file.rows.size() > kMaxRows)
      throw InputError(fileName, "",
                       message("has {} rows; allowed is {}, more than an instrument needs",
                               file.rows.size(), kMaxRows));
    const double strain =
        chooseStrain(file.rows, choices.strainAmplitude, choices.temperatureTolerance, fileName);
    if (const std::size_t left = leaveOutRamps(file.rows, choices.temperatureTolerance); left > 0)
      file.facts.notes.push_back(message(
          "ramps of temperature at one frequency, beside the sweeps: {} rows are not used", left));
    try {
      material =
          fitMaterial(groupIsotherms(std::move(file.rows), choices.temperatureTolerance), choices);
    } catch (const InputError& error) {
      throw error.isOfOption() ? error : error.in(fileName);
    }
    material.facts = file.facts;
    std::ranges::move(describeDrift(material.isotherms), std::back_inserter(material.facts.notes));
    material.strainAmplitude = strain;
    material.measured = measuredRange(material);
    if (file.shift && material.isotherms.size() == 1)
      takeShift(material, *file.shift, choices.shift);
  }
  material.fileName = std::filesystem::path(fileName).filename().string();
  material.fileDigest = sha256(bytes);
  material.name =
      choices.name.empty() ? std::filesystem::path(fileName).stem().string() : choices.name;
  material.source = choices.source;
  material.options = choices.options;
  return material;
}

}  // namespace asperity
