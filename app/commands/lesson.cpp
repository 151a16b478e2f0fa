// asperity lesson: lists the lessons, prints the questions and answers of one, and writes its
// handout; prints the results of a class.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "app/command_line.h"
#include "app/output.h"
#include "app/pictures/headless_pictures.h"
#include "core/base/input_error.h"
#include "core/base/json_text.h"
#include "core/base/text.h"
#include "core/lesson/lesson_answers.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/lesson_results.h"
#include "ui/language/language.h"
#include "ui/window/lesson/handout.h"
#include "ui/window/lesson/lesson_results_page.h"
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
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    const LessonStep& step = lesson.steps[i];
    Json one = {{"step", i + 1}, {"title", shown(step.title)}};
    if (step.prediction) {
      const LessonAnswer answer = lessonAnswer(step, {.threads = threads});
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
  for (const ShippedFile& shipped : shippedLessons()) {
    const Lesson lesson = readNamedLesson(std::string(shipped.name), readNamedScene);
    all.push_back(summaryJson(lesson));
    text += std::string(shipped.name) + ": " + summaryText(lesson);
  }
  printSummary(command.common, text);
  if (command.common.json) printJson(all);
  return kDone;
}

/// Returns whether the results of students are given, not a lesson. A folder may have the name of a
/// shipped lesson, which then is meant.
bool areResults(const std::vector<std::string>& given) {
  std::error_code ignored;
  return given.size() > 1 || given.front().ends_with('/') || isResultsFile(given.front()) ||
         (std::filesystem::is_directory(given.front(), ignored) &&
          !findShipped(shippedLessons(), given.front()));
}

/// Throws InputError where one of several words is no file and no folder, such as the name of a
/// lesson.
void checkResultsExist(const std::vector<std::string>& given) {
  if (given.size() < 2) return;
  for (const std::string& one : given) {
    std::error_code error;
    if (!std::filesystem::exists(one, error) && !error)
      throw InputError(one, "",
                       "there is no such file or folder of results; one lesson at a time is shown");
  }
}

/// Returns the table of a class in columns.
std::string classText(const std::vector<StudentResults>& students) {
  const ClassRows table = LessonResultsPage::classRows(students);
  std::vector<QStringList> rows = {table.heading, table.answers};
  rows.insert(rows.end(), table.students.begin(), table.students.end());
  std::vector<qsizetype> widths(static_cast<std::size_t>(table.heading.size()));
  const auto forEachCell = [&](QStringList& row, const auto& act) {
    for (std::size_t i = 0; i < widths.size(); ++i) act(row[static_cast<qsizetype>(i)], widths[i]);
  };
  for (QStringList& row : rows)
    forEachCell(row, [](QString& cell, qsizetype& width) {
      cell = fromUtf8(printable(cell.toStdString()));
      width = std::max(width, cell.size());
    });
  QString text;
  for (QStringList& row : rows) {
    forEachCell(row, [](QString& cell, qsizetype width) { cell = cell.leftJustified(width); });
    QString line = row.join(QStringLiteral("  "));
    while (line.endsWith(' ')) line.chop(1);
    text += line + '\n';
  }
  return text.toStdString();
}

/// Returns a table of each class below the title of its lesson.
std::string classesText(const ClassResults& results) {
  std::string text;
  std::set<std::string> titles;
  for (const std::vector<StudentResults>& students : results.classes) {
    const std::string title =
        printable(LessonResultsPage::lessonTitle(students.front().results).toStdString());
    const bool isKnown = !titles.insert(title).second;
    text += (text.empty() ? "" : "\n") +
            (isKnown ? filled(Words::tr("%1, another version"), {title}) : title) + "\n" +
            classText(students);
  }
  return text;
}

/// Prints the table of the files that can be read, and the reasons of the others to stderr.
int showClass(const LessonCommand& command) {
  const CommonOptions& common = command.common;
  checkResultsExist(command.lessons);
  checkOutputs(command.outputs, {".csv"});
  if (command.forTeacher)
    throw InputError("", "--teacher", "applies only to handouts, not to results");
  for (const std::string& output : command.outputs)
    checkNoInput(output, {command.lessons.begin(), command.lessons.end()});
  const ClassResults results = readClasses(command.lessons);
  if (!command.outputs.empty() || common.json) onlyClass(results);
  for (const InputError& error : results.refused) printError(error.what());
  const std::vector<StudentResults>& students = results.classes.front();
  const LessonResults& first = students.front().results;
  std::string summary = classesText(results);
  for (const std::string& output : command.outputs) {
    writeTable(output, classCsv(students));
    summary += wroteLine(output);
  }
  printSummary(common, summary);
  if (common.json) {
    Json answer = {{"schema", "asperity-lesson-class/1"},
                   {"version", ASPERITY_VERSION},
                   {"lesson", first.lesson},
                   {"title", first.title},
                   {"sha256", first.digest},
                   {"students", Json::array()}};
    for (const StudentResults& student : students) {
      Json one = {{"file", student.file}};
      const Json answers = jsonValue(resultsJson(student.results));
      for (const char* member : {"date", "right", "shown", "steps"})
        if (answers.contains(member)) one[member] = answers[member];
      one["wrong"] = student.results.wrong();
      answer["students"].push_back(std::move(one));
    }
    printJson(answer);
  }
  return results.refused.empty() ? kDone : kRunFailed;
}

}  // namespace

int runLesson(const LessonCommand& command) {
  const CommonOptions& common = command.common;
  if (command.lessons.empty()) {
    if (!command.outputs.empty() || command.forTeacher)
      throw InputError("", command.forTeacher ? "--teacher" : "-o",
                       "needs a lesson; without one the shipped lessons are listed");
    return listAll(command);
  }
  if (areResults(command.lessons)) return showClass(command);
  const std::string& name = command.lessons.front();
  checkOutputs(command.outputs, {".html", ".pdf"});
  if (command.forTeacher && command.outputs.empty())
    throw InputError("", "--teacher", "applies only to handouts; give -o as well");
  for (const std::string& output : command.outputs) checkNoInput(output, {name});
  const Lesson lesson = readNamedLesson(name, readNamedScene);
  checkChoices(lesson, name, {.threads = common.threads});
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
  printSummary(common, summary);
  if (common.json) {
    Json answer = {{"schema", "asperity-lesson-summary/1"}, {"version", ASPERITY_VERSION}};
    answer.update(summaryJson(lesson));
    answer["steps"] = answersJson(lesson, common.threads);
    printJson(answer);
  }
  return kDone;
}

}  // namespace asperity
