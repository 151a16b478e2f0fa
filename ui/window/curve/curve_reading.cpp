#include "ui/window/curve/curve_reading.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <string>

#include "core/chart/curve_regions.h"
#include "core/scene/sweep.h"
#include "ui/chart/friction_chart_model.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"

namespace asperity {

namespace {

struct CurveReadingText {
  Q_DECLARE_TR_FUNCTIONS(asperity::CurveReadingText)
};

bool isKnown(const CurvePoint& point) {
  return point.realizations > 0 && point.mu > 0;
}

/// Returns the position of a point on the axis of its curve.
double axisPosition(const CurvePoint& point, const Scene& scene) {
  return scene.sweep.isOfVelocity() ? point.velocity : point.swept;
}

/// The points of the curve next to a position, which are the same where a point lies on it; null
/// where there is none on that side.
struct Neighbours {
  const CurvePoint *below = nullptr, *above = nullptr;
};

Neighbours findNeighbours(const CurveUpdate& curve, double position) {
  Neighbours found;
  const auto at = [&](const CurvePoint* point) { return axisPosition(*point, *curve.scene); };
  for (const CurvePoint& point : curve.points) {
    if (!isKnown(point)) continue;
    const double here = at(&point);
    if (here <= position && (!found.below || here > at(found.below))) found.below = &point;
    if (here >= position && (!found.above || here < at(found.above))) found.above = &point;
  }
  return found;
}

/// Returns whether two velocities of a curve are more than a decade apart: friction may do anything
/// between them, which a straight line does not show.
bool areFarApart(const CurvePoint& below, const CurvePoint& above) {
  constexpr double kFarApart = 10 * (1 + 1e-9);
  return std::isnan(below.swept) && above.velocity > kFarApart * below.velocity;
}

/// Interpolates along a straight line between two points of the diagram.
void readMean(const CurveUpdate& curve, double position, CurveReading& reading) {
  const auto [below, above] = findNeighbours(curve, position);
  if (!below || !above || areFarApart(*below, *above)) return;
  reading.lines = std::min(below->realizations, above->realizations);
  const double from = axisPosition(*below, *curve.scene), to = axisPosition(*above, *curve.scene);
  if (from == to) {
    reading.mu = above->mu;
    reading.error = above->muStandardError;
    return;
  }
  reading.isInterpolated = true;
  const double share =
      from > 0 ? std::log(position / from) / std::log(to / from) : (position - from) / (to - from);
  reading.mu = below->mu * std::pow(above->mu / below->mu, share);
  reading.error = std::lerp(below->muStandardError, above->muStandardError, share);
}

/// Returns the notes of both neighbours of the position, or of the nearest end of the curve.
NoteSet notesAt(const CurveUpdate& curve, double position) {
  const auto [below, above] = findNeighbours(curve, position);
  NoteSet notes;
  if (below && above && areFarApart(*below, *above)) return notes;
  for (const CurvePoint* point : {below, above})
    if (point) notes.add(point->notes);
  return notes;
}

std::string regionAt(const CurveUpdate& curve, double velocity) {
  const auto [below, above] = findNeighbours(curve, velocity);
  if (below && above && areFarApart(*below, *above)) return {};
  for (const CurveRegion& region : findRegions(*curve.scene, curve.points))
    if (velocity >= region.from && velocity <= region.to) return region.name;
  return {};
}

}  // namespace

QString regionText(std::string_view name) {
  return CurveReadingText::tr("region %1, %2")
      .arg(fromUtf8(name), translatedText(regionWord(name)));
}

QString errorsInWords() {
  return CurveReadingText::tr(
      "The status line has the standard error of the mean at this velocity; the tab Accuracy has "
      "the error of the whole curve, the root mean square over its velocities.");
}

CurveReading readCurve(const Frame& frame, const CurveUpdate* curve) {
  const double velocity = frame.scene->sliding.velocity;
  CurveReading reading;
  if (frame.state.contactFraction >= 1)
    reading.regime = CurveReadingText::tr("complete contact");
  else if (velocity == 0 && !frame.transient)
    reading.regime = CurveReadingText::tr("at rest");
  const bool isSameScene = curve && haveSameCurve(*frame.scene, *curve->scene);
  const bool isOfVelocity = frame.scene->sweep.isOfVelocity();
  if (isSameScene) {
    reading.notes =
        notesAt(*curve, isOfVelocity ? std::abs(frame.velocity) : ownSweptValue(*frame.scene));
    reading.missedTarget = curve->missedTarget;
  }
  reading.notes.add(Note::FasterThanTested,
                    std::max(velocity, std::abs(frame.velocity)) > kFastestTested);
  if (!isSameScene || velocity <= 0 || frame.transient) return reading;
  readMean(*curve, isOfVelocity ? velocity : ownSweptValue(*frame.scene), reading);
  if (isOfVelocity && reading.regime.isEmpty() && curve->isComplete)
    reading.region = regionAt(*curve, velocity);
  if (!reading.region.empty()) reading.regime = regionText(reading.region);
  return reading;
}

}  // namespace asperity
