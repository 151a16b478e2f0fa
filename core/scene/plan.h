// The plan: the effects that a scene needs, and therefore the stages that run. Each question is
// answered in one place, needsStage, which the running code asks as well, so the plan shows what is
// really done. Pure functions; any thread. stageCounts() is for tests: it counts the stages that
// ran.
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

/// The stages in the order in which they run.
enum class Stage {
  Line,               // makes the rigid line from its spectrum, formula or file
  RollOff,            // lets its spectrum end at long waves
  SummitCorrelation,  // correlates the phases of its waves
  TemperatureShift,   // shifts all relaxation times
  FreeSurface,        // lets the free surface recover, with one relaxation time or more
  Arms,               // computes the internal variables of Maxwell arms
  StartFromRest,      // finds the static equilibrium at v = 0
  SteadyPass,         // finds the one shape that is stationary in the line's frame
  ContactSearch,      // finds the edges of contact, where contact is not complete
  Periodicity,        // makes the strains of arms the same again after a period
  ForceBalance,       // finds the indentation at which the force is carried
  TimeMarch,          // advances the elastomer step after step
  Interface,          // adds local friction
  Sweep,              // computes many velocities
  Averaging,          // averages over realizations
  Shape,              // computes the elastomer's shape at every point
};
inline constexpr std::size_t kStages = static_cast<std::size_t>(Stage::Shape) + 1;

/// The purpose of a run. The window moves the picture, and draws the curve beside it.
enum class Purpose { Curve, Picture, Surface, Window };

/// Returns whether the scene needs the stage. Effects of strength 0 are not needed.
bool needsStage(const Scene& scene, Purpose purpose, Stage stage);

struct PlanStage {
  Stage stage;
  std::string name;  // "time march"
  bool runs;
  Message reason;  // one sentence without a full stop: why it runs, or why it does not
};

/// Returns all stages in order. Throws InputError where effects exclude each other (checkEffects).
std::vector<PlanStage> planStages(const Scene& scene, Purpose purpose);

std::string_view stageName(Stage stage);

/// The number of runs of each stage in this process.
using StageCounts = std::array<std::uint64_t, kStages>;
StageCounts stageCounts();
/// Counts a run of a stage; called by its code. It costs one addition.
void countStage(Stage stage);

}  // namespace asperity
