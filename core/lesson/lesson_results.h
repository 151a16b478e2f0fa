// The answers of a student in a lesson, as a file of the student's choice (JSON, "schema":
// "asperity-lesson-results/1"): for every prediction the given answer, the expected one, and
// whether the given one was right. The file is written completely or not at all. A file with other
// content, or with results of another lesson, is never replaced. It contains the date of the last
// answer and no names: it belongs to the student.
// Failure: InputError with the file where it cannot be read or must not be replaced;
// std::runtime_error where it cannot be written.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

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

}  // namespace asperity
