#include "core/chart/few_summits.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/material/element_law.h"

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

std::optional<VelocityRange> fewSummitsWithin(double velocity, double first, double last) {
  if (!std::isfinite(velocity) || velocity >= last) return std::nullopt;
  return VelocityRange{std::max(velocity, first), last};
}

std::optional<VelocityRange> fewSummitsOf(const Scene& scene, std::span<const CurvePoint> points) {
  if (points.empty()) return std::nullopt;
  const auto [first, last] = std::ranges::minmax(points, {}, &CurvePoint::velocity);
  return fewSummitsWithin(fewSummitsVelocity(scene, points), first.velocity, last.velocity);
}

void addFewSummits(Diagram& diagram, const std::optional<VelocityRange>& range, double factor) {
  if (range)
    diagram.shades.push_back(
        {range->from * factor, range->to * factor, "few summits carry the load"});
}

}  // namespace asperity
