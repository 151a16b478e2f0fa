// Lessons as a teacher writes them: steps from what is shown, trials, drafts that outlive a crash,
// and rows of the editor in plain words.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QTableWidget>
#include <QToolButton>

#include "tests/core/temporary_folder.h"
#include "tests/ui/window/lesson/lessons_fixture.h"
#include "ui/language/language.h"
#include "ui/window/lesson/handout.h"
#include "ui/window/lesson/lesson_editor.h"
#include "ui/window/main/scene_library.h"

namespace asperity {
namespace {

class LessonAuthoringTest : public LessonsTest {};

TEST_F(LessonAuthoringTest, ATeacherAddsAStepFromWhatIsShown) {
  TemporaryFolder folder;
  type("load.normal_force", "5 mN");
  LessonEditor& editor = lessons().showEditor({}, {});
  EXPECT_FALSE(editor.errorText().isEmpty());  // there is no step yet
  EXPECT_EQ(editor.focusWidget()->objectName(), "editorTitle");
  EXPECT_FALSE(editor.findChild<QPushButton*>("editorTry")->isEnabled());
  auto& title = *editor.findChild<QLineEdit*>("editorTitle");
  QTest::keyClicks(&title, "Mine");
  editor.addShownStep();
  auto& text = *editor.findChild<QPlainTextEdit*>("editorText");
  text.setPlainText("Look at this.");
  type("load.normal_force", "7 mN");
  editor.addShownStep();
  EXPECT_EQ(editor.errorText(), QString());
  ASSERT_EQ(editor.lesson().steps.size(), 2U);
  EXPECT_EQ(editor.lesson().steps[1].set, std::vector<std::string>{"load.normal_force=0.007"});
  const std::string file = (folder / "mine.json").string();
  ASSERT_TRUE(editor.saveTo(QString::fromStdString(file)));
  const Lesson read = readLessonFile(file);
  EXPECT_EQ(read.title.english, "Mine");
  EXPECT_EQ(read.steps[0].text.english, "Look at this.");
  EXPECT_EQ(read.steps[0].scene.load.normalForce, 0.005);
  EXPECT_EQ(read.steps[1].scene.load.normalForce, 0.007);
  EXPECT_TRUE(editor.canClose());
}

/// By mouse and keys alone, as a teacher who has never seen a lesson's file.
TEST_F(LessonAuthoringTest, ATeacherWritesALessonOfThreeStepsAndTriesIt) {
  TemporaryFolder folder;
  LessonEditor& editor = lessons().showEditor({}, {});
  const auto write = [&](const char* name, const char* text) {
    auto& field = *editor.findChild<QWidget*>(name);
    field.setFocus();
    QTest::keyClick(&field, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(&field, text);
  };
  const auto press = [&](const char* name) {
    QTest::mouseClick(editor.findChild<QPushButton*>(name), Qt::LeftButton);
  };
  const auto choose = [&](const char* name, int index) {
    auto& box = *editor.findChild<QComboBox*>(name);
    box.setFocus();
    while (box.currentIndex() < index) QTest::keyClick(&box, Qt::Key_Down);
  };
  const auto change = [&](const char* list, const char* key, const char* value) {
    emit editor.findChild<QToolButton*>(list)->menu()->aboutToShow();
    editor.findChild<QAction*>(QStringLiteral("%1With:%2").arg(list, key))->trigger();
    QTest::keyClicks(editor.findChild<QWidget*>(QStringLiteral("%1:%2").arg(list, key)), value);
  };
  write("editorTitle", "Mine");
  write("editorGoal", "You see three things.");

  press("editorAdd");
  EXPECT_EQ(editor.focusWidget(), editor.findChild<QWidget*>("editorText"));
  QTest::keyClicks(editor.focusWidget(), "Look at the contact.");
  choose("editorKind", 1);
  write("editorQuestion", "Which side is touched?");
  auto& table = *editor.findChild<QTableWidget*>("editorChoices");
  const char* sides[] = {"the front", "the back"};
  for (int row = 0; row < 2; ++row) {
    table.setFocus();
    table.setCurrentCell(row, 0);
    QTest::keyClicks(&table, sides[row]);
    QTest::keyClick(table.findChildren<QLineEdit*>().last(), Qt::Key_Return);
  }
  table.setFocus();
  table.setCurrentCell(0, 1);
  QTest::keyClick(&table, Qt::Key_Space);
  EXPECT_EQ(editor.errorText(), QString());

  type("load.normal_force", "5 mN");
  press("editorAdd");
  QTest::keyClicks(editor.focusWidget(), "Twice the load.");
  choose("editorKind", 2);
  choose("editorValue", 1);
  change("editorValueSet", "load.normal_force", "10 mN");
  write("editorQuestion", "How many times as large is friction?");
  EXPECT_EQ(editor.errorText(), QString());

  press("editorAdd");
  QTest::keyClicks(editor.focusWidget(), "The whole curve.");
  choose("editorKind", 3);
  write("editorQuestion", "How large is friction at 0.1 m/s?");
  write("editorX", "100 mm/s");
  EXPECT_EQ(editor.errorText(), QString());

  const std::string file = (folder / "mine.json").string();
  ASSERT_TRUE(editor.saveTo(QString::fromStdString(file)));
  const Lesson read = readLessonFile(file);
  ASSERT_EQ(read.steps.size(), 3U);
  EXPECT_EQ(predictionCount(read), 3);
  EXPECT_TRUE(read.steps[0].prediction->choices[0].isRight);
  EXPECT_EQ(read.steps[1].prediction->answer->set,
            std::vector<std::string>{"load.normal_force=0.01"});
  EXPECT_EQ(read.steps[1].scene.load.normalForce, 0.005);
  EXPECT_EQ(read.steps[2].scene.load.normalForce, 0.005);
  EXPECT_EQ(read.steps[2].prediction->x, 0.1);

  editor.findChild<QListWidget*>("editorSteps")->setCurrentRow(1);
  press("editorTry");
  EXPECT_FALSE(editor.isVisible());
  for (int step = 0; step < 3; ++step) {
    EXPECT_EQ(player().step(), step);
    click("lessonShow");
    ASSERT_TRUE(waitForAnswer());
    click("lessonNext");
  }
  EXPECT_TRUE(editor.isVisible());
}

TEST_F(LessonAuthoringTest, TheEditorStepsAsideForAStepThatIsTried) {
  LessonEditor& editor = lessons().showEditor(lessonOf(sampleLesson()), {});
  emit editor.trialRequested(lessonOf(sampleLesson()), 1);
  EXPECT_EQ(player().step(), 1);
  EXPECT_FALSE(editor.isVisible());
  lessons().end();
  EXPECT_TRUE(editor.isVisible());
}

TEST_F(LessonAuthoringTest, ATrialCountsOnlyWhatWasTried) {
  LessonEditor& editor = lessons().showEditor(lessonOf(sampleLesson()), {});
  emit editor.trialRequested(lessonOf(sampleLesson()), 1);
  click("lessonShow");
  ASSERT_TRUE(waitForAnswer());
  EXPECT_TRUE(said("lessonScore").contains("You were right in 0 of 1 predictions"))
      << said("lessonReveal").toStdString();
}

TEST_F(LessonAuthoringTest, AnUnsavedLessonInTheEditorOutlivesACrash) {
  LessonEditor& editor = lessons().showEditor(lessonOf(sampleLesson()), {});
  auto& title = *editor.findChild<QLineEdit*>("editorTitle");
  title.selectAll();
  QTest::keyClicks(&title, "Mine");
  EXPECT_FALSE(keptDraft());
  ASSERT_TRUE(waitFor([] { return keptDraft().has_value(); }));
  {
    MainWindow next(smallScene());
    next.show();
    answer(QMessageBox::Yes);
    LessonEditor& again = next.lessons().openEditor({}, {});
    EXPECT_EQ(asked_, 1);
    EXPECT_EQ(again.lesson().title.english, "Mine");
    again.undo();
    EXPECT_EQ(again.lesson().title.english, "Sample");
  }
  MainWindow next(smallScene());
  next.show();
  answer(QMessageBox::Discard);
  EXPECT_TRUE(next.lessons().openEditor({}, {}).lesson().title.empty());
  EXPECT_EQ(asked_, 1);
  EXPECT_FALSE(keptDraft());
}

TEST_F(LessonAuthoringTest, ALessonThatIsSavedOrDiscardedIsNoDraft) {
  TemporaryFolder folder;
  LessonEditor& editor = lessons().showEditor(lessonOf(sampleLesson()), {});
  auto& title = *editor.findChild<QLineEdit*>("editorTitle");
  const auto edit = [&] {
    QTest::keyClicks(&title, "x");
    return waitFor([] { return keptDraft().has_value(); });
  };
  ASSERT_TRUE(edit());
  ASSERT_TRUE(editor.saveTo(QString::fromStdString((folder / "mine.json").string())));
  EXPECT_FALSE(keptDraft());
  ASSERT_TRUE(edit());
  answer(QMessageBox::Discard);
  EXPECT_TRUE(editor.canClose());
  EXPECT_FALSE(keptDraft());
  ASSERT_TRUE(edit());
  for (int edits = 0; edits < 2; ++edits) editor.undo();
  ASSERT_TRUE(editor.canClose());
  EXPECT_FALSE(keptDraft());
}

/// What was typed is not lost, and the question does not come when the window is gone.
TEST_F(LessonAuthoringTest, TheWindowAsksAboutTheLessonInTheEditorBeforeItCloses) {
  LessonEditor& editor = lessons().showEditor(lessonOf(sampleLesson()), {});
  QTest::keyClicks(editor.findChild<QLineEdit*>("editorTitle"), "Mine");
  answer(QMessageBox::Cancel);
  EXPECT_FALSE(window_.close());
  EXPECT_EQ(asked_, 1);
  EXPECT_TRUE(window_.isVisible());
  ASSERT_EQ(lessons().editor(), &editor);
  EXPECT_TRUE(editor.isVisible());
  answer(QMessageBox::Discard);
  EXPECT_TRUE(window_.close());
  EXPECT_EQ(asked_, 1);
  EXPECT_EQ(lessons().editor(), nullptr);
}

/// The editor is made anew in another language, with the lesson, its edits and what it shows.
TEST_F(LessonAuthoringTest, AnotherLanguageDoesNotLoseTheLessonInTheEditor) {
  LessonEditor& editor = lessons().showEditor(lessonOf(sampleLesson()), {});
  auto& title = *editor.findChild<QLineEdit*>("editorTitle");
  title.selectAll();
  QTest::keyClicks(&title, "Mine");
  editor.findChild<QListWidget*>("editorSteps")->setCurrentRow(2);
  action("language:de").trigger();
  EXPECT_EQ(presentLanguage(), "de");
  LessonEditor* again = lessons().editor();
  ASSERT_NE(again, nullptr);
  EXPECT_TRUE(again->isVisible());
  EXPECT_EQ(again->lesson().title.english, "Mine");
  EXPECT_EQ(again->findChild<QListWidget*>("editorSteps")->currentRow(), 2);
  EXPECT_TRUE(again->findChild<QPushButton*>("editorClose")->text().contains("chließen"));
  for (int letter = 0; letter < 4; ++letter) again->undo();
  ASSERT_EQ(again->lesson().title.english, "Sample");
  EXPECT_TRUE(again->canClose());  // it knows what was saved
  action("language:en").trigger();
  delete lessons().editor();
}

/// The scene behind the gallery is not what the teacher sees.
TEST_F(LessonAuthoringTest, NoStepIsTakenFromTheGallery) {
  window_.openGallery();
  LessonEditor& editor = lessons().showEditor({}, {});
  editor.addShownStep();
  EXPECT_TRUE(editor.lesson().steps.empty());
  EXPECT_TRUE(editor.findChild<QLabel*>("editorComplaint")->text().contains("gallery"));
}

TEST_F(LessonAuthoringTest, TheWindowAsksAboutAnEditorThatATrialHides) {
  LessonEditor& editor = lessons().showEditor(lessonOf(sampleLesson()), {});
  QTest::keyClicks(editor.findChild<QLineEdit*>("editorTitle"), "Mine");
  emit editor.trialRequested(editor.lesson(), 0);
  ASSERT_FALSE(editor.isVisible());
  answer(QMessageBox::Discard);
  EXPECT_TRUE(window_.close());
  EXPECT_EQ(asked_, 1);
  EXPECT_EQ(lessons().editor(), nullptr);
}

/// Neither the end of a trial nor the menu asks or begins another lesson.
TEST_F(LessonAuthoringTest, TheOpenEditorComesBackWithItsLesson) {
  LessonEditor& editor = lessons().showEditor(lessonOf(sampleLesson()), {});
  auto& title = *editor.findChild<QLineEdit*>("editorTitle");
  title.selectAll();
  QTest::keyClicks(&title, "Mine");
  emit editor.trialRequested(editor.lesson(), 0);
  ASSERT_FALSE(editor.isVisible());
  QTest::mouseClick(&control<QAbstractButton>("lessonEnd"), Qt::LeftButton);
  EXPECT_FALSE(player().isRunning());
  EXPECT_TRUE(editor.isVisible());
  EXPECT_TRUE(waitFor([&] { return editor.isActiveWindow(); }));
  action("lessonEditor").trigger();  // it may lie behind the main window
  ASSERT_EQ(lessons().editor(), &editor);
  emit editor.trialRequested(editor.lesson(), 0);
  action("lessonEditor").trigger();
  ASSERT_EQ(lessons().editor(), &editor);
  EXPECT_TRUE(editor.isVisible());
  EXPECT_EQ(title.text(), "Mine");
  delete &editor;  // it would ask about its changes
}

/// Reordering keeps the scene that each step shows.
TEST_F(LessonAuthoringTest, StepsKeepTheirScenesWhereTheyAreMovedAndRemoved) {
  const Lesson lesson = lessonOf(sampleLesson());
  LessonEditor& editor = lessons().showEditor(lesson, {});
  auto& steps = *editor.findChild<QListWidget*>("editorSteps");
  steps.setCurrentRow(2);
  editor.moveStep(-1);
  EXPECT_EQ(editor.errorText(), QString());
  EXPECT_EQ(editor.lesson().steps[0].scene.load.normalForce, 0.02);
  EXPECT_EQ(editor.lesson().steps[1].scene.load.normalForce,
            lesson.steps[0].scene.load.normalForce);
  editor.moveStep(1);
  steps.setCurrentRow(1);
  editor.removeStep();
  ASSERT_EQ(editor.lesson().steps.size(), 1U);
  EXPECT_EQ(editor.lesson().steps[0].scene.load.normalForce, 0.02);
  EXPECT_EQ(editor.lesson().steps[0].scene.sliding.velocity, 2e-4);
}

TEST_F(LessonAuthoringTest, TheEditorSaysWhatIsWrongAndWhere) {
  LessonEditor& editor = lessons().showEditor(lessonOf(sampleLesson()), {});
  editor.findChild<QListWidget*>("editorSteps")->setCurrentRow(2);
  auto& force = *editor.findChild<QLineEdit*>("editorSet:load.normal_force");
  EXPECT_EQ(force.text(), "20 mN");
  force.selectAll();
  QTest::keyClicks(&force, "much");
  EXPECT_TRUE(editor.errorText().startsWith("Step 2, changed, “normal force”: "))
      << editor.errorText().toStdString();
  EXPECT_FALSE(editor.findChild<QPushButton*>("editorTry")->isEnabled());
  EXPECT_FALSE(editor.findChild<QPushButton*>("editorHandout")->isEnabled());
  force.selectAll();
  QTest::keyClicks(&force, "30");  // in the unit that was shown
  EXPECT_EQ(editor.errorText(), QString());
  EXPECT_EQ(editor.lesson().steps[1].scene.load.normalForce, 0.03);
  auto& question = *editor.findChild<QPlainTextEdit*>("editorQuestion");
  question.selectAll();
  QTest::keyClick(&question, Qt::Key_Delete);
  EXPECT_EQ(editor.errorText(), "Step 2: the question needs a text");
  QTest::keyClicks(&question, "How deep?");
  QTest::mouseClick(editor.findChild<QPushButton*>("editorTry"), Qt::LeftButton);
  EXPECT_EQ(player().step(), 1);
  EXPECT_EQ(session().scene().load.normalForce, 0.03);
}

/// A parameter is chosen from a menu in plain words and has its present value, which is edited; a
/// word is chosen from a list. A change is removed by its button.
TEST_F(LessonAuthoringTest, TheEditorChangesParametersInPlainWords) {
  LessonEditor& editor = lessons().showEditor(lessonOf(sampleLesson()), {});
  editor.findChild<QListWidget*>("editorSteps")->setCurrentRow(2);
  const auto add = [&](const char* list, const char* key) {
    emit editor.findChild<QToolButton*>(list)->menu()->aboutToShow();
    editor.findChild<QAction*>(QStringLiteral("%1With:%2").arg(list, key))->trigger();
  };
  add("editorSet", "sliding.velocity");
  auto& velocity = *editor.findChild<QLineEdit*>("editorSet:sliding.velocity");
  EXPECT_TRUE(velocity.toolTip().contains("Allowed"));
  velocity.selectAll();
  QTest::keyClicks(&velocity, "3 mm/s");
  EXPECT_EQ(editor.lesson().steps[1].scene.sliding.velocity, 0.003);
  add("editorAfter", "accuracy.scheme");
  auto& scheme = *editor.findChild<QComboBox*>("editorAfter:accuracy.scheme");
  EXPECT_EQ(scheme.currentText(), "cubic");
  scheme.setCurrentIndex(scheme.findText("nodal"));
  emit scheme.activated(scheme.currentIndex());
  EXPECT_EQ(editor.lesson().steps[1].after, std::vector<std::string>{"accuracy.scheme=nodal"});
  EXPECT_EQ(editor.errorText(), QString());
  editor.findChild<QToolButton*>("editorSetWithout:load.normal_force")->click();
  EXPECT_EQ(editor.lesson().steps[1].set, std::vector<std::string>{"sliding.velocity=0.003"});
  EXPECT_EQ(editor.findChild<QLineEdit*>("editorSet:sliding.velocity")->text(), "3 mm/s");
}

/// Nothing of the editor is a word of the file: no key, no column, no member.
TEST_F(LessonAuthoringTest, TheEditorSpeaksNoJson) {
  const QRegularExpression code(QStringLiteral(R"([a-z]_[a-z]|[a-z]\.[a-z]|=)"));
  for (const ShippedFile& shipped : shippedLessons()) {
    LessonEditor& editor =
        lessons().showEditor(readNamedLesson(std::string(shipped.name), readNamedScene), {});
    auto& steps = *editor.findChild<QListWidget*>("editorSteps");
    for (int row = 1; row < steps.count(); ++row) {
      steps.setCurrentRow(row);
      QStringList said;
      for (const QLabel* label : editor.findChildren<QLabel*>()) said += label->text();
      for (const QComboBox* box : editor.findChildren<QComboBox*>())
        for (int i = 0; i < box->count(); ++i) said += box->itemText(i);
      for (const QLineEdit* line : editor.findChildren<QLineEdit*>())
        if (line->objectName().contains(':')) said += line->text();
      for (const QString& text : said)
        EXPECT_FALSE(code.match(text).hasMatch()) << shipped.name << row << text.toStdString();
    }
    EXPECT_TRUE(editor.canClose());
  }
}

TEST_F(LessonAuthoringTest, TheEditorSaysWhatTheStepShowsAndLocks) {
  LessonEditor& editor = lessons().showEditor(lessonOf(sampleLesson()), {});
  editor.findChild<QListWidget*>("editorSteps")->setCurrentRow(2);
  const auto choose = [&](const char* name, int index) {
    auto& box = *editor.findChild<QComboBox*>(name);
    box.setCurrentIndex(index);
    emit box.activated(index);
  };
  choose("editorHides", 2);
  EXPECT_TRUE(editor.lesson().steps[1].show.hidesCurveAfter);
  choose("editorHides", 0);
  EXPECT_FALSE(editor.lesson().steps[1].show.hidesCurve);
  choose("editorOthers", 1);
  EXPECT_EQ(editor.lesson().steps[1].controls.others, ControlState::Locked);
  auto& tolerance = *editor.findChild<QLineEdit*>("editorTolerance");
  EXPECT_EQ(tolerance.text(), "20");  // per cent
  tolerance.selectAll();
  QTest::keyClicks(&tolerance, "15 %");
  EXPECT_DOUBLE_EQ(editor.lesson().steps[1].prediction->tolerance, 0.15);
  EXPECT_EQ(editor.errorText(), QString());
}

/// What the editor does not show (values, hidden ranges, other curves) is kept.
TEST_F(LessonAuthoringTest, TheEditorLosesNothingOfALesson) {
  for (const ShippedFile& shipped : shippedLessons()) {
    const Lesson lesson = readNamedLesson(std::string(shipped.name), readNamedScene);
    LessonEditor& editor = lessons().showEditor(lesson, {});
    auto& steps = *editor.findChild<QListWidget*>("editorSteps");
    for (int row = 0; row < steps.count(); ++row) steps.setCurrentRow(row);
    EXPECT_EQ(writeLesson(editor.lesson()), writeLesson(lesson)) << shipped.name;
    EXPECT_TRUE(editor.canClose());
  }
}

/// An exponent is chosen, with its key and two values of it in any unit; what is refused is said.
TEST_F(LessonAuthoringTest, TheEditorWritesExponents) {
  const Lesson lesson = readNamedLesson("load_and_friction", readNamedScene);
  const auto asks = std::ranges::find_if(lesson.steps, [](const LessonStep& step) {
    return step.prediction && step.prediction->answer &&
           step.prediction->answer->kind == LessonValue::Kind::Exponent;
  });
  ASSERT_NE(asks, lesson.steps.end());
  const auto place = static_cast<std::size_t>(asks - lesson.steps.begin());
  LessonEditor& editor = lessons().showEditor(lesson, {});
  editor.findChild<QListWidget*>("editorSteps")->setCurrentRow(static_cast<int>(place) + 1);
  const auto value = [&] { return *editor.lesson().steps[place].prediction->answer; };
  auto& kind = *editor.findChild<QComboBox*>("editorValue");
  auto& key = *editor.findChild<QComboBox*>("editorExponentKey");
  auto& from = *editor.findChild<QLineEdit*>("editorExponentFrom");
  EXPECT_EQ(kind.currentIndex(), 3);
  EXPECT_EQ(key.currentData().toString(), "load.normal_force");
  EXPECT_EQ(from.text(), "3.4 mN");
  EXPECT_TRUE(from.isVisibleTo(&editor));

  from.selectAll();
  QTest::keyClicks(&from, "5 mN");
  EXPECT_EQ(value().from, 0.005);
  EXPECT_EQ(value().to, asks->prediction->answer->to);
  EXPECT_EQ(editor.errorText(), QString());
  from.selectAll();
  QTest::keyClicks(&from, "5 kg");
  EXPECT_TRUE(editor.errorText().contains("from and to")) << editor.errorText().toStdString();

  const auto choose = [](QComboBox& box, int index) {
    box.setCurrentIndex(index);
    emit box.activated(index);
  };
  choose(key, key.findData("sliding.velocity"));
  EXPECT_EQ(editor.errorText(), QString());  // two values of it are proposed
  EXPECT_NEAR(value().to / value().from, 10, 1e-9);
  from.selectAll();
  QTest::keyClicks(&from, "1e-3");
  EXPECT_EQ(value().key, "sliding.velocity");
  EXPECT_EQ(value().from, 1e-3);
  EXPECT_EQ(editor.errorText(), QString());
  choose(kind, 0);
  EXPECT_EQ(value().kind, LessonValue::Kind::State);
  EXPECT_TRUE(value().key.empty());
  EXPECT_FALSE(from.isVisibleTo(&editor));
  EXPECT_EQ(editor.errorText(), QString());
  delete &editor;
}

/// An edit elsewhere in a step leaves what an answer has beyond the rows.
TEST_F(LessonAuthoringTest, AnEditKeepsWhatTheRowsDoNotShow) {
  for (const ShippedFile& shipped : shippedLessons()) {
    Lesson lesson = readNamedLesson(std::string(shipped.name), readNamedScene);
    LessonEditor& editor = lessons().showEditor(lesson, {});
    auto& steps = *editor.findChild<QListWidget*>("editorSteps");
    auto& title = *editor.findChild<QLineEdit*>("editorStepTitle");
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
      steps.setCurrentRow(static_cast<int>(i) + 1);
      title.setText("changed");
      emit title.textEdited("changed");
      lesson.steps[i].title.english = "changed";
    }
    EXPECT_EQ(writeLesson(editor.lesson()), writeLesson(lesson)) << shipped.name;
    delete &editor;  // another one would ask about what is not saved
  }
}

}  // namespace
}  // namespace asperity
