#include "core/friction/curve_file.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "core/scene/provenance.h"

namespace asperity {
namespace {

struct Column {
  const char* name;
  double CurvePoint::*member;
};

constexpr std::array<Column, 10> kColumns{{
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
constexpr const char* kRealizations = "realizations";

/// Further columns, each where its first row applies: local friction, a target accuracy, the
/// paper's single elements.
struct ExtraColumn {
  const char* name;
  double (*value)(const CurvePoint& point);
};
constexpr std::array<ExtraColumn, 5> kExtraColumns{{
    {"mu_interface", [](const CurvePoint& point) { return point.muInterface; }},
    {"mu_total", [](const CurvePoint& point) { return point.mu + point.muInterface; }},
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
  for (const Column& column : kColumns) text += fmt::format("{},", column.name);
  return text + fmt::format("{}\n", kRealizations);
}

std::string curveRow(const CurvePoint& point) {
  std::string text;
  for (const Column& column : kColumns) text += csvNumber(point.*column.member) + ",";
  return text + fmt::format("{}\n", point.realizations);
}

std::string curveCsv(const std::vector<CurvePoint>& points) {
  const std::vector<ExtraColumn> extra = extraColumnsOf(points);
  std::string text = withoutLineEnd(curveHeader());
  for (const ExtraColumn& column : extra) text += fmt::format(",{}", column.name);
  text += "\n";
  for (const CurvePoint& point : points) {
    text += withoutLineEnd(curveRow(point));
    for (const ExtraColumn& column : extra) text += "," + csvNumber(column.value(point));
    text += "\n";
  }
  return text;
}

std::string curveJson(const std::vector<CurvePoint>& points, const Scene& scene) {
  using Json = nlohmann::ordered_json;
  const std::vector<ExtraColumn> extra = extraColumnsOf(points);
  Json rows = Json::array();
  for (const CurvePoint& point : points) {
    Json row;
    for (const Column& column : kColumns) {
      const double value = point.*column.member;
      row[column.name] = std::isfinite(value) ? Json(value) : Json(nullptr);
    }
    row[kRealizations] = point.realizations;
    for (const ExtraColumn& column : extra) {
      const double value = column.value(point);
      row[column.name] = std::isfinite(value) ? Json(value) : Json(nullptr);
    }
    rows.push_back(std::move(row));
  }
  Json root = provenance("curve", scene);
  root["points"] = std::move(rows);
  return root.dump(2) + "\n";
}

}  // namespace asperity
