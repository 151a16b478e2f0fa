// The commands of a window: their words in each language, their keys, and their tips.
#include "ui/window/main/commands.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QMainWindow>
#include <QMenu>
#include <QTest>

#include "tests/ui/window/qt_application.h"

namespace asperity {
namespace {

class CommandsTest : public testing::Test {
 protected:
  QMainWindow window_;
  Commands commands_{window_};
  int runs_ = 0;
};

TEST_F(CommandsTest, AKeyRunsACommandAnywhereInTheWindow) {
  commands_.add({"jump", [] { return QStringLiteral("Jump…"); }, [this] { ++runs_; }, {Qt::Key_J}});
  window_.setCentralWidget(new QWidget);
  window_.show();
  window_.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  QTest::keyClick(&window_, Qt::Key_J);
  EXPECT_EQ(runs_, 1);
  EXPECT_EQ(commands_.get("jump")->iconText(), "Jump") << "a button has no dots";
  EXPECT_EQ(commands_.get("jump")->toolTip(), "Jump… (J)");
}

/// A text that depends on more than the language is asked for again.
TEST_F(CommandsTest, ATextFollowsItsState) {
  bool isOn = false;
  commands_.add({"play", [&] { return QString(isOn ? "Pause" : "Play"); }, [] {}, {}});
  commands_.setTip("play", [&] { return QString(isOn ? "Stops the time" : "Goes on"); });
  isOn = true;
  EXPECT_EQ(commands_.get("play")->text(), "Play");
  commands_.refresh("play");
  EXPECT_EQ(commands_.get("play")->text(), "Pause");
  EXPECT_EQ(commands_.get("play")->toolTip(), "Stops the time");
}

TEST_F(CommandsTest, IconsHaveTheColourOfTheTheme) {
  commands_.add({"undo", [] { return QStringLiteral("Undo"); }, [] {}, {}, Symbol::Undo});
  const auto picture = [this] { return commands_.get("undo")->icon().pixmap(20).toImage(); };
  EXPECT_TRUE(picture().isNull()) << "there is no colour yet";
  commands_.setColour(Qt::black);
  const QImage black = picture();
  ASSERT_FALSE(black.isNull());
  commands_.setColour(Qt::white);
  EXPECT_NE(picture(), black);
}

TEST_F(CommandsTest, AMenuWithoutEntriesSaysWhy) {
  QMenu menu;
  explainEmpty(menu, "There is no curve");
  ASSERT_EQ(menu.actions().size(), 1);
  EXPECT_EQ(menu.actions().front()->text(), "There is no curve");
  EXPECT_FALSE(menu.actions().front()->isEnabled());
}

}  // namespace
}  // namespace asperity
