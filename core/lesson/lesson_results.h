// The answers of a student in a lesson, as a file of the student's choice (JSON, "schema":
// "asperity-lesson-results/1"): for every prediction the given answer, the expected one, and
// whether the given one was right. The file is written completely or not at all. A file with other
// content, or with results of another lesson, is never replaced. It contains the date of the last
// answer and no names: it belongs to the student. Also the results of a class: the files of several
// students in one lesson, side by side.
// Failure: InputError with the file where it cannot be read, must not be replaced, or is of another
// lesson where one lesson is asked for; std::runtime_error where it cannot be written.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/input_error.h"
#include "core/lesson/lesson.h"
#include "core/lesson/lesson_answers.h"

namespace asperity {

struct LessonResult {
  int step = 0;  // from 0
  PredictionKind kind = PredictionKind::Choice;
  GivenAnswer given{};
  LessonAnswer expected{};
  bool isRight = false;
};

struct LessonResults {
  std::string lesson, title, digest;
  std::vector<LessonResult> results;  // in the order of the steps, at most one each
  std::string date{};                 // of the last answer, ISO 8601; empty in older files

  /// Sets the result of its step.
  void set(const LessonResult& result);
  const LessonResult* find(int step) const;
  int right() const;
  int wrong() const;
  /// Returns in how many steps the answer was shown without one of the student's.
  int shown() const;
};

/// Returns results of this lesson without any answer.
LessonResults emptyResults(const Lesson& lesson);

std::string resultsJson(const LessonResults& results);
LessonResults parseResults(std::string_view json, const std::string& file);

/// Returns whether a regular file is meant to hold results, of any version; false where it cannot
/// be read.
bool isResultsFile(const std::filesystem::path& file);
/// Returns the results in a file, of any lesson.
LessonResults readResultsFile(const std::filesystem::path& file);

/// Returns the results in a file if it exists, which must be of this lesson; else empty ones.
LessonResults readResults(const std::filesystem::path& file, const Lesson& lesson);

/// Writes the results. The file must be absent or hold results of the same lesson.
void writeResults(const std::filesystem::path& file, const LessonResults& results,
                  const Lesson& lesson);

// ---- The results of a class

struct StudentResults {
  std::string file;  // without its folder
  LessonResults results;
};

/// The files of a class that could be read, and the errors of the others.
struct ClassResults {
  std::vector<std::vector<StudentResults>> classes;  // of each version of each lesson
  std::vector<InputError> refused;
};

/// Reads files of results, and all JSON files in folders, of any lessons. There is at least one
/// class; students and errors are in the order of the files. Throws the first error where no file
/// has results.
ClassResults readClasses(const std::vector<std::string>& filesAndFolders);

/// Returns the students of the class where there is one. Throws InputError with a file that is of
/// another lesson, or of another version of it.
const std::vector<StudentResults>& onlyClass(const ClassResults& results);

/// Returns the table as CSV: a row for each student with file, date, the numbers of right, wrong
/// and shown answers, and for each step that somebody answered `step_N` ("right", "wrong" or
/// "shown") and `step_N_given`; both are empty where this student has not come so far.
std::string classCsv(const std::vector<StudentResults>& students);

}  // namespace asperity
