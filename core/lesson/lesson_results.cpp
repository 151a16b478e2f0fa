#include "core/lesson/lesson_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/atomic_file.h"
#include "core/base/input_error.h"
#include "core/base/json_text.h"
#include "core/base/regular_file.h"
#include "core/lesson/lesson_json.h"

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
  if (json.is_null()) return std::numeric_limits<double>::quiet_NaN();
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
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) return false;
  try {
    const Json beginning =
        membersUpTo(readRegularFile(file, kLargestResults), "schema", kDeepestResults);
    return textMember(beginning, "schema").starts_with(kAnyVersion);
  } catch (const InputError&) {
    return false;
  }
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

}  // namespace asperity
