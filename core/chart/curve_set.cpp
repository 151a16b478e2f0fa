#include "core/chart/curve_set.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "core/friction/curve_file.h"
#include "core/scene/columns.h"

namespace asperity {
namespace {

constexpr double kSlopesDiffer = 1e-9;  // relative; less is rounding

/// A text as one cell.
std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\n") == text.npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

/// Rows of one table.
class Rows {
 public:
  explicit Rows(bool hasDifference) : hasDifference_(hasDifference) {
    text_ = joinedColumns({"series", "velocity", "mu", "mu_standard_error",
                           "dimensionless_velocity", "normalized_mu", "realizations"});
    if (hasDifference)
      text_ += "," + joinedColumns({"relative_difference", "relative_difference_standard_error"});
    text_ += "\n";
  }

  void add(const std::string& series, double velocity, double mu, double error,
           const AxesFactors& factors, std::int64_t realizations,
           const DifferencePoint* difference = nullptr) {
    if (!std::isfinite(mu)) return;
    text_ += cell(series);
    for (const double value :
         {velocity, mu, error, velocity * factors.velocity, mu * factors.friction})
      text_ += "," + csvNumber(value);
    text_ += realizations > 0 ? fmt::format(",{}", realizations) : ",";
    if (hasDifference_)
      text_ += difference ? fmt::format(",{},{}", csvNumber(difference->relative),
                                        csvNumber(difference->standardError))
                          : ",,";
    text_ += "\n";
  }

  void addCurve(const std::string& series, const NamedCurve& curve) {
    const AxesFactors factors = factorsOf(curve.points, CurveAxes::Dimensionless);
    for (const CurvePoint& point : curve.points) {
      if (point.realizations == 0) continue;
      AxesFactors own = factors;
      // Lines that differ in their slope have another factor at each velocity.
      const double ratio = point.normalizedMu / point.mu;
      if (std::abs(ratio / factors.friction - 1) > kSlopesDiffer) own.friction = ratio;
      add(series, point.velocity, point.mu, point.muStandardError, own, point.realizations);
    }
  }

  std::string take() { return std::move(text_); }

 private:
  bool hasDifference_;
  std::string text_;
};

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

int colourOfPin(int place) {
  // Without the first two, which the present curve and its marker have.
  constexpr std::array<int, kPinColours> order{2, 3, 6, 5, 4, 1};
  return order[static_cast<std::size_t>(place % kPinColours)];
}

std::string curveSetCsv(const CurveSet& set) {
  Rows rows(set.difference.has_value());
  rows.addCurve("present", set.present);
  const AxesFactors factors = factorsOf(set.present.points, CurveAxes::Dimensionless);
  for (const CurvePoint& point : set.present.points)
    rows.add("Eq. (11)", point.velocity, point.muLaw, kNotApplicable, factors, 0);
  for (std::size_t i = 0; i < set.pinned.size(); ++i)
    rows.addCurve(fmt::format("pinned {}: {}", i + 1, set.pinned[i].name.english()), set.pinned[i]);
  if (set.difference)
    for (const DifferencePoint& point : set.difference->points)
      rows.add("compared: " + nameOf(set.difference->setting).english(), point.velocity, point.mu,
               point.muStandardError, factors, set.difference->setting.realizations, &point);
  return rows.take();
}

}  // namespace asperity
