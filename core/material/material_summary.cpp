#include "core/material/material_summary.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/json_text.h"
#include "core/base/number_text.h"
#include "core/material/material_library.h"

namespace asperity {
namespace {

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
  lines.emplace_back(
      "a table of temperatures and log aT below the numbers in the file, or a line with C1 and C2 "
      "above them, would be read as the shift");
}

/// Adds what is known of a series that was read as it is.
void addSeries(const Material& material, std::vector<Message>& lines) {
  const PronySeries& series = material.series;
  lines.push_back(
      message("{}: {}, G\u221E = {}, at {}", material.format, describeArms(series.arms.size()),
              printed(series.equilibriumModulus, "Pa"), celsius(material.referenceTemperature)));
  lines.push_back(
      "which frequencies were measured is not known: friction on it is not marked as "
      "extrapolated");
  lines.insert(lines.end(), material.notes.begin(), material.notes.end());
}

/// Adds by how much rows at one temperature and frequency differ.
void addRepeats(const std::vector<Isotherm>& isotherms, std::vector<Message>& lines) {
  std::size_t repeats = 0;
  double ratio = 1;
  for (const Isotherm& isotherm : isotherms) {
    repeats += isotherm.repeats;
    ratio = std::max(ratio, isotherm.repeatRatio);
  }
  constexpr double kSame = 1.001;
  if (repeats > 0 && ratio > kSame)
    lines.push_back(
        message("repeated at the same temperature and frequency: {} rows, averaged; "
                "moduli that became one differ by a factor of up to {}",
                repeats, printed(ratio, 3)));
}

/// Adds what was measured, and what of it was read.
void addMeasurement(const Material& material, std::vector<Message>& lines) {
  const MasterCurve& curve = material.curve;
  const Isotherm &coldest = material.isotherms.front(), &warmest = material.isotherms.back();
  lines.push_back(
      curve.shifts.size() == 1
          ? message("measured: one isotherm at {}, {} to {}", celsius(coldest.temperature),
                    printed(curve.lowestFrequency(), "Hz"), printed(curve.highestFrequency(), "Hz"))
          : message("measured: {} isotherms from {} to {}; at {} they cover {} to {}",
                    curve.shifts.size(), celsius(coldest.temperature), celsius(warmest.temperature),
                    celsius(curve.referenceTemperature), printed(curve.lowestFrequency(), "Hz"),
                    printed(curve.highestFrequency(), "Hz")));
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
  addRepeats(material.isotherms, lines);
  if (material.facts.modulus == ModulusKind::Tension)
    lines.push_back(dividedForShear(material.poissonRatio));
}

/// Adds the residuals of the master curve, of the series and of the formulas of the shift.
void addResiduals(const Material& material, std::vector<Message>& lines) {
  const PronySeries& series = material.series;
  const MasterCurve& curve = material.curve;
  if (!curve.overlaps.empty()) {
    const auto [best, worst] = std::ranges::minmax(curve.overlaps, {}, &Overlap::mismatch);
    lines.push_back(message("overlaps: neighbours agree within {} to {} decades (rms)",
                            printed(best.mismatch, 2), printed(worst.mismatch, 2)));
  }
  if (curve.isFittedTogether)
    lines.push_back(
        "shifts: all isotherms are fitted together by smooth moduli, because the sums of the "
        "shifts "
        "of neighbours differ from it by more than their errors");
  lines.push_back(message(
      "Prony series: {} from {} relaxation times, G\u221E = {}; "
      "rms residual {} % of G\u2032, {} % of G\u2033",
      describeArms(series.arms.size()), series.terms, printed(series.equilibriumModulus, "Pa"),
      printedPercent(series.rmsStorage, 2), printedPercent(series.rmsLoss, 2)));
  constexpr double kPoor = 0.15;  // rms, more than the scatter of measurements
  if (std::max(series.rmsStorage, series.rmsLoss) > kPoor)
    lines.push_back(
        "the series does not follow the moduli: no relaxation has such a storage modulus together "
        "with such a loss modulus (Kramers and Kronig); check the columns, their units and the "
        "shifts");
  // A rubber that still relaxes at the lowest frequency has an equilibrium modulus by
  // extrapolation.
  constexpr double kReached = 1.4;
  const double lowest = curve.lowestFrequency();
  const double slowest = modulusAt(series, lowest).storage;
  if (series.equilibriumModulus > 0 && slowest > kReached * series.equilibriumModulus)
    lines.push_back(
        message("equilibrium was not measured: at the lowest frequency, {}, the storage modulus is "
                "{} times G\u221E",
                printed(lowest, "Hz"), printed(slowest / series.equilibriumModulus, 2)));
  if (material.wlf.isDefined)
    lines.push_back(message("Williams, Landel and Ferry: C1 = {}, C2 = {} K, {} decades rms",
                            printed(material.wlf.shift.c1), printed(material.wlf.shift.c2),
                            printed(material.wlf.rms, 2)));
  if (material.arrhenius.isDefined)
    lines.push_back(message("Arrhenius: {}, {} decades rms",
                            printed(material.arrhenius.shift.activationEnergy, "J/mol"),
                            printed(material.arrhenius.rms, 2)));
  addOneTemperature(material, lines);
  if (curve.shifts.size() > 1 || material.wlf.isDefined)
    lines.push_back(material.shift.kind == ShiftKind::Table
                        ? Message("the shift used is the table of measured shifts")
                    : material.shift.kind == ShiftKind::Wlf
                        ? Message("the shift is that of Williams, Landel and Ferry")
                        : Message("the shift is that of Arrhenius"));
}

/// Adds what the overlaps tell of vertical shifts and of thermorheological simplicity.
void addSimplicity(const Material& material, std::vector<Message>& lines) {
  const MasterCurve& curve = material.curve;
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
  const auto ofModulus = [](double decades) {
    return printedPercent(std::pow(10, decades) - 1, 2);
  };
  const VerticalEvidence& vertical = curve.vertical;
  if (material.isExplainedByVertical)
    lines.push_back(
        message("vertical shifts of up to {} % between neighbours, as of an entropic spring or an "
                "uncertain size of the sample, lower what neighbours differ by from {} to {} % "
                "(rms); without them "
                "shifts are uncertain by up to {} decades: --vertical-shifts",
                ofModulus(vertical.largestShift), ofModulus(vertical.residual),
                ofModulus(vertical.residualWith), printed(vertical.largestChange, 2)));
  else if (!curve.isThermorheologicallySimple && curve.largestStep > 0)
    lines.push_back(
        message("not thermorheologically simple: shifts from G\u2032 alone and from G\u2033 alone "
                "differ by up to {} decades between neighbours, {} in all; predictions at other "
                "temperatures are approximate",
                printed(curve.largestStep, 2), printed(curve.largestDifference, 2)));
  else if (!curve.isThermorheologicallySimple)
    lines.push_back(message(
        "not thermorheologically simple: beyond their noise, neighbours differ by {} % (rms) where "
        "they overlap, which no shift explains; predictions at other temperatures are approximate",
        ofModulus(curve.shapeMisfit)));
}

}  // namespace

Message describeArms(std::size_t count) {
  return count == 1 ? Message("one arm") : message("{} arms", count);
}

std::vector<Message> materialSummary(const Material& material) {
  std::vector<Message> lines;
  if (!material.isMeasured()) {
    addSeries(material, lines);
    addOneTemperature(material, lines);
    return lines;
  }
  addMeasurement(material, lines);
  addResiduals(material, lines);
  lines.insert(lines.end(), material.strays.begin(), material.strays.end());
  addSimplicity(material, lines);
  return lines;
}

namespace {

using Json = nlohmann::ordered_json;

Json shiftJson(const TemperatureShift& shift) {
  Json json{{"kind", shiftName(shift.kind)}};
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
          {"facts", englishOf(facts.sweeps > 0 ? factsOf(facts) : std::vector<Message>())},
          {"thermorheologically_simple", material.curve.isThermorheologicallySimple},
          {"shifts", std::move(shifts)}};
}

}  // namespace

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
    return jsonFile(root);
  }
  root["measurement"] = measurementJson(material);
  root["fit"] = {{"reference_temperature", material.referenceTemperature},
                 {"terms", material.series.terms},
                 {"rms_storage", material.series.rmsStorage},
                 {"rms_loss", material.series.rmsLoss},
                 {"wlf", fitJson(material.wlf)},
                 {"arrhenius", fitJson(material.arrhenius)}};
  return jsonFile(root);
}

}  // namespace asperity
