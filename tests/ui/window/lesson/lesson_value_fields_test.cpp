// The rows for a computed answer: its changes, its place, and what the picture shows of it.
#include "ui/window/lesson/lesson_value_fields.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QLineEdit>

#include "tests/ui/window/lesson/lesson_editor_fixture.h"
#include "tests/ui/window/qt_application.h"

namespace asperity {
namespace {

using LessonValueFieldsTest = LessonEditorTest;
using Json = nlohmann::ordered_json;

/// Else the texts after the answer would stand beside the old picture.
TEST_F(LessonValueFieldsTest, ThePictureFollowsTheChangesOfTheAnswer) {
  edit(sampleLesson(), 1);
  const auto& step = editor_->lesson().steps[0];
  type("editorValueSet:sliding.velocity", "0.3 mm/s");
  EXPECT_EQ(step.after, step.prediction->answer->set);
  EXPECT_EQ(step.revealedScene.sliding.velocity, 3e-4);
  EXPECT_NE(editor_->findChild<QLineEdit*>("editorAfter:sliding.velocity"), nullptr);
  type("editorAfter:sliding.velocity", "0.4 mm/s");  // the teacher's own choice stays
  type("editorValueSet:sliding.velocity", "0.5 mm/s");
  EXPECT_EQ(step.revealedScene.sliding.velocity, 4e-4);
}

TEST_F(LessonValueFieldsTest, APictureThatStaysThoughTheAnswerHasChangesIsSaid) {
  Json json = sampleLesson();
  json["steps"][0].erase("after");
  edit(json, 1);
  EXPECT_TRUE(field<QLabel>("editorComputed").text().contains("The picture stays as it is"));
}

/// Else everything below would move when the number comes.
TEST_F(LessonValueFieldsTest, ThePlaceOfTheComputedAnswerIsKept) {
  edit(sampleLesson(), 2);
  auto& said = field<QLabel>("editorComputed");
  EXPECT_TRUE(said.isVisibleTo(editor_));
  EXPECT_FALSE(said.text().contains("The program finds"));
  const int height = said.sizeHint().height();
  ASSERT_TRUE(waitFor([&] { return said.text().contains("The program finds"); }));
  EXPECT_EQ(said.sizeHint().height(), height);
}

}  // namespace
}  // namespace asperity
