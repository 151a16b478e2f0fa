// What a handout of a lesson contains, as blocks: texts, questions with space for an answer, and
// pictures that the program makes from the scenes of the steps. Students get empty charts to draw
// into; teachers the answers, as computed, and the notes. On the students' sheets, everything that
// comes after a question begins on a new page: later texts and curves may contain its answer.
// Threading: any thread on which no OpenGL context of the window is current, with a Qt application.
// Failure: InputError for a scene that cannot run; StopRequested where it was stopped.
#pragma once

#include <QImage>
#include <QString>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/lesson/lesson.h"

namespace asperity {

struct HandoutOptions {
  bool forTeacher = false;
  int threads = 0;  // 0: as many as the machine has
  std::stop_token stop{};
};

struct HandoutPicture {
  QImage image;
  QString name;  // the alternative text of the picture
};

/// Whether a block stays on the page of the next one: a heading stays with its text; the pictures
/// above a question stay with it where that leaves no large part of a page empty.
enum class KeepWithNext { No, IfShort, Always };

/// A block of the page: HTML, or a picture. On paper it is split only where it is longer than a
/// page.
struct HandoutBlock {
  QString html;
  std::optional<HandoutPicture> picture{};
  KeepWithNext withNext = KeepWithNext::No;
  bool beginsPage = false;
  bool isQuestion = false;
};

std::vector<HandoutBlock> handoutBlocks(const Lesson& lesson, const HandoutOptions& options);

}  // namespace asperity
