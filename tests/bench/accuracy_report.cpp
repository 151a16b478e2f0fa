#include "tests/bench/accuracy_report.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <utility>
#include <vector>

#include "core/accuracy/prediction.h"
#include "core/accuracy/target_curve.h"
#include "core/contact/steady_solver.h"
#include "core/contact/steady_sweep.h"
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
    table.add({percentText(target), result.curve.isTargetMet ? "yes" : "no",
               percentText(result.curve.achievedError),
               ratioText(result.plainOperations / result.operations),
               ratioText(result.plainOperations / plan.operations)});
  }
  return "## Multilevel against plain averaging\nOperations are nodes passed over, N = 5000, six "
         "velocities from 0.001 to 100 m/s. Plain: on the finest level that the target asks "
         "for.\n\n" +
         table.text() + "\n";
}

/// Mean friction of a scene's lines at eight points per element, from many lines of another seed:
/// most of them at one point per element, and the difference from fewer.
std::vector<double> trueMeans(Scene scene, bool isQuick) {
  const std::int64_t lines = isQuick ? 10000 : 100000;
  const auto means = [&](std::int64_t seed, std::int64_t oversampling, std::int64_t count) {
    scene.surface.seed = seed;
    scene.accuracy = {Scheme::Cubic, oversampling, 0};
    scene.ensemble.realizations = count;
    return frictionCurve(scene).points;
  };
  const auto coarse = means(990001, 1, lines), below = means(990002, 1, lines / 20),
             fine = means(990002, 8, lines / 20);
  std::vector<double> mu;
  for (std::size_t i = 0; i < coarse.size(); ++i)
    mu.push_back(coarse[i].mu - below[i].mu + fine[i].mu);
  return mu;
}

struct Cell {
  double hurst, normalForce, target;
  std::int64_t elements;
};

/// Studies of one velocity of a cell, against its true mean.
struct Honesty {
  int inside = 0, studies = 0;
  double lines = 0;
  RunningMean error, half;

  void add(const AchievedAccuracy& achieved, double mu) {
    ++studies;
    inside += mu > achieved.low && mu < achieved.high ? 1 : 0;
    lines += static_cast<double>(achieved.lines);
    error.add((achieved.low + achieved.high) / 2 - mu);
    half.add((achieved.high - achieved.low) / 2);
  }
  double coverage() const { return static_cast<double>(inside) / studies; }
};

std::string coverage(bool isQuick) {
  const int studies = isQuick ? 40 : 300;
  Table table({"H", "F_N", "N", "target", "velocity", "contact", "lines", "inside",
               "bias over half-width", "its standard error"});
  int inside = 0, all = 0, reached = 0, runs = 0;
  double least = 1, most = 0, bias = 0, operations = 0;
  for (const Cell& cell : {Cell{0.7, 0.05, 0.1, 500},
                           {0.7, 0.0005, 0.1, 2000},
                           {0.3, 0.02, 0.05, 500},
                           {0.7, 0.002, 0.05, 1000},
                           {1, 0.01, 0.05, 500},
                           {0.7, 0.05, 0.02, 500},
                           {0.5, 0.005, 0.02, 500}}) {
    Scene scene;
    scene.surface.hurst = cell.hurst;
    scene.surface.elements = cell.elements;
    scene.load.normalForce = cell.normalForce;
    scene.sweep = {1e-3, 100, 4};
    const std::vector<double> truth = trueMeans(scene, isQuick);
    std::vector<Honesty> honesty(truth.size());
    std::vector<CurvePoint> points;
    scene.accuracy = {Scheme::Cubic, 1, cell.target};
    // Cells must not share lines.
    scene.surface.seed = 1000 * (1 + runs);
    for (int study = 0; study < studies; ++study, ++runs) {
      ++scene.surface.seed;
      const TargetCurve result = targetCurve(scene);
      for (std::size_t i = 0; i < truth.size(); ++i) honesty[i].add(result.achieved[i], truth[i]);
      operations += result.operations;
      reached += result.curve.isTargetMet ? 1 : 0;
      points = result.curve.points;
    }
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const Honesty& here = honesty[i];
      const double off = here.error.mean() / here.half.mean();
      table.add({fmt::format("{}", cell.hurst), fmt::format("{} N", cell.normalForce),
                 fmt::format("{}", cell.elements), percentText(cell.target),
                 fmt::format("{:.2g} m/s", points[i].velocity),
                 fmt::format("{:.1e}", points[i].contactFraction),
                 fmt::format("{:.0f}", here.lines / here.studies),
                 fmt::format("{:.1f} %", 100 * here.coverage()), fmt::format("{:+.3f}", off),
                 fmt::format("{:.3f}", here.error.standardError() / here.half.mean())});
      inside += here.inside;
      all += here.studies;
      least = std::min(least, here.coverage());
      most = std::max(most, here.coverage());
      bias = std::max(bias, std::abs(off));
    }
  }
  return fmt::format(
      "## Honest intervals of ensembles\n{} studies a cell, each of other seeds; the true mean "
      "from "
      "lines of further seeds at eight points per element.\n\n{}\nTrue mean inside the 95 % "
      "interval: {:.1f} % of all {} (wanted: 94 to 96), {:.1f} to {:.1f} % of a cell (wanted: 91 "
      "to "
      "98.5); largest bias {:.3f} of the half-width (wanted: below 0.1); target met in {} of {} "
      "runs, {:.3g} nodes passed over.\n\n",
      studies, table.text(), 100.0 * inside / all, all, 100 * least, 100 * most, bias, reached,
      runs, operations);
}

/// A profile of the heights of a random line, and its friction at a resolution beyond any chosen.
struct GivenLine {
  Scene scene;
  std::vector<SteadyResult> truth;
};

GivenLine makeGivenLine(const std::filesystem::path& folder, std::mt19937& random, int number) {
  std::uniform_real_distribution<double> uniform;
  Scene rough;
  rough.surface.elements = 2 * std::lround(50 * std::pow(20, uniform(random)));
  rough.surface.hurst = uniform(random);
  rough.surface.seed = number;
  GivenLine given;
  Scene& scene = given.scene;
  scene.surface.kind = SurfaceKind::Profile;
  scene.surface.elements = 0;
  scene.surface.file = "line.csv";
  scene.folder = folder;
  std::ofstream file(folder / scene.surface.file);
  for (const double height : LineSource(rough, 1).make(0).height)
    file << fmt::format("{}\n", height);
  file.close();
  scene.load.normalForce = std::pow(10, -5 + 6.5 * uniform(random));
  scene.sweep = {1e-5, 1e3, 9};
  const std::vector<double> velocities = sweepVelocities(scene.sweep);
  given.truth.resize(velocities.size());
  SteadySolver(scene).sweep(prepareProfile(LineSource(scene, 256).make(0), Scheme::Cubic),
                            scene.load, velocities, given.truth);
  return given;
}

std::string givenLines(bool isQuick) {
  const int lines = isQuick ? 60 : 400;
  const std::vector<double> targets{0.1, 0.03, 0.01, 3e-3, 1e-3, 1e-4};
  const std::vector<double> bounds{3e-5, 3e-4, 3e-3, 3e-2, 0.999, 2};
  std::vector<std::vector<std::pair<int, int>>> counts(
      targets.size(), std::vector<std::pair<int, int>>(bounds.size() - 1));
  std::vector<double> oversampling(targets.size());
  const auto folder =
      std::filesystem::temp_directory_path() / fmt::format("asperity_bench_{}", ::getpid());
  std::filesystem::create_directory(folder);
  std::mt19937 random(11);
  for (int number = 0; number < lines; ++number) {
    GivenLine given = makeGivenLine(folder, random, number);
    for (std::size_t t = 0; t < targets.size(); ++t) {
      given.scene.accuracy = {Scheme::Cubic, 1, targets[t]};
      const TargetCurve result = targetCurve(given.scene);
      for (std::size_t i = 0; i < given.truth.size(); ++i) {
        const double contact = given.truth[i].contactFraction;
        const auto above = std::upper_bound(bounds.begin(), bounds.end(), contact);
        if (above == bounds.begin()) continue;
        auto& [outside, all] = counts[t][static_cast<std::size_t>(above - bounds.begin()) - 1];
        const AchievedAccuracy& achieved = result.achieved[i];
        const double mu = given.truth[i].mu;
        ++all;
        outside += mu < achieved.low || mu > achieved.high ? 1 : 0;
        oversampling[t] += static_cast<double>(achieved.oversampling);
      }
    }
  }
  std::filesystem::remove_all(folder);
  Table table({"target", "contact 3e-5 to 3e-4", "to 3e-3", "to 3e-2", "below 1", "complete",
               "all outside", "points per element"});
  for (std::size_t t = 0; t < targets.size(); ++t) {
    std::vector<std::string> row{percentText(targets[t])};
    int outside = 0, all = 0;
    for (const auto& [some, of] : counts[t]) {
      row.push_back(fmt::format("{} of {}", some, of));
      outside += some;
      all += of;
    }
    row.push_back(percentText(static_cast<double>(outside) / all));
    row.push_back(fmt::format("{:.1f}", oversampling[t] / all));
    table.add(row);
  }
  return fmt::format(
      "## Honest intervals of lines that are given\n{} random profiles of H = 0 to 1, 100 to 2000 "
      "elements, F_N = 1e-5 to 30 N, nine velocities from 1e-5 to 1000 m/s. Points at which "
      "friction "
      "at 256 points per element lies outside the stated interval; wanted: at most 2 %.\n\n{}\n",
      lines, table.text());
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
        slideSweep(prepareProfile(lines[kind], Scheme::Cubic), slidingConditions(scene, 0),
                   scene.load, velocities, row);
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
         givenLines(isQuick) + mirrors(isQuick);
}

}  // namespace asperity::bench
