// The window as a person uses it, with the real runner behind it. Under the offscreen platform
// there is no OpenGL: the program itself draws.
#include "ui/window/main/main_window.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QCursor>
#include <QEnterEvent>
#include <QLabel>
#include <QMenu>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <algorithm>
#include <memory>
#include <set>
#include <vector>

#include "core/scene/plan.h"
#include "core/scene/provenance.h"
#include "core/scene/scene_file.h"
#include "tests/ui/window/main_window_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "ui/chart/chart_view.h"
#include "ui/chart/diagram_style.h"
#include "ui/language/translated.h"
#include "ui/panels/parameter_panel.h"
#include "ui/panels/value_entry.h"
#include "ui/panels/value_slider.h"
#include "ui/window/contact/contact_canvas.h"
#include "ui/window/figures/diagram_view.h"
#include "ui/window/main/appearance.h"
#include "ui/window/main/message_bar.h"
#include "ui/window/main/scene_library.h"
#include "ui/window/main/session.h"

namespace asperity {
namespace {

TEST_F(MainWindowTest, ASliderBringsOneSceneToTheWorkerAndItsFrameBack) {
  ASSERT_TRUE(waitForFrame());
  const std::uint64_t before = session().sceneNumber();
  QTest::keyClick(&control<ValueSlider>("slider:load.normal_force"), Qt::Key_Right);
  EXPECT_EQ(session().sceneNumber(), before + 1);
  ASSERT_TRUE(waitForFrame());
  EXPECT_GT(frame()->scene->load.normalForce, smallScene().load.normalForce);
  EXPECT_EQ(*frame()->scene, window_.panel().scene());
  EXPECT_EQ(session().sceneNumber(), before + 1);
}

/// The pointer leaves the button while its menu is open, and Escape closes the menu.
TEST_F(MainWindowTest, TheButtonOfTheScenesIsNotLitAfterItsMenuWasClosed) {
  auto& button = control<QToolButton>("scenesButton");
  const QPointF middle = QRectF(button.rect()).center();
  QEnterEvent enter(middle, middle, button.mapToGlobal(middle));
  QCoreApplication::sendEvent(&button, &enter);
  ASSERT_TRUE(button.underMouse());
  QTimer::singleShot(50, button.menu(), [&] {
    QCursor::setPos(window_.mapToGlobal(window_.rect().center()));
    button.menu()->close();
  });
  button.showMenu();  // until the menu is closed
  EXPECT_FALSE(button.underMouse());
  EXPECT_FALSE(button.isDown());
}

TEST_F(MainWindowTest, TypingANumberDoesTheSame) {
  ASSERT_TRUE(waitForFrame());
  type("sliding.velocity", "0.125 m/s");  // the dot is text here, not the key of a single step
  EXPECT_TRUE(session().isPlaying());
  ASSERT_TRUE(waitForFrame());
  EXPECT_EQ(frame()->scene->sliding.velocity, 0.125);
  ASSERT_TRUE(waitFor([&] {
    const auto& marker = chart().marker;
    return marker && marker->x == 0.125;
  }));
}

TEST_F(MainWindowTest, DraggingThroughManyValuesEndsAtTheLastAndDropsOlderOnes) {
  ASSERT_TRUE(waitForFrame());
  const std::uint64_t before = session().sceneNumber();
  std::vector<std::uint64_t> seen;
  QObject::connect(&session(), &Session::frameArrived,
                   [&] { seen.push_back(frame()->sceneNumber); });
  auto& slider = control<ValueSlider>("slider:elastomer.shear_modulus");
  const int y = slider.height() / 2;
  const auto position = [&](int i) { return 2 + (slider.width() - 4) * i / 200; };
  QTest::mousePress(&slider, Qt::LeftButton, {}, QPoint(position(0), y));
  for (int lap = 0; lap < 6; ++lap)
    for (int i = 0; i <= 200; ++i)
      QTest::mouseMove(&slider, QPoint(position(lap % 2 ? 200 - i : i), y));
  for (int i = 0; i <= 140; ++i) QTest::mouseMove(&slider, QPoint(position(i), y));
  QTest::mouseRelease(&slider, Qt::LeftButton, {}, QPoint(position(140), y));
  const std::uint64_t posted = session().sceneNumber() - before;
  EXPECT_GE(posted, 200U);
  ASSERT_TRUE(waitForFrame());

  EXPECT_EQ(*frame()->scene, window_.panel().scene());
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
  const std::set<std::uint64_t> computed(seen.begin(), seen.end());
  EXPECT_LT(computed.size(), posted);
  EXPECT_EQ(*computed.rbegin(), session().sceneNumber());
}

TEST_F(MainWindowTest, RefusedTextReachesNobody) {
  ASSERT_TRUE(waitForFrame());
  const std::uint64_t before = session().sceneNumber();
  type("surface.hurst", "1.4");
  EXPECT_TRUE(control<ValueEntry>("entry:surface.hurst").hasError());
  EXPECT_EQ(session().sceneNumber(), before);
}

TEST_F(MainWindowTest, TheCurveFillsInBesideTheAnimation) {
  ASSERT_TRUE(waitFor([&] { return window_.plotView().sheet().status.text == "3 of 3 lines"; }));
  // The curve may be there before the first frame, and the diagram is painted anew after a pause.
  ASSERT_TRUE(waitFor([&] { return chart().marker.has_value(); }));
  ASSERT_EQ(chart().series.size(), 2U);
  EXPECT_EQ(chart().series.back().points.size(), 9U);
  EXPECT_GT(chart().series.front().points.size(), 9U);  // the law, finely
  for (const QLabel* label : window_.findChildren<QLabel*>())
    EXPECT_FALSE(label->text().contains("3 of 3"));  // it stands in the diagram, once
}

TEST_F(MainWindowTest, AnotherMaterialFadesTheCurveUntilItsOwnArrives) {
  ASSERT_TRUE(waitFor([&] { return !chart().series.empty(); }));
  QTest::keyClick(&control<ValueSlider>("slider:elastomer.shear_modulus"), Qt::Key_Right);
  const Diagram stale = session().friction().sheet().diagrams.front();
  ASSERT_FALSE(stale.series.empty());
  EXPECT_TRUE(stale.series.front().isFaded);
  ASSERT_TRUE(waitFor([&] {
    return !chart().series.empty() && !chart().series.front().isFaded &&
           session().friction().progress() == 1;
  }));
}

TEST_F(MainWindowTest, PlaysPausesAndSteps) {
  ASSERT_TRUE(waitForFrame());
  EXPECT_TRUE(session().isPlaying());
  QTest::keyClick(&window_, Qt::Key_Space);
  EXPECT_FALSE(session().isPlaying());
  ASSERT_TRUE(waitForRest());  // what was under way is over
  const std::uint64_t step = frame()->step;
  QTest::keyClick(&window_, Qt::Key_Period);
  ASSERT_TRUE(waitFor([&] { return frame()->step > step; }));
  const std::uint64_t later = frame()->step;
  ASSERT_TRUE(waitForRest());
  EXPECT_EQ(frame()->step, later);
  QTest::keyClick(&window_, Qt::Key_Space);
  EXPECT_TRUE(session().isPlaying());
  ASSERT_TRUE(waitFor([&] { return frame()->step > later + 3; }));
}

/// Of the line in the picture, at any zoom and however many elements there are.
TEST_F(MainWindowTest, AStepByHandIsSeen) {
  for (const std::int64_t elements : {256, 5000}) {
    Scene scene = smallScene();
    scene.surface.elements = elements;
    window_.document().open(scene);
    ASSERT_TRUE(waitForFrame());
    session().setPlaying(false);
    for (const int zoom : {0, 6, 6}) {
      window_.canvas().zoom(zoom);
      ASSERT_TRUE(waitForRest());
      const double before = frame()->distance;
      action("step").trigger();
      ASSERT_TRUE(waitFor([&] { return frame()->distance != before; }));
      const double seen = window_.canvas().viewer().options().view.width;
      const double pixels =
          (frame()->distance - before) / seen * window_.canvas().plotArea().width();
      EXPECT_GT(pixels, 2) << elements;
      EXPECT_LT(pixels,
                std::max(20.0, 2.1 * frame()->spacing / seen * window_.canvas().plotArea().width()))
          << elements;
    }
    window_.canvas().fit();
    session().setPlaying(true);
  }
}

TEST_F(MainWindowTest, ASingleStepWhilePlayingPauses) {
  ASSERT_TRUE(waitForFrame());
  QTest::keyClick(&window_, Qt::Key_Period);
  EXPECT_FALSE(session().isPlaying());
}

TEST_F(MainWindowTest, KeysAreTheWindowsAgainAfterEnterOrAClickOnTheViews) {
  ASSERT_TRUE(waitForFrame());
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  auto& entry = control<ValueEntry>("entry:sliding.velocity");
  QTest::mouseClick(&entry, Qt::LeftButton);
  ASSERT_TRUE(entry.hasFocus());
  type("sliding.velocity", "0.5 m/s");
  QTest::keyClick(window_.windowHandle(), Qt::Key_Space);
  EXPECT_EQ(entry.text(), "500");
  EXPECT_FALSE(session().isPlaying());

  for (QWidget* view :
       {static_cast<QWidget*>(&window_.canvas()), static_cast<QWidget*>(&window_.plotView())}) {
    const bool playing = session().isPlaying();
    QTest::mouseClick(&entry, Qt::LeftButton);
    ASSERT_TRUE(entry.hasFocus());
    QTest::mouseClick(window_.windowHandle(), Qt::LeftButton, {},
                      view->mapTo(&window_, view->rect().center()));
    EXPECT_FALSE(entry.hasFocus());
    QTest::keyClick(window_.windowHandle(), Qt::Key_Space);
    EXPECT_EQ(session().isPlaying(), !playing);
  }
}

TEST_F(MainWindowTest, ResetGoesBackToTimeZero) {
  ASSERT_TRUE(waitFor([&] { return frame() && frame()->time > 0; }));
  QTest::keyClick(&window_, Qt::Key_Space);
  QTest::keyClick(&window_, Qt::Key_R);
  ASSERT_TRUE(waitFor([&] { return frame()->time == 0; }));
}

TEST_F(MainWindowTest, ASceneThatCannotRunIsExplainedAndTheWindowLives) {
  ASSERT_TRUE(waitForFrame());
  Scene broken = smallScene();
  broken.surface.kind = SurfaceKind::Profile;
  broken.surface.file = "no_such_profile.csv";
  window_.document().open(broken);
  ASSERT_TRUE(waitFor([&] { return window_.messages().isVisible(); }));
  EXPECT_TRUE(window_.messages().text().startsWith("file: "));
  EXPECT_TRUE(window_.messages().text().contains("no_such_profile.csv"));
  EXPECT_TRUE(control<ValueEntry>("entry:surface.file").hasError());
  EXPECT_TRUE(control<QLabel>("error:surface.file").isVisible());

  window_.document().open(smallScene());
  ASSERT_TRUE(waitForFrame());
  EXPECT_TRUE(waitFor([&] { return !window_.messages().isVisible(); }));
}

/// No part of the window may throw over it while the scene is shown.
TEST_F(MainWindowTest, AMotionAtATemperatureWithoutAShiftIsExplained) {
  Scene motion = smallScene();
  motion.sliding.kind = SlidingKind::Step;
  motion.sliding.duration = 0.01;
  window_.document().open(motion);
  ASSERT_TRUE(waitForFrame());
  motion.elastomer.shift.referenceTemperature = motion.elastomer.temperature + 200;
  EXPECT_NO_THROW(window_.document().edit(motion));
  EXPECT_TRUE(waitFor([&] { return window_.messages().isVisible(); }));
}

TEST_F(MainWindowTest, WhatMendsASceneTakesItsComplaintsAway) {
  ASSERT_TRUE(waitForFrame());
  window_.document().open(refusedScene());
  ASSERT_TRUE(waitFor([&] { return window_.messages().isVisible(); }));
  auto& waves = control<ValueEntry>("entry:surface.waves");
  EXPECT_TRUE(waves.hasError());
  type("surface.elements", "100");
  ASSERT_TRUE(waitFor([&] { return !window_.messages().isVisible(); }));
  EXPECT_FALSE(waves.hasError());
}

/// The numbers of the former scene would pass for those of the one that cannot be shown.
TEST_F(MainWindowTest, NoStatisticsStayOfASceneThatWasLeft) {
  ASSERT_TRUE(waitForFrame());
  auto& view = control<DiagramView>("statisticsView");
  action("go:statisticsView").trigger();
  ASSERT_TRUE(waitFor([&] { return !view.frames().empty(); }));
  window_.document().open(refusedScene());
  EXPECT_TRUE(waitFor([&] { return view.frames().empty(); }));
}

TEST_F(MainWindowTest, WithoutAContactNoPictureIsSavedAndTheReasonIsSaid) {
  ASSERT_TRUE(waitForFrame());
  window_.document().open(refusedScene());
  ASSERT_TRUE(waitFor([&] { return !window_.canvas().frame() && window_.messages().isVisible(); }));
  for (const char* name : {"savePicture", "copyPicture"}) {
    window_.messages().hide();
    action(name).trigger();
    EXPECT_TRUE(window_.messages().isVisible()) << name;
    EXPECT_TRUE(window_.messages().text().contains("no picture")) << name;
  }
}

Scene sceneWithoutCurve() {
  Scene still = smallScene();
  still.sliding.velocity = 0;  // there is an answer at rest, but none where it slides
  still.elastomer.shearModulus = 1e15;
  still.elastomer.relaxationTime = 1e12;  // contacts shorter than the digits of numbers
  still.load.normalForce = 1e-30;
  return still;
}

/// A session whose pictures are ready when the test says so, as where they are drawn in the
/// background.
class SlowPictures : public testing::Test {
 protected:
  SlowPictures() {
    session_.drawFirst([this](const std::shared_ptr<const Frame>& frame) { drawn_ = frame; });
    QObject::connect(&session_, &Session::frameLost, &session_, [this] { drawn_.reset(); });
    QObject::connect(&session_, &Session::errorOccurred, &session_, [this] { ++errors_; });
    session_.begin();
    session_.setPlaying(false);
    EXPECT_TRUE(waitFor([this] { return drawn_ != nullptr; }));
  }
  template <class Condition>
  bool waitFor(Condition condition) {
    return QTest::qWaitFor(
        [&] {
          session_.poll();
          return condition();
        },
        30000);
  }

  Session session_{smallScene(), {}};
  std::shared_ptr<const Frame> drawn_;  // what the canvas draws now
  int errors_ = 0;
};

TEST_F(SlowPictures, AFailedCurveDoesNotLoseTheContactOfItsScene) {
  session_.show(drawn_);
  session_.setScene(sceneWithoutCurve(), Session::Begin::Restart);
  EXPECT_TRUE(waitFor(
      [this] { return errors_ > 0 && drawn_ && drawn_->sceneNumber == session_.sceneNumber(); }));
}

TEST_F(SlowPictures, TheContactOfASceneThatWasLeftIsNotDrawnAnyMore) {
  session_.setScene(refusedScene(), Session::Begin::Restart);
  EXPECT_TRUE(waitFor([this] { return errors_ > 0; }));
  EXPECT_EQ(drawn_, nullptr);
}

TEST_F(MainWindowTest, AFailedCurveStaysExplainedWhileTheContactRuns) {
  ASSERT_TRUE(waitForFrame());
  window_.document().open(sceneWithoutCurve());
  ASSERT_TRUE(waitForFrame());
  ASSERT_TRUE(waitFor([&] { return window_.messages().isVisible(); }));
  QSignalSpy frames(&session(), &Session::frameArrived);
  ASSERT_TRUE(waitFor([&] { return frames.count() > 5; }));
  EXPECT_TRUE(window_.messages().isVisible());
  EXPECT_LT(window_.messages().text().size(), 160) << window_.messages().text().toStdString();
}

TEST(Trouble, IsSaidOfFramesThatCannotBeBelieved) {
  Frame frame;
  frame.length = 1;
  frame.state.mu = 0;
  EXPECT_TRUE(frameError(frame).empty());
  frame.state.mu = kNotApplicable;
  EXPECT_THAT(frameError(frame).text, testing::HasSubstr("steady"));
  frame.surfaceHeight = {0, kNotApplicable};
  EXPECT_THAT(frameError(frame).text, testing::HasSubstr("numbers"));
  EXPECT_LT(translatedText(frameError(frame)).size(), 100);
}

TEST_F(MainWindowTest, AMotionThatIsNotSteadyIsShownInTime) {
  auto& tabs = control<QTabWidget>("tabs");
  auto& strips = control<ChartView>("motionStrips");
  const auto samples = [&] { return strips.sheet().diagrams[0].series[0].points.size(); };
  EXPECT_FALSE(tabs.isTabVisible(1));
  Scene moving = smallScene();
  moving.sliding.kind = SlidingKind::Step;
  window_.document().open(moving);
  EXPECT_TRUE(tabs.isTabVisible(1));
  EXPECT_EQ(tabs.currentIndex(), 1);
  ASSERT_TRUE(waitFor([&] { return samples() > 3; }));
  // There is no line yet, before the step; its room is there, so that the strips do not move.
  EXPECT_TRUE(strips.sheet().status.text.starts_with("a dashed line will"));
  const QImage image = strips.grab().toImage();
  const QColor line =
      toQColor(seriesColour(0, window_.appearance().isDark() ? darkTheme() : lightTheme()));
  int drawn = 0;  // pixels of the line's colour, or nearly: it is smooth
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const QColor pixel = image.pixelColor(x, y);
      const int away = std::abs(pixel.red() - line.red()) + std::abs(pixel.green() - line.green()) +
                       std::abs(pixel.blue() - line.blue());
      drawn += away < 100 ? 1 : 0;
    }
  EXPECT_GT(drawn, 3);
  const auto noteOf = [&](SlidingKind kind) {
    moving.sliding.kind = kind;
    window_.document().open(moving);
    EXPECT_TRUE(
        waitFor([&] { return frame()->sceneNumber == session().sceneNumber() && samples() > 3; }));
    return strips.sheet().status.text;
  };
  // A click leads to its moment, also to one that was not reached yet.
  session().reset();
  ASSERT_TRUE(waitFor([&] { return frame()->time < 0.4 * moving.sliding.duration; }));
  const DiagramAxis& y = strips.sheet().diagrams[0].y;
  const double late = 0.9 * moving.sliding.duration;
  QTest::mouseClick(&strips, Qt::LeftButton, {},
                    strips.mapToPosition(late, 0.5 * (y.from + y.to)).toPoint());
  EXPECT_TRUE(
      waitFor([&] { return std::abs(frame()->time - late) < 0.02 * moving.sliding.duration; }));
  EXPECT_FALSE(session().isPlaying());
  EXPECT_TRUE(noteOf(SlidingKind::Start).starts_with("dashed: relaxation at the predicted rate"));
  EXPECT_EQ(noteOf(SlidingKind::Oscillation), "");
  window_.document().open(smallScene());
  EXPECT_FALSE(tabs.isTabVisible(1));
  EXPECT_EQ(tabs.currentWidget(), &window_.plotView());
}

TEST_F(MainWindowTest, AValueIsTypedWithItsUnit) {
  type("elastomer.shear_modulus", "25 MPa");
  EXPECT_EQ(session().scene().elastomer.shearModulus, 2.5e7);
  type("load.normal_force", "3.4 mN");
  EXPECT_EQ(session().scene().load.normalForce, 0.0034);
  type("surface.length", "20 MPa");
  EXPECT_TRUE(control<ValueEntry>("entry:surface.length").hasError());
}

/// A part that was chosen for one line is none of another.
TEST_F(MainWindowTest, AnOpenedSceneIsShownAsAWhole) {
  ASSERT_TRUE(waitForFrame());
  window_.canvas().zoom(5);
  Scene edited = smallScene();
  edited.load.normalForce *= 2;
  window_.document().edit(edited);
  EXPECT_FALSE(window_.canvas().viewer().navigation().isFitted());
  Scene other = smallScene();
  other.surface.seed += 1;
  window_.document().open(other);
  EXPECT_TRUE(window_.canvas().viewer().navigation().isFitted());
}

TEST_F(MainWindowTest, TheContactIsPainted) {
  EXPECT_EQ(window_.canvas().backendName(), QStringLiteral("software"));
  QSignalSpy painted(&window_.canvas(), &ContactCanvas::painted);
  ASSERT_TRUE(waitFor([&] { return painted.count() >= 3; }));
  const QImage image = window_.canvas().grab().toImage();
  std::set<QRgb> colours;
  for (int y = 0; y < image.height(); ++y) colours.insert(image.pixel(image.width() / 2, y));
  EXPECT_GT(colours.size(), 5U);
}

TEST_F(MainWindowTest, LightAndDark) {
  for (const bool dark : {true, false}) {
    window_.appearance().setDark(dark);
    EXPECT_EQ(window_.palette().color(QPalette::Window).lightness() < 128, dark);
    ASSERT_TRUE(waitForFrame());
  }
}

TEST_F(MainWindowTest, FactsComeFromTheFrame) {
  ASSERT_TRUE(waitForFrame());
  EXPECT_EQ(fact("factForce"), QStringLiteral("force F̄ = 0.034"));
  EXPECT_TRUE(control<QLabel>("factForce").toolTip().contains("Eq. (14)"));
  EXPECT_TRUE(fact("factVelocity").startsWith(QStringLiteral("velocity v̄ = ")));
  EXPECT_TRUE(control<QLabel>("factVelocity").toolTip().contains("Eq. (13)"));
  EXPECT_TRUE(fact("factMu").startsWith(
      QStringLiteral("this line μ = %1").arg(QString::number(frame()->state.mu, 'g', 3))));
  ASSERT_TRUE(waitFor([&] { return fact("factBackend") == "software"; }));
}

}  // namespace
}  // namespace asperity
