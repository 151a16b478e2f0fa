// Docks, tabs, full screen, presentation and colours, and that they are remembered.
#include "ui/window/main/window_layout.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QDockWidget>
#include <QLayout>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScreen>
#include <QSettings>
#include <QSpinBox>
#include <QSplitter>
#include <QStatusBar>
#include <QStyle>
#include <QStyleOption>
#include <QTabBar>
#include <QTabWidget>
#include <QTableWidget>
#include <QTest>
#include <QToolBar>
#include <QToolButton>
#include <QToolTip>
#include <QVBoxLayout>
#include <algorithm>
#include <cstdlib>
#include <map>
#include <memory>
#include <tuple>

#include "core/chart/explanations.h"
#include "tests/ui/window/main_window_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "ui/window/figures/diagram_view.h"
#include "ui/window/figures/figures_page.h"
#include "ui/window/main/appearance.h"
#include "ui/window/main/scene_tabs.h"
#include "ui/window/main/session.h"
#include "ui/window/main/window_style.h"

namespace asperity {
namespace {

class WindowLayoutTest : public MainWindowTest {
 protected:
  WindowLayoutTest() { QSettings().clear(); }

  QDockWidget& dock() { return control<QDockWidget>("parameterDock"); }
  QTabWidget& tabs() { return control<QTabWidget>("tabs"); }
};

TEST_F(WindowLayoutTest, ParametersCloseAndComeBackByTheirKey) {
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  EXPECT_TRUE(dock().isVisible());
  QTest::keyClick(&window_, Qt::Key_F9);
  EXPECT_FALSE(dock().isVisible());
  QTest::keyClick(&window_, Qt::Key_F9);
  EXPECT_TRUE(dock().isVisible());
}

TEST_F(WindowLayoutTest, TheSlashGoesToTheFilterOfTheParameters) {
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  dock().hide();
  QTest::keyClick(&window_, Qt::Key_Slash);
  EXPECT_TRUE(dock().isVisible());
  EXPECT_TRUE(control<QLineEdit>("parameterFilter").hasFocus());
  QTest::keyClicks(&control<QLineEdit>("parameterFilter"), "seed");
  QTest::keyClick(&control<QLineEdit>("parameterFilter"), Qt::Key_Escape);
  EXPECT_EQ(control<QLineEdit>("parameterFilter").text(), "");
  EXPECT_TRUE(window_.canvas().hasFocus()) << "whose keys play and step";
}

TEST_F(WindowLayoutTest, PlayAndPauseTakeTheSameWidth) {
  auto& bar = control<QToolBar>("commands");
  const QWidget& step = *bar.widgetForAction(&action("step"));
  const int before = step.x();
  for (const bool isPlaying : {false, true, false}) {
    session().setPlaying(isPlaying);
    bar.layout()->activate();
    EXPECT_EQ(step.x(), before) << isPlaying;
  }
}

TEST_F(WindowLayoutTest, AnOpenedSceneBeginsWithoutAFilter) {
  auto& filter = control<QLineEdit>("parameterFilter");
  filter.setText("seed");
  Scene edited = window_.document().scene();
  edited.load.normalForce *= 2;
  window_.document().edit(edited);
  EXPECT_EQ(filter.text(), "seed");
  window_.document().open(smallScene());
  EXPECT_EQ(filter.text(), "");
}

/// Where every widget of the window is that can be seen, by its place in the tree.
std::map<const QWidget*, QPoint> placesIn(const QWidget& window) {
  std::map<const QWidget*, QPoint> places;
  for (const QWidget* widget : window.findChildren<QWidget*>())
    // The room for messages, which is empty, ends where the readings end.
    if (widget->isVisible() && widget->window() == &window &&
        widget->objectName() != "statusMessage")
      places[widget] = widget->mapTo(&window, QPoint());
  return places;
}

TEST_F(WindowLayoutTest, NothingMovesWhenWorkBeginsOrEnds) {
  const auto isAtRest = [&] {
    return !session().friction().isStale() && session().friction().progress() >= 1 &&
           session().averaging() != Session::Averaging::Running;
  };
  for (const int width : {1024, 1280, 1920}) {
    window_.resize(width, 700);
    ASSERT_TRUE(waitFor(isAtRest));
    QTest::qWait(300);  // readings of the status line
    const auto before = placesIn(window_);
    Scene scene = session().scene();
    scene.elastomer.shearModulus *= 1.1;
    scene.ensemble.realizations += 40;
    window_.document().edit(scene);
    bool hasSeenWork = false;
    const auto compare = [&](const char* when) {
      const auto now = placesIn(window_);
      for (const auto& [widget, place] : before) {
        const auto found = now.find(widget);
        EXPECT_TRUE(found == now.end() || found->second == place)
            << widget->metaObject()->className() << ' ' << widget->objectName().toStdString() << ' '
            << when << ' ' << width << " by " << found->second.x() - place.x() << ", "
            << found->second.y() - place.y() << "; "
            << control<QLabel>("factMu").text().toStdString();
      }
    };
    ASSERT_TRUE(waitFor([&] {
      if (isAtRest()) return hasSeenWork;
      hasSeenWork = true;
      compare("during work");
      return false;
    }));
    QTest::qWait(300);
    compare("after work");
  }
}

/// A comparison adds a plot below the curve, which takes its height from that of the curve alone.
TEST_F(WindowLayoutTest, TheBorderStaysWhenASecondPlotComesAndGoes) {
  auto& compares = control<QCheckBox>("comparisonWanted");
  for (const QSize size : {QSize(1024, 700), QSize(1280, 720), QSize(1920, 1080)}) {
    window_.resize(size);
    QTest::qWait(100);
    const int before = window_.canvas().height();
    for (const bool isOn : {true, false}) {
      compares.setChecked(isOn);
      ASSERT_TRUE(
          waitFor([&] { return window_.plotView().sheet().diagrams.size() == (isOn ? 2 : 1); }));
      QTest::qWait(100);
      EXPECT_EQ(window_.canvas().height(), before) << size.height() << ' ' << isOn;
      const QPointF inSecond = window_.plotView().mapToPosition(1, 0, 1);
      EXPECT_EQ(inSecond.isNull(), !isOn) << "it is shown";
    }
  }
}

TEST_F(WindowLayoutTest, TheBorderBelowTheContactMovesByKeysAndKeepsBothSidesInSight) {
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  const int before = window_.canvas().height();
  const auto press = [&](Qt::Key key) {
    QTest::keyClick(&window_, key, Qt::ControlModifier | Qt::AltModifier);
    QCoreApplication::processEvents();
  };
  press(Qt::Key_Up);
  EXPECT_LT(window_.canvas().height(), before);
  press(Qt::Key_Down);
  EXPECT_EQ(window_.canvas().height(), before);
  for (int i = 0; i < 40; ++i) press(Qt::Key_Down);
  EXPECT_GT(window_.canvas().height(), before);
  EXPECT_GE(window_.plotView().height(), 170) << "the chart can still be read";
}

TEST_F(WindowLayoutTest, DocksMayBeMoved) {
  EXPECT_TRUE(dock().features().testFlag(QDockWidget::DockWidgetMovable));
  EXPECT_TRUE(dock().features().testFlag(QDockWidget::DockWidgetFloatable));
  window_.addDockWidget(Qt::LeftDockWidgetArea, &dock());
  ASSERT_TRUE(waitFor([&] { return dock().x() < window_.centralWidget()->x(); }));
  action("restoreLayout").trigger();
  EXPECT_EQ(window_.dockWidgetArea(&dock()), Qt::RightDockWidgetArea);
}

TEST_F(WindowLayoutTest, TabsAreHiddenAndShown) {
  auto& plan = action("tab:planList");
  const int index = tabs().indexOf(&control<QWidget>("planList"));
  plan.setChecked(false);
  EXPECT_FALSE(tabs().isTabVisible(index));
  action("go:planList").trigger();  // wanted again
  EXPECT_TRUE(plan.isChecked());
  EXPECT_EQ(tabs().currentIndex(), index);
  for (QAction* each : window_.findChildren<QAction*>())
    if (each->objectName().startsWith("tab:")) each->setChecked(false);
  EXPECT_FALSE(tabs().isVisible());
  action("restoreLayout").trigger();
  EXPECT_TRUE(tabs().isVisible());
}

/// It has its key and its entry in the menu, and what its diagrams report is heard.
TEST_F(WindowLayoutTest, APageThatIsAddedLaterIsOneOfThem) {
  auto* page = new QWidget;
  page->setObjectName("laterPage");
  auto* view = new DiagramView(page);
  window_.tabs().addPage(*page, [] { return QStringLiteral("Later"); });
  const int index = tabs().indexOf(page);
  EXPECT_EQ(tabs().tabText(index), "Later");
  action("go:laterPage").trigger();
  EXPECT_EQ(tabs().currentIndex(), index);
  QSignalSpy failures(&window_.tabs(), &SceneTabs::failed);
  emit view->failed([] { return QStringLiteral("The disk is full"); });
  EXPECT_EQ(failures.size(), 1);
  EXPECT_TRUE(control<QMenu>("tabsMenu").actions().contains(&action("tab:laterPage")));
  action("tab:laterPage").setChecked(false);
  EXPECT_FALSE(tabs().isTabVisible(index));
}

TEST_F(WindowLayoutTest, TheMotionsTabComesOnlyWithAMotion) {
  EXPECT_FALSE(action("tab:transientStrips").isVisible());
  action("go:transientStrips").trigger();
  EXPECT_FALSE(tabs().isTabVisible(1));
  Scene moving = smallScene();
  moving.sliding.kind = SlidingKind::Step;
  window_.document().open(moving);
  EXPECT_TRUE(action("tab:transientStrips").isVisible());
  EXPECT_TRUE(tabs().isTabVisible(1));
}

TEST_F(WindowLayoutTest, FullScreenAndBack) {
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  QTest::keyClick(&window_, Qt::Key_F11);
  EXPECT_TRUE(window_.isFullScreen());
  EXPECT_TRUE(action("fullScreen").isChecked());
  QTest::keyClick(&window_, Qt::Key_Escape);
  EXPECT_FALSE(window_.isFullScreen());
  EXPECT_FALSE(action("leave").isEnabled());
}

/// Of a small screen, too, or there would be no space for the pictures.
TEST(PresentedScale, IsTheSamePartOfEveryScreenAndEnlarges) {
  for (const double height : {720.0, 900.0, 1080.0, 1440.0, 2160.0})
    EXPECT_DOUBLE_EQ(presentationScale({16 * height / 9, height}) / height, 1.5 / 900) << height;
  EXPECT_LT(presentationScale({1024, 700}), 1.2);
  EXPECT_DOUBLE_EQ(presentationScale({3000, 500}), 1.1);
}

/// A title is shortened as soon as one pixel is missing.
TEST_F(WindowLayoutTest, TitlesOfTabsAreWholeAtEveryWidth) {
  const QTabBar& bar = *tabs().tabBar();
  for (int width = 1024; width < 1180; width += 3) {
    window_.resize(width, 700);
    QTest::qWait(1);
    EXPECT_GE(bar.width(), bar.sizeHint().width()) << width;
  }
}

/// Qt chooses the size of the box from the text, and the style adds its own edges to it.
TEST_F(WindowLayoutTest, NoTipIsCutOff) {
  int lines = 0;
  for (const HoverExplanation& explanation : explanations()) {
    const auto html = QStringLiteral("<p>%1</p><p>%2</p>")
                          .arg(QString::fromUtf8(explanation.sentence).toHtmlEscaped(),
                               QString::fromUtf8(explanation.formula).toHtmlEscaped());
    QToolTip::showText(window_.mapToGlobal(QPoint(20, 20)), html, &window_);
    const auto boxes = QApplication::topLevelWidgets();
    const auto box = std::ranges::find_if(
        boxes, [](const QWidget* each) { return each->inherits("QTipLabel"); });
    ASSERT_NE(box, boxes.end());
    ASSERT_TRUE((*box)->isVisible());
    EXPECT_LE((*box)->heightForWidth((*box)->width()), (*box)->height())
        << explanation.id << ' ' << (*box)->width();
    lines = std::max(lines, (*box)->height() / (*box)->fontMetrics().lineSpacing());
  }
  EXPECT_GT(lines, 4) << "no tip had several lines";
}

/// The whole text is one click away, and in the tooltip.
TEST_F(WindowLayoutTest, ALongDescriptionLeavesTheContactItsHeight) {
  window_.resize(1024, 700);
  Scene scene = session().scene();
  scene.description = "One of the sentences of a long description.";
  for (int i = 0; i < 4; ++i) scene.description += " " + scene.description;
  window_.document().open(scene);
  auto& bar = control<MessageBar>("descriptionBar");
  ASSERT_TRUE(waitFor([&] { return bar.isVisible(); }));
  auto& text = *bar.findChild<QLabel*>("messageText");
  auto& more = *bar.findChild<QToolButton*>("moreOfMessage");
  const auto lines = [&] { return text.height() / text.fontMetrics().lineSpacing(); };
  EXPECT_TRUE(waitFor([&] { return lines() <= 2 && text.text().endsWith(u'…'); }));
  EXPECT_TRUE(text.text().endsWith(u'…'));
  EXPECT_TRUE(text.toolTip().contains("long description"));
  for (int width = 1024; width < 1100; width += 4) {
    window_.resize(width, 700);
    QTest::qWait(1);
    const QString shown = text.text().chopped(1), whole = bar.text() + ' ';
    ASSERT_TRUE(text.text().endsWith(u'…')) << width;
    EXPECT_TRUE(whole.startsWith(shown + ' ') || whole.startsWith(shown + ". "))
        << "cut within a word: " << shown.toStdString();
  }
  window_.resize(1024, 700);
  ASSERT_TRUE(more.isVisible());
  more.click();
  EXPECT_TRUE(waitFor([&] { return lines() > 4; }));
  EXPECT_TRUE(text.text().endsWith(u'.'));
  more.click();
  EXPECT_TRUE(waitFor([&] { return lines() <= 2; }));
  scene.description = "Short.";
  window_.document().open(scene);
  ASSERT_TRUE(waitFor([&] { return text.text() == "Short."; }));
  EXPECT_FALSE(more.isVisible());
}

/// The computations of the contact and of the curve complain about the same scene.
TEST(MessageBar, AComplaintThatIsRepeatedReplacesNoNewerMessage) {
  MessageBar bar;
  const Message force("needs a positive force");
  bar.showSceneError("load.normal_force", force);
  const QString complaint = bar.text();
  const auto cannotBeOpened = [] { return QStringLiteral("cannot be opened"); };
  bar.showFailure(MessageBar::Failure::Files, cannotBeOpened);
  bar.showSceneError("load.normal_force", force);
  EXPECT_EQ(bar.text(), "cannot be opened");
  bar.showSceneError("load.normal_force", Message("is too small"));
  EXPECT_NE(bar.text(), complaint);
  EXPECT_NE(bar.text(), "cannot be opened");
  bar.showFailure(MessageBar::Failure::Files, cannotBeOpened);
  bar.showSceneError("load.normal_force", force);
  EXPECT_EQ(bar.text(), complaint);
  EXPECT_FALSE(bar.isHidden());
}

/// The parameter has the complaint itself only where the bar does not show it.
TEST(MessageBar, AComplaintAboutAParameterIsSaidOnce) {
  MessageBar bar;
  QStringList marks;
  QObject::connect(&bar, &MessageBar::sceneErrorShown, &bar,
                   [&](const QString&, const QString& text) { marks += text; });
  const QString complaint = QStringLiteral("needs a positive force");
  bar.showSceneError("load.normal_force", Message(complaint.toStdString()));
  ASSERT_TRUE(bar.text().contains(complaint));
  ASSERT_FALSE(marks.empty());
  EXPECT_FALSE(marks.back().isEmpty()) << "the parameter is marked";
  EXPECT_FALSE(marks.join(' ').contains(complaint));
  bar.showFailure(MessageBar::Failure::Files, [] { return QStringLiteral("cannot be opened"); });
  EXPECT_EQ(marks.back(), complaint);
  bar.end(MessageBar::Failure::Files);
  EXPECT_TRUE(bar.text().contains(complaint));
  EXPECT_NE(marks.back(), complaint);
  bar.findChild<QToolButton*>("closeMessage")->click();
  EXPECT_EQ(marks.back(), complaint);
}

/// A presentation, which has no panel beside it, widens the description.
TEST(MessageBar, ATextTakesTheRoomThatAWiderBarHas) {
  QWidget page;
  auto* bar = new MessageBar;
  (new QVBoxLayout(&page))->addWidget(bar);
  bar->setLineLimit(1);
  bar->showNote([] {
    return QStringLiteral("This note has more words than a narrow bar has room for, and is whole.");
  });
  const auto* text = bar->findChild<QLabel*>("messageText");
  const auto* more = bar->findChild<QToolButton*>("moreOfMessage");
  page.resize(250, 100);
  page.show();
  for (int i = 0; i < 2; ++i) {
    page.resize(250, 100);
    EXPECT_TRUE(QTest::qWaitFor([&] { return more->isVisible() && text->text().endsWith(u'…'); }));
    page.resize(900, 100);
    EXPECT_TRUE(QTest::qWaitFor([&] { return !more->isVisible() && text->text().endsWith(u'.'); }));
  }
}

TEST_F(WindowLayoutTest, ThePageOfFiguresShowsOneAtOnceAndNothingOfTheScene) {
  auto& description = control<QWidget>("descriptionBar");
  drop(ASPERITY_RESOURCES_DIR "/scenes/region_1.json");
  ASSERT_TRUE(waitFor([&] { return description.isVisible(); }));
  action("figures").trigger();
  EXPECT_FALSE(description.isVisible());
  const FigureName first = window_.pages().figuresPage().chosen();
  EXPECT_TRUE(
      waitFor([&] { return window_.pages().figuresPage().queue().status(first).made != nullptr; }));
  action("figures").trigger();
  EXPECT_TRUE(description.isVisible());
}

TEST_F(WindowLayoutTest, APresentationShowsLittleInLargeLettersUntilEscape) {
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  const double before = QApplication::font().pointSizeF();
  QTest::keyClick(&window_, Qt::Key_F5);
  EXPECT_TRUE(window_.windowLayout().isPresenting());
  EXPECT_TRUE(window_.isFullScreen());
  EXPECT_NEAR(QApplication::font().pointSizeF(),
              presentationScale(window_.screen()->size()) * before, 0.01);
  EXPECT_NEAR(control<QWidget>("frictionPlot").font().pointSizeF(),
              presentationScale(window_.screen()->size()) * before, 0.01);
  for (const QWidget* hidden : std::initializer_list<QWidget*>{
           &dock(), window_.menuBar(), window_.statusBar(), &control<QToolBar>("commands")})
    EXPECT_FALSE(hidden->isVisible());
  EXPECT_TRUE(window_.messages().isVisible());
  EXPECT_TRUE(window_.messages().text().startsWith("F9 shows the parameters"));
  EXPECT_TRUE(window_.messages().property("note").toBool()) << "it is no error";
  QTest::keyClick(&window_, Qt::Key_F9);  // keys go on without a menu
  EXPECT_TRUE(dock().isVisible());
  EXPECT_FALSE(window_.messages().isVisible());
  QTest::keyClick(&window_, Qt::Key_Escape);
  EXPECT_FALSE(window_.windowLayout().isPresenting());
  EXPECT_FALSE(window_.isFullScreen());
  EXPECT_EQ(QApplication::font().pointSizeF(), before);
  EXPECT_TRUE(window_.menuBar()->isVisible());
  EXPECT_TRUE(dock().isVisible());
}

/// Handles are as large as the letters, and all of what is drawn is the handle.
TEST_F(WindowLayoutTest, HandlesOfSlidersGrowWithTheLetters) {
  WindowStyle style;
  const Parameter& row = knownParameter("sliding.velocity");
  ValueSlider slider{SliderScale(row)};
  slider.setStyle(&style);
  QFont font = slider.font();
  font.setPixelSize(30);
  slider.setFont(font);
  slider.resize(300, slider.sizeHint().height());
  slider.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&slider));
  slider.setValue(slider.minimum());
  const int radius = static_cast<int>(handleRadius(slider.fontMetrics()));
  EXPECT_GT(radius, 9);
  EXPECT_GE(slider.height(), 2 * radius);
  for (const int x : {3, radius + 1, 2 * radius - 1}) {
    QTest::mouseClick(&slider, Qt::LeftButton, {}, {x, slider.height() / 2});
    EXPECT_EQ(slider.value(), slider.minimum()) << x;
  }
  QTest::mouseClick(&slider, Qt::LeftButton, {}, {150, slider.height() / 2});
  EXPECT_GT(slider.value(), slider.minimum());
}

/// Buttons, entries, boxes and lists have one border, which is seen in both themes.
TEST(WindowStyle, GivesAllControlsTheSameBorder) {
  WindowStyle style;
  QPushButton push("A button");
  QToolButton tool;
  QLineEdit entry;
  QSpinBox number;
  QPlainTextEdit text;
  QListWidget list;
  QTableWidget table(2, 2);
  for (const Theme& theme : {lightTheme(), darkTheme()}) {
    const QPalette palette = themePalette(theme);
    for (QWidget* control : Widgets{&push, &tool, &entry, &number, &text, &list, &table}) {
      control->setStyle(&style);
      control->setPalette(palette);
      control->resize(120, 60);
      const QImage picture = control->grab().toImage();
      for (const QPoint edge : {QPoint(0, 30), QPoint(119, 30), QPoint(60, 0), QPoint(60, 59)})
        EXPECT_EQ(picture.pixelColor(edge).name(), palette.color(QPalette::Mid).name())
            << control->metaObject()->className() << ' ' << edge.x() << ' ' << edge.y();
    }
    EXPECT_GE(push.sizeHint().width(), push.fontMetrics().horizontalAdvance(push.text()) + 20);
  }
  for (QWidget* control : Widgets{&push, &tool, &entry, &number, &text, &list, &table})
    control->setStyle(nullptr);  // before the style ends
}

/// The sign of Fusion touches the last letter.
TEST(WindowStyle, SignsAMenuBesideTheTextOfItsButton) {
  WindowStyle style;
  QMenu menu;
  QToolButton button;
  button.setText("Change a parameter…");
  button.setPopupMode(QToolButton::InstantPopup);
  for (QWidget* each : Widgets{&button, &menu}) each->setStyle(&style);
  const int plain = button.sizeHint().width();
  button.setMenu(&menu);
  EXPECT_GE(button.sizeHint().width(), plain + 12);
  button.resize(button.sizeHint());
  const QImage signedButton = button.grab().toImage();
  // Of the columns at the right, inside of the border, those of the sign have its ink.
  const auto hasInk = [&](int from, int to) {
    for (int x = from; x < to; ++x)
      for (int y = 4; y < signedButton.height() - 4; ++y)
        if (signedButton.pixelColor(x, y).lightness() < 128) return true;
    return false;
  };
  const int right = signedButton.width();
  EXPECT_TRUE(hasInk(right - 18, right - 3));
  EXPECT_FALSE(hasInk(right - 22, right - 18)) << "the text ends before it";
  for (QWidget* each : Widgets{&button, &menu}) each->setStyle(nullptr);
}

/// On a small screen not all titles fit: they have the whole bar, and buttons that can be hit.
TEST_F(WindowLayoutTest, TitlesOfTabsHaveTheWholeBarInAPresentation) {
  window_.windowLayout().setPresenting(true);
  QCoreApplication::processEvents();
  const QTabBar& bar = *tabs().tabBar();
  EXPECT_FALSE(tabs().cornerWidget()) << "there is nothing to fit";
  QStyleOption option;
  option.initFrom(&bar);
  EXPECT_GE(bar.style()->pixelMetric(QStyle::PM_TabBarScrollButtonWidth, &option, &bar),
            bar.fontMetrics().height());
  window_.windowLayout().setPresenting(false);
}

TEST_F(WindowLayoutTest, WhatEndsAPresentationIsAsItWasBefore) {
  dock().hide();
  window_.windowLayout().setPresenting(true);
  EXPECT_FALSE(window_.messages().isVisible()) << "the panel was not in sight before";
  window_.windowLayout().setPresenting(false);
  EXPECT_FALSE(dock().isVisible());
}

/// Whatever was opened and needed room meanwhile.
TEST_F(WindowLayoutTest, APresentationGivesBackSizesToThePixel) {
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  ASSERT_TRUE(waitFor([&] { return session().friction().progress() >= 1; }));
  window_.resize(1000, 640);
  QCoreApplication::processEvents();
  auto& splitter = control<QSplitter>("viewSplitter");
  const auto sizes = [&] {
    QCoreApplication::processEvents();
    return std::tuple(window_.size(), dock().geometry(), window_.centralWidget()->geometry(),
                      splitter.sizes(), window_.statusBar()->isVisible());
  };
  const auto before = sizes();
  for (const char* opened : {"parameters", "figures", "go:accuracyPanel"}) {
    QTest::keyClick(&window_, Qt::Key_F5);
    action(opened).trigger();
    QCoreApplication::processEvents();
    QTest::keyClick(&window_, Qt::Key_F5);
    EXPECT_EQ(window_.pages().figuresPage().isVisible(), QString(opened) == "figures");
    if (window_.pages().figuresPage().isVisible()) {
      EXPECT_FALSE(dock().isVisible());
      EXPECT_FALSE(window_.statusBar()->isVisible());
      window_.pages().showViews();
    }
    EXPECT_TRUE(QTest::qWaitFor([&] { return sizes() == before; }, 2000)) << opened;
    EXPECT_EQ(sizes(), before) << opened;
  }
}

/// Also with a message and a description above the contact.
TEST_F(WindowLayoutTest, TheSmallestWindowShowsTheWholeChart) {
  Scene scene = session().scene();
  scene.description = "Friction grows with velocity.";
  window_.document().open(scene);
  window_.messages().showFailure(MessageBar::Failure::Files,
                                 [] { return QStringLiteral("cannot be opened"); });
  window_.resize(kMinWindowSize);
  ASSERT_TRUE(waitFor([&] { return control<MessageBar>("descriptionBar").isVisible(); }));
  ASSERT_TRUE(window_.messages().isVisible());
  QCoreApplication::processEvents();
  const QWidget& plot = window_.plotView();
  const int foot = plot.mapTo(&window_, QPoint(0, plot.height())).y();
  EXPECT_LE(foot, window_.statusBar()->y());
}

TEST_F(WindowLayoutTest, ContentsNeverPushTheWindowBeyondItsSize) {
  window_.resize(1000, 640);
  window_.centralWidget()->setMinimumWidth(2000);
  QCoreApplication::processEvents();
  EXPECT_EQ(window_.size(), QSize(1000, 640));
  EXPECT_LE(window_.minimumWidth(), 1000);
}

TEST_F(WindowLayoutTest, EscapeClosesTheFiguresAndThenEndsThePresentation) {
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  QTest::keyClick(&window_, Qt::Key_F5);
  QTest::keyClick(&window_, Qt::Key_G, Qt::ControlModifier);
  ASSERT_TRUE(window_.pages().figuresPage().isVisible());
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
  EXPECT_FALSE(window_.pages().figuresPage().isVisible());
  EXPECT_TRUE(window_.windowLayout().isPresenting());
  for (const QWidget* hidden : std::initializer_list<QWidget*>{&dock(), window_.statusBar()})
    EXPECT_FALSE(hidden->isVisible());
  QTest::keyClick(&window_, Qt::Key_Escape);
  EXPECT_FALSE(window_.windowLayout().isPresenting());
}

TEST_F(WindowLayoutTest, TheNextWindowIsAsTheLastWas) {
  const auto next = [] {
    auto window = std::make_unique<MainWindow>(smallScene());
    window->windowLayout().remember();
    window->show();
    return window;
  };
  auto first = next();
  first->findChild<QDockWidget*>("parameterDock")->hide();
  first->findChild<QAction*>("tab:planList")->setChecked(false);
  first->appearance().chooseTheme(ThemeChoice::Dark);
  const PanelView panel{true, {"load", "accuracy"}};
  first->panel().setView(panel);
  const QRect place(QGuiApplication::screens().back()->geometry().topLeft() + QPoint(100, 100),
                    QSize(1100, 700));
  first->setGeometry(place);
  first->windowLayout().setPresenting(true);  // is not kept
  ASSERT_TRUE(first->close());
  first.reset();

  auto second = next();
  EXPECT_FALSE(second->findChild<QDockWidget*>("parameterDock")->isVisible());
  EXPECT_FALSE(second->findChild<QAction*>("tab:planList")->isChecked());
  EXPECT_EQ(second->appearance().themeChoice(), ThemeChoice::Dark);
  EXPECT_EQ(second->panel().view(), panel);
  EXPECT_TRUE(second->appearance().isDark());
  EXPECT_FALSE(second->isFullScreen());
  EXPECT_TRUE(second->menuBar()->isVisible());
  EXPECT_EQ(second->geometry(), place);
  second->windowLayout().restoreDefault();
  EXPECT_EQ(second->panel().view(), ParameterPanel::defaultView());
  EXPECT_TRUE(second->findChild<QDockWidget*>("parameterDock")->isVisible());
  second->appearance().chooseTheme(ThemeChoice::Light);
}

TEST_F(WindowLayoutTest, ChosenColoursAreKeptAlsoWhenTheProgramIsKilled) {
  const auto kept = [] { return QSettings().value("window/colours").toString(); };
  action("light").trigger();
  EXPECT_EQ(kept(), "") << "of a window that remembers nothing";
  window_.windowLayout().remember();
  action("colours:2").trigger();
  EXPECT_EQ(kept(), "dark");
  action("light").trigger();
  EXPECT_EQ(kept(), "light");
}

TEST_F(WindowLayoutTest, ColoursOfEarlierSettingsAreRead) {
  const std::pair<QVariant, ThemeChoice> saved[] = {
      {0, ThemeChoice::System},     {1, ThemeChoice::Light},       {2, ThemeChoice::Dark},
      {"dark", ThemeChoice::Dark},  {"light", ThemeChoice::Light}, {"7", ThemeChoice::System},
      {"pink", ThemeChoice::System}};
  for (const auto& [value, colours] : saved) {
    QSettings().setValue("window/colours", value);
    window_.windowLayout().remember();
    EXPECT_EQ(window_.appearance().themeChoice(), colours) << value.toString().toStdString();
  }
}

/// The window with what a window manager draws around it.
void expectOnScreen(const QWidget& window, const QScreen& screen) {
  const QRect with = window.geometry().marginsAdded(QMargins(4, 30, 4, 4));
  EXPECT_TRUE(screen.availableGeometry().contains(with))
      << screen.name().toStdString() << ": " << with.x() << ' ' << with.y() << ' ' << with.width()
      << ' ' << with.height();
}

TEST_F(WindowLayoutTest, TheFirstWindowFitsItsScreen) {
  const QList<QScreen*> screens = QGuiApplication::screens();
  ASSERT_EQ(screens.size(), 4) << "as qt_application.h says";
  for (QScreen* screen : screens) {
    QSettings().clear();
    MainWindow window(smallScene());
    window.setScreen(screen);
    window.windowLayout().remember();
    const QSize room = screen->availableGeometry().size();
    EXPECT_LE(window.width(), room.width() - 8);
    EXPECT_LE(window.height(), room.height() - 34);
    EXPECT_GE(window.width(), std::min(1280, room.width()) - 40);
    EXPECT_GE(window.height(), std::min(800, room.height()) - 80);
    if (screen->size().width() > 2000) {
      EXPECT_EQ(window.size(), QSize(1280, 800)) << "no larger than it needs";
    }
  }
}

/// Closed on a large screen and opened where that one is away; also as it comes out
/// of a maximized one.
TEST_F(WindowLayoutTest, AWindowOfALargerScreenFitsASmallerOne) {
  for (const bool maximized : {false, true}) {
    QSettings().clear();
    {
      MainWindow first(smallScene());
      first.windowLayout().remember();
      first.setGeometry(9000, 2000, 2500, 1400);  // of a screen that is away then
      first.show();
      if (maximized) first.showMaximized();
      ASSERT_TRUE(first.close());
    }
    MainWindow second(smallScene());
    second.windowLayout().remember();
    second.setWindowState(Qt::WindowNoState);
    const QScreen* there = QGuiApplication::screenAt(second.geometry().center());
    ASSERT_TRUE(there);
    expectOnScreen(second, *there);
  }
  for (QScreen* screen : QGuiApplication::screens()) {
    MainWindow window(smallScene());
    QRect much(0, 0, 2700, 1600);
    much.moveCenter(screen->geometry().center());
    window.setGeometry(much);
    window.windowLayout().fitToScreen();
    expectOnScreen(window, *screen);
  }
}

/// Whatever a window manager makes of it: narrower than it likes to be.
TEST_F(WindowLayoutTest, CommandsThatHaveNoRoomAreBehindAnArrow) {
  auto& bar = control<QToolBar>("commands");
  auto& more = *bar.findChild<QToolButton*>("qt_toolbar_ext_button");
  window_.resize(1280, 720);
  ASSERT_TRUE(waitFor([&] { return !more.isVisible(); }));
  window_.setMinimumSize(300, 300);
  for (const bool dark : {false, true}) {
    window_.appearance().setDark(dark);
    for (const int width : {bar.sizeHint().width() - 1, 700, 500}) {
      window_.resize(width, 600);
      ASSERT_TRUE(waitFor([&] { return bar.width() <= width && more.isVisible(); })) << width;
      EXPECT_FALSE(more.accessibleName().isEmpty());
      EXPECT_TRUE(bar.rect().contains(more.geometry()));
      const QImage image = more.grab().toImage();
      const QColor ground = image.pixelColor(0, 0);
      int drawn = 0;
      for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
          drawn += std::abs(image.pixelColor(x, y).lightness() - ground.lightness()) > 80 ? 1 : 0;
      EXPECT_GT(drawn, 8) << width << (dark ? " dark" : " light");
    }
    window_.resize(1280, 720);
    ASSERT_TRUE(waitFor([&] { return !more.isVisible(); }));
  }
}

TEST_F(WindowLayoutTest, ColoursOfTheDesktopUnlessChosen) {
  EXPECT_EQ(window_.appearance().themeChoice(), ThemeChoice::System);
  EXPECT_EQ(window_.appearance().isDark(), systemIsDark());
  action("light").trigger();
  EXPECT_EQ(window_.appearance().isDark(), !systemIsDark());
  EXPECT_TRUE(action(systemIsDark() ? "colours:1" : "colours:2").isChecked());
  action("colours:0").trigger();
  EXPECT_EQ(window_.appearance().isDark(), systemIsDark());
}

/// Makes the colours of the desktop dark or light.
class DesktopColours : public WindowStyle {
 public:
  explicit DesktopColours(bool dark) : dark_(dark) {}
  void polish(QPalette& palette) override { palette = QPalette(dark_ ? Qt::black : Qt::lightGray); }
  using WindowStyle::polish;

 private:
  bool dark_;
};

TEST_F(WindowLayoutTest, ColoursFollowTheDesktopUnlessChosen) {
  ASSERT_FALSE(window_.appearance().isDark());
  QApplication::setStyle(new DesktopColours(true));
  EXPECT_TRUE(waitFor([&] { return window_.appearance().isDark(); }));
  window_.appearance().chooseTheme(ThemeChoice::Light);
  EXPECT_FALSE(window_.appearance().isDark());
  window_.appearance().chooseTheme(ThemeChoice::System);
  EXPECT_TRUE(window_.appearance().isDark());
  window_.appearance().chooseTheme(ThemeChoice::Dark);
  QApplication::setStyle(new WindowStyle);
  EXPECT_TRUE(waitFor([&] { return !systemIsDark(); }));
  EXPECT_TRUE(window_.appearance().isDark());
}

}  // namespace
}  // namespace asperity
