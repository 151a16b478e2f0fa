#include "core/friction/curve_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/scene/columns.h"
#include "core/scene/provenance.h"

namespace asperity {
namespace {

struct CurveColumn {
  ColumnName name;
  double CurvePoint::*member;
};

constexpr std::array<CurveColumn, 10> kCurveColumns{{
    {"velocity", &CurvePoint::velocity},
    {"mu", &CurvePoint::mu},
    {"mu_standard_error", &CurvePoint::muStandardError},
    {"mu_law", &CurvePoint::muLaw},
    {"contact_fraction", &CurvePoint::contactFraction},
    {"rms_slope_contact", &CurvePoint::rmsSlopeContact},
    {"indentation", &CurvePoint::indentation},
    {"normalized_mu", &CurvePoint::normalizedMu},
    {"dimensionless_velocity", &CurvePoint::dimensionlessVelocity},
    {"dimensionless_force", &CurvePoint::dimensionlessForce},
}};
constexpr ColumnName kRealizations = "realizations";

/// Further columns, each where its first row applies: local friction, a constant indentation, a
/// target accuracy, the paper's single elements.
struct ExtraColumn {
  ColumnName name;
  double (*value)(const CurvePoint& point);
};
constexpr std::array<ExtraColumn, 7> kExtraColumns{{
    {"mu_interface", [](const CurvePoint& point) { return point.muInterface; }},
    {"mu_total", [](const CurvePoint& point) { return point.mu + point.muInterface; }},
    {"mu_mean_of_ratios",
     [](const CurvePoint& point) {
       return std::isfinite(point.muRatioOfMeans) ? point.mu : kNotApplicable;
     }},
    {"mu_ratio_of_means", [](const CurvePoint& point) { return point.muRatioOfMeans; }},
    {"mu_low", [](const CurvePoint& point) { return point.muLow; }},
    {"mu_high", [](const CurvePoint& point) { return point.muHigh; }},
    {"marginal_share", [](const CurvePoint& point) { return point.marginalShare; }},
}};

std::vector<ExtraColumn> extraColumnsOf(const std::vector<CurvePoint>& points) {
  std::vector<ExtraColumn> columns;
  for (const ExtraColumn& column : kExtraColumns)
    if (!points.empty() && std::isfinite(column.value(points.front()))) columns.push_back(column);
  return columns;
}

constexpr ColumnName kNotes = "notes";

bool hasNotes(const std::vector<CurvePoint>& points) {
  return std::ranges::any_of(points,
                             [](const CurvePoint& point) { return !notesOf(point).empty(); });
}

std::string withoutLineEnd(std::string row) {
  row.pop_back();
  return row;
}

}  // namespace

std::string csvNumber(double value) {
  return std::isfinite(value) ? fmt::format("{}", value) : std::string();
}

std::string curveHeader() {
  std::string text;
  for (const CurveColumn& column : kCurveColumns) text += column.name.text() + ",";
  return text + kRealizations.text() + "\n";
}

std::string curveRow(const CurvePoint& point) {
  std::string text;
  for (const CurveColumn& column : kCurveColumns) text += csvNumber(point.*column.member) + ",";
  return text + fmt::format("{}\n", point.realizations);
}

std::string notesOf(const CurvePoint& point) {
  if (point.mu == 0) return {};
  // Eq. (4) is the work of the damping, 4 eta v times the squared slope over the contact, and that
  // of the elastic pressure. On resolved lines at H = 0.7 and 1e-4 to 1 N the second part is never
  // more than 0.45 of the first; where a contact has only a few elements it is their sum's error.
  const double slope = point.mu / point.normalizedMu;  // rms, of the whole line
  const double damping = 4 * std::sqrt(2.0) * point.dimensionlessVelocity / slope /
                         point.dimensionlessForce * point.rmsSlopeContact * point.rmsSlopeContact *
                         point.contactFraction;
  // Of what does not apply nothing is said.
  return std::isgreater(std::abs(point.mu - damping), damping) ? "unresolved_friction" : "";
}

std::string curveCsv(const std::vector<CurvePoint>& points) {
  const std::vector<ExtraColumn> extra = extraColumnsOf(points);
  const bool withNotes = hasNotes(points);
  std::string text = withoutLineEnd(curveHeader());
  for (const ExtraColumn& column : extra) text += "," + column.name.text();
  text += withNotes ? "," + kNotes.text() + "\n" : "\n";
  for (const CurvePoint& point : points) {
    text += withoutLineEnd(curveRow(point));
    for (const ExtraColumn& column : extra) text += "," + csvNumber(column.value(point));
    text += withNotes ? "," + notesOf(point) + "\n" : "\n";
  }
  return text;
}

std::string curveJson(const std::vector<CurvePoint>& points, const Scene& scene) {
  using Json = nlohmann::ordered_json;
  const std::vector<ExtraColumn> extra = extraColumnsOf(points);
  const bool withNotes = hasNotes(points);
  Json rows = Json::array();
  for (const CurvePoint& point : points) {
    Json row;
    for (const CurveColumn& column : kCurveColumns) {
      const double value = point.*column.member;
      row[column.name.text()] = std::isfinite(value) ? Json(value) : Json(nullptr);
    }
    row[kRealizations.text()] = point.realizations;
    for (const ExtraColumn& column : extra) {
      const double value = column.value(point);
      row[column.name.text()] = std::isfinite(value) ? Json(value) : Json(nullptr);
    }
    if (withNotes) row[kNotes.text()] = notesOf(point);
    rows.push_back(std::move(row));
  }
  Json root = provenance("curve", scene);
  root["points"] = std::move(rows);
  return root.dump(2) + "\n";
}

}  // namespace asperity
