#include <cmath>

#include "core/chart/diagram.h"
#include "core/lesson/lesson_json.h"
#include "core/scene/parameters.h"
#include "core/scene/range.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

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
    const Json parsed = Json::parse(text, nullptr, false);
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
  if (!step.sceneJson.empty()) json["scene"] = Json::parse(step.sceneJson);
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

}  // namespace

Json lessonJson(const Lesson& lesson) {
  Json json = {{"schema", kLessonSchema}};
  addText(json, "title", lesson.title);
  addText(json, "goal", lesson.goal);
  json["minutes"] = lesson.minutes;
  addText(json, "notes", lesson.notes);
  json["steps"] = Json::array();
  for (const LessonStep& step : lesson.steps) json["steps"].push_back(toJson(step));
  return json;
}

}  // namespace asperity
