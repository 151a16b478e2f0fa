#include "core/friction/few_summits.h"

#include <cmath>
#include <numbers>

#include "core/scene/element_law.h"

namespace asperity {

double climbedHeight(double normalForce, double viscosity, double velocity) {
  return normalForce / (4 * viscosity * velocity);
}

double fewSummitsVelocity(const Scene& scene, double rmsHeight) {
  const bool isRough =
      scene.surface.kind == SurfaceKind::SelfAffine || scene.surface.kind == SurfaceKind::Profile;
  const ElementLaw law = lawOf(scene.elastomer);
  if (!isRough || !(rmsHeight > 0) || scene.load.kind != LoadKind::Force ||
      law.kind() != ElementKind::Kelvin)
    return kNotApplicable;
  return scene.load.normalForce / (4 * law.viscosity * kFewSummits * rmsHeight);
}

double fewSummitsVelocity(const Scene& scene, std::span<const CurvePoint> points) {
  const ElementLaw law = lawOf(scene.elastomer);
  for (const CurvePoint& point : points) {
    // Eq. (13) solved for h.
    const double slope = point.mu / point.normalizedMu;
    const double height = law.relaxationTime * point.velocity * slope /
                          (std::numbers::sqrt2 * point.dimensionlessVelocity);
    if (std::isfinite(height)) return fewSummitsVelocity(scene, height);
  }
  return kNotApplicable;
}

void addFewSummits(Diagram& diagram, double velocity, double last) {
  if (velocity < last) diagram.shades.push_back({velocity, last, "few summits carry the load"});
}

}  // namespace asperity
