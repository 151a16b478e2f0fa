#include "tests/bench/effects_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

#include "core/contact/march/time_march.h"
#include "core/contact/steady_sliding.h"
#include "core/contact/steady_solver.h"
#include "core/surface/line_source.h"
#include "tests/bench/instructions.h"
#include "tests/bench/machine.h"
#include "tests/bench/table.h"
#include "tests/bench/workload.h"

namespace asperity::bench {
namespace {

constexpr std::int64_t kElements = 1000;
constexpr double kForce = 0.02, kDepth = 1e-6, kFriction = 0.2;
constexpr int kSteps = 40;  // of a march
constexpr int kTurns = 15;

/// Something timed: what it did, in elements that a simulation or a step went over.
struct Work {
  double elements = 0;
  double passes = 0;  // over the line, a simulation
  double contact = 0, friction = 0;
};

struct Case {
  std::string name;
  std::function<Work()> run;
  Work done{};
  int times = 1;                                                  // in a turn
  double seconds = std::numeric_limits<double>::infinity();       // an element, the fastest turn
  double instructions = std::numeric_limits<double>::infinity();  // an element, the fewest
};

/// One turn: as often as it takes to be measured.
void take(Case& each, const Instructions& counter, bool counts) {
  const auto before = counter.count();
  const double start = threadSeconds();
  double elements = 0;
  for (int i = 0; i < each.times; ++i) {
    each.done = each.run();
    elements += each.done.elements;
  }
  const double seconds = threadSeconds() - start;
  const auto after = counter.count();
  if (!counts) {
    constexpr double kTurn = 2e-3;  // s
    each.times = static_cast<int>(std::clamp(kTurn / std::max(seconds, 1e-9), 1.0, 1e4));
    return;
  }
  each.seconds = std::min(each.seconds, seconds / elements);
  if (before && after)
    each.instructions = std::min(each.instructions, (*after - *before) / elements);
}

/// All cases in turn, there and back, so that what else the machine does meets them alike.
void measure(std::vector<Case>& cases, bool isQuick) {
  const Instructions counter;
  const int turns = isQuick ? 3 : kTurns;
  for (Case& each : cases) take(each, counter, false);
  for (int turn = 0; turn < turns; ++turn)
    for (std::size_t i = 0; i < cases.size(); ++i)
      take(cases[turn % 2 == 0 ? i : cases.size() - 1 - i], counter, true);
}

struct Law {
  std::string name;
  Elastomer elastomer;
  int arms;
};

Elastomer withArms(int arms) {
  Elastomer elastomer;
  elastomer.rheology = arms == 1 ? Rheology::StandardSolid : Rheology::Prony;
  elastomer.arms.clear();
  for (int i = 0; i < arms; ++i)
    elastomer.arms.push_back({2e7 / arms, std::pow(10.0, -2 - 4.0 * i / std::max(arms - 1, 1))});
  return elastomer;
}

std::vector<Law> laws() {
  std::vector<Law> all{{"elastic", {}, 0}, {"kelvin", {}, 0}};
  all[0].elastomer.rheology = Rheology::Elastic;
  for (const int arms : {1, 2, 4, 8, 17})
    all.push_back(
        {arms == 1 ? "standard_solid" : fmt::format("prony, {} arms", arms), withArms(arms), arms});
  return all;
}

Scene sceneOf(const Law& law, Scheme scheme, LoadKind load, bool hasInterface) {
  Scene scene;
  scene.surface.elements = kElements;
  scene.elastomer = law.elastomer;
  scene.accuracy.scheme = scheme;
  scene.accuracy.oversampling = scheme == Scheme::Cubic ? 2 : 1;
  scene.load = {load, kForce, kDepth};
  if (hasInterface) scene.interface.frictionCoefficient = kFriction;
  return scene;
}

/// 16 velocities, each balanced, on the scene's line.
std::function<Work()> steadyWork(const Scene& scene) {
  const Line line = LineSource(scene, pointsPerElement(scene)).make(0);
  const auto profile =
      std::make_shared<PreparedProfile>(prepareProfile(line, scene.accuracy.scheme));
  const auto sliding = std::make_shared<SteadySolver>(scene);
  return [profile, sliding, load = scene.load] {
    const std::vector<double> velocities = logarithmic(0.01, 1, 16);
    std::vector<SteadyResult> results(velocities.size());
    sliding->sweep(*profile, load, velocities, results);
    Work work{static_cast<double>(kElements) * 16};
    for (const SteadyResult& result : results) {
      work.passes += result.passes / 16.0;
      work.contact += result.contactFraction / 16;
    }
    return work;
  };
}

/// Steps of one point each, and the local friction of each step as transients report it.
std::function<Work()> marchWork(const Scene& scene) {
  const auto line =
      std::make_shared<const Line>(LineSource(scene, pointsPerElement(scene)).make(0));
  const double lowest = prepareProfile(*line, scene.accuracy.scheme).lowestHeight;
  const auto march = std::make_shared<TimeMarch>(line, lowest, lawOf(scene.elastomer));
  const MarchLoad load{scene.load.kind, kForce, kDepth};
  march->settleAtRest(load);
  return [march, load, line, interface = scene.interface] {
    Work work{static_cast<double>(line->nodes()) * kSteps, 1};
    for (int i = 0; i < kSteps; ++i) {
      const MarchStep step = march->step(load, line->spacing / 0.1, line->spacing);
      work.contact += step.contactLength / line->length / kSteps;
      if (interface.frictionCoefficient > 0)
        work.friction += localFriction(interface, step.normalForce, step.contactLength);
    }
    return work;
  };
}

std::string nanoseconds(const Case& each) {
  return number(1e9 * each.seconds);
}

std::string counted(const Case& each) {
  return std::isfinite(each.instructions) ? number(each.instructions) : "-";
}

constexpr LoadKind kLoads[] = {LoadKind::Force, LoadKind::Indentation};

/// Four cases of a law and a scheme: each load without and with local friction.
template <class MakeWork>
void addFour(std::vector<Case>& cases, const std::string& name, const Law& law, Scheme scheme,
             const MakeWork& workOf) {
  for (const LoadKind load : kLoads)
    for (const bool interface : {false, true})
      cases.push_back({name, workOf(sceneOf(law, scheme, load, interface))});
}

std::string combinationsTable(const std::vector<Case>& cases, const char* what) {
  Table table({what, "force", "and interface", "indentation", "and interface",
               "instructions (force)", "passes (force)", "contact (force)"});
  for (std::size_t i = 0; i + 3 < cases.size(); i += 4)
    table.add({cases[i].name, nanoseconds(cases[i]), nanoseconds(cases[i + 1]),
               nanoseconds(cases[i + 2]), nanoseconds(cases[i + 3]), counted(cases[i]),
               number(cases[i].done.passes), percent(cases[i].done.contact)});
  return table.text() + "\n";
}

/// ns = first + each * arms by least squares.
struct Growth {
  double first, each, worst;
};

Growth growthOf(const std::vector<double>& arms, const std::vector<double>& ns) {
  // Relative residuals count, so that few arms count as much as many.
  double w = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t i = 0; i < arms.size(); ++i) {
    const double weight = 1 / (ns[i] * ns[i]);
    w += weight;
    x += weight * arms[i];
    y += weight * ns[i];
    xx += weight * arms[i] * arms[i];
    xy += weight * arms[i] * ns[i];
  }
  Growth growth{};
  growth.each = (w * xy - x * y) / (w * xx - x * x);
  growth.first = (y - growth.each * x) / w;
  for (std::size_t i = 0; i < arms.size(); ++i)
    growth.worst =
        std::max(growth.worst, std::abs((growth.first + growth.each * arms[i]) / ns[i] - 1));
  return growth;
}

/// Rows of laws with arms, `stride` cases apart; per pass where a simulation takes several.
void addGrowth(Table& table, const std::string& name, const std::vector<Case>& cases,
               const std::vector<Law>& of, std::size_t offset, std::size_t stride) {
  std::vector<double> arms, ns;
  for (std::size_t i = 0; i < of.size(); ++i) {
    if (of[i].arms == 0) continue;
    const Case& each = cases[offset + i * stride];
    arms.push_back(of[i].arms);
    ns.push_back(1e9 * each.seconds / each.done.passes);
  }
  const Growth growth = growthOf(arms, ns);
  table.add({name, number(growth.first), number(growth.each), percent(growth.worst)});
}

struct Pair {
  std::string name;
  Scene without, with;
};

std::vector<Pair> ofNoStrength() {
  const Scene plain = sceneOf(laws()[1], Scheme::Cubic, LoadKind::Force, false);
  std::vector<Pair> pairs;
  const auto add = [&](const char* name, const Scene& without, const auto& change) {
    Pair pair{name, without, without};
    change(pair.with);
    pairs.push_back(pair);
  };
  add("interface friction of 0", plain, [](Scene& s) { s.interface.frictionCoefficient = 0; });
  add("temperature at its reference", plain,
      [](Scene& s) { s.elastomer.temperature = s.elastomer.shift.referenceTemperature = 350; });
  add("roll-off as long as the line", plain,
      [](Scene& s) { s.surface.rollOffWavelength = s.surface.length; });
  Scene prony = plain;
  prony.elastomer = withArms(4);
  add("four more arms of no modulus", prony, [](Scene& s) {
    for (int i = 0; i < 4; ++i) s.elastomer.arms.push_back({0, 1e-3 * (i + 1)});
  });
  add("a dashpot of no viscosity", prony, [](Scene& s) { s.elastomer.viscosity = 0; });
  Scene elastic = plain;
  elastic.elastomer.rheology = Rheology::Elastic;
  add("elastic as a series without arms", elastic, [](Scene& s) {
    s.elastomer = withArms(2);
    for (Arm& arm : s.elastomer.arms) arm.modulus = 0;
  });
  return pairs;
}

std::string noStrengthTable(bool isQuick) {
  std::vector<Case> cases;
  const std::vector<Pair> pairs = ofNoStrength();
  for (const Pair& pair : pairs) {
    cases.push_back({pair.name, steadyWork(pair.without)});
    cases.push_back({pair.name, steadyWork(pair.with)});
  }
  measure(cases, isQuick);
  Table table({"effect of no strength", "ns without", "ns with", "with over without",
               "instructions, with over without"});
  for (std::size_t i = 0; i < cases.size(); i += 2) {
    const Case &without = cases[i], &with = cases[i + 1];
    table.add({without.name, nanoseconds(without), nanoseconds(with),
               fmt::format("{:.3f}", with.seconds / without.seconds),
               std::isfinite(with.instructions)
                   ? fmt::format("{:.4f}", with.instructions / without.instructions)
                   : "-"});
  }
  return "## Effects of no strength\nThe plan leaves them out, so the same code runs: cubic x2, "
         "steady, at the force. A test counts the stages.\n\n" +
         table.text() + "\n";
}

}  // namespace

std::string effectsReport(bool isQuick) {
  const std::vector<Law> all = laws();
  std::vector<Case> steady, march;
  for (const Scheme scheme : {Scheme::Linear, Scheme::Cubic})
    for (const Law& law : all)
      addFour(steady, law.name + (scheme == Scheme::Linear ? ", linear" : ", cubic x2"), law,
              scheme, steadyWork);
  for (const Law& law : all)
    if (law.arms == 0) addFour(steady, law.name + ", nodal", law, Scheme::Nodal, steadyWork);
  for (const Law& law : all) addFour(march, law.name, law, Scheme::Linear, marchWork);
  measure(steady, isQuick);
  measure(march, isQuick);
  Table growth(
      {"growth with the arms", "ns an element", "and ns an arm", "farthest from the line"});
  addGrowth(growth, "steady, a pass, linear", steady, all, 0, 4);
  addGrowth(growth, "steady, a pass, cubic x2", steady, all, 4 * all.size(), 4);
  addGrowth(growth, "march, a step", march, all, 0, 4);
  return fmt::format(
             "# What effects cost\n{}, N = {}, {} N or {} m deep; CPU time in ns per element, the "
             "fastest of {} turns. Free blocks are skipped, so contact matters.\n\n## Steady "
             "sliding, ns per element and simulation (16 velocities from 0.01 to 1 m/s)\n\n",
             cpuName(), kElements, kForce, kDepth, isQuick ? 3 : kTurns) +
         combinationsTable(steady, "steady") + "## March in time, ns per element and step\n\n" +
         combinationsTable(march, "march") +
         "## Growth with the number of arms\n1, 2, 4, 8 and 17 arms, at the force.\n\n" +
         growth.text() + "\n" + noStrengthTable(isQuick);
}

}  // namespace asperity::bench
