#include "core/chart/material_sheets.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

#include "core/base/input_error.h"
#include "core/base/json_text.h"
#include "core/base/number_text.h"
#include "core/base/units.h"
#include "core/material/material_summary.h"
#include "core/material/temperature_shift.h"
#include "core/scene/columns.h"
#include "core/scene/data_table.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kPointsPerDecade = 24;  // of fitted curves

/// Returns frequencies that are evenly spaced in their logarithm, both ends included.
std::vector<double> frequencies(double from, double to) {
  const int count = std::max(2, static_cast<int>(kPointsPerDecade * std::log10(to / from)) + 2);
  std::vector<double> values;
  for (int i = 0; i < count; ++i)
    values.push_back(from * std::pow(to / from, double(i) / (count - 1)));
  return values;
}

DiagramAxis frequencyAxis(Message title) {
  return {std::move(title), "Hz"};
}

Message at(double temperature) {
  return message("at {}", celsius(temperature));
}

/// Returns the position of an isotherm on the ramp: 0 for the coldest, 1 for the warmest.
double rampPosition(const Material& material, std::size_t isotherm) {
  const double from = material.isotherms.front().temperature;
  const double to = material.isotherms.back().temperature;
  return to > from ? (material.isotherms[isotherm].temperature - from) / (to - from) : 0.5;
}

std::optional<DiagramRamp> temperatureRamp(const Material& material) {
  if (material.isotherms.size() < 2) return {};
  return DiagramRamp{"temperature", celsius(material.isotherms.front().temperature),
                     celsius(material.isotherms.back().temperature)};
}

using Reading = double (*)(const DynamicModulus&);
double readStorage(const DynamicModulus& modulus) {
  return modulus.storage;
}
double readLoss(const DynamicModulus& modulus) {
  return modulus.loss;
}
double readTangent(const DynamicModulus& modulus) {
  return modulus.loss / modulus.storage;
}

/// Returns the measured values: a line with marks for each temperature.
Diagram isothermDiagram(const Material& material, Message title, const char* unit,
                        Reading reading) {
  Diagram diagram{.x = frequencyAxis("frequency f"), .y = {std::move(title), unit}};
  for (std::size_t i = 0; i < material.isotherms.size(); ++i) {
    DiagramSeries series{.mark = SeriesMark::Circle, .ramp = rampPosition(material, i)};
    for (const DynamicModulus& point : material.isotherms[i].points)
      series.points.push_back({point.frequency, reading(point)});
    diagram.series.push_back(std::move(series));
  }
  diagram.ramp = temperatureRamp(material);
  return diagram;
}

/// Adds the points of the master curve in the colours of their temperatures.
void addMasterPoints(const Material& material, Diagram& diagram, Reading reading, SeriesMark mark) {
  std::vector<DiagramSeries> series(material.isotherms.size());
  for (std::size_t i = 0; i < series.size(); ++i) {
    series[i].mark = mark;
    series[i].stroke = SeriesStroke::None;
    series[i].ramp = rampPosition(material, i);
  }
  for (const MasterPoint& point : material.curve.points)
    series[point.isotherm].points.push_back({point.modulus.frequency, reading(point.modulus)});
  for (DiagramSeries& one : series) diagram.series.push_back(std::move(one));
}

DiagramSeries fittedSeries(const Material& material, double from, double to, Reading reading,
                           Message name, SeriesStroke stroke) {
  DiagramSeries series{.name = std::move(name), .stroke = stroke, .isTheory = true};
  for (const double frequency : frequencies(from, to))
    series.points.push_back({frequency, reading(modulusAt(material.series, frequency))});
  return series;
}

/// Returns the range of the fit: the measured range, or that of the relaxation times.
FrequencyRange fittedRange(const Material& material) {
  if (material.isMeasured())
    return {material.curve.lowestFrequency(), material.curve.highestFrequency()};
  FrequencyRange range{0.01, 1e4};
  if (!material.series.arms.empty()) {
    range.from = 0.1 / (2 * std::numbers::pi * material.series.arms.front().relaxationTime);
    range.to = 10 / (2 * std::numbers::pi * material.series.arms.back().relaxationTime);
  }
  return range;
}

Message reducedFrequency(const Material& material) {
  if (material.isotherms.size() < 2)
    return message("frequency f {}", at(material.referenceTemperature));
  return message("reduced frequency f a\u1D1B {}", at(material.referenceTemperature));
}

NamedSheet isothermsSheet(const Material& material) {
  DiagramSheet sheet{
      .title = message("{}: isotherms", material.name),
      .subtitle = material.source.empty() ? Message() : Message::name(material.source),
      .diagrams = {isothermDiagram(material, "storage modulus G\u2032", "Pa", readStorage),
                   isothermDiagram(material, "loss modulus G\u2033", "Pa", readLoss)}};
  return {"isotherms", std::move(sheet)};
}

Diagram masterDiagram(const Material& material) {
  const FrequencyRange range = fittedRange(material);
  Diagram diagram{.x = frequencyAxis(reducedFrequency(material)),
                  .y = {"modulus G\u2032, G\u2033", "Pa"},
                  .height = 2};
  addMasterPoints(material, diagram, readStorage, SeriesMark::Circle);
  addMasterPoints(material, diagram, readLoss, SeriesMark::Triangle);
  const bool isMeasured = !material.curve.points.empty();  // a ready Prony series is not
  const auto addFit = [&](Reading reading, const char* modulus, const char* measured,
                          SeriesStroke stroke) {
    diagram.series.push_back(fittedSeries(material, range.from, range.to, reading,
                                          isMeasured ? measured : modulus, stroke));
  };
  addFit(readStorage, "G\u2032", "G\u2032 (\u25CF measured)", SeriesStroke::Solid);
  addFit(readLoss, "G\u2033", "G\u2033 (\u25B2 measured)", SeriesStroke::Dashed);
  diagram.ramp = temperatureRamp(material);
  return diagram;
}

Diagram residualDiagram(const Material& material, const DiagramAxis& along) {
  Diagram diagram{.x = along, .y = {"residual", "%", AxisScale::Linear}};
  double largest = 0;
  for (const bool isLoss : {false, true}) {
    DiagramSeries series{.name = isLoss ? "G\u2033" : "G\u2032",
                         .mark = isLoss ? SeriesMark::Triangle : SeriesMark::Circle,
                         .stroke = SeriesStroke::None};
    for (const MasterPoint& point : material.curve.points) {
      const DynamicModulus fitted = modulusAt(material.series, point.modulus.frequency);
      const double part =
          isLoss ? fitted.loss / point.modulus.loss : fitted.storage / point.modulus.storage;
      series.points.push_back({point.modulus.frequency, 100 * (part - 1)});
      largest = std::max(largest, std::abs(series.points.back().y));
    }
    diagram.series.push_back(std::move(series));
  }
  if (std::isfinite(largest) && largest > 0) {
    constexpr double kAir = 1.15;  // so that no mark is cut by the frame
    diagram.y.from = -kAir * largest;
    diagram.y.to = kAir * largest;
  }
  DiagramSeries zero{
      .isTheory = true,
      .points = {{material.curve.lowestFrequency(), 0}, {material.curve.highestFrequency(), 0}}};
  diagram.series.push_back(std::move(zero));
  return diagram;
}

NamedSheet masterSheet(const Material& material) {
  DiagramSheet sheet{.title = message("{}: master curve", material.name),
                     .diagrams = {masterDiagram(material)},
                     .columns = 1};
  if (material.isMeasured()) {
    const FrequencyRange range = fittedRange(material);
    sheet.subtitle = message("{}, G\u221E = {}, rms residual {} % of G\u2032 and {} % of G\u2033",
                             describeArms(material.series.arms.size()),
                             printed(material.series.equilibriumModulus, "Pa"),
                             printedPercent(material.series.rmsStorage, 2),
                             printedPercent(material.series.rmsLoss, 2));
    Diagram& master = sheet.diagrams.front();
    master.x.from = range.from / 1.5;
    master.x.to = range.to * 1.5;
    sheet.diagrams.push_back(residualDiagram(material, master.x));
    sheet.sharesAxis = true;
    if (!material.curve.isThermorheologicallySimple)
      sheet.note =
          "Not thermorheologically simple: shifts of the frequency alone do not bring the points "
          "of "
          "all temperatures onto one curve.";
  }
  return {"master_curve", std::move(sheet)};
}

/// Returns a linear scale for less than a decade, over which a logarithmic axis has hardly any
/// numbers.
AxisScale suitableScale(const Diagram& diagram) {
  double smallest = std::numeric_limits<double>::infinity(), largest = 0;
  for (const DiagramSeries& series : diagram.series)
    for (const DiagramPoint& point : series.points) {
      smallest = std::min(smallest, point.y);
      largest = std::max(largest, point.y);
    }
  return largest < 10 * smallest ? AxisScale::Linear : AxisScale::Logarithmic;
}

NamedSheet tangentSheet(const Material& material) {
  const FrequencyRange range = fittedRange(material);
  DiagramSheet sheet;
  sheet.title = message("{}: loss tangent", material.name);
  Diagram diagram{.x = frequencyAxis(reducedFrequency(material)),
                  .y = {"loss tangent tan \u03B4", ""}};
  addMasterPoints(material, diagram, readTangent, SeriesMark::Circle);
  diagram.series.push_back(fittedSeries(material, range.from, range.to, readTangent, "Prony series",
                                        SeriesStroke::Solid));
  diagram.y.scale = suitableScale(diagram);
  diagram.ramp = temperatureRamp(material);
  sheet.diagrams = {std::move(diagram)};
  return {"loss_tangent", std::move(sheet)};
}

/// Returns a formula over the temperatures of the table.
DiagramSeries formulaSeries(const Material& material, const TemperatureFit& fit, Message name,
                            SeriesStroke stroke) {
  constexpr int kPoints = 100;
  DiagramSeries series{.name = std::move(name), .stroke = stroke, .isTheory = true};
  const double from = material.isotherms.front().temperature;
  const double to = material.isotherms.back().temperature;
  for (int i = 0; i <= kPoints; ++i) {
    const double temperature = from + (to - from) * i / kPoints;
    try {
      series.points.push_back(
          {temperature - kZeroCelsius, log10ShiftFactor(fit.shift, temperature)});
    } catch (const InputError&) {
      continue;  // the formula has no value there
    }
  }
  return series;
}

NamedSheet shiftsSheet(const Material& material) {
  DiagramSheet sheet;
  sheet.title = message("{}: shifts with temperature", material.name);
  Diagram diagram{.x = {"temperature T", "\u00B0C", AxisScale::Linear},
                  .y = {"shift log\u2081\u2080 a\u1D1B", "", AxisScale::Linear}};
  DiagramSeries both{.name = "from both moduli", .mark = SeriesMark::Circle};
  DiagramSeries storage{
      .name = "from G\u2032 alone", .mark = SeriesMark::Square, .stroke = SeriesStroke::Dotted};
  DiagramSeries loss{
      .name = "from G\u2033 alone", .mark = SeriesMark::Triangle, .stroke = SeriesStroke::Dotted};
  for (const IsothermShift& shift : material.curve.shifts) {
    const double temperature = shift.temperature - kZeroCelsius;
    const bool hasError = std::isfinite(shift.standardError) && shift.standardError > 0;
    both.points.push_back(pointWithError(temperature, shift.log10Shift,
                                         hasError ? shift.standardError : kNotApplicable));
    storage.points.push_back({temperature, shift.fromStorage});
    loss.points.push_back({temperature, shift.fromLoss});
  }
  diagram.series = {std::move(storage), std::move(loss), std::move(both)};
  if (material.wlf.isDefined)
    diagram.series.push_back(formulaSeries(
        material, material.wlf, message("WLF, {} decades rms", printed(material.wlf.rms, 2)),
        SeriesStroke::Solid));
  if (material.arrhenius.isDefined)
    diagram.series.push_back(
        formulaSeries(material, material.arrhenius,
                      message("Arrhenius, {} decades rms", printed(material.arrhenius.rms, 2)),
                      SeriesStroke::Dashed));
  sheet.diagrams = {std::move(diagram)};
  return {"shifts", std::move(sheet)};
}

// ---- In a scene --------------------------------------------------------------------------------

/// Returns the range of a diagram over frequency: the band and the measured range, with a margin.
FrequencyRange shownRange(const std::optional<FrequencyRange>& measured,
                          const std::optional<ExcitedBand>& band, const ElementLaw& law) {
  FrequencyRange range{1, 1};
  if (band) range = {band->from, band->to};
  if (measured) {
    range.from = band ? std::min(range.from, measured->from) : measured->from;
    range.to = band ? std::max(range.to, measured->to) : measured->to;
  }
  if (!band && !measured && !law.arms.empty())
    range = {1 / law.arms.front().relaxationTime, 1 / law.arms.back().relaxationTime};
  return {range.from / 10, range.to * 10};
}

DiagramSeries lawSeries(const ElementLaw& law, const FrequencyRange& range, Reading reading,
                        Message name) {
  DiagramSeries series;
  series.name = std::move(name);
  for (const double frequency : frequencies(range.from, range.to)) {
    const ComplexModulus modulus = complexModulus(law, 2 * std::numbers::pi * frequency);
    series.points.push_back({frequency, reading({frequency, modulus.storage, modulus.loss})});
  }
  return series;
}

Message bandLabel(const Scene& scene) {
  std::string velocity = printedQuantity(scene.sliding.velocity, "m/s");
  // A hard blank keeps number and unit in one line.
  if (const std::size_t gap = velocity.rfind(' '); gap != std::string::npos)
    velocity.replace(gap, 1, "\u00A0");
  return message("excited at {}", PrintedNumber{std::move(velocity)});
}

}  // namespace

std::vector<NamedSheet> materialSheets(const Material& material) {
  if (!material.isMeasured()) return {masterSheet(material), tangentSheet(material)};
  std::vector<NamedSheet> sheets{isothermsSheet(material), masterSheet(material),
                                 tangentSheet(material)};
  if (material.isotherms.size() > 1) sheets.push_back(shiftsSheet(material));
  return sheets;
}

DiagramSheet excitationSheet(const Scene& scene, const Excitation& excitation) {
  const ElementLaw law = elementLaw(scene.elastomer);
  const auto measured = measuredFrequencies(scene.elastomer);
  const auto band = excitation.band(scene.sliding.velocity);
  const FrequencyRange range = shownRange(measured, band, law);

  Diagram moduli, tangent, weights;
  moduli.x = frequencyAxis("frequency f");
  moduli.x.from = range.from;
  moduli.x.to = range.to;
  tangent.x = weights.x = moduli.x;
  moduli.height = 2;
  // A hard blank keeps both symbols together where the title is shortened.
  moduli.y = {"moduli G\u2032,\u00A0G\u2033", "Pa"};
  moduli.series = {lawSeries(law, range, readStorage, "storage modulus G\u2032"),
                   lawSeries(law, range, readLoss, "loss modulus G\u2033")};
  tangent.y = {"tan \u03B4", ""};
  tangent.series = {lawSeries(law, range, readTangent, {})};
  weights.y = {"loss per decade / largest", "", AxisScale::Linear, 0, 1.05};
  DiagramSeries share;
  for (const Excitation::Weight& weight : excitation.weights(scene.sliding.velocity))
    if (weight.frequency >= range.from && weight.frequency <= range.to)
      share.points.push_back({weight.frequency, weight.weight});
  weights.series = {std::move(share)};
  if (!band) weights.blank = "nothing is dissipated at this velocity";

  DiagramSheet sheet;
  for (Diagram* diagram : {&moduli, &tangent, &weights}) {
    if (measured) diagram->spans.push_back({measured->from, measured->to, "measured", {}, {}});
    if (band) diagram->shades.push_back({band->from, band->to, bandLabel(scene), {}, {}});
  }
  tangent.spans.clear();
  weights.spans.clear();
  for (Diagram* diagram : {&tangent, &weights})
    for (DiagramSpan& shade : diagram->shades) shade.label = {};
  sheet.title = message("Where the rubber is used at {}", celsius(scene.elastomer.temperature));
  sheet.subtitle = describeExcitation(scene, excitation);
  sheet.diagrams = {std::move(moduli), std::move(tangent), std::move(weights)};
  sheet.columns = 1;
  sheet.sharesAxis = true;
  sheet.note =
      "Tinted: from 5 to 95 % of the loss in complete contact, q C(q) G\u2033(q v). The "
      "share is per decade of frequency, q\u00B2 C G\u2033, over its largest value.";
  return sheet;
}

DiagramSheet excitationSheet(const Scene& scene) {
  return excitationSheet(scene, computeExcitation(scene));
}

std::string excitationCsv(const Scene& scene, const Excitation& excitation) {
  const ElementLaw law = elementLaw(scene.elastomer);
  DataTable table{columnNames({"frequency", "storage_modulus", "loss_modulus", "loss_tangent",
                               "excitation_weight"}),
                  {}};
  for (const Excitation::Weight& weight : excitation.weights(scene.sliding.velocity)) {
    const ComplexModulus modulus = complexModulus(law, 2 * std::numbers::pi * weight.frequency);
    table.rows.push_back({weight.frequency, modulus.storage, modulus.loss,
                          modulus.loss / modulus.storage, weight.weight});
  }
  return tableCsv(table);
}

nlohmann::ordered_json excitationJson(const Scene& scene, const Excitation& excitation) {
  const auto band = excitation.band(scene.sliding.velocity);
  const auto measured = measuredFrequencies(scene.elastomer);
  const double outside = excitation.shareNotMeasured(scene.sliding.velocity);
  return {{"frequency_from", band ? Json(band->from) : Json()},
          {"frequency_median", band ? Json(band->median) : Json()},
          {"frequency_to", band ? Json(band->to) : Json()},
          {"measured_from", measured ? Json(measured->from) : Json()},
          {"measured_to", measured ? Json(measured->to) : Json()},
          {"share_not_measured", numberOrNull(outside)}};
}

Message describeExcitation(const Scene& scene, const Excitation& excitation) {
  const double velocity = scene.sliding.velocity;
  const auto band = excitation.band(velocity);
  if (!band) return "the line excites no loss at this velocity";
  const auto hertz = [](double value) { return printed(value, "Hz"); };
  const Message excited =
      message("at {} the line excites {} to {}, half of the loss below {}",
              printed(velocity, "m/s"), hertz(band->from), hertz(band->to), hertz(band->median));
  const auto measured = measuredFrequencies(scene.elastomer);
  const double outside = excitation.shareNotMeasured(velocity);
  if (!measured || std::isnan(outside)) return excited;
  return message("{}; measured were {} to {}, {} % of the loss is extrapolated", excited,
                 hertz(measured->from), hertz(measured->to), printedPercent(outside, 2));
}

}  // namespace asperity
