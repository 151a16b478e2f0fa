// What a lesson lacks, and mistakes in its predictions, in the words and units of the lesson
// editor. The check of its file (core/lesson/lesson_file.h) refuses the same, in the words of the
// file. GUI thread.
#pragma once

#include <QString>

#include "core/lesson/lesson.h"

namespace asperity {

/// Returns the first mistake, with the number of its step; empty where there is none.
QString findMistake(const Lesson& lesson);

/// Returns whether the curve of a step, in sight before the answer, shows the number that it asks
/// for.
bool showsAnswer(const LessonStep& step);

}  // namespace asperity
