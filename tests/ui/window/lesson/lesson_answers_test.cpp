// What a student has entered stays: through crashes, other scenes, languages and presentations,
// until it is saved or discarded.
#include <gtest/gtest.h>

#include <QDockWidget>
#include <QLineEdit>
#include <QRadioButton>
#include <QRegularExpression>
#include <QToolButton>

#include "tests/core/temporary_folder.h"
#include "tests/ui/window/lesson/lessons_fixture.h"
#include "ui/language/language.h"
#include "ui/window/lesson/prediction_point.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

class LessonAnswersTest : public LessonsTest {};

TEST_F(LessonAnswersTest, TheUsersOwnSceneComesBackWithItsChanges) {
  type("load.normal_force", "5 mN");
  const Scene own = session().scene();
  ASSERT_TRUE(window_.document().isChanged());
  lessons().start(lessonOf(sampleLesson()));
  EXPECT_TRUE(window_.document().isTrial());
  EXPECT_NE(session().scene(), own);
  QTest::mouseClick(&control<QAbstractButton>("lessonEnd"), Qt::LeftButton);
  EXPECT_FALSE(player().isRunning());
  EXPECT_EQ(session().scene(), own);
  EXPECT_TRUE(window_.document().isChanged());
  EXPECT_FALSE(control<QDockWidget>("lessonDock").isVisible());
  EXPECT_TRUE(control<QWidget>("row:surface.hurst").isEnabled());
}

TEST_F(LessonAnswersTest, AnotherSceneEndsTheLessonAndUndoBringsTheOwnOneBack) {
  type("load.normal_force", "5 mN");
  const Scene own = session().scene();
  lessons().start(lessonOf(sampleLesson()));
  action("scene:figure_2").trigger();
  EXPECT_FALSE(player().isRunning());
  EXPECT_NE(session().scene(), own);
  action("undo").trigger();
  EXPECT_EQ(session().scene(), own);
}

/// The window of the next session stands for the program that starts after a crash.
TEST_F(LessonAnswersTest, AnswersOutliveACrash) {
  TemporaryFolder folder;
  const std::filesystem::path path = folder / "mine.json";
  folder.write("mine.json", writeLesson(lessonOf(sampleLesson())));
  const QString file = QString::fromStdString(path.string());
  const Lesson lesson = readLessonFile(path);
  ASSERT_TRUE(lessons().open(file));
  EXPECT_FALSE(keptAnswers(lesson));
  control<QRadioButton>("lessonChoice:0").click();
  click("lessonNext");
  ASSERT_TRUE(waitForAnswer());
  ASSERT_TRUE(keptAnswers(lesson));
  for (const auto& [button, isKept] :
       {std::pair(QMessageBox::Yes, true), {QMessageBox::Discard, false}}) {
    MainWindow next(smallScene());
    next.show();
    answer(button);
    ASSERT_TRUE(next.lessons().open(file));
    EXPECT_EQ(asked_, 1);
    EXPECT_EQ(next.lessons().player().isRevealed(), isKept);
    EXPECT_EQ(keptAnswers(lesson).has_value(), isKept);
    next.lessons().end();
  }
}

/// Also in the next session, with the answers in their file; who begins anew is not asked again.
TEST_F(LessonAnswersTest, ALessonGoesOnWhereItWasLeft) {
  TemporaryFolder folder;
  folder.write("mine.json", writeLesson(lessonOf(sampleLesson())));
  const QString file = QString::fromStdString((folder / "mine.json").string());
  const QString results = QString::fromStdString((folder / "ada.json").string());
  ASSERT_TRUE(lessons().open(file));
  control<QRadioButton>("lessonChoice:0").click();
  click("lessonNext");
  ASSERT_TRUE(waitForAnswer());
  ASSERT_TRUE(lessons().keepResults(results));
  click("lessonNext");
  ASSERT_EQ(player().step(), 1);
  lessons().end();
  for (const auto& [button, goesOn, asked] : {std::tuple(QMessageBox::Yes, true, 1),
                                              {QMessageBox::Discard, false, 1},
                                              {QMessageBox::Discard, false, 0}}) {
    int questions = 0;
    QTimer clicker;
    QObject::connect(&clicker, &QTimer::timeout, [&, button] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (!box || !box->isVisible()) return;
      ++questions;
      QTest::mouseClick(box->button(button), Qt::LeftButton);
    });
    clicker.start(10);
    ASSERT_TRUE(lessons().open(file));
    clicker.stop();
    EXPECT_EQ(questions, asked);
    EXPECT_EQ(player().step(), goesOn ? 1 : 0);
    EXPECT_EQ(player().results().results.size(), goesOn ? 1U : 0U);
    window_.activateWindow();  // as the desktop does when the question closes
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
    EXPECT_EQ(window_.focusWidget()->objectName(), goesOn ? "lessonNumber" : "lessonChoice:0");
    lessons().end();
  }
}

/// In both questions, that after a crash and that about a file, the key loses nothing.
TEST_F(LessonAnswersTest, EscapeGoesOnWithAnswersOfAnEarlierSession) {
  TemporaryFolder folder;
  folder.write("mine.json", writeLesson(lessonOf(sampleLesson())));
  const QString file = QString::fromStdString((folder / "mine.json").string());
  ASSERT_TRUE(lessons().open(file));
  control<QRadioButton>("lessonChoice:0").click();
  click("lessonNext");
  ASSERT_TRUE(waitForAnswer());
  for (const char* name : {"answersQuestion", "savedAnswersQuestion"}) {
    MainWindow next(smallScene());
    next.show();
    QString asked, text;
    QTimer presser;
    QObject::connect(&presser, &QTimer::timeout, [&] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (!box || !box->isVisible()) return;
      asked = box->objectName();
      text = box->text();
      QTest::keyClick(box, Qt::Key_Escape);
    });
    presser.start(10);
    ASSERT_TRUE(next.lessons().open(file));
    presser.stop();
    EXPECT_EQ(asked, name);
    // The date is not one of a file: "2026-11-29".
    EXPECT_FALSE(text.contains(QRegularExpression("\\d{4}-\\d\\d"))) << text.toStdString();
    EXPECT_EQ(next.lessons().player().results().results.size(), 1U);
    ASSERT_TRUE(next.lessons().keepResults(QString::fromStdString((folder / "ada.json").string())));
    next.lessons().end();
  }
}

TEST_F(LessonAnswersTest, AnswersThatAreSavedOrDiscardedAreNotKept) {
  TemporaryFolder folder;
  const Lesson lesson = lessonOf(sampleLesson());
  const auto answerFirst = [&] {
    lessons().start(lesson);
    control<QRadioButton>("lessonChoice:0").click();
    click("lessonNext");
    return waitForAnswer() && keptAnswers(lesson);
  };
  ASSERT_TRUE(answerFirst());
  ASSERT_TRUE(lessons().keepResults(QString::fromStdString((folder / "ada.json").string())));
  EXPECT_FALSE(keptAnswers(lesson));
  lessons().end();
  ASSERT_TRUE(answerFirst());
  answer(QMessageBox::Discard);
  QTest::mouseClick(&control<QAbstractButton>("lessonEnd"), Qt::LeftButton);
  EXPECT_FALSE(keptAnswers(lesson));
}

TEST_F(LessonAnswersTest, ResultsAreKeptInAFileOfTheStudentsChoice) {
  TemporaryFolder folder;
  const Lesson lesson = lessonOf(sampleLesson());
  const std::filesystem::path file = folder / "mine.json";
  lessons().start(lesson);
  EXPECT_EQ(control<QToolButton>("lessonKeep").text().simplified(),
            "Save results…");  // as the guide has it
  ASSERT_TRUE(lessons().keepResults(QString::fromStdString(file.string())));
  control<QRadioButton>("lessonChoice:0").click();
  click("lessonNext");
  ASSERT_TRUE(waitForAnswer());
  EXPECT_EQ(readResults(file, lesson).results.size(), 1U);
  EXPECT_EQ(readResults(file, lesson).right(), 0);
  // Another day: what was answered is seen again.
  lessons().start(lesson);
  EXPECT_FALSE(player().isRevealed());
  ASSERT_TRUE(lessons().keepResults(QString::fromStdString(file.string())));
  EXPECT_TRUE(player().isRevealed());
  // A file of somebody else's stays as it is.
  folder.write("thesis.txt", "my thesis");
  EXPECT_FALSE(lessons().keepResults(QString::fromStdString((folder / "thesis.txt").string())));
  EXPECT_TRUE(window_.messages().isVisible());
  EXPECT_EQ(TemporaryFolder::read(folder / "thesis.txt"), "my thesis");
}

/// A choice that is made and not checked yet, a number and a point.
TEST_F(LessonAnswersTest, AnotherLanguageKeepsWhatTheStudentHasEntered) {
  const auto inGerman = [this](const QString& check) {
    useLanguage("de");
    EXPECT_TRUE(waitFor([&] { return button("lessonNext").text() == check; }));
    EXPECT_TRUE(button("lessonNext").isEnabled());
  };
  lessons().start(lessonOf(sampleLesson()));
  control<QRadioButton>("lessonChoice:1").click();
  inGerman("Prüfen");
  EXPECT_TRUE(control<QRadioButton>("lessonChoice:1").isChecked());
  useLanguage("en");
  lessons().start(lessonOf(sampleLesson()), 1);
  EXPECT_EQ(control<QLineEdit>("lessonNumber").text(), "");  // nothing of the other step
  // Its mark is a decimal sign in English, and one of thousands in German.
  QTest::keyClicks(&control<QLineEdit>("lessonNumber"), "1.250 um");
  inGerman("Prüfen");
  EXPECT_EQ(control<QLineEdit>("lessonNumber").text(), "1,250 um");
  click("lessonNext");
  ASSERT_TRUE(waitForAnswer());
  EXPECT_DOUBLE_EQ(player().results().find(1)->given.number, 1.25e-6);
  useLanguage("en");
  Json json = sampleLesson();
  json["steps"][1]["prediction"] = {
      {"kind", "point"}, {"question", {{"en", "Where?"}, {"de", "Wo?"}}}, {"tolerance", 0.5}};
  lessons().start(lessonOf(json), 1);
  PredictionPoint& point = player().point();
  ASSERT_TRUE(waitFor([&] { return window_.plotView().frame().has_value(); }));
  QTest::keyClick(&point, Qt::Key_Up);
  ASSERT_TRUE(point.point());
  inGerman("Prüfen");
  EXPECT_TRUE(point.point());
  EXPECT_TRUE(point.accessibleName().startsWith("Wo?")) << point.accessibleName().toStdString();
  EXPECT_FALSE(point.toolTip().contains("Drag")) << point.toolTip().toStdString();
  useLanguage("en");
}

/// The choices are made anew in another language; the focus would go to the button "Back".
TEST_F(LessonAnswersTest, AnotherLanguageKeepsTheFocus) {
  window_.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  lessons().start(lessonOf(sampleLesson()));
  control<QRadioButton>("lessonChoice:1").setFocus();
  useLanguage("de");
  EXPECT_TRUE(waitFor([&] { return said("lessonProgress") == "1 von 2"; }));
  EXPECT_TRUE(control<QRadioButton>("lessonChoice:1").hasFocus());
  useLanguage("en");
}

TEST_F(LessonAnswersTest, AnswersAreSavedBesideOneThatIsNotCheckedYet) {
  TemporaryFolder folder;
  lessons().start(lessonOf(sampleLesson()));
  control<QRadioButton>("lessonChoice:1").click();
  ASSERT_TRUE(lessons().keepResults(QString::fromStdString((folder / "ada.json").string())));
  EXPECT_TRUE(control<QRadioButton>("lessonChoice:1").isChecked());
  EXPECT_TRUE(button("lessonNext").isEnabled());
}

/// The same lesson may run in another window of the program, or on another day.
TEST_F(LessonAnswersTest, AnswersThatAFileGotElsewhereStay) {
  TemporaryFolder folder;
  const Lesson lesson = lessonOf(sampleLesson());
  const std::filesystem::path file = folder / "ada.json";
  lessons().start(lesson);
  ASSERT_TRUE(lessons().keepResults(QString::fromStdString(file.string())));
  LessonResults elsewhere = emptyResults(lesson);
  LessonResult second;
  second.step = 1;
  second.kind = PredictionKind::Number;
  second.given.number = 1e-6;
  elsewhere.set(second);
  writeResults(file, elsewhere, lesson);
  control<QRadioButton>("lessonChoice:0").click();
  click("lessonNext");
  ASSERT_TRUE(waitForAnswer());
  EXPECT_NE(readResults(file, lesson).find(0), nullptr);
  EXPECT_NE(readResults(file, lesson).find(1), nullptr);
}

/// The window asks about the answers first, and then perhaps about the scene.
TEST_F(LessonAnswersTest, DiscardedAnswersStayUntilTheLessonEnds) {
  const Lesson lesson = lessonOf(sampleLesson());
  lessons().start(lesson);
  control<QRadioButton>("lessonChoice:0").click();
  click("lessonNext");
  ASSERT_TRUE(waitForAnswer());
  answer(QMessageBox::Discard);
  ASSERT_TRUE(lessons().mayLeave());
  EXPECT_TRUE(player().isRevealed());  // the window stays open after all
  lessons().end();
  EXPECT_FALSE(keptAnswers(lesson));
  lessons().start(lesson);
  EXPECT_FALSE(player().isRevealed());
}

/// The picture's title, too, which is that of the step; what was changed stays.
TEST_F(LessonAnswersTest, ALessonChangesItsLanguage) {
  ASSERT_TRUE(lessons().open("load_and_friction"));
  press("load.normal_force");
  const double force = session().scene().load.normalForce;
  useLanguage("de");
  EXPECT_TRUE(waitFor([&] { return said("lessonStepTitle") == "Das Gesetz von Amontons"; }));
  EXPECT_EQ(session().scene().title, "Das Gesetz von Amontons");
  EXPECT_EQ(session().scene().load.normalForce, force);
  useLanguage("en");
  EXPECT_TRUE(waitFor([&] { return session().scene().title == "Amontons' law"; }));
}

/// The end of a presentation restores the docks of before, but not a lesson that is over.
TEST_F(LessonAnswersTest, APresentationBringsNoLessonBackAndLosesNone) {
  auto& dock = control<QDockWidget>("lessonDock");
  lessons().start(lessonOf(sampleLesson()));
  action("present").trigger();
  EXPECT_TRUE(dock.isVisible());
  EXPECT_GT(control<QLabel>("lessonStepTitle").font().pointSizeF(),
            control<QLabel>("lessonText").font().pointSizeF());
  QTest::mouseClick(&control<QAbstractButton>("lessonEnd"), Qt::LeftButton);
  action("present").trigger();
  EXPECT_FALSE(dock.isVisible());
  action("present").trigger();
  lessons().start(lessonOf(sampleLesson()));
  action("present").trigger();
  EXPECT_TRUE(dock.isVisible());
}

TEST_F(LessonAnswersTest, AnswersAreNotLostWithoutAQuestion) {
  const Lesson lesson = lessonOf(sampleLesson());
  const auto answerFirst = [&] {
    control<QRadioButton>("lessonChoice:0").click();
    click("lessonNext");
    return waitForAnswer();
  };
  lessons().start(lesson);
  answer(QMessageBox::Cancel);
  const auto end = [&] {
    QTest::mouseClick(&control<QAbstractButton>("lessonEnd"), Qt::LeftButton);
  };
  ASSERT_TRUE(answerFirst());
  end();
  EXPECT_EQ(asked_, 1);
  EXPECT_TRUE(player().isRunning());
  answer(QMessageBox::Cancel);
  EXPECT_FALSE(window_.close());
  EXPECT_EQ(asked_, 1);
  answer(QMessageBox::Discard);
  end();
  EXPECT_EQ(asked_, 1);
  EXPECT_FALSE(player().isRunning());
  lessons().start(lesson);
  EXPECT_FALSE(player().isRevealed());
  // Another scene ends the lesson at once; its answers are there when it begins again.
  ASSERT_TRUE(answerFirst());
  action("scene:figure_2").trigger();
  EXPECT_FALSE(player().isRunning());
  lessons().start(lesson);
  EXPECT_TRUE(player().isRevealed());
  // What a file has is left without a question.
  TemporaryFolder folder;
  ASSERT_TRUE(lessons().keepResults(QString::fromStdString((folder / "mine.json").string())));
  answer(QMessageBox::Cancel);
  end();
  EXPECT_EQ(asked_, 0);
  EXPECT_FALSE(player().isRunning());
}

}  // namespace
}  // namespace asperity
