// The plan: which effects a scene calls for, and so which stages run. Each question is answered in
// one place, needsStage, which the code that runs asks as well: what the plan says is what is done.
// Pure functions; any thread. stageCounts() is for tests: it counts what really ran.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"
#include "core/material/element_law.h"
#include "core/scene/scene.h"

namespace asperity {

/// In the order in which they run.
enum class Stage {
  Line,               // the rigid line from its spectrum, formula or file
  RollOff,            // of its spectrum
  SummitCorrelation,  // of its waves
  TemperatureShift,   // of all relaxation times
  FreeSurface,        // that remembers: one relaxation time or more
  Arms,               // internal variables
  StartFromRest,      // static equilibrium at v = 0
  SteadyPass,         // one shape, stationary in the line's frame
  ContactSearch,      // of its edges, where contact is not complete
  Periodicity,        // of the arms: the same strains again after a period
  ForceBalance,       // the indentation at which the force is carried
  TimeMarch,          // step after step
  Interface,          // local friction
  Sweep,              // many velocities
  Averaging,          // over realizations
  Shape,              // of the elastomer at every point
};
inline constexpr std::size_t kStages = static_cast<std::size_t>(Stage::Shape) + 1;

/// What a scene is run for. The window moves the picture, and draws the curve beside it.
enum class Purpose { Curve, Picture, Surface, Window };

/// Whether the scene calls for the stage. Effects of no strength are not called for.
bool needsStage(const Scene& scene, Purpose purpose, Stage stage);

struct PlanStage {
  Stage stage;
  std::string name;  // "time march"
  bool runs;
  Message reason;  // one sentence without a full stop: why it runs, or why it does not
};

/// All stages in order. Throws InputError where effects exclude each other (checkEffects).
std::vector<PlanStage> planStages(const Scene& scene, Purpose purpose);

std::string_view stageName(Stage stage);

/// How often each stage has run in this process.
using StageCounts = std::array<std::uint64_t, kStages>;
StageCounts stageCounts();
/// Called by the code of a stage; costs one addition.
void countStage(Stage stage);

}  // namespace asperity
