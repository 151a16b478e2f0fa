#include "core/friction/curve_averages.h"

#include <cmath>

#include "core/friction/law.h"
#include "core/scene/plan.h"

namespace asperity {

void CurveAverages::add(const SteadyResult& result) {
  if (std::isfinite(result.mu)) mu.add(result.mu);
  if (std::isfinite(result.muInterface)) muInterface.add(result.muInterface);
  contactFraction.add(result.contactFraction);
  indentation.add(result.indentation);
  normalForce.add(result.normalForce);
  marginalShare.add(result.marginalShare);
  if (std::isfinite(result.rmsSlopeContact)) rmsSlopeContact.add(result.rmsSlopeContact);
}

CurvePoint CurveAverages::point(double velocity) const {
  CurvePoint point;
  point.velocity = velocity;
  point.mu = mu.mean();
  point.muStandardError = mu.standardError();
  point.muInterface = muInterface.mean();
  point.contactFraction = contactFraction.mean();
  point.rmsSlopeContact = rmsSlopeContact.mean();
  point.indentation = indentation.mean();
  point.marginalShare = marginalShare.mean();
  point.realizations = mu.count();
  return point;
}

LawColumns::LawColumns(const Scene& scene, const LineSource& source)
    : scene_(scene),
      line_(source.statistics()),
      length_(source.length()),
      isRandom_(source.isRandom()),
      hasArms_(callsFor(scene, Purpose::Curve, Stage::Arms)),
      hasInterface_(callsFor(scene, Purpose::Curve, Stage::Interface)) {}

void LawColumns::addTo(CurvePoint& point, double meanForce) const {
  if (!hasInterface_) point.muInterface = kNotApplicable;
  const Accuracy& accuracy = scene_.accuracy;
  if (accuracy.scheme != Scheme::Nodal || accuracy.targetRelativeError > 0)
    point.marginalShare = kNotApplicable;
  if (!(line_.rmsHeight > 0)) return;
  const SlidingConditions conditions = conditionsOf(scene_, point.velocity);
  const double force = scene_.load.kind == LoadKind::Force ? scene_.load.normalForce : meanForce;
  const LawInput in{conditions.shearModulus, conditions.relaxationTime, length_, line_.rmsHeight,
                    line_.rmsSlope,          scene_.surface.hurst,      force,   point.velocity};
  point.normalizedMu = point.mu / line_.rmsSlope;
  point.dimensionlessForce = dimensionlessForce(in);
  if (hasArms_) return;  // Eqs. (5) to (14) know one relaxation time
  point.dimensionlessVelocity = dimensionlessVelocity(in);
  if (isRandom_) point.muLaw = frictionLaw(in);
}

}  // namespace asperity
