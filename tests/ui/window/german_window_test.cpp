// The window in each language at 1280 x 720: nothing is left in English, and nothing is cut off.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QDialog>
#include <QDockWidget>
#include <QFile>
#include <QScrollBar>
#include <QSlider>
#include <QTabBar>
#include <QTabWidget>
#include <QTemporaryDir>
#include <algorithm>
#include <array>
#include <cmath>

#include "tests/core/elastomers.h"
#include "tests/ui/window/qt_application.h"
#include "tests/ui/window/window_in.h"
#include "ui/panels/boxes.h"
#include "ui/panels/value_slider.h"
#include "ui/window/accuracy/accuracy_panel.h"
#include "ui/window/figures/diagram_view.h"
#include "ui/window/figures/figure_list.h"
#include "ui/window/figures/figures_page.h"
#include "ui/window/import/import_commands.h"
#include "ui/window/import/material_import.h"
#include "ui/window/import/surface_import.h"
#include "ui/window/main/message_bar.h"
#include "ui/window/main/scene_library.h"
#include "ui/window/main/window_keys.h"

namespace asperity {
namespace {

using testing::IsEmpty;

/// What a window says in a language, its sheet of shortcuts and a step of its tour included.
Texts allTextsIn(std::string_view code) {
  WindowIn window(code);
  EXPECT_TRUE(window.waitForCurve());
  Texts texts = textsOf(*window);
  for (const char* command : {"shortcuts", "tour"}) {
    window->findChild<QAction*>(command)->trigger();
    texts.merge(textsOf(*window));
  }
  return texts;
}

TEST(GermanWindow, HasNothingLeftInEnglish) {
  const Texts english = allTextsIn("en"), german = allTextsIn("de");
  EXPECT_GT(german.size(), 150U);
  EXPECT_THAT(leftOver(german, english), IsEmpty());
  EXPECT_TRUE(german.contains("Reibungskurve"));
}

class WindowInEachLanguage : public testing::TestWithParam<const char*> {};

TEST_P(WindowInEachLanguage, NothingIsCutOff) {
  WindowIn window(GetParam());
  ASSERT_TRUE(window.waitForCurve());
  auto& tabs = *window->findChild<QTabWidget*>("tabs");
  for (const bool dark : {false, true}) {
    window->appearance().setDark(dark);
    for (int tab = 0; tab < tabs.count(); ++tab) {
      tabs.setCurrentIndex(tab);
      EXPECT_EQ(cutOffIn(*window), "") << tabs.tabText(tab).toStdString();
    }
  }
}

/// No page of a tab needs more width than the others: the views above stay where they are, and
/// nothing on the page is cut off, also while a map is computed.
TEST_P(WindowInEachLanguage, NoTabMovesTheViewsOfASmallWindow) {
  WindowIn window(GetParam());
  ASSERT_TRUE(window.waitForCurve());
  window->resize(1024, 700);
  auto& tabs = *window->findChild<QTabWidget*>("tabs");
  QTest::qWait(100);
  const QSize before = tabs.size();
  for (int tab = 0; tab < tabs.count(); ++tab) {
    if (!tabs.isTabVisible(tab)) continue;
    tabs.setCurrentIndex(tab);
    QTest::qWait(100);
    EXPECT_EQ(tabs.width(), before.width()) << tabs.tabText(tab).toStdString();
    EXPECT_EQ(cutOffIn(*window), "") << tabs.tabText(tab).toStdString();
  }
  const auto& progress = *window->findChild<QLabel*>("mapProgress");
  const auto& quantity = *window->findChild<QWidget*>("mapQuantity");
  EXPECT_GE(progress.minimumWidth(),
            progress.fontMetrics().horizontalAdvance("200 lines, 38 % done"));
  EXPECT_EQ(progress.parentWidget()->width(), progress.width());
  EXPECT_LE(quantity.geometry().right(), progress.parentWidget()->x());
}

/// Every tab is in sight, with a whole title, also that of a motion.
TEST_P(WindowInEachLanguage, EveryTabIsInSightInASmallWindow) {
  WindowIn window(GetParam());
  Scene moving = smallScene();
  moving.sliding.kind = SlidingKind::Oscillation;
  moving.sliding.amplitude = 0.5;
  auto& tabs = *window->findChild<QTabWidget*>("tabs");
  const QTabBar& bar = *tabs.tabBar();
  const auto isWhole = [&](int tab) {
    constexpr std::array kAir{14, 7, 4};  // at each side, as in the style sheet
    const int text = bar.fontMetrics().size(Qt::TextShowMnemonic, bar.tabText(tab)).width();
    const auto crowded = static_cast<std::size_t>(bar.property("crowded").toInt());
    return bar.tabRect(tab).width() >= text + 2 * kAir[crowded];
  };
  for (const Scene& scene : {smallScene(), moving}) {
    window->document().open(scene);
    for (const QSize size : {QSize(1024, 700), QSize(1280, 720), QSize(1024, 700)}) {
      window->resize(size);
      const auto isInSight = [&] {
        for (int i = 0; i < bar.count(); ++i) {
          if (!bar.isTabVisible(i)) continue;
          const QRect place = bar.tabRect(i);
          if (place.right() >= bar.width() || !isWhole(i) || place.left() < 0) return false;
        }
        return true;
      };
      EXPECT_TRUE(QTest::qWaitFor(isInSight, 2000))
          << size.width() << ": the bar has " << bar.width() << " of " << tabs.width();
    }
    for (int i = 0; i < bar.count(); ++i)
      EXPECT_GE(bar.tabToolTip(i).size(), bar.tabText(i).size()) << i;
    // A window manager may make the window smaller than its parts need.
    for (const int width : {565, 420}) {
      tabs.setFixedWidth(width);
      EXPECT_TRUE(QTest::qWaitFor(
          [&] {
            for (int i = 0; i < bar.count(); ++i)
              if (bar.isTabVisible(i) && !isWhole(i)) return false;
            return true;
          },
          2000))
          << width;
    }
    tabs.setMinimumWidth(0);
    tabs.setMaximumWidth(QWIDGETSIZE_MAX);
  }
}

/// A motion has a track on which its moment is chosen, and the view keeps its width for it.
TEST_P(WindowInEachLanguage, ASmallWindowHasATrackForTheMoment) {
  WindowIn window(GetParam());
  window->resize(1024, 700);
  const auto& tabs = *window->findChild<QTabWidget*>("tabs");
  Scene moving = smallScene();
  moving.sliding.kind = SlidingKind::Oscillation;
  moving.sliding.amplitude = 0.5;
  window->document().open(moving);
  const auto& moment = *window->findChild<QSlider*>("moment");
  ASSERT_TRUE(QTest::qWaitFor([&] { return moment.isVisible(); }, 2000));
  QTest::qWait(100);
  EXPECT_GE(moment.width(), 80);
  EXPECT_LE(tabs.width(), 660) << "the panel keeps its part of the window";
}

/// Numbers below zero have the decimal sign of the language, as they come and as they are typed.
TEST(GermanWindow, NumbersBelowZeroHaveAComma) {
  WindowIn window("de");
  Scene scene = smallScene();
  scene.surface.summitCorrelation = -0.9;
  window->document().open(scene);
  window->panel().setView({true, {}});
  auto& entry = *window->findChild<ValueEntry*>("entry:surface.summit_correlation");
  EXPECT_EQ(entry.text(), "-0,9");
  for (const auto& [typed, shown] : {std::pair{"-0.25", "-0,25"}, {"-0,4", "-0,4"}}) {
    entry.setFocus();
    entry.selectAll();
    QTest::keyClicks(&entry, typed);
    QTest::keyClick(&entry, Qt::Key_Return);
    EXPECT_EQ(entry.text(), shown);
  }
  EXPECT_EQ(window->document().scene().surface.summitCorrelation, -0.4);
}

/// At the size of a lecturer's projector, where the texts are larger.
TEST_P(WindowInEachLanguage, NothingOfTheAccuracyPanelIsCutOffInAPresentation) {
  WindowIn window(GetParam());
  ASSERT_TRUE(window.waitForCurve());
  window->findChild<QAction*>("go:accuracyPanel")->trigger();
  window->windowLayout().setPresenting(true);
  window->resize(1280, 720);
  auto& panel = *window->findChild<AccuracyPanel*>("accuracyPanel");
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return !panel.findChild<QLabel*>("accuracyMeasured")->text().isEmpty(); },
      kWindowPatience));
  EXPECT_EQ(cutOffIn(panel), "");
}

TEST_P(WindowInEachLanguage, NothingOfTheFiguresPageIsCutOff) {
  WindowIn window(GetParam());
  window->pages().openFigures();
  EXPECT_EQ(cutOffIn(*window), "");
}

/// With the parameters called back, and on the page of figures.
TEST_P(WindowInEachLanguage, NothingIsCutOffInAPresentation) {
  WindowIn window(GetParam());
  ASSERT_TRUE(window.waitForCurve());
  window->windowLayout().setPresenting(true);
  window->showNormal();  // the screen here may be smaller
  window->resize(1280, 720);
  auto& dock = *window->findChild<QDockWidget*>("parameterDock");
  dock.show();
  EXPECT_EQ(cutOffIn(dock), "");
  EXPECT_TRUE(QTest::qWaitFor([&] { return dock.geometry().right() <= 1280; }, kWindowPatience))
      << dock.geometry().right();
  EXPECT_LE(dock.width(), 1280 / 2);
  auto& rows = *dock.findChild<QWidget*>("parameterRows");
  EXPECT_LE(rows.width(), rows.parentWidget()->width());
  for (const ValueSlider* slider : dock.findChildren<ValueSlider*>())
    EXPECT_TRUE(!slider->isVisible() || slider->width() >= 40)
        << slider->objectName().toStdString();

  ASSERT_EQ(window->width(), 1280);

  window->pages().openFigures();
  EXPECT_EQ(cutOffIn(window->pages().figuresPage()), "");
  const auto& list = *window->pages().figuresPage().findChild<FigureList*>();
  EXPECT_GE(list.width(), list.minimumSizeHint().width());
  // The picture has all that panel and list leave, and the window does not grow for it.
  constexpr int kBorders = 8;
  EXPECT_EQ(window->width(), 1280);
  const int picture = window->pages().figuresPage().picture().width();
  EXPECT_GE(picture, 1280 - dock.width() - list.width() - kBorders);
  EXPECT_GT(picture, std::max(dock.width(), list.width()));
}

INSTANTIATE_TEST_SUITE_P(Window, WindowInEachLanguage, testing::Values("en", "de"),
                         [](const auto& each) { return std::string(each.param); });

/// With what the wheel and fingers do.
TEST_P(WindowInEachLanguage, NothingOfTheSheetOfKeysIsCutOff) {
  WindowIn window(GetParam());
  window->findChild<QAction*>("shortcuts")->trigger();
  auto& sheet = *window->findChild<QDialog*>("shortcutSheet");
  EXPECT_EQ(cutOffIn(sheet), "");
  // It may scroll down rather than have small letters, but not sideways.
  for (const QScrollBar* bar : sheet.findChildren<QScrollBar*>())
    if (bar->orientation() == Qt::Horizontal) EXPECT_EQ(bar->maximum(), bar->minimum());
  for (const QLabel* label : sheet.findChildren<QLabel*>())
    EXPECT_GE(label->font().pointSizeF(), 0.8 * window->font().pointSizeF());
  for (const ShortcutGroup& group : gestureGroups())
    for (const ShortcutGroup::Entry& entry : group.entries)
      EXPECT_TRUE(std::ranges::any_of(sheet.findChildren<QLabel*>(), [&](const QLabel* label) {
        return label->text() == entry.text;
      })) << entry.text.toStdString();
}

TEST(GermanWindow, ShippedScenesSpeakGermanAndOthersAsTheyWereWritten) {
  const auto& library = libraryScenes();
  const auto shipped = std::ranges::find(library, "tread_compound", &LibraryScene::name);
  ASSERT_NE(shipped, library.end());
  WindowIn window("de", shipped->scene);
  auto* title = window->findChild<ValueEntry*>("entry:title");
  auto* description = window->findChild<TextBox*>("text:description");
  EXPECT_EQ(title->text(), "Gefüllte Laufflächenmischung: dreizehn Arme");
  EXPECT_TRUE(description->toPlainText().startsWith("Ein Beispiel ohne veröffentlichte Quelle"));
  EXPECT_TRUE(description->toPlainText().contains(QStringLiteral("10⁵ m/s")));
  // To look at it or to leave it changes nothing.
  description->setFocus();
  title->setFocus();
  QTest::keyClick(title, Qt::Key_Return);
  EXPECT_EQ(window->session().scene(), shipped->scene);
  EXPECT_FALSE(window->isWindowModified());

  Scene own = smallScene();
  own.title = "linear";
  own.description = "velocity sweep";
  window->document().open(own);
  EXPECT_EQ(title->text(), "linear");
  EXPECT_EQ(description->toPlainText(), "velocity sweep");
  EXPECT_EQ(window->windowTitle(), QStringLiteral("linear[*] – Asperity"));
}

TEST(GermanWindow, AComplaintAboutTheSceneIsGerman) {
  WindowIn window("de");
  Scene empty = smallScene();
  empty.elastomer = prony(0, {});
  window->document().edit(empty);
  ASSERT_TRUE(QTest::qWaitFor([&] { return window->messages().isVisible(); }, kWindowPatience));
  EXPECT_EQ(window->messages().text(),
            "Gleichgewichtsmodul: ist 0, und es gibt weder Arme noch einen Dämpfer; das Elastomer "
            "hätte keine Kraft");
  Scene soft = smallScene();
  soft.elastomer = prony(1e6, {{1e6, 1e-3}, {1e-300, 1}});
  window->document().edit(soft);
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return window->messages().text().startsWith("Arme, Zeile 2: "); }, kWindowPatience))
      << window->messages().text().toStdString();
  EXPECT_FALSE(openIn(*window, "/no/such/scene.json"));
  EXPECT_EQ(window->messages().text(),
            "/no/such/scene.json: lässt sich nicht öffnen: die Datei gibt es nicht");
}

TEST(GermanWindow, NumbersHaveACommaAndMayBeTypedWithEither) {
  WindowIn window("de");
  auto* entry = window->findChild<ValueEntry*>("entry:surface.hurst");
  EXPECT_EQ(entry->text(), "0,7");
  for (const char* text : {"0,25", "0.25"}) {
    entry->setFocus();
    entry->selectAll();
    QTest::keyClicks(entry, text);
    QTest::keyClick(entry, Qt::Key_Return);
    EXPECT_EQ(window->session().scene().surface.hurst, 0.25) << text;
    EXPECT_EQ(entry->text(), "0,25");
    EXPECT_FALSE(entry->hasError());
  }
}

TEST(GermanWindow, ARefusalIsGerman) {
  WindowIn window("de");
  auto* entry = window->findChild<ValueEntry*>("entry:surface.hurst");
  entry->setFocus();
  entry->selectAll();
  QTest::keyClicks(entry, "1,4");
  QTest::keyClick(entry, Qt::Key_Return);
  EXPECT_EQ(window->findChild<QLabel*>("error:surface.hurst")->text(),
            "1,4 liegt außerhalb von 0 bis 1");
  entry = window->findChild<ValueEntry*>("entry:load.normal_force");
  entry->setFocus();
  entry->selectAll();
  QTest::keyClicks(entry, "0.5 kg");
  QTest::keyClick(entry, Qt::Key_Return);
  EXPECT_EQ(window->findChild<QLabel*>("error:load.normal_force")->text().replace(QChar::Nbsp, ' '),
            "0,5 kg ist eine Masse; erwartet wird eine Kraft, zum Beispiel 3,4 mN");
}

/// What a window with one of the pages shows, once the page has read its file.
template <class Page>
Texts textsWith(std::string_view code, Page& (*open)(MainWindow&, const QString&),
                const QString& file, std::string& cutOff) {
  WindowIn window(code);
  Page& page = open(*window, file);
  page.resize(984, 660);  // as on a small screen
  EXPECT_TRUE(QTest::qWaitFor([&] { return !page.isReading(); }, kWindowPatience));
  EXPECT_TRUE(page.isReady()) << page.errorText().toStdString();
  cutOff = cutOffIn(page);
  return textsOf(*window);
}

TEST(GermanWindow, PagesOfMeasuredFilesAreGermanAndWhole) {
  const QTemporaryDir folder;
  const QString profile = folder.filePath("p.csv"), moduli = folder.filePath("m.csv");
  QFile file(profile);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("x [mm];z [nm]\n");
  for (int i = 0; i < 200; ++i)
    file.write(QStringLiteral("%1;%2\n").arg(i).arg(100 * std::sin(0.1 * i)).toUtf8());
  file.close();
  ASSERT_TRUE(QFile::copy(ASPERITY_RESOURCES_DIR "/materials/measurements/epdm_70.csv", moduli));
  constexpr auto kSurface = +[](MainWindow& window, const QString& name) -> SurfaceImport& {
    return window.imports().openSurface(name);
  };
  constexpr auto kModuli = +[](MainWindow& window, const QString& name) -> MaterialImport& {
    return window.imports().openModuli(name);
  };
  std::string cut;
  const Texts surface = textsWith("de", kSurface, profile, cut);
  EXPECT_EQ(cut, "");
  EXPECT_THAT(leftOver(surface, textsWith("en", kSurface, profile, cut)), testing::IsEmpty());
  EXPECT_EQ(cut, "");
  const Texts material = textsWith("de", kModuli, moduli, cut);
  EXPECT_EQ(cut, "");
  EXPECT_THAT(leftOver(material, textsWith("en", kModuli, moduli, cut)), testing::IsEmpty());
  EXPECT_EQ(cut, "");
}

}  // namespace
}  // namespace asperity
