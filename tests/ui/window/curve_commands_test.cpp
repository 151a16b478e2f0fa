// The friction diagram in the window: velocity from the marker and from points, pins, axes, files,
// and how soon a new curve is there.
#include <gtest/gtest.h>

#include <QAction>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QFile>
#include <QMenu>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTemporaryDir>
#include <algorithm>
#include <cmath>

#include "core/base/number_text.h"
#include "core/friction/ensemble.h"
#include "core/scene/provenance.h"
#include "tests/ui/window/fresh_paints.h"
#include "tests/ui/window/main_window_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "ui/chart/chart_view.h"
#include "ui/panels/controls.h"
#include "ui/panels/value_slider.h"
#include "ui/window/curve/curve_commands.h"
#include "ui/window/figures/diagram_view.h"
#include "ui/window/main/message_bar.h"
#include "ui/window/main/session.h"

namespace asperity {
namespace {

class CurveCommandsTest : public MainWindowTest {
 protected:
  bool waitForCurve() {
    return waitFor([this] {
      return !session().friction().isStale() && session().friction().progress() >= 1 &&
             !chart().series.empty() && !chart().series.back().isFaded &&
             chart().marker.has_value();
    });
  }
  ChartView& plot() { return window_.plotView(); }
  double velocity() { return session().scene().sliding.velocity; }
  QPoint at(double x, double y) { return plot().mapToPosition(x, y).toPoint(); }
  double middle() {
    return std::pow(10, 0.5 * (plot().visibleRange().y.from + plot().visibleRange().y.to));
  }
  void drag(QPoint from, QPoint to) {
    QTest::mousePress(&plot(), Qt::LeftButton, {}, from);
    for (int i = 1; i <= 6; ++i) QTest::mouseMove(&plot(), from + (to - from) * i / 6);
    QTest::mouseRelease(&plot(), Qt::LeftButton, {}, to);
  }
};

TEST_F(CurveCommandsTest, DraggingTheMarkerSetsTheVelocityAndIsOneStepBack) {
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

/// The axis keeps a decade that a change of the scene leaves empty, until somebody fits it.
TEST_F(CurveCommandsTest, HomeAndADoubleClickTakeEmptyDecadesAway) {
  for (const bool isByKey : {true, false}) {
    ASSERT_TRUE(waitForCurve());
    const AxisRange fitted = plot().visibleRange().y;
    const Scene scene = session().scene();
    Scene flat = scene;
    flat.surface.rmsHeight *= 0.1;
    window_.document().edit(flat);
    ASSERT_TRUE(waitForCurve());
    window_.document().edit(scene);
    ASSERT_TRUE(waitForCurve());
    ASSERT_LT(plot().visibleRange().y.from, fitted.from);
    if (isByKey)
      QTest::keyClick(&plot(), Qt::Key_Home);
    else
      QTest::mouseDClick(&plot(), Qt::LeftButton, {}, at(velocity() / 37, middle()));
    EXPECT_TRUE(waitFor([&] { return plot().visibleRange().y == fitted; }));
  }
}

/// By hand nobody means all digits of a place on the axis; with Shift some more.
TEST_F(CurveCommandsTest, VelocitiesSetByHandAreRound) {
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

TEST_F(CurveCommandsTest, ClickingAPointLoadsExactlyItsVelocity) {
  ASSERT_TRUE(waitForCurve());
  const std::vector<double> velocities = sweepVelocities(session().scene().sweep);
  const DiagramSeries series = chart().series.back();
  ASSERT_GT(series.points.size(), 3U);
  const DiagramPoint& point = series.points[1];
  QTest::mouseClick(&plot(), Qt::LeftButton, {}, at(point.x, point.y));
  EXPECT_EQ(velocity(), velocities[static_cast<std::size_t>(point.row)]);
}

TEST_F(CurveCommandsTest, ArrowKeysMoveTheVelocityWhereTheChartHasTheFocus) {
  ASSERT_TRUE(waitForCurve());
  const double before = velocity();
  plot().setFocus();
  QTest::keyClick(&plot(), Qt::Key_Left);
  EXPECT_NEAR(velocity() / before, std::pow(10, -0.05), 0.005);
}

/// A zoomed range belongs to its axes: those of forces say nothing of velocities.
TEST_F(CurveCommandsTest, AZoomEndsWithItsAxis) {
  ASSERT_TRUE(waitForCurve());
  Scene scene = session().scene();
  scene.sweep.key = "load.normal_force";
  scene.sweep.from = 1e-3;
  scene.sweep.to = 1;
  window_.document().edit(scene);
  ASSERT_TRUE(waitForCurve());
  plot().zoom(0.3);
  ASSERT_TRUE(plot().isZoomed());
  action("undo").trigger();
  ASSERT_TRUE(waitForCurve());
  EXPECT_FALSE(plot().isZoomed());
  // Evenly spaced values have another axis, too.
  plot().zoom(0.3);
  scene = session().scene();
  scene.sweep.scale = SweepScale::Linear;
  window_.document().edit(scene);
  ASSERT_TRUE(waitForCurve());
  EXPECT_FALSE(plot().isZoomed());
  action("undo").trigger();
  ASSERT_TRUE(waitForCurve());
  // Any other change keeps what is looked at; another scene is shown as a whole.
  plot().zoom(0.3);
  scene = session().scene();
  scene.elastomer.shearModulus *= 2;
  window_.document().edit(scene);
  ASSERT_TRUE(waitForCurve());
  EXPECT_TRUE(plot().isZoomed());
  window_.openShipped("start");
  EXPECT_FALSE(plot().isZoomed());
}

/// A curve over the axis before is not shown: it can neither be pinned nor be saved.
TEST_F(CurveCommandsTest, ACurveOverAnotherAxisCannotBePinnedOrSaved) {
  ASSERT_TRUE(waitForCurve());
  ASSERT_TRUE(action("pinCurve").isEnabled());
  Scene scene = session().scene();
  scene.sweep.key = "load.normal_force";
  scene.sweep.from = 1e-3;
  scene.sweep.to = 1;
  window_.document().edit(scene);
  for (const char* name : {"pinCurve", "saveCurve", "copyCurvePicture"})
    EXPECT_FALSE(action(name).isEnabled()) << name;
  ASSERT_TRUE(waitForCurve());
  for (const char* name : {"pinCurve", "saveCurve", "copyCurvePicture"})
    EXPECT_TRUE(action(name).isEnabled()) << name;
}

TEST_F(CurveCommandsTest, TheListsAtTheAxesChooseThem) {
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
TEST_F(CurveCommandsTest, TheMarkerFollowsTheQuantityAtOnce) {
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
  EXPECT_DOUBLE_EQ(show(CurveQuantity::ContactFraction), frame()->contactFraction);
  EXPECT_DOUBLE_EQ(show(CurveQuantity::Mu), before->y);
}

TEST_F(CurveCommandsTest, AFamilyHasAsManyCurvesAsAreWanted) {
  ASSERT_TRUE(waitForCurve());
  QMenu& family = *window_.findChild<QMenu*>("familyMenu");
  emit family.aboutToShow();
  EXPECT_EQ(family.findChild<QAction*>("key:load.normal_force")->text().remove('&'),
            "Normal force");
  window_.findChild<QAction*>("familySize:3")->trigger();
  family.findChild<QAction*>("key:elastomer.shear_modulus")->trigger();
  ASSERT_TRUE(waitFor([&] { return session().friction().pinned().size() == 3; }));
}

TEST_F(CurveCommandsTest, InfluencesAreComputedWhileTheirTabIsSeen) {
  action("go:influencePage").trigger();
  auto& view = control<DiagramView>("influenceView");
  EXPECT_TRUE(view.placeholder().startsWith("The influences are being computed"));
  ASSERT_TRUE(waitFor([&] { return view.isPainted(); }));
  const QImage first = view.image();
  auto& choice = control<QComboBox>("influenceChoice");
  choice.setCurrentIndex(1);
  // The other diagram would pass for that of the wavelengths.
  EXPECT_TRUE(view.image().isNull());
  EXPECT_TRUE(view.placeholder().startsWith("The influences are being computed"));
  ASSERT_TRUE(waitFor([&] { return view.isPainted() && view.image() != first; }));
}

TEST_F(CurveCommandsTest, PinsAreKeptComparedAndLetGo) {
  ASSERT_TRUE(waitForCurve());
  action("pinCurve").trigger();
  Scene scene = session().scene();
  scene.elastomer.shearModulus *= 2;
  window_.document().edit(scene);
  ASSERT_TRUE(waitForCurve());
  action("pinCurve").trigger();
  ASSERT_EQ(session().friction().pinned().size(), 2U);
  ASSERT_TRUE(waitFor([this] { return chart().series.size() == 4; }));
  EXPECT_EQ(chart().series[1].name.english(), "G = 10 MPa");

  auto* menu = window_.findChild<QMenu*>("unpinMenu");
  ASSERT_TRUE(menu);
  emit menu->aboutToShow();
  ASSERT_EQ(menu->actions().size(), 2);
  EXPECT_EQ(menu->actions()[0]->text().remove(u'&'), QStringLiteral("G = 10 MPa"));
  menu->actions()[0]->trigger();
  EXPECT_EQ(session().friction().pinned().size(), 1U);
  action("unpinAll").trigger();
  EXPECT_TRUE(session().friction().pinned().empty());
  EXPECT_FALSE(action("unpinAll").isEnabled());
  emit menu->aboutToShow();
  ASSERT_EQ(menu->actions().size(), 1);
  EXPECT_EQ(menu->actions()[0]->text().remove(u'&'), "No curve is pinned");
  EXPECT_FALSE(menu->actions()[0]->isEnabled());
}

TEST_F(CurveCommandsTest, DimensionlessAxesStayWhileScenesChange) {
  ASSERT_TRUE(waitForCurve());
  action("dimensionlessAxes").trigger();
  Scene scene = session().scene();
  scene.load.normalForce *= 3;
  window_.document().edit(scene);
  ASSERT_TRUE(waitForCurve());
  EXPECT_NE(chart().x.title.english().find("∇z"), std::string::npos);
  const double from = velocity();
  const double x = chart().marker->x;
  EXPECT_NE(x, from);
  drag(at(x, middle()), at(x / 10, middle()));
  EXPECT_NEAR(velocity() / (from / 10), 1, 0.05) << "the marker moves in the axis' own numbers";
  action("dimensionlessAxes").trigger();
  ASSERT_TRUE(waitFor([this] { return chart().marker->x == velocity(); }));
}

TEST_F(CurveCommandsTest, WhatIsShownIsSavedInEveryFormatAndOpensAgain) {
  ASSERT_TRUE(waitForCurve());
  action("pinCurve").trigger();
  Scene scene = session().scene();
  scene.elastomer.shearModulus *= 2;
  window_.document().edit(scene);
  ASSERT_TRUE(waitForCurve());
  const QTemporaryDir folder;
  for (const char* name : {"curve.png", "curve.svg", "curve.pdf", "curve.csv"}) {
    QSignalSpy exported(&window_.curveCommands(), &CurveCommands::exported);
    const QString file = folder.filePath(name);
    window_.curveCommands().save(file);
    ASSERT_TRUE(waitFor([&] { return exported.count() == 1; })) << name;
    EXPECT_EQ(findScene(file.toStdString()).scene.elastomer, scene.elastomer) << name;
    QFile written(file);
    ASSERT_TRUE(written.open(QIODevice::ReadOnly));
    const QByteArray bytes = written.readAll();
    EXPECT_GT(bytes.size(), 1000);
    const bool isTable = QString(name).endsWith("csv"), isText = QString(name).endsWith("svg");
    EXPECT_EQ(bytes.contains("\nG = 10 MPa,"), isTable) << name;
    EXPECT_EQ(bytes.contains("linear") && bytes.contains("G = 10 MPa"), isText) << name;
  }
}

TEST_F(CurveCommandsTest, AnUnknownFormatIsRefusedInTheBar) {
  ASSERT_TRUE(waitForCurve());
  const QTemporaryDir folder;
  window_.curveCommands().save(folder.filePath("curve.xyz"));
  ASSERT_TRUE(waitFor([this] { return window_.messages().isVisible(); }));
  EXPECT_FALSE(QFile::exists(folder.filePath("curve.xyz")));
}

TEST_F(CurveCommandsTest, AFolderThatDoesNotExistIsNamedInTheBar) {
  ASSERT_TRUE(waitForCurve());
  const QTemporaryDir folder;
  window_.curveCommands().save(folder.filePath("no_such_folder/curve.png"));
  ASSERT_TRUE(waitFor([this] { return window_.messages().isVisible(); }));
  EXPECT_TRUE(window_.messages().text().contains("does not exist"))
      << window_.messages().text().toStdString();
}

TEST_F(CurveCommandsTest, ThePictureGoesToTheClipboard) {
  ASSERT_TRUE(waitForCurve());
  QGuiApplication::clipboard()->clear();
  QSignalSpy exported(&window_.curveCommands(), &CurveCommands::exported);
  action("copyCurvePicture").trigger();
  ASSERT_TRUE(waitFor([&] { return exported.count() == 1; }));
  EXPECT_GE(QGuiApplication::clipboard()->image().width(), 900);
}

TEST_F(CurveCommandsTest, ASettingChosenInTheAccuracyPanelIsComparedBelowTheCurve) {
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

TEST_F(CurveCommandsTest, ATargetLeavesNothingToCompare) {
  ASSERT_TRUE(waitForCurve());
  control<QCheckBox>("comparisonWanted").setChecked(true);
  ASSERT_TRUE(waitFor([this] { return plot().sheet().diagrams.size() == 2; }));
  Scene scene = session().scene();
  scene.accuracy.targetRelativeError = 0.1;
  window_.document().edit(scene);
  EXPECT_FALSE(control<QWidget>("comparisonBox").isEnabled());
  ASSERT_TRUE(waitFor([this] { return plot().sheet().diagrams.size() == 1; }));
}

TEST_F(CurveCommandsTest, ASliderBringsANewCurveAtOnceAndNeverMixesItWithTheOld) {
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
