// The page of the paper's figures in the main window: its menu, and how it changes places with the
// views.
#include "ui/window/main/window_pages.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QClipboard>
#include <QDockWidget>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QSignalSpy>
#include <QSpinBox>

#include "core/scene/plan.h"
#include "core/scene/scene_file.h"
#include "tests/ui/window/figures/figures_page_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "ui/panels/number_text.h"
#include "ui/panels/parameter_panel.h"
#include "ui/window/figures/diagram_view.h"
#include "ui/window/figures/figure_list.h"
#include "ui/window/main/main_window.h"
#include "ui/window/main/message_bar.h"
#include "ui/window/main/session.h"

namespace asperity {
namespace {

/// The page in the window.
class WindowPagesTest : public testing::Test {
 protected:
  WindowPagesTest() : window_(std::make_unique<MainWindow>(smallScene())) {
    window_->show();
    window_->activateWindow();
  }

  QAction& action(const QString& name) { return *window_->findChild<QAction*>(name); }
  FiguresPage& page() { return window_->pages().figuresPage(); }

  std::unique_ptr<MainWindow> window_;
};

TEST_F(WindowPagesTest, TheMenuHasThemAllWithKeysOfTheirOwn) {
  for (const FigureEntry& entry : figureEntries()) {
    auto* action = window_->findChild<QAction*>("figure:" + fromUtf8(entry.word));
    ASSERT_TRUE(action) << entry.word;
    EXPECT_TRUE(action->text().contains(fromUtf8(entry.headline)));
  }
  ASSERT_TRUE(window_->findChild<QAction*>("figures"));
  std::set<QString> keys;
  for (const QAction* action : window_->findChildren<QAction*>()) {
    const QString key = action->shortcut().toString();
    EXPECT_TRUE(key.isEmpty() || keys.insert(key).second) << qPrintable(key);
  }
}

TEST_F(WindowPagesTest, ThePageTakesThePlaceOfTheViewsAndGivesItBack) {
  ASSERT_TRUE(QTest::qWaitForWindowActive(window_.get()));
  auto& dock = *window_->findChild<QDockWidget*>("parameterDock");
  QTest::keyClick(window_.get(), Qt::Key_G, Qt::ControlModifier);
  EXPECT_TRUE(page().isVisible());
  EXPECT_FALSE(dock.isVisible());
  EXPECT_FALSE(action("play").isEnabled());  // Space is for the page's buttons
  QTest::keyClick(&page(), Qt::Key_Escape);
  EXPECT_FALSE(page().isVisible());
  EXPECT_TRUE(dock.isVisible());
  EXPECT_TRUE(action("play").isEnabled());
  EXPECT_FALSE(action("figures").isChecked());

  dock.hide();
  action("figures").trigger();
  action("figures").trigger();
  EXPECT_FALSE(page().isVisible());
  EXPECT_FALSE(dock.isVisible());
}

TEST_F(WindowPagesTest, AFigureOpensAsASceneToPlayWith) {
  action("figure:1").trigger();
  EXPECT_TRUE(page().isVisible());
  EXPECT_EQ(page().chosen(), FigureName::Contact);
  ASSERT_TRUE(waitFor([&] { return page().queue().status(FigureName::Contact).made != nullptr; }));
  const std::uint64_t before = window_->session().sceneNumber();
  QTest::mouseClick(page().findChild<QPushButton*>("openAsScene"), Qt::LeftButton);
  EXPECT_EQ(window_->session().sceneNumber(), before + 1);
  EXPECT_EQ(window_->session().scene(),
            page().queue().status(FigureName::Contact).made->figure.scene);
  EXPECT_EQ(window_->panel().scene(), window_->session().scene());
  EXPECT_TRUE(window_->windowTitle().contains("Fig. 1"));
  EXPECT_FALSE(page().isVisible());
  ASSERT_TRUE(waitFor([&] {
    const auto frame = window_->session().frame();
    return frame && frame->sceneNumber == window_->session().sceneNumber();
  }));
}

/// Of what is in sight: never the contact behind the page.
TEST_F(WindowPagesTest, PicturesAreOfTheFigureThatIsShown) {
  window_->pages().openFigures();
  page().choose(FigureName::Forces, false);
  for (const char* name : {"savePicture", "copyPicture", "copyCommand", "copyCurveCommand"})
    EXPECT_FALSE(action(name).isEnabled()) << name;
  page().choose(FigureName::Contact, true);
  ASSERT_TRUE(waitFor([&] { return page().picture().isPainted(); }));
  QGuiApplication::clipboard()->clear();
  action("copyPicture").trigger();
  EXPECT_EQ(QGuiApplication::clipboard()->image().size(), page().picture().image().size());
  EXPECT_FALSE(action("copyCommand").isEnabled());
  QString proposed;
  QTimer::singleShot(0, [&] {
    auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
    proposed = dialog->findChild<QLineEdit*>("fileNameEdit")->text();
    dialog->reject();
  });
  action("savePicture").trigger();
  EXPECT_EQ(proposed, "figure_1.png");
  window_->pages().showViews();
  for (const char* name : {"savePicture", "copyPicture", "copyCommand", "copyCurveCommand"})
    EXPECT_TRUE(action(name).isEnabled()) << name;
}

TEST_F(WindowPagesTest, TheContactGoesOnWhileAFigureIsComputed) {
  page().findChild<QSpinBox*>("realizations")->setValue(1500);
  action("figure:6").trigger();
  const auto part = [&] { return page().queue().status(FigureName::Plateau).part; };
  ASSERT_TRUE(waitFor([&] { return part() > 0; }));
  window_->pages().showViews();  // behind its page the contact rests
  QSignalSpy frames(&window_->session(), &Session::frameArrived);
  EXPECT_TRUE(waitFor([&] { return frames.count() >= 5; }));
  EXPECT_EQ(page().queue().computing(), FigureName::Plateau);
}

TEST_F(WindowPagesTest, TheWindowClosesInTheMiddleOfAComputation) {
  page().findChild<QSpinBox*>("realizations")->setValue(1500);
  action("figure:6").trigger();
  ASSERT_TRUE(waitFor([&] { return page().queue().status(FigureName::Plateau).part > 0; }));
  EXPECT_TRUE(window_->close());
  EXPECT_FALSE(window_->isVisible());
  // The work is counted, not timed: thousands of lines would follow, and each thread may end the
  // one that it has begun.
  const auto slid = [] { return stageCounts()[static_cast<std::size_t>(Stage::SteadyPass)]; };
  const std::uint64_t before = slid();
  EXPECT_GT(before, 0U);
  window_.reset();
  EXPECT_LE(slid() - before, 100U);
}

}  // namespace
}  // namespace asperity
