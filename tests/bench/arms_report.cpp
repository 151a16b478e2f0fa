#include "tests/bench/arms_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <limits>
#include <memory>
#include <stdexcept>
#include <vector>

#include "core/contact/arms/arm_balance.h"
#include "core/contact/kernels/kernels.h"
#include "core/contact/steady_solver.h"
#include "core/friction/ensemble.h"
#include "core/surface/line_source.h"
#include "tests/bench/fields.h"
#include "tests/bench/line_store.h"
#include "tests/bench/machine.h"
#include "tests/bench/table.h"
#include "tests/bench/workload.h"

namespace asperity::bench {
namespace {

constexpr int kArms = 20, kLines = 6;
constexpr LineKey kLine{};  // N = 5000, cubic x2
constexpr double kNever = std::numeric_limits<double>::infinity();

/// G_inf = 1e7 Pa and arms from 10 s to 1e-8 s, evenly spaced in their logarithm; moduli (Pa) from
/// `first` to `last` likewise.
Elastomer withArms(int arms, double first = 1e7, double last = 1e7) {
  Elastomer elastomer;
  elastomer.rheology = Rheology::Prony;
  elastomer.equilibriumModulus = kModulus;
  elastomer.viscosity = 0;
  elastomer.arms.clear();
  for (int i = 0; i < arms; ++i) {
    const double share = arms > 1 ? i / (arms - 1.0) : 0.5;
    elastomer.arms.push_back({first * std::pow(last / first, share), 10 * std::pow(1e-9, share)});
  }
  return elastomer;
}

/// The curve of Fig. 2 on several given lines with one solver, as one thread of an ensemble
/// computes it after the first line.
struct Case {
  std::string name;
  std::unique_ptr<SteadySolver> sliding;
  Load load;
  std::vector<SteadyResult> others;
  double passes = 0;        // of a simulation
  double seconds = kNever;  // of a simulation, the fastest turn
  int times = 1;            // in a turn

  Case(std::string caseName, const Elastomer& elastomer) : name(std::move(caseName)) {
    Scene scene = sceneOf(kLine);
    scene.elastomer = elastomer;
    sliding = std::make_unique<SteadySolver>(scene);
    load = scene.load;
    others.resize(figure2Velocities().size());
    sliding->sweep(preparedProfile({5000, Scheme::Cubic, 2, 100}), load, figure2Velocities(),
                   others);
  }

  void turn() {
    static std::vector<SteadyResult> results;
    results.resize(figure2Velocities().size());
    double sum = 0;
    const double start = threadSeconds();
    for (int time = 0; time < times; ++time)
      for (int line = 0; line < kLines; ++line) {
        sliding->sweep(preparedProfile({5000, Scheme::Cubic, 2, line}), load, figure2Velocities(),
                       results, {}, others);
        for (const SteadyResult& result : results) {
          if (result.status != SteadyStatus::Balanced)
            throw std::runtime_error("a force balance of the benchmark is not met");
          sum += result.passes;
        }
      }
    const double simulations = times * kLines * static_cast<double>(results.size());
    seconds = std::min(seconds, (threadSeconds() - start) / simulations);
    passes = sum / simulations;
  }
};

/// All in turn, there and back, so that what else the machine does meets them alike.
void measure(std::vector<Case>& cases, int turns) {
  for (Case& each : cases) {
    each.turn();
    constexpr double kTurn = 0.02;  // s
    const double once = each.seconds * kLines * static_cast<double>(figure2Velocities().size());
    each.times = static_cast<int>(std::clamp(kTurn / once, 1.0, 100.0));
    each.seconds = kNever;
  }
  for (int turn = 0; turn < turns; ++turn)
    for (std::size_t i = 0; i < cases.size(); ++i)
      cases[turn % 2 == 0 ? i : cases.size() - 1 - i].turn();
}

/// CPU time (s) that a line costs each of its simulations.
double lineSeconds(int turns) {
  const LineSource source(sceneOf(kLine), kLine.oversampling);
  Line line;
  PreparedProfile profile;
  double fastest = kNever;
  for (int turn = 0; turn < 4 * turns; ++turn) {
    const double start = threadSeconds();
    source.makeInto(line, turn, Slopes::Computed, {});
    prepareProfileInto(profile, line, kLine.scheme);
    fastest = std::min(fastest, threadSeconds() - start);
  }
  return fastest / static_cast<double>(figure2Velocities().size());
}

std::string verdict(double value, double limit, double accepted) {
  if (value <= limit) return "met";
  return value <= accepted ? "missed, accepted" : "missed";
}

std::string ratioTable(int turns) {
  constexpr double kMaxAvx512 = 8, kMaxOther = 12, kAccepted = 20;
  Table table({"Fig. 2, N = 5000, cubic x2", "instruction set", "kelvin", "20 arms", "passes",
               "over kelvin", "lines included", "target", ""});
  const double line = lineSeconds(turns);
  for (const InstructionSet set :
       {InstructionSet::Scalar, InstructionSet::Avx2, InstructionSet::Avx512}) {
    const bool isHere = chooseInstructionSet(set);
    if (isHere) {
      std::vector<Case> cases;
      cases.emplace_back("", sceneOf(kLine).elastomer);
      cases.emplace_back("arms of 1e7 Pa each", withArms(kArms));
      cases.emplace_back("arms of 1e6 to 1e9 Pa", withArms(kArms, 1e6, 1e9));
      measure(cases, turns);
      const double most = set == InstructionSet::Avx512 ? kMaxAvx512 : kMaxOther;
      const bool isBound = set != InstructionSet::Scalar;
      for (std::size_t i = 1; i < cases.size(); ++i) {
        const double ratio = cases[i].seconds / cases[0].seconds;
        table.add({cases[i].name, instructionSetName(set), duration(cases[0].seconds),
                   duration(cases[i].seconds), number(cases[i].passes), number(ratio),
                   number((cases[i].seconds + line) / (cases[0].seconds + line)),
                   isBound ? "<= " + number(most) : "-",
                   isBound ? verdict(ratio, most, kAccepted) : ""});
      }
    }
    chooseInstructionSet(InstructionSet::Best);
  }
  return table.text() + "\n";
}

/// Of a whole curve on two threads, the fastest of several, in s.
struct CurveSeconds {
  double wall = kNever;
  double cpu = kNever;  // of both threads together, which other work does not lengthen
};

CurveSeconds curveSeconds(const Elastomer& elastomer, std::int64_t realizations, int turns) {
  Scene scene = sceneOf(kLine);
  scene.elastomer = elastomer;
  scene.ensemble.realizations = realizations;
  CurveOptions options;
  options.threads = 2;
  CurveSeconds fastest;
  for (int turn = 0; turn < turns; ++turn) {
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t clock = std::clock();
    frictionCurve(scene, options);
    const double cpu = static_cast<double>(std::clock() - clock) / CLOCKS_PER_SEC;
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
    fastest.wall = std::min(fastest.wall, wall.count());
    fastest.cpu = std::min(fastest.cpu, cpu);
  }
  return fastest;
}

std::string curveTable(int turns) {
  Table table({"41 velocities, 2 threads, lines included", "kelvin", "20 arms", "target", "",
               "CPU, kelvin", "CPU, 20 arms"});
  const auto add = [&](const char* name, std::int64_t realizations, int repeated, double limit) {
    const CurveSeconds kelvin = curveSeconds(sceneOf(kLine).elastomer, realizations, repeated);
    const CurveSeconds arms = curveSeconds(withArms(kArms), realizations, repeated);
    table.add({name, duration(kelvin.wall), duration(arms.wall), "<= " + duration(limit),
               verdict(arms.wall, limit, limit), duration(kelvin.cpu), duration(arms.cpu)});
  };
  add("first curve, 1 line", 1, 3 * turns, 0.016);
  add("whole curve, 200 lines", kRealizations, std::max(turns / 3, 1), 1);
  return table.text() + "\n";
}

/// Seconds of one pass from the balance at 1 m/s, by the plain pass and in vectors.
struct PassSeconds {
  double plain = kNever, vectors = kNever;
};

PassSeconds passSeconds(const Elastomer& elastomer, int turns) {
  const PreparedProfile& line = preparedProfile(kLine);
  const ElementLaw law = elementLaw(elastomer);
  const RetardationModes modes = retardationModes(law);
  ArmTables tables(law, modes);
  const ArmBalance balance = slideWithArms(line, tables, sceneOf(kLine).load, 1).balance;
  const std::shared_ptr<const ArmTable> table = tables.at(1, line);
  ArmPass plain(line, table->coefficients);
  ArmWorkspace work(table->vectors);
  PassSeconds found;
  const auto take = [](double& fastest, const auto& pass) {
    constexpr int kPasses = 20;
    const double start = threadSeconds();
    for (int i = 0; i < kPasses; ++i) pass();
    fastest = std::min(fastest, (threadSeconds() - start) / kPasses);
  };
  for (int turn = 0; turn < turns; ++turn) {
    take(found.plain, [&] { plain.run(balance.force.depth, balance.strain); });
    take(found.vectors, [&] {
      runArmPass(line, table->vectors, balance.force.depth, balance.strain, Output::Force, work);
    });
  }
  return found;
}

std::string growthTable(int turns) {
  Table table({"arms", "simulation", "passes", "ns an element", "ns an element and arm",
               "a pass at 1 m/s", "the plain pass over it"});
  const std::vector<int> counts{1, 2, 4, 8, 16, 24, 32, 48, 64};
  std::vector<Case> cases;
  for (const int arms : counts)
    cases.emplace_back(std::to_string(arms), withArms(arms, 2e8 / arms, 2e8 / arms));
  measure(cases, turns);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const double each = 1e9 * cases[i].seconds / static_cast<double>(kLine.elements);
    const PassSeconds pass =
        passSeconds(withArms(counts[i], 2e8 / counts[i], 2e8 / counts[i]), turns);
    table.add({cases[i].name, duration(cases[i].seconds), number(cases[i].passes), number(each),
               number(each / counts[i]), duration(pass.vectors),
               number(pass.plain / pass.vectors)});
  }
  return table.text() + "\n";
}

}  // namespace

std::string armsSection(bool isQuick) {
  const int turns = isQuick ? 3 : 15;
  return "## Arms beside Kelvin's element\nFig. 2 with G_inf = 1e7 Pa and 20 arms from 1e-8 to 10 "
         "s: CPU time of one simulation, lines given, the fastest of several turns; \"lines "
         "included\": a line's share added to both.\n\n" +
         ratioTable(turns) +
         "Whole curves, wall-clock time, and CPU time of both threads together:\n\n" +
         curveTable(turns) +
         "From 1 to 64 arms, 2e8 Pa together, of all velocities and of one pass:\n\n" +
         growthTable(turns);
}

}  // namespace asperity::bench
