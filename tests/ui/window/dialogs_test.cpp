// What is shown by the pages and dialogs that import, fit, export and show figures can be read and
// reached in both languages on a screen of 1024 x 700 pixels.
#include <gtest/gtest.h>

#include <QScreen>

#include "tests/ui/window/dialog_states.h"
#include "tests/ui/window/qt_application.h"
#include "tests/ui/window/readable_widgets.h"
#include "tests/ui/window/window_in.h"
#include "ui/window/main/main_window.h"
#include "ui/window/main/session.h"

namespace asperity {
namespace {

constexpr QSize kScreen(1024, 700);

class Dialogs : public testing::TestWithParam<const char*> {};

TEST_P(Dialogs, AreReadableAndReachable) {
  WindowIn window(GetParam());
  // Dialogs take their size from the screen: a large one, so that the wish below decides.
  window->move(QGuiApplication::screens().back()->geometry().topLeft());
  window->resize(kScreen);
  // No dialog shows the moving picture, which would take a third of the time.
  window->session().setPlaying(false);
  DialogWishes wishes;
  wishes.program = ASPERITY_PROGRAM;
  wishes.screen = kScreen;
  wishes.hasFigures = false;
  int states = 0;
  visitDialogs(*window, wishes, [&](const QString& name, QWidget& shown) {
    ++states;
    const auto expectNone = [&](const QStringList& faults) {
      EXPECT_TRUE(faults.isEmpty()) << name.toStdString() << ":\n"
                                    << faults.join('\n').toStdString();
    };
    // The other parts of the main window have a test of their own.
    if (&shown == &*window) return;
    expectNone(readingFaults(shown));
    if (!shown.isWindow()) return;
    expectNone(sizeFaults(shown, kScreen));
    expectNone(tabFaults(shown));
  });
  EXPECT_GT(states, 40);
}

INSTANTIATE_TEST_SUITE_P(Languages, Dialogs, testing::Values("en", "de"));

}  // namespace
}  // namespace asperity
