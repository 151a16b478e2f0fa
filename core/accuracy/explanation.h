// A plan and its expected cost, like a database's EXPLAIN, in machine-readable form;
// app/explanation_text.h has it as text. Pure; any thread.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/accuracy/map_cost.h"
#include "core/accuracy/prediction.h"
#include "core/friction/curve_point.h"
#include "core/scene/plan.h"
#include "core/scene/scene.h"

namespace asperity {

/// The measured cost of a run, to compare with the prediction.
struct Measurement {
  double seconds = 0;
  double memory = 0;  // bytes by which the process grew; 0 where it did not
  ErrorBudget error;
};

struct Explanation {
  Scene scene;
  std::string verb;  // "curve" or "render"
  std::vector<PlanStage> stages;
  /// Velocity in m/s above which few summits carry the load (core/chart/curve_regions.h); NaN:
  /// none.
  double fewSummitsVelocity = kNotApplicable;
  double length = 0;                    // m, of the line
  double normalForce = kNotApplicable;  // N, on one period, where the load means one
  NoteSet notes{};                      // of the line and the elastomer, at the scene's velocity
  /// Which frequencies the line excites and how many of them were measured; empty where it is not
  /// known what was measured.
  Message excitation{};
  std::optional<Prediction> predicted{};
  std::optional<Measurement> measured{};
  std::optional<MapCost> map{};  // of a map over two parameters, where one is asked for
};

/// Returns the plan of `curve` for steady sliding, else of `render`, with the prediction of a
/// curve; core/run/motion_accuracy.h adds that of a motion.
Explanation explain(const Scene& scene, int threads = 0);

/// Returns the theories that the scene chooses beside its curve; none where it leaves the choice to
/// the program.
std::vector<Theory> theoriesBeside(const Scene& scene);

/// Runs the curve and fills `measured`. It does nothing for a motion that is not steady.
void analyze(Explanation& explanation, int threads = 0);

std::string explanationJson(const Explanation& explanation);

}  // namespace asperity
