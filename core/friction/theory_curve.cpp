#include "core/friction/theory_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/friction/curve_point.h"
#include "core/friction/law.h"
#include "core/friction/theories.h"
#include "core/scene/sweep.h"

namespace asperity {
namespace {

constexpr std::array<TheoryEntry, 4> kTheories{
    {{Theory::Eq11, "Eq. (11)",
      "Eq. (11) of Li et al. (2013): self-affine lines, Kelvin elements, contact of many summits."},
     {Theory::GaussianFoundation, "Gaussian foundation, low velocity",
      "Gaussian line on independent elements as the velocity goes to 0, without a fitted constant; "
      "it needs three independent waves in contact."},
     {Theory::CompleteContact, "complete contact",
      "Losses of all waves of the line in complete contact, for any linear rheology; below "
      "complete contact it is too large."},
     {Theory::PerssonHalfSpace, "half-space, with long-range elasticity",
      "Persson (2001) for the isotropic surface that this line is equivalent to, at its nominal "
      "pressure: another model, whose elements feel each other."}}};

/// Contact counts as complete where the mean pressure is at least this many times its rms
/// variation: on a Gaussian line the pressure is then below 0 at one point in seven hundred.
constexpr double kDeviationsOfCompleteContact = 3;

/// The heights of a line count as Gaussian where so many of its waves are in contact: with 40 lines
/// of figure_2.json, roll-off wavelengths of 0.5 to 20 mm and 0.3 to 300 mN, the contact fraction
/// then differs by at most 2 % from the theory, and by 11 % at two waves.
constexpr double kWavesInContact = 3;

struct TheoryInput {
  ElementLaw law;
  WaveSpectrum spectrum;
  double length;           // m
  double normalForce;      // N
  double nominalPressure;  // Pa
};

std::vector<TheoryPoint> lawCurve(const Scene& scene, const LineSource& source,
                                  std::span<const double> velocities) {
  std::vector<TheoryPoint> points;
  const LawColumns columns(scene, source);
  CurveAverages none;  // of friction; the law needs the slope of the lines alone
  none.mu.add(0);
  none.rmsSlope.add(source.statistics().rmsSlope);
  for (const double velocity : velocities) {
    CurvePoint point;
    point.velocity = velocity;
    columns.addTo(point, none);
    points.push_back({velocity, point.muLaw, kNotApplicable, true});
  }
  return points;
}

std::vector<TheoryPoint> gaussianCurve(const TheoryInput& in, std::span<const double> velocities) {
  const GaussianFoundation found =
      gaussianFoundation(in.law, in.spectrum.meanSquareHeight(), in.spectrum.meanSquareSlope(),
                         in.normalForce / in.length);
  const bool isGaussian = in.spectrum.effectiveWaves() * found.contactFraction >= kWavesInContact;
  std::vector<TheoryPoint> points;
  for (const double velocity : velocities)
    points.push_back({velocity, found.slope * std::abs(velocity), found.contactFraction,
                      isGaussian && std::abs(velocity) <= found.validBelow});
  return points;
}

std::vector<TheoryPoint> completeCurve(const TheoryInput& in, std::span<const double> velocities) {
  std::vector<TheoryPoint> points;
  const double lineForce = in.normalForce / in.length;
  for (const double velocity : velocities) {
    const CompleteContactFriction found =
        completeContactFriction(in.law, in.spectrum, lineForce, std::abs(velocity));
    points.push_back(
        {velocity, found.mu, 1, lineForce >= kDeviationsOfCompleteContact * found.rmsPressure});
  }
  return points;
}

std::vector<TheoryPoint> perssonCurve(const TheoryInput& in, std::span<const double> velocities) {
  const PerssonHalfSpace theory(in.law, in.spectrum, in.nominalPressure);
  std::vector<TheoryPoint> points;
  for (const double velocity : velocities) {
    const auto [mu, contactFraction] = theory.at(std::abs(velocity));
    points.push_back({velocity, mu, contactFraction, true});
  }
  return points;
}

}  // namespace

std::span<const TheoryEntry> theoryEntries() {
  return kTheories;
}

const TheoryEntry& theoryEntry(Theory theory) {
  return *std::ranges::find(kTheories, theory, &TheoryEntry::theory);
}

std::vector<TheoryPoint> theoryCurve(Theory theory, const Scene& scene, const LineSource& source,
                                     std::span<const double> velocities) {
  if (theory == Theory::Eq11) return lawCurve(scene, source, velocities);
  const double length = source.length();
  const double force = loadOn(scene.load, length).normalForce;
  if (scene.load.kind == LoadKind::Indentation || !(force > 0)) {
    std::vector<TheoryPoint> none;
    for (const double velocity : velocities)
      none.push_back({velocity, kNotApplicable, kNotApplicable, false});
    return none;
  }
  const double pressure = scene.load.kind == LoadKind::Pressure ? scene.load.nominalPressure
                                                                : force / (length * length);
  const TheoryInput in{elementLaw(scene.elastomer), waveSpectrum(source), length, force, pressure};
  switch (theory) {
    case Theory::GaussianFoundation:
      return gaussianCurve(in, velocities);
    case Theory::CompleteContact:
      return completeCurve(in, velocities);
    default:
      return perssonCurve(in, velocities);
  }
}

double TheoryPoint::value(CurveQuantity quantity) const {
  switch (quantity) {
    case CurveQuantity::Mu:
      return mu;
    case CurveQuantity::NormalizedMu:
      return mu / rmsSlope;
    case CurveQuantity::ContactFraction:
      return contactFraction;
    case CurveQuantity::TangentialForce:
      return mu * normalForce;
    case CurveQuantity::Power:
      return mu * normalForce * velocity;
    case CurveQuantity::MeanPressure:
      return std::isgreater(contactFraction, 0) ? normalForce / (contactFraction * area)
                                                : kNotApplicable;
    default:
      return kNotApplicable;
  }
}

std::vector<TheoryPoint> theoryOverAxis(Theory theory, const Scene& scene, std::int64_t points,
                                        const std::stop_token& stop) {
  ParameterRange range = sweepRange(scene);
  range.points = std::max(range.points, points);
  std::vector<TheoryPoint> curve;
  std::optional<LineSource> source;
  Surface made;
  const auto add = [&](const Scene& state, std::span<const double> velocities, double swept) {
    // Most keys leave the line as it is, which may be long.
    if (!source || !(made == state.surface)) {
      source.emplace(state, 1);
      made = state.surface;
    }
    const double length = source->length();
    for (TheoryPoint point : theoryCurve(theory, state, *source, velocities)) {
      point.swept = swept;
      point.rmsSlope = source->statistics().rmsSlope;
      point.area = length * contactWidth(state.load, length);
      if (state.load.kind != LoadKind::Indentation)
        point.normalForce = loadOn(state.load, length).normalForce;
      curve.push_back(point);
    }
  };
  const std::vector<double> values = rangeValues(range);
  if (scene.sweep.isOfVelocity()) {
    add(scene, values, kNotApplicable);
    return curve;
  }
  for (const double value : values) {
    if (stop.stop_requested()) break;
    const Scene state = sceneAt(scene, value);
    add(state, {&state.sliding.velocity, 1}, value);
  }
  return curve;
}

}  // namespace asperity
