// The lesson editor: computed answers, numbers that cannot be read, undo, scenes of steps; and what
// students' handouts leave out.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSet>
#include <QSpinBox>
#include <QStandardItemModel>
#include <QTabBar>
#include <QTableWidget>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <QWheelEvent>

#include "core/lesson/lesson_file.h"
#include "tests/core/lesson/lesson_samples.h"
#include "tests/core/temporary_folder.h"
#include "tests/ui/window/main_window_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "ui/panels/controls.h"
#include "ui/window/lesson/handout.h"
#include "ui/window/lesson/lesson_editor.h"
#include "ui/window/lesson/lesson_text.h"
#include "ui/window/lesson/lessons.h"
#include "ui/window/main/scene_library.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

class LessonEditorTest : public MainWindowTest {
 protected:
  /// Opens the editor at a step, from 1.
  void edit(const Json& lesson, int step) {
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

/// The sample with its second step asking for the largest value of the curve.
Json sampleWithPeak() {
  Json json = sampleLesson();
  json["steps"][1]["prediction"] = {
      {"kind", "point"}, {"question", "Where?"}, {"tolerance", 0.5}, {"place_tolerance", 0.8}};
  return json;
}

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

/// The form may be narrower than its sentences.
TEST_F(LessonEditorTest, LongTextsOfTheFormAreWrapped) {
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

TEST_F(LessonEditorTest, WhatIsNoNumberIsSaidAndChangesNothing) {
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

TEST_F(LessonEditorTest, ChoicesAreCheckedInTheWordsOfTheForm) {
  edit(sampleLesson(), 1);
  setCell(1, 2, "abc");
  EXPECT_EQ(errorText(), "Step 1: Choice 2, From: “abc” is not a number");
  EXPECT_EQ(prediction(0).choices[1].above, 1.5);
  setCell(1, 2, "1.5");
  setCell(2, 2, "2");
  EXPECT_TRUE(errorText().starts_with("Step 1: Choice 3: its range overlaps that of choice 2"))
      << errorText();
  setCell(2, 2, "");
  EXPECT_EQ(errorText(), "Step 1: Choice 3: needs a number in From or To, as the others have");
  for (const auto& [row, column] : {std::pair(0, 3), {1, 2}, {1, 3}}) setCell(row, column, "");
  EXPECT_TRUE(errorText().starts_with("Step 1: Choices: tick the right one")) << errorText();
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

/// Else the texts after the answer would stand beside the old picture.
TEST_F(LessonEditorTest, ThePictureFollowsTheChangesOfTheAnswer) {
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

TEST_F(LessonEditorTest, APictureThatStaysThoughTheAnswerHasChangesIsSaid) {
  Json json = sampleLesson();
  json["steps"][0].erase("after");
  edit(json, 1);
  EXPECT_TRUE(field<QLabel>("editorComputed").text().contains("The picture stays as it is"));
}

/// A tenth of a value is one pixel on an axis of several decades.
TEST_F(LessonEditorTest, APointHasAFactorAsItsUsualToleranceAndItsAnswerIsShown) {
  edit(sampleLesson(), 2);
  choose("editorKind", 3);
  EXPECT_EQ(prediction(1).tolerance, 0.2);  // that of the teacher
  editor_->addShownStep();
  choose("editorKind", 3);
  EXPECT_EQ(prediction(2).tolerance, 1);
  choose("editorKind", 2);
  EXPECT_DOUBLE_EQ(prediction(2).tolerance, LessonPrediction{}.tolerance);
  field<QListWidget>("editorSteps").setCurrentRow(3);
  editor_->removeStep();
  field<QListWidget>("editorSteps").setCurrentRow(2);
  auto& said = field<QLabel>("editorComputed");
  EXPECT_TRUE(waitFor([&] { return said.text().contains("The program finds"); }));
  EXPECT_TRUE(said.text().contains(" at "));
}

/// What is said above a field that cannot be read is not of the value before.
TEST_F(LessonEditorTest, AnAnswerToAnotherPlaceIsNotShown) {
  edit(sampleWithPeak(), 2);
  auto& said = field<QLabel>("editorComputed");
  ASSERT_TRUE(waitFor([&] { return said.text().contains("The program finds"); }));
  EXPECT_TRUE(said.text().contains("within a factor of 1.5")) << said.text().toStdString();
  type("editorX", "abc");
  EXPECT_TRUE(errorText().find("not a number") != std::string::npos) << errorText();
  EXPECT_FALSE(said.text().contains("The program finds")) << said.text().toStdString();
  EXPECT_FALSE(said.text().contains("1.5"));
  EXPECT_TRUE(said.isVisibleTo(editor_));  // what is below does not move
}

TEST_F(LessonEditorTest, AnotherStepBeginsAtItsTop) {
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

/// What was locked among free controls would stay locked in sight among hidden ones.
TEST_F(LessonEditorTest, NoControlStaysLockedWhereTheOthersAreHidden) {
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

/// Else everything below would move when the number comes.
TEST_F(LessonEditorTest, ThePlaceOfTheComputedAnswerIsKept) {
  edit(sampleLesson(), 2);
  auto& said = field<QLabel>("editorComputed");
  EXPECT_TRUE(said.isVisibleTo(editor_));
  EXPECT_FALSE(said.text().contains("The program finds"));
  const int height = said.sizeHint().height();
  ASSERT_TRUE(waitFor([&] { return said.text().contains("The program finds"); }));
  EXPECT_EQ(said.sizeHint().height(), height);
}

TEST_F(LessonEditorTest, ATranslatorSeesTheOriginalAndWhatIsMissing) {
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

TEST_F(LessonEditorTest, TheDeleteKeyEmptiesTheCellsOfTheChoices) {
  edit(sampleLesson(), 1);
  auto& table = field<QTableWidget>("editorChoices");
  ASSERT_TRUE(waitFor([&] {
    editor_->activateWindow();
    return editor_->isActiveWindow();
  }));
  table.setFocus();
  table.setCurrentCell(2, 0);
  QTest::keyClick(&table, Qt::Key_Delete);
  EXPECT_EQ(table.item(2, 0)->text(), "");
  EXPECT_EQ(prediction(0).choices.size(), 2U);
}

TEST_F(LessonEditorTest, ALongChoiceIsShownAsAWhole) {
  edit(sampleLesson(), 1);
  const auto& table = field<QTableWidget>("editorChoices");
  const auto showsAll = [&] {
    return table.verticalHeader()->length() <= table.viewport()->height();
  };
  ASSERT_TRUE(waitFor([&] { return table.isVisible() && showsAll(); }));
  const int height = table.rowHeight(0);
  setCell(0, 0,
          QStringLiteral("It grows by half or more: it doubles, as Amontons says. ").repeated(3));
  EXPECT_TRUE(waitFor([&] { return table.rowHeight(0) > height; })) << table.columnWidth(0);
  EXPECT_TRUE(waitFor(showsAll)) << table.verticalHeader()->length() << " in "
                                 << table.viewport()->height();
  EXPECT_EQ(table.rowHeight(1), height);
  setCell(0, 0, "short");
  EXPECT_TRUE(waitFor([&] { return table.rowHeight(0) == height; }));
}

TEST_F(LessonEditorTest, EmptyingManyCellsIsOneEdit) {
  edit(sampleLesson(), 1);
  const std::string before = writeLesson(editor_->lesson());
  auto& table = field<QTableWidget>("editorChoices");
  ASSERT_TRUE(waitFor([&] {
    editor_->activateWindow();
    return editor_->isActiveWindow();
  }));
  table.setFocus();
  table.setCurrentCell(1, 0);
  table.setRangeSelected({1, 0, 2, 3}, true);
  QTest::keyClick(&table, Qt::Key_Delete);
  EXPECT_EQ(prediction(0).choices.size(), 1U);
  EXPECT_EQ(table.item(1, 2)->text(), "");
  editor_->undo();
  EXPECT_EQ(writeLesson(editor_->lesson()), before);
  EXPECT_EQ(table.item(1, 0)->text(), "twice");
}

/// A choice keeps its translation where the one above it is removed.
TEST_F(LessonEditorTest, TranslationsStayWithTheirChoices) {
  Json json = sampleLesson();
  json["steps"][0]["prediction"]["choices"][2]["text"] = {{"en", "more"}, {"de", "mehr"}};
  edit(json, 1);
  setCell(1, 0, "");
  setCell(2, 0, "much more");
  const auto& choices = prediction(0).choices;
  ASSERT_EQ(choices.size(), 2U);
  EXPECT_EQ(choices[0].text, (LessonText{"same", ""}));
  EXPECT_EQ(choices[1].text, (LessonText{"much more", "mehr"}));
}

/// What is hidden stays hidden only where the teacher sees that it does.
TEST_F(LessonEditorTest, AllSettingsOfAPointCanBeSeenAndChanged) {
  edit(sampleWithPeak(), 2);
  auto& hides = field<QComboBox>("editorHides");
  EXPECT_TRUE(hides.isEnabled());
  EXPECT_FALSE(qobject_cast<QStandardItemModel*>(hides.model())->item(0)->isEnabled());
  choose("editorHides", 2);
  EXPECT_TRUE(editor_->lesson().steps[1].show.hidesCurveAfter);
  choose("editorHides", 1);
  EXPECT_FALSE(editor_->lesson().steps[1].show.hidesCurveAfter);
  auto& place = field<QLineEdit>("editorPlaceTolerance");
  EXPECT_TRUE(place.isVisibleTo(editor_));
  EXPECT_EQ(place.text(), "80");
  type("editorPlaceTolerance", "30");
  EXPECT_DOUBLE_EQ(prediction(1).xTolerance, 0.3);
  type("editorX", "0.1");
  EXPECT_FALSE(place.isVisibleTo(editor_));
  choose("editorKind", 2);
  EXPECT_TRUE(qobject_cast<QStandardItemModel*>(hides.model())->item(0)->isEnabled());
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

/// A step whose predecessor is removed keeps its scene, and its changes can still be seen.
TEST_F(LessonEditorTest, AStepShowsItsSceneAndKeepsItsChanges) {
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

TEST_F(LessonEditorTest, AStepTakesTheSceneThatIsShown) {
  edit(sampleLesson(), 1);
  const Scene next = editor_->lesson().steps[1].scene;
  field<QPushButton>("editorTakeScene").click();
  EXPECT_EQ(editor_->errorText(), QString());
  EXPECT_EQ(editor_->lesson().steps[0].scene.surface, session().scene().surface);
  EXPECT_NE(editor_->lesson().steps[0].scene.surface, next.surface);
  EXPECT_EQ(editor_->lesson().steps[1].scene, next);
  EXPECT_EQ(editor_->lesson().steps[1].set, std::vector<std::string>{"load.normal_force=20mN"});
}

TEST_F(LessonEditorTest, ACurveThatShowsTheAnswerIsHiddenOrTheFormSaysSo) {
  Json json = sampleLesson();
  json["steps"][1] = {{"text", "Look."}};
  edit(json, 2);
  const auto& view = editor_->lesson().steps[1].show;
  const auto says = [&] { return field<QLabel>("editorComputed").text().contains("in sight"); };
  choose("editorKind", 1);  // a choice that nothing computes
  EXPECT_FALSE(view.hidesCurve);
  choose("editorKind", 2);
  EXPECT_TRUE(view.hidesCurve);
  EXPECT_EQ(field<QComboBox>("editorHides").currentIndex(), 1);
  EXPECT_FALSE(says());
  choose("editorHides", 0);  // the teacher's own choice stays
  EXPECT_FALSE(view.hidesCurve);
  EXPECT_TRUE(says());
  auto& column = field<QComboBox>("editorColumn");
  choose("editorColumn", column.findData("indentation"));
  EXPECT_FALSE(view.hidesCurve);
  EXPECT_FALSE(says());
}

TEST_F(LessonEditorTest, TheTextsAfterAnAnswerNameTheirPlaceholders) {
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

/// Else the wheel that scrolls the form would change the lesson below the pointer.
TEST_F(LessonEditorTest, TheWheelChangesOnlyAFieldWithFocus) {
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

/// A page has several lists of changes, whose buttons have the same text.
TEST_F(LessonEditorTest, TheButtonsOfTheListsOfChangesSayWhichOneTheyBelongTo) {
  edit(sampleLesson(), 1);
  QSet<QString> lists;
  for (const char* name : {"editorSet", "editorAfter", "editorValueSet"})
    lists += field<QToolButton>(name).accessibleDescription();
  EXPECT_EQ(lists.size(), 3);
}

TEST_F(LessonEditorTest, TheTabKeyGoesThroughTheChangesInTheirOrder) {
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
  EXPECT_EQ(richText("One *and\nthe same*.\nTwo."), "<p>One <i>and<br>the same</i>.<br>Two.</p>");
}

}  // namespace
}  // namespace asperity
