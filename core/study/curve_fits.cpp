#include "core/study/curve_fits.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/chart/curve_regions.h"
#include "core/friction/curve_features.h"
#include "core/material/element_law.h"

namespace asperity {
namespace {

/// The points of a curve whose values have a logarithm, with x ascending.
struct KnownCurve {
  std::vector<double> x, mu;
  std::vector<CurvePoint> points;

  KnownCurve(std::span<const double> values, std::span<const CurvePoint> all) {
    const bool isDescending = values.size() > 1 && values.front() > values.back();
    for (std::size_t k = 0; k < values.size(); ++k) {
      const std::size_t i = isDescending ? values.size() - 1 - k : k;
      if (!std::isfinite(all[i].mu) || !(all[i].mu > 0) || !(values[i] > 0)) continue;
      x.push_back(values[i]);
      mu.push_back(all[i].mu);
      points.push_back(all[i]);
    }
  }

  std::size_t size() const { return x.size(); }
  std::size_t highest() const {
    return static_cast<std::size_t>(std::ranges::max_element(mu) - mu.begin());
  }
  /// Returns whether the point and its neighbours have equal distances in ln x, as a parabola
  /// through them needs. The points of whole numbers and of a linear axis do not.
  bool isEvenAround(std::size_t i) const {
    constexpr double kEven = 1e-6;
    const double before = std::log(x[i] / x[i - 1]), after = std::log(x[i + 1] / x[i]);
    return std::abs(after / before - 1) < kEven;
  }
};

double& at(CurveFitValues& values, CurveFit fit) {
  return values[static_cast<std::size_t>(fit)];
}

/// Returns the fit that stands `count` entries after this one.
CurveFit after(CurveFit first, std::size_t count) {
  return static_cast<CurveFit>(static_cast<std::size_t>(first) + count);
}

/// Returns ln x where the curve passes `level` beside its highest point, by a straight line between
/// logarithms; NaN where it does not fall to the level on this side. step: 1 to the right, -1 to
/// the left.
double passing(const KnownCurve& curve, std::size_t top, double level, int step) {
  for (std::size_t i = top; step > 0 ? i + 1 < curve.size() : i > 0;) {
    const std::size_t next = step > 0 ? i + 1 : i - 1;
    if (curve.mu[next] <= level) {
      const double above = std::log(curve.mu[i] / level), below = std::log(level / curve.mu[next]);
      return std::lerp(std::log(curve.x[i]), std::log(curve.x[next]), above / (above + below));
    }
    i = next;
  }
  return kNotApplicable;
}

void addMaximum(const KnownCurve& curve, CurveFitValues& fits) {
  const std::size_t top = curve.highest();
  at(fits, CurveFit::Maximum) = curve.mu[top];
  if (top == 0 || top + 1 == curve.size()) return;  // the maximum may lie beyond the curve
  CurveMaximum maximum{curve.x[top], curve.mu[top]};
  if (curve.isEvenAround(top)) maximum = curveMaximum(curve.x, curve.mu);
  at(fits, CurveFit::Maximum) = maximum.value;
  at(fits, CurveFit::PlaceOfMaximum) = maximum.x;
  const double left = passing(curve, top, maximum.value / 2, -1);
  const double right = passing(curve, top, maximum.value / 2, 1);
  if (std::isnan(left) || std::isnan(right)) return;
  at(fits, CurveFit::HalfWidth) = (right - left) / std::log(10.0);
}

void addRegions(const Scene& scene, const KnownCurve& curve, CurveFitValues& fits) {
  for (const CurveRegion& region : findRegions(scene, curve.points)) {
    const std::size_t number = regionNumber(region.name);
    std::vector<double> x, mu;
    double sum = 0;
    for (std::size_t i = 0; i < curve.size(); ++i)
      if (curve.x[i] >= region.from && curve.x[i] <= region.to) {
        x.push_back(curve.x[i]);
        mu.push_back(curve.mu[i]);
        sum += curve.mu[i];
      }
    if (number > 0 && region.from > curve.x.front())
      at(fits, after(CurveFit::BeginOfRegion2, number - 1)) = region.from;
    if (x.size() >= kMinFitted)
      at(fits, after(CurveFit::ExponentOfRegion1, number)) = fitPower(x, mu).slope;
    if (number == 2 && !x.empty())
      at(fits, CurveFit::Plateau) = sum / static_cast<double>(x.size());
  }
}

}  // namespace

CurveFitValues curveFits(const Scene& scene, std::span<const double> values,
                         std::span<const CurvePoint> points) {
  CurveFitValues fits;
  fits.fill(kNotApplicable);
  const KnownCurve curve(values, points);
  const bool isElastic = elementLaw(scene.elastomer).kind() == ElementKind::Elastic;
  if (isElastic || curve.size() < kMinFitted) return fits;
  addMaximum(curve, fits);
  const LineFit power = fitPower(curve.x, curve.mu);
  at(fits, CurveFit::Exponent) = power.slope;
  at(fits, CurveFit::ExponentResidual) = power.rmsResidual;
  if (scene.sweep.isOfVelocity()) addRegions(scene, curve, fits);
  return fits;
}

}  // namespace asperity
