// Steps of lessons in the window, as a student works through them by mouse and by keyboard: what is
// asked, hidden, locked and revealed.
#include "ui/window/lesson/lesson_player.h"
#include "ui/panels/labels.h"

#include <gmock/gmock.h>

#include <QDockWidget>
#include <QLineEdit>
#include <QMenu>
#include <QRadioButton>
#include <QTextDocumentFragment>
#include <QThread>
#include <array>
#include <atomic>

#include "core/base/stop.h"
#include "tests/core/temporary_folder.h"
#include "tests/ui/window/lesson/lessons_fixture.h"
#include "ui/language/language.h"
#include "ui/window/lesson/lesson_pane.h"
#include "ui/window/lesson/lesson_text.h"
#include "ui/window/lesson/prediction_point.h"
#include "ui/window/main/scene_library.h"
#include "ui/window/main/scene_tabs.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

class LessonPlayerTest : public LessonsTest {};

TEST_F(LessonPlayerTest, AsksRevealsAndFreesWhatTheStepSays) {
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
  EXPECT_EQ(player().results().right(), 1);
}

TEST_F(LessonPlayerTest, AButtonIsPressedByReturnThoughItIsNotTheOneThatLeadsOn) {
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  lessons().start(lessonOf(sampleLesson()));
  control<QRadioButton>("lessonChoice:0").click();
  button("lessonShow").setFocus();
  QTest::keyClick(window_.windowHandle(), Qt::Key_Return);
  ASSERT_TRUE(waitForAnswer());
  EXPECT_FALSE(player().results().find(0)->given.isGiven());
}

/// Where the focus goes with a step, a screen reader says what the step asks or tells.
TEST_F(LessonPlayerTest, AListenerHearsTheQuestionWithTheFirstAnswer) {
  Json json = sampleLesson();
  json["steps"].push_back({{"text", "All is *said*."}});
  lessons().start(lessonOf(json));
  EXPECT_EQ(control<QRadioButton>("lessonChoice:0").accessibleDescription(), "Twice as fast?");
  EXPECT_EQ(control<QRadioButton>("lessonChoice:1").accessibleDescription(), "");
  player().show(1);
  EXPECT_EQ(control<QLineEdit>("lessonNumber").accessibleDescription(), "Indentation?");
  player().show(2);
  EXPECT_TRUE(button("lessonNext").accessibleDescription().startsWith("All is said."));
  QTest::qWait(0);  // the fields of the former steps go, of which one had the focus
}

/// The window may be painted before any other event: the question and its fields are in their
/// places as soon as the step is shown.
TEST_F(LessonPlayerTest, AQuestionIsNeverSeenWithoutItsFields) {
  lessons().start(lessonOf(sampleLesson()));
  auto& question = control<QLabel>("lessonQuestion");
  ASSERT_TRUE(waitFor([&] { return question.isVisible() && question.y() > 0; }));
  const auto top = [&](const char* name) {
    return control<QWidget>(name).mapTo(question.parentWidget(), QPoint()).y();
  };
  player().show(1);
  EXPECT_TRUE(control<QWidget>("lessonNumber").isVisible());
  EXPECT_GT(top("lessonNumber"), question.geometry().bottom());
  player().show(0);
  EXPECT_TRUE(control<QWidget>("lessonChoice:0").isVisible());
  EXPECT_GT(top("lessonChoice:0"), question.geometry().bottom());
  EXPECT_GT(top("lessonChoice:1"), top("lessonChoice:0"));
  QTest::qWait(0);  // the fields of the former steps go, of which one had the focus
}

TEST_F(LessonPlayerTest, TheTabKeyGoesFromTheQuestionToTheAnswerAndOn) {
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
TEST_F(LessonPlayerTest, ACurveStaysHiddenWhereTheStepSaysSo) {
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
TEST_F(LessonPlayerTest, ACurveHasTheScaleOfItsStep) {
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

TEST_F(LessonPlayerTest, WhatIsLockedStaysAndWhatIsFreeMoves) {
  lessons().start(lessonOf(sampleLesson()));
  const Scene shown = session().scene();
  Scene changed = shown;
  changed.sliding.velocity = 3;
  window_.document().edit(changed);  // as the marker of the chart does
  ASSERT_TRUE(waitFor([&] { return session().scene() == shown; }));
  EXPECT_TRUE(said("lessonNote").contains("guess"));
  click("lessonShow");
  ASSERT_TRUE(waitForAnswer());
  EXPECT_FALSE(player().results().find(0)->given.isGiven());
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

TEST_F(LessonPlayerTest, ANoteIsScrolledTo) {
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

TEST_F(LessonPlayerTest, ALongWordOfTheTitleIsShortenedWithDots) {
  Json json = sampleLesson();
  json["title"] = "Of " + std::string(300, 'M');
  lessons().start(lessonOf(json));
  const auto& title = dynamic_cast<WrappedLabel&>(control<QLabel>("lessonTitle"));
  EXPECT_TRUE(waitFor([&] { return title.shownText().endsWith(u'…'); }));
  EXPECT_TRUE(title.shownText().startsWith("Of MM"));
  EXPECT_EQ(title.text().size(), 303);
}

/// Many per cent are said as what they mean.
TEST_F(LessonPlayerTest, ANumberSaysHowNearItHasToBe) {
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

TEST_F(LessonPlayerTest, EveryShippedLessonIsWalkedThrough) {
  for (const ShippedFile& shipped : shippedLessons()) {
    SCOPED_TRACE(std::string(shipped.name));
    ASSERT_TRUE(lessons().open(
        QString::fromUtf8(shipped.name.data(), static_cast<qsizetype>(shipped.name.size()))));
    const auto steps = static_cast<int>(player().lesson()->steps.size());
    for (int step = 0; step < steps; ++step) {
      EXPECT_EQ(player().step(), step);
      ASSERT_TRUE(waitForFrame());
      EXPECT_TRUE(frameError(*frame()).empty()) << step;
      if (!player().isRevealed()) {
        click("lessonShow");
        ASSERT_TRUE(waitForAnswer()) << step;
      }
      for (const char* text : {"lessonText", "lessonReveal", "lessonVerdict"})
        EXPECT_FALSE(said(text).contains('{')) << said(text).toStdString();
      EXPECT_FALSE(window_.messages().isVisible()) << window_.messages().text().toStdString();
      click("lessonNext");
    }
    EXPECT_FALSE(player().isRunning());
  }
}

TEST_F(LessonPlayerTest, GoesForwardAndBackByKeys) {
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  lessons().start(lessonOf(sampleLesson()));
  QTest::keyClick(&window_, Qt::Key_Right, Qt::ControlModifier | Qt::AltModifier);
  EXPECT_EQ(player().step(), 0);  // first the guess
  click("lessonShow");
  ASSERT_TRUE(waitForAnswer());
  QTest::keyClick(&window_, Qt::Key_Right, Qt::ControlModifier | Qt::AltModifier);
  EXPECT_EQ(player().step(), 1);
  QTest::keyClick(&window_, Qt::Key_Left, Qt::ControlModifier | Qt::AltModifier);
  EXPECT_EQ(player().step(), 0);
  EXPECT_TRUE(player().isRevealed());  // what was answered stays answered
}

/// Whoever answers soon does not wait longer.
TEST_F(LessonPlayerTest, AnAnswerIsComputedOnce) {
  std::atomic<int> calls = 0;
  std::atomic<bool> mayEnd = false;
  player().setAnswerFunction([&](const LessonStep& step, const CurveOptions& options) {
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

TEST_F(LessonPlayerTest, WhatWasLockedInAStepIsNotBroughtIntoTheNext) {
  lessons().start(lessonOf(sampleLesson()));
  Scene changed = session().scene();
  changed.load.normalForce *= 3;
  window_.document().edit(changed);
  player().show(1);
  const Scene second = session().scene();
  QTest::qWait(50);
  EXPECT_EQ(session().scene(), second);
}

TEST_F(LessonPlayerTest, AStepBringsItsTabToTheFront) {
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

TEST_F(LessonPlayerTest, AHiddenCurveIsSeenNeitherInOtherTabsNorInReadings) {
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

TEST_F(LessonPlayerTest, AWrongNumberStaysInSightAndTheScoreIsAboveTheButtons) {
  lessons().start(lessonOf(sampleLesson()), 1);
  EXPECT_FALSE(control<QLabel>("lessonScore").isVisible());
  QTest::keyClicks(&control<QLineEdit>("lessonNumber"), "7 um");
  click("lessonNext");
  ASSERT_TRUE(waitForAnswer());
  EXPECT_TRUE(said("lessonVerdict").contains("You said 7")) << said("lessonVerdict").toStdString();
  EXPECT_TRUE(said("lessonScore").contains("You were right in 0 of 2 predictions."));
}

/// A person who was right, or nearly, wants to know how near.
TEST_F(LessonPlayerTest, AReplySaysWhatTheProgramFindsUnlessItsTextDoes) {
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

TEST_F(LessonPlayerTest, WhatIsShownIsSaidMarkedAndNoWrongAnswer) {
  for (const bool hasPlace : {true, false}) {
    lessons().start(sampleWithPoint(hasPlace), 1);
    click("lessonShow");
    ASSERT_TRUE(waitForAnswer());
    EXPECT_TRUE(said("lessonVerdict").contains("The program finds"));
    EXPECT_TRUE(said("lessonScore").contains("; 1 was shown to you."));
    PredictionPoint& point = player().point();
    EXPECT_TRUE(point.isVisible());
    EXPECT_EQ(point.point()->y(), player().results().find(1)->expected.number.value);
    lessons().end();
  }
}

TEST_F(LessonPlayerTest, ALessonBeginsWithAPictureThatMoves) {
  session().setPlaying(false);
  lessons().start(lessonOf(sampleLesson()));
  EXPECT_TRUE(session().isPlaying());
}

/// Texts of lessons speak of the glow of the pressure, whatever the user had chosen before.
TEST_F(LessonPlayerTest, ShowsThePressureAndGivesTheChosenColoursBack) {
  auto& canvas = *window_.findChild<ContactCanvas*>();
  canvas.setOverlay(ContactOverlay::Power);
  lessons().start(lessonOf(sampleLesson()));
  EXPECT_EQ(canvas.viewer().overlay(), ContactOverlay::Pressure);
  lessons().end();
  EXPECT_EQ(canvas.viewer().overlay(), ContactOverlay::Power);
}

/// No step speaks of the difference that the student had chosen to see before.
TEST_F(LessonPlayerTest, AComparisonPausesDuringALesson) {
  auto& compares = control<QAbstractButton>("comparisonWanted");
  compares.setChecked(true);
  lessons().start(lessonOf(sampleLesson()));
  EXPECT_FALSE(compares.isChecked());
  lessons().end();
  EXPECT_TRUE(compares.isChecked());
}

/// The line of the chart follows the pointer no farther than the velocity does.
TEST_F(LessonPlayerTest, TheLineOfALockedVelocityStaysWithIt) {
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
