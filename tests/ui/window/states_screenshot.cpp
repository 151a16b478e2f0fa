// Saves a picture of the screen in every state of the window, and with every menu, tooltip and
// drag. Usage: states_screenshot FOLDER [--size WxH] [--dark] [--language CODE] [--only WORD] WORD:
// a part of the names of the wanted states. Needs a display with a window manager.
#include <QApplication>
#include <QCommandLineParser>
#include <QCursor>
#include <QDir>
#include <QMenu>
#include <QMenuBar>
#include <QPainter>
#include <QPixmap>
#include <QScreen>
#include <QSettings>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QToolTip>
#include <cstdio>

#include "core/run/frame.h"
#include "tests/ui/window/window_in.h"
#include "tests/ui/window/window_states.h"
#include "ui/contact/contact_handles.h"
#include "ui/window/contact/motion_view.h"
#include "ui/window/main/appearance.h"
#include "ui/window/main/run_window.h"
#include "ui/window/main/scene_tabs.h"
#include "ui/window/main/session.h"

namespace {

using namespace asperity;

constexpr int kSettled = 400;  // ms, until a picture is on the screen

class Camera {
 public:
  Camera(MainWindow& window, QString folder, QString only)
      : window_(window), folder_(std::move(folder)), only_(std::move(only)) {}

  bool wants(const std::string& name) const {
    return only_.isEmpty() || QString::fromStdString(name).contains(only_);
  }

  void shoot(const std::string& name) {
    if (!wants(name)) return;
    const QString file = folder_ + "/" + QString::fromStdString(name) + ".png";
    window_.screen()->grabWindow(0).save(file, nullptr, 80);
    std::printf("%s %dx%d\n", name.c_str(), window_.width(), window_.height());
    std::fflush(stdout);
  }

 private:
  MainWindow& window_;
  QString folder_, only_;
};

void shootStates(MainWindow& window, Camera& camera) {
  const StateScenes scenes(false);
  std::string scene;
  for (const WindowState& state : windowStates()) {
    if (!camera.wants(state.name)) continue;
    if (scene != state.scene || window.isWindowModified()) {
      window.document().open(scenes.scene(state.scene));
      window.findChild<QTabWidget*>("tabs")->setCurrentIndex(0);
      waitForScene(window);
    }
    scene = state.scene;
    state.enter(window);
    QTest::qWait(state.name.starts_with("motion") ? 6000 : kSettled);
    waitForScene(window);
    if (state.name.starts_with("tab_") || state.name == "gallery") QTest::qWait(6000);
    QTest::qWait(kSettled);
    camera.shoot(state.name);
    leaveState(window, state);
    if (state.name.starts_with("tour")) scene.clear();
  }
}

/// Shows a menu, saves its picture, and so its submenus.
void shootMenu(QMenu& menu, const QPoint& at, const std::string& name, Camera& camera) {
  emit menu.aboutToShow();
  menu.popup(at);
  QTest::qWait(kSettled);
  camera.shoot(name);
  int number = 0;
  for (QAction* action : menu.actions()) {
    if (!action->menu() || !action->isVisible()) continue;
    menu.setActiveAction(action);
    const QRect place = menu.actionGeometry(action);
    shootMenu(*action->menu(), menu.mapToGlobal(place.topRight()),
              name + "_" + std::to_string(++number), camera);
  }
  menu.hide();
}

void shootMenus(MainWindow& window, Camera& camera) {
  int number = 0;
  for (QAction* action : window.menuBar()->actions()) {
    const QRect place = window.menuBar()->actionGeometry(action);
    shootMenu(*action->menu(), window.menuBar()->mapToGlobal(place.bottomLeft()),
              "menu_" + std::to_string(++number), camera);
  }
}

/// The pointer over a widget, until its tooltip is there.
void point(QWidget& widget, const QPoint& at) {
  QTest::mouseMove(&widget, at - QPoint(7, 3));
  QTest::qWait(60);
  QTest::mouseMove(&widget, at);
  QCursor::setPos(widget.mapToGlobal(at));
  QTest::qWait(1200);
}

void shootContextMenu(QWidget& widget, const std::string& name, Camera& camera) {
  if (!camera.wants(name)) return;
  QTimer::singleShot(500, [&] {
    camera.shoot(name);
    if (QWidget* menu = QApplication::activePopupWidget()) menu->close();
  });
  const QPoint at = widget.rect().center();
  QContextMenuEvent event(QContextMenuEvent::Mouse, at, widget.mapToGlobal(at));
  QApplication::sendEvent(&widget, &event);
  QTest::qWait(700);
}

void shootHandles(MainWindow& window, Camera& camera) {
  ContactCanvas& canvas = window.canvas();
  const QRectF plot = canvas.plotArea();
  const auto at = [&](double x, double y) {
    return QPoint(static_cast<int>(plot.left() + x * plot.width()),
                  static_cast<int>(plot.top() + y * plot.height()));
  };
  const struct {
    const char* name;
    double x, y;
    QPoint drag;
  } kPlaces[] = {{"handle_body", 0.3, 0.04, {0, 40}},
                 {"handle_velocity", 0.5, 0.07, {60, 0}},
                 {"handle_force", 0.975, 0.16, {0, 40}},
                 {"contact_surface", 0.4, 0.6, {60, 0}}};
  for (const auto& place : kPlaces) {
    if (!camera.wants(place.name)) continue;
    point(canvas, at(place.x, place.y));
    camera.shoot(std::string(place.name) + "_tip");
    QTest::mousePress(&canvas, Qt::LeftButton, {}, at(place.x, place.y));
    for (int step = 1; step <= 5; ++step) {
      QTest::mouseMove(&canvas, at(place.x, place.y) + place.drag * step / 5);
      QTest::qWait(60);
    }
    QTest::qWait(kSettled);
    camera.shoot(std::string(place.name) + "_drag");
    QTest::keyClick(&canvas, Qt::Key_Escape);
    QTest::mouseRelease(&canvas, Qt::LeftButton, {}, at(place.x, place.y) + place.drag);
    QTest::qWait(kSettled);
    camera.shoot(std::string(place.name) + "_taken_back");
  }
}

void shootTips(MainWindow& window, Camera& camera) {
  if (!camera.wants("tip")) return;
  ChartView& chart = window.plotView();
  const auto in = [](const QWidget& widget, double x, double y) {
    return QPoint(static_cast<int>(x * widget.width()), static_cast<int>(y * widget.height()));
  };
  int number = 0;
  for (const auto& [x, y] :
       {std::pair{0.3, 0.2}, {0.5, 0.3}, {0.5, 0.6}, {0.85, 0.85}, {0.9, 0.5}}) {
    point(chart, in(chart, x, y));
    camera.shoot("tip_chart_" + std::to_string(++number));
  }
  number = 0;
  for (const auto& [x, y] :
       {std::pair{0.06, 0.1}, {0.2, 0.1}, {0.35, 0.1}, {0.6, 0.97}, {0.9, 0.1}, {0.01, 0.5}})
    point(window.canvas(), in(window.canvas(), x, y)),
        camera.shoot("tip_contact_" + std::to_string(++number));
  for (const char* row :
       {"row:load.normal_force", "row:sliding.velocity", "slowMotion", "paceSlider", "factMu"})
    if (auto* widget = window.findChild<QWidget*>(row); widget && widget->isVisible()) {
      point(*widget, {30, 8});
      camera.shoot(std::string("tip_") + QString(row).replace(':', '_').toStdString());
    }
}

}  // namespace

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  const QTemporaryDir settings;  // never the user's own
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
  QCommandLineParser parser;
  parser.addPositionalArgument("FOLDER", "where the pictures go");
  parser.addOptions({{"dark", "dark colours"},
                     {"size", "of the window, WxH", "WxH"},
                     {"language", "of all texts", "CODE"},
                     {"only", "part of the names of the wanted pictures", "WORD"}});
  parser.process(application);
  if (parser.positionalArguments().size() != 1) parser.showHelp(1);
  prepareApplication(application);
  useLanguage(parser.value("language").toStdString());
  const QString folder = parser.positionalArguments().constFirst();
  QDir().mkpath(folder);
  const QStringList sides = parser.value("size").split('x');
  const QSize size =
      sides.size() == 2 ? QSize(sides[0].toInt(), sides[1].toInt()) : QSize(1280, 720);
  const StateScenes scenes(false);
  MainWindow window(scenes.scene(kUsualScene));
  window.windowLayout().remember();
  window.appearance().setDark(parser.isSet("dark"));
  window.resize(size);
  window.show();
  if (!QTest::qWaitForWindowExposed(&window)) return std::fputs("never exposed\n", stderr), 1;
  waitForScene(window);
  Camera camera(window, folder, parser.value("only"));
  shootStates(window, camera);
  window.document().open(scenes.scene(kUsualScene));
  waitForScene(window);
  if (camera.wants("menu")) shootMenus(window, camera);
  shootContextMenu(window.canvas(), "context_contact", camera);
  shootContextMenu(window.plotView(), "context_chart", camera);
  shootTips(window, camera);
  shootHandles(window, camera);
}
