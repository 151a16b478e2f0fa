// What a student answered in a lesson, as a file of the student's choice (JSON, "schema":
// "asperity-lesson-results/1"): for every prediction the answer, what was right, and whether it
// was. Written whole or not at all; a file that is something else, or belongs to another lesson, is
// never replaced. No dates and no names: the file is the student's own.
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

  /// Sets the result of its step.
  void set(const LessonResult& result);
  const LessonResult* of(int step) const;
  int right() const;
  /// Returns in how many steps the answer was shown without one of the student's.
  int shown() const;
};

/// Returns results of this lesson without any answer.
LessonResults emptyResults(const Lesson& lesson);

std::string resultsJson(const LessonResults& results);
LessonResults resultsFrom(std::string_view json, const std::string& file);

/// Returns the results in a file, where it exists, which must be of this lesson; else empty ones.
LessonResults readResults(const std::filesystem::path& file, const Lesson& lesson);

/// Writes the results. The file must be absent or hold results of the same lesson.
void writeResults(const std::filesystem::path& file, const LessonResults& results,
                  const Lesson& lesson);

}  // namespace asperity
