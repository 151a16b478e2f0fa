#include "core/material/material_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/base/file_digest.h"
#include "core/base/input_error.h"
#include "core/base/json_text.h"
#include "core/base/number_text.h"
#include "core/base/text_encoding.h"
#include "core/material/material_library.h"
#include "core/material/stray_points.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostRows = 20000;  // of measurements; the fit takes a few seconds then
constexpr std::size_t kLargestSeries = std::size_t{4} << 20;  // bytes of a file with a ready series
constexpr const char* kShiftNames[]{"wlf", "arrhenius", "table"};

/// Reads a table; returns nothing, and the error, where the file is none, because it may still be a
/// ready Prony series of a finite-element program.
std::optional<TextTable> readTable(std::string_view bytes, const std::string& name,
                                   std::optional<InputError>& failure) {
  try {
    TextTableOptions options;
    options.keepsTexts = true;
    return readTextTable(bytes, name, options);
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

TemperatureShift chosenShift(const Material& material, const std::vector<ShiftPoint>& table,
                             std::optional<ShiftKind> wanted) {
  if (table.size() == 1) return shiftAt(material.referenceTemperature);
  if (!wanted) return chosenShift(table, material.referenceTemperature);
  if (*wanted == ShiftKind::Table) return tableShift(table, material.referenceTemperature);
  const TemperatureFit& fit = *wanted == ShiftKind::Wlf ? material.wlf : material.arrhenius;
  if (!fit.isDefined)
    throw InputError("", "--shift",
                     message("{} needs more isotherms than {}",
                             kShiftNames[static_cast<int>(*wanted)], table.size()));
  return fit.shift;
}

Json shiftJson(const TemperatureShift& shift) {
  Json json{{"kind", kShiftNames[static_cast<int>(shift.kind)]}};
  switch (shift.kind) {
    case ShiftKind::Wlf:
      json["c1"] = shift.c1;
      json["c2"] = shift.c2;
      json["reference_temperature"] = shift.referenceTemperature;
      break;
    case ShiftKind::Arrhenius:
      json["reference_temperature"] = shift.referenceTemperature;
      json["activation_energy"] = shift.activationEnergy;
      break;
    case ShiftKind::Table:
      json["table"] = Json::array();
      for (const ShiftPoint& row : shift.table)
        json["table"].push_back(
            {{"temperature", row.temperature}, {"log10_shift", row.log10Shift}});
  }
  return json;
}

Json fitJson(const TemperatureFit& fit) {
  if (!fit.isDefined) return nullptr;
  Json json = shiftJson(fit.shift);
  json["rms_decades"] = fit.rms;
  return json;
}

Json englishOf(const std::vector<Message>& lines) {
  Json list = Json::array();
  for (const Message& line : lines) list.push_back(line.english());
  return list;
}

Json measurementJson(const Material& material) {
  const DmaFacts& facts = material.facts;
  Json temperatures = Json::array(), shifts = Json::array();
  std::size_t points = 0;
  for (const Isotherm& isotherm : material.isotherms) {
    temperatures.push_back(isotherm.temperature);
    points += isotherm.points.size();
  }
  for (std::size_t i = 0; i < material.curve.shifts.size(); ++i) {
    const IsothermShift& shift = material.curve.shifts[i];
    Json row{{"temperature", shift.temperature},
             {"log10_shift", shift.log10Shift},
             {"standard_error", numberOrNull(shift.standardError)},
             {"log10_vertical_shift", shift.log10Vertical},
             {"log10_shift_from_storage", numberOrNull(shift.fromStorage)},
             {"log10_shift_from_loss", numberOrNull(shift.fromLoss)}};
    if (i < material.curve.overlaps.size()) {
      row["overlap_mismatch_decades"] = material.curve.overlaps[i].mismatch;
      row["overlap_decades"] = material.curve.overlaps[i].decades;
    }
    shifts.push_back(std::move(row));
  }
  return {{"points", points},
          {"temperatures", std::move(temperatures)},
          {"modulus", facts.modulus == ModulusKind::Tension ? "tension" : "shear"},
          {"poisson_ratio",
           facts.modulus == ModulusKind::Tension ? Json(material.poissonRatio) : Json(nullptr)},
          {"vertical_shifts", material.isVertical},
          {"facts", facts.sweeps > 0 ? englishOf(factsOf(facts)) : Json::array()},
          {"thermorheologically_simple", material.curve.isThermorheologicallySimple},
          {"shifts", std::move(shifts)}};
}

/// Such a material fixes the temperature of the scene.
void addOneTemperature(const Material& material, std::vector<Message>& lines) {
  if (material.shift.kind != ShiftKind::Table || material.shift.table.size() > 1) return;
  const double kelvin = material.shift.table.front().temperature;
  constexpr int kDigits = 15;  // -20 degrees are 253.15 K, not 253.14999999999998
  if (kelvin == Elastomer{}.temperature)
    lines.push_back("one temperature alone: there is no shift");
  else
    lines.push_back(
        message("one temperature alone: there is no shift, and scenes need "
                "elastomer.temperature={}",
                plain(roundedToDigits(kelvin, kDigits))));
}

/// Fits both formulas to a table of shifts and takes the shift that the user wants, or the good
/// one.
void fitShift(Material& material, const std::vector<ShiftPoint>& table,
              std::optional<ShiftKind> wanted) {
  material.wlf = fitWlf(table, material.referenceTemperature);
  material.arrhenius = fitArrhenius(table, material.referenceTemperature);
  material.shift = chosenShift(material, table, wanted);
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
                             kShiftNames[static_cast<int>(*wanted)],
                             kShiftNames[static_cast<int>(stated.kind)]));
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
  constexpr std::size_t kMost = 3;
  std::vector<Message> lines;
  for (const StrayPoint& stray : strays) {
    if (lines.size() == kMost) {
      lines.push_back(
          message("more points leave the curve of their neighbours: {}", strays.size() - kMost));
      break;
    }
    const Message point = describe(stray, material.isotherms);
    const double change = changeWithout(stray, material);
    lines.push_back(change > 0
                        ? message("{}; without it a shift changes by {} decades: correct its row, "
                                  "or take it out",
                                  point, PrintedNumber{printedNumber(change, 2)})
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

Message describeArms(std::size_t count) {
  return count == 1 ? Message("one arm") : message("{} arms", count);
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
    if (file.rows.size() > kMostRows)
      throw InputError(fileName, "",
                       message("has {} rows; allowed is {}, more than an instrument needs",
                               file.rows.size(), kMostRows));
    const double strain =
        chooseStrain(file.rows, choices.strainAmplitude, choices.temperatureTolerance, fileName);
    try {
      material =
          fitMaterial(groupIsotherms(std::move(file.rows), choices.temperatureTolerance), choices);
    } catch (const InputError& error) {
      throw error.isOfOption() ? error : error.in(fileName);
    }
    material.facts = file.facts;
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

Json materialOrigin(const Material& material) {
  Json options = Json::object();
  for (const auto& [option, value] : material.options) {
    Json& stated = options[option];
    // A repeated option has a list.
    if (stated.is_string()) stated = Json::array({stated});
    if (stated.is_array())
      stated.push_back(value);
    else
      stated = value;
  }
  return {{"schema", kMaterialSchema},
          {"verb", "material"},
          {"version", ASPERITY_VERSION},
          {"origin",
           {{"file", material.fileName}, {"sha256", material.fileDigest}, {"options", options}}}};
}

std::string materialJson(const Material& material) {
  const MeasuredRange& range = material.measured;
  Json root = materialOrigin(material);
  root["name"] = material.name;
  root["source"] = material.source;
  root["equilibrium_modulus"] = material.series.equilibriumModulus;
  root["viscosity"] = material.viscosity;
  root["arms"] = Json::array();
  for (const Arm& arm : material.series.arms)
    root["arms"].push_back({{"modulus", arm.modulus}, {"relaxation_time", arm.relaxationTime}});
  root["shift"] = shiftJson(material.shift);
  root["measured"] = {{"frequency_from", range.frequencyFrom},
                      {"frequency_to", range.frequencyTo},
                      {"temperature_from", range.temperatureFrom},
                      {"temperature_to", range.temperatureTo},
                      {"strain_amplitude", range.strainAmplitude}};
  if (!material.isMeasured()) {
    root["fit"] = {{"reference_temperature", material.referenceTemperature},
                   {"format", material.format.english()},
                   {"facts", englishOf(material.notes)}};
    return root.dump(2) + "\n";
  }
  root["measurement"] = measurementJson(material);
  root["fit"] = {{"reference_temperature", material.referenceTemperature},
                 {"terms", material.series.terms},
                 {"rms_storage", material.series.rmsStorage},
                 {"rms_loss", material.series.rmsLoss},
                 {"wlf", fitJson(material.wlf)},
                 {"arrhenius", fitJson(material.arrhenius)}};
  return root.dump(2) + "\n";
}

std::vector<Message> materialSummary(const Material& material) {
  const auto quantity = [](double value, const char* unit) {
    return PrintedNumber{printedQuantity(value, unit)};
  };
  const auto percent = [](double part) { return PrintedNumber{printedNumber(100 * part, 2)}; };
  const PronySeries& series = material.series;
  std::vector<Message> lines;
  if (!material.isMeasured()) {
    lines.push_back(
        message("{}: {}, G\u221E = {}, at {}", material.format, describeArms(series.arms.size()),
                quantity(series.equilibriumModulus, "Pa"), celsius(material.referenceTemperature)));
    lines.push_back(
        "which frequencies were measured is not known: friction on it is not marked as "
        "extrapolated");
    lines.insert(lines.end(), material.notes.begin(), material.notes.end());
    addOneTemperature(material, lines);
    return lines;
  }
  const MasterCurve& curve = material.curve;
  const Isotherm &coldest = material.isotherms.front(), &warmest = material.isotherms.back();
  lines.push_back(
      curve.shifts.size() == 1
          ? message("measured: one isotherm at {}, {} to {}", celsius(coldest.temperature),
                    quantity(curve.lowestFrequency(), "Hz"),
                    quantity(curve.highestFrequency(), "Hz"))
          : message("measured: {} isotherms from {} to {}; at {} they cover {} to {}",
                    curve.shifts.size(), celsius(coldest.temperature), celsius(warmest.temperature),
                    celsius(curve.referenceTemperature), quantity(curve.lowestFrequency(), "Hz"),
                    quantity(curve.highestFrequency(), "Hz")));
  if (material.facts.sweeps > 0) {
    const std::vector<Message> facts = factsOf(material.facts);
    lines.insert(lines.end(), facts.begin(), facts.end());
  }
  if (material.facts.leftOut > 0)
    lines.push_back(message("rows without a value, left out: {}", material.facts.leftOut));
  if (!material.facts.leftOutColumns.empty())
    lines.push_back(message("columns of deviations and set values, not read: {}",
                            Message::name(material.facts.leftOutColumns)));
  if (material.facts.isMarkUnclear) lines.push_back(unclearMark(material.facts.decimal));
  std::size_t repeats = 0;
  double ratio = 1;
  for (const Isotherm& isotherm : material.isotherms) {
    repeats += isotherm.repeats;
    ratio = std::max(ratio, isotherm.repeatRatio);
  }
  constexpr double kSame = 1.001;
  if (repeats > 0 && ratio > kSame)
    lines.push_back(
        message("repeated at the same temperature and frequency: {} rows, averaged; "
                "moduli that became one differ by a factor of up to {}",
                repeats, PrintedNumber{printedNumber(ratio, 3)}));
  if (material.facts.modulus == ModulusKind::Tension)
    lines.push_back(dividedForShear(material.poissonRatio));
  if (!curve.overlaps.empty()) {
    const auto [best, worst] = std::ranges::minmax(curve.overlaps, {}, &Overlap::mismatch);
    lines.push_back(message("overlaps: neighbours agree within {} to {} decades (rms)",
                            PrintedNumber{printedNumber(best.mismatch, 2)},
                            PrintedNumber{printedNumber(worst.mismatch, 2)}));
  }
  lines.push_back(message(
      "Prony series: {} from {} relaxation times, G\u221E = {}; "
      "rms residual {} % of G', {} % of G''",
      describeArms(series.arms.size()), series.terms, quantity(series.equilibriumModulus, "Pa"),
      percent(series.rmsStorage), percent(series.rmsLoss)));
  if (material.wlf.isDefined)
    lines.push_back(message("Williams, Landel and Ferry: C1 = {}, C2 = {} K, {} decades rms",
                            PrintedNumber{printedNumber(material.wlf.shift.c1)},
                            PrintedNumber{printedNumber(material.wlf.shift.c2)},
                            PrintedNumber{printedNumber(material.wlf.rms, 2)}));
  if (material.arrhenius.isDefined)
    lines.push_back(message("Arrhenius: {}, {} decades rms",
                            quantity(material.arrhenius.shift.activationEnergy, "J/mol"),
                            PrintedNumber{printedNumber(material.arrhenius.rms, 2)}));
  addOneTemperature(material, lines);
  if (curve.shifts.size() > 1 || material.wlf.isDefined)
    lines.push_back(material.shift.kind == ShiftKind::Table
                        ? Message("the shift used is the table of measured shifts")
                    : material.shift.kind == ShiftKind::Wlf
                        ? Message("the shift is that of Williams, Landel and Ferry")
                        : Message("the shift is that of Arrhenius"));
  lines.insert(lines.end(), material.strays.begin(), material.strays.end());
  const auto decades = [](double value) { return PrintedNumber{printedNumber(value, 2)}; };
  const auto ofModulus = [&](double value) { return percent(std::pow(10, value) - 1); };
  const auto open =
      static_cast<std::size_t>(std::ranges::count_if(curve.overlaps, &Overlap::isVerticalOpen));
  if (material.isVertical && open > 0)
    lines.push_back(message(
        "in {} of {} overlaps the moduli do not tell a vertical shift from a horizontal one, as "
        "power laws of one exponent do not: there the law of entropy elasticity, b_T ~ T, decides",
        open, curve.overlaps.size()));
  else if (2 * open > curve.overlaps.size())
    lines.push_back(message(
        "in {} of {} overlaps the moduli do not tell a vertical shift from a horizontal one, as "
        "power laws of one exponent do not: there the shifts hold for b_T = 1",
        open, curve.overlaps.size()));
  const VerticalEvidence& vertical = curve.vertical;
  if (material.isExplainedByVertical)
    lines.push_back(message(
        "vertical shifts of up to {} % between neighbours, as of an entropic spring or an "
        "uncertain "
        "size of the sample, lower what neighbours differ by from {} to {} % (rms); without them "
        "shifts are uncertain by up to {} decades: --vertical-shifts",
        ofModulus(vertical.largestShift), ofModulus(vertical.residual),
        ofModulus(vertical.residualWith), decades(vertical.largestChange)));
  else if (!curve.isThermorheologicallySimple && curve.largestStep > 0)
    lines.push_back(message(
        "not thermorheologically simple: shifts from G' alone and from G'' alone differ by up to "
        "{} decades between neighbours, {} in all; predictions at other temperatures are "
        "approximate",
        decades(curve.largestStep), decades(curve.largestDifference)));
  else if (!curve.isThermorheologicallySimple)
    lines.push_back(message(
        "not thermorheologically simple: beyond their noise, neighbours differ by {} % (rms) where "
        "they overlap, which no shift explains; predictions at other temperatures are approximate",
        ofModulus(curve.shapeMisfit)));
  return lines;
}

}  // namespace asperity
