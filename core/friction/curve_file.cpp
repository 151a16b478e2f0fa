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
// Only where a scene has local friction.
constexpr const char *kInterface = "mu_interface", *kTotal = "mu_total";

bool hasInterface(const std::vector<CurvePoint>& points) {
  return !points.empty() && std::isfinite(points.front().muInterface);
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
  if (!hasInterface(points)) {
    std::string text = curveHeader();
    for (const CurvePoint& point : points) text += curveRow(point);
    return text;
  }
  std::string text = fmt::format("{},{},{}\n", withoutLineEnd(curveHeader()), kInterface, kTotal);
  for (const CurvePoint& point : points)
    text += fmt::format("{},{},{}\n", withoutLineEnd(curveRow(point)), csvNumber(point.muInterface),
                        csvNumber(point.mu + point.muInterface));
  return text;
}

std::string curveJson(const std::vector<CurvePoint>& points, const Scene& scene) {
  using Json = nlohmann::ordered_json;
  Json rows = Json::array();
  for (const CurvePoint& point : points) {
    Json row;
    for (const Column& column : kColumns) {
      const double value = point.*column.member;
      row[column.name] = std::isfinite(value) ? Json(value) : Json(nullptr);
    }
    row[kRealizations] = point.realizations;
    if (hasInterface(points)) {
      row[kInterface] = point.muInterface;
      row[kTotal] = point.mu + point.muInterface;
    }
    rows.push_back(std::move(row));
  }
  Json root = provenance("curve", scene);
  root["points"] = std::move(rows);
  return root.dump(2) + "\n";
}

}  // namespace asperity
