// The results of a class: the files of several students in one lesson, side by side.
// Pure except for reading the files. Failure: InputError with the file that cannot be read where
// none can, or with one of another lesson where one lesson is asked for.
#pragma once

#include <string>
#include <vector>

#include "core/base/input_error.h"
#include "core/lesson/lesson_results.h"

namespace asperity {

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

/// Returns the given answer as a cell of a table: the number of the choice from 1, or the number in
/// SI with all its digits, of a point with its place; empty where none was given.
std::string givenText(const LessonResult& result);

/// Returns "right", "wrong" or "shown".
std::string verdictWord(const LessonResult& result);

/// Returns the table as CSV: a row for each student with file, date, the numbers of right, wrong
/// and shown answers, and for each step that somebody answered `step_N` (verdictWord) and
/// `step_N_given`; both are empty where this student has not come so far.
std::string classCsv(const std::vector<StudentResults>& students);

}  // namespace asperity
