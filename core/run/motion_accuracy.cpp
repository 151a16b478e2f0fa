#include "core/run/motion_accuracy.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/accuracy/pilot.h"
#include "core/base/jobs.h"
#include "core/base/statistics.h"
#include "core/base/stop.h"
#include "core/material/element_law.h"
#include "core/run/rigid_line.h"
#include "core/run/transient.h"

namespace asperity {
namespace {

constexpr double kPieceWork = 3e6;  // steps times elements of a piece for each region
// Work of a pilot in units of the march as it is: 1 for itself, 2 with half the step, 4 with twice
// the elements, 2 for settling.
constexpr double kMarches = 9;
/// Steps times elements of a pilot: a tenth of the motion, at least about 20 ms and at most 0.2 s.
constexpr double kMinWork = 2.5e6, kMaxWork = 1.5e7;
constexpr double kWindow = 16;     // number of steps over which friction is averaged
constexpr double kMinWindows = 8;  // of a piece, at least
/// The number of longest retardation times after which the initial state no longer matters.
constexpr double kRetardationTimes = 6;
constexpr int kEnds = 2;  // number of windows at either end of settling

/// A motion or its first part, cut so that steps keep their length.
struct Piece {
  Scene scene;
  const Profile* profile = nullptr;  // replaces the one in the scene's file
  std::int64_t leastSteps = Transient::kMinSteps;
  double windows = 1;
};

double nodesOf(const RigidLine& rigid) {
  return static_cast<double>(rigid.line->nodes());
}

/// Returns `part` of the motion, as a multiple of one over its minimum number of steps; if it has
/// far more steps than that, any part is possible, because the minimum does not limit the length of
/// a step.
Piece pieceOf(const Scene& scene, double steps, double part, const Profile* profile = nullptr) {
  Piece piece{scene, profile};
  const auto all = static_cast<double>(Transient::kMinSteps);
  const double kept = part * all < 1 ? part * all : std::min(std::ceil(part * all), all);
  piece.leastSteps = std::max<std::int64_t>(1, static_cast<std::int64_t>(kept));
  piece.scene.sliding.duration *= kept / all;
  piece.windows = std::max(1.0, std::floor(steps * kept / all / kWindow));
  return piece;
}

/// Returns the cost of an element in a step, relative to one relaxation time.
double weightOf(const ElementLaw& law) {
  return law.kind() == ElementKind::Arms ? 1 + static_cast<double>(law.arms.size()) : 1;
}

/// Friction in the windows of a piece, and the work of computing them.
struct March {
  std::vector<double> mu;
  double forceError = 0;  // relative, largest
  double seconds = 0;     // of the steps, processor time
  double steps = 0;
};

March marchThrough(const Piece& piece, const std::shared_ptr<const RigidLine>& rigid, int division,
                   const std::stop_token& stop) {
  Transient transient(piece.scene, rigid, piece.leastSteps, division);
  March march;
  const double begin = threadSeconds();
  for (double i = 1; i <= piece.windows; ++i) {
    throwIfStopped(stop);
    const TransientSample sample =
        transient.marchTo(piece.scene.sliding.duration * i / piece.windows);
    march.mu.push_back(sample.mu);
    if (piece.scene.load.kind != LoadKind::Indentation)
      march.forceError = std::max(
          march.forceError,
          std::abs(sample.normalForce / loadOn(piece.scene.load, rigid->line->length).normalForce -
                   1));
  }
  march.seconds = threadSeconds() - begin;
  march.steps = static_cast<double>(transient.steps());
  return march;
}

/// Returns the root mean square of the difference over that of the better one; windows at rest do
/// not count.
double relativeDifference(const std::vector<double>& mu, const std::vector<double>& better) {
  double differences = 0, all = 0;
  for (std::size_t i = 0; i < std::min(mu.size(), better.size()); ++i) {
    if (!std::isfinite(mu[i]) || !std::isfinite(better[i])) continue;
    differences += (mu[i] - better[i]) * (mu[i] - better[i]);
    all += better[i] * better[i];
  }
  return all > 0 ? std::sqrt(differences / all) : kNotApplicable;
}

/// Returns the scene with twice the points; for separate elements the resolved line.
Scene refined(const Scene& scene) {
  Scene fine = scene;
  const Scheme scheme =
      scene.accuracy.scheme == Scheme::Nodal ? Scheme::Cubic : scene.accuracy.scheme;
  fine.accuracy = {scheme, 2 * linePoints(scene), 0};
  return fine;
}

/// Returns the difference of friction at the beginning from that after the distance in which memory
/// fades, or as much of it as `work` allows. Friction in steady sliding is constant, so that any
/// difference comes from the beginning.
double settlingOf(const Scene& scene, const std::shared_ptr<const RigidLine>& rigid,
                  std::int64_t leastSteps, double work, const std::stop_token& stop) {
  const double velocity = std::abs(scene.sliding.velocity);
  if (scene.sliding.kind == SlidingKind::Start || !(velocity > 0)) return kNotApplicable;
  Piece piece{scene};
  Sliding& sliding = piece.scene.sliding;
  sliding.kind = SlidingKind::Step;  // with a step that changes nothing
  sliding.velocityAfter = sliding.velocity;
  const Transient steady(piece.scene, rigid, leastSteps);
  const double step = sliding.duration / std::max(1.0, steady.countSteps());
  double memory = 0;
  for (const double rate : steady.march().modes().rate) memory = std::max(memory, 1 / rate);
  const double wanted = std::max(kRetardationTimes * memory / step, kMinWindows * kWindow);
  const double steps = std::min(wanted, std::max(work / nodesOf(*rigid), kMinWindows * kWindow));
  sliding.duration = steps * step;
  piece.leastSteps = std::max<std::int64_t>(1, static_cast<std::int64_t>(steps));
  piece.windows = std::max(2.0 * kEnds, std::floor(steps / kWindow));
  const std::vector<double> mu = marchThrough(piece, rigid, 1, stop).mu;
  const double settled = mean(std::span(mu).last(kEnds));
  return settled != 0 ? std::abs(mean(std::span(mu).first(kEnds)) / settled - 1) : kNotApplicable;
}

struct Measured {
  ErrorBudget error;
  March march;
};

Measured measure(const Scene& scene, const std::shared_ptr<const RigidLine>& rigid,
                 const Piece& piece, const std::stop_token& stop) {
  Measured measured;
  measured.march = marchThrough(piece, rigid, 1, stop);
  ErrorBudget& error = measured.error;
  if (scene.load.kind != LoadKind::Indentation) error.forceBalance = measured.march.forceError;
  const std::vector<double>& mu = measured.march.mu;
  error.timeStep = relativeDifference(mu, marchThrough(piece, rigid, 2, stop).mu);
  Piece fine = piece;
  fine.scene = refined(piece.scene);
  const auto fineLine = std::make_shared<const RigidLine>(fine.scene, 0, piece.profile);
  const double difference = relativeDifference(mu, marchThrough(fine, fineLine, 1, stop).mu);
  (scene.accuracy.scheme == Scheme::Nodal ? error.modelDifference : error.resolution) = difference;
  error.settling = settlingOf(scene, rigid, Transient::kMinSteps,
                              2 * nodesOf(*rigid) * measured.march.steps, stop);
  return measured;
}

/// Returns the memory of the march in bytes: the data of every element with its amplitudes; and
/// that of the march on fewer nodes that estimates its error.
double memoryOf(const Transient& transient, double elements) {
  constexpr double kOfElement = 36;  // numbers of march, line, prepared profile and transform
  const auto modes = static_cast<double>(transient.march().modes().modes());
  return elements * (kOfElement + modes) * sizeof(double);
}

/// Returns the scene, or one with a shorter line if the minimum work on all elements is not
/// allowed.
PilotScene sampleFor(const PilotScene& whole, double weight, double allowed) {
  const Accuracy& accuracy = whole.scene.accuracy;
  const std::int64_t points = linePoints(whole.scene);
  PilotScene sample = sampleWithin(whole, kMarches * kMinWindows * kWindow * weight,
                                   static_cast<double>(points), allowed);
  if (accuracy.scheme != Scheme::Nodal) sample.scene.accuracy = {accuracy.scheme, points, 0};
  return sample;
}

/// A motion at time 0, and the cost of its preparation.
struct Beginning {
  explicit Beginning(const PilotScene& sample)
      : scene(sample.scene),
        start(threadSeconds()),
        profile(sample.profile()),
        rigid(std::make_shared<const RigidLine>(scene, 0, profile.get())),
        transient(scene, rigid),
        seconds(threadSeconds() - start) {}

  Scene scene;
  double start;
  std::unique_ptr<const Profile> profile;
  std::shared_ptr<const RigidLine> rigid;
  Transient transient;
  double seconds;
};

}  // namespace

Prediction predictMotion(const Scene& scene, const std::stop_token& stop) {
  const double weight = weightOf(elementLaw(scene.elastomer)), leastSteps = kMinWindows * kWindow;
  const PilotScene whole(scene, lineExtent(scene));
  // A shorter line has the same number of steps; it first determines how much the pilot may do.
  const double steps = Beginning(sampleFor(whole, weight, kMinWork)).transient.countSteps();
  Prediction prediction;
  prediction.steps = steps;
  prediction.elements = whole.elements() * static_cast<double>(linePoints(scene));
  prediction.runOperations = steps * prediction.elements * weight;
  const double allowed = std::clamp(0.1 * prediction.runOperations, kMinWork, kMaxWork);
  const Beginning begin(sampleFor(whole, weight, allowed));
  const double elements = nodesOf(*begin.rigid), larger = prediction.elements / elements;
  prediction.lines = prediction.simulations = 1;
  prediction.memory = memoryOf(begin.transient, prediction.elements);
  const double wanted = std::max(allowed / (kMarches * elements * weight), leastSteps);
  const Piece piece = pieceOf(begin.scene, steps, wanted / steps, begin.profile.get());
  const Measured measured = measure(begin.scene, begin.rigid, piece, stop);
  prediction.operations = kMarches * measured.march.steps * elements * weight;
  prediction.error = measured.error;
  prediction.seconds =
      larger * (begin.seconds + measured.march.seconds / measured.march.steps * steps);
  return prediction;
}

ErrorBudget measureMotionError(const Scene& scene) {
  const auto rigid = std::make_shared<const RigidLine>(scene);
  const double steps = Transient(scene, rigid).countSteps();
  return measure(scene, rigid, pieceOf(scene, steps, 1), {}).error;
}

void addMarchErrors(WorkPrecision& comparison) {
  for (RegionPrecision& region : comparison.regions) {
    Piece piece{comparison.scene};
    // The march has the points of the line that it is compared with.
    if (comparison.scene.accuracy.scheme != Scheme::Nodal)
      piece.scene.accuracy = {comparison.scene.accuracy.scheme, linePoints(comparison.scene), 0};
    Sliding& sliding = piece.scene.sliding;
    sliding.kind = SlidingKind::Step;  // with a step that changes nothing
    sliding.velocity = region.middleVelocity();
    sliding.velocityAfter = sliding.velocity;
    const auto rigid = std::make_shared<const RigidLine>(piece.scene);
    const double steps = std::max(std::floor(kPieceWork / nodesOf(*rigid)), kMinWindows * kWindow);
    sliding.duration = steps * rigid->line->spacing / sliding.velocity;
    piece.leastSteps = 1;  // one node per step
    piece.windows = std::floor(steps / kWindow);
    const March march = marchThrough(piece, rigid, 1, {});
    region.timeStepError = relativeDifference(march.mu, marchThrough(piece, rigid, 2, {}).mu);
    region.settlingError = settlingOf(piece.scene, rigid, piece.leastSteps, 2 * kPieceWork, {});
  }
}

Prediction predictRun(const Scene& scene, int threads, const std::stop_token& stop) {
  return scene.sliding.kind == SlidingKind::Steady ? predictCurve(scene, threads, stop)
                                                   : predictMotion(scene, stop);
}

Explanation explainRun(const Scene& scene, int threads) {
  Explanation explanation = explain(scene, threads);
  if (!explanation.predicted) explanation.predicted = predictMotion(scene);
  return explanation;
}

void analyzeRun(Explanation& explanation, int threads) {
  const Scene& scene = explanation.scene;
  if (scene.sliding.kind == SlidingKind::Steady) return analyze(explanation, threads);
  Measurement measured;
  const double begin = threadSeconds();
  Transient transient(scene, std::make_shared<const RigidLine>(scene));
  while (!transient.isOver()) transient.marchTo(scene.sliding.duration);
  measured.seconds = threadSeconds() - begin;
  measured.error = measureMotionError(scene);
  explanation.measured = measured;
}

}  // namespace asperity
