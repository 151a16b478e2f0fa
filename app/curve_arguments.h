// What a user says about the curves in a friction diagram: axes and their ranges, another setting
// to compare with, other curves beside. Main thread.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/chart/curve_set.h"
#include "core/friction/ensemble.h"

namespace CLI {
class App;
}

namespace asperity {

struct CommonOptions;

/// As written on the command line; empty: not said.
struct CurveArguments {
  std::string axes = "physical";
  std::string xRange, yRange;     // FROM:TO, in the units of the axes
  std::string compare;            // SCHEME[:OVERSAMPLING[:LINES]]
  std::vector<std::string> with;  // KEY=VALUE[;KEY=VALUE...], one for each curve beside

  /// One that is said; null where none is.
  const char* firstOption() const;
  /// Whether there are more curves than the scene's own.
  bool hasMore() const { return !compare.empty() || !with.empty(); }
  void addTo(nlohmann::ordered_json& picture) const;
};

void addCurveOptions(CLI::App& verb, CurveArguments& arguments);

/// Reads all of it before anything is computed. Throws InputError naming the option.
void checkCurves(const CurveArguments& arguments, const Scene& scene);

/// Axes are a picture's: throws InputError where one is said and no file is a picture.
void checkUseful(const CurveArguments& arguments, const std::vector<std::string>& files);

/// The scene's curve with the options that all verbs share (core/accuracy/compute_curve.h); shows
/// progress. A target that is missed is no error yet: requireTarget() makes it one.
Curve computeCurve(const Scene& scene, const CommonOptions& common);

/// The curves: the scene's own as given, and what is asked for beside. Shows progress. Throws
/// InputError.
CurveSet curvesOf(const CurveArguments& arguments, const Scene& scene, std::vector<CurvePoint> own,
                  const CommonOptions& common);

/// The curves as JSON, one object for each beside the scene's own; nothing is added to `answer`
/// where there is none.
void addCurvesTo(nlohmann::ordered_json& answer, const CurveSet& set);

}  // namespace asperity
