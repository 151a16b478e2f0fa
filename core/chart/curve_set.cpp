#include "core/chart/curve_set.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/friction/curve_file.h"
#include "core/scene/columns.h"

namespace asperity {
namespace {

/// Returns a text as one cell of CSV.
std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\n") == text.npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace

AxesFactors factorsOf(std::span<const CurvePoint> points, CurveAxes axes) {
  if (axes == CurveAxes::Physical) return {1, 1};
  AxesFactors factors;
  for (const CurvePoint& point : points) {
    if (point.velocity > 0 && std::isfinite(point.dimensionlessVelocity))
      factors.velocity = point.dimensionlessVelocity / point.velocity;
    if (point.mu != 0 && std::isfinite(point.normalizedMu))
      factors.friction = point.normalizedMu / point.mu;
  }
  return factors;
}

bool showsLaw(const Scene& scene) {
  return std::ranges::find(scene.comparison.theory, Theory::Eq11) != scene.comparison.theory.end();
}

int colourOfPin(int place) {
  // The first two colours belong to the present curve and its marker, so they come last.
  constexpr std::array<int, kPinColours> order{2, 3, 6, 5, 4, 7, 8, 1};
  return order[static_cast<std::size_t>(place % kPinColours)];
}

std::string curveSetCsv(const CurveSet& set) {
  std::vector<const std::vector<CurvePoint>*> curves{&set.present.points};
  for (const NamedCurve& curve : set.pinned) curves.push_back(&curve.points);
  const CurveTable table(curves);
  std::string text = joinedColumns({"series"}) + "," + table.header();
  if (set.difference)
    text += "," + joinedColumns({"relative_difference", "relative_difference_standard_error"});
  text += "\n";
  const auto addRow = [&](const std::string& series, const CurvePoint& point,
                          const DifferencePoint* difference = nullptr) {
    if (!std::isfinite(point.mu)) return;
    text += cell(series) + "," + table.row(point);
    if (set.difference)
      text += difference ? fmt::format(",{},{}", csvNumber(difference->relative),
                                       csvNumber(difference->standardError))
                         : ",,";
    text += "\n";
  };
  const auto addCurve = [&](const std::string& series, const NamedCurve& curve) {
    for (const CurvePoint& point : curve.points)
      if (point.realizations > 0) addRow(series, point);
  };
  const std::string& title = set.present.scene.title;
  addCurve(title.empty() ? "this scene" : title, set.present);
  const AxesFactors factors = factorsOf(set.present.points, CurveAxes::Dimensionless);
  const auto pointAt = [&](double velocity, double mu) {
    CurvePoint point;
    point.velocity = velocity;
    point.mu = mu;
    point.contactFraction = point.indentation = kNotApplicable;
    point.dimensionlessVelocity = velocity * factors.velocity;
    point.normalizedMu = mu * factors.friction;
    return point;
  };
  if (showsLaw(set.present.scene))
    for (const CurvePoint& point : set.present.points)
      addRow("Eq. (11)", pointAt(point.velocity, point.muLaw));
  for (const TheoryCurve& theory : set.theories)
    for (const TheoryPoint& point : theory.points)
      if (point.isInRange) {
        CurvePoint row = pointAt(point.velocity, point.mu);
        row.contactFraction = point.contactFraction;
        addRow(entryOf(theory.theory).name, row);
      }
  for (const MeasuredCurve& measured : set.measured)
    for (std::size_t i = 0; i < measured.velocities.size(); ++i) {
      CurvePoint point = pointAt(measured.velocities[i], measured.data.points[i].mu);
      point.muStandardError = measured.data.points[i].muError;
      addRow(measured.data.name, point);
    }
  for (const NamedCurve& curve : set.pinned) addCurve(curve.name.english(), curve);
  if (!set.difference) return text;
  for (const DifferencePoint& difference : set.difference->points) {
    CurvePoint point = pointAt(difference.velocity, difference.mu);
    point.muStandardError = difference.muStandardError;
    point.realizations = set.difference->setting.realizations;
    addRow(nameOf(set.difference->setting).english(), point, &difference);
  }
  return text;
}

}  // namespace asperity
