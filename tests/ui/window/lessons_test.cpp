// Lessons in the window, as a student and a teacher use them: by mouse and by keyboard, from the
// first step to the last, with the user's own scene back at the end.
#include "ui/window/lesson/lessons.h"

#include <gmock/gmock.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QFileDialog>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QTableWidget>
#include <QTextBrowser>
#include <QTextDocumentFragment>
#include <QThread>
#include <QToolButton>
#include <array>
#include <atomic>
#include <stdexcept>

#include "core/base/stop.h"
#include "tests/core/lesson/lesson_samples.h"
#include "tests/core/temporary_folder.h"
#include "tests/ui/window/main_window_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "tests/ui/window/window_in.h"
#include "ui/language/language.h"
#include "ui/panels/controls.h"
#include "ui/window/lesson/handout.h"
#include "ui/window/lesson/lesson_document.h"
#include "ui/window/lesson/lesson_editor.h"
#include "ui/window/lesson/lesson_list.h"
#include "ui/window/lesson/lesson_pane.h"
#include "ui/window/lesson/lesson_results_page.h"
#include "ui/window/lesson/lesson_text.h"
#include "ui/window/lesson/prediction_point.h"
#include "ui/window/main/scene_library.h"
#include "ui/window/main/scene_tabs.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

/// A third step with a point, at a place or free.
Lesson sampleWithPoint(bool hasPlace) {
  Json json = sampleLesson();
  json["steps"][1]["prediction"] = {{"kind", "point"}, {"question", "Where?"}, {"tolerance", 0.5}};
  if (hasPlace) json["steps"][1]["prediction"]["x"] = 0.1;
  return lessonOf(json);
}

class LessonsTest : public MainWindowTest {
 protected:
  LessonsTest() {
    for (const char* kept : {"lessonAnswers", "lessonDraft", "lessonFiles", "lessonSteps"})
      QSettings().remove(kept);
  }
  Lessons& lessons() { return window_.lessons(); }
  QPushButton& button(const char* name) { return control<QPushButton>(name); }
  void click(const char* name) { QTest::mouseClick(&button(name), Qt::LeftButton); }
  QString said(const char* name) { return control<QLabel>(name).text(); }
  bool waitForAnswer() {
    return waitFor([&] { return lessons().isRevealed(); });
  }
  /// Answers the next question for files, of which several stand in quotation marks.
  void chooseFiles(const QString& files) {
    whenAsked<QFileDialog>([files](QFileDialog& dialog) {
      dialog.findChild<QLineEdit*>("fileNameEdit")->setText(files);
      static_cast<QDialog&>(dialog).accept();
    });
  }
  /// Whether the friction curve itself is on the chart.
  bool showsCurve() {
    for (const DiagramSeries& series : chart().series)
      if (series.id == kPresentCurve && !series.points.empty()) return true;
    return false;
  }
};

TEST_F(LessonsTest, AsksRevealsAndFreesWhatTheStepSays) {
  lessons().start(lessonOf(sampleLesson()));
  EXPECT_TRUE(control<QDockWidget>("lessonDock").isVisible());
  EXPECT_EQ(said("lessonProgress"), "1 of 2");
  EXPECT_EQ(said("lessonStepTitle"), "First");
  EXPECT_EQ(session().scene().sliding.velocity, 1e-4);
  EXPECT_FALSE(button("lessonNext").isEnabled());
  EXPECT_FALSE(control<QWidget>("row:sliding.velocity").isEnabled());
  EXPECT_TRUE(control<QWidget>("row:load.normal_force").isVisibleTo(&window_));
  EXPECT_TRUE(control<QWidget>("row:surface.hurst").isHidden());

  QTest::mouseClick(&control<QLabel>("lessonChoiceText:0"), Qt::LeftButton);
  EXPECT_TRUE(control<QRadioButton>("lessonChoice:0").isChecked());
  control<QRadioButton>("lessonChoice:1").setFocus();
  QTest::keyClick(&control<QRadioButton>("lessonChoice:1"), Qt::Key_Space);
  EXPECT_TRUE(button("lessonNext").isEnabled());
  click("lessonNext");
  ASSERT_TRUE(waitForAnswer());
  EXPECT_TRUE(said("lessonVerdict").contains("Yes, 1.9") ||
              said("lessonVerdict").contains("Yes, 2"));
  EXPECT_TRUE(said("lessonReveal").contains("twice"));
  EXPECT_FALSE(said("lessonReveal").contains("{"));
  EXPECT_EQ(session().scene().sliding.velocity, 2e-4);
  EXPECT_TRUE(control<QWidget>("row:sliding.velocity").isEnabled());
  EXPECT_EQ(lessons().results().right(), 1);
}

/// By real keys, which are offered to the window's shortcuts first: the space bar pauses.
TEST_F(LessonsTest, AChoiceIsMadeAndCheckedByKeysAlone) {
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  lessons().start(lessonOf(sampleLesson()));
  const bool isPlaying = session().isPlaying();
  auto& first = control<QRadioButton>("lessonChoice:0");
  auto& second = control<QRadioButton>("lessonChoice:1");
  ASSERT_TRUE(first.hasFocus());
  const auto heightOf = [&](QWidget& one) { return one.mapTo(&window_, QPoint()).y(); };
  ASSERT_TRUE(waitFor([&] { return heightOf(second) > heightOf(first); }));
  const auto key = [&](Qt::Key pressed) { QTest::keyClick(window_.windowHandle(), pressed); };
  key(Qt::Key_Down);
  EXPECT_TRUE(second.hasFocus());
  EXPECT_TRUE(second.isChecked());
  key(Qt::Key_Up);
  EXPECT_TRUE(first.isChecked());
  second.setFocus();
  key(Qt::Key_Space);
  EXPECT_TRUE(second.isChecked());
  EXPECT_EQ(session().isPlaying(), isPlaying);
  key(Qt::Key_Tab);
  EXPECT_EQ(QApplication::focusWidget(), &button("lessonShow"));  // the first step has no "Back"
  key(Qt::Key_Tab);
  EXPECT_EQ(QApplication::focusWidget(), &button("lessonNext"));
  key(Qt::Key_Space);
  ASSERT_TRUE(waitForAnswer());
  EXPECT_EQ(lessons().results().right(), 1);
  EXPECT_EQ(session().isPlaying(), isPlaying);
}

TEST_F(LessonsTest, AButtonIsPressedByReturnThoughItIsNotTheOneThatLeadsOn) {
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  lessons().start(lessonOf(sampleLesson()));
  control<QRadioButton>("lessonChoice:0").click();
  button("lessonShow").setFocus();
  QTest::keyClick(window_.windowHandle(), Qt::Key_Return);
  ASSERT_TRUE(waitForAnswer());
  EXPECT_FALSE(lessons().results().find(0)->given.isGiven());
}

/// Where the focus goes with a step, a screen reader says what the step asks or tells.
TEST_F(LessonsTest, AListenerHearsTheQuestionWithTheFirstAnswer) {
  Json json = sampleLesson();
  json["steps"].push_back({{"text", "All is *said*."}});
  lessons().start(lessonOf(json));
  EXPECT_EQ(control<QRadioButton>("lessonChoice:0").accessibleDescription(), "Twice as fast?");
  EXPECT_EQ(control<QRadioButton>("lessonChoice:1").accessibleDescription(), "");
  lessons().player().show(1);
  EXPECT_EQ(control<QLineEdit>("lessonNumber").accessibleDescription(), "Indentation?");
  lessons().player().show(2);
  EXPECT_TRUE(button("lessonNext").accessibleDescription().startsWith("All is said."));
  QTest::qWait(0);  // the fields of the former steps go, of which one had the focus
}

/// The window may be painted before any other event: the question and its fields are in their
/// places as soon as the step is shown.
TEST_F(LessonsTest, AQuestionIsNeverSeenWithoutItsFields) {
  lessons().start(lessonOf(sampleLesson()));
  auto& question = control<QLabel>("lessonQuestion");
  ASSERT_TRUE(waitFor([&] { return question.isVisible() && question.y() > 0; }));
  const auto top = [&](const char* name) {
    return control<QWidget>(name).mapTo(question.parentWidget(), QPoint()).y();
  };
  lessons().player().show(1);
  EXPECT_TRUE(control<QWidget>("lessonNumber").isVisible());
  EXPECT_GT(top("lessonNumber"), question.geometry().bottom());
  lessons().player().show(0);
  EXPECT_TRUE(control<QWidget>("lessonChoice:0").isVisible());
  EXPECT_GT(top("lessonChoice:0"), question.geometry().bottom());
  EXPECT_GT(top("lessonChoice:1"), top("lessonChoice:0"));
  QTest::qWait(0);  // the fields of the former steps go, of which one had the focus
}

TEST_F(LessonsTest, TheTabKeyGoesFromTheQuestionToTheAnswerAndOn) {
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  lessons().start(lessonOf(sampleLesson()), 1);
  ASSERT_TRUE(waitFor([&] { return control<QLineEdit>("lessonNumber").isVisible(); }));
  control<QLabel>("lessonQuestion").setFocus();
  const auto tab = [&] { QTest::keyClick(window_.windowHandle(), Qt::Key_Tab); };
  tab();
  EXPECT_TRUE(control<QLabel>("lessonTolerance").hasFocus());
  tab();
  EXPECT_TRUE(control<QLineEdit>("lessonNumber").hasFocus());
  tab();
  EXPECT_TRUE(button("lessonBack").hasFocus());
}

/// A later step may ask for what the curve would show.
TEST_F(LessonsTest, ACurveStaysHiddenWhereTheStepSaysSo) {
  for (const bool throughout : {false, true}) {
    Json json = sampleLesson();
    json["steps"][0]["show"]["curve"] = throughout ? "hidden_throughout" : "hidden";
    lessons().start(lessonOf(json));
    click("lessonShow");
    ASSERT_TRUE(waitForAnswer());
    ASSERT_TRUE(waitFor([&] { return session().friction().progress() >= 1; }));
    ASSERT_TRUE(waitFor([&] { return showsCurve() == !throughout; }));
  }
}

/// While it is hidden, the axis has the ends that the step gives it, too.
TEST_F(LessonsTest, ACurveHasTheScaleOfItsStep) {
  Json json = sampleLesson();
  json["steps"][0]["show"]["curve"] = "hidden";
  json["steps"][0]["show"]["scale"] = "linear";
  json["steps"][0]["show"]["hidden_range"] = {{"from", 0}, {"to", 0.002}};
  lessons().start(lessonOf(json));
  ASSERT_TRUE(waitFor([&] { return chart().y.scale == AxisScale::Linear; }));
  EXPECT_EQ(chart().y.from, 0);
  EXPECT_EQ(chart().y.to, 0.002);
  click("lessonShow");
  ASSERT_TRUE(waitForAnswer());
  ASSERT_TRUE(waitFor([&] { return chart().y.scale == AxisScale::Linear; }));
  EXPECT_TRUE(window_.findChild<QAction*>("linearQuantity")->isChecked());
  lessons().end();
  ASSERT_TRUE(waitFor([&] { return chart().y.scale == AxisScale::Logarithmic; }));
  EXPECT_FALSE(window_.findChild<QAction*>("linearQuantity")->isChecked());
}

TEST_F(LessonsTest, WhatIsLockedStaysAndWhatIsFreeMoves) {
  lessons().start(lessonOf(sampleLesson()));
  const Scene shown = session().scene();
  Scene changed = shown;
  changed.sliding.velocity = 3;
  window_.document().edit(changed);  // as the marker of the chart does
  ASSERT_TRUE(waitFor([&] { return session().scene() == shown; }));
  EXPECT_TRUE(said("lessonNote").contains("guess"));
  click("lessonShow");
  ASSERT_TRUE(waitForAnswer());
  EXPECT_FALSE(lessons().results().find(0)->given.isGiven());
  press("sliding.velocity");
  EXPECT_NE(session().scene().sliding.velocity, 2e-4);
  changed = session().scene();
  const double velocity = changed.sliding.velocity;
  changed.load.normalForce = 9;
  window_.document().edit(changed);
  ASSERT_TRUE(
      waitFor([&] { return session().scene().load.normalForce == shown.load.normalForce; }));
  EXPECT_EQ(session().scene().sliding.velocity, velocity);
}

TEST_F(LessonsTest, TheUsersOwnSceneComesBackWithItsChanges) {
  type("load.normal_force", "5 mN");
  const Scene own = session().scene();
  ASSERT_TRUE(window_.document().isChanged());
  lessons().start(lessonOf(sampleLesson()));
  EXPECT_TRUE(window_.document().isTrial());
  EXPECT_NE(session().scene(), own);
  QTest::mouseClick(&control<QAbstractButton>("lessonEnd"), Qt::LeftButton);
  EXPECT_FALSE(lessons().isRunning());
  EXPECT_EQ(session().scene(), own);
  EXPECT_TRUE(window_.document().isChanged());
  EXPECT_FALSE(control<QDockWidget>("lessonDock").isVisible());
  EXPECT_TRUE(control<QWidget>("row:surface.hurst").isEnabled());
}

TEST_F(LessonsTest, ALessonIsSeenThoughTheGalleryWasOpen) {
  window_.openGallery();
  QWidget& contact = control<QWidget>("contactPage");
  ASSERT_FALSE(contact.isVisible());
  lessons().start(lessonOf(sampleLesson()));
  EXPECT_TRUE(contact.isVisible());
}

TEST_F(LessonsTest, AnotherSceneEndsTheLessonAndUndoBringsTheOwnOneBack) {
  type("load.normal_force", "5 mN");
  const Scene own = session().scene();
  lessons().start(lessonOf(sampleLesson()));
  action("scene:figure_2").trigger();
  EXPECT_FALSE(lessons().isRunning());
  EXPECT_NE(session().scene(), own);
  action("undo").trigger();
  EXPECT_EQ(session().scene(), own);
}

TEST_F(LessonsTest, ANumberIsTypedWithOrWithoutItsUnit) {
  lessons().start(lessonOf(sampleLesson()), 1);
  auto& number = control<QLineEdit>("lessonNumber");
  EXPECT_FALSE(showsCurve());
  QTest::keyClicks(&number, "much");
  click("lessonNext");
  EXPECT_FALSE(lessons().isRevealed());
  EXPECT_TRUE(said("lessonNote").contains("number"));
  number.selectAll();
  QTest::keyClicks(&number, "0.3 um");
  QTest::keyClick(&number, Qt::Key_Return);
  ASSERT_TRUE(waitForAnswer());
  EXPECT_DOUBLE_EQ(lessons().results().find(1)->given.number, 3e-7);
  ASSERT_TRUE(waitFor([&] { return showsCurve(); }));
}

/// Groups of thousands are those of the language, and the pane says how it reads them.
TEST_F(LessonsTest, ANumberIsReadAsTheLanguageWritesIt) {
  Json json = sampleLesson();
  const auto begin = [&](const char* language) {
    useLanguage(language);
    json["title"] = language;  // another lesson, without answers
    lessons().start(lessonOf(json), 1);
  };
  for (const auto& [language, typed] : {std::pair("en", "2,560 um"), {"de", "2.560 um"}}) {
    begin(language);
    QTest::keyClicks(&control<QLineEdit>("lessonNumber"), typed);
    EXPECT_TRUE(said("lessonNote").contains("2560 um")) << said("lessonNote").toStdString();
    click("lessonNext");
    ASSERT_TRUE(waitForAnswer());
    EXPECT_DOUBLE_EQ(lessons().results().find(1)->given.number, 2.56e-3);
  }
  json["goal"] = "another one";
  begin("de");
  QTest::keyClicks(&control<QLineEdit>("lessonNumber"), "2,560 um");
  EXPECT_TRUE(said("lessonNote").contains("2,56 um")) << said("lessonNote").toStdString();
  useLanguage("en");
}

TEST_F(LessonsTest, ANoteIsScrolledTo) {
  TemporaryFolder folder;
  Json json = sampleLesson();
  std::string lines;
  for (int i = 0; i < 30; ++i) lines += "A line that is read.\n";
  json["steps"][0]["text"] = json["steps"][0]["reveal"] = lines;
  const Lesson lesson = lessonOf(json);
  for (const bool isRevealed : {false, true}) {
    lessons().start(lesson);
    if (isRevealed) {
      click("lessonShow");
      ASSERT_TRUE(waitForAnswer());
    }
    ASSERT_TRUE(lessons().keepResults(QString::fromStdString((folder / "ada.json").string())));
    const auto& note = control<QLabel>("lessonNote");
    EXPECT_TRUE(note.text().contains("ada.json"));
    EXPECT_TRUE(waitFor([&] { return note.visibleRegion().boundingRect() == note.rect(); }));
    lessons().end();
    std::filesystem::remove(folder / "ada.json");
  }
}

/// The window of the next session stands for the program that starts after a crash.
TEST_F(LessonsTest, AnswersOutliveACrash) {
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
    EXPECT_EQ(next.lessons().isRevealed(), isKept);
    EXPECT_EQ(keptAnswers(lesson).has_value(), isKept);
    next.lessons().end();
  }
}

/// Also in the next session, with the answers in their file; who begins anew is not asked again.
TEST_F(LessonsTest, ALessonGoesOnWhereItWasLeft) {
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
  ASSERT_EQ(lessons().step(), 1);
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
    EXPECT_EQ(lessons().step(), goesOn ? 1 : 0);
    EXPECT_EQ(lessons().results().results.size(), goesOn ? 1U : 0U);
    window_.activateWindow();  // as the desktop does when the question closes
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
    EXPECT_EQ(window_.focusWidget()->objectName(), goesOn ? "lessonNumber" : "lessonChoice:0");
    lessons().end();
  }
}

/// In both questions, that after a crash and that about a file, the key loses nothing.
TEST_F(LessonsTest, EscapeGoesOnWithAnswersOfAnEarlierSession) {
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
    EXPECT_EQ(next.lessons().results().results.size(), 1U);
    ASSERT_TRUE(next.lessons().keepResults(QString::fromStdString((folder / "ada.json").string())));
    next.lessons().end();
  }
}

TEST_F(LessonsTest, AnswersThatAreSavedOrDiscardedAreNotKept) {
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

TEST_F(LessonsTest, APointHasThreeDigits) {
  Json json = sampleLesson();
  json["steps"][1]["prediction"] = {{"kind", "point"}, {"question", "Where?"}, {"x", 0.123}};
  lessons().start(lessonOf(json), 1);
  PredictionPoint& point = lessons().point();
  ASSERT_TRUE(waitFor([&] { return point.isVisible() && chart().y.to == 1; }));
  QTest::keyClick(&point, Qt::Key_Up);
  EXPECT_TRUE(point.accessibleName().contains("at 123 mm/s"))
      << point.accessibleName().toStdString();
}

TEST_F(LessonsTest, TheLabelOfAPointHidesNoLine) {
  Json json = sampleLesson();
  json["steps"][1]["prediction"] = {{"kind", "point"}, {"question", "Where?"}, {"x", 2e-3}};
  lessons().start(lessonOf(json), 1);
  PredictionPoint& point = lessons().point();
  click("lessonShow");
  ASSERT_TRUE(waitForAnswer());
  ASSERT_TRUE(waitFor([&] { return showsCurve() && session().friction().progress() >= 1; }));
  const auto isCrossed = [&] {
    (void)point.grab();  // draws it
    const QRectF label = point.label();
    const double present = window_.plotView().mapToPosition(chart().marker->x, 1).x();
    if (label.left() < present && present < label.right()) return true;
    const auto pixel = [&](const DiagramPoint& each) {
      return window_.plotView().mapToPosition(each.x, each.y);
    };
    for (const DiagramSeries& series : chart().series)
      for (std::size_t i = 1; i < series.points.size(); ++i) {
        const QLineF line(pixel(series.points[i - 1]), pixel(series.points[i]));
        for (int part = 0; part <= 100; ++part)
          if (label.contains(line.pointAt(part / 100.0))) return true;
      }
    return false;
  };
  EXPECT_TRUE(waitFor([&] { return !isCrossed(); }));
  EXPECT_FALSE(point.label().isEmpty());
}

TEST_F(LessonsTest, ALongWordOfTheTitleIsShortenedWithDots) {
  Json json = sampleLesson();
  json["title"] = "Of " + std::string(300, 'M');
  lessons().start(lessonOf(json));
  const auto& title = dynamic_cast<WrappedLabel&>(control<QLabel>("lessonTitle"));
  EXPECT_TRUE(waitFor([&] { return title.shownText().endsWith(u'…'); }));
  EXPECT_TRUE(title.shownText().startsWith("Of MM"));
  EXPECT_EQ(title.text().size(), 303);
}

TEST_F(LessonsTest, APointSaysHowCloselyItCounts) {
  lessons().start(sampleWithPoint(false), 1);
  EXPECT_EQ(said("lessonTolerance"),
            "A height within a factor of 1.5 and a place within a factor of 2 count as right.");
  lessons().start(sampleWithPoint(true), 1);
  EXPECT_EQ(said("lessonTolerance"), "A height within a factor of 1.5 counts as right.");
  lessons().start(lessonOf(sampleLesson()), 0);  // a choice
  EXPECT_FALSE(control<QLabel>("lessonTolerance").isVisible());
}

/// Many per cent are said as what they mean.
TEST_F(LessonsTest, ANumberSaysHowNearItHasToBe) {
  Json json = sampleLesson();
  for (const auto& [tolerance, text] :
       {std::pair(0.2, "An answer within 20\u00A0% of the right one counts."),
        {0.5, "An answer from 0.5 to 1.5 times the right one counts."},
        {1, "An answer from 0 to 2 times the right one counts."}}) {
    json["steps"][1]["prediction"]["tolerance"] = tolerance;
    lessons().start(lessonOf(json), 1);
    EXPECT_EQ(said("lessonTolerance"), QString::fromUtf8(text));
  }
}

TEST_F(LessonsTest, APointIsDraggedOrMovedByKeysOverTheHiddenCurve) {
  for (const bool hasPlace : {true, false}) {
    lessons().start(sampleWithPoint(hasPlace), 1);
    PredictionPoint& point = lessons().point();
    ASSERT_TRUE(waitFor([&] {
      return point.isVisible() && session().friction().progress() >= 1 && chart().y.from == 1e-6 &&
             chart().y.to == 1;
    }));
    EXPECT_FALSE(showsCurve());
    EXPECT_FALSE(button("lessonNext").isEnabled());
    const QPoint place = window_.plotView().mapToPosition(0.1, 1e-3).toPoint();
    QTest::mousePress(&point, Qt::LeftButton, {}, place + QPoint(20, 30));
    QTest::mouseMove(&point, place + QPoint(10, 5));
    QTest::mouseRelease(&point, Qt::LeftButton, {}, place);
    ASSERT_TRUE(point.point());
    QTest::mouseClick(&point, Qt::LeftButton, {}, place);
    EXPECT_NEAR(std::log10(point.point()->y()), -3, 0.1);
    EXPECT_NEAR(std::log10(point.point()->x()), -1, hasPlace ? 1e-12 : 0.1);
    const double before = point.point()->y();
    QTest::keyClick(&point, Qt::Key_Up);
    EXPECT_GT(point.point()->y(), before);
    QTest::keyClick(&point, Qt::Key_Down);
    QTest::keyClick(&point, Qt::Key_Right, Qt::ShiftModifier);
    EXPECT_EQ(point.point()->x() > 0.1 * 1.0001, !hasPlace);
    EXPECT_TRUE(point.accessibleName().contains("Where?"));
    const double placed = point.point()->y();
    click("lessonNext");
    ASSERT_TRUE(waitForAnswer());
    EXPECT_EQ(lessons().results().find(1)->given.number, placed);
    ASSERT_TRUE(waitFor([&] { return showsCurve(); }));
    lessons().end();
    EXPECT_FALSE(point.isVisible());
  }
}

/// By real keys; the Return key does nothing before the point is placed.
TEST_F(LessonsTest, APointIsPlacedAndCheckedByKeysAlone) {
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  lessons().start(sampleWithPoint(true), 1);
  ASSERT_TRUE(waitFor(
      [&] { return lessons().point().isVisible() && window_.plotView().frame().has_value(); }));
  const auto key = [&](Qt::Key pressed) { QTest::keyClick(window_.windowHandle(), pressed); };
  key(Qt::Key_Return);
  EXPECT_FALSE(lessons().point().point());
  key(Qt::Key_Up);
  ASSERT_TRUE(lessons().point().point());
  const double placed = lessons().point().point()->y();
  key(Qt::Key_Return);
  ASSERT_TRUE(waitForAnswer());
  EXPECT_EQ(lessons().results().find(1)->given.number, placed);
  EXPECT_TRUE(button("lessonNext").hasFocus());
}

TEST_F(LessonsTest, ResultsAreKeptInAFileOfTheStudentsChoice) {
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
  EXPECT_FALSE(lessons().isRevealed());
  ASSERT_TRUE(lessons().keepResults(QString::fromStdString(file.string())));
  EXPECT_TRUE(lessons().isRevealed());
  // A file of somebody else's stays as it is.
  folder.write("thesis.txt", "my thesis");
  EXPECT_FALSE(lessons().keepResults(QString::fromStdString((folder / "thesis.txt").string())));
  EXPECT_TRUE(window_.messages().isVisible());
  EXPECT_EQ(TemporaryFolder::read(folder / "thesis.txt"), "my thesis");
}

TEST_F(LessonsTest, EveryShippedLessonIsWalkedThrough) {
  for (const ShippedLesson& shipped : shippedLessons()) {
    SCOPED_TRACE(std::string(shipped.name));
    ASSERT_TRUE(lessons().open(
        QString::fromUtf8(shipped.name.data(), static_cast<qsizetype>(shipped.name.size()))));
    const auto steps = static_cast<int>(lessons().lesson()->steps.size());
    for (int step = 0; step < steps; ++step) {
      EXPECT_EQ(lessons().step(), step);
      ASSERT_TRUE(waitForFrame());
      EXPECT_TRUE(frameError(*frame()).empty()) << step;
      if (!lessons().isRevealed()) {
        click("lessonShow");
        ASSERT_TRUE(waitForAnswer()) << step;
      }
      for (const char* text : {"lessonText", "lessonReveal", "lessonVerdict"})
        EXPECT_FALSE(said(text).contains('{')) << said(text).toStdString();
      EXPECT_FALSE(window_.messages().isVisible()) << window_.messages().text().toStdString();
      click("lessonNext");
    }
    EXPECT_FALSE(lessons().isRunning());
  }
}

TEST_F(LessonsTest, GoesForwardAndBackByKeys) {
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  lessons().start(lessonOf(sampleLesson()));
  QTest::keyClick(&window_, Qt::Key_Right, Qt::ControlModifier | Qt::AltModifier);
  EXPECT_EQ(lessons().step(), 0);  // first the guess
  click("lessonShow");
  ASSERT_TRUE(waitForAnswer());
  QTest::keyClick(&window_, Qt::Key_Right, Qt::ControlModifier | Qt::AltModifier);
  EXPECT_EQ(lessons().step(), 1);
  QTest::keyClick(&window_, Qt::Key_Left, Qt::ControlModifier | Qt::AltModifier);
  EXPECT_EQ(lessons().step(), 0);
  EXPECT_TRUE(lessons().isRevealed());  // what was answered stays answered
}

/// A choice that is made and not checked yet, a number and a point.
TEST_F(LessonsTest, AnotherLanguageKeepsWhatTheStudentHasEntered) {
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
  EXPECT_DOUBLE_EQ(lessons().results().find(1)->given.number, 1.25e-6);
  useLanguage("en");
  Json json = sampleLesson();
  json["steps"][1]["prediction"] = {
      {"kind", "point"}, {"question", {{"en", "Where?"}, {"de", "Wo?"}}}, {"tolerance", 0.5}};
  lessons().start(lessonOf(json), 1);
  PredictionPoint& point = lessons().point();
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
TEST_F(LessonsTest, AnotherLanguageKeepsTheFocus) {
  window_.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  lessons().start(lessonOf(sampleLesson()));
  control<QRadioButton>("lessonChoice:1").setFocus();
  useLanguage("de");
  EXPECT_TRUE(waitFor([&] { return said("lessonProgress") == "1 von 2"; }));
  EXPECT_TRUE(control<QRadioButton>("lessonChoice:1").hasFocus());
  useLanguage("en");
}

TEST_F(LessonsTest, AnswersAreSavedBesideOneThatIsNotCheckedYet) {
  TemporaryFolder folder;
  lessons().start(lessonOf(sampleLesson()));
  control<QRadioButton>("lessonChoice:1").click();
  ASSERT_TRUE(lessons().keepResults(QString::fromStdString((folder / "ada.json").string())));
  EXPECT_TRUE(control<QRadioButton>("lessonChoice:1").isChecked());
  EXPECT_TRUE(button("lessonNext").isEnabled());
}

/// The same lesson may run in another window of the program, or on another day.
TEST_F(LessonsTest, AnswersThatAFileGotElsewhereStay) {
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
TEST_F(LessonsTest, DiscardedAnswersStayUntilTheLessonEnds) {
  const Lesson lesson = lessonOf(sampleLesson());
  lessons().start(lesson);
  control<QRadioButton>("lessonChoice:0").click();
  click("lessonNext");
  ASSERT_TRUE(waitForAnswer());
  answer(QMessageBox::Discard);
  ASSERT_TRUE(lessons().mayLeave());
  EXPECT_TRUE(lessons().isRevealed());  // the window stays open after all
  lessons().end();
  EXPECT_FALSE(keptAnswers(lesson));
  lessons().start(lesson);
  EXPECT_FALSE(lessons().isRevealed());
}

/// Whoever answers soon does not wait longer.
TEST_F(LessonsTest, AnAnswerIsComputedOnce) {
  std::atomic<int> calls = 0;
  std::atomic<bool> mayEnd = false;
  lessons().player().setAnswerFunction([&](const LessonStep& step, const CurveOptions& options) {
    ++calls;
    while (!mayEnd) {
      throwIfStopped(options.stop);
      QThread::msleep(1);
    }
    return lessonAnswer(step, options);
  });
  lessons().start(lessonOf(sampleLesson()));
  control<QRadioButton>("lessonChoice:1").click();
  ASSERT_TRUE(waitFor([&] { return calls == 1; }));
  click("lessonNext");
  EXPECT_TRUE(said("lessonNote").contains("computes"));
  mayEnd = true;
  ASSERT_TRUE(waitForAnswer());
  EXPECT_EQ(calls, 1);
}

TEST_F(LessonsTest, WhatWasLockedInAStepIsNotBroughtIntoTheNext) {
  lessons().start(lessonOf(sampleLesson()));
  Scene changed = session().scene();
  changed.load.normalForce *= 3;
  window_.document().edit(changed);
  lessons().player().show(1);
  const Scene second = session().scene();
  QTest::qWait(50);
  EXPECT_EQ(session().scene(), second);
}

/// The teacher closes the list while its handout is being made.
TEST_F(LessonsTest, AHandoutIsSavedThoughItsPageIsClosed) {
  TemporaryFolder folder;
  LessonList& list = lessons().showList();
  list.saver().save(lessonOf(sampleLesson()),
                    QString::fromStdString((folder / "handout.html").string()), false);
  list.close();
  EXPECT_TRUE(waitFor([&] { return std::filesystem::exists(folder / "handout.html"); }));
  EXPECT_TRUE(waitFor([&] { return window_.messages().text().contains("handout.html"); }));
}

/// The picture's title, too, which is that of the step; what was changed stays.
TEST_F(LessonsTest, ALessonChangesItsLanguage) {
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

TEST_F(LessonsTest, AStepBringsItsTabToTheFront) {
  const std::pair<const char*, const char*> tabs[] = {
      {"curve", "frictionPlot"},    {"spectrum", "spectrumView"},  {"statistics", "statisticsView"},
      {"material", "materialView"}, {"accuracy", "accuracyPanel"}, {"plan", "planList"},
      {"map", "mapPanel"}};
  for (const auto& [word, name] : tabs) {
    Json json = sampleLesson();
    json["steps"] = Json::array({json["steps"][0]});
    json["steps"][0]["show"]["tab"] = word;
    lessons().start(lessonOf(json));
    EXPECT_EQ(window_.tabs().currentWidget()->objectName(), name);
  }
}

/// The end of a presentation restores the docks of before, but not a lesson that is over.
TEST_F(LessonsTest, APresentationBringsNoLessonBackAndLosesNone) {
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

TEST_F(LessonsTest, AHiddenCurveIsSeenNeitherInOtherTabsNorInReadings) {
  Json json = sampleLesson();
  json["steps"][0]["show"]["curve"] = "hidden";
  lessons().start(lessonOf(json));
  SceneTabs& tabs = window_.tabs();
  ASSERT_TRUE(waitFor([&] { return session().friction().progress() >= 1; }));
  ASSERT_TRUE(waitForFrame());
  for (const char* page : {"mapPanel", "influencePage"}) {
    const int index = tabs.indexOf(&control<QWidget>(page));
    EXPECT_FALSE(tabs.isTabEnabled(index)) << page;
    EXPECT_TRUE(tabs.tabToolTip(index).contains("hidden until the answer"));
    action(QStringLiteral("go:%1").arg(page)).trigger();
    EXPECT_NE(tabs.currentIndex(), index);
  }
  const std::shared_ptr<const Frame> before = session().frame();
  ASSERT_TRUE(waitFor([&] { return session().frame() != before; }));
  EXPECT_EQ(said("factRegime"), QString());
  // Nor can it be pinned or go into a file.
  constexpr std::array kWithCurve{"pinCurve", "saveCurve", "exportPicture", "exportFilm",
                                  "exportTable"};
  for (const char* name : kWithCurve) EXPECT_FALSE(action(name).isEnabled()) << name;
  EXPECT_FALSE(control<QMenu>("familyMenu").isEnabled());
  click("lessonShow");
  ASSERT_TRUE(waitForAnswer());
  EXPECT_TRUE(waitFor([&] { return said("factRegime").contains("region"); }));
  for (const char* name : kWithCurve) EXPECT_TRUE(action(name).isEnabled()) << name;
  for (const char* page : {"mapPanel", "influencePage"})
    EXPECT_TRUE(tabs.isTabEnabled(tabs.indexOf(&control<QWidget>(page)))) << page;
}

TEST_F(LessonsTest, AnswersAreNotLostWithoutAQuestion) {
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
  EXPECT_TRUE(lessons().isRunning());
  answer(QMessageBox::Cancel);
  EXPECT_FALSE(window_.close());
  EXPECT_EQ(asked_, 1);
  answer(QMessageBox::Discard);
  end();
  EXPECT_EQ(asked_, 1);
  EXPECT_FALSE(lessons().isRunning());
  lessons().start(lesson);
  EXPECT_FALSE(lessons().isRevealed());
  // Another scene ends the lesson at once; its answers are there when it begins again.
  ASSERT_TRUE(answerFirst());
  action("scene:figure_2").trigger();
  EXPECT_FALSE(lessons().isRunning());
  lessons().start(lesson);
  EXPECT_TRUE(lessons().isRevealed());
  // What a file has is left without a question.
  TemporaryFolder folder;
  ASSERT_TRUE(lessons().keepResults(QString::fromStdString((folder / "mine.json").string())));
  answer(QMessageBox::Cancel);
  end();
  EXPECT_EQ(asked_, 0);
  EXPECT_FALSE(lessons().isRunning());
}

TEST_F(LessonsTest, AGuessStaysOnTheAxis) {
  lessons().start(sampleWithPoint(true), 1);
  PredictionPoint& point = lessons().point();
  ASSERT_TRUE(waitFor([&] { return point.isVisible() && chart().y.to == 1; }));
  ASSERT_TRUE(waitFor([&] { return session().friction().progress() >= 1; }));
  const std::shared_ptr<const Frame> before = session().frame();
  ASSERT_TRUE(waitFor([&] { return session().frame() != before; }));
  EXPECT_FALSE(said("factMu").contains("mean"));
  const QPoint beside = window_.plotView().mapToPosition(0.1, 1).toPoint() - QPoint(0, 15);
  QTest::mouseClick(&point, Qt::LeftButton, {}, beside);
  EXPECT_FALSE(point.point());  // the legend is no place for an answer
  const QPoint high = window_.plotView().mapToPosition(0.1, 0.8).toPoint();
  QTest::mouseClick(&point, Qt::LeftButton, {}, high);
  ASSERT_TRUE(point.point());
  click("lessonNext");
  ASSERT_TRUE(waitForAnswer());
  ASSERT_TRUE(waitFor([&] { return showsCurve(); }));
  EXPECT_LE(chart().y.from, 1e-6);
  EXPECT_EQ(chart().y.to, 1);
  click("lessonBack");
  ASSERT_TRUE(waitFor([&] { return chart().y.to < 1; }));
}

TEST_F(LessonsTest, AWrongNumberStaysInSightAndTheScoreIsAboveTheButtons) {
  lessons().start(lessonOf(sampleLesson()), 1);
  EXPECT_FALSE(control<QLabel>("lessonScore").isVisible());
  QTest::keyClicks(&control<QLineEdit>("lessonNumber"), "7 um");
  click("lessonNext");
  ASSERT_TRUE(waitForAnswer());
  EXPECT_TRUE(said("lessonVerdict").contains("You said 7")) << said("lessonVerdict").toStdString();
  EXPECT_TRUE(said("lessonScore").contains("You were right in 0 of 2 predictions."));
}

TEST_F(LessonsTest, AWrongPointIsNamedWithWhatIsWrongOfIt) {
  LessonPane pane;
  const auto verdict = [&pane](bool hasPlace, double x, double y) {
    const Lesson lesson = sampleWithPoint(hasPlace);
    const LessonAnswer answer{{0.5, ""}, {0.1, "m/s"}, -1, {}};
    const GivenAnswer given{-1, y, x};
    LessonPage page;
    page.lesson = &lesson;
    page.step = 1;
    page.answer = &answer;
    page.given = &given;
    page.isRight = isRight(*lesson.steps[1].prediction, answer, given);
    pane.showStep(page);
    return pane.findChild<QLabel*>("lessonVerdict")->text().toStdString();
  };
  using testing::HasSubstr;
  EXPECT_THAT(verdict(false, 5, 0.5), HasSubstr("at 5"));
  EXPECT_THAT(verdict(false, 5, 0.5), HasSubstr("The height is right, the place is not."));
  EXPECT_THAT(verdict(false, 0.1, 9), HasSubstr("You said 9 at "));
  EXPECT_THAT(verdict(false, 0.1, 9), HasSubstr("The place is right, the height is not."));
  EXPECT_THAT(verdict(false, 5, 9), HasSubstr("Neither the place nor the height is right."));
  EXPECT_THAT(verdict(false, 0.1, 0.5), Not(HasSubstr("place")));
  EXPECT_THAT(verdict(true, 0.1, 9), HasSubstr("You said 9."));
  EXPECT_THAT(verdict(true, 0.1, 9), HasSubstr("The program finds 0.5."));
}

/// A person who was right, or nearly, wants to know how near.
TEST_F(LessonsTest, AReplySaysWhatTheProgramFindsUnlessItsTextDoes) {
  LessonPrediction point;
  point.kind = PredictionKind::Point;
  point.right = {"That is the place.", ""};
  point.wrong = {"It is {answer}.", ""};
  const LessonAnswer answer{{0.0018, ""}, {0.0981, "m/s"}, 1, {}};
  const GivenAnswer near{-1, 0.00137, 0.0917};
  const auto says = [&](const LessonPrediction& prediction, const GivenAnswer& given,
                        bool isRight) {
    return QTextDocumentFragment::fromHtml(verdictText(prediction, answer, given, isRight))
        .toPlainText()
        .replace(QChar::Nbsp, ' ')
        .toStdString();
  };
  EXPECT_EQ(says(point, near, true),
            "✓ Right\nYou said 0.00137 at 91.7 mm/s. The program finds 0.0018 at 98.1 mm/s.\n"
            "That is the place.");
  EXPECT_THAT(says(point, near, false), testing::Not(testing::HasSubstr("The program finds")));
  LessonPrediction choice;
  choice.choices.resize(2);
  choice.answer.emplace();
  EXPECT_EQ(says(choice, {0}, false), "✗ No\nThe program finds 0.0018.");
  choice.wrong = {"It stays the same.", ""};
  EXPECT_EQ(says(choice, {0}, false), "✗ No\nIt stays the same.");
  choice.answer.reset();
  EXPECT_EQ(says(choice, {1}, true), "✓ Right");
}

TEST_F(LessonsTest, WhatIsShownIsSaidMarkedAndNoWrongAnswer) {
  for (const bool hasPlace : {true, false}) {
    lessons().start(sampleWithPoint(hasPlace), 1);
    click("lessonShow");
    ASSERT_TRUE(waitForAnswer());
    EXPECT_TRUE(said("lessonVerdict").contains("The program finds"));
    EXPECT_TRUE(said("lessonScore").contains("; 1 was shown to you."));
    PredictionPoint& point = lessons().point();
    EXPECT_TRUE(point.isVisible());
    EXPECT_EQ(point.point()->y(), lessons().results().find(1)->expected.number.value);
    lessons().end();
  }
}

TEST_F(LessonsTest, ALessonBeginsWithAPictureThatMoves) {
  session().setPlaying(false);
  lessons().start(lessonOf(sampleLesson()));
  EXPECT_TRUE(session().isPlaying());
}

TEST_F(LessonsTest, TheListSaysWhatEachTeachesAndBeginsIt) {
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
  ASSERT_TRUE(lessons().isRunning());
  EXPECT_EQ(lessons().lesson()->name, "load_and_friction");
}

TEST_F(LessonsTest, TheListTriesAnswersThatFailedAgain) {
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

TEST_F(LessonsTest, TheListShowsAnotherLessonFromItsBeginning) {
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

TEST_F(LessonsTest, AWrongFileIsOneMessage) {
  TemporaryFolder folder;
  folder.write("wrong.json", "{\"schema\": \"asperity-lesson/1\"}");
  EXPECT_FALSE(lessons().open(QString::fromStdString((folder / "wrong.json").string())));
  EXPECT_TRUE(window_.messages().text().contains("title"));
  EXPECT_FALSE(lessons().isRunning());
}

TEST_F(LessonsTest, ATeacherAddsAStepFromWhatIsShown) {
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
TEST_F(LessonsTest, ATeacherWritesALessonOfThreeStepsAndTriesIt) {
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
    EXPECT_EQ(lessons().step(), step);
    click("lessonShow");
    ASSERT_TRUE(waitForAnswer());
    click("lessonNext");
  }
  EXPECT_TRUE(editor.isVisible());
}

TEST_F(LessonsTest, TheEditorStepsAsideForAStepThatIsTried) {
  LessonEditor& editor = lessons().showEditor(lessonOf(sampleLesson()), {});
  emit editor.trialRequested(lessonOf(sampleLesson()), 1);
  EXPECT_EQ(lessons().step(), 1);
  EXPECT_FALSE(editor.isVisible());
  lessons().end();
  EXPECT_TRUE(editor.isVisible());
}

TEST_F(LessonsTest, ATrialCountsOnlyWhatWasTried) {
  LessonEditor& editor = lessons().showEditor(lessonOf(sampleLesson()), {});
  emit editor.trialRequested(lessonOf(sampleLesson()), 1);
  click("lessonShow");
  ASSERT_TRUE(waitForAnswer());
  EXPECT_TRUE(said("lessonScore").contains("You were right in 0 of 1 predictions"))
      << said("lessonReveal").toStdString();
}

TEST_F(LessonsTest, AnUnsavedLessonInTheEditorOutlivesACrash) {
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

TEST_F(LessonsTest, ALessonThatIsSavedOrDiscardedIsNoDraft) {
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
TEST_F(LessonsTest, TheWindowAsksAboutTheLessonInTheEditorBeforeItCloses) {
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
TEST_F(LessonsTest, AnotherLanguageDoesNotLoseTheLessonInTheEditor) {
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

/// A lesson is dropped on the window like any other file.
TEST_F(LessonsTest, ADroppedLessonStarts) {
  TemporaryFolder folder;
  folder.write("mine.json", writeLesson(lessonOf(sampleLesson())));
  drop(QString::fromStdString((folder / "mine.json").string()));
  EXPECT_TRUE(waitFor([this] { return lessons().isRunning(); }));
}

/// A teacher opens the file of a student like any other file.
TEST_F(LessonsTest, AStudentsResultsAreShownInWords) {
  TemporaryFolder folder;
  const Lesson lesson = readNamedLesson("load_and_friction", readNamedScene);
  LessonResults results = emptyResults(lesson);
  results.date = "2026-11-27T10:00:00";
  LessonResult one;
  one.step = 1;
  one.given.choice = 0;
  one.expected.choice = 1;
  results.set(one);
  writeResults(folder / "ada.json", results, lesson);
  const QString file = QString::fromStdString((folder / "ada.json").string());
  window_.documentCommands().openFile(file);
  const auto* dialog = window_.findChild<QDialog*>("lessonResults");
  ASSERT_NE(dialog, nullptr);
  const auto& table = *dialog->findChild<QTextBrowser*>("lessonResultsTable");
  const QString text = table.toPlainText();
  const LessonPrediction& asked = *lesson.steps[1].prediction;
  for (const QString& part :
       {plainText(lesson.title), plainText(asked.question), plainText(asked.choices[0].text),
        plainText(asked.choices[1].text), QStringLiteral("0 right, 1 wrong, 0 shown"),
        QStringLiteral("11/27/26"), QStringLiteral("ada.json")})
    EXPECT_TRUE(text.contains(part)) << part.toStdString() << text.toStdString();
  EXPECT_FALSE(window_.messages().isVisible());
  auto* goOn = dialog->findChild<QPushButton*>("resultsGoOn");
  ASSERT_NE(goOn, nullptr);
  EXPECT_TRUE(goOn->isDefault()) << "it is the first button, which the Enter key presses";
  goOn->click();
  ASSERT_TRUE(lessons().isRunning());
  EXPECT_EQ(lessons().step(), 1);
  EXPECT_TRUE(lessons().isRevealed());
}

/// Of a long lesson, too: a screen of 1024 x 700 pixels does not hold its table.
TEST_F(LessonsTest, TheResultsOfALongLessonAreScrolledTo) {
  TemporaryFolder folder;
  const Lesson lesson = readNamedLesson("load_and_friction", readNamedScene);
  LessonResults results = emptyResults(lesson);
  for (int step = 0; step < 60; ++step) {
    LessonResult one;
    one.step = step;
    one.given.choice = 0;
    one.expected.choice = 1;
    results.set(one);
  }
  folder.write("ada.json", resultsJson(results));
  showLessonResults(window_, QString::fromStdString((folder / "ada.json").string()));
  const auto& dialog = control<QDialog>("lessonResults");
  const auto* table = dialog.findChild<QTextBrowser*>("lessonResultsTable");
  ASSERT_NE(table, nullptr);
  EXPECT_LE(dialog.height(), dialog.screen()->availableSize().height());
  EXPECT_TRUE(waitFor([&] { return table->verticalScrollBar()->maximum() > 0; }));
}

/// Of a lesson that the program does not know as well.
TEST_F(LessonsTest, ThePlaceOfAPointInResultsHasItsUnit) {
  for (const Lesson& lesson :
       {readNamedLesson("rubber_is_not_coulomb", readNamedScene), sampleWithPoint(false)}) {
    const auto step = std::ranges::find_if(lesson.steps, [](const LessonStep& each) {
      return each.prediction && each.prediction->kind == PredictionKind::Point &&
             !each.prediction->x;
    });
    ASSERT_NE(step, lesson.steps.end());
    TemporaryFolder folder;
    LessonResults results = emptyResults(lesson);
    LessonResult one;
    one.step = static_cast<int>(step - lesson.steps.begin());
    one.kind = PredictionKind::Point;
    one.given.number = 0.25;
    one.given.x = 0.01;
    one.expected.number = {0.5, ""};
    one.expected.x = {0.03, "m/s"};
    results.set(one);
    writeResults(folder / "ada.json", results, lesson);
    const QString html =
        LessonResultsPage::html(QString::fromStdString((folder / "ada.json").string()));
    EXPECT_TRUE(html.contains("0.25 at 10 mm/s")) << html.toStdString();
    EXPECT_TRUE(html.contains("0.5 at 30 mm/s")) << html.toStdString();
  }
}

/// Texts of lessons speak of the glow of the pressure, whatever the user had chosen before.
TEST_F(LessonsTest, ShowsThePressureAndGivesTheChosenColoursBack) {
  auto& canvas = *window_.findChild<ContactCanvas*>();
  canvas.setOverlay(ContactOverlay::Power);
  lessons().start(lessonOf(sampleLesson()));
  EXPECT_EQ(canvas.viewer().overlay(), ContactOverlay::Pressure);
  lessons().end();
  EXPECT_EQ(canvas.viewer().overlay(), ContactOverlay::Power);
}

TEST_F(LessonsTest, AClassIsATable) {
  TemporaryFolder folder;
  const Lesson lesson = readNamedLesson("load_and_friction", readNamedScene);
  QStringList files;
  for (const char* student : {"ada.json", "bo.json"}) {
    LessonResults results = emptyResults(lesson);
    LessonResult one;
    one.step = 1;
    one.given.choice = files.isEmpty() ? 0 : 1;
    one.expected.choice = 1;
    one.isRight = !files.isEmpty();
    results.set(one);
    writeResults(folder / student, results, lesson);
    files += QString::fromStdString((folder / student).string());
  }
  chooseFiles("\"" + files.join("\" \"") + "\"");
  action("classTable").trigger();
  const auto* dialog = window_.findChild<QDialog*>("classResults");
  ASSERT_NE(dialog, nullptr);
  const QString text = dialog->findChild<QTextBrowser*>("classResultsTable")->toPlainText();
  for (const QString& part :
       {plainText(lesson.title), QStringLiteral("ada.json"), QStringLiteral("bo.json"),
        QStringLiteral("Step 2"), QStringLiteral("wrong (choice 1)"),
        QStringLiteral("right (choice 2)")})
    EXPECT_TRUE(text.contains(part)) << part.toStdString() << text.toStdString();

  // The file is that of the command line.
  const std::filesystem::path table = folder / "class.csv";
  chooseFiles(QString::fromStdString(table.string()));
  click("saveClassTable");
  const ClassResults results = readClasses({files[0].toStdString(), files[1].toStdString()});
  EXPECT_EQ(TemporaryFolder::read(table), classCsv(onlyClass(results)));
  EXPECT_EQ(said("classResultsStatus"), "Saved class.csv");
  chooseFiles(QString::fromStdString((folder / "class.txt").string()));
  click("saveClassTable");
  EXPECT_TRUE(said("classResultsStatus").contains(".csv"))
      << said("classResultsStatus").toStdString();
  EXPECT_FALSE(std::filesystem::exists(folder / "class.txt"));
}

TEST_F(LessonsTest, ATableIsOfOneLesson) {
  TemporaryFolder folder;
  QStringList files;
  for (const char* name : {"load_and_friction", "what_the_mesh_does"}) {
    const Lesson lesson = readNamedLesson(name, readNamedScene);
    const std::filesystem::path file = folder / (std::string(name) + ".json");
    writeResults(file, emptyResults(lesson), lesson);
    files += QString::fromStdString(file.string());
  }
  ASSERT_TRUE(lessons().openResults(files));
  click("saveClassTable");
  EXPECT_TRUE(said("classResultsStatus").contains("what_the_mesh_does.json"))
      << said("classResultsStatus").toStdString();
}

/// The others are shown, and the table says which file it lacks and why.
TEST_F(LessonsTest, AFileWithoutResultsDoesNotRefuseTheClass) {
  TemporaryFolder folder;
  const Lesson lesson = readNamedLesson("load_and_friction", readNamedScene);
  writeResults(folder / "ada.json", emptyResults(lesson), lesson);
  folder.write("lesson.json", writeLesson(lesson));
  folder.write("torn.json", R"({"schema": "asperity-lesson-results/1", "lesson": )");
  const auto path = [&](const char* name) {
    return QString::fromStdString((folder / name).string());
  };
  ASSERT_TRUE(lessons().openResults(
      {path("ada.json"), path("lesson.json"), path("torn.json"), path("none.json")}));
  const auto* dialog = window_.findChild<QDialog*>("classResults");
  ASSERT_NE(dialog, nullptr);
  const QString text = dialog->findChild<QTextBrowser*>("classResultsTable")->toPlainText();
  for (const char* part :
       {"ada.json", "lesson.json: has no results of a lesson", "torn.json: ", "none.json: "})
    EXPECT_TRUE(text.contains(part)) << part << text.toStdString();
  EXPECT_FALSE(window_.messages().isVisible());
  EXPECT_FALSE(lessons().openResults({path("lesson.json"), path("none.json")}));
  EXPECT_TRUE(window_.messages().text().contains("lesson.json: has no results of a lesson"));
}

/// The scene behind the gallery is not what the teacher sees.
TEST_F(LessonsTest, NoStepIsTakenFromTheGallery) {
  window_.openGallery();
  LessonEditor& editor = lessons().showEditor({}, {});
  editor.addShownStep();
  EXPECT_TRUE(editor.lesson().steps.empty());
  EXPECT_TRUE(editor.findChild<QLabel*>("editorComplaint")->text().contains("gallery"));
}

TEST_F(LessonsTest, TheWindowAsksAboutAnEditorThatATrialHides) {
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
TEST_F(LessonsTest, TheOpenEditorComesBackWithItsLesson) {
  LessonEditor& editor = lessons().showEditor(lessonOf(sampleLesson()), {});
  auto& title = *editor.findChild<QLineEdit*>("editorTitle");
  title.selectAll();
  QTest::keyClicks(&title, "Mine");
  emit editor.trialRequested(editor.lesson(), 0);
  ASSERT_FALSE(editor.isVisible());
  QTest::mouseClick(&control<QAbstractButton>("lessonEnd"), Qt::LeftButton);
  EXPECT_FALSE(lessons().isRunning());
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
TEST_F(LessonsTest, StepsKeepTheirScenesWhereTheyAreMovedAndRemoved) {
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

TEST_F(LessonsTest, TheEditorSaysWhatIsWrongAndWhere) {
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
  EXPECT_EQ(lessons().step(), 1);
  EXPECT_EQ(session().scene().load.normalForce, 0.03);
}

/// A parameter is chosen from a menu in plain words and has its present value, which is edited; a
/// word is chosen from a list. A change is removed by its button.
TEST_F(LessonsTest, TheEditorChangesParametersInPlainWords) {
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
TEST_F(LessonsTest, TheEditorSpeaksNoJson) {
  const QRegularExpression code(QStringLiteral(R"([a-z]_[a-z]|[a-z]\.[a-z]|=)"));
  for (const ShippedLesson& shipped : shippedLessons()) {
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

TEST_F(LessonsTest, TheEditorSaysWhatTheStepShowsAndLocks) {
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
TEST_F(LessonsTest, TheEditorLosesNothingOfALesson) {
  for (const ShippedLesson& shipped : shippedLessons()) {
    const Lesson lesson = readNamedLesson(std::string(shipped.name), readNamedScene);
    LessonEditor& editor = lessons().showEditor(lesson, {});
    auto& steps = *editor.findChild<QListWidget*>("editorSteps");
    for (int row = 0; row < steps.count(); ++row) steps.setCurrentRow(row);
    EXPECT_EQ(writeLesson(editor.lesson()), writeLesson(lesson)) << shipped.name;
    EXPECT_TRUE(editor.canClose());
  }
}

/// An exponent is chosen, with its key and two values of it in any unit; what is refused is said.
TEST_F(LessonsTest, TheEditorWritesExponents) {
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
TEST_F(LessonsTest, AnEditKeepsWhatTheRowsDoNotShow) {
  for (const ShippedLesson& shipped : shippedLessons()) {
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

TEST(LessonTexts, MarkupBecomesHtmlAndNothingElseDoes) {
  EXPECT_EQ(richText("A *b* and **c**.\n\nD < 2 * 3 * 4"),
            "<p>A <i>b</i> and <b>c</b>.</p><p>D &lt; 2 * 3 * 4</p>");
  EXPECT_EQ(richText("See:\n- one\n- *two*"),
            "<p>See:</p><ul><li>one</li><li><i>two</i></li></ul>");
  EXPECT_EQ(richText("<b>x</b>"), "<p>&lt;b&gt;x&lt;/b&gt;</p>");
  // A number stays with its unit; other words may be parted.
  EXPECT_EQ(richText("H = 0.7"), QStringLiteral("<p>H\u00A0=\u00A00.7</p>"));
  EXPECT_EQ(richText("at 3 mm/s, 70 °C, 40 lines"),
            QStringLiteral("<p>at 3\u00A0mm/\u2060s, 70\u00A0°C, 40 lines</p>"));
}

TEST(Handouts, StudentsGetQuestionsAndTeachersAnswers) {
  const Lesson lesson = lessonOf(sampleLesson());
  HandoutOptions options;
  const QByteArray students = handoutHtml(lesson, options);
  options.forTeacher = true;
  const QByteArray teachers = handoutHtml(lesson, options);
  for (const QByteArray& page : {students, teachers}) {
    EXPECT_TRUE(page.contains("Twice as fast?"));
    EXPECT_TRUE(page.contains("data:image/png;base64,"));
    EXPECT_FALSE(page.contains("http"));
  }
  EXPECT_FALSE(students.contains("Answer:"));
  EXPECT_FALSE(students.contains("<p>One.</p>"));
  EXPECT_TRUE(teachers.contains("Answer:"));
  EXPECT_TRUE(teachers.contains("<p>One.</p>"));
  EXPECT_GT(teachers.count("<img"), students.count("<img"));
  EXPECT_TRUE(teachers.contains("After the answer to step 1"));  // above its picture
  EXPECT_TRUE(students.contains("Name: ___"));
  EXPECT_FALSE(teachers.contains("Name: ___"));
  EXPECT_EQ(handoutHtml(lesson, options), teachers);
}

/// The next step begins with what the answer made of the scene: printed, it would be the answer.
TEST(Handouts, NoPictureBelowAQuestionTellsItsAnswer) {
  Json json = sampleLesson();
  json["steps"][1].erase("set");
  EXPECT_EQ(handoutHtml(lessonOf(json), {}).count("<img"), 2);  // contact and chart of the first
}

TEST(Handouts, ACurveThatWasAskedForIsNotPrintedBelowTheNextStep) {
  Json json = sampleLesson();
  json["steps"][0]["show"]["curve"] = "hidden";
  json["steps"][1].erase("set");
  EXPECT_FALSE(handoutHtml(lessonOf(json), {}).contains("alt=\"the friction curve"));
  HandoutOptions teacher;
  teacher.forTeacher = true;
  EXPECT_TRUE(handoutHtml(lessonOf(json), teacher).contains("alt=\"the friction curve"));
}

/// A choice needs no chart, and a curve that is to be guessed is not printed.
TEST(Handouts, AnEmptyChartStandsWhereAPointIsDrawn) {
  Json json = sampleLesson();
  json["steps"][0]["show"]["curve"] = "hidden";
  json["steps"][1]["prediction"] = {{"kind", "point"}, {"question", "Where?"}, {"x", 0.1}};
  const QByteArray beside = handoutHtml(lessonOf(json), {});
  EXPECT_EQ(beside.count("alt=\"a chart of friction, to draw into, with the curve for "), 1);
  json["steps"][1]["show"].erase("beside");
  const QByteArray html = handoutHtml(lessonOf(json), {});
  EXPECT_EQ(html.count("an empty chart of friction"), 1);
  EXPECT_GT(html.indexOf("an empty chart of friction"), html.indexOf("Second"));
  EXPECT_LT(html.indexOf("an empty chart of friction"), html.indexOf("Where?"));
  EXPECT_FALSE(html.contains("alt=\"the friction curve"));
}

/// As on the screen, where the state of the step is marked in the empty chart.
TEST(Handouts, AnEmptyChartHasTheStateFromWhichAGuessBegins) {
  Json json = sampleLesson();
  json["steps"][1]["prediction"] = {{"kind", "point"}, {"question", "Where?"}, {"x", 0.1}};
  json["steps"][1]["show"].erase("beside");
  for (const HandoutBlock& block : handoutBlocks(lessonOf(json), {})) {
    if (!block.picture || !block.picture->name.startsWith("an empty chart")) continue;
    const QImage& image = block.picture->image;
    int coloured = 0;  // lines and letters of the axes are grey
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x)
        coloured += image.pixelColor(x, y).saturation() > 100 ? 1 : 0;
    EXPECT_GT(coloured, 100);
    return;
  }
  FAIL() << "there is no empty chart";
}

/// The same curve on another axis is another picture.
TEST(Handouts, ACurveIsPrintedAgainOnALinearAxis) {
  Json json = sampleLesson();
  json["steps"][1] = {{"text", "Again."}};
  const auto charts = [&json] {
    return handoutHtml(lessonOf(json), {}).count("alt=\"the friction curve");
  };
  const qsizetype before = charts();
  json["steps"][1]["show"]["scale"] = "linear";
  EXPECT_EQ(charts(), before + 1);
}

TEST(Handouts, PdfIsWholeAndTheSameEveryTime) {
  const Lesson lesson = lessonOf(sampleLesson());
  const QByteArray pdf = handoutPdf(lesson);
  EXPECT_TRUE(pdf.startsWith("%PDF-"));
  EXPECT_TRUE(pdf.trimmed().endsWith("%%EOF"));
  EXPECT_FALSE(pdf.contains("CreationDate"));
  EXPECT_EQ(handoutPdf(lesson), pdf);
}

/// The line of the chart follows the pointer no farther than the velocity does.
TEST_F(LessonsTest, TheLineOfALockedVelocityStaysWithIt) {
  lessons().start(lessonOf(sampleLesson()));
  const Scene shown = session().scene();
  ASSERT_TRUE(
      waitFor([&] { return chart().marker && chart().marker->x == shown.sliding.velocity; }));
  ChartView& plot = window_.plotView();
  QTest::keyClick(&plot, Qt::Key_Right);  // as a drag does
  EXPECT_GT(plot.lineValue(), shown.sliding.velocity);
  ASSERT_TRUE(waitFor([&] { return session().scene() == shown; }));
  ASSERT_TRUE(waitFor([&] { return said("lessonNote").contains("guess"); }));
  EXPECT_TRUE(waitFor([&] { return plot.lineValue() == shown.sliding.velocity; }));
}

}  // namespace
}  // namespace asperity
