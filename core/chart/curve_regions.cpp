#include "core/chart/curve_regions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/friction/ensemble.h"
#include "core/material/element_law.h"

namespace asperity {
namespace {

struct RegionText {
  std::string_view word, sentence;
};
/// In the order of kRegionNames.
constexpr std::array<RegionText, 4> kTexts{
    {{"linear",
      "Friction grows in proportion to velocity, Eqs. (5) to (8). Ends where the curve is 20 % "
      "below that line."},
     {"transition", "From the line to the plateau. Ends where 95 % of the maximum is reached."},
     {"plateau",
      "Contacts carry on their leading sides only, Eq. (9). Ends where friction falls below 95 % "
      "of the maximum."},
     {"decrease",
      "Few contacts of the finite period carry the load, and the slope in contact falls, "
      "Eq. (15). Begins below 95 % of the maximum."}}};

const RegionText* findRegionText(std::string_view name) {
  const std::size_t number = regionNumber(name);
  return number < kTexts.size() ? &kTexts[number] : nullptr;
}

/// The known part of a curve, where friction is positive and has a logarithm.
struct Known {
  std::vector<double> velocities, mu;

  /// Returns d ln mu / d ln v between two points.
  double exponent(std::size_t i) const {
    return std::log(mu[i + 1] / mu[i]) / std::log(velocities[i + 1] / velocities[i]);
  }
  std::size_t size() const { return mu.size(); }
};

/// Returns the points from which regions are found, whose velocities are evenly spaced in their
/// logarithm. Beside linearly spaced velocities such points have been computed for this purpose
/// (logVelocitiesBeside).
Known knownPart(const Scene& scene, std::span<const CurvePoint> points) {
  const std::vector<double> chosen = logVelocitiesBeside(scene.sweep);
  Known known;
  for (const CurvePoint& point : points)
    if (point.realizations > 0 && std::isfinite(point.mu) && point.mu > 0 && point.velocity > 0 &&
        (chosen.empty() || std::ranges::binary_search(chosen, point.velocity))) {
      known.velocities.push_back(point.velocity);
      known.mu.push_back(point.mu);
    }
  return known;
}

// In region I the exponent is 1; where Eq. (12) has reached 95 % of its plateau it is 0.1.
constexpr double kLinear = 0.9, kFlat = 0.1;

/// Collects regions from the curve's first velocity on, each beginning where the previous one ends.
class RegionSequence {
 public:
  explicit RegionSequence(const Known& known)
      : begin_(known.velocities.front()), end_(known.velocities.back()) {}

  /// Adds a region, which ends at the border or, if that is not on the curve, at the curve's end.
  void add(std::size_t number, double border) {
    const double end = std::isfinite(border) ? std::min(border, end_) : end_;
    if (!(end > begin_)) return;
    regions_.push_back({kRegionNames[number], begin_, end});
    begin_ = end;
  }
  std::vector<CurveRegion> take() { return std::move(regions_); }

 private:
  double begin_, end_;
  std::vector<CurveRegion> regions_;
};

std::vector<CurveRegion> splitIntoRegions(const Known& known) {
  enum { kI, kII, kIII, kIV };
  const RegionBorders borders = regionBorders(known.velocities, known.mu);
  const std::size_t last = known.size() - 1;
  const CurveMaximum top = curveMaximum(known.velocities, known.mu);
  RegionSequence regions(known);
  if (top.x == known.velocities[0] && known.exponent(0) < -kFlat) {
    regions.add(kIV, known.velocities[last]);
    return regions.take();
  }
  if (known.mu[0] < BorderRule{}.ofMaximum * top.value) {
    const bool isRising = top.x == known.velocities[last] && known.exponent(last - 1) > kFlat;
    const double toPlateau = isRising ? known.velocities[last] : borders.toPlateau;
    if (known.exponent(0) > kLinear)
      regions.add(kI, std::isfinite(borders.endOfLinear) ? std::min(borders.endOfLinear, toPlateau)
                                                         : toPlateau);
    regions.add(kII, toPlateau);
  }
  regions.add(kIII, borders.offPlateau);
  regions.add(kIV, known.velocities[last]);
  return regions.take();
}

}  // namespace

std::vector<CurveRegion> findRegions(const Scene& scene, std::span<const CurvePoint> points) {
  const Known known = knownPart(scene, points);
  if (known.size() < 3 || elementLaw(scene.elastomer).kind() != ElementKind::Kelvin) return {};
  return splitIntoRegions(known);
}

std::string_view regionWord(std::string_view name) {
  const RegionText* text = findRegionText(name);
  return text ? text->word : std::string_view();
}

std::string_view regionSentence(std::string_view name) {
  const RegionText* text = findRegionText(name);
  return text ? text->sentence : std::string_view();
}

double summedContactHeight(double normalForce, double viscosity, double velocity) {
  return normalForce / (4 * viscosity * velocity);
}

double fewContactsVelocity(const Scene& scene, double rmsHeight) {
  const ElementLaw law = elementLaw(scene.elastomer);
  if (!isRough(scene.surface) || !(rmsHeight > 0) || scene.load.kind != LoadKind::Force ||
      law.kind() != ElementKind::Kelvin)
    return kNotApplicable;
  return scene.load.normalForce / (4 * law.viscosity * kFewContactsHeight * rmsHeight);
}

double fewContactsVelocity(const Scene& scene, std::span<const CurvePoint> points) {
  const ElementLaw law = elementLaw(scene.elastomer);
  for (const CurvePoint& point : points) {
    if (point.normalizedMu == 0 || point.dimensionlessVelocity == 0) continue;  // an elastic body
    // This is Eq. (13) solved for h.
    const double slope = point.mu / point.normalizedMu;
    const double height = law.relaxationTime * point.velocity * slope /
                          (std::numbers::sqrt2 * point.dimensionlessVelocity);
    if (std::isfinite(height)) return fewContactsVelocity(scene, height);
  }
  return kNotApplicable;
}

std::optional<VelocityRange> fewContactsWithin(double velocity, double first, double last) {
  if (!std::isfinite(velocity) || velocity >= last) return std::nullopt;
  return VelocityRange{std::max(velocity, first), last};
}

std::optional<VelocityRange> fewContactsRange(const Scene& scene,
                                              std::span<const CurvePoint> points) {
  if (points.empty()) return std::nullopt;
  const auto [first, last] = std::ranges::minmax(points, {}, &CurvePoint::velocity);
  return fewContactsWithin(fewContactsVelocity(scene, points), first.velocity, last.velocity);
}

void addFewContacts(Diagram& diagram, const std::optional<VelocityRange>& range, double factor) {
  if (range)
    diagram.shades.push_back(
        {range->from * factor, range->to * factor, "few contacts carry the load"});
}

}  // namespace asperity
