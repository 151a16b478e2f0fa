// The lesson editor: computed answers, numbers that cannot be read, undo, scenes of steps; and what
// students' handouts leave out.
#include <gtest/gtest.h>

#include <QDir>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTest>
#include <QTimer>

#include "core/lesson/lesson_file.h"
#include "tests/core/lesson/lesson_samples.h"
#include "tests/core/temporary_folder.h"
#include "tests/ui/window/lesson/lesson_editor_fixture.h"
#include "tests/ui/window/main_window_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "ui/window/lesson/handout.h"
#include "ui/window/lesson/lesson_editor.h"
#include "ui/window/lesson/lesson_text.h"
#include "ui/window/lesson/lessons.h"
#include "ui/window/main/scene_library.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

/// A student could not go on where no choice covers the computed answer, which is about 2.
TEST_F(LessonEditorTest, RangesThatDoNotCoverTheComputedAnswerAreNotPlayed) {
  edit(sampleLesson(), 1);
  EXPECT_TRUE(canTry());
  setCell(1, 3, "1.6");
  EXPECT_FALSE(canTry());  // nor before the answer is known
  ASSERT_TRUE(waitFor([&] { return !editor_->isComputing(); }));
  EXPECT_TRUE(errorText().starts_with("Step 1, choices: none of them covers the computed answer"))
      << errorText();
  EXPECT_LT(errorText().size(), 65U) << errorText();  // a number of a few digits
  EXPECT_FALSE(canTry());
  setCell(1, 3, "2.9");  // a gap in which the answer is not
  EXPECT_TRUE(waitFor([&] { return canTry(); }));
  EXPECT_EQ(errorText(), "");
}

TEST_F(LessonEditorTest, SaysWhatTheProgramFindsAndOverHowManyLines) {
  edit(sampleLesson(), 1);
  auto& said = field<QLabel>("editorComputed");
  EXPECT_TRUE(said.isVisibleTo(editor_));
  EXPECT_TRUE(said.text().contains("4 lines"));
  EXPECT_TRUE(waitFor([&] { return said.text().contains("The program finds"); }));
}

/// An answer is computed as long as it is shown or needed, and not for a lesson that is gone.
TEST_F(LessonEditorTest, StopsComputingWhatNobodyNeeds) {
  edit(sampleLesson(), 1);
  EXPECT_TRUE(editor_->hasWork());
  field<QListWidget>("editorSteps").setCurrentRow(0);
  EXPECT_FALSE(editor_->hasWork());
  field<QListWidget>("editorSteps").setCurrentRow(1);
  setCell(1, 3, "1.6");
  EXPECT_TRUE(editor_->isComputing());
  TemporaryFolder folder;
  folder.write("other.json", writeLesson(lessonOf(sampleLesson())));
  editor_->openFile(QString::fromStdString((folder / "other.json").string()));
  EXPECT_FALSE(editor_->hasWork());
  EXPECT_FALSE(editor_->isComputing());
  QTest::qWait(300);  // nothing of the former lesson arrives
  EXPECT_EQ(errorText(), "");
}

TEST_F(LessonEditorTest, WhatALessonLacksIsSaidInAPlainSentence) {
  editor_ = &window_.lessons().showEditor({}, {});
  EXPECT_EQ(errorText(), "The lesson needs a title");
  type("editorTitle", "Mine");
  EXPECT_EQ(errorText(), "A lesson needs at least one step");
  editor_->addShownStep();
  EXPECT_EQ(errorText(), "");
  field<QPlainTextEdit>("editorText").clear();
  EXPECT_EQ(errorText(), "Step 1: the step needs a text");
  field<QPlainTextEdit>("editorText").setPlainText("Look.");
  choose("editorKind", 3);
  EXPECT_EQ(errorText(), "Step 1: the question needs a text");
  field<QPlainTextEdit>("editorQuestion").setPlainText("Where?");
  EXPECT_EQ(errorText(), "");
  choose("editorTab", 1);
  EXPECT_EQ(errorText(),
            "Step 1: a point needs the tab “Friction curve” in front, on which it lies");
}

/// Teachers write a lesson on several days, and see at once what it still needs.
TEST_F(LessonEditorTest, ALessonThatIsNotCompleteIsSavedAndOpenedAgain) {
  TemporaryFolder folder;
  const QString file = QString::fromStdString((folder / "draft.json").string());
  editor_ = &window_.lessons().showEditor({}, {});
  type("editorTitle", "Mine");
  editor_->addShownStep();
  choose("editorKind", 1);
  EXPECT_EQ(errorText(), "Step 1: the question needs a text");
  EXPECT_FALSE(canTry());
  EXPECT_TRUE(field<QPushButton>("editorSave").isEnabled());
  ASSERT_TRUE(editor_->saveTo(file));
  EXPECT_TRUE(field<QLabel>("editorComplaint").text().contains("the question needs a text"));
  EXPECT_TRUE(editor_->canClose());
  EXPECT_EQ(writeLesson(readDraftFile(file.toStdString())), writeLesson(editor_->lesson()));
  // Ctrl+S writes the same file without a question.
  ASSERT_TRUE(waitFor([&] {
    editor_->activateWindow();
    return editor_->isActiveWindow();
  }));
  type("editorStepTitle", "First");
  QTest::keyClick(&field<QLineEdit>("editorStepTitle"), Qt::Key_S, Qt::ControlModifier);
  EXPECT_EQ(readDraftFile(file.toStdString()).steps[0].title.english, "First");
  // As a lesson it is refused with what is missing, and where it is completed.
  EXPECT_FALSE(window_.lessons().open(file));
  EXPECT_TRUE(window_.messages().text().contains("question"));
  EXPECT_TRUE(window_.messages().text().contains("Lesson editor"));
}

/// A student's file of the same name is another scene.
TEST_F(LessonEditorTest, AShippedLessonHasTheShippedScenesInAnyFolder) {
  const Lesson lesson = readNamedLesson("load_and_friction", readNamedScene);
  ASSERT_EQ(lesson.steps[0].sceneName, "region_1.json");
  TemporaryFolder folder;
  folder.write("region_1.json", writeScene(smallScene()));
  const QString before = QDir::currentPath();
  ASSERT_TRUE(QDir::setCurrent(QString::fromStdString(folder.path().string())));
  editor_ = &window_.lessons().showEditor(lesson, {});
  QDir::setCurrent(before);
  EXPECT_EQ(errorText(), "");
  EXPECT_EQ(editor_->lesson().steps[0].scene, lesson.steps[0].scene);
}

/// Also after a step that has a scene of its own.
TEST_F(LessonEditorTest, AStepThatIsAddedToAShippedLessonHasTheChangesAlone) {
  editor_ = &window_.lessons().showEditor(readNamedLesson("load_and_friction", readNamedScene), {});
  field<QListWidget>("editorSteps").setCurrentRow(1);
  editor_->takeShownScene();
  MainWindowTest::type("load.normal_force", "7 mN");
  editor_->addShownStep();
  EXPECT_EQ(errorText(), "");
  EXPECT_EQ(editor_->lesson().steps[1].set, std::vector<std::string>{"load.normal_force=0.007"});
}

/// Nobody knows yet whether a student could go on.
TEST_F(LessonEditorTest, WhileAnAnswerIsComputedTheLessonIsSavedAsADraft) {
  TemporaryFolder folder;
  edit(sampleLesson(), 1);
  setCell(1, 3, "2.9");
  ASSERT_TRUE(editor_->isComputing());
  const QString file = QString::fromStdString((folder / "mine.json").string());
  ASSERT_TRUE(editor_->saveTo(file));
  const auto& message = field<QLabel>("editorComplaint");
  EXPECT_TRUE(message.text().startsWith("Saved mine.json as a draft"))
      << message.text().toStdString();
  ASSERT_TRUE(waitFor([&] { return !editor_->isComputing(); }));
  ASSERT_TRUE(editor_->saveTo(file));
  EXPECT_EQ(message.text(), "Saved mine.json");
}

/// The window asks for the file of a new lesson with a name that says what it is.
TEST_F(LessonEditorTest, ANewLessonIsSavedUnderItsTitle) {
  Json json = sampleLesson();
  json["title"] = "What / is: friction?";
  edit(json, 0);
  QString proposed;
  QTimer closer;
  QObject::connect(&closer, &QTimer::timeout, [&] {
    auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
    if (!dialog || !dialog->isVisible()) return;
    proposed = QFileInfo(dialog->selectedFiles().value(0)).fileName();
    dialog->reject();
  });
  closer.start(10);
  EXPECT_FALSE(editor_->save());
  EXPECT_EQ(proposed, "What is friction.json");
}

/// Keys undo an edit of the lesson, also while a field of text has the focus.
TEST_F(LessonEditorTest, EveryEditCanBeUndone) {
  edit(sampleLesson(), 1);
  const std::string before = writeLesson(editor_->lesson());
  EXPECT_FALSE(field<QPushButton>("editorUndo").isEnabled());
  ASSERT_TRUE(waitFor([&] {  // its keys are those of the active window
    editor_->activateWindow();
    return editor_->isActiveWindow();
  }));
  editor_->removeStep();
  ASSERT_EQ(editor_->lesson().steps.size(), 1U);
  QTest::keyClick(&field<QListWidget>("editorSteps"), Qt::Key_Z, Qt::ControlModifier);
  ASSERT_EQ(writeLesson(editor_->lesson()), before);
  EXPECT_TRUE(editor_->canClose());  // nothing is changed
  EXPECT_EQ(field<QListWidget>("editorSteps").currentRow(), 1);
  EXPECT_EQ(field<QLineEdit>("editorStepTitle").text(), "First");

  type("editorStepTitle", "Another title");
  choose("editorHides", 1);
  const std::string after = writeLesson(editor_->lesson());
  auto& title = field<QLineEdit>("editorStepTitle");
  QTest::keyClick(&title, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_FALSE(editor_->lesson().steps[0].show.hidesCurve);
  EXPECT_EQ(title.text(), "Another title");
  QTest::keyClick(&title, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(writeLesson(editor_->lesson()), before);
  field<QPushButton>("editorRedo").click();
  field<QPushButton>("editorRedo").click();
  EXPECT_EQ(writeLesson(editor_->lesson()), after);
  EXPECT_FALSE(field<QPushButton>("editorRedo").isEnabled());
}

TEST_F(LessonEditorTest, ClosingAsksWhetherToSave) {
  TemporaryFolder folder;
  const std::string file = (folder.path() / "mine.json").string();
  edit(sampleLesson(), 1);
  ASSERT_TRUE(editor_->saveTo(QString::fromStdString(file)));
  const auto answerWith = [](QMessageBox::StandardButton wanted) {
    QTimer::singleShot(0, [wanted] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      ASSERT_NE(box, nullptr);
      EXPECT_EQ(box->defaultButton(), box->button(QMessageBox::Save));
      box->button(wanted)->click();
    });
  };
  type("editorStepTitle", "New title");
  answerWith(QMessageBox::Cancel);
  EXPECT_FALSE(editor_->canClose());
  answerWith(QMessageBox::Discard);
  EXPECT_TRUE(editor_->canClose());
  EXPECT_EQ(readLessonFile(file).steps[0].title.english, "First");
  answerWith(QMessageBox::Save);
  EXPECT_TRUE(editor_->canClose());
  EXPECT_EQ(readLessonFile(file).steps[0].title.english, "New title");
}

/// A style sheet creates the popup list of a combo box at once; it is no part of the order.
/// A scene that the lesson names may go while the lesson is edited.
TEST_F(LessonEditorTest, AHandoutOfALessonWithoutItsSceneIsRefused) {
  TemporaryFolder folder;
  Json json = sampleLesson();
  folder.write("line.json", json["steps"][0]["scene"].dump());
  json["steps"][0]["scene"] = "line.json";
  folder.write("lesson.json", json.dump());
  const std::filesystem::path file = folder / "lesson.json";
  editor_ =
      &window_.lessons().showEditor(readLessonFile(file), QString::fromStdString(file.string()));
  auto& handout = field<QPushButton>("editorHandout");
  ASSERT_TRUE(handout.isEnabled()) << errorText();
  std::filesystem::remove(folder / "line.json");
  EXPECT_NO_THROW(handout.click());
  EXPECT_TRUE(errorText().find("line.json") != std::string::npos) << errorText();
  EXPECT_FALSE(handout.isEnabled());
}

/// Later texts and curves may contain the answer.
TEST(StudentHandouts, WhatComesAfterAQuestionBeginsOnANewPage) {
  Json json = sampleLesson();
  json["steps"].push_back({{"text", "Now you know it."}});
  const QByteArray students = handoutHtml(lessonOf(json));
  EXPECT_EQ(students.count("class=\"stays page\"><h2>"), 2);
  EXPECT_FALSE(students.contains("After your answer"));  // an empty part
  const qsizetype first = students.indexOf("Turn the page");
  const qsizetype second = students.lastIndexOf("Turn the page");
  EXPECT_LT(students.indexOf("Twice as fast?"), first);
  EXPECT_LT(first, students.indexOf("Indentation?"));
  EXPECT_LT(students.indexOf("Indentation?"), second);
  EXPECT_LT(second, students.indexOf("Now you know it."));
  EXPECT_EQ(handoutPdf(lessonOf(json)).count("/Type /Page\n"), 3);
  HandoutOptions teacher;
  teacher.forTeacher = true;
  EXPECT_FALSE(handoutHtml(lessonOf(json), teacher).contains("Turn the page"));
}

/// An answer that changes nothing in the picture leaves nothing to hide from the next question.
TEST(StudentHandouts, NoPageBeginsWhereThereIsNothingToHide) {
  Json json = sampleLesson();
  json["steps"][0].erase("after");
  json["steps"][0].erase("reveal");
  json["steps"][0].erase("values");
  Json same = json;
  same["steps"][1].erase("set");
  EXPECT_FALSE(handoutHtml(lessonOf(same)).contains("Turn the page"));
  EXPECT_TRUE(handoutHtml(lessonOf(json)).contains("Turn the page")) << "another contact is shown";
}

TEST(StudentHandouts, TeachersSeeTheTolerance) {
  HandoutOptions teacher;
  teacher.forTeacher = true;
  EXPECT_TRUE(handoutHtml(lessonOf(sampleLesson()), teacher).contains("(right within ±20\u00A0%)"));
  const QByteArray point = handoutHtml(lessonOf(sampleWithPeak()), teacher);
  EXPECT_TRUE(point.contains("(right within a factor of 1.5, its place within a factor of 1.8)"));
  EXPECT_TRUE(point.contains("Mark the place in the chart."));
  EXPECT_TRUE(point.contains("____ at ____"));  // a free point has two numbers
}

TEST(StudentHandouts, LinesOfATextStayLines) {
  EXPECT_EQ(lessonHtml("One *and\nthe same*.\nTwo."), "<p>One <i>and<br>the same</i>.<br>Two.</p>");
}

}  // namespace
}  // namespace asperity
