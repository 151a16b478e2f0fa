// asperity lesson: lists the lessons, prints the questions and answers of one, and writes its
// handout.
#include <fmt/format.h>

#include <cmath>

#include "app/command_line.h"
#include "app/output.h"
#include "app/pictures/headless_pictures.h"
#include "core/base/input_error.h"
#include "core/base/json_text.h"
#include "core/base/text.h"
#include "core/lesson/lesson_answers.h"
#include "core/lesson/lesson_file.h"
#include "ui/language/language.h"
#include "ui/window/lesson/handout.h"
#include "ui/window/lesson/lesson_text.h"
#include "ui/window/main/scene_library.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

std::string summaryText(const Lesson& lesson) {
  return printable(shown(lesson.title)) + "\n  " +
         filled(Words::tr("%1 minutes, %2 steps, %3 predictions"),
                {std::to_string(lesson.minutes), std::to_string(lesson.steps.size()),
                 std::to_string(predictionCount(lesson))}) +
         "\n  " + printable(shown(lesson.goal)) + "\n";
}

Json numberJson(const LessonNumber& number) {
  Json json = {{"value", numberOrNull(number.value)}};
  if (!number.unit.empty()) json["unit"] = number.unit;
  return json;
}

/// Returns the right answer of each step, as computed now.
Json answersJson(const Lesson& lesson, int threads) {
  Json steps = Json::array();
  CurveOptions options;
  options.threads = threads;
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    const LessonStep& step = lesson.steps[i];
    Json one = {{"step", i + 1}, {"title", shown(step.title)}};
    if (step.prediction) {
      const LessonAnswer answer = lessonAnswer(step, options);
      one["question"] = shown(step.prediction->question);
      if (answer.choice >= 0) {
        one["answer"] = {
            {"choice", answer.choice + 1},
            {"text",
             shown(step.prediction->choices[static_cast<std::size_t>(answer.choice)].text)}};
        if (step.prediction->answer) one["answer"]["computed"] = numberJson(answer.number);
      } else {
        one["answer"] = numberJson(answer.number);
        if (std::isfinite(answer.x.value)) one["answer"]["at"] = numberJson(answer.x);
      }
    }
    steps.push_back(std::move(one));
  }
  return steps;
}

Json summaryJson(const Lesson& lesson) {
  return {{"name", lesson.name},       {"title", shown(lesson.title)}, {"goal", shown(lesson.goal)},
          {"minutes", lesson.minutes}, {"steps", lesson.steps.size()}, {"sha256", lesson.digest}};
}

int listAll(const LessonCommand& command) {
  Json all = Json::array();
  std::string text;
  for (const ShippedLesson& shipped : shippedLessons()) {
    const Lesson lesson = readNamedLesson(std::string(shipped.name), readNamedScene);
    all.push_back(summaryJson(lesson));
    text += std::string(shipped.name) + ": " + summaryText(lesson);
  }
  printSummary(command.common.json, command.common.quiet, text);
  if (command.common.json) fmt::print("{}\n", all.dump(2));
  return kDone;
}

}  // namespace

int runLesson(const LessonCommand& command) {
  const CommonOptions& common = command.common;
  if (common.scene.empty()) {
    if (!command.outputs.empty() || command.forTeacher)
      throw InputError("", command.forTeacher ? "--teacher" : "-o",
                       "needs a lesson; without one the shipped lessons are listed");
    return listAll(command);
  }
  checkOutputs(command.outputs, {".html", ".pdf"});
  if (command.forTeacher && command.outputs.empty())
    throw InputError("", "--teacher", "is of a handout; give -o as well");
  for (const std::string& output : command.outputs) checkNoInput(output, {common.scene});
  const Lesson lesson = readNamedLesson(common.scene, readNamedScene);
  CurveOptions computing;
  computing.threads = common.threads;
  checkChoices(lesson, common.scene, computing);
  std::string summary = summaryText(lesson);
  if (!command.outputs.empty()) {
    HeadlessPictures pictures;
    HandoutOptions options;
    options.forTeacher = command.forTeacher;
    options.threads = common.threads;
    for (const std::string& output : command.outputs) {
      writeHandout(output, lesson, options);
      summary += wroteLine(output);
    }
  }
  printSummary(common.json, common.quiet, summary);
  if (common.json) {
    Json answer = {{"schema", "asperity-lesson-summary/1"}, {"version", ASPERITY_VERSION}};
    answer.update(summaryJson(lesson));
    answer["steps"] = answersJson(lesson, common.threads);
    fmt::print("{}\n", answer.dump(2));
  }
  return kDone;
}

}  // namespace asperity
