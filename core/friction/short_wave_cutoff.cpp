#include "core/friction/short_wave_cutoff.h"

#include <algorithm>
#include <cmath>

#include "core/base/input_error.h"
#include "core/base/stop.h"
#include "core/scene/parameters.h"
#include "core/scene/scene_check.h"
#include "core/surface/line_source.h"
#include "core/surface/spectrum.h"

namespace asperity {
namespace {

constexpr double kStepsPerDecade = 4;
constexpr std::size_t kMinModes = 4;  // of a line that is still rough

/// Returns the rms height of the remaining waves over that of all. The waves stay the same, while
/// the rms height of a scene is that of its whole spectrum.
double heightOfModes(const Scene& scene, std::size_t modes) {
  const Surface& surface = scene.surface;
  const std::vector<double> all = selfAffineAmplitudes(static_cast<std::size_t>(surface.elements),
                                                       surface.hurst, 1, rollOffMode(surface));
  double square = 0;
  for (std::size_t j = std::min(modes, all.size()); j-- > 0;) square += all[j] * all[j] / 2;
  return std::sqrt(square);
}

/// Returns the scene with its waves up to this mode alone.
Scene cutAt(const Scene& scene, std::size_t modes, double wavelength) {
  Scene cut = scene;
  switch (scene.surface.kind) {
    case SurfaceKind::SelfAffine:
      cut.surface.rmsHeight *= heightOfModes(scene, modes);
      [[fallthrough]];
    case SurfaceKind::Profile:
      cut.surface.elements = static_cast<std::int64_t>(2 * modes + 1);
      break;
    default:
      cut.surface.processing.shortWaveCut = wavelength;
  }
  return cut;
}

/// Returns the mean of b - a over the lines, times a factor.
Estimate meanDifference(const std::vector<double>& a, const std::vector<double>& b, double factor,
                        std::int64_t orderedRows) {
  LineMean mean(orderedRows);
  for (std::size_t line = 0; line < a.size(); ++line) mean.add(factor * (b[line] - a[line]));
  return {mean.mean(), mean.error().standardError};
}

}  // namespace

std::vector<CutoffPoint> frictionOverCutoff(const Scene& scene, const StateOptions& options) {
  if (!isRough(scene.surface))
    throw InputError("", "surface.kind",
                     "has no short waves to remove; a random line, a profile, a spectrum or a "
                     "measured surface has");
  requireNoTarget(scene, "all cut-offs have the same lines");
  const LineExtent extent = lineExtent(scene);
  const std::size_t all = modeCount(static_cast<std::size_t>(extent.elements));
  const double before = hasSurfaceFile(scene.surface) && scene.surface.kind != SurfaceKind::Profile
                            ? scene.surface.processing.shortWaveCut
                            : 0;
  std::vector<CutoffPoint> points;
  std::vector<Scene> states;
  // The resolution that the program chooses must not change from cut to cut.
  Scene whole = scene;
  fixResolution(whole);
  std::size_t last = all + 1;
  for (int step = 0;; ++step) {
    const auto modes = static_cast<std::size_t>(
        std::llround(static_cast<double>(all) * std::pow(10, -step / kStepsPerDecade)));
    if (modes < kMinModes && step > 0) break;
    if (modes == last) continue;
    last = modes;
    const double wavelength = extent.length / static_cast<double>(std::max<std::size_t>(modes, 1));
    // The scene's own cut-off removes all shorter waves.
    if (step > 0 && wavelength <= before) continue;
    CutoffPoint point;
    point.wavelength = step == 0 ? std::max(wavelength, before) : wavelength;
    points.push_back(point);
    states.push_back(step == 0 ? whole : cutAt(whole, modes, wavelength));
  }
  std::ranges::reverse(points);
  std::ranges::reverse(states);
  StateOptions keeping = options;
  keeping.keepsLines = true;
  const SteadyStates found = slideStates(states, keeping);
  if (!found.isComplete) throw StopRequested{};
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i].state = found.points[i];
    const double full = found.points.back().mu;
    if (i == 0 || !(full > 0)) continue;
    const double decades = std::log10(points[i - 1].wavelength / points[i].wavelength);
    points[i].shareOfDecade = meanDifference(found.muOfLines[i - 1], found.muOfLines[i],
                                             1 / (full * decades), found.orderedRows[i]);
  }
  return points;
}

}  // namespace asperity
