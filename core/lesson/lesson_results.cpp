#include "core/lesson/lesson_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/atomic_file.h"
#include "core/base/input_error.h"
#include "core/base/json_text.h"
#include "core/base/number_text.h"
#include "core/base/regular_file.h"
#include "core/base/statistics.h"
#include "core/lesson/lesson_json.h"
#include "core/scene/data_table.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kAnyVersion = "asperity-lesson-results/";
constexpr std::string_view kSchema = "asperity-lesson-results/1";
constexpr std::string_view kShown = "shown";                   // in place of an answer
constexpr std::size_t kLargestResults = std::size_t{1} << 20;  // bytes
constexpr int kDeepestResults = 6;

Json answerJson(PredictionKind kind, int choice, double number, double x) {
  if (kind == PredictionKind::Choice) return choice < 0 ? Json(nullptr) : Json(choice + 1);
  if (kind == PredictionKind::Number) return numberOrNull(number);
  if (!std::isfinite(number)) return nullptr;
  return {{"x", numberOrNull(x)}, {"y", numberOrNull(number)}};
}

double numberOrNone(const Json& json, const std::string& path) {
  if (json.is_null()) return kNaN;
  if (!json.is_number()) refuseMember(path, "needs a number or null");
  return json.get<double>();
}

void readAnswer(const Json& json, const std::string& path, PredictionKind kind, int& choice,
                double& number, double& x) {
  if (json.is_null()) return;
  if (kind == PredictionKind::Choice) {
    const Json one = {{"choice", json}};
    choice = static_cast<int>(integerMember(one, "choice", 1, 9, path)) - 1;
  } else if (kind == PredictionKind::Number) {
    number = numberOrNone(json, path);
  } else {
    checkMembers(json, path, {"x", "y"});
    x = json.contains("x") ? numberOrNone(json["x"], path + ".x") : x;
    number = json.contains("y") ? numberOrNone(json["y"], path + ".y") : number;
  }
}

LessonResult readResult(const Json& json, const std::string& path) {
  checkMembers(json, path, {"step", "kind", "given", "expected", "unit", "x_unit", "right"});
  for (const char* member : {"step", "kind", "given", "expected", "right"})
    if (!json.contains(member)) refuseMember(path + "." + member, "is missing");
  LessonResult result;
  result.step =
      static_cast<int>(integerMember(json, "step", 1, static_cast<std::int64_t>(1) << 20, path)) -
      1;
  result.kind = chosen(kPredictionKinds, textMember(json, "kind", "", path), path + ".kind");
  GivenAnswer& given = result.given;
  LessonAnswer& expected = result.expected;
  if (json["given"] != kShown)
    readAnswer(json["given"], path + ".given", result.kind, given.choice, given.number, given.x);
  readAnswer(json["expected"], path + ".expected", result.kind, expected.choice,
             expected.number.value, expected.x.value);
  expected.number.unit = textMember(json, "unit", "", path);
  expected.x.unit = textMember(json, "x_unit", "", path);
  if (!json["right"].is_boolean()) refuseMember(path + ".right", "needs true or false");
  result.isRight = json["right"].get<bool>();
  return result;
}

}  // namespace

void LessonResults::set(const LessonResult& result) {
  std::erase_if(results, [&](const LessonResult& one) { return one.step == result.step; });
  results.insert(std::ranges::upper_bound(results, result.step, {}, &LessonResult::step), result);
}

const LessonResult* LessonResults::find(int step) const {
  const auto found = std::ranges::find(results, step, &LessonResult::step);
  return found == results.end() ? nullptr : &*found;
}

int LessonResults::right() const {
  return static_cast<int>(std::ranges::count_if(results, &LessonResult::isRight));
}

int LessonResults::wrong() const {
  return static_cast<int>(results.size()) - right() - shown();
}

int LessonResults::shown() const {
  return static_cast<int>(
      std::ranges::count_if(results, [](const LessonResult& one) { return !one.given.isGiven(); }));
}

LessonResults emptyResults(const Lesson& lesson) {
  return {lesson.name, lesson.title.in("en"), lesson.digest, {}};
}

std::string resultsJson(const LessonResults& results) {
  Json json = {{"schema", kSchema},        {"lesson", results.lesson}, {"title", results.title},
               {"sha256", results.digest}, {"right", results.right()}, {"shown", results.shown()},
               {"steps", Json::array()}};
  if (!results.date.empty()) json["date"] = results.date;
  for (const LessonResult& one : results.results) {
    Json step = {{"step", one.step + 1},
                 {"kind", choiceWord(kPredictionKinds, one.kind)},
                 {"given", one.given.isGiven() ? answerJson(one.kind, one.given.choice,
                                                            one.given.number, one.given.x)
                                               : Json(kShown)},
                 {"expected", answerJson(one.kind, one.expected.choice, one.expected.number.value,
                                         one.expected.x.value)}};
    if (!one.expected.number.unit.empty()) step["unit"] = one.expected.number.unit;
    if (!one.expected.x.unit.empty()) step["x_unit"] = one.expected.x.unit;
    step["right"] = one.isRight;
    json["steps"].push_back(std::move(step));
  }
  return jsonFile(json);
}

LessonResults parseResults(std::string_view text, const std::string& file) {
  try {
    // Any other file is told apart before its members are read: a lesson is nested more deeply.
    const std::string schema = textMember(membersUpTo(text, "schema", kDeepestResults), "schema");
    if (!schema.starts_with(kAnyVersion)) throw InputError("", "", "has no results of a lesson");
    const Json json = parseJson(text, kDeepestResults, "results of a lesson are JSON in UTF-8");
    checkMembers(json, "",
                 {"schema", "lesson", "title", "sha256", "right", "shown", "steps", "date"});
    if (schema != kSchema) refuseMember("schema", message("is not {}", kSchema));
    LessonResults results{
        textMember(json, "lesson"), textMember(json, "title"), textMember(json, "sha256"), {}};
    results.date = textMember(json, "date", "");
    const auto steps = json.find("steps");
    if (steps == json.end() || !steps->is_array()) refuseMember("steps", "needs a list");
    for (std::size_t i = 0; i < steps->size(); ++i)
      results.set(readResult((*steps)[i], fmt::format("steps[{}]", i)));
    return results;
  } catch (const InputError& error) {
    throw error.in(file);
  }
}

bool isResultsFile(const std::filesystem::path& file) {
  return isFileOfSchema(file, kLargestResults, kAnyVersion);
}

LessonResults readResultsFile(const std::filesystem::path& file) {
  return parseResults(readRegularFile(file, kLargestResults), file.string());
}

LessonResults readResults(const std::filesystem::path& file, const Lesson& lesson) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return emptyResults(lesson);
  LessonResults results = readResultsFile(file);
  if (results.digest != lesson.digest)
    throw InputError(file.string(), "",
                     message("belongs to another lesson, or to another version of it ({}); its "
                             "answers stay as they are",
                             results.title));
  return results;
}

void writeResults(const std::filesystem::path& file, const LessonResults& results,
                  const Lesson& lesson) {
  readResults(file, lesson);
  writeFileAtomically(file, resultsJson(results));
}

namespace {

/// Returns the JSON files in a folder, by name.
std::vector<std::filesystem::path> jsonFilesIn(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  if (files.empty()) throw InputError(folder.string(), "", "has no results of a lesson");
  std::ranges::sort(files);
  return files;
}

/// Returns the steps that somebody answered, in their order.
std::set<int> answeredSteps(const std::vector<StudentResults>& students) {
  std::set<int> steps;
  for (const StudentResults& student : students)
    for (const LessonResult& one : student.results.results) steps.insert(one.step);
  return steps;
}

/// Returns the given answer as a cell of a table: the number of the choice from 1, or the number in
/// SI with all its digits, of a point with its place; empty where none was given.
std::string givenText(const LessonResult& result) {
  const GivenAnswer& given = result.given;
  if (!given.isGiven()) return {};
  if (result.kind == PredictionKind::Choice) return std::to_string(given.choice + 1);
  if (result.kind == PredictionKind::Number) return plainNumber(given.number);
  return plainNumber(given.number) + " at " + plainNumber(given.x);
}

std::string verdictWord(const LessonResult& result) {
  return !result.given.isGiven() ? "shown" : result.isRight ? "right" : "wrong";
}

}  // namespace

ClassResults readClasses(const std::vector<std::string>& filesAndFolders) {
  ClassResults found;
  std::vector<std::vector<StudentResults>>& classes = found.classes;
  const auto read = [&](const std::filesystem::path& file) {
    LessonResults results = readResultsFile(file);
    auto known = std::ranges::find_if(classes, [&](const std::vector<StudentResults>& one) {
      return one.front().results.digest == results.digest;
    });
    if (known == classes.end())
      known = classes.insert(classes.end(), std::vector<StudentResults>());
    known->push_back({file.filename().string(), std::move(results)});
  };
  const auto tryTo = [&](const auto& work) {
    try {
      work();
    } catch (const InputError& error) {
      found.refused.push_back(error);
    }
  };
  std::error_code ignored;
  for (const std::string& one : filesAndFolders)
    tryTo([&] {
      if (!std::filesystem::is_directory(one, ignored)) return read(one);
      for (const std::filesystem::path& file : jsonFilesIn(one)) tryTo([&] { read(file); });
    });
  if (classes.empty() && !found.refused.empty()) throw InputError(found.refused.front());
  return found;
}

const std::vector<StudentResults>& onlyClass(const ClassResults& results) {
  const auto& classes = results.classes;
  const StudentResults& first = classes.front().front();
  if (classes.size() == 1) return classes.front();
  const StudentResults& other = classes[1].front();
  throw InputError(
      other.file, "",
      other.results.title == first.results.title
          ? message("has results of another version of '{}' than {}; a table is of one version",
                    other.results.title, first.file)
          : message("has results of '{}', but {} has those of '{}'; a table is of one lesson",
                    other.results.title, first.file, first.results.title));
}

std::string classCsv(const std::vector<StudentResults>& students) {
  const std::set<int> steps = answeredSteps(students);
  DataTable table{{"file", "date", "right", "wrong", "shown"}, {}};
  for (const int step : steps) {
    table.columns.push_back(fmt::format("step_{}", step + 1));
    table.columns.push_back(fmt::format("step_{}_given", step + 1));
  }
  for (const StudentResults& student : students) {
    const LessonResults& results = student.results;
    std::vector<TableCell> row{student.file, results.date, std::int64_t{results.right()},
                               std::int64_t{results.wrong()}, std::int64_t{results.shown()}};
    for (const int step : steps) {
      const LessonResult* one = results.find(step);
      row.emplace_back(one ? verdictWord(*one) : std::string());
      row.emplace_back(one ? givenText(*one) : std::string());
    }
    table.rows.push_back(std::move(row));
  }
  return tableCsv(table);
}

}  // namespace asperity
