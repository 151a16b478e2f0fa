// Opens the window on a real display, covers it with another one and takes that away: time stands
// still while it is covered and goes on afterwards. Usage: covered_window; needs a window manager
// that does not compose the screen. Exit: 0, or 1 with the reason.
#include <QApplication>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <cstdint>
#include <cstdio>

#include "tests/core/small_scene.h"
#include "ui/window/main/main_window.h"
#include "ui/window/main/run_window.h"
#include "ui/window/main/session.h"

namespace {

using namespace asperity;

constexpr int kPatience = 60000;  // ms, far more than anything here takes

std::uint64_t stepOf(MainWindow& window) {
  const auto frame = window.session().frame();
  return frame ? frame->step : 0;
}

bool waitForSight(MainWindow& window, bool seen) {
  return QTest::qWaitFor([&] { return window.session().isVisible() == seen; }, kPatience);
}

bool waitForSteps(MainWindow& window) {
  const std::uint64_t step = stepOf(window);
  return QTest::qWaitFor([&] { return stepOf(window) > step + 3; }, kPatience);
}

/// The answer to an order, before and after which nothing else is done.
std::uint64_t answeredStep(MainWindow& window, bool slopes) {
  FrameFields fields;
  fields.lineSlope = slopes;
  window.session().requestFields(fields);
  (void)QTest::qWaitFor([&] { return window.session().frame()->lineSlope.empty() != slopes; },
                        kPatience);
  return stepOf(window);
}

const char* complaint(MainWindow& window) {
  if (!QTest::qWaitForWindowExposed(&window)) return "never exposed";
  if (!waitForSteps(window)) return "the contact is not animated";
  {
    QWidget cover;
    cover.showFullScreen();
    if (!waitForSight(window, false)) return "covered, it believes to be seen";
    const std::uint64_t step = answeredStep(window, true);
    for (const bool slopes : {false, true, false})
      if (answeredStep(window, slopes) != step) return "covered, it goes on";
  }
  if (!waitForSight(window, true)) return "uncovered, it believes to be hidden";
  if (!waitForSteps(window)) return "uncovered, it stands still";
  window.showMinimized();
  if (!waitForSight(window, false)) return "minimized, it believes to be seen";
  window.showNormal();
  if (!waitForSight(window, true) || !waitForSteps(window)) return "restored, it stands still";
  return nullptr;
}

}  // namespace

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  const QTemporaryDir settings;  // never the user's own
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
  prepareApplication(application);
  MainWindow window(sceneOfSize(256, 9, 3));
  window.show();
  const char* reason = complaint(window);
  if (reason) std::fprintf(stderr, "covered_window: %s\n", reason);
  return reason ? 1 : 0;
}
