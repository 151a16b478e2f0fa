// The rows of the lesson editor: texts in two languages, numbers, and lists of changes.
#include "ui/window/lesson/lesson_form.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSet>
#include <QSpinBox>
#include <QTabBar>
#include <QToolButton>
#include <QWheelEvent>

#include "tests/ui/window/lesson/lesson_editor_fixture.h"
#include "tests/ui/window/qt_application.h"

namespace asperity {
namespace {

using LessonFormTest = LessonEditorTest;
using Json = nlohmann::ordered_json;

/// The form may be narrower than its sentences.
TEST_F(LessonFormTest, LongTextsOfTheFormAreWrapped) {
  Json json = sampleLesson();
  json["steps"][0]["scene"]["title"] = QString(120, 'n').toStdString();
  edit(json, 1);
  auto& said = field<QLabel>("editorComputed");
  const auto isWhole = [&] {
    return said.isVisible() && said.height() >= said.heightForWidth(said.width());
  };
  EXPECT_TRUE(waitFor(isWhole));
  const int before = said.height();
  editor_->resize(editor_->minimumSizeHint());
  EXPECT_TRUE(waitFor([&] { return isWhole() && said.height() >= before; }));
  const auto& scene = field<QLabel>("editorScene");
  EXPECT_GE(scene.height(), scene.heightForWidth(scene.width()));
  EXPECT_LE(scene.geometry().right(), field<QPushButton>("editorTakeScene").x());
}

TEST_F(LessonFormTest, WhatIsNoNumberIsSaidAndChangesNothing) {
  Json json = sampleWithPeak();
  json["steps"][1]["prediction"].erase("place_tolerance");
  json["steps"][1]["prediction"]["x"] = 0.1;
  edit(json, 2);
  type("editorX", "abc");
  EXPECT_EQ(errorText(), "Step 2: Place on the axis: “abc” is not a number");
  EXPECT_FALSE(canTry());
  EXPECT_EQ(prediction(1).x, 0.1);  // the question is still the same
  type("editorX", "10 mm/s");
  EXPECT_EQ(errorText(), "");
  EXPECT_EQ(prediction(1).x, 0.01);
  type("editorTolerance", "abc");
  EXPECT_EQ(errorText(), "Step 2: Tolerance in %: “abc” is not a number");
  EXPECT_EQ(prediction(1).tolerance, 0.5);
  type("editorTolerance", "-5");
  EXPECT_EQ(errorText(), "Step 2: Tolerance in %: -5 is not above 0 and up to 1000");
  type("editorTolerance", "20");
  EXPECT_EQ(errorText(), "");
}

TEST_F(LessonFormTest, ATranslatorSeesTheOriginalAndWhatIsMissing) {
  Json json = sampleLesson();
  edit(json, 1);
  auto& language = field<QTabBar>("editorLanguage");
  EXPECT_EQ(language.tabText(0), "English");
  EXPECT_TRUE(language.tabText(1).startsWith("Deutsch (")) << language.tabText(1).toStdString();
  EXPECT_TRUE(language.tabToolTip(1).contains("step 1, choice 2"));
  language.setCurrentIndex(1);
  EXPECT_EQ(field<QPlainTextEdit>("editorQuestion").placeholderText(), "Twice as fast?");
  EXPECT_EQ(field<QLineEdit>("editorStepTitle").placeholderText(), "First");
  EXPECT_EQ(field<QLineEdit>("editorStepTitle").text(), "");
  const qsizetype before = language.tabToolTip(1).count("step ");
  type("editorStepTitle", "Erstens");
  EXPECT_EQ(language.tabToolTip(1).count("step "), before - 1);
}

/// Else the wheel that scrolls the form would change the lesson below the pointer.
TEST_F(LessonFormTest, TheWheelChangesOnlyAFieldWithFocus) {
  edit(sampleLesson(), 1);
  ASSERT_TRUE(waitFor([&] {
    editor_->activateWindow();
    return editor_->isActiveWindow();
  }));
  const auto turn = [](QWidget& widget, int delta) {
    QWheelEvent event(QPointF(5, 5), widget.mapToGlobal(QPointF(5, 5)), {}, {0, delta},
                      Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&widget, &event);
  };
  const std::string before = writeLesson(editor_->lesson());
  field<QLineEdit>("editorStepTitle").setFocus();
  for (const int delta : {120, -120}) {
    for (QComboBox* box : editor_->findChildren<QComboBox*>()) {
      EXPECT_EQ(box->focusPolicy(), Qt::StrongFocus) << box->objectName().toStdString();
      const int index = box->currentIndex();
      turn(*box, delta);
      EXPECT_EQ(box->currentIndex(), index) << box->objectName().toStdString();
    }
    turn(field<QSpinBox>("editorMinutes"), delta);
  }
  EXPECT_EQ(writeLesson(editor_->lesson()), before);
  auto& tab = field<QComboBox>("editorTab");
  tab.setFocus();
  ASSERT_TRUE(waitFor([&] { return tab.hasFocus(); }));
  turn(tab, -120);
  EXPECT_EQ(tab.currentIndex(), 1);
}

/// A page has several lists of changes, whose buttons have the same text.
TEST_F(LessonFormTest, TheButtonsOfTheListsOfChangesSayWhichOneTheyBelongTo) {
  edit(sampleLesson(), 1);
  QSet<QString> lists;
  for (const char* name : {"editorSet", "editorAfter", "editorValueSet"})
    lists += field<QToolButton>(name).accessibleDescription();
  EXPECT_EQ(lists.size(), 3);
}

TEST_F(LessonFormTest, TheTabKeyGoesThroughTheChangesInTheirOrder) {
  Json json = sampleLesson();
  json["steps"][1]["set"] = {{"accuracy.scheme", "nodal"}, {"load.normal_force", "20mN"}};
  edit(json, 2);
  QStringList names;
  for (const QWidget* widget = &field<QWidget>("editorSet:accuracy.scheme"); names.size() < 5;
       widget = widget->nextInFocusChain())
    if (widget->focusPolicy() & Qt::TabFocus) names += widget->objectName();
  EXPECT_EQ(
      names.join(' ').toStdString(),
      "editorSet:accuracy.scheme editorSetWithout:accuracy.scheme editorSet:load.normal_force "
      "editorSetWithout:load.normal_force editorSet");
}

}  // namespace
}  // namespace asperity
