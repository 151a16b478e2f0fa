// Work on lessons that is in no file yet: the answers of students and the draft of the lesson in
// the editor. It is kept in the user's settings, so that a crash does not lose it, until it is
// saved or discarded. GUI thread. Failure: what cannot be read again is as if it had never been
// kept.
#pragma once

#include <optional>
#include <string>

#include "core/lesson/lesson_results.h"

namespace asperity {

/// Keeps the answers of one lesson in place of those kept before.
void keepAnswers(const LessonResults& results);
/// Returns the answers that are kept of this lesson; nothing where there are none.
std::optional<LessonResults> keptAnswers(const Lesson& lesson);
void forgetAnswers(const Lesson& lesson);

/// The lesson in the editor: as it is, as it was when it was saved, and its file, which is empty
/// where it has none.
struct LessonDraft {
  Lesson lesson, saved;
  std::string file;
};

/// Keeps the draft in place of the one before. A lesson that could not be read again is not kept:
/// the one before stays. folder: where the scenes are that it names.
void keepDraft(const LessonDraft& draft, const std::string& folder);
std::optional<LessonDraft> keptDraft();
void forgetDraft();

}  // namespace asperity
