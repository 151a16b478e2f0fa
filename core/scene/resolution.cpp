// The resolution of lines where the scene leaves it open. The choice depends only on the scene,
// without a pilot, so that it costs nothing and is the same everywhere.
//
// Source of the numbers: 96 random lines of 5000 elements for each of seven Hurst exponents, seven
// loads and 17 velocities, contact from 1e-6 of the line to all of it, `cubic` compared with 32
// points per element. The friction of one line varies by 5 to 30 % about the mean, and less if more
// of the line is in contact; in complete contact all lines agree. The mean over many lines has an
// error of 0.33 % (H = 0) to 0.05 % (H = 1) at x2, and a tenth of that at x4. A line takes 12 to 25
// % longer at x4 than at x2; more lines could use this time to reduce the standard error: so the
// finer line is better if its error exceeds half of the standard error.
#include <algorithm>
#include <cmath>

#include "core/scene/motion.h"
#include "core/scene/scene.h"

namespace asperity {
namespace {

constexpr std::int64_t kPointsOfOneLine = 4;
/// Straight segments converge only at second order.
constexpr std::int64_t kStraightPoints = 8;
/// Elements that are marched in time converge at second order, and chance decides where a contact
/// ends between two of them; so a small motion, which costs nothing, gets more of them.
constexpr std::int64_t kMaxPointsOfMarch = 32;
constexpr double kSmallMarch = 5e6;                         // steps times points: some 25 ms
constexpr std::int64_t kMaxPoints = std::int64_t{1} << 25;  // of a line: 3 GB
constexpr double kPartOfStandardError = 0.5;

LineSize statedSize(const Scene& scene) {
  return {scene.surface.length, scene.surface.elements};
}

/// Limits the points so that the line fits the memory of usual machines.
std::int64_t withinMemory(std::int64_t elements, std::int64_t points) {
  while (points > 1 && elements * points > kMaxPoints) points /= 2;
  return points;
}
std::int64_t withinMemory(const Scene& scene, std::int64_t points) {
  return withinMemory(scene.surface.elements, points);
}

/// Returns the resolution that the scene prescribes: a number, the paper's elements, or a target.
/// 0: automatic.
std::int64_t statedPoints(const Scene& scene) {
  const Accuracy& accuracy = scene.accuracy;
  if (accuracy.scheme == Scheme::Nodal) return 1;
  if (!choosesAccuracy(scene)) return accuracy.oversampling;
  const double target = accuracy.targetRelativeError;
  return withinMemory(scene, target >= 0.01 ? 4 : target >= 1e-3 ? 8 : 16);
}

/// Returns whether the points of a motion follow from its cost.
bool choosesPointsOfMarch(const Scene& scene) {
  return scene.sliding.kind != SlidingKind::Steady && scene.accuracy.scheme != Scheme::Nodal &&
         (choosesAccuracy(scene) || scene.accuracy.oversampling == 0);
}

/// Returns the mean depth to which the elastomer is pressed at rest, over the rms height. Contact
/// begins at 0 and is complete above 3 to 4.
double depthOverHeight(const Scene& scene) {
  constexpr double kLowestPoint = 3.3;  // rms heights below the mean of a random line
  constexpr double kDeep = 1e3;         // for lines without load and lines without roughness
  const double height = scene.surface.rmsHeight;
  if (!(height > 0)) return kDeep;
  if (scene.load.kind == LoadKind::Indentation)
    return std::clamp(scene.load.depth / height - kLowestPoint, 0.0, kDeep);
  const Elastomer& elastomer = scene.elastomer;
  const double modulus =
      hasArms(elastomer.rheology) ? elastomer.equilibriumModulus : elastomer.shearModulus;
  const double carried = 4 * modulus * scene.surface.length * height;  // N
  const double force = loadOn(scene.load, scene.surface.length).normalForce;
  return force < kDeep * carried ? force / carried : kDeep;
}

/// Returns the relative standard deviation of the friction of one line at the velocity where it is
/// smallest, which is a low velocity.
double spreadOfLines(const Scene& scene) {
  return 0.1 / (1 + 8 * depthOverHeight(scene));
}

/// Returns the relative error of the mean over many lines.
double errorOfMean(const Scene& scene, std::int64_t points) {
  const double atTwo = 3.4e-3 - 2.6e-3 * scene.surface.hurst;
  return atTwo * std::pow(2 / static_cast<double>(points), 3);
}

/// Returns the number of independent parts of line, in all realizations together.
double independentLines(const Scene& scene) {
  return static_cast<double>(scene.ensemble.realizations) *
         std::max(1.0, rollOffMode(scene.surface));
}

/// Returns the largest resolution at which the march of a motion is small; the usual one where
/// none is, or where the size of the line is unknown.
std::int64_t marchedPoints(const Scene& scene, const LineSize& line) {
  const auto elements = static_cast<double>(line.elements);
  std::int64_t points = kPointsOfOneLine;
  if (!(elements > 0) || !(line.length > 0)) return points;
  const Motion motion(scene.sliding);
  const double slid = motion.fastest(0, motion.duration()) * motion.duration();
  const double periods = motion.isSmooth() ? scene.sliding.frequency * motion.duration() : 0;
  const double leastSteps = std::max<double>(Motion::kMinSteps, Motion::kStepsOfPeriod * periods);
  const double modes = hasArms(scene.elastomer.rheology)
                           ? std::max(1.0, static_cast<double>(scene.elastomer.arms.size()))
                           : 1;
  const auto workAt = [&](std::int64_t pointsThere) {
    const double nodes = elements * static_cast<double>(pointsThere);
    return std::max(leastSteps, slid / line.length * nodes) * nodes * modes;
  };
  while (points < kMaxPointsOfMarch && workAt(2 * points) <= kSmallMarch) points *= 2;
  return points;
}

}  // namespace

std::int64_t pointsPerElement(const Scene& scene, const LineSize& line) {
  const std::int64_t stated = statedPoints(scene);
  // Elements that are marched in time do not use the segments between them. A target is that of
  // steady states, and never gives a motion fewer points.
  if (choosesPointsOfMarch(scene))
    return std::max(stated, withinMemory(line.elements, marchedPoints(scene, line)));
  if (stated > 0) return stated;
  const bool isStraight = scene.accuracy.scheme == Scheme::Linear;
  return withinMemory(scene, isStraight ? kStraightPoints : kPointsOfOneLine);
}

std::int64_t pointsPerElement(const Scene& scene) {
  return pointsPerElement(scene, statedSize(scene));
}

bool needsSizeOfFile(const Scene& scene) {
  return choosesPointsOfMarch(scene) && hasSurfaceFile(scene.surface) &&
         (scene.surface.elements == 0 || scene.surface.length == 0);
}

std::int64_t curvePointsPerElement(const Scene& scene) {
  if (const std::int64_t stated = statedPoints(scene); stated > 0) return stated;
  if (scene.accuracy.scheme == Scheme::Linear) return withinMemory(scene, kStraightPoints);
  // Of measured rows and of spectra neither height nor Hurst exponent stands in the scene.
  const bool isOneLine =
      scene.surface.kind != SurfaceKind::SelfAffine || scene.ensemble.realizations == 1;
  if (isOneLine) return withinMemory(scene, kPointsOfOneLine);
  const double allowed =
      kPartOfStandardError * spreadOfLines(scene) / std::sqrt(independentLines(scene));
  std::int64_t points = 2;
  while (points < 8 && !(errorOfMean(scene, points) <= allowed)) points *= 2;
  return withinMemory(scene, points);
}

void fixResolution(Scene& scene) {
  if (scene.accuracy.scheme != Scheme::Nodal && scene.accuracy.oversampling == 0)
    scene.accuracy.oversampling = curvePointsPerElement(scene);
}

}  // namespace asperity
