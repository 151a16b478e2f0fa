// The lesson in the editor as a document: edits that are undone, scenes that steps keep, and the
// draft against a crash.
#include "ui/window/lesson/lesson_document.h"

#include <gtest/gtest.h>

#include "core/base/input_error.h"
#include "core/lesson/lesson_file.h"
#include "tests/core/lesson/lesson_samples.h"
#include "tests/core/temporary_folder.h"
#include "tests/ui/window/qt_application.h"

namespace asperity {
namespace {

LessonDocument sampleDocument() {
  return {lessonOf(sampleLesson()), {}};
}

TEST(LessonDocument, WhatIsTypedIntoOneFieldIsOneEdit) {
  LessonDocument document = sampleDocument();
  const std::string before = document.lesson.title.english;
  EXPECT_FALSE(document.canUndo());
  EXPECT_FALSE(document.remember(0, "title")) << "nothing has changed";
  for (const char* typed : {"F", "Fr", "Friction"}) {
    document.lesson.title.english = typed;
    EXPECT_TRUE(document.remember(0, "title"));
  }
  document.lesson.goal.english = "Another goal";
  document.remember(0, "goal");
  EXPECT_EQ(document.undo(), 0);
  EXPECT_EQ(document.lesson.title.english, "Friction");
  document.undo();
  EXPECT_EQ(document.lesson.title.english, before);
  EXPECT_FALSE(document.canUndo());
  document.redo();
  EXPECT_EQ(document.lesson.title.english, "Friction");
  document.lesson.title.english = "Friction of rubber";  // the break makes it another edit
  document.remember(0, "title");
  EXPECT_FALSE(document.canRedo());
  document.undo();
  EXPECT_EQ(document.lesson.title.english, "Friction");
}

/// The second step is a change of what the first one leaves.
TEST(LessonDocument, StepsKeepTheirScenesWhereOthersComeAndGo) {
  LessonDocument document = sampleDocument();
  document.updateScenes();
  const Scene first = document.lesson.steps[0].scene, second = document.lesson.steps[1].scene;
  ASSERT_FALSE(first == second);
  LessonStep between;
  between.text.english = "Between";
  between.scene = first;
  between.scene.load.normalForce = 0.5;
  document.insertStep(1, between);
  document.updateScenes();
  EXPECT_EQ(document.lesson.steps[1].scene.load.normalForce, 0.5);
  EXPECT_TRUE(document.lesson.steps[2].scene == second);
  document.swapSteps(1, 2);
  document.updateScenes();
  EXPECT_TRUE(document.lesson.steps[1].scene == second);
  document.removeStep(0);
  document.updateScenes();
  EXPECT_TRUE(document.lesson.steps[0].scene == second);
}

TEST(LessonDocument, WhatIsInNoFileIsKeptUntilItIsSaved) {
  const TemporaryFolder folder;
  LessonDocument document = sampleDocument();
  document.lesson.title.english = "A draft";
  document.keep();
  ASSERT_TRUE(keptDraft());
  EXPECT_EQ(keptDraft()->lesson.title.english, "A draft");
  EXPECT_TRUE(keptDraft()->isChanged());
  document.save(QString::fromStdString((folder / "draft.json").string()));
  EXPECT_FALSE(document.isChanged());
  document.keep();
  EXPECT_FALSE(keptDraft());
}

/// What cannot be read leaves the lesson as it is.
TEST(LessonDocument, AFileThatIsNoLessonChangesNothing) {
  const TemporaryFolder folder;
  folder.write("notes.json", "{\"schema\": \"asperity-scene/1\"}");
  LessonDocument document = sampleDocument();
  const std::string before = writeLesson(document.lesson);
  EXPECT_THROW(document.open(QString::fromStdString((folder / "notes.json").string())), InputError);
  EXPECT_EQ(writeLesson(document.lesson), before);
}

}  // namespace
}  // namespace asperity
