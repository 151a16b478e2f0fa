// The literal algorithm of the paper: as the program is compiled, and with the widest vectors this
// machine has. For N >= 1e5 it is given 200 steps of steady sliding, the cheapest it has, and the
// time is scaled up to N of them.
#include <algorithm>

#include "core/paper/literal_march.h"
#include "tests/bench/fields.h"
#include "tests/bench/line_store.h"
#include "tests/bench/workload.h"

namespace asperity::bench {
namespace {

constexpr std::int64_t kTimedSteps = 200;
constexpr std::int64_t kExtrapolatedFrom = 100000;

LiteralVectors widest() {
  for (const LiteralVectors vectors : {LiteralVectors::Avx512, LiteralVectors::Avx2})
    if (isSupported(vectors)) return vectors;
  return LiteralVectors::AsCompiled;
}

struct Version {
  const char* path;
  LiteralVectors vectors;
};

/// Steady sliding, one step before the first.
struct Steady {
  std::vector<double> depth;  // m
  double indentation;         // m
};

Steady steadyAt(std::int64_t elements, double force) {
  const PreparedProfile line = prepareProfile(nodeLine(elements), Scheme::Nodal);
  const SlidingConditions conditions{kModulus, kRelaxation, kSlow};
  const double indentation = slideAtForce(line, conditions, force).indentation;
  Steady steady{inLineOrder(line, shapeAt(line, conditions, indentation).depth), indentation};
  std::rotate(steady.depth.begin(), steady.depth.begin() + 1, steady.depth.end());
  return steady;
}

/// The whole march from a flat elastomer.
void addWhole(const Version& version, std::int64_t elements, const Contact& contact) {
  addCase(
      gridName(version.path, elements, contact.name),
      [=]() -> Body {
        const Line& line = nodeLine(elements);
        const double force = forceForContact(preparedProfile({elements}), contact.fraction);
        return [=, &line] {
          const LiteralResult result = literalMarch(line, {kModulus, kRelaxation, kSlow}, force,
                                                    {.vectors = version.vectors});
          return Tally{1, result.sweepsPerStep, result.contactFraction};
        };
      },
      Clock::Cpu, 3, 1e-3);
}

void addExtrapolated(const Version& version, std::int64_t elements, const Contact& contact,
                     std::int64_t steps) {
  addCase(
      gridName(version.path, elements, contact.name),
      [=]() -> Body {
        const Line& line = nodeLine(elements);
        const double force = forceForContact(preparedProfile({elements}), contact.fraction);
        return [=, &line, steady = steadyAt(elements, force)] {
          const LiteralResult result =
              literalMarch(line, {kModulus, kRelaxation, kSlow}, force,
                           {steps, steady.depth, steady.indentation, version.vectors});
          const double scale = static_cast<double>(elements) / static_cast<double>(steps);
          return Tally{1, result.sweepsPerStep, result.contactFraction, scale};
        };
      },
      Clock::Cpu, steps < kTimedSteps ? 1 : 3, 1e-3);
}

/// The mean over the velocities of Fig. 2; `stride` leaves some of them out.
void addFigure2(const Version& version, std::size_t stride) {
  const auto prepare = [=]() -> Body {
    const Line& line = nodeLine(5000);
    return [=, &line] {
      Tally tally{0};
      for (std::size_t i = 0; i < figure2Velocities().size(); i += stride) {
        const LiteralResult result =
            literalMarch(line, {kModulus, kRelaxation, figure2Velocities()[i]}, kFigure2Force,
                         {.vectors = version.vectors});
        add(tally, {1, result.sweepsPerStep, result.contactFraction});
      }
      return tally;
    };
  };
  addCase(figure2Name(version.path, "nodal"), prepare, Clock::Cpu, 3, 1e-3);
}

}  // namespace

void addLiteralCases(bool quick) {
  for (const Version& version :
       {Version{"literal", LiteralVectors::AsCompiled}, Version{"literal_wide", widest()}}) {
    addFigure2(version, quick ? 5 : 1);
    for (const std::int64_t elements : kElements)
      for (const Contact& contact : kContacts) {
        if (elements < kExtrapolatedFrom)
          addWhole(version, elements, contact);
        else
          addExtrapolated(version, elements, contact, quick ? kTimedSteps / 10 : kTimedSteps);
      }
  }
}

}  // namespace asperity::bench
