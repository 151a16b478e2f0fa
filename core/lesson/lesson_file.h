// Lessons as files (JSON, "schema": "asperity-lesson/1"). The reader checks everything that can be
// checked without a simulation: every scene of every step, every key, every choice. A draft may
// lack what a lesson needs to be played. Pure except for reading the scenes that a lesson names.
// Failure: InputError with the file, the path ("steps[2].prediction.answer"), what is wrong and
// what is allowed.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "core/base/shipped_file.h"
#include "core/lesson/lesson.h"
#include "core/scene/scene_file.h"

namespace asperity {

inline constexpr std::string_view kLessonSchema = "asperity-lesson/1";
inline constexpr std::size_t kLargestLesson = std::size_t{4} << 20;  // bytes
inline constexpr std::size_t kMaxLessonSteps = 200;

/// Describes for users what a file may contain.
extern const char* const kLessonFormat;

/// Reads a lesson. readNamed reads the scenes that the lesson names; null: they are files
/// relative to the folder of the lesson.
Lesson readLessonFile(const std::filesystem::path& file, const SceneReader& readNamed = {});

/// Reads the same from a text; `file` is named in errors.
Lesson readLesson(std::string_view json, const std::string& file,
                  const std::filesystem::path& folder = {}, const SceneReader& readNamed = {});

/// Reads a lesson on which somebody still writes: what it lacks and what of it cannot run is left
/// as it is, and the scene of a step with an impossible change is that without the change. Throws
/// InputError for what is no lesson, and where a scene cannot be read.
Lesson readDraft(std::string_view json, const std::string& file,
                 const std::filesystem::path& folder = {}, const SceneReader& readNamed = {});
Lesson readDraftFile(const std::filesystem::path& file, const SceneReader& readNamed = {});

/// Returns the canonical text, which reads back to the same lesson.
std::string writeLesson(const Lesson& lesson);

/// Returns whether a regular file is meant to be a lesson: the schema of its outermost object is
/// that of a lesson, of any version; false where it cannot be read.
bool isLessonFile(const std::filesystem::path& file);

/// Returns the shipped lessons in the order of a course.
std::span<const ShippedFile> shippedLessons();

/// Returns the lesson of a file or, where there is none, the shipped one of this name, with or
/// without ".json". Throws InputError, which names the shipped ones where there is neither.
Lesson readNamedLesson(const std::string& name, const SceneReader& readNamed = {});

}  // namespace asperity
