// The lesson editor over the main window, and a teacher who uses it. For tests on the GUI thread.
#pragma once

#include <QComboBox>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTableWidget>
#include <QTest>
#include <string>

#include "tests/core/lesson/lesson_samples.h"
#include "tests/ui/window/main_window_fixture.h"
#include "ui/window/lesson/lesson_editor.h"
#include "ui/window/lesson/lessons.h"

namespace asperity {

/// The sample with its second step asking for the largest value of the curve.
inline nlohmann::ordered_json sampleWithPeak() {
  nlohmann::ordered_json json = sampleLesson();
  json["steps"][1]["prediction"] = {
      {"kind", "point"}, {"question", "Where?"}, {"tolerance", 0.5}, {"place_tolerance", 0.8}};
  return json;
}

class LessonEditorTest : public MainWindowTest {
 protected:
  /// Opens the editor at a step, from 1.
  void edit(const nlohmann::ordered_json& lesson, int step) {
    editor_ = &window_.lessons().showEditor(lessonOf(lesson), {});
    editor_->findChild<QListWidget*>("editorSteps")->setCurrentRow(step);
  }
  void TearDown() override {
    delete editor_;  // else it would ask about its changes
    MainWindowTest::TearDown();
  }
  template <class Widget>
  Widget& field(const char* name) {
    return *editor_->findChild<Widget*>(name);
  }
  void type(const char* name, const QString& text) {
    auto& line = field<QLineEdit>(name);
    line.setFocus();
    line.selectAll();
    if (text.isEmpty())
      QTest::keyClick(&line, Qt::Key_Delete);
    else
      QTest::keyClicks(&line, text);
  }
  void setCell(int row, int column, const QString& text) {
    field<QTableWidget>("editorChoices").item(row, column)->setText(text);
  }
  void choose(const char* name, int index) {
    auto& box = field<QComboBox>(name);
    box.setFocus();
    box.setCurrentIndex(index);
    emit box.activated(index);
  }
  std::string errorText() const { return editor_->errorText().toStdString(); }
  bool canTry() { return field<QPushButton>("editorTry").isEnabled(); }
  const LessonPrediction& prediction(std::size_t step) const {
    return *editor_->lesson().steps[step].prediction;
  }

  LessonEditor* editor_ = nullptr;
};

}  // namespace asperity
