// The commands of the friction diagram: axes and their zoom, pins, families, files, the clipboard.
#include <gtest/gtest.h>

#include <QAction>
#include <QClipboard>
#include <QFile>
#include <QMenu>
#include <QSignalSpy>
#include <QTemporaryDir>

#include "core/base/number_text.h"
#include "core/friction/ensemble.h"
#include "core/scene/provenance.h"
#include "tests/ui/window/curve/curve_fixture.h"
#include "tests/ui/window/fresh_paints.h"
#include "tests/ui/window/main_window_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "ui/chart/chart_view.h"
#include "ui/panels/value_slider.h"
#include "ui/window/curve/curve_commands.h"
#include "ui/window/figures/diagram_view.h"
#include "ui/window/main/exports.h"
#include "ui/window/main/message_bar.h"
#include "ui/window/main/session.h"

namespace asperity {
namespace {

using CurveCommandsTest = CurveTest;

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
    const QString file = folder.filePath(name);
    window_.curveCommands().save(file);
    ASSERT_TRUE(waitFor([&] { return said() == QStringLiteral("Saved %1").arg(name); })) << name;
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
  action("copyCurvePicture").trigger();
  ASSERT_TRUE(waitFor([&] { return said() == "The curve's picture is on the clipboard"; }));
  EXPECT_GE(QGuiApplication::clipboard()->image().width(), 900);
}

}  // namespace
}  // namespace asperity
