// The results of a class: the files of several students in one lesson, side by side.
// Pure except for reading the files. Failure: InputError with the file that cannot be read, or that
// is of another lesson where one is asked for.
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

/// Reads files of results, and those in folders, where other files are left out. All are of one
/// version of one lesson.
std::vector<StudentResults> readClass(const std::vector<std::string>& filesAndFolders);

/// Reads the same files, of any lessons. Returns the students of each version of each lesson, in
/// the order of the files; there is at least one. refused: where it is given, it gets the errors of
/// the files that cannot be read, and the others are returned, if there are any.
std::vector<std::vector<StudentResults>> readClasses(
    const std::vector<std::string>& filesAndFolders, std::vector<InputError>* refused = nullptr);

/// Returns the given answer as a cell of a table: the number of the choice from 1, or the number in
/// SI with all its digits, of a point with its place; empty where none was given.
std::string givenText(const LessonResult& result);

/// Returns the same for people: a number has three digits and its unit.
std::string givenInWords(const LessonResult& result);

/// Returns "right", "wrong" or "shown".
std::string verdictWord(const LessonResult& result);

/// Returns the table as CSV: a row for each student with file, date, the numbers of right, wrong
/// and shown answers, and for each step that somebody answered `step_N` (verdictWord) and
/// `step_N_given`; both are empty where this student has not come so far.
std::string classCsv(const std::vector<StudentResults>& students);

/// Returns the same for people, in columns.
std::string classText(const std::vector<StudentResults>& students);

}  // namespace asperity
