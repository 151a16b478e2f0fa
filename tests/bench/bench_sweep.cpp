// Figs. 2 and 4 of the paper at N = 5000: the shipped path on every instruction set, and the scalar
// pass. Lines and their block minima are given; the shipped path begins from the depths of another
// line, as in every ensemble, the first line of which is one in 200.
#include <map>

#include "core/contact/kernels/kernels.h"
#include "tests/bench/fields.h"
#include "tests/bench/line_store.h"
#include "tests/bench/workload.h"

namespace asperity::bench {
namespace {

using Lines = std::vector<const PreparedProfile*>;

Lines linesOf(const Resolution& resolution, int count) {
  Lines lines;
  for (int i = 0; i < count; ++i)
    lines.push_back(&preparedProfile({5000, resolution.scheme, resolution.oversampling, i}));
  return lines;
}

/// What `sweep` does for every line and force, one after the other.
template <class Sweep>
Body over(const Resolution& resolution, int lineCount, const std::vector<double>& forces,
          const Sweep& sweep) {
  return [lines = linesOf(resolution, lineCount), forces, sweep] {
    Tally tally{0};
    for (const PreparedProfile* line : lines)
      for (const double force : forces) add(tally, sweep(*line, force));
    return tally;
  };
}

/// The shipped path at these forces on each line.
Body shipped(const Resolution& resolution, int lineCount, const std::vector<double>& forces) {
  const PreparedProfile& another =
      preparedProfile({5000, resolution.scheme, resolution.oversampling, 100});
  std::map<double, std::vector<SteadyResult>> others;
  for (const double force : forces)
    others[force] = shippedResults(another, force, figure2Velocities());
  return over(resolution, lineCount, forces, [others](const PreparedProfile& line, double force) {
    return shippedSweep(line, force, figure2Velocities(), others.at(force));
  });
}

void addShipped(const Resolution& resolution, int lineCount) {
  for (const InstructionSet set :
       {InstructionSet::Scalar, InstructionSet::Avx2, InstructionSet::Avx512}) {
    const bool isHere = chooseInstructionSet(set);
    chooseInstructionSet(InstructionSet::Best);
    if (!isHere) continue;
    addCase(
        figure2Name(instructionSetName(set), resolution.name),
        [=] { return shipped(resolution, lineCount, {kFigure2Force}); }, Clock::Cpu, 0, 0, set);
    if (resolution.scheme == Scheme::Cubic)
      addCase(
          figure4Name(instructionSetName(set)),
          [=] { return shipped(resolution, 1, figure4Forces()); }, Clock::Cpu, 0, 0, set);
  }
}

void addScalar(const Resolution& resolution) {
  addCase(figure2Name("scalar_pass", resolution.name), [=] {
    return over(resolution, 1, {kFigure2Force}, [](const PreparedProfile& line, double force) {
      return scalarSweep(line, force, figure2Velocities());
    });
  });
}

}  // namespace

void addSweepCases(bool quick) {
  for (const Resolution& resolution : kResolutions) {
    addShipped(resolution, quick ? 2 : 8);
    addScalar(resolution);
  }
}

}  // namespace asperity::bench
