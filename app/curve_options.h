// Command-line options for the curves of a friction diagram: axes and their ranges, another setting
// to compare with, and further curves. Main thread.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/chart/curve_set.h"
#include "core/friction/ensemble.h"

namespace CLI {
class App;
}

namespace asperity {

struct CommonOptions;
class RealizationTable;

/// The options as text from the command line; empty: not given.
struct CurveArguments {
  std::string over;  // KEY=FROM:TO:N, instead of the scene's axis
  std::string axes = "physical";
  std::string y = "mu";           // word of a quantity (core/friction/curve_quantity.h)
  std::string xScale, yScale;     // log or linear
  std::string xRange, yRange;     // FROM:TO, in the units of the axes
  std::string family;             // KEY=FROM:TO:N: one further curve for each value
  std::string compare;            // SCHEME[:OVERSAMPLING[:LINES]]
  std::vector<std::string> with;  // KEY=VALUE[;KEY=VALUE...], one for each further curve
  std::vector<std::string> data;  // files of measured friction, beside those of the scene
  std::string theory;             // words separated by commas, instead of those of the scene

  /// Returns the name of an option that is given; null where none is.
  const char* firstOption() const;
  /// Returns whether there are more curves than the scene's own.
  bool hasMore(const Scene& scene) const;
  void addTo(nlohmann::ordered_json& picture) const;
};

void addCurveOptions(CLI::App& command, CurveArguments& arguments);

/// Checks all options before anything is computed. Throws InputError naming the option.
void checkCurves(const CurveArguments& arguments, const Scene& scene);

/// The files that the further scenes of the curves name.
std::vector<std::filesystem::path> filesReadBeside(const CurveArguments& arguments,
                                                   const Scene& scene);

/// Throws InputError where an axis is given but no output file is a picture.
void checkUseful(const CurveArguments& arguments, const std::vector<std::string>& files);

/// A scene with the axis, the measured friction and the theories of the options, as if it named
/// them itself.
struct ComparedScene {
  Scene scene;
  std::vector<FrictionData> given;  // the tables of the options: the last that the scene names
};

/// Reads the tables of the options, so that errors are reported before anything is computed. Throws
/// InputError naming the file or the option.
ComparedScene withCurveOptions(Scene scene, const CurveArguments& arguments);

/// Computes the scene's curve with the options that all commands share
/// (core/accuracy/compute_curve.h), and shows progress. A missed target is no error here: commands
/// write what was computed, and then end with the reason.
/// lines: gets the results of each random line; may be null.
Curve computeCurve(const Scene& scene, const CommonOptions& common,
                   RealizationTable* lines = nullptr);

/// Returns the requested curves before anything is computed, from which the size of their chart is
/// checked. Over velocity they are flat lines that stand for what will be computed, with the panels
/// of their chart; over another key they have no points and no measured friction. There are no
/// theories, and the names of means are not those of the chart. Throws InputError.
CurveSet plannedCurveSet(const CurveArguments& arguments, const ComparedScene& compared);

/// The curves of a chart.
struct ComputedCurves {
  CurveSet set;
  /// Why the first of those that miss their target does so, then names and errors of the others.
  std::optional<Message> missed;

  /// Throws std::runtime_error with this reason.
  void requireTargets() const;
};

/// Returns the given curve of the scene together with the requested further curves. Shows progress.
/// Throws InputError.
ComputedCurves makeCurveSet(const CurveArguments& arguments, const ComparedScene& compared,
                            Curve own, const CommonOptions& common);

/// Adds the curves to `answer`, one object for each curve beside the scene's own; adds nothing
/// where there is none.
void addCurvesTo(nlohmann::ordered_json& answer, const CurveSet& set);

}  // namespace asperity
