#include "core/lesson/lesson.h"

#include <algorithm>

#include "core/base/input_error.h"
#include "core/scene/parameters.h"
#include "core/scene/scene_file.h"

namespace asperity {

ControlState LessonControls::state(std::string_view key) const {
  if (std::ranges::find(free, key) != free.end()) return ControlState::Free;
  if (std::ranges::find(locked, key) != locked.end()) return ControlState::Locked;
  if (std::ranges::find(hidden, key) != hidden.end()) return ControlState::Hidden;
  return others;
}

Lesson withWholeQuestions(Lesson lesson) {
  for (LessonStep& step : lesson.steps) {
    if (!step.prediction) continue;
    std::vector<LessonText*> texts = {&step.prediction->question, &step.prediction->right,
                                      &step.prediction->wrong, &step.reveal};
    for (LessonChoice& choice : step.prediction->choices) texts.push_back(&choice.text);
    const auto lacks = [&](std::string LessonText::*language) {
      return std::ranges::any_of(texts, [&](const LessonText* text) {
        return !text->empty() && (text->*language).empty();
      });
    };
    const bool lacksEnglish = lacks(&LessonText::english), lacksGerman = lacks(&LessonText::german);
    if (lacksEnglish == lacksGerman) continue;  // whole, or in no language
    for (LessonText* text : texts) (lacksEnglish ? text->english : text->german).clear();
  }
  return lesson;
}

const LessonStep* askingStep(const Lesson& lesson, int step) {
  const auto place = static_cast<std::size_t>(step);
  return place < lesson.steps.size() && lesson.steps[place].prediction ? &lesson.steps[place]
                                                                       : nullptr;
}

int predictionCount(const Lesson& lesson) {
  return static_cast<int>(std::ranges::count_if(
      lesson.steps, [](const LessonStep& step) { return step.prediction.has_value(); }));
}

std::string_view assignmentKey(std::string_view assignment) {
  return assignment.substr(0, assignment.find('='));
}

Scene withKeys(const Scene& scene, const std::vector<std::string>& assignments) {
  if (assignments.empty()) return scene;
  return changedScene(scene, assignments, "");
}

std::vector<std::string_view> lockedChanges(const LessonControls& controls, const Scene& step,
                                            const Scene& given) {
  std::vector<std::string_view> keys;
  for (const Parameter& row : parameters())
    if (controls.state(row.key) != ControlState::Free &&
        parameterValue(row, step) != parameterValue(row, given))
      keys.push_back(row.key);
  return keys;
}

Scene withinControls(const LessonControls& controls, const Scene& step, const Scene& given) {
  Scene scene = step;
  for (const Parameter& row : parameters()) {
    if (controls.state(row.key) != ControlState::Free) continue;
    const ParameterValue value = parameterValue(row, given);
    if (value == parameterValue(row, step)) continue;
    try {
      setValue(row, scene, value);
    } catch (const InputError&) {
      // Where the kind is locked, a value that belongs to another kind stays as in the step.
    }
  }
  return scene;
}

}  // namespace asperity
