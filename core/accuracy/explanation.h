// What a run of a scene does and costs, like EXPLAIN of a database: its stages, its line and load,
// and its predicted time, memory and errors, as values and as JSON. app/commands/explain.cpp prints
// them as text. Threading: one thread at a time (time is measured). Failure: as predictCurve.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/accuracy/prediction.h"
#include "core/friction/curve_point.h"
#include "core/scene/plan.h"
#include "core/scene/scene.h"

namespace asperity {

/// The measured cost of a run, to compare with the prediction.
struct Measurement {
  double seconds = 0;
  double memory = 0;  // bytes by which the peak memory of the process grew
  ErrorBudget error;
};

struct Explanation {
  Scene scene;
  std::string verb;  // the command that it explains: "curve" or "render"
  std::vector<PlanStage> stages;
  /// Velocity in m/s above which few contacts carry the load (core/chart/curve_regions.h); NaN:
  /// none.
  double fewContactsVelocity = kNotApplicable;
  double length = 0;                    // m, of the line
  double normalForce = kNotApplicable;  // N, on one period, where the load means one
  std::vector<Message> reading{};       // how the file of the surface was read (readingFacts)
  NoteSet notes{};                      // of the line and the elastomer, at the scene's velocity
  /// Which frequencies the line excites and how many of them were measured; empty where it is not
  /// known what was measured.
  Message excitation{};
  std::optional<Prediction> predicted{};
  std::optional<Measurement> measured{};
  std::optional<MapCost> map{};  // of a map over two parameters, where one is asked for
};

/// Explains `curve` with a prediction where the scene slides steadily, else `render` without one.
/// explainRun (core/run/motion_accuracy.h) adds the prediction of a motion. threads: 0 means as
/// many as the machine has.
Explanation explain(const Scene& scene, int threads = 0);

/// Returns the theories that the scene chooses beside its curve; none where it leaves the choice to
/// the program.
std::vector<Theory> theoriesBeside(const Scene& scene);

/// Runs the curve and fills `measured`. It does nothing where `explanation` has no prediction of a
/// curve; analyzeRun (core/run/motion_accuracy.h) runs motions as well.
void analyze(Explanation& explanation, int threads = 0);

std::string explanationJson(const Explanation& explanation);

}  // namespace asperity
