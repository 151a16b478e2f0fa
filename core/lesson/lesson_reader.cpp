#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <set>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/text.h"
#include "core/chart/diagram.h"
#include "core/friction/curve_file.h"
#include "core/friction/curve_quantity.h"
#include "core/lesson/lesson_json.h"
#include "core/scene/parameters.h"
#include "core/scene/range.h"
#include "core/scene/scene_check.h"
#include "core/scene/scene_file.h"
#include "core/scene/sweep.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMaxChoices = 9, kMinChoices = 2, kMaxBeside = 6, kMaxValues = 30;

/// Runs `read`; an error about a key is reported with this path.
template <class Read>
auto at(const std::string& path, const Read& read) {
  try {
    return read();
  } catch (const InputError& error) {
    std::string where = path;
    if (!error.key().empty()) where += "." + error.key();
    throw InputError(
        "", where,
        error.file().empty() ? error.message() : message("{}: {}", error.file(), error.message()));
  }
}

/// Returns the paragraphs of a text, which is given as one text or as a list of paragraphs.
std::string joinParagraphs(const Json& json, const std::string& path) {
  if (json.is_string()) return json.get<std::string>();
  if (!json.is_array()) refuseMember(path, "needs a text, or a list of paragraphs");
  std::string text;
  for (const Json& paragraph : json) {
    if (!paragraph.is_string()) refuseMember(path, "needs a text, or a list of paragraphs");
    appendItem(text, paragraph.get<std::string>(), "\n\n");
  }
  return text;
}

LessonText readText(const Json& object, const char* member, const std::string& where,
                    bool isRequired = false) {
  const std::string path = where.empty() ? member : where + "." + member;
  const auto found = object.find(member);
  if (found == object.end()) {
    if (isRequired) refuseMember(path, "is missing; it needs a text");
    return {};
  }
  LessonText text;
  if (found->is_object()) {
    checkMembers(*found, path, {"en", "de"});
    for (const auto& [language, value] : found->items())
      (language == "de" ? text.german : text.english) =
          joinParagraphs(value, path + "." + language);
  } else {
    text.english = joinParagraphs(*found, path);
  }
  if (isRequired && text.empty()) refuseMember(path, "is empty");
  return text;
}

/// Reads an object of keys and values as assignments. Numbers in JSON are in SI units; texts may
/// have a unit.
std::vector<std::string> readAssignments(const Json& keys, const std::string& path) {
  if (!keys.is_object()) refuseMember(path, "needs an object of keys");
  std::vector<std::string> assignments;
  for (const auto& [key, value] : keys.items()) {
    at(path, [&] { knownParameter(key); });
    if (value.is_object() || value.is_null() || value.is_boolean())
      refuseMember(path + "." + key,
                   message("needs a value; allowed is {}", allowedText(knownParameter(key))));
    assignments.push_back(key + "=" + assignedText(value));
  }
  return assignments;
}

std::vector<std::string> readAssignments(const Json& object, const char* member,
                                         const std::string& where) {
  const auto found = object.find(member);
  return found == object.end() ? std::vector<std::string>()
                               : readAssignments(*found, where + "." + member);
}

Scene withKeysAt(const Scene& scene, const std::vector<std::string>& assignments,
                 const std::string& path) {
  return at(path, [&] { return withKeys(scene, assignments); });
}

std::string readColumn(const std::string& name, const std::string& path) {
  std::vector<std::string_view> known = curveColumns();
  std::erase_if(known, [](std::string_view column) {
    return column == "mu_low" || column == "mu_high" || column == "realizations";
  });
  if (std::ranges::find(known, name) != known.end()) return name;
  const std::string_view nearest = nearestWord(name, known);
  refuseMember(path, nearest.empty() ? message("'{}' is unknown; known are {}", shortened(name),
                                               namesWithCommas(known))
                                     : message("'{}' is unknown; the nearest known one is {}",
                                               shortened(name), nearest));
}

/// Checks what a lesson needs to be played, and a draft may lack.
template <class Check>
void require(LessonReading reading, const Check& check) {
  try {
    check();
  } catch (const InputError&) {
    if (reading == LessonReading::Complete) throw;
  }
}

LessonValue readValue(const Json& json, const std::string& path, const Scene& scene,
                      LessonReading reading, bool mayHaveOver = true) {
  checkMembers(json, path, {"quantity", "peak", "exponent", "key", "from", "to", "set", "over"});
  LessonValue value;
  int kinds = 0;
  for (const auto& [member, kind] : kLessonValueKinds) {
    const auto found = json.find(std::string(member));
    if (found == json.end()) continue;
    ++kinds;
    value.kind = kind;
    const std::string where = path + "." + std::string(member);
    if (!found->is_string()) refuseMember(where, "needs the name of a column");
    value.column = readColumn(found->get<std::string>(), where);
  }
  if (kinds != 1) refuseMember(path, "needs one of quantity, peak, exponent");
  value.set = readAssignments(json, "set", path);
  Scene changed = scene;
  require(reading, [&] {
    changed = withKeysAt(scene, value.set, path + ".set");
    at(path, [&] { checkEffects(changed); });
  });
  const bool isExponent = value.kind == LessonValue::Kind::Exponent;
  for (const char* member : {"key", "from", "to"})
    if (json.contains(member) != isExponent)
      refuseMember(path + "." + member, isExponent
                                            ? "is missing; an exponent needs key, from and to"
                                            : "has no meaning here; it belongs to an exponent");
  if (isExponent) {
    value.key = textMember(json, "key", "", path);
    value.from = numberMember(json, path, "from");
    value.to = numberMember(json, path, "to");
    at(path + ".key", [&] { numberRow(value.key); });
    require(reading, [&] {
      if (!(value.from > 0 && value.to > 0) || value.from == value.to)
        refuseMember(path, "needs two different values above 0 in from and to");
      for (const double end : {value.from, value.to})
        withKeysAt(changed, {value.key + "=" + plainNumber(end)}, path);
    });
  }
  if (const auto over = json.find("over"); over != json.end()) {
    if (!mayHaveOver) refuseMember(path + ".over", "stands only in the outer value");
    value.over.push_back(readValue(*over, path + ".over", scene, reading, false));
  }
  return value;
}

bool isPlaceName(std::string_view name) {
  return !name.empty() && std::ranges::all_of(name, [](unsigned char letter) {
    return std::islower(letter) || std::isdigit(letter) || letter == '_';
  });
}

/// Throws InputError where a text contains the name of a value that the step does not have.
void checkPlaceholders(const LessonText& text, const std::set<std::string>& known,
                       const std::string& path) {
  for (const std::string* one : {&text.english, &text.german})
    for (std::size_t open = one->find('{'); open != one->npos; open = one->find('{', open + 1)) {
      const std::size_t close = one->find('}', open);
      if (close == one->npos) return;
      std::string name = one->substr(open + 1, close - open - 1);
      if (name.ends_with('%')) name.pop_back();  // in per cent
      if (!isPlaceName(name) || known.contains(name)) continue;
      refuseMember(path, message("speaks of a value {} that the step does not have; known are {}",
                                 shortened(name), fmt::format("{}", fmt::join(known, ", "))));
    }
}

class StepReader {
 public:
  StepReader(const Json& json, std::string path, const Scene* before,
             const std::filesystem::path& folder, const SceneReader& readNamed,
             LessonReading reading)
      : json_(json),
        path_(std::move(path)),
        before_(before),
        folder_(folder),
        readNamed_(readNamed),
        reading_(reading) {}

  LessonStep read() {
    checkMembers(json_, path_,
                 {"title", "text", "scene", "set", "after", "show", "controls", "prediction",
                  "reveal", "values"});
    step_.title = readText(json_, "title", path_);
    step_.text = readText(json_, "text", path_, isComplete());
    step_.reveal = readText(json_, "reveal", path_);
    readScenes();
    readView();
    readControls();
    readValues();
    if (json_.contains("prediction")) readPrediction(json_["prediction"], path_ + ".prediction");
    if (!step_.prediction)
      for (const char* member : {"after", "reveal", "values"})
        if (json_.contains(member))
          refuseMember(path_ + "." + member, "has no meaning without a prediction");
    require(reading_, [&] { checkTexts(); });
    return std::move(step_);
  }

 private:
  bool isComplete() const { return reading_ == LessonReading::Complete; }

  void readScenes() {
    const auto scene = json_.find("scene");
    if (scene == json_.end()) {
      if (!before_) refuseMember(path_ + ".scene", "is missing; the first step needs a scene");
      step_.scene = *before_;
    } else if (scene->is_string()) {
      step_.sceneName = scene->get<std::string>();
      step_.scene = at(path_ + ".scene", [&] {
        return readNamed_ ? readNamed_(step_.sceneName, folder_, {})
                          : readSceneFile(folder_ / step_.sceneName);
      });
    } else if (scene->is_object()) {
      step_.scene = at(path_ + ".scene", [&] { return readScene(scene->dump(), "", folder_); });
      step_.sceneJson = scene->dump();
    } else {
      refuseMember(path_ + ".scene", "needs the name of a scene, or a scene");
    }
    step_.set = readAssignments(json_, "set", path_);
    require(reading_, [&] { step_.scene = withKeysAt(step_.scene, step_.set, path_ + ".set"); });
    step_.after = readAssignments(json_, "after", path_);
    step_.revealedScene = step_.scene;
    require(reading_, [&] {
      step_.revealedScene = withKeysAt(step_.scene, step_.after, path_ + ".after");
      for (const Scene* one : {&step_.scene, &step_.revealedScene})
        at(path_, [&] { checkEffects(*one); });
    });
  }

  void readView() {
    const auto show = json_.find("show");
    if (show == json_.end()) return;
    const std::string path = path_ + ".show";
    checkMembers(*show, path, {"tab", "quantity", "scale", "curve", "hidden_range", "beside"});
    LessonView& view = step_.show;
    view.tab = textMember(*show, "tab", view.tab, path);
    if (std::ranges::find(kLessonTabs, view.tab) == std::end(kLessonTabs))
      refuseMember(path + ".tab", notOneOf(view.tab, kLessonTabs));
    view.quantity = textMember(*show, "quantity", view.quantity, path);
    if (!findQuantity(view.quantity))
      refuseMember(path + ".quantity", notOneOf(view.quantity, quantityWords()));
    view.isLinearY = chosen(kAxisScales, textMember(*show, "scale", "log", path),
                            path + ".scale") == AxisScale::Linear;
    const CurveHiding hiding =
        chosen(kCurveStates, textMember(*show, "curve", "shown", path), path + ".curve");
    view.hidesCurve = hiding != CurveHiding::Never;
    view.hidesCurveAfter = hiding == CurveHiding::Throughout;
    if (const auto range = show->find("hidden_range"); range != show->end()) {
      const std::string where = path + ".hidden_range";
      checkMembers(*range, where, {"from", "to"});
      view.hiddenFrom = numberMember(*range, where, "from");
      view.hiddenTo = numberMember(*range, where, "to");
      const bool canBegin = view.hiddenFrom > 0 || (view.isLinearY && view.hiddenFrom == 0);
      if (!(canBegin && view.hiddenTo > view.hiddenFrom && std::isfinite(view.hiddenTo)))
        refuseMember(where,
                     view.isLinearY
                         ? message("needs two values from 0 on, of which to is the larger one")
                         : message("needs two values above 0, of which to is the larger one"));
    }
    if (const auto beside = show->find("beside"); beside != show->end()) {
      if (!beside->is_array() || beside->size() > kMaxBeside)
        refuseMember(path + ".beside",
                     message("needs a list of at most {} objects of keys", kMaxBeside));
      for (std::size_t i = 0; i < beside->size(); ++i) {
        const std::string where = fmt::format("{}.beside[{}]", path, i);
        view.beside.push_back(readAssignments((*beside)[i], where));
        require(reading_, [&] {
          const Scene other = withKeysAt(step_.scene, view.beside.back(), where);
          if (other.sweep.key != step_.scene.sweep.key)
            refuseMember(where, "has another axis than the curve beside which it stands");
        });
      }
    }
  }

  void readControls() {
    const auto controls = json_.find("controls");
    if (controls == json_.end()) return;
    const std::string path = path_ + ".controls";
    checkMembers(*controls, path, {"free", "locked", "hidden", "others"});
    LessonControls& read = step_.controls;
    std::set<std::string> named;
    const auto list = [&](const char* member, std::vector<std::string>& keys) {
      const auto found = controls->find(member);
      if (found == controls->end()) return;
      const std::string where = path + "." + member;
      if (!found->is_array()) refuseMember(where, "needs a list of keys");
      for (const Json& key : *found) {
        if (!key.is_string()) refuseMember(where, "needs a list of keys");
        keys.push_back(key.get<std::string>());
        at(where, [&] { knownParameter(keys.back()); });
        if (!named.insert(keys.back()).second)
          refuseMember(where, message("{} is named twice", keys.back()));
      }
    };
    list("free", read.free);
    list("locked", read.locked);
    list("hidden", read.hidden);
    require(reading_, [&] {
      for (const std::string& key : read.free)
        if (!isApplicable(*findParameter(key), step_.revealedScene))
          refuseMember(path + ".free", message("{} has no meaning in this scene", key));
    });
    read.others =
        chosen(kControlStates, textMember(*controls, "others", "hidden", path), path + ".others");
  }

  void readValues() {
    const auto values = json_.find("values");
    if (values == json_.end()) return;
    const std::string path = path_ + ".values";
    if (!values->is_object() || values->size() > kMaxValues)
      refuseMember(path, message("needs an object of at most {} values", kMaxValues));
    for (const auto& [name, value] : values->items()) {
      if (!isPlaceName(name) || name == "answer" || name == "given")
        refuseMember(path + "." + shortened(name),
                     "needs a name of small letters, digits and _, which is not answer or given");
      step_.values.push_back({name, readValue(value, path + "." + name, step_.scene, reading_)});
    }
  }

  void readPrediction(const Json& json, const std::string& path) {
    checkMembers(json, path,
                 {"kind", "question", "choices", "answer", "tolerance", "x", "place_tolerance",
                  "right", "wrong"});
    LessonPrediction& prediction = step_.prediction.emplace();
    prediction.kind = chosen(kPredictionKinds, textMember(json, "kind", "", path), path + ".kind");
    prediction.question = readText(json, "question", path, isComplete());
    prediction.right = readText(json, "right", path);
    prediction.wrong = readText(json, "wrong", path);
    const bool isChoice = prediction.kind == PredictionKind::Choice;
    const bool isNumber = prediction.kind == PredictionKind::Number;
    const bool isPoint = prediction.kind == PredictionKind::Point;
    const auto belongs = [&](const char* member, bool holds, const char* to) {
      if (json.contains(member) && !holds)
        refuseMember(path + "." + member,
                     message("has no meaning here; it belongs to {}", Message(to)));
    };
    belongs("choices", isChoice, "a choice");
    belongs("answer", !isPoint, "a number or a choice");
    belongs("tolerance", !isChoice, "a number or a point");
    belongs("x", isPoint, "a point");
    belongs("place_tolerance", isPoint && !json.contains("x"), "a point without x");
    if (json.contains("answer"))
      prediction.answer = readValue(json["answer"], path + ".answer", step_.scene, reading_);
    if (isNumber && !prediction.answer && isComplete())
      refuseMember(path + ".answer", "is missing; a number is computed");
    prediction.tolerance = tolerance(json, path, "tolerance", prediction.tolerance);
    prediction.xTolerance = tolerance(json, path, "place_tolerance", 1);
    if (isChoice) readChoices(json, path, prediction);
    if (isPoint) readPoint(json, path, prediction);
  }

  double tolerance(const Json& json, const std::string& path, const char* member,
                   double otherwise) const {
    if (!json.contains(member)) return otherwise;
    const double value = numberMember(json, path, member);
    if (!(value > 0 && value <= kLargestTolerance) && isComplete())
      refuseMember(path + "." + member,
                   message("{} is outside {}", plain(value),
                           message("above 0 to {}", plain(kLargestTolerance))));
    return value;
  }

  void readChoices(const Json& json, const std::string& path, LessonPrediction& prediction) {
    const auto choices = json.find("choices");
    const std::string all = path + ".choices";
    if (choices == json.end() && !isComplete()) return;
    const std::size_t fewest = isComplete() ? kMinChoices : 0;
    if (choices == json.end() || !choices->is_array() || choices->size() < fewest ||
        choices->size() > kMaxChoices)
      refuseMember(all, message("needs a list of {} to {} choices", kMinChoices, kMaxChoices));
    for (std::size_t i = 0; i < choices->size(); ++i) {
      const Json& one = (*choices)[i];
      const std::string where = fmt::format("{}[{}]", all, i);
      checkMembers(one, where, {"text", "right", "above", "below"});
      LessonChoice choice;
      choice.text = readText(one, "text", where, isComplete());
      if (one.contains("right")) {
        if (!one["right"].is_boolean()) refuseMember(where + ".right", "needs true or false");
        choice.isRight = one["right"].get<bool>();
      }
      choice.above = optionalNumberMember(one, where, "above").value_or(choice.above);
      choice.below = optionalNumberMember(one, where, "below").value_or(choice.below);
      require(reading_, [&] { checkChoice(one, choice, prediction, where); });
      prediction.choices.push_back(std::move(choice));
    }
    const auto right = std::ranges::count_if(prediction.choices, &LessonChoice::isRight);
    if (!prediction.answer && right != 1 && isComplete())
      refuseMember(all, message("has {} right choices; it needs one, or a computed answer", right));
  }

  /// Checks a choice together with those before it, which the prediction has.
  static void checkChoice(const Json& json, const LessonChoice& choice,
                          const LessonPrediction& prediction, const std::string& where) {
    if (choice.isRange() && !prediction.answer)
      refuseMember(where, "has above or below, which need a computed answer");
    if (json.contains("right") && prediction.answer)
      refuseMember(where + ".right", "follows from the computed answer; give above or below");
    if (!choice.isRange() && prediction.answer)
      refuseMember(where, "needs above or below, where the answer is computed");
    if (!(choice.above < choice.below)) refuseMember(where, "needs above to be less than below");
    for (std::size_t j = 0; j < prediction.choices.size() && prediction.answer; ++j)
      if (choice.above < prediction.choices[j].below && prediction.choices[j].above < choice.below)
        refuseMember(where, message("overlaps choices[{}]; one answer would make both right", j));
  }

  void readPoint(const Json& json, const std::string& path, LessonPrediction& prediction) {
    if (step_.show.tab != "curve" && isComplete())
      refuseMember(path, "needs show.tab curve, on which the point stands");
    step_.show.hidesCurve = true;
    prediction.x = optionalNumberMember(json, path, "x");
    require(reading_, [&] {
      const ParameterRange axis = at(path, [&] { return sweepRange(step_.scene); });
      const auto [low, high] = std::minmax(axis.from, axis.to);
      if (prediction.x && !(*prediction.x >= low && *prediction.x <= high))
        refuseMember(path + ".x", message("{} is outside {}, the axis of the curve",
                                          plain(*prediction.x), rangeText(low, high)));
    });
  }

  void checkTexts() const {
    std::set<std::string> known;
    if (step_.prediction) known = {"answer", "given"};
    for (const NamedLessonValue& value : step_.values) known.insert(value.name);
    checkPlaceholders(step_.reveal, known, path_ + ".reveal");
    if (!step_.prediction) return;
    checkPlaceholders(step_.prediction->right, known, path_ + ".prediction.right");
    checkPlaceholders(step_.prediction->wrong, known, path_ + ".prediction.wrong");
  }

  const Json& json_;
  std::string path_;
  const Scene* before_;
  const std::filesystem::path& folder_;
  const SceneReader& readNamed_;
  const LessonReading reading_;
  LessonStep step_;
};

}  // namespace

Lesson parseLesson(const Json& root, const std::filesystem::path& folder,
                   const SceneReader& readNamed, LessonReading reading) {
  const bool isComplete = reading == LessonReading::Complete;
  if (!root.is_object()) refuseMember("", "a lesson is one JSON object");
  const std::string schema = textMember(root, "schema");
  if (schema.starts_with("asperity-lesson-results/"))
    refuseMember("", "holds the results of a student, not a lesson");
  if (schema != kLessonSchema) refuseMember("schema", message("is not {}", kLessonSchema));
  checkMembers(root, "", {"schema", "title", "goal", "minutes", "notes", "steps"});
  Lesson lesson;
  lesson.title = readText(root, "title", "", isComplete);
  lesson.goal = readText(root, "goal", "");
  lesson.notes = readText(root, "notes", "");
  if (root.contains("minutes"))
    lesson.minutes = static_cast<int>(integerMember(root, "minutes", 1, 600));
  const auto steps = root.find("steps");
  if (steps == root.end() || !steps->is_array() || (steps->empty() && isComplete) ||
      steps->size() > kMaxLessonSteps)
    refuseMember("steps", message("needs a list of 1 to {} steps", kMaxLessonSteps));
  for (std::size_t i = 0; i < steps->size(); ++i) {
    const Scene* before = lesson.steps.empty() ? nullptr : &lesson.steps.back().revealedScene;
    lesson.steps.push_back(
        StepReader((*steps)[i], fmt::format("steps[{}]", i), before, folder, readNamed, reading)
            .read());
  }
  return lesson;
}

}  // namespace asperity
