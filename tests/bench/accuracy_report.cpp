#include "tests/bench/accuracy_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <vector>

#include "core/accuracy/prediction.h"
#include "core/accuracy/target_curve.h"
#include "core/contact/sweep.h"
#include "core/friction/ensemble.h"
#include "core/scene/scene_file.h"
#include "core/surface/line_source.h"
#include "tests/bench/table.h"

namespace asperity::bench {
namespace {

std::string ratioText(double ratio) {
  return fmt::format("{:.2f}", ratio);
}

std::string percentText(double part) {
  return std::isfinite(part) ? fmt::format("{:.2g} %", 100 * part) : std::string("-");
}

double secondsOf(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::vector<std::filesystem::path> steadyScenes() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(ASPERITY_RESOURCES_DIR "/scenes"))
    if (readSceneFile(entry.path()).sliding.kind == SlidingKind::Steady)
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::string predictions(bool isQuick) {
  Table table({"scene", "time, predicted over measured", "error predicted", "error measured",
               "predicted over measured"});
  for (const std::filesystem::path& file : steadyScenes()) {
    const Scene scene = readSceneFile(file);
    const Prediction predicted = predictCurve(scene);
    double fastest = 1e300;
    for (int repeat = 0; repeat < (isQuick ? 1 : 3); ++repeat)
      fastest = std::min(fastest, secondsOf([&] { frictionCurve(scene); }));
    const ErrorBudget measured = measureError(scene, 16);
    table.add({file.stem().string(), ratioText(predicted.seconds / fastest),
               percentText(predicted.error.total()), percentText(measured.total()),
               ratioText(predicted.error.total() / measured.total())});
  }
  return "## Prediction against run\nWanted: time within a factor of 2, error within 1.5.\n\n" +
         table.text() + "\n";
}

Scene targetScene(double target, std::int64_t seed) {
  Scene scene;
  scene.surface.seed = seed;
  scene.sweep = {1e-3, 100, 6};
  scene.accuracy.targetRelativeError = target;
  return scene;
}

std::string multilevel(bool isQuick) {
  Table table({"target", "reached", "worst", "plain over multilevel, operations",
               "the same without the pilot's"});
  for (const double target : {0.05, 0.02, 0.01, 0.005, 0.002}) {
    if (isQuick && target < 0.01) continue;
    const TargetCurve result = targetCurve(targetScene(target, 1));
    const TargetPlan plan = planTarget(targetScene(target, 1));
    table.add({percentText(target), result.isReached ? "yes" : "no", percentText(result.worst),
               ratioText(result.plainOperations / result.operations),
               ratioText(result.plainOperations / plan.operations)});
  }
  return "## Multilevel against plain averaging\nOperations are nodes passed over, N = 5000, six "
         "velocities from 0.001 to 100 m/s. Plain: on the finest level that the target asks "
         "for.\n\n" +
         table.text() + "\n";
}

std::string coverage(bool isQuick) {
  const int studies = isQuick ? 20 : 200;
  Table table({"target", "studies", "true mean inside the 95 % interval", "wanted"});
  for (const double target : {0.05, 0.02}) {
    Scene reference = targetScene(0, 100000);
    reference.surface.elements = 1000;
    reference.accuracy = {Scheme::Cubic, 8, 0};
    reference.ensemble.realizations = isQuick ? 5000 : 100000;
    const Curve truth = frictionCurve(reference);
    std::size_t inside = 0, all = 0;
    for (int study = 0; study < studies; ++study) {
      Scene scene = targetScene(target, study);
      scene.surface.elements = 1000;
      const TargetCurve result = targetCurve(scene);
      for (std::size_t i = 0; i < truth.points.size(); ++i, ++all)
        inside += truth.points[i].mu > result.achieved[i].low &&
                          truth.points[i].mu < result.achieved[i].high
                      ? 1
                      : 0;
    }
    table.add(
        {percentText(target), fmt::format("{}", studies),
         fmt::format("{:.1f} %", 100.0 * static_cast<double>(inside) / static_cast<double>(all)),
         "91 to 98 %"});
  }
  return "## Honest intervals\nN = 1000, six velocities each; the true mean from lines of other "
         "seeds at eight points per element.\n\n" +
         table.text() + "\n";
}

Line upsideDown(Line line) {
  for (auto* values : {&line.height, &line.slopeAfter, &line.slopeBefore})
    for (double& value : *values) value = -value;
  return line;
}

Line backwards(const Line& line) {
  Line mirrored = line;
  const std::size_t count = line.nodes();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t from = (count - i) % count;
    mirrored.height[i] = line.height[from];
    mirrored.slopeAfter[i] = -line.slopeLeftOf(from);
  }
  mirrored.slopeBefore.clear();
  return mirrored;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  RunningMean meanA, meanB;
  for (const double value : a) meanA.add(value);
  for (const double value : b) meanB.add(value);
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += (a[k] - meanA.mean()) * (b[k] - meanB.mean());
  return sum / static_cast<double>(a.size() - 1) / std::sqrt(meanA.variance() * meanB.variance());
}

std::string mirrors(bool isQuick) {
  Table table({"F_N", "velocity", "z and -z", "x and -x"});
  const std::vector<double> velocities{1e-3, 1e-1, 1, 10, 1000};
  for (const double force : {0.0034, 0.33}) {
    Scene scene;
    scene.load.normalForce = force;
    const LineSource source(scene, 2);
    std::vector<std::vector<double>> mu[3];
    for (auto& kind : mu) kind.resize(velocities.size());
    for (std::int64_t r = 0; r < (isQuick ? 40 : 400); ++r) {
      const Line line = source.make(r);
      const Line lines[3] = {line, upsideDown(line), backwards(line)};
      for (std::size_t kind = 0; kind < 3; ++kind) {
        std::vector<SteadyResult> row(velocities.size());
        slideSweep(prepareTravel(lines[kind], Scheme::Cubic), conditionsOf(scene, 0), scene.load,
                   velocities, row);
        for (std::size_t i = 0; i < row.size(); ++i) mu[kind][i].push_back(row[i].mu);
      }
    }
    for (std::size_t i = 0; i < velocities.size(); ++i)
      table.add({fmt::format("{} N", force), fmt::format("{} m/s", velocities[i]),
                 ratioText(correlation(mu[0][i], mu[1][i])),
                 ratioText(correlation(mu[0][i], mu[2][i]))});
  }
  return "## Mirrored lines\nCorrelation of mu between a line and its mirror image. Averaging both "
         "gains where it is below 0 and loses where it is above: upside down it is close to 0 but "
         "on the plateau, backwards close to 1 in regions I and IV. Neither is used. Velocities of "
         "a sweep share their lines.\n\n" +
         table.text() + "\n";
}

}  // namespace

std::string accuracyReport(bool isQuick) {
  return "# Accuracy\n\n" + predictions(isQuick) + multilevel(isQuick) + coverage(isQuick) +
         mirrors(isQuick);
}

}  // namespace asperity::bench
