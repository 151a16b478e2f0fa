// Friction for Python: curves, many states in one call, sensitivities, fits.
#include <pybind11/stl.h>

#include <cmath>
#include <ctime>
#include <nlohmann/json.hpp>

#include "app/python/arrays.h"
#include "app/python/call.h"
#include "app/python/module.h"
#include "core/accuracy/compute_curve.h"
#include "core/base/input_error.h"
#include "core/base/json_text.h"
#include "core/base/number_text.h"
#include "core/chart/curve_set.h"
#include "core/chart/fit_report.h"
#include "core/chart/influence_sheets.h"
#include "core/fit/derivatives.h"
#include "core/fit/fit.h"
#include "core/friction/curve_file.h"
#include "core/friction/parameter_map.h"
#include "core/friction/steady_states.h"
#include "core/scene/provenance.h"
#include "core/scene/range.h"
#include "core/scene/scene_check.h"
#include "core/surface/measured_summary.h"

namespace asperity {
namespace {

namespace py = pybind11;
using Json = nlohmann::ordered_json;
using Texts = std::vector<std::string>;
using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// Returns the options of a computation of states that Python waits for.
StateOptions callOptions(const Call& call, int threads) {
  return {.threads = threads, .stop = call.stop(), .progress = [&call](double part) {
            call.report(part);
          }};
}

// ---- curves

/// A curve with the scene that it belongs to.
struct CurveOfScene {
  Scene scene;
  Curve curve;
};

std::shared_ptr<CurveOfScene> runCurve(const Scene& scene, int threads,
                                       const py::object& progress) {
  checkThreads(threads);
  requireSteadySliding(scene, "asperity.curve");
  return compute(progress, [scene, threads](const Call& call) {
    CurveOptions options{.threads = threads, .stop = call.stop()};
    options.progress = [&call](const CurveProgress& done) {
      call.report(done.realizationsDone, done.realizationsTotal);
    };
    return std::make_shared<CurveOfScene>(CurveOfScene{scene, computeCurve(scene, options)});
  });
}

/// Returns the columns of the answer that the program writes, which has them for any swept key.
py::dict curveArrays(const CurveOfScene& found) {
  return toColumns(jsonValue(curveJson(found.curve.points, found.scene))["points"]);
}

// ---- many states in one call

/// Values of a key, one for each state.
struct Override {
  const Parameter* row;
  std::vector<double> values;
};

/// States of one call: each is a scene of about a kilobyte.
constexpr std::size_t kMaxStates = 200000;

std::vector<Scene> variedScenes(const Scene& scene, const std::vector<Override>& overrides,
                                std::size_t count, const std::stop_token& stop) {
  Scene plain = scene;  // words and lists beside a curve mean nothing here, but would be copied
  plain.title.clear();
  plain.description.clear();
  plain.chapter.clear();
  plain.comparison = {};
  plain.sweep = {};
  std::vector<Scene> states;
  states.reserve(count);
  for (std::size_t i = 0; i < count && !stop.stop_requested(); ++i) {
    Scene& state = states.emplace_back(plain);
    for (const Override& one : overrides) setValue(*one.row, state, one.values[i]);
    checkScene(state);
  }
  return states;
}

double processSeconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct FoundStates {
  std::vector<CurvePoint> points;
  std::size_t computed = 0;
  double kernelSeconds = 0;
};

/// Returns the columns, how many states were slid, and the processor time of sliding them.
py::tuple friction(const Scene& scene, const Texts& keys, const std::vector<Numbers>& values,
                   int threads, const py::object& progress) {
  checkThreads(threads);
  requireSteadySliding(scene, "asperity.friction");
  requireNoTarget(scene, "states side by side have the same lines");
  std::vector<Override> overrides;
  std::size_t count = 1;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const Parameter& row = numberRow(keys[k]);
    if (!isApplicable(row, scene)) throw InputError("", keys[k], "has no meaning in this scene");
    const double* first = values[k].data();
    overrides.push_back({&row, {first, first + values[k].size()}});
    count = overrides.back().values.size();
    if (count > kMaxStates)
      throw InputError("", keys[k],
                       message("{} states are more than {} in one call", count, kMaxStates));
  }
  FoundStates found = compute(progress, [scene, overrides, count, threads](const Call& call) {
    const std::vector<Scene> states = variedScenes(scene, overrides, count, call.stop());
    const auto options = callOptions(call, threads);
    const double before = processSeconds();
    SteadyStates slid = slideStates(states, options);
    return FoundStates{std::move(slid.points), slid.computed, processSeconds() - before};
  });
  return py::make_tuple(toColumns(found.points), found.computed, found.kernelSeconds);
}

// ---- maps

std::shared_ptr<ParameterMap> runMap(const Scene& scene, const Texts& x, const Texts& y,
                                     int threads, const py::object& progress) {
  checkThreads(threads);
  requireSteadySliding(scene, "asperity.map");
  const ParameterRange xRange = parseRange(x.at(0), x.at(1)), yRange = parseRange(y.at(0), y.at(1));
  const MapAxis alongX = mapAxis(scene, xRange, &yRange);
  const MapAxis alongY = mapAxis(scene, yRange, &xRange);
  return compute(progress, [scene, alongX, alongY, threads](const Call& call) {
    const auto options = callOptions(call, threads);
    return std::make_shared<ParameterMap>(parameterMap(scene, alongX, alongY, options));
  });
}

constexpr const char* kShown = "mu";  // the default of the program

std::string mapText(const ParameterMap& map) {
  const ProvenanceOptions none(Json::object());
  return provenanceComment(mapProvenance(map, kShown)) + mapCsv(map, kShown);
}

// ---- sensitivity

struct SensitivityOfScene {
  Scene scene;
  std::vector<Sensitivity> all;
  std::vector<Exponent> exponents;
};

std::shared_ptr<SensitivityOfScene> runSensitivity(const Scene& scene, int threads,
                                                   const py::object& progress) {
  checkThreads(threads);
  requireSteadySliding(scene, "asperity.sensitivity");
  return compute(progress, [scene, threads](const Call& call) {
    const auto options = callOptions(call, threads);
    std::vector<Sensitivity> all = sensitivities(scene, options);
    std::vector<Exponent> exponents = sensitivityExponents(scene, all);
    return std::make_shared<SensitivityOfScene>(
        SensitivityOfScene{scene, std::move(all), std::move(exponents)});
  });
}

/// Returns key, value, exponent and its error as the program writes them, then the slope with its
/// error, and whether it is by the logarithm.
py::list sensitivityRows(const SensitivityOfScene& found) {
  py::list rows;
  for (const Exponent& one : found.exponents) {
    const auto sensitivity = std::ranges::find(found.all, one.key, &Sensitivity::key);
    rows.append(py::make_tuple(std::string(one.key), one.value, one.exponent.value,
                               one.exponent.standardError, sensitivity->slope.value,
                               sensitivity->slope.standardError, sensitivity->isLogarithmic));
  }
  return rows;
}

// ---- fits

struct FitOfScene {
  Scene scene;
  Fit fit;
  std::vector<FrictionData> data;
  Texts varied;
  bool hasProfiles = true;
  bool hasFiles = true;  // all its tables are files, so that it can be made again

  /// The options as the program has them for the file fit.json.
  std::string answer() const {
    Json options = fitOptions(varied, hasProfiles);
    options["file"] = "fit";
    const ProvenanceOptions given(hasFiles ? std::move(options) : Json());
    return fitAnswer(scene, readingFacts(scene), fit, varied);
  }
};

/// tables: names and texts of tables that are no files.
std::shared_ptr<FitOfScene> runFit(const Scene& given, const Texts& files,
                                   const std::vector<std::pair<std::string, std::string>>& tables,
                                   const Texts& varied, bool hasProfiles, int threads,
                                   const py::object& progress) {
  checkThreads(threads);
  Scene scene = given;
  const std::vector<FrictionData> read = addComparisonData(scene, files);
  if (scene.comparison.data.empty() && tables.empty()) throw missingFrictionData();
  const std::vector<VariedParameter> parameters = parseVariedParameters(varied, scene);
  std::vector<FrictionData> data = readComparisonData(scene, read);
  for (const auto& [name, text] : tables) data.push_back(parseFrictionData(text, name));
  const bool hasFiles = tables.empty();
  return compute(progress, [scene, data, varied, parameters, hasProfiles, hasFiles,
                            threads](const Call& call) {
    FitOptions options;
    options.threads = threads;
    options.stop = call.stop();
    options.hasProfiles = hasProfiles;
    options.progress = [&call](int evaluations, double) {
      // The number of steps is not known beforehand: the rest shrinks by a part with each.
      constexpr double kDefault = 50;
      call.report(1 - std::exp(-evaluations / kDefault));
    };
    return std::make_shared<FitOfScene>(FitOfScene{
        scene, fitFriction(scene, data, parameters, options), data, varied, hasProfiles, hasFiles});
  });
}

}  // namespace

void addFriction(py::module_& module) {
  py::class_<CurveOfScene, std::shared_ptr<CurveOfScene>>(module, "Curve")
      .def("columns", &curveArrays)
      .def("scene", [](const CurveOfScene& found) { return found.scene; })
      .def("csv",
           [](const CurveOfScene& found) {
             const ProvenanceOptions none(Json::object());
             return provenanceComment("curve", found.scene) +
                    curveCsv(found.curve.points, columnsFor(found.scene));
           })
      .def("json",
           [](const CurveOfScene& found) {
             const ProvenanceOptions none(Json::object());
             return curveJson(found.curve.points, found.scene);
           })
      .def("achieved_error", [](const CurveOfScene& found) { return found.curve.achievedError; })
      .def("is_target_met", [](const CurveOfScene& found) { return found.curve.isTargetMet; });
  py::class_<FitOfScene, std::shared_ptr<FitOfScene>>(module, "Fit")
      .def("scene", [](const FitOfScene& found) { return found.fit.scene; })
      .def("json", &FitOfScene::answer)
      .def("csv", [](const FitOfScene& found) { return fitCsv(found.fit, found.data); });
  py::class_<SensitivityOfScene, std::shared_ptr<SensitivityOfScene>>(module, "Sensitivity")
      .def("rows", &sensitivityRows)
      .def("scene", [](const SensitivityOfScene& found) { return found.scene; })
      .def("csv",
           [](const SensitivityOfScene& found) {
             const ProvenanceOptions none(Json::object());
             return provenanceComment("sensitivity", found.scene) + sensitivityCsv(found.exponents);
           })
      .def("json", [](const SensitivityOfScene& found) {
        const ProvenanceOptions none(Json::object());
        return sensitivityJson(found.scene, found.exponents);
      });
  py::class_<ParameterMap, std::shared_ptr<ParameterMap>>(module, "Map")
      .def("columns", [](const ParameterMap& map) { return toColumns(map.points); })
      .def("x", [](const ParameterMap& map) { return toArray(map.x.values); })
      .def("y", [](const ParameterMap& map) { return toArray(map.y.values); })
      .def("computed", [](const ParameterMap& map) { return map.computed; })
      .def("scene", [](const ParameterMap& map) { return map.scene; })
      .def("csv", &mapText)
      .def("json", [](const ParameterMap& map) {
        const ProvenanceOptions none(Json::object());
        return mapJson(map, kShown);
      });
  module.def("curve", &runCurve);
  module.def("friction", &friction);
  module.def("sensitivity", &runSensitivity);
  module.def("map", &runMap);
  module.def("fit", &runFit);
}

}  // namespace asperity
