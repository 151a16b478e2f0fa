#include "core/lesson/lesson_file.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/file_digest.h"
#include "core/base/input_error.h"
#include "core/base/json_text.h"
#include "core/base/regular_file.h"
#include "core/chart/diagram.h"
#include "core/lesson/lesson_json.h"
#include "core/scene/parameters.h"
#include "core/scene/range.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kDeepestLesson = 16;

// ---- Writing

Json toJson(const std::string& text) {
  Json list = Json::array();
  for (std::size_t begin = 0;;) {
    const std::size_t end = text.find("\n\n", begin);
    list.push_back(text.substr(begin, end == text.npos ? end : end - begin));
    if (end == text.npos) break;
    begin = end + 2;
  }
  return list.size() == 1 ? list.front() : list;
}

void addText(Json& object, const char* member, const LessonText& text) {
  if (text.empty()) return;
  if (!text.english.empty()) object[member]["en"] = toJson(text.english);
  if (!text.german.empty()) object[member]["de"] = toJson(text.german);
}

/// Returns a value of an assignment as JSON: a number or a list where it reads as one, else a text.
Json jsonOfValue(const std::string& key, const std::string& text) {
  const Parameter* row = findParameter(key);
  if (row && (allowedRange(*row) || isList(*row))) {
    const Json parsed = jsonOrDiscarded(text);
    if (parsed.is_number() || parsed.is_array()) return parsed;
  }
  return text;
}

Json toJson(const std::vector<std::string>& assignments) {
  Json object = Json::object();
  for (const std::string& assignment : assignments) {
    const std::string key(assignmentKey(assignment));
    // An assignment that is still being edited may have no value yet.
    const bool hasValue = assignment.size() > key.size();
    object[key] = jsonOfValue(key, hasValue ? assignment.substr(key.size() + 1) : std::string());
  }
  return object;
}

Json toJson(const LessonValue& value) {
  Json json = {{std::string(choiceWord(kLessonValueKinds, value.kind)), value.column}};
  if (value.kind == LessonValue::Kind::Exponent) {
    json["key"] = value.key;
    json["from"] = value.from;
    json["to"] = value.to;
  }
  if (!value.set.empty()) json["set"] = toJson(value.set);
  if (!value.over.empty()) json["over"] = toJson(value.over.front());
  return json;
}

Json toJson(const LessonView& view) {
  const LessonView usual;
  Json json = Json::object();
  if (view.tab != usual.tab) json["tab"] = view.tab;
  if (view.quantity != usual.quantity) json["quantity"] = view.quantity;
  if (view.isLinearY) json["scale"] = choiceWord(kAxisScales, AxisScale::Linear);
  if (view.hidesCurve)
    json["curve"] = choiceWord(
        kCurveStates, view.hidesCurveAfter ? CurveHiding::Throughout : CurveHiding::UntilAnswered);
  if (view.hiddenFrom != usual.hiddenFrom || view.hiddenTo != usual.hiddenTo)
    json["hidden_range"] = {{"from", view.hiddenFrom}, {"to", view.hiddenTo}};
  for (const std::vector<std::string>& keys : view.beside) json["beside"].push_back(toJson(keys));
  return json;
}

Json toJson(const LessonControls& controls) {
  Json json = Json::object();
  if (!controls.free.empty()) json["free"] = controls.free;
  if (!controls.locked.empty()) json["locked"] = controls.locked;
  if (!controls.hidden.empty()) json["hidden"] = controls.hidden;
  if (controls.others != ControlState::Hidden)
    json["others"] = choiceWord(kControlStates, controls.others);
  return json;
}

Json toJson(const LessonPrediction& prediction) {
  Json json = {{"kind", choiceWord(kPredictionKinds, prediction.kind)}};
  addText(json, "question", prediction.question);
  for (const LessonChoice& choice : prediction.choices) {
    Json one = Json::object();
    addText(one, "text", choice.text);
    if (choice.isRight) one["right"] = true;
    if (std::isfinite(choice.above)) one["above"] = choice.above;
    if (std::isfinite(choice.below)) one["below"] = choice.below;
    json["choices"].push_back(one);
  }
  if (prediction.x) json["x"] = *prediction.x;
  if (prediction.answer) json["answer"] = toJson(*prediction.answer);
  if (prediction.kind != PredictionKind::Choice) json["tolerance"] = prediction.tolerance;
  if (prediction.kind == PredictionKind::Point && !prediction.x)
    json["place_tolerance"] = prediction.xTolerance;
  addText(json, "right", prediction.right);
  addText(json, "wrong", prediction.wrong);
  return json;
}

Json toJson(const LessonStep& step) {
  Json json = Json::object();
  addText(json, "title", step.title);
  addText(json, "text", step.text);
  if (!step.sceneName.empty()) json["scene"] = step.sceneName;
  if (!step.sceneJson.empty()) json["scene"] = jsonValue(step.sceneJson);
  if (!step.set.empty()) json["set"] = toJson(step.set);
  if (Json show = toJson(step.show); !show.empty()) json["show"] = std::move(show);
  if (Json controls = toJson(step.controls); !controls.empty())
    json["controls"] = std::move(controls);
  if (!step.prediction) return json;
  json["prediction"] = toJson(*step.prediction);
  if (!step.after.empty()) json["after"] = toJson(step.after);
  addText(json, "reveal", step.reveal);
  for (const NamedLessonValue& value : step.values)
    json["values"][value.name] = toJson(value.value);
  return json;
}

Json toJson(const Lesson& lesson) {
  Json json = {{"schema", kLessonSchema}};
  addText(json, "title", lesson.title);
  addText(json, "goal", lesson.goal);
  json["minutes"] = lesson.minutes;
  addText(json, "notes", lesson.notes);
  json["steps"] = Json::array();
  for (const LessonStep& step : lesson.steps) json["steps"].push_back(toJson(step));
  return json;
}

}  // namespace

const char* const kLessonFormat =
    R"(LESSON.json:
  {"schema": "asperity-lesson/1", "title": {"en": "...", "de": "..."}, "goal": ..., "notes": ...,
   "minutes": 15, "steps": [
     {"text": {"en": ["A paragraph.", "Another one."]}, "scene": "region_1.json",
      "set": {"load.normal_force": 0.01},
      "show": {"tab": "curve", "scale": "log", "curve": "hidden"},
      "controls": {"free": ["sliding.velocity"]},
      "prediction": {"kind": "number", "question": "...", "tolerance": 0.2,
        "answer": {"quantity": "mu", "set": {"sliding.velocity": 0.1}, "over": {"quantity": "mu"}}},
      "after": {"sliding.velocity": 0.1}, "reveal": "It is {answer} times as large."}]}
A prediction is a choice, a number or a point on the chart. What is right is computed.

RESULTS.json is the file in which a student saved the answers. The table of a class (-o FILE.csv)
has a row for each file, and for each step N the columns step_N (right, wrong or shown) and
step_N_given (the number of a choice, or a number in SI).
)";

// ---- Reading

namespace {

Lesson readAs(LessonReading reading, std::string_view text, const std::string& file,
              const std::filesystem::path& folder, const SceneReader& readNamed) {
  try {
    if (text.size() > kLargestLesson)
      refuseMember(
          "", message("is larger than {} bytes, the most that a lesson may have", kLargestLesson));
    const Json root = parseJson(text, kDeepestLesson, "a lesson is JSON in UTF-8");
    Lesson lesson = parseLesson(root, folder, readNamed, reading);
    lesson.name = std::filesystem::path(file).stem().string();
    lesson.digest = sha256(writeLesson(lesson));
    return lesson;
  } catch (const InputError& error) {
    throw error.withFile(file);
  }
}

}  // namespace

Lesson readLesson(std::string_view text, const std::string& file,
                  const std::filesystem::path& folder, const SceneReader& readNamed) {
  return readAs(LessonReading::Complete, text, file, folder, readNamed);
}

Lesson readDraft(std::string_view text, const std::string& file,
                 const std::filesystem::path& folder, const SceneReader& readNamed) {
  return readAs(LessonReading::Draft, text, file, folder, readNamed);
}

Lesson readDraftFile(const std::filesystem::path& file, const SceneReader& readNamed) {
  return readDraft(readRegularFile(file, kLargestLesson), file.string(), file.parent_path(),
                   readNamed);
}

Lesson readLessonFile(const std::filesystem::path& file, const SceneReader& readNamed) {
  return readLesson(readRegularFile(file, kLargestLesson), file.string(), file.parent_path(),
                    readNamed);
}

std::string writeLesson(const Lesson& lesson) {
  return jsonFile(toJson(lesson));
}

bool isLessonFile(const std::filesystem::path& file) {
  return isFileOfSchema(file, kLargestLesson, "asperity-lesson/");
}

Lesson readNamedLesson(const std::string& name, const SceneReader& readNamed) {
  std::error_code ignored;
  // A folder may have the same name as a shipped lesson.
  if (std::filesystem::exists(name, ignored) && !std::filesystem::is_directory(name, ignored))
    return readLessonFile(name, readNamed);
  constexpr std::string_view kExtension = ".json";
  std::string_view bare = name;
  if (bare.ends_with(kExtension)) bare.remove_suffix(kExtension.size());
  if (const ShippedFile* lesson = findShipped(shippedLessons(), bare))
    return readLesson(lesson->json, std::string(bare) + ".json", kShippedFolder, readNamed);
  throw InputError(name, "",
                   message("is neither a file nor a shipped lesson; those are {}",
                           namesWithCommas(namesOf(shippedLessons()))));
}

}  // namespace asperity
