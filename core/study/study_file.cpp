#include "core/study/study_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/base/file_digest.h"
#include "core/base/input_error.h"
#include "core/base/json_text.h"
#include "core/base/named_choices.h"
#include "core/base/number_text.h"
#include "core/base/regular_file.h"
#include "core/base/text.h"
#include "core/friction/curve_file.h"
#include "core/scene/provenance.h"
#include "core/scene/scene_check.h"
#include "core/scene/sweep.h"
#include "core/study/study_axes.h"
#include "core/study/study_space.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kSchema = "asperity-study/1";
constexpr std::size_t kLargest = std::size_t{1} << 24;  // bytes of a study file
constexpr int kDeepest = 12;
constexpr std::int64_t kMaxSimulations = std::int64_t{1} << 40;
constexpr std::int64_t kMaxSobol = std::int64_t{1} << 32;
constexpr std::int64_t kMaxInChunk = 4096;
constexpr std::string_view kRows = "rows";
constexpr std::string_view kCurve = "curve.", kFit = "fit.";

constexpr NamedChoices<Sampling, 4> kSamplings{{{"grid", Sampling::Grid},
                                                {"latin_hypercube", Sampling::LatinHypercube},
                                                {"sobol", Sampling::Sobol},
                                                {"saltelli", Sampling::Saltelli}}};

std::vector<std::string_view> fitNames() {
  std::vector<std::string_view> names;
  for (const CurveFitEntry& entry : kCurveFits) names.push_back(entry.name);
  return names;
}

StudyOutput readOutput(const Json& json) {
  if (!json.is_string()) refuseMember("outputs", "needs a list of names");
  StudyOutput output;
  output.name = json.get<std::string>();
  const bool isFit = output.name.starts_with(kFit);
  output.isCurve = output.name.starts_with(kCurve);
  output.column = output.isCurve ? output.name.substr(kCurve.size()) : output.name;
  std::vector<std::string_view> known = isFit ? fitNames() : curveColumns();
  std::erase_if(known, [](std::string_view name) { return name == "mu_low" || name == "mu_high"; });
  const auto found = std::ranges::find(known, output.column);
  if (found != known.end()) {
    if (isFit) output.fit = static_cast<CurveFit>(found - known.begin());
    return output;
  }
  const std::string_view nearest = nearestWord(output.column, known);
  const Message all = namesWithCommas(known);
  if (isFit && nearest.empty())
    refuseMember("outputs", message("'{}' is unknown; known are {}", shortened(output.name), all));
  refuseMember(
      "outputs",
      nearest.empty()
          ? message("'{}' is unknown; known are {}, curve.NAME for a whole curve, and fit.NAME for "
                    "what sums it up",
                    shortened(output.name), all)
          : message("'{}' is unknown; the nearest known one is {}", shortened(output.name),
                    output.isCurve ? std::string(kCurve) + std::string(nearest)
                                   : std::string(nearest)));
}

/// Returns how many simulations take about a second: a killed process loses no more than these.
std::int64_t usualChunk(const ParameterStudy& study) {
  constexpr double kNodesInSecond = 2e8;
  const Scene& scene = study.base;
  const auto states = static_cast<double>(study.states());
  const double lines = mayHaveManyLines(scene.surface)
                           ? std::max<double>(1, static_cast<double>(scene.ensemble.realizations))
                           : 1;
  const double elements = std::max<double>(100, static_cast<double>(scene.surface.elements));
  const double arms = 1 + 10 * static_cast<double>(scene.elastomer.arms.size());
  const double simulations = kNodesInSecond / (2 * elements * lines * states * arms);
  const auto most = std::max<std::int64_t>(1, static_cast<std::int64_t>(kMaxInChunk / states));
  std::int64_t chunk = 1;
  while (2 * chunk <= most && 2 * static_cast<double>(chunk) <= simulations) chunk *= 2;
  return chunk;
}

class StudyReader {
 public:
  StudyReader(const Json& root, std::filesystem::path folder, const SceneReader& readNamed)
      : root_(root), folder_(std::move(folder)), readNamed_(readNamed) {}

  ParameterStudy read() {
    checkMembers(root_, "",
                 {"schema", "title", "scene", "set", "space", "sampling", "samples", "seed",
                  "outputs", "chunk", "inputs"});
    if (textMember(root_, "schema") != kSchema)
      refuseMember("schema", message("is not {}", kSchema));
    sampling_ = chosen(kSamplings, textMember(root_, "sampling", "grid"), "sampling");
    readBase();
    readSpace();
    study_.title = textMember(root_, "title", study_.base.title);
    readOutputs();
    study_.chunk = root_.contains("chunk") ? integerMember(root_, "chunk", 1, kMaxInChunk)
                                           : usualChunk(study_);
    checkSteady();
    setCanonical();
    return std::move(study_);
  }

 private:
  void readBase() {
    std::vector<std::string> assignments;
    if (const auto set = root_.find("set"); set != root_.end()) {
      if (!set->is_object()) refuseMember("set", "needs an object of keys");
      for (const auto& [key, value] : set->items()) {
        if (!findParameter(key)) {
          const std::string_view nearest = nearestKey(key);
          refuseMember("set." + shortened(key),
                       nearest.empty()
                           ? message("unknown key")
                           : message("unknown key; the nearest known one is {}", nearest));
        }
        assignments.push_back(key + "=" + assignedText(value));
      }
    }
    const auto scene = root_.find("scene");
    if (scene == root_.end())
      study_.base = readScene("{}", "", folder_, assignments);
    else if (scene->is_string())
      study_.base = named(scene->get<std::string>(), assignments);
    else if (!scene->is_object())
      refuseMember("scene", "needs an object");
    else
      study_.base = readScene(scene->dump(), "", folder_, assignments);
  }

  Scene named(const std::string& name, const std::vector<std::string>& assignments) const {
    try {
      return readNamed_ ? readNamed_(name, folder_, assignments)
                        : readSceneFile(folder_ / name, assignments);
    } catch (const InputError& error) {
      throw InputError("", "scene", errorMessage(error));
    }
  }

  void readSpace() {
    std::vector<StudyAxis> axes = readAxes();
    const Samples samples = readSamples(axes.size());
    study_.space = StudySpace(std::move(axes), sampling_, samples.count, samples.seed);
    if (study_.space.size() > kMaxSimulations)
      refuseMember("space", message("plans more than {} simulations", kMaxSimulations));
  }

  std::vector<StudyAxis> readAxes() {
    const auto space = root_.find("space");
    if (space == root_.end() || !space->is_object() || space->empty())
      refuseMember("space", "needs an object of keys and what they are varied over");
    std::vector<StudyAxis> axes;
    std::set<std::string_view> keys;
    for (const auto& [key, spec] : space->items()) {
      axes.push_back(key == kRows ? readRows(spec, "space.rows", folder_)
                                  : readAxis(key, spec, sampling_ == Sampling::Grid));
      hasRows_.push_back(key == kRows);
      for (const StudyColumn& column : axes.back().columns) {
        if (!keys.insert(column.key()).second) refuseColumn(column, "is varied twice");
        const auto set = root_.find("set");
        if (set != root_.end() && set->contains(std::string(column.key())))
          refuseColumn(column, "is in set and in space; one of them is enough");
        study_.isSlow |= column.hasWords() || isKind(*column.row);
      }
    }
    if (study_.isSlow) return axes;
    for (const StudyAxis& axis : axes)
      for (const StudyColumn& column : axis.columns)
        if (!isApplicable(*column.row, study_.base))
          refuseColumn(column, "has no meaning in this scene, so nothing depends on it");
    return axes;
  }

  [[noreturn]] static void refuseColumn(const StudyColumn& column, const Message& why) {
    refuseMember("space." + std::string(column.key()), why);
  }

  struct Samples {
    std::int64_t count = 0, seed = 1;  // a grid has none
  };

  Samples readSamples(std::size_t axes) const {
    const bool isGrid = sampling_ == Sampling::Grid;
    const bool isSobol = sampling_ == Sampling::Sobol || sampling_ == Sampling::Saltelli;
    const std::size_t dimensions = sampling_ == Sampling::Saltelli ? 2 * axes : axes;
    if (isSobol && dimensions > kMaxSobolDimensions)
      refuseMember("space", message("has {} keys; with this sampling at most {} are allowed", axes,
                                    kMaxSobolDimensions * axes / dimensions));
    for (const char* member : {"samples", "seed"})
      if (isGrid && root_.contains(member))
        refuseMember(member, "has no meaning for sampling grid; it belongs to all others");
    Samples samples;
    if (isGrid) return samples;
    if (!root_.contains("samples"))
      refuseMember("samples", "is missing; only sampling grid does without");
    samples.count = integerMember(root_, "samples", 1, isSobol ? kMaxSobol : kMaxSimulations);
    if (root_.contains("seed"))
      samples.seed = integerMember(root_, "seed", 0, (std::int64_t{1} << 53) - 1);
    return samples;
  }

  void readOutputs() {
    const auto outputs = root_.find("outputs");
    if (outputs == root_.end()) {
      study_.outputs = {{"mu", "mu", false}};
      return;
    }
    if (!outputs->is_array() || outputs->empty()) refuseMember("outputs", "needs a list of names");
    for (const Json& json : *outputs) {
      study_.outputs.push_back(readOutput(json));
      for (std::size_t i = 0; i + 1 < study_.outputs.size(); ++i)
        if (study_.outputs[i].name == study_.outputs.back().name)
          refuseMember("outputs", message("{} is named twice", study_.outputs[i].name));
    }
    if (study_.wantsCurve())
      for (std::size_t c = 0; c < study_.space.columns(); ++c)
        if (study_.space.column(c).key() == study_.base.sweep.key)
          refuseColumn(study_.space.column(c),
                       "is what the curve goes over, so it cannot be varied as well");
    for (const StudyOutput& output : study_.outputs)
      if (output.fit) checkFit(output);
  }

  /// Throws InputError for a fit that the curve of the base scene cannot have, as its column would
  /// be empty. Where kinds are varied, some simulations may have it.
  void checkFit(const StudyOutput& output) const {
    const std::size_t points = study_.curveValues().size();
    if (points < kMinFitted)
      refuseMember("outputs",
                   message("{} needs a curve of at least {} points; sweep.points gives {}",
                           output.name, kMinFitted, points));
    const bool isOfRegions = kCurveFits[static_cast<std::size_t>(*output.fit)].isOfRegions;
    if (!isOfRegions || study_.isSlow) return;
    if (!study_.base.sweep.isOfVelocity())
      refuseMember("outputs", message("{} needs a curve over velocity, not over {}", output.name,
                                      study_.base.sweep.key));
    const Elastomer& elastomer = study_.base.elastomer;
    if (hasArms(elastomer.rheology) && !elastomer.arms.empty())
      refuseMember("outputs",
                   message("{} needs an elastomer of one relaxation time, whose curve has "
                           "regions I to IV",
                           output.name));
  }

  void checkSteady() const {
    requireSteadySliding(study_.base, "a study");
    if (choosesAccuracy(study_.base))
      refuseMember("accuracy.target_relative_error",
                   "a study needs a stated accuracy, not a target");
    if (study_.wantsPoint() && !(study_.base.sliding.velocity > 0))
      refuseMember(std::string(kVelocityKey), "is not above 0, where friction is wanted");
  }

  void setCanonical() {
    Json text = {{"schema", kSchema}};
    Scene untitled = study_.base;
    untitled.title = untitled.description = untitled.chapter = "";
    untitled.comparison = {};
    study_.baseText = writeScene(untitled);
    text["scene"] = jsonValue(study_.baseText);
    Json& space = text["space"] = Json::object();
    for (std::size_t a = 0; a < study_.space.axes().size(); ++a) {
      const StudyAxis& axis = study_.space.axes()[a];
      if (hasRows_[a])
        space[std::string(kRows)] = rowsJson(axis);
      else
        space[std::string(axis.columns.front().key())] = axisJson(axis);
    }
    text["sampling"] = choiceWord(kSamplings, sampling_);
    if (sampling_ != Sampling::Grid) {
      text["samples"] = study_.space.samples();
      text["seed"] = study_.space.seed();
    }
    Json& outputs = text["outputs"] = Json::array();
    for (const StudyOutput& output : study_.outputs) outputs.push_back(output.name);
    text["chunk"] = study_.chunk;
    // This adds the content of the files that the scene names; a text from a store has it already.
    if (root_.contains("inputs")) {
      text["inputs"] = root_["inputs"];
    } else {
      const Json origin = provenance("study", untitled);
      if (origin.contains("inputs")) text["inputs"] = origin["inputs"];
    }
    study_.canonical = text.dump(1);
    study_.digest = sha256(study_.canonical);
  }

  const Json& root_;
  std::filesystem::path folder_;
  const SceneReader& readNamed_;
  Sampling sampling_ = Sampling::Grid;
  std::vector<bool> hasRows_;  // of each axis: whether it is a table
  ParameterStudy study_;
};

}  // namespace

const char* const kStudyFormat =
    R"(STUDY.json:
  {"schema": "asperity-study/1", "scene": "figure_2.json", "set": {"ensemble.realizations": 10},
   "space": {"load.normal_force": {"from": 1e-3, "to": 1, "points": 10, "scale": "log"},
             "surface.hurst": [0.3, 0.7, 1]},
   "sampling": "grid", "outputs": ["mu", "contact_fraction", "curve.mu"]}
A key's values are a list, a range, or {"distribution": "normal", "lognormal" or "uniform", "mean",
"deviation"} with optional limits "from" and "to" (of uniform: the limits alone). Numbers of lists
and ends of ranges are in SI units, or texts with a unit: "1 mN". "rows": "FILE.csv" in space
takes keys and values from the columns of a table. sampling is grid, or with
"samples" and "seed" latin_hypercube, sobol or saltelli (for sensitivity indices: samples times the
number of keys and two); a range then has no points. outputs are columns of a curve at the scene's
velocity, curve.COLUMN at every value of its sweep, and what sums that curve up: fit.maximum,
fit.place_of_maximum, fit.half_width, fit.exponent (the power of what the sweep goes over), and of
one relaxation time fit.plateau, fit.begin_of_region_2 to 4, fit.exponent_region_1 to 4 ('asperity
columns' says more). "chunk": simulations stored at a time.)";

bool ParameterStudy::wantsPoint() const {
  return std::ranges::any_of(outputs, &StudyOutput::isOfPoint);
}

bool ParameterStudy::wantsCurve() const {
  return std::ranges::any_of(outputs,
                             [](const StudyOutput& one) { return one.isCurve || one.fit; });
}

std::vector<double> ParameterStudy::curveValues() const {
  return wantsCurve() ? sweepValues(base) : std::vector<double>();
}

std::size_t ParameterStudy::states() const {
  return curveValues().size() + (wantsPoint() ? 1 : 0);
}

std::size_t ParameterStudy::numbers() const {
  const std::size_t values = curveValues().size();
  std::size_t count = 0;
  for (const StudyOutput& output : outputs) count += output.isCurve ? values : 1;
  return count;
}

Scene ParameterStudy::sceneAt(std::span<const double> point) const {
  if (isSlow) {
    std::vector<std::string> assignments;
    for (std::size_t c = 0; c < point.size(); ++c)
      assignments.push_back(std::string(space.column(c).key()) + "=" + textAt(c, point[c]));
    return readScene(baseText, "", base.folder, assignments);
  }
  Scene scene = base;
  std::size_t index = 0;
  for (const StudyAxis& axis : space.axes())
    for (const StudyColumn& column : axis.columns) setValue(*column.row, scene, point[index++]);
  checkEffects(scene);
  return scene;
}

std::string ParameterStudy::textAt(std::size_t column, double value) const {
  const StudyColumn& one = space.column(column);
  return one.hasWords() ? one.words[static_cast<std::size_t>(value)] : plainNumber(value);
}

ParameterStudy readStudy(const std::filesystem::path& file, const SceneReader& readNamed) {
  return readStudy(readRegularFile(file, kLargest), file.string(), file.parent_path(), readNamed);
}

ParameterStudy readStudy(std::string_view json, const std::string& name,
                         const std::filesystem::path& folder, const SceneReader& readNamed) {
  try {
    const Json root = parseJson(json, kDeepest, "a study is JSON in UTF-8");
    return StudyReader(root, folder, readNamed).read();
  } catch (const InputError& error) {
    throw error.withFile(name);
  }
}

Message describeDifference(std::string_view expected, std::string_view found) {
  constexpr std::size_t kMax = 3;
  const Json before = jsonValue(expected).flatten(), now = jsonValue(found).flatten();
  const auto named = [](std::string path) {
    std::ranges::replace(path, '/', '.');
    return shortened(path.substr(std::min<std::size_t>(1, path.size())));
  };
  std::vector<Message> parts;
  std::size_t more = 0;
  const auto add = [&](Message part) {
    if (parts.size() < kMax)
      parts.push_back(std::move(part));
    else
      ++more;
  };
  for (const auto& [path, value] : now.items()) {
    const auto other = before.find(path);
    if (other == before.end())
      add(message("{} is new", named(path)));
    else if (*other != value)
      add(message("{} is {} instead of {}", named(path), shortened(jsonLine(value)),
                  shortened(other->dump())));
  }
  for (const auto& [path, value] : before.items())
    if (!now.contains(path)) add(message("{} is missing", named(path)));
  if (more > 0) parts.push_back(message("and {} more", more));
  return listed(parts);
}

}  // namespace asperity
