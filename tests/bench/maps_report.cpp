#include "tests/bench/maps_report.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>
#include <thread>

#include "core/friction/parameter_map.h"
#include "core/friction/steady_states.h"
#include "core/scene/scene_file.h"
#include "tests/bench/table.h"

namespace asperity::bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kThreads = 2;

double seconds(Clock::time_point from) {
  return std::chrono::duration<double>(Clock::now() - from).count();
}

/// Processor time of all threads of this process, s.
double processorSeconds() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  const auto of = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return of(used.ru_utime) + of(used.ru_stime);
}

struct Timed {
  double first = 0, whole = 0;     // s, wall clock
  double firstWork = 0, work = 0;  // s, processor
  std::size_t computed = 0;
};

MapAxis side(const Scene& scene, const std::string& range) {
  return mapAxis(scene, parseRangeOption("--x", range));
}

Timed timedMap(const Scene& scene, const std::string& x, const std::string& y, int turns) {
  Timed best{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
             std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(), 0};
  for (int turn = 0; turn < turns; ++turn) {
    const Clock::time_point begin = Clock::now();
    const double work = processorSeconds();
    double first = 0, firstWork = 0;
    const auto preview = [&](const ParameterMap&) {
      if (first > 0) return;
      first = seconds(begin);
      firstWork = processorSeconds() - work;
    };
    const ParameterMap map =
        parameterMap(scene, side(scene, x), side(scene, y), {.threads = kThreads}, preview);
    best.whole = std::min(best.whole, seconds(begin));
    best.work = std::min(best.work, processorSeconds() - work);
    best.first = std::min(best.first, first);
    best.firstWork = std::min(best.firstWork, firstWork);
    best.computed = map.computed;
  }
  return best;
}

/// One call for each row, as one would without a map: nothing is shared from row to row.
double rowByRow(const Scene& scene, const std::string& x, const std::string& y, int turns) {
  const MapAxis across = side(scene, x), up = side(scene, y);
  ParameterMap map{scene, across, up, {}, 0, 0, false, true};
  double best = std::numeric_limits<double>::infinity();
  for (int turn = 0; turn < turns; ++turn) {
    const double work = processorSeconds();
    StateOptions options;
    options.threads = kThreads;
    for (std::size_t j = 0; j < up.values.size(); ++j) {
      std::vector<Scene> row;
      for (std::size_t i = 0; i < across.values.size(); ++i) row.push_back(cellScene(map, i, j));
      slideStates(row, options);
    }
    best = std::min(best, processorSeconds() - work);
  }
  return best;
}

double slowestCancel(const Scene& scene, int tries) {
  double slowest = 0;
  for (int i = 0; i < tries; ++i) {
    std::stop_source source;
    Clock::time_point asked;
    std::jthread asking([&] {
      std::this_thread::sleep_for(std::chrono::microseconds(2000 + 9137 * i));
      asked = Clock::now();
      source.request_stop();
    });
    parameterMap(scene, side(scene, "sliding.velocity=1e-5:1e3:64"),
                 side(scene, "load.normal_force=1e-3:10:64"),
                 {.threads = kThreads, .stop = source.get_token()}, [](const ParameterMap&) {});
    const Clock::time_point back = Clock::now();
    asking.join();
    slowest = std::max(slowest, std::chrono::duration<double>(back - asked).count());
  }
  return slowest;
}

Scene paper() {
  Scene scene;
  scene.accuracy.oversampling = 2;
  scene.ensemble.realizations = 10;
  return scene;
}

/// The shipped rubber with 13 arms.
Scene rubber() {
  Scene scene = readSceneFile(std::filesystem::path(ASPERITY_RESOURCES_DIR) / "scenes" /
                              "temperature_tread.json");
  scene.surface = {};
  scene.load = {};
  scene.accuracy = {};
  scene.accuracy.oversampling = 2;
  scene.ensemble.realizations = 10;
  scene.comparison = {};
  return scene;
}

}  // namespace

std::string mapsSection(bool isQuick) {
  const int turns = isQuick ? 1 : 3;
  Table table({"map of 64 x 64, N = 5000, cubic x2, 10 lines", "states", "first picture",
               "processor", "all", "processor"});
  const auto add = [&](const std::string& name, const Scene& scene, const std::string& x,
                       const std::string& y) {
    const Timed timed = timedMap(scene, x, y, turns);
    table.add({name, std::to_string(timed.computed), duration(timed.first),
               duration(timed.firstWork), duration(timed.whole), duration(timed.work)});
    return timed;
  };
  const Scene kelvin = paper(), arms = rubber();
  const std::string velocity = "sliding.velocity=1e-5:1e3:64";
  add("velocity, normal force", kelvin, velocity, "load.normal_force=1e-3:10:64");
  add("velocity, relaxation time", kelvin, velocity, "elastomer.relaxation_time=1e-7:10:64");
  add("velocity, Hurst exponent", kelvin, velocity, "surface.hurst=0.2:1:64");
  add(fmt::format("velocity, temperature of {} arms", arms.elastomer.arms.size()), arms, velocity,
      "elastomer.temperature=275:330:64");
  const std::string force = "load.normal_force=1e-3:10:64",
                    modulus = "elastomer.shear_modulus=1e6:1e10:64",
                    height = "surface.rms_height=1e-8:1e-4:64";
  const Timed shared = add("normal force, modulus", kelvin, force, modulus);
  const Timed sharedArms = add("normal force, rms height with arms", arms, force, height);
  const double rows = rowByRow(kelvin, force, modulus, turns);
  const double rowsArms = isQuick ? kNotApplicable : rowByRow(arms, force, height, 1);
  std::string text = "## Maps\n\n" + table.text() + "\n";
  // Previews are part of a map's time here, and not of the rows.
  text += fmt::format(
      "Normal force and modulus: one curve a row takes {} of processor time, {:.1f} times as much "
      "as the map with its previews.\n",
      duration(rows), rows / shared.work);
  if (!isQuick)
    text += fmt::format("With arms, normal force and rms height: {}, {:.1f} times as much.\n",
                        duration(rowsArms), rowsArms / sharedArms.work);
  text += fmt::format("Cancelled at any moment it is back within {} (Kelvin), {} (arms).\n",
                      duration(slowestCancel(kelvin, isQuick ? 5 : 20)),
                      duration(slowestCancel(arms, isQuick ? 5 : 20)));
  return text;
}

}  // namespace asperity::bench
