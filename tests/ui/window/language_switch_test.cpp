// The window's language changed while it is open: all words are the other language's, and all else
// stays as it was.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QDockWidget>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QSpinBox>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QToolButton>
#include <QUndoStack>
#include <vector>

#include "tests/core/elastomers.h"
#include "tests/ui/window/qt_application.h"
#include "tests/ui/window/window_in.h"
#include "ui/chart/chart_view.h"
#include "ui/panels/elastomer_tables.h"
#include "ui/window/accuracy/region_pictures.h"
#include "ui/window/contact/contact_canvas.h"
#include "ui/window/figures/claims_table.h"
#include "ui/window/figures/figures_page.h"
#include "ui/window/main/message_bar.h"
#include "ui/window/main/run_window.h"
#include "ui/window/main/scene_document.h"

namespace asperity {
namespace {

using testing::IsEmpty;

TEST(LanguageSwitch, LeavesNoWordBehindInEitherDirection) {
  WindowIn window("en");
  ASSERT_TRUE(window.waitForCurve());
  window->findChild<QAction*>("tour")->trigger();
  ASSERT_TRUE(window.waitForCurve());
  const Texts english = textsOf(*window);
  window->setLanguage("de");
  EXPECT_EQ(presentLanguage(), "de");
  ASSERT_TRUE(window.waitForCurve());
  EXPECT_TRUE(window->tour().isRunning());
  const Texts german = textsOf(*window);
  EXPECT_THAT(leftOver(german, english), IsEmpty());
  EXPECT_GT(german.size(), 150U);
  EXPECT_EQ(cutOffIn(*window), "");
  window->setLanguage("en");
  const Texts back = textsOf(*window);
  EXPECT_THAT(leftOver(back, german), IsEmpty());
  EXPECT_TRUE(back.contains("Friction curve"));
}

TEST(LanguageSwitch, KeepsSceneHistoryRunsAndLayout) {
  WindowIn window("en");
  ASSERT_TRUE(window.waitForCurve());
  Scene scene = window->session().scene();
  scene.load.normalForce = 0.01;
  window->document().edit(scene);
  window->findChild<QAction*>("resetAll")->trigger();
  window->document().history().undo();
  window->appearance().setDark(true);
  window->findChild<QDockWidget*>("parameterDock")->hide();
  auto* tabs = window->findChild<QTabWidget*>("tabs");
  const QString name = tabs->widget(2)->objectName();
  tabs->setCurrentIndex(2);
  window->session().setPlaying(false);
  const auto number = window->session().sceneNumber();
  const auto actions = window->findChildren<QAction*>().size();

  for (const char* code : {"de", "en", "de"}) window->setLanguage(code);
  EXPECT_EQ(window->session().scene(), scene);
  EXPECT_EQ(window->session().sceneNumber(), number);  // nothing was begun anew
  EXPECT_FALSE(window->session().isPlaying());
  EXPECT_TRUE(window->appearance().isDark());
  EXPECT_TRUE(window->findChild<QDockWidget*>("parameterDock")->isHidden());
  tabs = window->findChild<QTabWidget*>("tabs");
  EXPECT_EQ(tabs->currentWidget()->objectName(), name);
  EXPECT_EQ(window->findChildren<QAction*>().size(), actions);
  EXPECT_EQ(window->findChild<QAction*>("play")->text(), "Start");

  QUndoStack& history = window->document().history();
  EXPECT_EQ(history.count(), 2);
  EXPECT_EQ(history.undoText(), "Normalkraft");
  EXPECT_EQ(history.redoText(), "Alle Parameter");
  window->findChild<QAction*>("undo")->trigger();
  EXPECT_EQ(window->session().scene().load.normalForce, smallScene().load.normalForce);
  EXPECT_EQ(window->panel().scene(), window->session().scene());
  QTest::keyClick(&*window, Qt::Key_F9);  // the key is no one's twice
  EXPECT_FALSE(window->findChild<QDockWidget*>("parameterDock")->isHidden());
}

TEST(LanguageSwitch, KeepsWhatIsInSight) {
  WindowIn window("en");
  ASSERT_TRUE(window.waitForCurve());
  window->findChild<QAction*>("dimensionlessAxes")->trigger();
  window->plotView().zoom(0.5);
  const VisibleRange zoomed = window->plotView().visibleRange();
  window->canvas().zoom(3);
  for (const char* name : {"followLine", "magnify"}) window->findChild<QAction*>(name)->trigger();
  const ViewNavigation view = window->canvas().viewer().navigation();

  for (const char* code : {"de", "en"}) {
    window->setLanguage(code);
    EXPECT_TRUE(window->plotView().isZoomed());
    EXPECT_EQ(window->plotView().visibleRange(), zoomed);
    EXPECT_EQ(window->canvas().viewer().navigation(), view);
    for (const char* name : {"dimensionlessAxes", "followLine", "magnify"})
      EXPECT_TRUE(window->findChild<QAction*>(name)->isChecked()) << name;
  }
}

TEST(LanguageSwitch, KeepsAFoldedTableAndHowFarThePanelIsScrolled) {
  Scene scene = smallScene();
  scene.elastomer.rheology = Rheology::Prony;
  scene.elastomer.arms = {{1e6, 1e-3}, {1e7, 1e-2}};
  WindowIn window("en", scene);
  window->panel().setView({true, {}});
  const auto bar = [&] { return window->panel().findChild<QScrollArea*>()->verticalScrollBar(); };
  window->findChild<QToolButton*>("armsFold")->click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return bar()->maximum() > 50; }, kWindowPatience));
  bar()->setValue(50);
  window->setLanguage("de");
  EXPECT_FALSE(window->findChild<ArmsEditor*>()->isVisible());
  EXPECT_EQ(bar()->value(), 50);
}

TEST(LanguageSwitch, KeepsWhatIsBeingTypedAndWhyItWasRefused) {
  Scene scene = smallScene();
  scene.elastomer.rheology = Rheology::Prony;
  scene.elastomer.arms = {{1e6, 1e-3}};
  WindowIn window("en", scene);
  ASSERT_TRUE(window.waitForCurve());
  const auto type = [&](const char* name, const char* text) {
    auto* entry = window->findChild<ValueEntry*>(name);
    entry->setFocus();
    entry->selectAll();
    QTest::keyClicks(entry, text);
    return entry;
  };
  QTest::keyClick(type("entry:surface.hurst", "1.4"), Qt::Key_Return);
  QTest::keyClick(type("armModulus:0", "1 s"), Qt::Key_Return);
  type("entry:load.normal_force", "3.")->setCursorPosition(1);
  window->setLanguage("de");
  auto* hurst = window->findChild<ValueEntry*>("entry:surface.hurst");
  EXPECT_EQ(hurst->text(), "1.4");
  EXPECT_TRUE(hurst->hasError());
  EXPECT_EQ(window->findChild<QLabel*>("error:surface.hurst")->text(),
            "1,4 liegt außerhalb von 0 bis 1");
  auto* modulus = window->findChild<ValueEntry*>("armModulus:0");
  EXPECT_EQ(modulus->text(), "1 s");
  EXPECT_TRUE(modulus->hasError());
  EXPECT_THAT(window->findChild<QLabel*>("armError:0")->text().toStdString(),
              testing::StartsWith("1 s ist eine Zeit"));
  auto* force = window->findChild<ValueEntry*>("entry:load.normal_force");
  EXPECT_EQ(force->text(), "3.");
  EXPECT_FALSE(force->hasError());
  EXPECT_EQ(window->focusWidget(), force);
  EXPECT_EQ(force->cursorPosition(), 1);

  QTest::keyClicks(force, "0");
  QTest::keyClick(force, Qt::Key_Return);
  EXPECT_EQ(window->session().scene().load.normalForce, 0.03);  // "30." of the unit shown, mN
  QTest::keyClick(hurst, Qt::Key_Escape);
  EXPECT_EQ(hurst->text(), "0,7");
  EXPECT_FALSE(hurst->hasError());
}

TEST(LanguageSwitch, KeepsTheFiguresPage) {
  WindowIn window("en");
  window->appearance().setDark(true);
  window->resize(1920, 1080);
  window->pages().openFigures();
  window->pages().figuresPage().findChild<QSpinBox*>("realizations")->setValue(2);
  window->pages().figuresPage().choose(FigureName::Exponents, true);
  const auto made = [&] {
    return window->pages().figuresPage().queue().status(FigureName::Exponents).made != nullptr;
  };
  ASSERT_TRUE(QTest::qWaitFor(made, 6 * kWindowPatience));
  const auto claims = [&] { return window->pages().figuresPage().findChild<ClaimsTable*>(); };
  ASSERT_GT(claims()->rowCount(), 1);
  claims()->selectRow(1);
  std::vector<int> heights;
  for (int row = 0; row < claims()->rowCount(); ++row) heights.push_back(claims()->rowHeight(row));

  window->setLanguage("de");
  EXPECT_EQ(window->pages().figuresPage().findChild<QSpinBox*>("realizations")->value(), 2);
  EXPECT_EQ(claims()->unfolded(), 1);
  window->setLanguage("en");
  EXPECT_EQ(window->pages().figuresPage().chosen(), FigureName::Exponents);
  EXPECT_EQ(claims()->unfolded(), 1);
  const auto haveTheirHeights = [&] {
    for (int row = 0; row < claims()->rowCount(); ++row)
      if (claims()->rowHeight(row) != heights.at(static_cast<std::size_t>(row))) return false;
    return true;
  };
  EXPECT_TRUE(QTest::qWaitFor(haveTheirHeights, kWindowPatience));
}

TEST(LanguageSwitch, KeepsComplaintsComparisonsAndFigures) {
  WindowIn window("en");
  ASSERT_TRUE(window.waitForCurve());
  window->findChild<QCheckBox*>("comparisonWanted")->setChecked(true);
  window->pages().openFigures();
  FigureQueue* figures = &window->pages().figuresPage().queue();
  window->setLanguage("de");
  EXPECT_TRUE(window->pages().isShowingFigures());
  EXPECT_EQ(&window->pages().figuresPage().queue(), figures);
  window->pages().showViews();
  EXPECT_TRUE(window->findChild<QCheckBox*>("comparisonWanted")->isChecked());

  Scene empty = smallScene();
  empty.elastomer = prony(0, {});
  window->document().edit(empty);
  ASSERT_TRUE(QTest::qWaitFor([&] { return window->messages().isVisible(); }, kWindowPatience));
  EXPECT_TRUE(window->messages().text().startsWith("Gleichgewichtsmodul: "));
  window->setLanguage("en");
  EXPECT_TRUE(window->messages().isVisible());
  EXPECT_TRUE(window->messages().text().startsWith("equilibrium modulus: "));
  EXPECT_TRUE(window->findChild<ValueEntry*>("entry:elastomer.equilibrium_modulus")->hasError());
}

TEST(LanguageSwitch, TranslatesAMessageThatIsNotAboutTheScene) {
  WindowIn window("en");
  ASSERT_TRUE(window.waitForCurve());
  const QTemporaryDir folder;
  const QString file = folder.filePath("scene.json");
  ASSERT_FALSE(openIn(*window, file));
  const QString english = window->messages().text();
  window->setLanguage("de");
  EXPECT_TRUE(window->messages().isVisible());
  EXPECT_NE(window->messages().text(), english);
  const QString label = window->messages().findChild<QLabel*>("messageText")->text();
  EXPECT_EQ(label, window->messages().text());
  window->messages().hide();
  EXPECT_FALSE(openIn(*window, file));
  EXPECT_EQ(window->messages().text(), label) << "as in a window that was always German";
  window->messages().end(MessageBar::Failure::Scene);
  EXPECT_TRUE(window->messages().isVisible());
  window->messages().hide();
  window->setLanguage("en");
  EXPECT_FALSE(window->messages().isVisible());
}

TEST(LanguageSwitch, KeepsTheMeasuredComparisonOfMethods) {
  WindowIn window("en");
  auto* pictures = window->findChild<RegionPictures*>("regionPictures");
  ASSERT_TRUE(pictures);
  DiagramSheet sheet;
  sheet.diagrams.resize(2);
  sheet.diagrams[0].title = "region I: here";
  sheet.diagrams[1].title = "region II: there";
  pictures->showSheet(sheet);
  window->setLanguage("de");
  EXPECT_TRUE(pictures->hasSheet());
  EXPECT_TRUE(pictures->findChild<QToolButton*>("region:1"));
}

TEST(WindowLanguageMenu, TheChoiceCountsAtOnceAndIsRemembered) {
  WindowIn window("en");
  auto* german = window->findChild<QAction*>("language:de");
  ASSERT_TRUE(german);
  german->trigger();
  EXPECT_EQ(windowLanguage(), "de");
  ASSERT_TRUE(QTest::qWaitFor([] { return presentLanguage() == "de"; }, kWindowPatience));
  EXPECT_TRUE(window->findChild<QAction*>("language:de")->isChecked());
  EXPECT_EQ(window->findChild<QTabWidget*>("tabs")->tabText(0), "Reibungskurve");
  window->findChild<QAction*>("language:en")->trigger();
  EXPECT_EQ(windowLanguage(), "en");
  ASSERT_TRUE(QTest::qWaitFor([] { return presentLanguage() == "en"; }, kWindowPatience));
  window->findChild<QAction*>("language:")->trigger();
  EXPECT_FALSE(QSettings().contains("language"));
}

}  // namespace
}  // namespace asperity
