#include "core/chart/curve_set.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <utility>

#include "core/base/input_error.h"
#include "core/friction/curve_file.h"
#include "core/friction/ensemble.h"
#include "core/material/temperature_shift.h"
#include "core/scene/columns.h"
#include "core/scene/data_table.h"
#include "core/scene/list_text.h"
#include "core/scene/sweep.h"

namespace asperity {

AxesFactors axesFactors(std::span<const CurvePoint> points, CurveAxes axes) {
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

double measuredFactor(const MeasuredCurve& measured, std::size_t point, const CurveSet& set,
                      const AxesFactors& factors) {
  if (set.isOfMu() || isCoefficient(set.y)) return factors.friction;
  return point < measured.computed.size() ? perFriction(set.y, measured.computed[point])
                                          : kNotApplicable;
}

bool showsLaw(const Scene& scene) {
  return std::ranges::find(scene.comparison.theory, Theory::Eq11) != scene.comparison.theory.end();
}

int pinColour(int index) {
  // The first two colours belong to the present curve and its marker, so they come last.
  constexpr std::array<int, kPinColours> order{2, 3, 6, 5, 4, kColourOfHalfSpace, 8, 1};
  return order[static_cast<std::size_t>(index % kPinColours)];
}

int measuredColour(int index) {
  // Orange and sky blue come first. The marker has colour 1; on white, colour 8 is nearly black, as
  // are the lines of theories.
  constexpr std::array<int, kPinColours> order{4, 5, 1, 8, 6, 3, 2, kColourOfHalfSpace};
  return order[static_cast<std::size_t>(index % kPinColours)];
}

AxisScale CurveSet::scaleOfX() const {
  const bool isLinear =
      axes == CurveAxes::Physical && present.scene.sweep.scale == SweepScale::Linear;
  return xScale.value_or(isLinear ? AxisScale::Linear : AxisScale::Logarithmic);
}

namespace {

/// Returns a_T of an elastomer over that at another temperature; NaN where it has none there.
double shiftTo(double temperature, const Elastomer& elastomer) {
  try {
    return temperatureShift(elastomer, elastomer.temperature, temperature);
  } catch (const InputError&) {
    return kNotApplicable;
  }
}

}  // namespace

double reduction(const Scene& scene, const CurveSet& set) {
  return set.hasReducedAxis() ? shiftTo(set.present.scene.elastomer.temperature, scene.elastomer)
                              : 1;
}

double abscissa(const CurvePoint& point, const Scene& scene, const CurveSet& set) {
  if (set.axes == CurveAxes::Dimensionless) return point.dimensionlessVelocity;
  return set.isOfVelocity() ? point.velocity * reduction(scene, set) : point.swept;
}

bool showsTotal(const CurveSet& set) {
  return set.isOfMu() && !set.measured.empty() && hasLocalFriction(set.present.scene);
}

double ordinate(const CurvePoint& point, const CurveSet& set) {
  return quantityValue(set.quantity(), point);
}

bool showsForces(const CurveSet& set) {
  return set.y == CurveQuantity::TangentialForce || set.y == CurveQuantity::Power ||
         set.y == CurveQuantity::MeanPressure;
}

namespace {

/// Returns the family's column: the last word of its key, or the key where the table has a column
/// of that name already.
std::string familyColumn(const CurveSet& set, const std::vector<std::string>& header) {
  if (set.familyKey.empty()) return {};
  const std::string word(columnOfKey(set.familyKey));
  return std::ranges::find(header, word) == header.end() ? word : set.familyKey;
}

std::vector<const std::vector<CurvePoint>*> pointsOfCurves(const CurveSet& set) {
  std::vector<const std::vector<CurvePoint>*> curves{&set.present.points};
  for (const NamedCurve& curve : set.pinned) curves.push_back(&curve.points);
  return curves;
}

/// The table of a set, written series by series.
class CurveSetTable {
 public:
  explicit CurveSetTable(const CurveSet& set)
      : set_(set),
        curve_(pointsOfCurves(set), columnsFor(set.present.scene, showsForces(set))),
        family_(familyColumn(set, curve_.header())),
        isReduced_(set.isReduced && set.isOfVelocity()),
        present_(sharedBy(set.present.scene, valueInFamily(set.present.scene))),
        factors_(axesFactors(set.present.points, CurveAxes::Dimensionless)) {}

  std::string csv() {
    addHeader();
    const std::string& title = set_.present.scene.title;
    addCurve(title.empty() ? "this scene" : title, set_.present, present_);
    addLaw();
    for (const TheoryCurve& theory : set_.theories)
      if (theory.theory != Theory::Eq11) addTheory(theory);
    for (const MeasuredCurve& measured : set_.measured) addMeasured(measured);
    for (const NamedCurve& curve : set_.pinned)
      addCurve(curve.name.english(), curve,
               sharedBy(curve.scene,
                        std::isnan(curve.familyValue) ? present_.familyValue : curve.familyValue));
    if (set_.difference) addDifference(*set_.difference);
    return tableCsv(table_);
  }

 private:
  /// What the points of a series share.
  struct Shared {
    double familyValue = kNotApplicable, temperature = kNotApplicable;
    double reduction = 1;  // from velocities to those of the reduced axis
  };

  Shared sharedBy(const Scene& scene, double familyValue) const {
    return {familyValue, scene.elastomer.temperature,
            shiftTo(set_.present.scene.elastomer.temperature, scene.elastomer)};
  }

  double valueInFamily(const Scene& scene) const {
    return family_.empty() ? kNotApplicable
                           : parameterNumber(*findParameter(set_.familyKey), scene);
  }

  bool isOfTemperature() const { return family_ == "temperature"; }

  void addHeader() {
    std::vector<std::string> own = columnNames({"series"});
    if (!family_.empty()) own.push_back(family_);
    table_.columns = curve_.header(std::move(own));
    const auto add = [this](ColumnName name) { table_.columns.push_back(name.text()); };
    if (isReduced_) add("reduced_velocity");
    if (isReduced_ && !isOfTemperature()) add("temperature");
    if (!set_.difference) return;
    add("relative_difference");
    add("relative_difference_standard_error");
  }

  void addRow(const std::string& series, const CurvePoint& point, const Shared& shared,
              const DifferencePoint* difference = nullptr) {
    if (!std::isfinite(point.mu)) return;
    std::vector<TableCell> row{series};
    if (!family_.empty()) row.emplace_back(shared.familyValue);
    row = curve_.row(point, std::move(row));
    if (isReduced_) row.emplace_back(point.velocity * shared.reduction);
    if (isReduced_ && !isOfTemperature()) row.emplace_back(shared.temperature);
    if (set_.difference) {
      row.emplace_back(difference ? difference->relative : kNotApplicable);
      row.emplace_back(difference ? difference->standardError : kNotApplicable);
    }
    table_.rows.push_back(std::move(row));
  }

  void addCurve(const std::string& series, const NamedCurve& curve, const Shared& shared) {
    for (const CurvePoint& point : curve.points)
      if (point.realizations > 0) addRow(series, point, shared);
  }

  /// Returns a point with this friction at a position (in the unit of the horizontal axis), at
  /// which no line was slid.
  CurvePoint pointAt(double position, double mu) const {
    CurvePoint point;
    if (set_.isOfVelocity()) {
      point.velocity = position;
    } else {
      point.velocity = set_.present.scene.sliding.velocity;
      point.swept = position;
    }
    point.mu = mu;
    point.contactFraction = point.indentation = kNotApplicable;
    point.dimensionlessVelocity = point.velocity * factors_.velocity;
    point.normalizedMu = mu * factors_.friction;
    return point;
  }

  template <class Point>
  double positionOf(const Point& point) const {
    return set_.isOfVelocity() ? point.velocity : point.swept;
  }

  void addLaw() {
    if (!showsLaw(set_.present.scene)) return;
    for (const CurvePoint& point : set_.present.points)
      addRow("Eq. (11)", pointAt(positionOf(point), point.muLaw), present_);
  }

  void addTheory(const TheoryCurve& theory) {
    for (const TheoryPoint& point : theory.points) {
      if (!point.isInRange) continue;
      CurvePoint row = pointAt(positionOf(point), point.mu);
      row.contactFraction = point.contactFraction;
      if (!set_.isOfVelocity()) {
        row.normalizedMu = point.value(CurveQuantity::NormalizedMu);
        row.dimensionlessVelocity = kNotApplicable;
      }
      addRow(theoryEntry(theory.theory).name, row, present_);
    }
  }

  void addMeasured(const MeasuredCurve& measured) {
    for (std::size_t i = 0; i < measured.abscissas.size(); ++i) {
      const MeasuredPoint& seen = measured.data.points[i];
      CurvePoint point = pointAt(measured.abscissas[i], seen.mu);
      point.velocity = seen.velocity;
      point.muStandardError = seen.muError;
      point.normalForce = i < measured.computed.size() && std::isnan(seen.normalForce)
                              ? measured.computed[i].normalForce
                              : seen.normalForce;
      point.nominalPressure = seen.nominalPressure;
      Shared shared = present_;
      shared.reduction = measured.abscissas[i] / seen.velocity;
      if (!std::isnan(seen.temperature)) shared.temperature = seen.temperature;
      if (isOfTemperature()) shared.familyValue = shared.temperature;
      addRow(measured.data.name, point, shared);
    }
  }

  void addDifference(const CurveDifference& difference) {
    for (const DifferencePoint& one : difference.points) {
      CurvePoint point = pointAt(one.velocity, one.mu);
      point.muStandardError = one.muStandardError;
      point.realizations = difference.setting.realizations;
      addRow(settingName(difference.setting).english(), point, present_, &one);
    }
  }

  const CurveSet& set_;
  CurveTable curve_;
  std::string family_;  // the column of the family; empty: none
  bool isReduced_;
  Shared present_;  // of the present curve, and of what is compared with it
  AxesFactors factors_;
  DataTable table_;
};

}  // namespace

std::string curveSetCsv(const CurveSet& set) {
  return CurveSetTable(set).csv();
}

namespace {

constexpr std::int64_t kTheoryPoints = 160;
constexpr std::int64_t kTheoryPointsOfLines = 48;  // each of a line of its own

double temperatureAt(const MeasuredPoint& point, const Scene& scene) {
  return std::isnan(point.temperature) ? scene.elastomer.temperature : point.temperature;
}

/// Returns the factor that shifts a measured velocity to the temperature of the scene.
double shiftToScene(const MeasuredPoint& point, const Scene& scene) {
  return temperatureShift(scene.elastomer, temperatureAt(point, scene),
                          scene.elastomer.temperature);
}

std::vector<TheoryCurve> theoryCurves(const CurveSet& set, const std::stop_token& stop) {
  std::vector<TheoryCurve> curves;
  const Scene& scene = set.present.scene;
  for (const Theory theory : scene.comparison.theory) {
    if (theory == Theory::Eq11 && set.hasLawInPoints()) continue;
    const bool isOfSurface = scene.sweep.key.starts_with("surface.");
    curves.push_back(
        {theory,
         theoryOverAxis(theory, scene, isOfSurface ? kTheoryPointsOfLines : kTheoryPoints, stop)});
  }
  return curves;
}

/// The quantities of a state that a table may have besides the velocity.
struct MeasuredColumn {
  std::string_view key;
  double MeasuredPoint::*value;
};
constexpr std::array<MeasuredColumn, 4> kMeasuredColumns{
    {{kVelocityKey, &MeasuredPoint::velocity},
     {"load.normal_force", &MeasuredPoint::normalForce},
     {"load.nominal_pressure", &MeasuredPoint::nominalPressure},
     {"elastomer.temperature", &MeasuredPoint::temperature}}};

/// Returns whether a measured value equals that of the scene, as far as both are known.
bool agrees(const MeasuredColumn& column, const MeasuredPoint& point, const Scene& scene) {
  constexpr double kClose = 0.02;
  const Parameter& row = *findParameter(column.key);
  const double measured = point.*column.value;
  if (std::isnan(measured) || !isApplicable(row, scene)) return true;
  const double own = parameterNumber(row, scene);
  // Two per cent of a temperature would be six kelvins.
  const double allowed = column.key == "elastomer.temperature" ? 1.0 : kClose * std::abs(own);
  return std::abs(measured - own) <= allowed;
}

/// Returns the rows of a table that belong on an axis over another key than velocity. Adds a note
/// where some do not.
FrictionData onAxis(FrictionData table, CurveSet& set) {
  const Scene& scene = set.present.scene;
  const Parameter& row = sweptParameter(scene);
  const auto column = std::ranges::find(kMeasuredColumns, scene.sweep.key, &MeasuredColumn::key);
  const std::size_t all = table.points.size();
  std::size_t known = 0;
  if (column != kMeasuredColumns.end())
    std::erase_if(table.points, [&](const MeasuredPoint& point) {
      if (std::isnan(point.*column->value)) return true;
      ++known;
      return std::ranges::any_of(kMeasuredColumns, [&](const MeasuredColumn& other) {
        return other.key != column->key && !agrees(other, point, scene);
      });
    });
  const Message name(table.name);
  if (known == 0) {
    table.points.clear();
    set.notes.push_back(
        message("{} is not shown: it has no column of {}", name, Message(row.label)));
  } else if (table.points.empty()) {
    set.notes.push_back(
        message("{} is not shown: it was measured at another velocity, load or temperature than "
                "the scene's",
                name));
  } else if (table.points.size() < all) {
    set.notes.push_back(message(
        "{}: {} of {} points; the others were measured at another velocity, load or temperature",
        name, table.points.size(), all));
  }
  return table;
}

double measuredAbscissa(const MeasuredPoint& point, const Scene& scene) {
  if (scene.sweep.isOfVelocity()) return point.velocity * shiftToScene(point, scene);
  return point.*std::ranges::find(kMeasuredColumns, scene.sweep.key, &MeasuredColumn::key)->value;
}

}  // namespace

std::vector<FrictionData> readComparisonData(const Scene& scene,
                                             const std::vector<FrictionData>& known) {
  const std::vector<DataFile>& tables = scene.comparison.data;
  std::vector<FrictionData> data;
  for (std::size_t i = 0; i + known.size() < tables.size(); ++i)
    data.push_back(readFrictionData(scene.folder / tables[i].file, tables[i].label));
  data.insert(data.end(), known.begin(), known.end());
  return data;
}

std::vector<FrictionData> addComparisonData(Scene& scene, const std::vector<std::string>& files) {
  std::vector<FrictionData> given;
  for (const std::string& name : files) {
    const std::filesystem::path file(name);
    given.push_back(readFrictionData(file));
    std::error_code error;
    const std::filesystem::path beside =
        std::filesystem::proximate(file, scene.folder.empty() ? "." : scene.folder, error);
    scene.comparison.data.push_back({error ? name : beside.string(), {}});
  }
  if (scene.comparison.data.size() > kMaxDataFiles)
    throw InputError(
        "", "--data",
        message("{} tables are more than {}", scene.comparison.data.size(), kMaxDataFiles));
  return given;
}

bool hasComparisons(const CurveSet& set) {
  const Comparisons& comparison = set.present.scene.comparison;
  return !(comparison == Comparisons{}) || (!comparison.theory.empty() && !set.hasLawInPoints());
}

void placeMeasured(CurveSet& set) {
  const Scene& scene = set.present.scene;
  set.isReduced = false;
  for (MeasuredCurve& measured : set.measured) {
    measured.abscissas.clear();
    for (const MeasuredPoint& point : measured.data.points) {
      measured.abscissas.push_back(measuredAbscissa(point, scene));
      set.isReduced |=
          set.isOfVelocity() && temperatureAt(point, scene) != scene.elastomer.temperature;
    }
  }
}

void addComparisons(CurveSet& set, std::vector<FrictionData> data, const StateOptions& options) {
  const Scene& scene = set.present.scene;
  set.theories = theoryCurves(set, options.stop);
  for (FrictionData& table : data) {
    if (!set.isOfVelocity()) table = onAxis(std::move(table), set);
    if (table.points.empty()) continue;
    MeasuredCurve curve;
    std::vector<Scene> states;
    for (const MeasuredPoint& point : table.points) states.push_back(sceneAtPoint(point, scene));
    SteadyStates found = slideStates(states, options);
    if (found.isComplete) curve.computed = std::move(found.points);
    const bool hasPressures = std::ranges::any_of(table.points, [](const MeasuredPoint& point) {
      return !std::isnan(point.nominalPressure);
    });
    // Another pressure of the scene has its own note.
    if (const auto note = pressureNote(curve.computed, scene.load.width); hasPressures && note)
      set.notes.push_back(message("{}: {}", Message::name(table.name), *note));
    if (auto note = forceNote(table, scene)) set.notes.push_back(std::move(*note));
    curve.data = std::move(table);
    set.measured.push_back(std::move(curve));
  }
  placeMeasured(set);
}

}  // namespace asperity
