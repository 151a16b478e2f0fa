#include "ui/window/lesson/lesson_mistakes.h"

#include <algorithm>

#include "core/base/number_text.h"
#include "ui/panels/number_text.h"
#include "ui/window/lesson/lesson_editor.h"

namespace asperity {

namespace {

QString findRangeMistake(const std::vector<LessonChoice>& choices) {
  for (std::size_t i = 0; i < choices.size(); ++i) {
    const LessonChoice& choice = choices[i];
    if (!choice.isRange())
      return LessonEditor::tr("Choice %1: needs a number in From or To, as the others have")
          .arg(i + 1);
    if (!(choice.above < choice.below))
      return LessonEditor::tr("Choice %1: From has to be less than To").arg(i + 1);
    for (std::size_t j = 0; j < i; ++j)
      if (choice.above < choices[j].below && choices[j].above < choice.below)
        return LessonEditor::tr(
                   "Choice %1: its range overlaps that of choice %2, so that one answer would make "
                   "both right")
            .arg(i + 1)
            .arg(j + 1);
  }
  return {};
}

QString findMistake(const QString& field, double tolerance) {
  if (tolerance > 0 && tolerance <= kLargestTolerance) return {};
  return LessonEditor::tr("%1: %2 is not above 0 and up to %3")
      .arg(field, shownNumber(roundedToDigits(100 * tolerance, 12)),
           shownNumber(100 * kLargestTolerance));
}

QString findMistake(const LessonStep& step) {
  if (step.text.empty()) return LessonEditor::tr("the step needs a text");
  if (!step.prediction) return {};
  const LessonPrediction& prediction = *step.prediction;
  if (prediction.question.empty()) return LessonEditor::tr("the question needs a text");
  if (prediction.kind == PredictionKind::Point && step.show.tab != "curve")
    return LessonEditor::tr("a point needs the tab “Friction curve” in front, on which it lies");
  if (prediction.kind != PredictionKind::Choice) {
    if (const QString text = findMistake(LessonEditor::tr("Tolerance in %"), prediction.tolerance);
        !text.isEmpty())
      return text;
    return prediction.kind == PredictionKind::Point && !prediction.x
               ? findMistake(LessonEditor::tr("Tolerance of the place in %"), prediction.xTolerance)
               : QString();
  }
  if (prediction.choices.size() < 2) return LessonEditor::tr("Choices: write at least two");
  if (prediction.answer) return findRangeMistake(prediction.choices);
  if (std::ranges::count_if(prediction.choices, &LessonChoice::isRight) == 1) return {};
  return LessonEditor::tr(
      "Choices: tick the right one, or write into From and To for which computed answers each is "
      "right");
}

/// Returns whether a number can be read off the curve of the step's scene.
bool isOnCurve(const LessonValue& value, const LessonStep& step) {
  const auto isAxis = [&](std::string_view key) { return key == step.scene.sweep.key; };
  return value.column == step.show.quantity &&
         std::ranges::all_of(value.set, isAxis, assignmentKey) &&
         (value.kind != LessonValue::Kind::Exponent || isAxis(value.key)) &&
         std::ranges::all_of(value.over,
                             [&](const LessonValue& under) { return isOnCurve(under, step); });
}

}  // namespace

bool keepsPicture(const LessonStep& step) {
  return step.prediction && step.prediction->answer && !step.prediction->answer->set.empty() &&
         step.after.empty();
}

QStringList missingTexts(const Lesson& lesson, bool inGerman) {
  QStringList missing;
  bool hasAny = false;
  const auto look = [&](const LessonText& text, const QString& name) {
    hasAny = hasAny || !(inGerman ? text.german : text.english).empty();
    if (!text.empty() && (inGerman ? text.german : text.english).empty()) missing += name;
  };
  look(lesson.title, LessonEditor::tr("title"));
  look(lesson.goal, LessonEditor::tr("goal"));
  look(lesson.notes, LessonEditor::tr("notes for teachers"));
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    const LessonStep& step = lesson.steps[i];
    const auto lookInStep = [&](const LessonText& text, const QString& name) {
      look(text, LessonEditor::tr("step %1").arg(i + 1) + QStringLiteral(", ") + name);
    };
    lookInStep(step.title, LessonEditor::tr("title"));
    lookInStep(step.text, LessonEditor::tr("text"));
    if (!step.prediction) continue;
    const LessonPrediction& prediction = *step.prediction;
    lookInStep(prediction.question, LessonEditor::tr("question"));
    for (std::size_t j = 0; j < prediction.choices.size(); ++j)
      lookInStep(prediction.choices[j].text, LessonEditor::tr("choice %1").arg(j + 1));
    lookInStep(prediction.right, LessonEditor::tr("if right"));
    lookInStep(prediction.wrong, LessonEditor::tr("if wrong"));
    lookInStep(step.reveal, LessonEditor::tr("said with the answer"));
  }
  return hasAny ? missing : QStringList();
}

bool showsAnswer(const LessonStep& step) {
  return step.show.tab == "curve" && !step.show.hidesCurve && step.prediction &&
         step.prediction->answer && isOnCurve(*step.prediction->answer, step);
}

QString findMistake(const Lesson& lesson) {
  if (lesson.title.empty()) return LessonEditor::tr("The lesson needs a title");
  if (lesson.steps.empty()) return LessonEditor::tr("A lesson needs at least one step");
  for (std::size_t i = 0; i < lesson.steps.size(); ++i)
    if (const QString text = findMistake(lesson.steps[i]); !text.isEmpty())
      return LessonEditor::tr("Step %1: %2").arg(i + 1).arg(text);
  return {};
}

}  // namespace asperity
