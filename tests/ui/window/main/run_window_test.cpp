// The program ends soon after its window is closed, whatever works in the background.
#include "ui/window/main/run_window.h"

#include <gtest/gtest.h>

#include <QTimer>
#include <thread>

#include "tests/core/small_scene.h"
#include "tests/ui/window/qt_application.h"
#include "ui/window/main/main_window.h"

namespace asperity {
namespace {

using namespace std::chrono_literals;

// Each of these programs would run for an hour without the limit, far beyond the patience of any
// test run; nothing is timed.
constexpr auto kForever = 1h;

class QuitLimitTest : public testing::Test {
 protected:
  QuitLimitTest() { GTEST_FLAG_SET(death_test_style, "threadsafe"); }
};

TEST_F(QuitLimitTest, EndsTheProcessWhenItsTimeIsOver) {
  EXPECT_EXIT(
      {
        const QuitLimit limit(20ms, 7);
        std::this_thread::sleep_for(kForever);
      },
      testing::ExitedWithCode(7), "");
}

TEST_F(QuitLimitTest, LetsGoOfWhatEndsByItself) {
  const QuitLimit limit(kForever, 7);  // destroyed at once, with its thread
}

/// Something of the window that never ends.
struct Endless : QObject {
  using QObject::QObject;
  ~Endless() override { std::this_thread::sleep_for(kForever); }
};

TEST_F(QuitLimitTest, AClosedWindowEndsTheProgramWhateverRuns) {
  EXPECT_EXIT(
      {
        auto window = std::make_unique<MainWindow>(sceneOfSize(256, 9, 3));
        window->show();
        new Endless(window.get());
        QTimer::singleShot(0, window.get(), &QWidget::close);
        runUntilClosed(*qApp, std::move(window));
        std::_Exit(9);  // never gets here
      },
      testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace asperity
