// The list of lessons: what each teaches, how one begins, and files that are none.
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QListWidget>
#include <QScrollArea>
#include <QScrollBar>
#include <atomic>
#include <stdexcept>

#include "tests/core/temporary_folder.h"
#include "tests/ui/window/lesson/lessons_fixture.h"
#include "ui/window/lesson/lesson_list.h"
#include "ui/window/main/scene_library.h"

namespace asperity {
namespace {

class LessonListTest : public LessonsTest {};

TEST_F(LessonListTest, ALessonIsSeenThoughTheGalleryWasOpen) {
  window_.openGallery();
  QWidget& contact = control<QWidget>("contactPage");
  ASSERT_FALSE(contact.isVisible());
  lessons().start(lessonOf(sampleLesson()));
  EXPECT_TRUE(contact.isVisible());
}

TEST_F(LessonListTest, TheListSaysWhatEachTeachesAndBeginsIt) {
  action("lessons").trigger();
  auto& list = control<LessonList>("lessonList");
  auto& names = *list.findChild<QListWidget*>("lessonNames");
  EXPECT_EQ(names.count(), static_cast<int>(shippedLessons().size()));
  names.setCurrentRow(1);
  EXPECT_EQ(list.chosen(), "load_and_friction");
  const auto said = [&] { return list.findChild<QLabel*>("lessonAbout")->text(); };
  EXPECT_TRUE(said().contains("15 minutes"));
  EXPECT_FALSE(said().contains("A good question for the class"));  // answers are for teachers
  list.findChild<QCheckBox*>("lessonNotes")->click();
  EXPECT_TRUE(said().contains("A good question for the class"));
  EXPECT_TRUE(waitFor([&] { return said().contains("right within"); }));  // computed, then listed
  QTest::keyClick(&names, Qt::Key_Return);
  ASSERT_TRUE(player().isRunning());
  EXPECT_EQ(player().lesson()->name, "load_and_friction");
}

TEST_F(LessonListTest, TheListTriesAnswersThatFailedAgain) {
  std::atomic<int> tries = 0;
  LessonList list(&window_, [&tries](const LessonStep& step, const CurveOptions& options) {
    if (++tries == 1) throw std::runtime_error("no room in memory");
    return lessonAnswer(step, options);
  });
  list.show();
  list.findChild<QListWidget*>("lessonNames")->setCurrentRow(1);
  const auto said = [&](const char* name) { return list.findChild<QLabel*>(name)->text(); };
  auto& notes = *list.findChild<QCheckBox*>("lessonNotes");
  notes.click();
  EXPECT_TRUE(said("lessonAbout").contains("They are being computed"));
  ASSERT_TRUE(waitFor([&] { return said("lessonStatus").contains("no room in memory"); }));
  EXPECT_TRUE(said("lessonAbout").contains("They could not be computed."));
  EXPECT_EQ(tries, 1);
  notes.click();
  notes.click();
  EXPECT_TRUE(waitFor([&] { return said("lessonAbout").contains("right within"); }));
  EXPECT_EQ(said("lessonStatus"), "");
}

TEST_F(LessonListTest, TheListShowsAnotherLessonFromItsBeginning) {
  LessonList& list = lessons().showList();
  list.resize(500, 260);
  list.findChild<QCheckBox*>("lessonNotes")->click();
  auto& bar = *list.findChild<QScrollArea*>()->verticalScrollBar();
  ASSERT_TRUE(waitFor([&] { return bar.maximum() > 0; }));
  bar.setValue(bar.maximum());
  EXPECT_GT(bar.value(), 0);
  list.findChild<QListWidget*>("lessonNames")->setCurrentRow(1);
  EXPECT_EQ(bar.value(), 0);
}

TEST_F(LessonListTest, AWrongFileIsOneMessage) {
  TemporaryFolder folder;
  folder.write("wrong.json", "{\"schema\": \"asperity-lesson/1\"}");
  EXPECT_FALSE(lessons().open(QString::fromStdString((folder / "wrong.json").string())));
  EXPECT_TRUE(window_.messages().text().contains("title"));
  EXPECT_FALSE(player().isRunning());
}

/// A lesson is dropped on the window like any other file.
TEST_F(LessonListTest, ADroppedLessonStarts) {
  TemporaryFolder folder;
  folder.write("mine.json", writeLesson(lessonOf(sampleLesson())));
  drop(QString::fromStdString((folder / "mine.json").string()));
  EXPECT_TRUE(waitFor([this] { return player().isRunning(); }));
}

}  // namespace
}  // namespace asperity
