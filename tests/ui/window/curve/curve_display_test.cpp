// The friction diagram in the window: how soon a new curve is there, velocities from the marker and
// from points, the lists at its axes, and what is compared with it.
#include "ui/window/curve/curve_display.h"
#include "ui/panels/boxes.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QSpinBox>
#include <algorithm>
#include <cmath>

#include "tests/ui/window/curve/curve_fixture.h"
#include "tests/ui/window/fresh_paints.h"
#include "tests/ui/window/qt_application.h"
#include "ui/panels/value_slider.h"

namespace asperity {
namespace {

using CurveDisplayTest = CurveTest;

TEST_F(CurveDisplayTest, DraggingTheMarkerSetsTheVelocityAndIsOneStepBack) {
  ASSERT_TRUE(waitForCurve());
  const double before = velocity();
  drag(at(before, middle()), at(before / 37, middle()));
  EXPECT_NEAR(velocity() / (before / 37), 1, 0.05);
  EXPECT_EQ(window_.panel().scene().sliding.velocity, velocity());
  ASSERT_TRUE(waitFor([this] { return chart().marker->x == velocity(); }));
  EXPECT_FALSE(session().friction().isStale()) << "the curve is the same";
  action("undo").trigger();
  EXPECT_EQ(velocity(), before);
}

/// By hand nobody means all digits of a place on the axis; with Shift some more.
TEST_F(CurveDisplayTest, VelocitiesSetByHandAreRound) {
  ASSERT_TRUE(waitForCurve());
  const double before = velocity();
  drag(at(before, middle()), at(before / 37, middle()));
  EXPECT_EQ(velocity(), roundedToDigits(velocity(), 3));
  EXPECT_NE(velocity(), before);
  plot().setFocus();
  QTest::keyClick(&plot(), Qt::Key_Left);
  EXPECT_EQ(velocity(), roundedToDigits(velocity(), 3));
  QTest::keyClick(&plot(), Qt::Key_Left, Qt::ShiftModifier);
  EXPECT_EQ(velocity(), roundedToDigits(velocity(), 5));
  EXPECT_NE(velocity(), roundedToDigits(velocity(), 3));
}

TEST_F(CurveDisplayTest, ClickingAPointLoadsExactlyItsVelocity) {
  ASSERT_TRUE(waitForCurve());
  const std::vector<double> velocities = sweepVelocities(session().scene().sweep);
  const DiagramSeries series = chart().series.back();
  ASSERT_GT(series.points.size(), 3U);
  const DiagramPoint& point = series.points[1];
  QTest::mouseClick(&plot(), Qt::LeftButton, {}, at(point.x, point.y));
  EXPECT_EQ(velocity(), velocities[static_cast<std::size_t>(point.row)]);
}

TEST_F(CurveDisplayTest, ArrowKeysMoveTheVelocityWhereTheChartHasTheFocus) {
  ASSERT_TRUE(waitForCurve());
  const double before = velocity();
  plot().setFocus();
  QTest::keyClick(&plot(), Qt::Key_Left);
  EXPECT_NEAR(velocity() / before, std::pow(10, -0.05), 0.005);
}

TEST_F(CurveDisplayTest, TheListsAtTheAxesChooseThem) {
  ASSERT_TRUE(waitForCurve());
  auto& keys = control<ChoiceBox>("axisKey");
  auto& quantities = control<ChoiceBox>("axisQuantity");
  EXPECT_EQ(keys.shownText(), "sliding velocity v (m/s)");
  EXPECT_EQ(quantities.shownText().toStdString(), "coefficient of friction \u03BC");
  EXPECT_EQ(keys.currentData().toString(), "sliding.velocity");
  const auto choose = [](ChoiceBox& box, const QVariant& data) {
    box.setFocus();
    ASSERT_GE(box.findData(data), 0);
    box.setCurrentIndex(box.findData(data));
    emit box.activated(box.currentIndex());
  };
  choose(keys, "load.normal_force");
  EXPECT_EQ(session().scene().sweep.key, "load.normal_force");
  ASSERT_TRUE(waitForCurve());
  ASSERT_TRUE(waitFor([&] { return keys.shownText() == "normal force (N)"; }))
      << keys.shownText().toStdString();
  EXPECT_EQ(keys.itemText(keys.findData("load.normal_force")), "Normal force (N)");
  choose(quantities, static_cast<int>(CurveQuantity::Indentation));
  ASSERT_TRUE(waitFor([&] { return quantities.shownText().contains("indentation"); }));
  action("undo").trigger();  // the axis; what is shown stays
  EXPECT_EQ(session().scene().sweep.key, kVelocityKey);
  ASSERT_TRUE(waitFor([&] { return keys.currentData().toString() == "sliding.velocity"; }));
  choose(keys, "dimensionless");
  EXPECT_TRUE(action("dimensionlessAxes").isChecked());
  ASSERT_TRUE(waitFor([&] { return keys.currentData().toString() == "dimensionless"; }));
  choose(keys, "sliding.velocity");
  EXPECT_FALSE(action("dimensionlessAxes").isChecked());
}

/// The marker is a value of what the axis shows, also where the scene stays as it is.
TEST_F(CurveDisplayTest, TheMarkerFollowsTheQuantityAtOnce) {
  ASSERT_TRUE(waitForCurve());
  const std::optional<DiagramMarker> before = session().friction().marker();
  ASSERT_TRUE(before);
  ASSERT_TRUE(frame());
  const auto show = [this](CurveQuantity quantity) {
    session().editCurve([&](FrictionChartModel& plot) { plot.setQuantity(quantity); });
    const std::optional<DiagramMarker> marker = session().friction().marker();
    return marker ? marker->y : kNotApplicable;
  };
  EXPECT_DOUBLE_EQ(show(CurveQuantity::NormalizedMu), before->y / frame()->rmsSlope);
  EXPECT_DOUBLE_EQ(show(CurveQuantity::ContactFraction), frame()->state.contactFraction);
  EXPECT_DOUBLE_EQ(show(CurveQuantity::Mu), before->y);
}

TEST_F(CurveDisplayTest, ASettingChosenInTheAccuracyPanelIsComparedBelowTheCurve) {
  ASSERT_TRUE(waitForCurve());
  control<QComboBox>("comparisonScheme").setCurrentIndex(static_cast<int>(Scheme::Linear));
  control<QSpinBox>("comparisonOversampling").setValue(3);
  control<QSpinBox>("comparisonLines").setValue(5);
  EXPECT_EQ(plot().sheet().diagrams.size(), 1U);
  control<QCheckBox>("comparisonWanted").setChecked(true);
  const auto isComplete = [this] {
    const auto& difference = session().friction().difference();
    return difference && !session().friction().isDifferenceStale() &&
           difference->done == difference->total;
  };
  const auto strip = [this] { return session().friction().sheet().diagrams.at(1).series.at(1); };
  ASSERT_TRUE(waitFor(isComplete));
  EXPECT_EQ(strip().name.english(), "linear x3, 5 lines minus the curve above");
  const auto own = frictionCurve(session().scene()).points;
  const auto other = frictionCurve(withSetting(session().scene(), {Scheme::Linear, 3, 5})).points;
  const DiagramPoint shown = strip().points[2];
  EXPECT_NEAR(shown.y, 100 * (other[2].mu / own[2].mu - 1), 1e-6);
  EXPECT_GT(shown.high, shown.y);

  Scene scene = session().scene();
  scene.load.normalForce *= 5;
  window_.document().edit(scene);
  EXPECT_TRUE(strip().isFaded) << "until that of the new scene is there";
  ASSERT_TRUE(waitForCurve());
  ASSERT_TRUE(waitFor(isComplete));
  EXPECT_NE(strip().points[2].y, shown.y);
  ASSERT_TRUE(waitFor([&] {
    return plot().sheet().diagrams.size() == 2 &&
           plot().sheet().diagrams[1].series.at(1).points == strip().points;
  }));

  control<QCheckBox>("comparisonWanted").setChecked(false);
  ASSERT_TRUE(waitFor([this] { return plot().sheet().diagrams.size() == 1; }));
}

TEST_F(CurveDisplayTest, ATargetLeavesNothingToCompare) {
  ASSERT_TRUE(waitForCurve());
  control<QCheckBox>("comparisonWanted").setChecked(true);
  ASSERT_TRUE(waitFor([this] { return plot().sheet().diagrams.size() == 2; }));
  Scene scene = session().scene();
  scene.accuracy.targetRelativeError = 0.1;
  window_.document().edit(scene);
  EXPECT_FALSE(control<QWidget>("comparisonBox").isEnabled());
  ASSERT_TRUE(waitFor([this] { return plot().sheet().diagrams.size() == 1; }));
}

TEST_F(CurveDisplayTest, ASliderBringsANewCurveAtOnceAndNeverMixesItWithTheOld) {
  window_.document().open(Scene{});  // the paper's size
  ASSERT_TRUE(waitForCurve());
  auto& slider = control<ValueSlider>("slider:elastomer.shear_modulus");
  std::vector<double> milliseconds;
  FreshPaints paints(session(), plot());
  for (int i = 0; i < 20; ++i) {
    QTest::qWait(20);
    paints.start();
    QTest::keyClick(&slider, i % 2 == 0 ? Qt::Key_Right : Qt::Key_Left);
    ASSERT_TRUE(session().friction().isStale());
    ASSERT_TRUE(paints.waitForPicture());
    milliseconds.push_back(paints.milliseconds);
    EXPECT_EQ(*session().curve()->scene, session().scene());
  }
  EXPECT_EQ(paints.mixed, 0);
  std::sort(milliseconds.begin(), milliseconds.end());
  std::printf("from a slider to the first new curve painted: median %.1f ms, fastest %.1f ms\n",
              milliseconds[milliseconds.size() / 2], milliseconds.front());
}

}  // namespace
}  // namespace asperity
