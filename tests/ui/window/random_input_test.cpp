// A person without a plan in front of the main window: keys, clicks, drags, wheels, numbers and
// commands at random, wherever the window, its menus and its dialogs take them. Nothing may crash
// or hang, and afterwards a scene must run as before.
//
// ASPERITY_RANDOM_SECONDS (4) and ASPERITY_RANDOM_SEED (1) in the environment say how long and
// which; ASPERITY_RANDOM_LOG names a file that gets a line for each action before it is done, so
// that the last line names what went wrong. The times of computed frames are not part of the seed.
#include <gtest/gtest.h>
#include <unistd.h>

#include <QComboBox>
#include <QDesktopServices>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QFile>
#include <QFileDialog>
#include <QHelpEvent>
#include <QLineEdit>
#include <QMenu>
#include <QPointer>
#include <QTabBar>
#include <QTemporaryDir>
#include <QWheelEvent>
#include <random>

#include "tests/ui/window/main_window_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "ui/window/export/export_dialog.h"
#include "ui/window/lesson/lessons.h"
#include "ui/window/main/scene_library.h"

namespace asperity {
namespace {

constexpr int kUsualSeconds = 4;
constexpr int kAtRest = 20;                   // actions after which the window may answer in peace
constexpr std::int64_t kMaxElements = 20000;  // of a scene with which it goes on
constexpr std::int64_t kMaxLines = 2000;

int wished(const char* name, int usual) {
  bool isNumber = false;
  const int value = qEnvironmentVariableIntValue(name, &isNumber);
  return isNumber ? value : usual;
}

/// Takes what the window would give to the desktop's browser.
class NoBrowser : public QObject {
  Q_OBJECT

 public:
  NoBrowser() {
    for (const char* scheme : kSchemes) QDesktopServices::setUrlHandler(scheme, this, "take");
  }
  ~NoBrowser() override {
    for (const char* scheme : kSchemes) QDesktopServices::unsetUrlHandler(scheme);
  }

 public slots:
  void take(const QUrl&) {}

 private:
  static constexpr const char* kSchemes[] = {"file", "http", "https"};
};

/// Does one action after the other, also while a menu or a dialog has an event loop of its own:
/// each action begins with the appointment for the next one.
class Person : public QObject {
 public:
  Person(MainWindow& window, unsigned seed, int seconds)
      : window_(window), random_(seed), seconds_(seconds) {
    if (const QString name = qEnvironmentVariable("ASPERITY_RANDOM_LOG"); !name.isEmpty()) {
      log_.setFileName(name);
      EXPECT_TRUE(log_.open(QIODevice::WriteOnly | QIODevice::Truncate));
    }
  }

  /// Returns the number of actions.
  int act() {
    time_.start();
    next();
    loop_.exec();
    return done_;
  }

 private:
  int upTo(int most) { return std::uniform_int_distribution<int>(0, most)(random_); }
  template <class List>
  auto& oneOf(List& list) {
    return list[upTo(static_cast<int>(std::size(list)) - 1)];
  }
  bool isLikely(int percent) { return upTo(99) < percent; }

  void next() {
    QTimer::singleShot(0, this, [this] {
      if (time_.elapsed() > 1000 * seconds_) return leave();
      next();
      one();
    });
  }

  /// Closes whatever has a loop of its own, and then the loop below all of them.
  void leave() {
    QWidget* top = QApplication::activePopupWidget();
    if (!top) top = QApplication::activeModalWidget();
    if (!top) return loop_.quit();
    closeHard(top);
    QTimer::singleShot(0, this, [this] { leave(); });
  }

  static void closeHard(QWidget* top) {
    if (auto* dialog = qobject_cast<QDialog*>(top))
      dialog->done(QDialog::Rejected);  // asks nothing
    else
      top->close();
  }

  void note(const QString& what) {
    if (!log_.isOpen()) return;
    log_.write(QStringLiteral("%1 %2\n").arg(done_).arg(what).toUtf8());
    log_.flush();
  }

  void one() {
    ++done_;
    if (!window_.isVisible()) window_.show();  // it was closed, or quit
    if (done_ % kAtRest == 0) keepSmall();
    QWidget* top = target();
    if (qobject_cast<QFileDialog*>(top)) {  // whose files are not ours to change
      note("file dialog");
      return closeHard(top);
    }
    if (qobject_cast<QMessageBox*>(top) && isLikely(20)) return closeHard(top);
    const int kind = upTo(99);
    if (kind < 30)
      click(*top);
    else if (kind < 42)
      drag(*top);
    else if (kind < 50)
      turn(*top);
    else if (kind < 75)
      press(*top);
    else if (kind < 82)
      hover(*top);
    else if (top != &window_)
      dismiss(*top);
    else if (kind < 88)
      typeNumber();
    else if (kind < 94)
      command();
    else if (kind < 97)
      choose();
    else if (kind < 98)
      resize();
    else
      changeScene();
  }

  /// What takes the input now: a menu, a dialog, else one of the windows.
  QWidget* target() {
    if (QWidget* popup = QApplication::activePopupWidget()) return popup;
    if (QWidget* modal = QApplication::activeModalWidget()) return modal;
    QWidgetList tops;
    for (QWidget* top : QApplication::topLevelWidgets())
      if (top->isVisible() && top != &window_ && top->windowType() != Qt::ToolTip) tops += top;
    return tops.isEmpty() || isLikely(70) ? &window_ : oneOf(tops);
  }

  /// Goes on with a scene that runs fast, wherever sliders have led.
  void keepSmall() {
    const Scene& scene = window_.document().scene();
    const bool isLarge = scene.surface.elements > kMaxElements ||
                         scene.ensemble.realizations > kMaxLines || scene.sweep.points > 200 ||
                         scene.accuracy.targetRelativeError > 0;
    if (!isLarge || QApplication::activeModalWidget()) return;
    note("small scene");
    window_.document().open(smallScene());
  }

  QPoint placeIn(const QWidget& widget) {
    return {upTo(std::max(widget.width() - 1, 0)), upTo(std::max(widget.height() - 1, 0))};
  }

  /// What lies under a place of a window, and the place in it.
  struct Spot {
    QPointer<QWidget> widget;
    QPoint place;
  };
  Spot spotIn(QWidget& top) {
    const QPoint place = placeIn(top);
    QWidget* child = qobject_cast<QMenu*>(&top) ? nullptr : top.childAt(place);
    if (!child) return {&top, place};
    return {child, child->mapFrom(&top, place)};
  }

  Qt::KeyboardModifiers modifiers() {
    static constexpr Qt::KeyboardModifier kAll[] = {Qt::ShiftModifier, Qt::ControlModifier,
                                                    Qt::AltModifier};
    if (isLikely(70)) return Qt::NoModifier;
    Qt::KeyboardModifiers held = oneOf(kAll);
    if (isLikely(30)) held |= oneOf(kAll);
    return held;
  }

  /// Writing files is tested elsewhere.
  static bool writes(const QWidget* widget) {
    return widget && widget->objectName() == "exportWrite";
  }

  void click(QWidget& top) {
    const Spot spot = spotIn(top);
    if (writes(spot.widget)) return;
    const Qt::MouseButton button = isLikely(85) ? Qt::LeftButton : Qt::RightButton;
    const Qt::KeyboardModifiers held = modifiers();
    note(QStringLiteral("click %1 %2 at %3 %4")
             .arg(spot.widget->metaObject()->className(), spot.widget->objectName())
             .arg(spot.place.x())
             .arg(spot.place.y()));
    const auto send = [&](QEvent::Type type, Qt::MouseButtons down) {
      if (!spot.widget) return;
      const QPoint global = spot.widget->mapToGlobal(spot.place);
      QMouseEvent event(type, spot.place, global, button, down, held);
      QApplication::sendEvent(spot.widget, &event);
    };
    send(QEvent::MouseButtonPress, button);
    send(QEvent::MouseButtonRelease, {});
    if (isLikely(10)) send(QEvent::MouseButtonDblClick, button);
    // A right button asks for the menu of its place, as the desktop would.
    if (button == Qt::RightButton && spot.widget) {
      QContextMenuEvent event(QContextMenuEvent::Mouse, spot.place,
                              spot.widget->mapToGlobal(spot.place), held);
      QApplication::sendEvent(spot.widget, &event);
    }
  }

  void drag(QWidget& top) {
    const Spot spot = spotIn(top);
    if (writes(spot.widget)) return;
    const Qt::KeyboardModifiers held = modifiers();
    note(QStringLiteral("drag %1 %2 from %3 %4")
             .arg(spot.widget->metaObject()->className(), spot.widget->objectName())
             .arg(spot.place.x())
             .arg(spot.place.y()));
    QPoint at = spot.place;
    const auto send = [&](QEvent::Type type, Qt::MouseButton button, Qt::MouseButtons down) {
      if (!spot.widget) return;
      QMouseEvent event(type, at, spot.widget->mapToGlobal(at), button, down, held);
      QApplication::sendEvent(spot.widget, &event);
    };
    send(QEvent::MouseButtonPress, Qt::LeftButton, Qt::LeftButton);
    const QPoint way(upTo(200) - 100, upTo(200) - 100);
    for (int i = 1; i <= 6; ++i) {
      at = spot.place + way * i / 6;
      send(QEvent::MouseMove, Qt::NoButton, Qt::LeftButton);
      if (i == 3 && isLikely(10)) QTest::keyClick(&window_, Qt::Key_Escape);
    }
    send(QEvent::MouseButtonRelease, Qt::LeftButton, {});
  }

  void turn(QWidget& top) {
    const Spot spot = spotIn(top);
    note(QStringLiteral("wheel %1 %2")
             .arg(spot.widget->metaObject()->className(), spot.widget->objectName()));
    QWheelEvent event(spot.place, spot.widget->mapToGlobal(spot.place), {},
                      {isLikely(10) ? 120 : 0, 120 * (upTo(6) - 3)}, {}, modifiers(),
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(spot.widget, &event);
  }

  void press(QWidget& top) {
    static constexpr Qt::Key kKeys[] = {
        Qt::Key_Tab,    Qt::Key_Backtab,  Qt::Key_Escape, Qt::Key_Return, Qt::Key_Space,
        Qt::Key_Left,   Qt::Key_Right,    Qt::Key_Up,     Qt::Key_Down,   Qt::Key_PageUp,
        Qt::Key_Home,   Qt::Key_PageDown, Qt::Key_End,    Qt::Key_Delete, Qt::Key_Backspace,
        Qt::Key_Period, Qt::Key_Comma,    Qt::Key_Plus,   Qt::Key_Minus,  Qt::Key_Question,
        Qt::Key_F1,     Qt::Key_F10,      Qt::Key_F11,    Qt::Key_Menu,   Qt::Key_F6};
    const int letter = upTo(35);
    const Qt::Key key = isLikely(60)  ? oneOf(kKeys)
                        : letter < 26 ? static_cast<Qt::Key>(Qt::Key_A + letter)
                                      : static_cast<Qt::Key>(Qt::Key_0 + letter - 26);
    QWidget* focus = QApplication::focusWidget();
    QWidget* goes = focus && (focus == &top || top.isAncestorOf(focus)) ? focus : &top;
    const bool isExport = qobject_cast<ExportDialog*>(goes->window()) != nullptr;
    if (isExport && (key == Qt::Key_Return || key == Qt::Key_Space || key == Qt::Key_E)) return;
    const Qt::KeyboardModifiers held = modifiers();
    note(QStringLiteral("key %1 to %2 %3")
             .arg(QKeySequence(key | held).toString(), goes->metaObject()->className(),
                  goes->objectName()));
    QTest::keyClick(goes, key, held);
  }

  void hover(QWidget& top) {
    const Spot spot = spotIn(top);
    note(QStringLiteral("hover %1 %2")
             .arg(spot.widget->metaObject()->className(), spot.widget->objectName()));
    const QPoint global = spot.widget->mapToGlobal(spot.place);
    QMouseEvent move(QEvent::MouseMove, spot.place, global, Qt::NoButton, {}, {});
    QApplication::sendEvent(spot.widget, &move);
    if (!spot.widget) return;
    QHelpEvent tip(QEvent::ToolTip, spot.place, global);
    QApplication::sendEvent(spot.widget, &tip);
  }

  /// Leaves a menu or a dialog, so that the window is not covered for most of the time.
  void dismiss(QWidget& top) {
    note(QStringLiteral("leave %1 %2").arg(top.metaObject()->className(), top.objectName()));
    if (isLikely(50))
      QTest::keyClick(&top, Qt::Key_Escape);
    else
      closeHard(&top);
  }

  void typeNumber() {
    static constexpr const char* kTexts[] = {"1",     "0.5",   "3 mm", "1e-3", "20 mN", "-1",
                                             "1e999", "x",     "",     "7 kg", "0",     "40 °C",
                                             "0,25",  "1e-30", "100",  "nan",  "1 MPa", "%1 %n"};
    QList<QLineEdit*> entries = window_.findChildren<QLineEdit*>();
    if (entries.isEmpty()) return;
    const QPointer<QLineEdit> entry = oneOf(entries);
    if (!entry->isVisible() || !entry->isEnabled()) return;
    const char* text = oneOf(kTexts);
    note(QStringLiteral("type %1 into %2").arg(text, entry->objectName()));
    entry->setFocus();
    entry->selectAll();
    for (const QChar letter : QString::fromUtf8(text)) {
      if (!entry) return;
      QKeyEvent event(QEvent::KeyPress, 0, {}, QString(letter));
      QApplication::sendEvent(entry, &event);
    }
    if (entry) QTest::keyClick(entry, isLikely(80) ? Qt::Key_Return : Qt::Key_Tab);
  }

  void command() {
    QList<QAction*> actions = window_.findChildren<QAction*>();
    QAction* action = oneOf(actions);
    if (!action->isEnabled() || !action->isVisible() || action->menu()) return;
    note(QStringLiteral("command %1 %2").arg(action->objectName(), action->text()));
    action->trigger();
  }

  void choose() {
    if (isLikely(50)) {
      QList<QComboBox*> boxes = window_.findChildren<QComboBox*>();
      const QPointer<QComboBox> box = oneOf(boxes);
      if (!box->isVisible() || !box->isEnabled() || box->count() == 0) return;
      const int index = upTo(box->count() - 1);
      note(QStringLiteral("choose %1 of %2").arg(index).arg(box->objectName()));
      box->setCurrentIndex(index);
      if (box) emit box->activated(index);
    } else {
      QList<QTabBar*> bars = window_.findChildren<QTabBar*>();
      QTabBar* bar = oneOf(bars);
      if (bar->count() == 0) return;
      const int index = upTo(bar->count() - 1);
      note(QStringLiteral("tab %1 of %2").arg(index).arg(bar->objectName()));
      if (bar->isTabVisible(index)) bar->setCurrentIndex(index);
    }
  }

  void resize() {
    const QSize size(900 + upTo(900), 560 + upTo(700));
    note(QStringLiteral("resize %1 x %2").arg(size.width()).arg(size.height()));
    window_.resize(size);
  }

  void changeScene() {
    const auto& scenes = libraryScenes();
    const LibraryScene& entry =
        scenes[static_cast<std::size_t>(upTo(static_cast<int>(scenes.size()) - 1))];
    note("scene " + entry.name);
    window_.openShipped(entry.name);
  }

  MainWindow& window_;
  std::mt19937 random_;
  int seconds_, done_ = 0;
  QElapsedTimer time_;
  QEventLoop loop_;
  QFile log_;
};

using RandomInputTest = MainWindowTest;

TEST_F(RandomInputTest, NothingCrashesAndASceneRunsAfterwards) {
  // Whatever is written goes into a folder of the test's own.
  const QTemporaryDir folder;
  qputenv("HOME", folder.path().toUtf8());
  ASSERT_TRUE(QDir::setCurrent(folder.path()));
  const NoBrowser browser;
  QApplication::setQuitOnLastWindowClosed(false);
  ASSERT_TRUE(waitForFrame());
  const auto seed = static_cast<unsigned>(wished("ASPERITY_RANDOM_SEED", 1));
  Person person(window_, seed, wished("ASPERITY_RANDOM_SECONDS", kUsualSeconds));
  const int done = person.act();
  std::printf("%d actions, seed %u\n", done, seed);
  EXPECT_GT(done, 50);

  window_.show();
  window_.pages().showViews();
  window_.lessons().end();
  window_.document().endTrial();
  window_.document().open(Scene{});
  window_.document().open(smallScene());
  session().setPlaying(true);
  ASSERT_TRUE(waitForFrame());
  EXPECT_EQ(frame()->scene->surface, smallScene().surface);
  EXPECT_TRUE(waitFor([&] { return session().curve() && session().curve()->isComplete; }));
  EXPECT_TRUE(QDir::setCurrent(QDir::tempPath()));
}

}  // namespace
}  // namespace asperity

/// The export dialog runs this program as `asperity`, which it stands for.
int main(int count, char** arguments) {
  if (count > 1 && arguments[1][0] != '-') {
    arguments[0] = const_cast<char*>(ASPERITY_PROGRAM);
    execv(ASPERITY_PROGRAM, arguments);
    return 127;
  }
  testing::InitGoogleTest(&count, arguments);
  return RUN_ALL_TESTS();
}

#include "random_input_test.moc"
