#include "core/lesson/lesson_file.h"

#include <fmt/format.h>

#include "core/base/file_digest.h"
#include "core/base/input_error.h"
#include "core/base/json_text.h"
#include "core/base/regular_file.h"
#include "core/lesson/lesson_json.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kDeepestLesson = 16;

}  // namespace

const char* const kLessonFormat =
    R"(LESSON.json:
  {"schema": "asperity-lesson/1", "title": {"en": "...", "de": "..."}, "goal": ..., "notes": ...,
   "minutes": 15, "steps": [
     {"text": {"en": ["A paragraph.", "Another one."]}, "scene": "region_1.json",
      "set": {"load.normal_force": 0.01},
      "show": {"tab": "curve", "scale": "log", "curve": "hidden"},
      "controls": {"free": ["sliding.velocity"]},
      "prediction": {"kind": "number", "question": "...", "tolerance": 0.2,
        "answer": {"quantity": "mu", "set": {"sliding.velocity": 0.1}, "over": {"quantity": "mu"}}},
      "after": {"sliding.velocity": 0.1}, "reveal": "It is {answer} times as large."}]}
A prediction is a choice, a number or a point on the chart. What is right is computed.

RESULTS.json is the file in which a student saved the answers. The table of a class (-o FILE.csv)
has a row for each file, and for each step N the columns step_N (right, wrong or shown) and
step_N_given (the number of a choice, or a number in SI).
)";

namespace {

Lesson readAs(LessonReading reading, std::string_view text, const std::string& file,
              const std::filesystem::path& folder, const SceneReader& readNamed) {
  try {
    if (text.size() > kLargestLesson)
      refuseMember(
          "", message("is larger than {} bytes, the most that a lesson may have", kLargestLesson));
    const Json root = parseJson(text, kDeepestLesson, "a lesson is JSON in UTF-8");
    Lesson lesson = parseLesson(root, folder, readNamed, reading);
    lesson.name = std::filesystem::path(file).stem().string();
    lesson.digest = sha256(writeLesson(lesson));
    return lesson;
  } catch (const InputError& error) {
    throw error.file().empty() ? error.in(file) : error;
  }
}

}  // namespace

Lesson readLesson(std::string_view text, const std::string& file,
                  const std::filesystem::path& folder, const SceneReader& readNamed) {
  return readAs(LessonReading::Complete, text, file, folder, readNamed);
}

Lesson readDraft(std::string_view text, const std::string& file,
                 const std::filesystem::path& folder, const SceneReader& readNamed) {
  return readAs(LessonReading::Draft, text, file, folder, readNamed);
}

Lesson readDraftFile(const std::filesystem::path& file, const SceneReader& readNamed) {
  return readDraft(readRegularFile(file, kLargestLesson), file.string(), file.parent_path(),
                   readNamed);
}

Lesson readLessonFile(const std::filesystem::path& file, const SceneReader& readNamed) {
  return readLesson(readRegularFile(file, kLargestLesson), file.string(), file.parent_path(),
                    readNamed);
}

std::string writeLesson(const Lesson& lesson) {
  return lessonJson(lesson).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

bool isLesson(std::string_view text) {
  try {
    const Json beginning = membersUpTo(text, "schema", kDeepestLesson);
    return textMember(beginning, "schema").starts_with("asperity-lesson/");
  } catch (const InputError&) {
    return false;
  }
}

bool isLessonFile(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) return false;
  try {
    return isLesson(readRegularFile(file, kLargestLesson));
  } catch (const InputError&) {
    return false;
  }
}

Lesson readNamedLesson(const std::string& name, const SceneReader& readNamed) {
  std::error_code ignored;
  // A folder may have the same name as a shipped lesson.
  if (std::filesystem::exists(name, ignored) && !std::filesystem::is_directory(name, ignored))
    return readLessonFile(name, readNamed);
  std::vector<std::string_view> names;
  for (const ShippedLesson& lesson : shippedLessons()) {
    names.push_back(lesson.name);
    if (name == lesson.name || name == std::string(lesson.name) + ".json")
      return readLesson(lesson.json, std::string(lesson.name) + ".json", kShippedFolder, readNamed);
  }
  throw InputError(name, "",
                   message("is neither a file nor a shipped lesson; those are {}",
                           fmt::format("{}", fmt::join(names, ", "))));
}

}  // namespace asperity
