// The page of a fit as a person uses it: ticking, limits, running, stopping, taking the values,
// writing the report; theories and measured tables in the menu of the curve.
#include "ui/window/fit/fit_page.h"
#include "ui/panels/panel_style.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QElapsedTimer>
#include <QEvent>
#include <QFile>
#include <QListWidget>
#include <QMenu>
#include <QPointer>
#include <QProcess>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSpinBox>
#include <QTabBar>
#include <QTableWidget>
#include <QToolButton>
#include <algorithm>

#include "core/chart/curve_diagram.h"
#include "core/friction/steady_states.h"
#include "core/scene/scene_file.h"
#include "tests/ui/window/fit/fit_page_fixture.h"
#include "tests/ui/window/main_window_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "ui/language/language.h"
#include "ui/window/curve/comparison_commands.h"
#include "ui/window/figures/diagram_view.h"
#include "ui/window/fit/fit_results.h"
#include "ui/window/import/import_commands.h"

namespace asperity {
namespace {

TEST_F(FitPageTest, FindsTheValuesAndTheSceneTakesThemInOneStep) {
  FitPage& page = openPage(withData());
  EXPECT_FALSE(button(page, "fitRun").isEnabled());  // nothing is ticked
  tick(page, "surface.rms_height");
  tick(page, "elastomer.relaxation_time");
  ASSERT_TRUE(fit(page));
  ASSERT_TRUE(page.fitted()) << page.errorText().toStdString();
  // The same lines made the data: what is left is the rounding of the table.
  const Scene before = smallScene();
  const Fit& found = page.fitted()->fit;
  EXPECT_NEAR(found.scene.surface.rmsHeight / before.surface.rmsHeight, 1.3, 1e-3);
  EXPECT_NEAR(found.scene.elastomer.relaxationTime / before.elastomer.relaxationTime, 2, 2e-3);
  EXPECT_TRUE(page.findChild<QLabel*>("fitTable")->isVisibleTo(&page));
  const int steps = window_.document().history().count();
  button(page, "fitUse").click();
  EXPECT_EQ(window_.document().history().count(), steps + 1);
  // The scene has as many digits as the error allows.
  EXPECT_NEAR(scene().surface.rmsHeight / found.scene.surface.rmsHeight, 1, 5e-4);
  EXPECT_EQ(scene().ensemble, withData().ensemble);
  EXPECT_EQ(scene().comparison, withData().comparison);
  window_.document().history().undo();
  EXPECT_DOUBLE_EQ(scene().surface.rmsHeight, before.surface.rmsHeight);
  EXPECT_DOUBLE_EQ(scene().elastomer.relaxationTime, before.elastomer.relaxationTime);
}

TEST(FitTable, WarnsInTheColourOfWarnings) {
  Fit fit;
  fit.hasFoundPoints = true;
  fit.parameters = {{.key = "surface.rms_height", .value = 1e-6, .isDetermined = false}};
  const QString warning = QStringLiteral("<span style='color:#8a5a00'>⚠ ");
  EXPECT_TRUE(fittedTable(fit, QColor("#8a5a00")).contains(warning));
  fit.parameters[0].isDetermined = true;
  EXPECT_FALSE(fittedTable(fit, QColor("#8a5a00")).contains("color:"));
}

/// Before a fit there is nothing to show but how to begin; tables are shown by their file names.
TEST_F(FitPageTest, ShowsNoEmptyDiagramBeforeTheFirstFit) {
  FitPage& page = openPage(withData());
  EXPECT_FALSE(page.findChild<QTabBar*>("fitSheets")->isVisibleTo(&page));
  EXPECT_FALSE(page.findChild<DiagramView*>("fitSheet")->isVisibleTo(&page));
  EXPECT_EQ(page.findChild<QListWidget*>("fitTables")->item(0)->text(), "mine.csv");
}

/// The correlations are a line of the notes, which wraps.
TEST_F(FitPageTest, TheValuesFitIntoANarrowPage) {
  useLanguage("de");
  FitPage& page = openPage(withData());
  page.resize(984, 620);
  tick(page, "surface.rms_height");
  tick(page, "elastomer.relaxation_time");
  ASSERT_TRUE(fit(page));
  ASSERT_TRUE(page.fitted()) << page.errorText().toStdString();
  const QString notes = page.findChild<QLabel*>("fitNotes")->text();
  EXPECT_TRUE(notes.contains("Korrelation: r("));
  EXPECT_TRUE(notes.contains("mine: ")) << notes.toStdString();
  EXPECT_FALSE(notes.contains(QStringLiteral("⚠"))) << notes.toStdString();
  EXPECT_EQ(page.findChild<QLabel*>("fitWarnings")->property("role").toString(), "warning");
  EXPECT_TRUE(page.findChild<DiagramView*>("fitSheet")->isVisibleTo(&page));
  const auto* texts = page.findChild<QScrollArea*>();
  ASSERT_TRUE(texts->isAncestorOf(page.findChild<QLabel*>("fitTable")));
  EXPECT_TRUE(waitFor([&] { return texts->horizontalScrollBar()->maximum() == 0; }));
  EXPECT_EQ(texts->verticalScrollBar()->maximum(), 0);
  useLanguage("en");
}

TEST_F(FitPageTest, TheReportIsThatOfTheCommand) {
  FitPage& page = openPage(withData());
  tick(page, "surface.rms_height");
  const int row = rowOf(keysOf(page), "surface.rms_height");
  keysOf(page).item(row, 2)->setText("100 nm");
  keysOf(page).item(row, 3)->setText("5 um");
  ASSERT_TRUE(fit(page));
  page.findChild<DiagramView*>("fitSheet")->files().save("/no/such/folder/fit.png");
  EXPECT_TRUE(waitFor([&] { return page.errorText().contains("/no/such/folder"); }));
  const QString folder = folder_.filePath("window");
  page.setFolderChooser([&](QWidget*, const QString&) { return folder; });
  button(page, "fitSave").click();
  EXPECT_TRUE(waitFor([&] { return page.errorText().startsWith("Saved "); }))
      << page.errorText().toStdString();
  const auto& message = *page.findChild<QLabel*>("fitComplaint");
  EXPECT_EQ(message.palette().color(QPalette::WindowText),
            page.palette().color(QPalette::WindowText));  // it is no error
  QFile scene(folder_.filePath("s.json"));
  ASSERT_TRUE(scene.open(QIODevice::WriteOnly));
  scene.write(QByteArray::fromStdString(writeScene(withData())));
  scene.close();
  QProcess program;
  program.setWorkingDirectory(folder_.path());
  program.start(ASPERITY_PROGRAM,
                {"fit", "s.json", "--vary", "surface.rms_height=1e-7:5e-6", "-o", "command"});
  ASSERT_TRUE(program.waitForFinished(kWindowPatience));
  ASSERT_EQ(program.exitCode(), 0) << program.readAllStandardError().toStdString();
  for (const char* name : {"fit.json", "fit.csv", "curve.svg", "profiles.svg", "curve.pdf"}) {
    QFile mine(QDir(folder).filePath(name)), its(folder_.filePath("command/" + QString(name)));
    ASSERT_TRUE(mine.open(QIODevice::ReadOnly)) << name;
    ASSERT_TRUE(its.open(QIODevice::ReadOnly)) << name;
    EXPECT_EQ(mine.readAll(), its.readAll()) << name;
  }
  for (const char* name : {"curve.png", "profiles.png", "fitted.scene.json"})
    EXPECT_TRUE(QFile::exists(QDir(folder).filePath(name))) << name;
}

/// The disk may be full: nobody would learn it from a page that is gone.
TEST_F(FitPageTest, ThePageStaysUntilItsReportIsWritten) {
  QPointer<FitPage> page = &openPage(withData());
  tick(*page, "surface.rms_height");
  ASSERT_TRUE(fit(*page));
  page->setFolderChooser([&](QWidget*, const QString&) { return file_; });
  button(*page, "fitSave").click();
  page->close();
  ASSERT_TRUE(page && page->isVisible());
  EXPECT_TRUE(waitFor([&] { return page->errorText().contains("mine.csv"); }));
  page->close();
  EXPECT_TRUE(waitFor([&] { return page.isNull(); }));
}

TEST_F(FitPageTest, IsStoppedAtOnceAndBeginsAgain) {
  Scene large = withData();
  large.ensemble.realizations = 20000;
  FitPage& page = openPage(large);
  tick(page, "surface.rms_height");
  tick(page, "elastomer.relaxation_time");
  button(page, "fitRun").click();
  EXPECT_TRUE(page.isFitting());
  EXPECT_FALSE(button(page, "fitUse").isEnabled());
  QTest::qWait(100);
  QElapsedTimer time;
  time.start();
  button(page, "fitRun").click();
  EXPECT_FALSE(page.isFitting());
  EXPECT_LT(time.elapsed(), 50);
  EXPECT_FALSE(page.errorText().isEmpty());
  EXPECT_FALSE(page.fitted());
  page.findChild<QSpinBox*>("fitLines")->setValue(3);
  ASSERT_TRUE(fit(page));
  EXPECT_TRUE(page.fitted()) << page.errorText().toStdString();
  EXPECT_EQ(page.fitted()->fit.scene.ensemble.realizations, 3);
}

TEST_F(FitPageTest, ReturnPressesTheButtonWithTheFocus) {
  FitPage& page = openPage(withData());
  ASSERT_TRUE(QTest::qWaitForWindowActive(&page));
  auto& lines = *page.findChild<QSpinBox*>("fitLines");
  lines.setFocus();
  QTest::keyClick(&lines, Qt::Key_Return);
  EXPECT_TRUE(page.isVisible());
  button(page, "fitClose").setFocus();
  QTest::keyClick(&button(page, "fitClose"), Qt::Key_Return);
  EXPECT_FALSE(page.isVisible());
}

TEST_F(FitPageTest, WhatCannotBeFittedIsSaidOnThePage) {
  QFile bad(folder_.filePath("bad.csv"));
  ASSERT_TRUE(bad.open(QIODevice::WriteOnly));
  bad.write("velocity,mu\n1,0.2\n2,0.3\n");
  bad.close();
  Scene scene = smallScene();
  scene.comparison.data = {{bad.fileName().toStdString(), {}}};
  FitPage& page = openPage(scene);
  tick(page, "surface.rms_height");
  tick(page, "elastomer.relaxation_time");
  ASSERT_TRUE(fit(page));
  EXPECT_FALSE(page.fitted());
  EXPECT_TRUE(page.errorText().contains("2 points")) << page.errorText().toStdString();
  EXPECT_FALSE(page.errorText().contains("--data"));
  for (const bool isDark : {true, false}) {
    window_.appearance().setDark(isDark);
    const QPalette colours = page.findChild<QLabel*>("fitComplaint")->palette();
    EXPECT_EQ(colours.color(QPalette::WindowText), errorColour(page.palette()));
    EXPECT_EQ(asperity::isDark(page.palette()), isDark);
  }
}

TEST_F(FitPageTest, TheoriesAreChosenByNameAndUndone) {
  auto& theory = action("theory:persson_half_space");
  EXPECT_TRUE(action("theory:eq_11").isChecked());
  EXPECT_FALSE(theory.isChecked());
  EXPECT_TRUE(theory.toolTip().contains("Persson (2001)"));
  theory.trigger();
  EXPECT_EQ(scene().comparison.theory, (std::vector{Theory::Eq11, Theory::PerssonHalfSpace}));
  const auto isDrawn = [&] {
    return std::ranges::any_of(chart().series, [](const DiagramSeries& series) {
      return series.id <= kTheoryCurves && series.id > kMeasuredCurves;
    });
  };
  EXPECT_TRUE(waitFor(isDrawn));
  action("theory:eq_11").trigger();
  EXPECT_EQ(scene().comparison.theory, (std::vector{Theory::PerssonHalfSpace}));
  window_.document().history().undo();
  EXPECT_TRUE(action("theory:eq_11").isChecked());
  window_.document().history().undo();
  EXPECT_FALSE(theory.isChecked());
  EXPECT_TRUE(waitFor([&] { return !isDrawn(); }));
}

/// The button gets its text in another language after the tabs have theirs.
TEST_F(FitPageTest, TheTabsKeepRoomForTheButtonWhateverItsText) {
  window_.document().open(withData());
  const auto& tabs = control<QTabWidget>("tabs");
  auto& button = control<QToolButton>("fitButton");
  ASSERT_TRUE(waitForFrame());  // the layout is done
  const int before = tabs.minimumSizeHint().width(), width = button.sizeHint().width();
  button.setText(button.text().repeated(3));
  QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
  EXPECT_GT(button.sizeHint().width(), width);
  EXPECT_EQ(tabs.minimumSizeHint().width() - before, button.sizeHint().width() - width);
}

TEST_F(FitPageTest, MeasuredTablesAreRemovedFromTheMenu) {
  EXPECT_FALSE(control<QToolButton>("fitButton").isVisible());
  window_.document().open(withData());
  EXPECT_TRUE(control<QToolButton>("fitButton").isVisible());
  const auto& sheet = [&]() -> DiagramSheet { return window_.plotView().sheet(); };
  ASSERT_TRUE(waitFor([&] { return sheet().diagrams.size() == 2; }));
  auto& menu = control<QMenu>("measuredMenu");
  emit menu.aboutToShow();
  action("measured:0").trigger();
  EXPECT_TRUE(scene().comparison.data.empty());
  EXPECT_FALSE(control<QToolButton>("fitButton").isVisible());
  emit menu.aboutToShow();
  ASSERT_EQ(menu.actions().size(), 1);
  EXPECT_EQ(menu.actions()[0]->text().remove('&'), "The scene has no measured friction");
  EXPECT_FALSE(menu.actions()[0]->isEnabled());
  EXPECT_TRUE(waitFor([&] { return sheet().diagrams.size() == 1; }));
}

}  // namespace
}  // namespace asperity
