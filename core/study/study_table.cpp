#include "core/study/study_table.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/json_text.h"
#include "core/friction/curve_point.h"
#include "core/scene/columns.h"
#include "core/scene/data_table.h"
#include "core/scene/provenance.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

constexpr ColumnName kSimulation = "simulation", kOutput = "output", kSweepValue = "sweep_value",
                     kValue = "value", kError = "error";
constexpr std::size_t kEnough = std::size_t{1} << 18;  // bytes that are handed over together

/// Returns the names of the numbers of a simulation in a wide table: "mu", and for a curve "mu_1",
/// "mu_2", ...
std::vector<std::string> numberNames(const ParameterStudy& study) {
  const std::size_t values = study.curveValues().size();
  std::vector<std::string> names;
  for (const StudyOutput& output : study.outputs) {
    if (!output.isCurve) names.push_back(output.name);
    for (std::size_t v = 0; output.isCurve && v < values; ++v)
      names.push_back(fmt::format("{}_{}", output.column, v + 1));
  }
  return names;
}

/// Writes the rows of one table.
class TableWriter {
 public:
  TableWriter(const StudyStore& store, TableShape shape, TableFormat format,
              const std::function<void(std::string_view)>& write)
      : store_(store),
        study_(store.study()),
        isLong_(shape == TableShape::Long),
        isJson_(format == TableFormat::Json),
        hasErrors_(store.hasFailures()),
        write_(write),
        point_(study_.space.columns()),
        curve_(study_.curveValues()),
        names_(numberNames(study_)) {
    for (std::size_t c = 0; c < point_.size(); ++c)
      keys_.push_back(quotedJson(study_.space.column(c).key()));
    for (const std::string& name : names_) quotedNames_.push_back(quotedJson(name));
  }

  void begin() {
    const Json origin = studyProvenance(store_);
    if (isJson_) {
      std::string text = jsonFile(origin);
      text.resize(text.size() - 3);  // the closing brace with the line ends around it
      append(text + ",\n  \"rows\": [");
      return;
    }
    append(provenanceComment(origin));
    std::vector<std::string> columns{kSimulation.text()};
    for (std::size_t c = 0; c < point_.size(); ++c)
      columns.emplace_back(study_.space.column(c).key());
    const auto results = isLong_ ? columnNames({kOutput, kSweepValue, kValue}) : names_;
    columns.insert(columns.end(), results.begin(), results.end());
    if (hasErrors_) columns.push_back(kError.text());
    append(tableCsv({std::move(columns), {}}));
  }

  void add(const StudyChunk& chunk) {
    auto failure = chunk.failures.begin();
    for (std::int64_t i = 0; i < chunk.count; ++i) {
      const std::int64_t simulation = chunk.first + i;
      study_.space.pointInto(simulation, point_);
      std::string_view error;
      if (failure != chunk.failures.end() && failure->simulation == simulation)
        error = (failure++)->message;
      if (isLong_)
        addLong(chunk, i, error);
      else
        addWide(chunk, i, error);
      if (buffer_.size() >= kEnough) flush();
    }
  }

  void end() {
    if (isJson_) append(rows_ > 0 ? "\n  ]\n}\n" : "]\n}\n");
    flush();
  }

 private:
  void addWide(const StudyChunk& chunk, std::int64_t i, std::string_view error) {
    beginRow(chunk.first + i);
    for (std::size_t n = 0; n < names_.size(); ++n) {
      name(quotedNames_[n]);
      number(chunk.at(n, i));
    }
    endRow(error);
  }

  void addLong(const StudyChunk& chunk, std::int64_t i, std::string_view error) {
    std::size_t n = 0;
    for (const StudyOutput& output : study_.outputs) {
      const std::size_t count = output.isCurve ? curve_.size() : 1;
      for (std::size_t v = 0; v < count; ++v) {
        beginRow(chunk.first + i);
        name("\"output\"");
        word(output.name);
        name("\"sweep_value\"");
        number(output.isCurve ? curve_[v] : kNotApplicable);
        name("\"value\"");
        number(chunk.at(n++, i));
        endRow(error);
      }
    }
  }

  void beginRow(std::int64_t simulation) {
    if (isJson_) append(rows_ > 0 ? ",\n    {\"simulation\": " : "\n    {\"simulation\": ");
    ++rows_;
    fmt::format_to(std::back_inserter(buffer_), "{}", simulation);
    for (std::size_t c = 0; c < point_.size(); ++c) {
      name(keys_[c]);
      if (study_.space.column(c).hasWords())
        word(study_.textAt(c, point_[c]));
      else
        number(point_[c]);
    }
  }

  void endRow(std::string_view error) {
    if (hasErrors_) {
      name("\"error\"");
      if (!error.empty() || isJson_) word(error, error.empty());
    }
    append(isJson_ ? "}" : "\n");
  }

  /// Begins the next cell: with a comma in CSV, with its name in JSON.
  void name(std::string_view quoted) {
    if (!isJson_) {
      buffer_.push_back(',');
      return;
    }
    append(", ");
    append(quoted);
    append(": ");
  }

  void number(double value) {
    if (std::isfinite(value))
      fmt::format_to(std::back_inserter(buffer_), "{}", value);
    else if (isJson_)
      append("null");
  }

  void word(std::string_view text, bool isNull = false) {
    if (isNull)
      append("null");
    else
      append(isJson_ ? quotedJson(text) : csvCell(text));
  }

  static std::string quotedJson(std::string_view text) { return jsonLine(Json(text)); }

  void append(std::string_view text) { buffer_.append(text.data(), text.data() + text.size()); }
  void flush() {
    write_({buffer_.data(), buffer_.size()});
    buffer_.clear();
  }

  const StudyStore& store_;
  const ParameterStudy& study_;
  bool isLong_, isJson_, hasErrors_;
  const std::function<void(std::string_view)>& write_;
  std::vector<double> point_, curve_;
  std::vector<std::string> names_, keys_, quotedNames_;
  std::int64_t rows_ = 0;
  fmt::memory_buffer buffer_;
};

}  // namespace

Json studyProvenance(const StudyStore& store) {
  const ParameterStudy& study = store.study();
  const Json canonical = jsonValue(study.canonical);
  Json keys = Json::array();
  for (std::size_t c = 0; c < study.space.columns(); ++c)
    keys.push_back(study.space.column(c).key());
  // "asperity-study/1" is the file of a study itself.
  Json origin = {
      {"schema", "asperity-study-results/1"},
      {"verb", "study"},
      {"version", ASPERITY_VERSION},
      {"seed", hasRandomPhases(study.base.surface) ? Json(study.base.surface.seed) : Json()},
      {"study_sha256", study.digest},
      {"simulations", store.simulationsDone()}};
  if (origin["simulations"] != study.simulations()) origin["chunks_sha256"] = store.chunksDigest();
  origin["keys"] = std::move(keys);
  origin["sampling"] = canonical["sampling"];
  if (canonical.contains("samples")) {
    origin["samples"] = canonical["samples"];
    origin["sampling_seed"] = canonical["seed"];
  }
  origin["outputs"] = canonical["outputs"];
  if (study.wantsCurve())
    origin["curve"] = {{"key", study.base.sweep.key}, {"values", study.curveValues()}};
  if (canonical.contains("inputs")) origin["inputs"] = canonical["inputs"];
  addOptions(origin);
  origin["scene"] = canonical["scene"];
  return origin;
}

std::int64_t writeStudyTable(const StudyStore& store, TableShape shape, TableFormat format,
                             const std::function<void(std::string_view)>& write) {
  TableWriter table(store, shape, format, write);
  std::int64_t simulations = 0;
  table.begin();
  store.eachChunk([&](const StudyChunk& chunk) {
    table.add(chunk);
    simulations += chunk.count;
    return true;
  });
  table.end();
  return simulations;
}

}  // namespace asperity
