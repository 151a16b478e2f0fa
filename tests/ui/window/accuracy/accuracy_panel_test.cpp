// The accuracy panel as a person uses it; predictions are real.
#include "ui/window/accuracy/accuracy_panel.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QTest>
#include <QToolButton>
#include <vector>

#include "core/run/motion_accuracy.h"
#include "tests/core/small_scene.h"
#include "tests/ui/window/qt_application.h"
#include "ui/window/curve/curve_reading.h"
#include "ui/window/figures/diagram_view.h"
#include "ui/window/main/status_line.h"

namespace asperity {
namespace {

constexpr int kPatience = 60000;  // ms, far more than anything here takes

Scene sceneOfThePanel() {
  return sceneOfSize(64, 9, 4);
}

class AccuracyPanelTest : public testing::Test {
 protected:
  AccuracyPanelTest() {
    panel_.resize(900, 260);
    panel_.show();
    panel_.showScene(sceneOfThePanel());
  }
  template <class Control>
  Control& control(const QString& name) {
    return *panel_.findChild<Control*>(name);
  }
  QString text(const QString& name) { return control<QLabel>(name).text(); }

  AccuracyPanel panel_;
};

TEST(AccuracyScale, GoesFromQuickToExactAndBack) {
  EXPECT_EQ(targetAt(0), 0.2);
  EXPECT_EQ(targetAt(kAccuracySteps), 0.002);
  for (int place = 0; place <= kAccuracySteps; ++place)
    EXPECT_EQ(sliderPosition(targetAt(place)), place);
  for (int place = 1; place <= kAccuracySteps; ++place)
    EXPECT_LT(targetAt(place), targetAt(place - 1));
}

TEST_F(AccuracyPanelTest, TimeAndErrorArePredicted) {
  ASSERT_TRUE(QTest::qWaitFor([&] { return text("accuracyPredicted").startsWith("predicted:"); },
                              kPatience));
  EXPECT_TRUE(text("accuracyPredicted").contains("error of the whole curve"));
  EXPECT_TRUE(text("accuracyPredicted").contains("standard error"));
}

TEST_F(AccuracyPanelTest, AMotionIsPredictedByItsSteps) {
  Scene scene = sceneOfThePanel();
  scene.sliding = {SlidingKind::Step, 0.1, 0.2};
  scene.sliding.duration = 0.01;
  panel_.showScene(scene);
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return text("accuracyPredicted").startsWith("predicted motion:"); }, kPatience));
  EXPECT_TRUE(text("accuracyPredicted").contains("error of the whole motion"));
  EXPECT_TRUE(text("accuracyPredicted").contains("time step"));
}

TEST_F(AccuracyPanelTest, TheSliderSetsTheTargetAndTheButtonTakesItAway) {
  Scene edited;
  QObject::connect(&panel_, &AccuracyPanel::sceneEdited, [&](const Scene& s) { edited = s; });
  QTest::keyClick(&control<QSlider>("accuracySlider"), Qt::Key_Right);
  EXPECT_EQ(edited.accuracy.targetRelativeError, targetAt(1));
  EXPECT_EQ(edited.accuracy.scheme, Scheme::Cubic);
  EXPECT_TRUE(text("accuracyTarget").startsWith("target:"));
  // Its value is a position from 0 to 20, which says nothing to a listener.
  EXPECT_EQ(control<QSlider>("accuracySlider").accessibleDescription(), text("accuracyTarget"));
  QTest::mouseClick(&control<QPushButton>("accuracyFree"), Qt::LeftButton);
  EXPECT_EQ(edited.accuracy.targetRelativeError, 0);
  EXPECT_FALSE(control<QPushButton>("accuracyFree").isEnabled());
  EXPECT_EQ(control<QSlider>("accuracySlider").value(), 0);
}

TEST_F(AccuracyPanelTest, WhatCannotBePredictedIsExplained) {
  Scene missing = sceneOfThePanel();
  missing.surface.kind = SurfaceKind::Profile;
  missing.surface.file = "nowhere.csv";
  panel_.showScene(missing);
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return text("accuracyPredicted").contains("nowhere.csv"); }, kPatience))
      << text("accuracyPredicted").toStdString();
}

TEST_F(AccuracyPanelTest, AComparisonCanBeCancelled) {
  auto& button = control<QPushButton>("accuracyCompare");
  QTest::mouseClick(&button, Qt::LeftButton);
  EXPECT_TRUE(button.text().startsWith("Cancel"));
  QTest::mouseClick(&button, Qt::LeftButton);
  ASSERT_TRUE(QTest::qWaitFor([&] { return button.text() == "Compare methods"; }, kPatience));
}

TEST_F(AccuracyPanelTest, TheComparisonIsShownRegionByRegion) {
  Scene scene = sceneOfThePanel();
  scene.sweep.points = 41;
  scene.surface.elements = 128;
  panel_.showScene(scene);
  QTest::mouseClick(&control<QPushButton>("accuracyCompare"), Qt::LeftButton);
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return panel_.findChild<QToolButton*>("region:1"); }, kPatience));
  auto& first = control<QToolButton>("region:0");
  auto& second = control<QToolButton>("region:1");
  EXPECT_TRUE(first.isChecked());
  EXPECT_EQ(first.text(), "region I");
  EXPECT_THAT(text("regionRange").toStdString(), testing::MatchesRegex("[^ ]+ to [^ ]+ m/s"));
  const QString range = text("regionRange");
  QTest::keyClick(&second, Qt::Key_Space);
  EXPECT_TRUE(second.isChecked());
  EXPECT_FALSE(first.isChecked());
  EXPECT_NE(text("regionRange"), range);
  const auto& picture = control<DiagramView>("figurePicture");
  EXPECT_TRUE(picture.accessibleName().endsWith(second.text()));
  EXPECT_TRUE(picture.toolTip().contains("median"));
  // The diagram goes with its scene.
  scene.load.normalForce *= 2;
  panel_.showScene(scene);
  EXPECT_FALSE(second.isVisibleTo(&panel_));
}

TEST_F(AccuracyPanelTest, MeasuredNumbersGoWithTheirScene) {
  panel_.showMeasured({2, 0.015});
  EXPECT_EQ(text("accuracyMeasured"),
            "measured: 2 s on the clock, standard error of the whole curve 1.5\u00A0%");
  panel_.showScene(sceneOfThePanel());
  EXPECT_EQ(text("accuracyMeasured"), "");
}

/// The error beside the mean is that of one velocity; both places tell the same of both.
TEST_F(AccuracyPanelTest, TheErrorOfTheCurveIsToldFromThatOfTheStatusLine) {
  StatusLine status;
  const QString both = errorsInWords();
  EXPECT_TRUE(both.contains("at this velocity") && both.contains("of the whole curve"));
  for (const QWidget* place :
       {static_cast<QWidget*>(panel_.findChild<QLabel*>("accuracyPredicted")),
        static_cast<QWidget*>(panel_.findChild<QLabel*>("accuracyMeasured")),
        static_cast<QWidget*>(status.findChild<QLabel*>("factMu"))})
    EXPECT_TRUE(place->toolTip().contains(both.toHtmlEscaped()))
        << place->objectName().toStdString();
}

TEST(Predictions, TheNewestSceneWins) {
  std::vector<int> answered;
  BackgroundWork work;
  for (int number = 1; number <= 20; ++number)
    work.request(
        [](const BackgroundWork::Run& run) { return predictRun(sceneOfThePanel(), 0, run.stop()); },
        [&answered, number](const Prediction&) { answered.push_back(number); });
  ASSERT_TRUE(QTest::qWaitFor([&] { return !answered.empty(); }, kPatience));
  EXPECT_EQ(answered, std::vector{20});
}

}  // namespace
}  // namespace asperity
