#include "core/friction/curve_point.h"

#include <algorithm>
#include <cmath>

#include "core/base/intervals.h"
#include "core/base/number_text.h"
#include "core/contact/steady_sliding.h"
#include "core/friction/excitation.h"
#include "core/friction/law.h"
#include "core/material/element_law.h"
#include "core/scene/plan.h"
#include "core/surface/line_source.h"

namespace asperity {

void CurveAverages::add(const SteadyResult& result) {
  if (std::isfinite(result.mu)) mu.add(result.mu);
  if (std::isfinite(result.mu) && result.rmsSlopeLine > 0)
    normalizedMu.add(result.mu / result.rmsSlopeLine);
  rmsSlope.add(result.rmsSlopeLine);
  if (std::isfinite(result.muInterface)) muInterface.add(result.muInterface);
  contactFraction.add(result.contactFraction);
  contactSpots.add(result.contactSpots);
  indentation.add(result.indentation);
  normalForce.add(result.normalForce);
  tangentialForce.add(result.tangentialForce);
  marginalShare.add(result.marginalShare);
  if (std::isfinite(result.rmsSlopeContact)) rmsSlopeContact.add(result.rmsSlopeContact);
}

CurvePoint CurveAverages::point(double velocity) const {
  CurvePoint point{.velocity = velocity,
                   .mu = mu.mean(),
                   .muStandardError = mu.error().standardError,
                   .muInterface = muInterface.mean()};
  if (normalForce.mean() != 0) point.muRatioOfMeans = tangentialForce.mean() / normalForce.mean();
  point.contactFraction = contactFraction.mean();
  point.contactSpots = contactSpots.mean();
  point.rmsSlopeContact = rmsSlopeContact.mean();
  point.indentation = indentation.mean();
  point.marginalShare = marginalShare.mean();
  point.realizations = mu.count();
  return point;
}

Message extentText(const Extent& values, std::string_view unit) {
  constexpr int kDigits = 6;
  const PrintedNumber least = printed(values.least, unit, kDigits),
                      most = printed(values.most, unit, kDigits);
  return least.text == most.text ? Message(least) : message("{} to {}", least, most);
}

std::optional<Message> pressureNote(std::span<const CurvePoint> points, double width) {
  Extent pressures, forces, periods;
  for (const CurvePoint& point : points) {
    const double line = point.normalForce / point.nominalPressure;  // period times width
    if (!std::isgreater(line, 0)) continue;
    pressures.add(point.nominalPressure);
    forces.add(point.normalForce);
    periods.add(width > 0 ? line / width : std::sqrt(line));
  }
  if (pressures.isEmpty()) return {};
  const Message pressure = extentText(pressures, "Pa"), force = extentText(forces, "N"),
                period = extentText(periods, "m");
  return width > 0 ? message(
                         "the nominal pressure of {} is a normal force of {}: pressure times the "
                         "period of {} times the width of {} (load.width)",
                         pressure, force, period, printed(width, "m"))
                   : message(
                         "the nominal pressure of {} is a normal force of {}: pressure times the "
                         "period of {} times the width, for which the period is taken because none "
                         "is given; results depend on it, so set load.width (with load.kind "
                         "pressure)",
                         pressure, force, period);
}

std::optional<Message> pressureNote(const Scene& scene) {
  if (scene.load.kind != LoadKind::Pressure) return {};
  CurvePoint point;
  point.normalForce = loadOn(scene.load, lineExtent(scene).length).normalForce;
  point.nominalPressure = scene.load.nominalPressure;
  return pressureNote({&point, 1}, scene.load.width);
}

bool areContactsFew(double contactSpots, double contactFraction) {
  constexpr double kGrownTogether = 0.5;
  return std::isgreater(contactSpots, 0) && std::isless(contactSpots, kFewContacts) &&
         std::isless(contactFraction, kGrownTogether);
}

bool listsContacts(const Scene& scene) {
  return (hasSurfaceFile(scene.surface) && scene.surface.kind != SurfaceKind::Profile) ||
         scene.load.kind == LoadKind::Pressure || !scene.elastomer.material.empty() ||
         measuredFrequencies(scene.elastomer).has_value();
}

LineProperties lineProperties(const LineSource& source, const Elastomer& elastomer) {
  LineProperties lines{.rmsHeight = source.statistics().rmsHeight,
                       .rmsSlope = source.statistics().rmsSlope,
                       .length = source.length(),
                       .slopesDiffer = source.slopesDiffer(),
                       .hasRows = source.hasRows(),
                       .notes = lineNotes(source)};
  if (measuredFrequencies(elastomer)) lines.waves = excitedWaves(source);
  return lines;
}

LineProperties LineProperties::scaled(double factor) const {
  LineProperties lines = *this;
  lines.rmsHeight *= factor;
  lines.rmsSlope *= factor;
  // The slope is noted for the lines as they are now.
  lines.notes = {};
  for (const Note note : notes.list()) lines.notes.add(note, note != Note::SlopeAbove);
  lines.notes.add(Note::SlopeAbove, lines.rmsSlope > kSmallSlope);
  return lines;
}

LawColumns::LawColumns(const Scene& scene, const LineSource& source)
    : LawColumns(scene, lineProperties(source, scene.elastomer)) {}

LawColumns::LawColumns(const Scene& scene, const LineProperties& lines)
    : scene_(scene),
      lines_(lines),
      excitation_(lines.waves && measuredFrequencies(scene.elastomer)
                      ? std::make_shared<const Excitation>(scene.elastomer, lines.waves)
                      : nullptr),
      hasLaw_(scene.surface.kind == SurfaceKind::SelfAffine),
      hasArms_(needsStage(scene, Purpose::Curve, Stage::Arms)),
      hasInterface_(needsStage(scene, Purpose::Curve, Stage::Interface)) {
  lines_.notes.add(elastomerNotes(scene.elastomer, lines.rmsSlope, kNotApplicable));
}

/// Returns the mean of the lines' own ratios, for a mean `mu` that may include other lines.
double LawColumns::normalized(double mu, const CurveAverages& averages) const {
  const double sampled = averages.mu.mean();
  if (!lines_.slopesDiffer || !(sampled > 0)) return mu / lines_.rmsSlope;
  return mu * (averages.normalizedMu.mean() / sampled);
}

/// Adds normal and tangential force, power and pressure in contact.
void LawColumns::addForces(CurvePoint& point, const CurveAverages& averages) const {
  const bool isIndentationPrescribed = scene_.load.kind == LoadKind::Indentation;
  point.forceOnPeriod = isIndentationPrescribed ? averages.normalForce.mean()
                                                : loadOn(scene_.load, lines_.length).normalForce;
  point.tangentialForce =
      isIndentationPrescribed ? averages.tangentialForce.mean() : point.mu * point.forceOnPeriod;
  point.power = point.tangentialForce * point.velocity;
  const double width = contactWidth(scene_.load, lines_.length);
  if (std::isgreater(point.contactFraction, 0))
    point.contactPressure = point.forceOnPeriod / (point.contactFraction * lines_.length * width);
}

void LawColumns::addTo(CurvePoint& point, const CurveAverages& averages) const {
  if (!hasInterface_) point.muInterface = kNotApplicable;
  if (scene_.load.kind != LoadKind::Indentation) point.muRatioOfMeans = kNotApplicable;
  if (excitation_) {
    const double share = excitation_->shareNotMeasured(point.velocity);
    point.extrapolated = isExtrapolated(share) ? 1 : 0;
    point.notes.add(Note::ExtrapolatedMaterial, isExtrapolated(share));
  }
  const Accuracy& accuracy = scene_.accuracy;
  if (accuracy.scheme != Scheme::Nodal || accuracy.targetRelativeError > 0)
    point.marginalShare = kNotApplicable;
  point.notes.add(lines_.notes);
  point.listsContacts = listsContacts(scene_);
  // Only a rough line has many summits, of which few may carry the load.
  point.notes.add(Note::FewContacts, isRough(scene_.surface) &&
                                         areContactsFew(point.contactSpots, point.contactFraction));
  point.notes.add(Note::FewIndependentRows,
                  lines_.hasRows && averages.mu.count() > 1 &&
                      averages.mu.error().degreesOfFreedom < kFewDegreesOfFreedom);
  addForces(point, averages);
  if (scene_.load.kind == LoadKind::Pressure) {
    point.normalForce = point.forceOnPeriod;
    point.nominalPressure = scene_.load.nominalPressure;
    if (point.contactFraction > 0)
      point.meanPressure = point.nominalPressure / point.contactFraction;
  }
  if (!(lines_.rmsHeight > 0)) return;
  const double slope = lines_.slopesDiffer ? averages.rmsSlope.mean() : lines_.rmsSlope;
  const LawInput in =
      lawInput(elementLaw(scene_.elastomer), {lines_.rmsHeight, slope}, lines_.length,
               scene_.surface.hurst, point.forceOnPeriod, point.velocity);
  point.normalizedMu = normalized(point.mu, averages);
  point.dimensionlessForce = dimensionlessForce(in);
  if (hasArms_) return;  // Eqs. (5) to (14) have one relaxation time
  point.dimensionlessVelocity = dimensionlessVelocity(in);
  if (hasLaw_) point.muLaw = frictionLaw(in);
}

}  // namespace asperity
