#include "core/study/study_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "core/base/file_digest.h"
#include "core/base/input_error.h"
#include "core/base/json_text.h"
#include "core/base/number_text.h"
#include "core/base/regular_file.h"
#include "core/base/text.h"
#include "core/base/text_table.h"
#include "core/friction/curve_file.h"
#include "core/scene/effects.h"
#include "core/scene/provenance.h"
#include "core/scene/scene_file.h"
#include "core/scene/sweep.h"
#include "core/study/sobol_sequence.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kSchema = "asperity-study/1";
constexpr std::size_t kLargest = std::size_t{1} << 24;       // bytes of a study file
constexpr std::size_t kLargestTable = std::size_t{1} << 28;  // bytes of a table of rows
constexpr int kDeepest = 12;
constexpr std::int64_t kMostValues = 1000000;  // of one list, rows of a table
constexpr std::int64_t kMostSimulations = std::int64_t{1} << 40;
constexpr std::int64_t kMostSobol = std::int64_t{1} << 32;
constexpr std::int64_t kMostInChunk = 4096;
constexpr std::string_view kRows = "rows";
constexpr std::string_view kCurve = "curve.";

[[noreturn]] void refuse(const std::string& key, const Message& why) {
  throw InputError("", key, why);
}

void checkMembers(const Json& object, const std::string& where,
                  std::span<const std::string_view> known) {
  if (!object.is_object()) refuse(where, "needs an object");
  for (const auto& [key, value] : object.items()) {
    if (std::ranges::find(known, key) != known.end()) continue;
    const std::string path = where.empty() ? shortened(key) : where + "." + shortened(key);
    const std::string_view nearest = nearestOf(key, known);
    refuse(path, nearest.empty() ? message("unknown key; known are {}",
                                           fmt::format("{}", fmt::join(known, ", ")))
                                 : message("unknown key; the nearest known one is {}", nearest));
  }
}

void checkMembers(const Json& object, const std::string& where,
                  std::initializer_list<std::string_view> known) {
  checkMembers(object, where, std::span<const std::string_view>(known.begin(), known.size()));
}

double numberIn(const Json& object, const std::string& where, const char* member) {
  const auto found = object.find(member);
  if (found == object.end()) refuse(where + "." + member, "is missing; it needs a number");
  if (!found->is_number()) refuse(where + "." + member, "needs a number");
  return found->get<double>();
}

std::optional<double> optionalNumber(const Json& object, const std::string& where,
                                     const char* member) {
  return object.contains(member) ? std::optional(numberIn(object, where, member)) : std::nullopt;
}

std::int64_t wholeIn(const Json& object, const char* member, std::int64_t least, std::int64_t most,
                     const std::string& where = "") {
  const std::string path = where.empty() ? member : where + "." + member;
  const double number = object.at(member).is_number() ? object.at(member).get<double>() : 0.5;
  if (number != std::floor(number) || number < static_cast<double>(least) ||
      number > static_cast<double>(most))
    refuse(path, message("{} is not a whole number from {} to {}",
                         shortened(object.at(member).dump()), least, most));
  return static_cast<std::int64_t>(number);
}

std::string textIn(const Json& object, const char* member, const std::string& otherwise = "",
                   const std::string& where = "") {
  const auto found = object.find(member);
  if (found == object.end()) return otherwise;
  if (!found->is_string()) refuse(where.empty() ? member : where + "." + member, "needs a text");
  return found->get<std::string>();
}

template <class Choice, std::size_t N>
Choice chosen(const std::array<std::pair<std::string_view, Choice>, N>& choices,
              const std::string& word, const std::string& where) {
  std::array<std::string_view, N> known;
  for (std::size_t i = 0; i < N; ++i) {
    if (choices[i].first == word) return choices[i].second;
    known[i] = choices[i].first;
  }
  refuse(where, notOneOf(word, known));
}

constexpr std::array<std::pair<std::string_view, Sampling>, 4> kSamplings{
    {{"grid", Sampling::Grid},
     {"latin_hypercube", Sampling::LatinHypercube},
     {"sobol", Sampling::Sobol},
     {"saltelli", Sampling::Saltelli}}};
constexpr std::array<std::pair<std::string_view, DistributionKind>, 3> kDistributions{
    {{"normal", DistributionKind::Normal},
     {"lognormal", DistributionKind::Lognormal},
     {"uniform", DistributionKind::Uniform}}};

bool isNumber(const Parameter& row) {
  return allowedRange(row).has_value();
}

/// Throws InputError where no value of the key would be a simulation of its own.
void checkKey(const Parameter& row, const std::string& where) {
  const std::string_view key = row.key;
  for (const std::string_view section : {"sweep.", "comparison."})
    if (key.starts_with(section))
      refuse(where, message("has no influence on one simulation, so it cannot be varied"));
  if (key.find('.') == key.npos)
    refuse(where, message("has no influence on one simulation, so it cannot be varied"));
  if (key == "sliding.kind") refuse(where, "a study slides steadily; it cannot be varied");
  if (key == "accuracy.target_relative_error")
    refuse(where, "a study needs a stated accuracy, not a target");
}

/// Throws InputError where the key does not allow a value.
void checkValue(const Parameter& row, const ParameterValue& value, const std::string& where) {
  Scene scratch;
  try {
    setValue(row, scratch, value);
  } catch (const InputError& error) {
    refuse(where, error.message());
  }
}

/// Adds a value of a list or a table to a column, which has either numbers or words.
void addValue(StudyColumn& column, const Json& value, const std::string& where) {
  const Parameter& row = *column.row;
  if (value.is_number() && isNumber(row)) {
    checkValue(row, value.get<double>(), where);
    column.numbers.push_back(value.get<double>());
    return;
  }
  if (isNumber(row) || !(value.is_string() || (value.is_array() && isList(row))))
    refuse(where, message("{} is not allowed here; allowed is {}", shortened(value.dump()),
                          allowedText(row)));
  std::string word = value.is_string() ? value.get<std::string>() : value.dump();
  checkValue(row, word, where);
  column.words.push_back(std::move(word));
}

/// A range, continuous in a sample and its points in a grid.
void readRange(StudyAxis& axis, const Json& spec, const std::string& where, bool isGrid) {
  checkMembers(spec, where, {"from", "to", "points", "scale"});
  const Parameter& row = *axis.columns.front().row;
  if (!isNumber(row)) refuse(where, "is not a number, so it has no range; a list names its values");
  ParameterRange range{&row, numberIn(spec, where, "from"), numberIn(spec, where, "to"), 1, false};
  checkValue(row, range.from, where + ".from");
  checkValue(row, range.to, where + ".to");
  const bool isPositive = range.from > 0 && range.to > 0;
  range.isLogarithmic = hasLogarithmicSlider(row) && isPositive;
  if (spec.contains("scale")) {
    const std::string scale = textIn(spec, "scale", "", where);
    if (scale != "log" && scale != "linear") refuse(where + ".scale", "is neither log nor linear");
    range.isLogarithmic = scale == "log";
    if (range.isLogarithmic && !isPositive)
      refuse(where + ".scale", message("a logarithmic range needs ends above 0; {} is not",
                                       plain(range.from > 0 ? range.to : range.from)));
  }
  if (!isGrid) {
    if (spec.contains("points"))
      refuse(where + ".points", "has no meaning in a sample; it belongs to sampling grid");
    if (!(range.from < range.to)) refuse(where + ".to", "is not above from");
    axis.range = range;
    return;
  }
  if (!spec.contains("points"))
    refuse(where + ".points", "is missing; a grid needs the number of values");
  range.points = wholeIn(spec, "points", 1, kMostRangePoints, where);
  axis.columns.front().numbers = valuesOf(range);
}

void readDistribution(StudyAxis& axis, const Json& spec, const std::string& where, bool isGrid) {
  checkMembers(spec, where, {"distribution", "mean", "deviation", "from", "to"});
  const Parameter& row = *axis.columns.front().row;
  if (!isNumber(row)) refuse(where, "is not a number, so it has no distribution");
  if (isGrid)
    refuse(where, "a distribution needs sampling latin_hypercube, sobol or saltelli, not a grid");
  Distribution made;
  made.kind =
      chosen(kDistributions, textIn(spec, "distribution", "", where), where + ".distribution");
  const auto from = optionalNumber(spec, where, "from"), to = optionalNumber(spec, where, "to");
  const bool hasMoments = spec.contains("mean") || spec.contains("deviation");
  if (made.kind == DistributionKind::Uniform && hasMoments == (from || to))
    refuse(where, "a uniform distribution has either from and to, or mean and deviation");
  if (made.kind == DistributionKind::Uniform && !hasMoments && !(from && to))
    refuse(where, "a uniform distribution has either from and to, or mean and deviation");
  if (hasMoments || made.kind != DistributionKind::Uniform) {
    made.mean = numberIn(spec, where, "mean");
    made.deviation = numberIn(spec, where, "deviation");
    if (!(made.deviation > 0)) refuse(where + ".deviation", "is not above 0");
  }
  if (made.kind == DistributionKind::Lognormal && !(made.mean > 0))
    refuse(where + ".mean", "of a lognormal distribution is not above 0");
  if (from) checkValue(row, *from, where + ".from");
  if (to) checkValue(row, *to, where + ".to");
  made.from = from.value_or(made.from);
  made.to = to.value_or(made.to);
  if (!(made.from < made.to)) refuse(where + ".to", "is not above from");
  // Limits that leave nothing of the distribution would leave its last digits alone.
  const double middle = made.quantile(0.5);
  if (!(middle > made.from && middle < made.to) || !(made.quantile(0.25) < made.quantile(0.75)))
    refuse(where, "almost nothing of the distribution is between from and to");
  if (made.kind == DistributionKind::Uniform) {
    checkValue(row, made.quantile(0x1p-53), where);
    checkValue(row, made.quantile(1 - 0x1p-53), where);
  }
  axis.distribution = made;
}

/// The rows of a table, whose columns are named by keys; in a canonical text they stand in it.
StudyAxis readRows(const Json& spec, const std::string& where,
                   const std::filesystem::path& folder) {
  StudyAxis axis;
  const auto addColumn = [&](const std::string& key) {
    const Parameter& row = knownParameter(key);
    checkKey(row, where);
    for (const StudyColumn& other : axis.columns)
      if (other.row == &row) refuse(where, message("has two columns of {}", key));
    axis.columns.push_back({&row, {}, {}});
  };
  if (spec.is_object()) {
    checkMembers(spec, where, {"keys", "values"});
    if (!spec.contains("keys") || !spec.contains("values") || !spec["keys"].is_array() ||
        !spec["values"].is_array())
      refuse(where, "needs the lists keys and values, or the name of a table");
    for (const Json& key : spec["keys"]) {
      if (!key.is_string()) refuse(where + ".keys", "needs texts");
      addColumn(key.get<std::string>());
    }
    for (const Json& row : spec["values"]) {
      if (!row.is_array() || row.size() != axis.columns.size())
        refuse(where + ".values", "needs lists of as many values as there are keys");
      for (std::size_t i = 0; i < row.size(); ++i)
        addValue(axis.columns[i], row[i], where + ".values");
    }
  } else if (spec.is_string()) {
    const std::filesystem::path file = folder / spec.get<std::string>();
    TextTableOptions options;
    options.keepsTexts = true;
    const TextTable table =
        readTextTable(readRegularFile(file, kLargestTable), file.string(), options);
    const TextBlock& block = table.largest();
    for (const TextColumn& column : block.columns) {
      const Parameter* row = findParameter(column.name);
      if (!row) {
        const std::string_view nearest = nearestKey(column.name);
        throw InputError(file.string(), "",
                         nearest.empty()
                             ? message("column '{}' is no scene key", shortened(column.name))
                             : message("column '{}' is no scene key; the nearest known one is {}",
                                       shortened(column.name), nearest));
      }
      if (!column.unit.empty() && column.unit != row->unit)
        throw InputError(
            file.string(), "",
            message("column {} is in {}; a study takes plain numbers in {}", column.name,
                    shortened(column.unit), row->unit.empty() ? "1" : row->unit));
      addColumn(column.name);
    }
    for (std::size_t r = 0; r < block.rows; ++r)
      for (std::size_t c = 0; c < block.columns.size(); ++c) {
        const bool isText = block.columns[c].isText;
        if (!isText && std::isnan(block.at(r, c)))
          throw InputError(
              file.string(), "",
              message("line {}: {} is missing", block.lines[r], block.columns[c].name));
        try {
          addValue(axis.columns[c], isText ? Json(block.texts[c][r]) : Json(block.at(r, c)), "");
        } catch (const InputError& error) {
          throw InputError(
              file.string(), "",
              message("line {}: {}: {}", block.lines[r], block.columns[c].name, error.message()));
        }
      }
  } else {
    refuse(where, "needs the name of a table with a column for each key");
  }
  if (axis.columns.empty() || axis.count() == 0) refuse(where, "has no row");
  if (axis.count() > kMostValues)
    refuse(where, message("has {} rows; at most {} are allowed", axis.count(), kMostValues));
  return axis;
}

StudyAxis readAxis(const std::string& key, const Json& spec, bool isGrid) {
  const std::string where = "space." + shortened(key);
  StudyAxis axis;
  try {
    axis.columns = {{&knownParameter(key), {}, {}}};
  } catch (const InputError& error) {
    refuse(where, error.message());
  }
  checkKey(*axis.columns.front().row, where);
  if (spec.is_array()) {
    if (spec.empty()) refuse(where, "has no value");
    if (static_cast<std::int64_t>(spec.size()) > kMostValues)
      refuse(where, message("has {} values; at most {} are allowed", spec.size(), kMostValues));
    for (const Json& value : spec) addValue(axis.columns.front(), value, where);
  } else if (!spec.is_object()) {
    refuse(where,
           "needs a list of values, a range {\"from\", \"to\", \"points\", \"scale\"} or a "
           "distribution");
  } else if (spec.contains("distribution")) {
    readDistribution(axis, spec, where, isGrid);
  } else {
    readRange(axis, spec, where, isGrid);
  }
  return axis;
}

StudyOutput readOutput(const Json& json) {
  if (!json.is_string()) refuse("outputs", "needs a list of names");
  StudyOutput output;
  output.name = json.get<std::string>();
  output.isCurve = output.name.starts_with(kCurve);
  output.column = output.isCurve ? output.name.substr(kCurve.size()) : output.name;
  std::vector<std::string_view> known = curveColumns();
  std::erase_if(known, [](std::string_view name) { return name == "mu_low" || name == "mu_high"; });
  if (std::ranges::find(known, output.column) != known.end()) return output;
  const std::string_view nearest = nearestOf(output.column, known);
  refuse("outputs",
         nearest.empty()
             ? message("'{}' is unknown; known are {}, and curve.NAME for a whole curve",
                       shortened(output.name), fmt::format("{}", fmt::join(known, ", ")))
             : message("'{}' is unknown; the nearest known one is {}", shortened(output.name),
                       output.isCurve ? std::string(kCurve) + std::string(nearest)
                                      : std::string(nearest)));
}

Json valueJson(const StudyColumn& column, std::size_t place) {
  if (!column.hasWords()) return column.numbers[place];
  return column.words[place];
}

Json axisJson(const StudyAxis& axis) {
  if (axis.range)
    return {{"from", axis.range->from},
            {"to", axis.range->to},
            {"scale", axis.range->isLogarithmic ? "log" : "linear"}};
  if (const auto& given = axis.distribution) {
    Json json = {
        {"distribution", std::ranges::find(kDistributions, given->kind,
                                           &std::pair<std::string_view, DistributionKind>::second)
                             ->first}};
    const bool hasLimits = std::isfinite(given->from) && std::isfinite(given->to);
    if (given->kind != DistributionKind::Uniform || !hasLimits) {
      json["mean"] = given->mean;
      json["deviation"] = given->deviation;
    }
    if (std::isfinite(given->from)) json["from"] = given->from;
    if (std::isfinite(given->to)) json["to"] = given->to;
    return json;
  }
  Json list = Json::array();
  for (std::size_t i = 0; i < static_cast<std::size_t>(axis.count()); ++i)
    list.push_back(valueJson(axis.columns.front(), i));
  return list;
}

Json rowsJson(const StudyAxis& axis) {
  Json keys = Json::array(), values = Json::array();
  for (const StudyColumn& column : axis.columns) keys.push_back(column.key());
  for (std::size_t i = 0; i < static_cast<std::size_t>(axis.count()); ++i) {
    Json row = Json::array();
    for (const StudyColumn& column : axis.columns) row.push_back(valueJson(column, i));
    values.push_back(std::move(row));
  }
  return {{"keys", std::move(keys)}, {"values", std::move(values)}};
}

/// About how many simulations take a second: as many as are lost at most where a process is killed.
std::int64_t usualChunk(const ParameterStudy& study) {
  constexpr double kNodesInSecond = 2e8;
  const Scene& scene = study.base;
  const double states =
      (study.wantsPoint() ? 1.0 : 0.0) + static_cast<double>(study.curveValues().size());
  const double lines = mayHaveManyLines(scene.surface)
                           ? std::max<double>(1, static_cast<double>(scene.ensemble.realizations))
                           : 1;
  const double elements = std::max<double>(100, static_cast<double>(scene.surface.elements));
  const double arms = 1 + 10 * static_cast<double>(scene.elastomer.arms.size());
  const double simulations = kNodesInSecond / (2 * elements * lines * states * arms);
  const auto most = std::max<std::int64_t>(1, static_cast<std::int64_t>(kMostInChunk / states));
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
    if (textIn(root_, "schema") != kSchema) refuse("schema", message("is not {}", kSchema));
    sampling_ = chosen(kSamplings, textIn(root_, "sampling", "grid"), "sampling");
    readBase();
    readSpace();
    study_.title = textIn(root_, "title", study_.base.title);
    readOutputs();
    study_.chunk =
        root_.contains("chunk") ? wholeIn(root_, "chunk", 1, kMostInChunk) : usualChunk(study_);
    checkSteady();
    setCanonical();
    return std::move(study_);
  }

 private:
  void readBase() {
    std::vector<std::string> assignments;
    if (const auto set = root_.find("set"); set != root_.end()) {
      if (!set->is_object()) refuse("set", "needs an object of keys");
      for (const auto& [key, value] : set->items()) {
        if (!findParameter(key)) {
          const std::string_view nearest = nearestKey(key);
          refuse("set." + shortened(key),
                 nearest.empty() ? message("unknown key")
                                 : message("unknown key; the nearest known one is {}", nearest));
        }
        assignments.push_back(key + "=" +
                              (value.is_string() ? value.get<std::string>() : value.dump()));
      }
    }
    const auto scene = root_.find("scene");
    if (scene == root_.end())
      study_.base = readScene("{}", "", folder_, assignments);
    else if (scene->is_string())
      study_.base = named(scene->get<std::string>(), assignments);
    else
      study_.base = readScene(scene->dump(), "", folder_, assignments);
  }

  Scene named(const std::string& name, const std::vector<std::string>& assignments) const {
    return readNamed_ ? readNamed_(name, folder_, assignments)
                      : readSceneFile(folder_ / name, assignments);
  }

  void readSpace() {
    const auto space = root_.find("space");
    if (space == root_.end() || !space->is_object() || space->empty())
      refuse("space", "needs an object of keys and what they are varied over");
    const bool isGrid = sampling_ == Sampling::Grid;
    std::vector<StudyAxis> axes;
    std::set<std::string_view> keys;
    for (const auto& [key, spec] : space->items()) {
      axes.push_back(key == kRows ? readRows(spec, "space.rows", folder_)
                                  : readAxis(key, spec, isGrid));
      hasRows_.push_back(key == kRows);
      for (const StudyColumn& column : axes.back().columns) {
        if (!keys.insert(column.key()).second)
          refuse("space." + std::string(column.key()), "is varied twice");
        const auto set = root_.find("set");
        if (set != root_.end() && set->contains(std::string(column.key())))
          refuse("space." + std::string(column.key()),
                 "stands in set and in space; one of them is enough");
        study_.isSlow |= column.hasWords() || isKind(*column.row);
      }
    }
    if (!study_.isSlow)
      for (const StudyAxis& axis : axes)
        for (const StudyColumn& column : axis.columns)
          if (!isApplicable(*column.row, study_.base))
            refuse("space." + std::string(column.key()),
                   "has no meaning in this scene, so nothing depends on it");
    std::int64_t samples = 0, seed = 1;
    const std::size_t dimensions = sampling_ == Sampling::Saltelli ? 2 * axes.size() : axes.size();
    const bool isSobol = sampling_ == Sampling::Sobol || sampling_ == Sampling::Saltelli;
    if (isSobol && dimensions > kMostSobolDimensions)
      refuse("space", message("has {} keys; with this sampling at most {} are allowed", axes.size(),
                              kMostSobolDimensions * axes.size() / dimensions));
    for (const char* member : {"samples", "seed"})
      if (isGrid && root_.contains(member))
        refuse(member, "has no meaning for sampling grid; it belongs to all others");
    if (!isGrid) {
      if (!root_.contains("samples"))
        refuse("samples", "is missing; only sampling grid does without");
      samples = wholeIn(root_, "samples", 1, isSobol ? kMostSobol : kMostSimulations);
      if (root_.contains("seed")) seed = wholeIn(root_, "seed", 0, std::int64_t{1} << 53);
    }
    study_.space = StudySpace(std::move(axes), sampling_, samples, seed);
    if (study_.space.size() > kMostSimulations)
      refuse("space", message("is of more than {} simulations", kMostSimulations));
  }

  void readOutputs() {
    const auto outputs = root_.find("outputs");
    if (outputs == root_.end()) {
      study_.outputs = {{"mu", "mu", false}};
      return;
    }
    if (!outputs->is_array() || outputs->empty()) refuse("outputs", "needs a list of names");
    for (const Json& json : *outputs) {
      study_.outputs.push_back(readOutput(json));
      for (std::size_t i = 0; i + 1 < study_.outputs.size(); ++i)
        if (study_.outputs[i].name == study_.outputs.back().name)
          refuse("outputs", message("{} is named twice", study_.outputs[i].name));
    }
    if (study_.wantsCurve())
      for (std::size_t c = 0; c < study_.space.columns(); ++c)
        if (study_.space.column(c).key() == study_.base.sweep.key)
          refuse("space." + study_.base.sweep.key,
                 "is what the curve goes over, so it cannot be varied as well");
  }

  void checkSteady() const {
    needSteadySliding(study_.base, "a study");
    if (choosesAccuracy(study_.base))
      refuse("accuracy.target_relative_error", "a study needs a stated accuracy, not a target");
    if (study_.wantsPoint() && !(study_.base.sliding.velocity > 0))
      refuse("sliding.velocity", "is not above 0, where friction is wanted");
  }

  void setCanonical() {
    Json text = {{"schema", kSchema}};
    Scene untitled = study_.base;
    untitled.title = untitled.description = untitled.chapter = "";
    untitled.comparison = {};
    study_.baseText = writeScene(untitled);
    text["scene"] = Json::parse(study_.baseText);
    Json& space = text["space"] = Json::object();
    for (std::size_t a = 0; a < study_.space.axes().size(); ++a) {
      const StudyAxis& axis = study_.space.axes()[a];
      if (hasRows_[a])
        space[std::string(kRows)] = rowsJson(axis);
      else
        space[std::string(axis.columns.front().key())] = axisJson(axis);
    }
    text["sampling"] =
        std::ranges::find(kSamplings, sampling_, &std::pair<std::string_view, Sampling>::second)
            ->first;
    if (sampling_ != Sampling::Grid) {
      text["samples"] = study_.space.samples();
      text["seed"] = study_.space.seed();
    }
    Json& outputs = text["outputs"] = Json::array();
    for (const StudyOutput& output : study_.outputs) outputs.push_back(output.name);
    text["chunk"] = study_.chunk;
    // The content of files that the scene names; a text from a store has it already.
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
"deviation"} with limits "from" and "to" where wanted (of uniform: the limits alone). "rows":
"FILE.csv" in space takes keys and values from the columns of a table. sampling is grid, or with
"samples" and "seed" latin_hypercube, sobol or saltelli (for sensitivity indices: samples times the
number of keys and two); a range then has no points. outputs are columns of a curve at the scene's
velocity, and curve.COLUMN at every value of its sweep. "chunk": simulations stored at a time.)";

bool ParameterStudy::wantsPoint() const {
  return std::ranges::any_of(outputs, [](const StudyOutput& one) { return !one.isCurve; });
}

bool ParameterStudy::wantsCurve() const {
  return std::ranges::any_of(outputs, &StudyOutput::isCurve);
}

std::vector<double> ParameterStudy::curveValues() const {
  return wantsCurve() ? sweepValues(base) : std::vector<double>();
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
  std::size_t place = 0;
  for (const StudyAxis& axis : space.axes())
    for (const StudyColumn& column : axis.columns) setValue(*column.row, scene, point[place++]);
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
    throw error.file().empty() ? error.in(name) : error;
  }
}

Message differenceOf(std::string_view expected, std::string_view found) {
  constexpr std::size_t kMost = 3;
  const Json before = Json::parse(expected).flatten(), now = Json::parse(found).flatten();
  const auto named = [](std::string path) {
    std::ranges::replace(path, '/', '.');
    return shortened(path.substr(std::min<std::size_t>(1, path.size())));
  };
  std::vector<Message> parts;
  std::size_t more = 0;
  const auto add = [&](Message part) {
    if (parts.size() < kMost)
      parts.push_back(std::move(part));
    else
      ++more;
  };
  for (const auto& [path, value] : now.items()) {
    const auto other = before.find(path);
    if (other == before.end())
      add(message("{} is new", named(path)));
    else if (*other != value)
      add(message("{} is {} instead of {}", named(path), shortened(value.dump()),
                  shortened(other->dump())));
  }
  for (const auto& [path, value] : before.items())
    if (!now.contains(path)) add(message("{} is missing", named(path)));
  if (more > 0) parts.push_back(message("and {} more", more));
  return listed(parts);
}

}  // namespace asperity
