#include "core/lesson/lesson_class.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/scene/data_table.h"

namespace asperity {
namespace {

using Row = std::vector<std::string>;

/// Returns the JSON files in a folder, by name.
std::vector<std::filesystem::path> jsonFilesIn(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  if (files.empty()) throw InputError(folder.string(), "", "has no results of a lesson");
  std::ranges::sort(files);
  return files;
}

/// Returns the steps that somebody answered, in their order.
std::set<int> answeredSteps(const std::vector<StudentResults>& students) {
  std::set<int> steps;
  for (const StudentResults& student : students)
    for (const LessonResult& one : student.results.results) steps.insert(one.step);
  return steps;
}

Row summaryCells(const LessonResults& results) {
  return {std::to_string(results.right()), std::to_string(results.wrong()),
          std::to_string(results.shown())};
}

}  // namespace

ClassResults readClasses(const std::vector<std::string>& filesAndFolders) {
  ClassResults found;
  std::vector<std::vector<StudentResults>>& classes = found.classes;
  const auto read = [&](const std::filesystem::path& file) {
    LessonResults results = readResultsFile(file);
    auto known = std::ranges::find_if(classes, [&](const std::vector<StudentResults>& one) {
      return one.front().results.digest == results.digest;
    });
    if (known == classes.end())
      known = classes.insert(classes.end(), std::vector<StudentResults>());
    known->push_back({file.filename().string(), std::move(results)});
  };
  const auto tryTo = [&](const auto& work) {
    try {
      work();
    } catch (const InputError& error) {
      found.refused.push_back(error);
    }
  };
  std::error_code ignored;
  for (const std::string& one : filesAndFolders)
    tryTo([&] {
      if (!std::filesystem::is_directory(one, ignored)) return read(one);
      for (const std::filesystem::path& file : jsonFilesIn(one)) tryTo([&] { read(file); });
    });
  if (classes.empty() && !found.refused.empty()) throw InputError(found.refused.front());
  return found;
}

const std::vector<StudentResults>& onlyClass(const ClassResults& results) {
  const auto& classes = results.classes;
  const StudentResults& first = classes.front().front();
  if (classes.size() == 1) return classes.front();
  const StudentResults& other = classes[1].front();
  throw InputError(
      other.file, "",
      other.results.title == first.results.title
          ? message("has results of another version of '{}' than {}; a table is of one version",
                    other.results.title, first.file)
          : message("has results of '{}', but {} has those of '{}'; a table is of one lesson",
                    other.results.title, first.file, first.results.title));
}

std::string givenText(const LessonResult& result) {
  const GivenAnswer& given = result.given;
  if (!given.isGiven()) return {};
  if (result.kind == PredictionKind::Choice) return std::to_string(given.choice + 1);
  if (result.kind == PredictionKind::Number) return plainNumber(given.number);
  return plainNumber(given.number) + " at " + plainNumber(given.x);
}

std::string verdictWord(const LessonResult& result) {
  return !result.given.isGiven() ? "shown" : result.isRight ? "right" : "wrong";
}

std::string classCsv(const std::vector<StudentResults>& students) {
  const std::set<int> steps = answeredSteps(students);
  std::vector<Row> rows = {{"file", "date", "right", "wrong", "shown"}};
  for (const int step : steps) {
    rows.front().push_back(fmt::format("step_{}", step + 1));
    rows.front().push_back(fmt::format("step_{}_given", step + 1));
  }
  for (const StudentResults& student : students) {
    Row row = {student.file, student.results.date};
    for (const std::string& cell : summaryCells(student.results)) row.push_back(cell);
    for (const int step : steps) {
      const LessonResult* one = student.results.find(step);
      row.push_back(one ? verdictWord(*one) : std::string());
      row.push_back(one ? givenText(*one) : std::string());
    }
    rows.push_back(row);
  }
  std::string text;
  for (const Row& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i)
      text += csvCell(row[i]) + (i + 1 < row.size() ? "," : "\n");
  return text;
}

}  // namespace asperity
