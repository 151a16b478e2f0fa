// Handouts of lessons on paper and as a web page: texts, questions with space for an answer, and
// pictures that the program makes from the scenes of the steps. Students get empty charts to draw
// into; teachers the answers, as computed, and the notes. On the students' sheets, everything that
// comes after a question begins on a new page: later texts and curves may contain its answer. One
// file without links; the same bytes for the same lesson and language.
// Threading: any thread on which no OpenGL context of the window is current, with a Qt application.
// Failure: InputError for another extension than .html or .pdf, or a scene that cannot run;
// std::runtime_error where it cannot be written; StopRequested where it was stopped.
#pragma once

#include <QByteArray>
#include <QString>
#include <filesystem>
#include <functional>
#include <stop_token>

#include "core/lesson/lesson.h"

namespace asperity {

struct HandoutOptions {
  bool forTeacher = false;
  int threads = 0;  // 0: as many as the machine has
  std::stop_token stop{};
  /// Called with the part that is done; may be empty.
  std::function<void(double part)> progress{};
};

/// Returns a page of HTML with its pictures in it.
QByteArray handoutHtml(const Lesson& lesson, const HandoutOptions& options = {});

/// Returns the same as PDF on A4.
QByteArray handoutPdf(const Lesson& lesson, const HandoutOptions& options = {});

/// Writes HTML or PDF, by the extension.
void writeHandout(const std::filesystem::path& file, const Lesson& lesson,
                  const HandoutOptions& options = {});

}  // namespace asperity
