#include "core/chart/cutoff_sheet.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/json_text.h"
#include "core/base/number_text.h"
#include "core/chart/curve_words.h"
#include "core/friction/curve_file.h"
#include "core/scene/columns.h"
#include "core/scene/provenance.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

constexpr ColumnName kWavelength = "cutoff_wavelength", kShare = "share_of_decade",
                     kShareError = "share_of_decade_standard_error";

DiagramAxis wavelengthAxis() {
  return {"short-wave cut-off \u03BB", "m", AxisScale::Logarithmic};
}

}  // namespace

DiagramSheet cutoffSheet(const Scene& scene, const std::vector<CutoffPoint>& points) {
  DiagramSheet sheet;
  sheet.title = "Friction against the short-wave cut-off";
  sheet.subtitle = describeScene(scene);
  sheet.columns = 1;
  sheet.sharesAxis = true;
  Diagram friction, share;
  friction.x = share.x = wavelengthAxis();
  friction.y = {"coefficient of friction \u03BC", "", AxisScale::Logarithmic};
  share.y = {"share of friction per decade", "", AxisScale::Linear};
  share.height = 0.7;
  DiagramSeries mu, shares, zero;
  mu.mark = shares.mark = SeriesMark::Circle;
  mu.colour = 0;
  shares.colour = 1;
  zero.isTheory = true;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const CurvePoint& state = points[i].state;
    const double error = state.muStandardError;
    mu.points.push_back(
        {points[i].wavelength, state.mu, state.mu - error, state.mu + error, static_cast<int>(i)});
    if (i == 0) continue;
    // The step belongs to the waves between its two cut-offs.
    const double middle = std::sqrt(points[i - 1].wavelength * points[i].wavelength);
    const Estimate& part = points[i].shareOfDecade;
    shares.points.push_back({middle, part.value, part.value - part.standardError,
                             part.value + part.standardError, static_cast<int>(i)});
    zero.points.push_back({middle, 0});
  }
  friction.series = {std::move(mu)};
  share.series = {std::move(zero), std::move(shares)};
  if (!points.empty()) {
    constexpr double kAir = 1.3;
    for (DiagramAxis* axis : {&friction.x, &share.x}) {
      axis->from = points.back().wavelength / kAir;
      axis->to = points.front().wavelength * kAir;
    }
  }
  sheet.diagrams = {std::move(friction), std::move(share)};
  sheet.note =
      "Friction of the same lines without their waves shorter than \u03BB, and the share of it "
      "that the waves of one decade of wavelengths make.";
  return sheet;
}

std::string cutoffCsv(const std::vector<CutoffPoint>& points) {
  std::vector<CurvePoint> states;
  for (const CutoffPoint& point : points) states.push_back(point.state);
  const CurveTable table(states, {});
  std::string text = kWavelength.text() + "," + kShare.text() + "," + kShareError.text() + "," +
                     table.header() + "\n";
  for (const CutoffPoint& point : points)
    text += fmt::format("{},{},{},{}\n", point.wavelength, csvNumber(point.shareOfDecade.value),
                        csvNumber(point.shareOfDecade.standardError), table.row(point.state));
  return text;
}

std::string cutoffJson(const Scene& scene, const std::vector<CutoffPoint>& points) {
  std::vector<CurvePoint> states;
  for (const CutoffPoint& point : points) states.push_back(point.state);
  const CurveTable table(states, {});
  Json root = provenance("cutoff", scene);
  Json rows = Json::array();
  for (const CutoffPoint& point : points) {
    Json row;
    row[kWavelength.text()] = point.wavelength;
    row[kShare.text()] = numberOrNull(point.shareOfDecade.value);
    row[kShareError.text()] = numberOrNull(point.shareOfDecade.standardError);
    row.update(table.json(point.state));
    rows.push_back(std::move(row));
  }
  root["points"] = std::move(rows);
  return root.dump(2) + "\n";
}

}  // namespace asperity
