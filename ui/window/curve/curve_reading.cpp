#include "ui/window/curve/curve_reading.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <string>

#include "core/chart/curve_regions.h"
#include "ui/chart/friction_chart_model.h"
#include "ui/language/translated.h"
#include "ui/panels/number_text.h"

namespace asperity {

namespace {

struct CurveReadingText {
  Q_DECLARE_TR_FUNCTIONS(asperity::CurveReadingText)
};

bool isKnown(const CurvePoint& point) {
  return point.realizations > 0 && point.mu > 0;
}

/// Interpolates along a straight line between two points of the diagram.
void interpolate(const CurvePoint& a, const CurvePoint& b, double velocity, CurveReading& reading) {
  const double share = std::log(velocity / a.velocity) / std::log(b.velocity / a.velocity);
  reading.mu = a.mu * std::pow(b.mu / a.mu, share);
  reading.error = std::lerp(a.muStandardError, b.muStandardError, share);
}

void readMean(const CurveUpdate& curve, double velocity, CurveReading& reading) {
  const auto& points = curve.points;
  const auto above = std::ranges::lower_bound(points, velocity, {}, &CurvePoint::velocity);
  if (above == points.end() || !isKnown(*above)) return;
  if (above->velocity == velocity) {
    reading.mu = above->mu;
    reading.error = above->muStandardError;
  } else if (above != points.begin() && isKnown(*(above - 1))) {
    interpolate(*(above - 1), *above, velocity, reading);
  }
}

QString regionAt(const CurveUpdate& curve, double velocity) {
  for (const CurveRegion& region : regionsOfCurve(*curve.scene, curve.points))
    if (velocity >= region.from && velocity <= region.to)
      return CurveReadingText::tr("region %1, %2")
          .arg(QString::fromStdString(region.name), translatedText(wordOfRegion(region.name)));
  return {};
}

}  // namespace

CurveReading readCurve(const Frame& frame, const CurveUpdate* curve) {
  const double velocity = frame.scene->sliding.velocity;
  CurveReading reading;
  if (frame.contactFraction >= 1)
    reading.regime = CurveReadingText::tr("full contact");
  else if (velocity == 0 && !frame.transient)
    reading.regime = CurveReadingText::tr("at rest");
  const bool isOfThisScene = curve && haveSameCurve(*frame.scene, *curve->scene);
  if (!isOfThisScene || velocity <= 0 || frame.transient) return reading;
  readMean(*curve, velocity, reading);
  if (reading.regime.isEmpty() && curve->isComplete) reading.regime = regionAt(*curve, velocity);
  return reading;
}

}  // namespace asperity
