// The pages of the lesson editor: the lesson as a whole, and a step with its scene and its
// controls.
#include "ui/window/lesson/lesson_pages.h"

#include <gmock/gmock.h>

#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QToolButton>

#include "tests/ui/window/lesson/lesson_editor_fixture.h"
#include "tests/ui/window/qt_application.h"

namespace asperity {
namespace {

using LessonPagesTest = LessonEditorTest;
using Json = nlohmann::ordered_json;

TEST_F(LessonPagesTest, AnotherStepBeginsAtItsTop) {
  edit(sampleLesson(), 1);
  auto* bar = field<QLabel>("editorScene").parentWidget()->parentWidget();
  while (bar && !qobject_cast<QScrollArea*>(bar)) bar = bar->parentWidget();
  ASSERT_NE(bar, nullptr);
  QScrollBar& scroll = *qobject_cast<QScrollArea*>(bar)->verticalScrollBar();
  ASSERT_TRUE(waitFor([&] { return scroll.maximum() > 100; }));
  scroll.setValue(100);
  type("editorStepTitle", "x");  // scrolls to nothing, and is one step to be undone
  scroll.setValue(100);
  editor_->undo();
  EXPECT_EQ(scroll.value(), 100);
  field<QListWidget>("editorSteps").setCurrentRow(2);
  EXPECT_EQ(scroll.value(), 0);
}

/// What was locked among free controls would stay locked in sight among hidden ones.
TEST_F(LessonPagesTest, NoControlStaysLockedWhereTheOthersAreHidden) {
  edit(sampleLesson(), 1);
  choose("editorOthers", 2);  // free, too
  auto& controls = field<QToolButton>("editorControls");
  EXPECT_EQ(controls.text(), "all except: normal force") << controls.text().toStdString();
  emit controls.menu()->aboutToShow();
  controls.menu()->findChild<QAction*>("free:sliding.kind")->trigger();
  const LessonControls& chosen = editor_->lesson().steps[0].controls;
  EXPECT_THAT(chosen.locked, testing::ElementsAre("load.normal_force", "sliding.kind"));
  choose("editorOthers", 0);  // hidden
  EXPECT_THAT(chosen.locked, testing::IsEmpty());
  EXPECT_THAT(chosen.free, testing::ElementsAre("sliding.velocity"));
  EXPECT_FALSE(controls.text().contains("except")) << controls.text().toStdString();
  choose("editorOthers", 2);
  EXPECT_EQ(controls.text(), "all");
}

/// A step whose predecessor is removed keeps its scene, and its changes can still be seen.
TEST_F(LessonPagesTest, AStepShowsItsSceneAndKeepsItsChanges) {
  Json json = sampleLesson();
  json["steps"][0]["scene"]["title"] = "The small line";
  edit(json, 2);
  EXPECT_EQ(field<QLabel>("editorScene").text(), "The small line, as step 1 leaves it");
  const Scene scene = editor_->lesson().steps[1].scene;
  field<QListWidget>("editorSteps").setCurrentRow(1);
  editor_->removeStep();
  ASSERT_EQ(editor_->lesson().steps.size(), 1U);
  EXPECT_EQ(editor_->lesson().steps[0].scene, scene);
  EXPECT_EQ(editor_->lesson().steps[0].set,
            (std::vector<std::string>{"sliding.velocity=0.0002", "load.normal_force=20mN"}));
  EXPECT_EQ(field<QLabel>("editorScene").text(), "The small line");
}

TEST_F(LessonPagesTest, AStepTakesTheSceneThatIsShown) {
  edit(sampleLesson(), 1);
  const Scene next = editor_->lesson().steps[1].scene;
  field<QPushButton>("editorTakeScene").click();
  EXPECT_EQ(editor_->errorText(), QString());
  EXPECT_EQ(editor_->lesson().steps[0].scene.surface, session().scene().surface);
  EXPECT_NE(editor_->lesson().steps[0].scene.surface, next.surface);
  EXPECT_EQ(editor_->lesson().steps[1].scene, next);
  EXPECT_EQ(editor_->lesson().steps[1].set, std::vector<std::string>{"load.normal_force=20mN"});
}

TEST_F(LessonPagesTest, TheTextsAfterAnAnswerNameTheirPlaceholders) {
  edit(sampleLesson(), 1);
  auto& reveal = field<QPlainTextEdit>("editorReveal");
  for (const QString& text : {reveal.placeholderText(), reveal.toolTip()})
    EXPECT_TRUE(text.contains("{answer}") && text.contains("{given}")) << text.toStdString();
  for (const char* name : {"editorRight", "editorWrong"}) {
    auto& line = field<QLineEdit>(name);
    for (const QString& text : {line.placeholderText(), line.toolTip()})
      EXPECT_TRUE(text.contains("{answer}") && text.contains("{given}")) << text.toStdString();
  }
}

}  // namespace
}  // namespace asperity
