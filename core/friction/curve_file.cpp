#include "core/friction/curve_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/json_text.h"
#include "core/contact/steady_sliding.h"
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

/// Further columns, each for the rows to which it applies: local friction, a constant indentation,
/// a target accuracy, the paper's single elements.
struct ExtraColumn {
  ColumnName name;
  double (*value)(const CurvePoint& point);
  /// Where forces are requested, a column may apply to more rows.
  double (*withForces)(const CurvePoint& point) = nullptr;
};
constexpr std::array<ExtraColumn, 14> kExtraColumns{{
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
    {"extrapolated", [](const CurvePoint& point) { return point.extrapolated; }},
    {"normal_force", [](const CurvePoint& point) { return point.normalForce; },
     [](const CurvePoint& point) { return point.forceOnPeriod; }},
    {"nominal_pressure", [](const CurvePoint& point) { return point.nominalPressure; }},
    {"mean_pressure", [](const CurvePoint& point) { return point.meanPressure; },
     [](const CurvePoint& point) { return point.contactPressure; }},
    {"tangential_force", [](const CurvePoint&) { return kNotApplicable; },
     [](const CurvePoint& point) { return point.tangentialForce; }},
    {"power", [](const CurvePoint&) { return kNotApplicable; },
     [](const CurvePoint& point) { return point.power; }},
    {"contact_spots",
     [](const CurvePoint& point) {
       return point.listsContacts ? point.contactSpots : kNotApplicable;
     },
     [](const CurvePoint& point) { return point.contactSpots; }},
}};

constexpr ColumnName kNotesColumn = "notes";

/// Returns whether more than half of the friction by Eq. (4) is the work of the elastic pressure.
bool isUnresolved(const CurvePoint& point) {
  if (point.mu == 0) return false;
  // Eq. (4) is the work of the damping, 4 eta v times the squared slope over the contact, plus that
  // of the elastic pressure. On resolved lines at H = 0.7 and 1e-4 to 1 N the second part never
  // exceeds 0.45 of the first; where a contact has only a few elements it is the error of their
  // sum.
  const double slope = point.mu / point.normalizedMu;  // rms, of the whole line
  const double damping = 4 * std::sqrt(2.0) * point.dimensionlessVelocity / slope /
                         point.dimensionlessForce * point.rmsSlopeContact * point.rmsSlopeContact *
                         point.contactFraction;
  // A value that does not apply gives no note.
  return std::isgreater(std::abs(point.mu - damping), damping);
}

bool hasNotes(const std::vector<CurvePoint>& points) {
  return std::ranges::any_of(points,
                             [](const CurvePoint& point) { return !pointNotes(point).empty(); });
}

}  // namespace

NoteSet pointNoteSet(const CurvePoint& point) {
  NoteSet notes = point.notes;
  notes.add(Note::UnresolvedFriction, isUnresolved(point));
  return notes;
}

std::string pointNotes(const CurvePoint& point) {
  NoteSet listed;
  for (const Note note : pointNoteSet(point).list())
    listed.add(note, note != Note::FewContacts || point.listsContacts);
  return listed.words();
}

std::vector<std::string_view> curveColumns() {
  std::vector<std::string_view> names;
  for (const CurveColumn& column : kCurveColumns) names.push_back(column.name);
  names.push_back(kRealizations);
  for (const ExtraColumn& column : kExtraColumns) names.push_back(column.name);
  return names;
}

double curveValue(const CurvePoint& point, std::string_view column) {
  for (const CurveColumn& one : kCurveColumns)
    if (one.name == column) return point.*one.member;
  for (const ExtraColumn& one : kExtraColumns)
    if (one.name == column) return one.withForces ? one.withForces(point) : one.value(point);
  return column == kRealizations ? static_cast<double>(point.realizations) : kNotApplicable;
}

std::string_view CurveColumns::sweptColumn() const {
  return columnOfKey(sweptKey);
}

CurveColumns columnsFor(const Scene& scene, bool hasForces) {
  return {scene.sweep.key, hasForces || !scene.sweep.isOfVelocity()};
}

CurveTable::CurveTable(std::span<const std::vector<CurvePoint>* const> curves, CurveColumns columns)
    : columns_(std::move(columns)) {
  for (std::size_t i = 0; i < kExtraColumns.size(); ++i) {
    // The axis may be one of the further columns.
    if (!isOfVelocity() && columns_.sweptColumn() == std::string_view(kExtraColumns[i].name))
      continue;
    if (std::ranges::any_of(curves, [&](const std::vector<CurvePoint>* points) {
          return !points->empty() && std::isfinite(extraValue(i, points->front()));
        }))
      extra_.push_back(i);
  }
  for (const std::vector<CurvePoint>* points : curves) hasNotes_ = hasNotes_ || hasNotes(*points);
}

CurveTable::CurveTable(const std::vector<CurvePoint>& rows, std::vector<std::string> without)
    : columns_{.hasForces = true}, without_(std::move(without)), hasNotes_(hasNotes(rows)) {
  for (std::size_t i = 0; i < kExtraColumns.size(); ++i)
    if (!isLeftOut(kExtraColumns[i].name) &&
        std::ranges::any_of(
            rows, [&](const CurvePoint& point) { return std::isfinite(extraValue(i, point)); }))
      extra_.push_back(i);
}

bool CurveTable::isLeftOut(std::string_view column) const {
  return std::ranges::find(without_, column) != without_.end();
}

double CurveTable::extraValue(std::size_t i, const CurvePoint& point) const {
  const ExtraColumn& column = kExtraColumns[i];
  return columns_.hasForces && column.withForces ? column.withForces(point) : column.value(point);
}

std::vector<std::string> CurveTable::header(std::vector<std::string> own) const {
  std::vector<std::string> names = std::move(own);
  if (!isOfVelocity()) names.emplace_back(columns_.sweptColumn());
  for (const CurveColumn& column : kCurveColumns)
    if (!isLeftOut(column.name)) names.push_back(column.name.text());
  names.push_back(kRealizations.text());
  for (const std::size_t i : extra_) names.push_back(kExtraColumns[i].name.text());
  if (hasNotes_) names.push_back(kNotesColumn.text());
  return names;
}

std::vector<TableCell> CurveTable::row(const CurvePoint& point, std::vector<TableCell> own) const {
  std::vector<TableCell> cells = std::move(own);
  if (!isOfVelocity()) cells.emplace_back(point.swept);
  for (const CurveColumn& column : kCurveColumns)
    if (!isLeftOut(column.name)) cells.emplace_back(point.*column.member);
  cells.push_back(point.realizations > 0 ? TableCell(point.realizations) : kNotApplicable);
  for (const std::size_t i : extra_) cells.emplace_back(extraValue(i, point));
  if (hasNotes_) cells.emplace_back(pointNotes(point));
  return cells;
}

DataTable CurveTable::of(const std::vector<CurvePoint>& points) const {
  DataTable table{header(), {}};
  for (const CurvePoint& point : points) table.rows.push_back(row(point));
  return table;
}

DataTable curveTable(const std::vector<CurvePoint>& points, const CurveColumns& columns) {
  const std::vector<CurvePoint>* const curves[] = {&points};
  return CurveTable(curves, columns).of(points);
}

std::string curveCsv(const std::vector<CurvePoint>& points, const CurveColumns& columns) {
  return tableCsv(curveTable(points, columns));
}

std::string curveJson(const std::vector<CurvePoint>& points, const Scene& scene, bool hasForces) {
  nlohmann::ordered_json root = provenance("curve", scene);
  root["points"] = tableJson(curveTable(points, columnsFor(scene, hasForces)));
  return jsonFile(root);
}

RealizationTable::RealizationTable(std::vector<double> velocities)
    : velocities_(std::move(velocities)),
      table_{columnNames({"realization", "velocity", "mu", "mu_interface", "contact_fraction",
                          "rms_slope_contact", "indentation", "normal_force", "tangential_force",
                          "rms_slope"}),
             {}} {}

void RealizationTable::add(std::int64_t realization, std::span<const SteadyResult> results) {
  for (std::size_t i = 0; i < std::min(results.size(), velocities_.size()); ++i) {
    const SteadyResult& at = results[i];
    // A line without normal force has no coefficient of friction.
    const bool isPressed = at.normalForce > 0;
    table_.rows.push_back({realization, velocities_[i], isPressed ? at.mu : kNotApplicable,
                           isPressed ? at.muInterface : kNotApplicable, at.contactFraction,
                           at.rmsSlopeContact, at.indentation, at.normalForce, at.tangentialForce,
                           at.rmsSlopeLine});
  }
}

}  // namespace asperity
