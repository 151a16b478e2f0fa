#include "core/accuracy/pilot.h"

#include <algorithm>
#include <cmath>

#include "core/contact/steady_sliding.h"
#include "core/friction/curve_point.h"
#include "core/friction/ensemble.h"
#include "core/friction/line_mean.h"
#include "core/material/element_law.h"
#include "core/scene/plan.h"

namespace asperity {
namespace {

constexpr std::int64_t kMinElements = 64;
constexpr double kTimedVelocities = 41, kTimedLines = 2;
constexpr double kOperationsOfRow = 18;  // to read one row of a profile's file
constexpr double kBytesOfRow = 56;       // of a row in a file: its text and two numbers
constexpr double kOfProgram = 3e6;       // bytes that threads and transforms of any run need

/// Returns the sum of j^-power over j = first ... last, to about 1e-6.
double sumOfPowers(double first, double last, double power) {
  constexpr double kExact = 256;  // number of terms that are added; an integral gives the rest
  double sum = 0, j = first;
  for (; j <= last && j < first + kExact; ++j) sum += std::pow(j, -power);
  if (j > last) return sum;
  const double from = j - 0.5, to = last + 0.5;
  return sum + (power == 1 ? std::log(to / from)
                           : (std::pow(from, 1 - power) - std::pow(to, 1 - power)) / (power - 1));
}

/// Returns the relative sum of the spectrum over a line's modes; the spectrum is flat below the
/// roll-off.
double sumOfModes(const Surface& surface) {
  const double last = std::floor((static_cast<double>(surface.elements) - 1) / 2);
  const double rollOff = rollOffMode(surface);
  const double power = 2 * surface.hurst + 1;
  const double flat = std::min(std::floor(rollOff), last);
  return flat * std::pow(std::max(rollOff, 1.0), -power) + sumOfPowers(flat + 1, last, power);
}

bool isIsolated(const Surface& surface) {
  return surface.kind == SurfaceKind::Wedge || surface.kind == SurfaceKind::Parabola;
}

/// Returns the operations of one balance per point of the line. They are a small part of the points
/// where blocks of the line are skipped; a pass visits elements with arms one by one, several
/// times.
double operationsOfBalance(const Scene& scene) {
  const ElementLaw law = elementLaw(scene.elastomer);
  if (law.kind() != ElementKind::Arms) return 0.1;
  return 3 * (1 + static_cast<double>(law.arms.size()));
}

/// The size of a pilot, which is reduced step by step.
struct PilotSize {
  double lines, refinedLines, velocities;
  double perPoint(double balance) const {
    return (lines + 2 * refinedLines) * (1 + balance * velocities);
  }
};
/// Four lines at least: two of them agree by chance to a tenth of their spread in one case of
/// twelve, and how alike neighbouring rows of a topography are shows in two pairs
/// (varianceOfMean).
constexpr PilotSize kPilotSizes[] = {{24, 12, 9}, {16, 8, 9}, {8, 4, 9}, {8, 4, 5},
                                     {6, 2, 5},   {4, 2, 5},  {4, 1, 5}, {4, 1, 3}};

}  // namespace

PilotScene::PilotScene(const Scene& runScene, const LineExtent& extent)
    : scene(runScene), rows(extent.rows), rowsOfFile(extent.rows), lines(extent.lines) {
  scene.surface.length = extent.length;
  scene.surface.elements = extent.elements;
  scene.load = loadOn(scene.load, extent.length);
}

double PilotScene::operations(double perPoint, double points) const {
  return elements() * points * perPoint + static_cast<double>(rows) * kOperationsOfRow;
}

std::unique_ptr<const Profile> PilotScene::profile() const {
  if (rows == 0) return nullptr;
  auto profile = std::make_unique<Profile>(readProfileStart(scene, rows));
  std::vector<double>& height = profile->height;
  if (rows == rowsOfFile) return profile;
  const double slope = (height.back() - height.front()) / static_cast<double>(height.size());
  for (std::size_t i = 0; i < height.size(); ++i) height[i] -= slope * static_cast<double>(i);
  return profile;
}

PilotScene shortened(const PilotScene& whole, std::int64_t factor) {
  PilotScene part = whole;
  Surface& surface = part.scene.surface;
  const Surface& all = whole.scene.surface;
  if (factor <= 1) return part;
  const std::int64_t wanted = std::max(all.elements / factor, kMinElements);
  if (wanted >= all.elements) return part;
  surface.elements = wanted;
  if (isIsolated(surface)) return part;
  const double share = static_cast<double>(wanted) / static_cast<double>(all.elements);
  surface.length *= share;
  part.scene.load.normalForce *= share;
  if (surface.kind == SurfaceKind::Profile) {
    part.rows = std::max(std::llround(share * static_cast<double>(whole.rows)), 3LL);
    return part;
  }
  if (surface.kind == SurfaceKind::Sine) {
    const double waves = std::round(static_cast<double>(surface.waves) * share);
    surface.waves =
        static_cast<std::int64_t>(std::clamp(waves, 1.0, static_cast<double>((wanted - 1) / 2)));
    return part;
  }
  // The remaining waves keep their strength: one of them represents 1 / share of the line's waves.
  surface.rmsHeight *=
      std::pow(share, surface.hurst) * std::sqrt(sumOfModes(surface) / sumOfModes(all));
  return part;
}

PilotScene sampleWithin(const PilotScene& whole, double perPoint, double points, double allowed) {
  PilotScene sample = whole;
  for (std::int64_t factor = 2; sample.operations(perPoint, points) > allowed; factor *= 2) {
    PilotScene shorter = shortened(whole, factor);
    if (shorter.elements() >= sample.elements()) break;
    sample = std::move(shorter);
  }
  return sample;
}

std::vector<std::int64_t> sampledLines(const LineSource& source, std::int64_t count) {
  const std::int64_t rows = source.orderedRows();
  std::vector<std::int64_t> lines;
  for (std::int64_t i = 0; i < count; ++i)
    lines.push_back(rows <= count ? i : i / 2 * 2 * rows / count + i % 2);
  return lines;
}

double varianceOfMean(const std::vector<double>& values, const LineSource& source, double lines) {
  const std::int64_t rows = source.orderedRows();
  RunningMean all;
  for (const double value : values) all.add(value);
  if (rows == 0) return all.variance() / lines;
  if (rows <= std::ssize(values)) {
    const double error = errorOfCorrelatedMean(values).standardError;
    return error * error;
  }
  const double variance = all.variance();
  if (!(variance > 0)) return 0;
  double square = 0;
  for (std::size_t i = 1; i < values.size(); i += 2)
    square += (values[i] - values[i - 1]) * (values[i] - values[i - 1]);
  const double ofDifference = square / static_cast<double>(values.size() / 2);
  const double correlation = std::clamp(1 - ofDifference / (2 * variance), 0.0, 1.0);
  const double alike = (1 + correlation) / static_cast<double>(rows);
  return variance * (alike < 1 - correlation ? alike / (1 - correlation) : 1);
}

PilotPlan planPilot(const Scene& scene, int threads) {
  const PilotScene whole(scene, lineExtent(scene));
  const auto lines = static_cast<double>(whole.lines);
  const auto velocities = static_cast<double>(scene.sweep.points);
  const auto points = static_cast<double>(curvePointsPerElement(scene));
  const double balance = operationsOfBalance(scene);
  PilotPlan plan{whole, whole};
  plan.runOperations = lines * whole.operations(1 + balance * velocities, points);
  const double wall = plan.runOperations / std::min(static_cast<double>(threads), lines);
  const double tenth = std::clamp(0.1 * wall, kShortPilot, kMaxPilot);
  double perPoint = 0;
  for (const PilotSize& size : kPilotSizes) {
    const PilotSize fitting{std::min(size.lines, lines),
                            std::min(size.refinedLines, std::min(size.lines, lines)),
                            std::min(size.velocities, velocities)};
    plan.lines = static_cast<std::int64_t>(fitting.lines);
    plan.refinedLines = static_cast<std::int64_t>(fitting.refinedLines);
    plan.velocities = logSpaced(scene.sweep.velocityFrom, scene.sweep.velocityTo,
                                static_cast<std::int64_t>(fitting.velocities));
    perPoint = fitting.perPoint(balance);
    if (whole.operations(perPoint, points) <= tenth) break;
  }
  const double allowed = std::max(tenth, kMinPilot);
  plan.sample = sampleWithin(whole, perPoint, points, allowed);
  // The resolution is that of the run, whatever the number of the pilot's elements.
  if (scene.accuracy.scheme != Scheme::Nodal)
    plan.sample.scene.accuracy.oversampling = static_cast<std::int64_t>(points);
  const double timed = std::min(velocities, kTimedVelocities);
  const double withTimed = perPoint + kTimedLines * (1 + balance * timed);
  if (plan.sample.operations(withTimed, points) <= tenth) {
    perPoint = withTimed;
    plan.timedVelocities = logSpaced(scene.sweep.velocityFrom, scene.sweep.velocityTo,
                                     static_cast<std::int64_t>(timed));
  }
  plan.shortening = whole.elements() / plan.sample.elements();
  plan.operations = plan.sample.operations(perPoint, points);
  return plan;
}

double curveMemory(const PilotScene& run, int threads, std::int64_t finest) {
  const Scene& scene = run.scene;
  const bool isRandom = mayHaveManyLines(scene.surface);
  const auto lines = static_cast<double>(run.lines);
  const double parallel = std::min(static_cast<double>(threads), lines);
  const Scheme scheme = scene.accuracy.scheme;
  const double elements = run.elements(), nodes = elements * static_cast<double>(finest);
  constexpr double kNumber = sizeof(double);
  // Memory in numbers per node: Line, PreparedProfile with its blocks, and the buffers of the
  // transform.
  const double ofLine = scheme == Scheme::Linear && isRandom ? 1 : 2;
  const double ofProfile = scheme == Scheme::Cubic    ? 3 + 5 * 4.0 / 3
                           : scheme == Scheme::Linear ? 2 + 5 / 3.0
                                                      : 2 + 4 / 3.0;
  const double ofTransform = isRough(scene.surface) ? 2 : 0;
  double bytes = kOfProgram + (ofLine + ofProfile) * nodes * kNumber * parallel;
  bytes += ofTransform * nodes * kNumber * (isRandom ? parallel : 1);
  if (isRandom) bytes += (0.5 + parallel) * elements * kNumber;  // amplitudes and phases
  if (!isRandom) bytes += 2 * nodes * kNumber;                   // for the only line
  // The text of a file and its numbers are freed before the line is made.
  bytes = std::max(bytes, kOfProgram + kBytesOfRow * static_cast<double>(run.rows));
  if (needsStage(scene, Purpose::Curve, Stage::SummitCorrelation))
    bytes += 18 * elements * kNumber * parallel;  // its transform at four nodes per element
  // Results of a batch of 32 lines wait for their turn, and those of the first are kept.
  const auto points = static_cast<double>(scene.sweep.points);
  return bytes + points * ((std::min(lines, 32.0) + 1) * sizeof(SteadyResult) +
                           sizeof(CurveAverages) + sizeof(CurvePoint));
}

}  // namespace asperity
