#include "core/material/material_json.h"

#include <nlohmann/json.hpp>

#include "core/base/json_text.h"
#include "core/material/material_library.h"

namespace asperity {
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
