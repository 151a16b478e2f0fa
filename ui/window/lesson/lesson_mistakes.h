// What a lesson lacks, and mistakes in its predictions, in the words and units of the lesson
// editor. The check of its file (core/lesson/lesson_file.h) refuses the same, in the words of the
// file. GUI thread.
#pragma once

#include <QString>
#include <QStringList>

#include "core/lesson/lesson.h"

namespace asperity {

/// Returns the first mistake, with the number of its step; empty where there is none.
QString findMistake(const Lesson& lesson);

/// Returns whether the picture of a step does not change with its answer, although the answer is
/// computed after changes of the scene.
bool keepsPicture(const LessonStep& step);

/// Returns the texts that lack this language and have the other one, as "step 1, title"; none where
/// nothing is written in this language.
QStringList missingTexts(const Lesson& lesson, bool inGerman);

/// Returns whether the curve of a step, in sight before the answer, shows the number that it asks
/// for.
bool showsAnswer(const LessonStep& step);

}  // namespace asperity
