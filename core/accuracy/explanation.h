// A plan and what it will cost, like a database's EXPLAIN, and as machines read it; as people do:
// app/explanation_text.h. Pure; any thread.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/accuracy/prediction.h"
#include "core/friction/curve_point.h"
#include "core/scene/plan.h"
#include "core/scene/scene.h"

namespace asperity {

/// What a run took, beside what was predicted.
struct Measurement {
  double seconds = 0;
  double memory = 0;  // bytes, by which the process grew; 0 where it did not
  ErrorBudget error;
};

struct Explanation {
  Scene scene;
  std::string verb;  // "curve" or "render"
  std::vector<PlanStage> stages;
  /// m/s, above which few summits carry the load (core/chart/curve_regions.h); NaN: nowhere.
  double fewSummitsVelocity = kNotApplicable;
  double length = 0;                    // m, of the line
  double normalForce = kNotApplicable;  // N, on one period, where the load means one
  NoteSet notes{};                      // of the line and the elastomer, at the scene's velocity
  /// Which frequencies the line excites and how many of them were measured; empty where it is not
  /// known what was measured.
  Message excitation{};
  std::optional<Prediction> predicted{};
  std::optional<Measurement> measured{};
};

/// The plan of `curve` for steady sliding, else of `render`, with the prediction of a curve; that
/// of a motion is added by core/run/motion_accuracy.h.
Explanation explain(const Scene& scene, int threads = 0);

/// Runs the curve and fills `measured`. Nothing for a motion that is not steady.
void analyze(Explanation& explanation, int threads = 0);

std::string explanationJson(const Explanation& explanation);

}  // namespace asperity
