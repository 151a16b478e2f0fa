// The window with lessons of which nothing is kept from earlier ones, and what tests of them press
// and read.
#pragma once

#include <QFileDialog>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>

#include "tests/core/lesson/lesson_samples.h"
#include "tests/ui/window/main_window_fixture.h"
#include "ui/window/lesson/lessons.h"

namespace asperity {

/// A third step with a point, at a place or free.
inline Lesson sampleWithPoint(bool hasPlace) {
  nlohmann::ordered_json json = sampleLesson();
  json["steps"][1]["prediction"] = {{"kind", "point"}, {"question", "Where?"}, {"tolerance", 0.5}};
  if (hasPlace) json["steps"][1]["prediction"]["x"] = 0.1;
  return lessonOf(json);
}

class LessonsTest : public MainWindowTest {
 protected:
  LessonsTest() {
    for (const char* kept : {"lessonAnswers", "lessonDraft", "lessonFiles", "lessonSteps"})
      QSettings().remove(kept);
  }
  Lessons& lessons() { return window_.lessons(); }
  LessonPlayer& player() { return lessons().player(); }
  QPushButton& button(const char* name) { return control<QPushButton>(name); }
  void click(const char* name) { QTest::mouseClick(&button(name), Qt::LeftButton); }
  QString said(const char* name) { return control<QLabel>(name).text(); }
  bool waitForAnswer() {
    return waitFor([&] { return player().isRevealed(); });
  }
  /// Answers the next question for files, of which several stand in quotation marks.
  void chooseFiles(const QString& files) {
    whenAsked<QFileDialog>([files](QFileDialog& dialog) {
      dialog.findChild<QLineEdit*>("fileNameEdit")->setText(files);
      static_cast<QDialog&>(dialog).accept();
    });
  }
  /// Whether the friction curve itself is on the chart.
  bool showsCurve() {
    for (const DiagramSeries& series : chart().series)
      if (series.id == kPresentCurve && !series.points.empty()) return true;
    return false;
  }
};

}  // namespace asperity
