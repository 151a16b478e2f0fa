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
#include <algorithm>
#include <cstdio>
#include <map>
#include <optional>

#include "core/run/frame.h"
#include "tests/ui/window/window_in.h"
#include "tests/ui/window/window_states.h"
#include "ui/contact/contact_signs.h"
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

/// Where a drag of this kind begins: the middle of its label; of the body, which is large, a place
/// in it; else a place of the line. None where the picture has no such label.
std::optional<QPoint> placeOf(const ContactCanvas& canvas, ContactHandle wanted) {
  const QRectF plot = canvas.plotArea();
  if (wanted == ContactHandle::Body || wanted == ContactHandle::None) {
    const QPointF part = wanted == ContactHandle::Body ? QPointF(0.3, 0.04) : QPointF(0.4, 0.6);
    return (plot.topLeft() + QPointF(part.x() * plot.width(), part.y() * plot.height())).toPoint();
  }
  return handleIn(canvas, wanted);
}

void shootHandles(MainWindow& window, Camera& camera) {
  ContactCanvas& canvas = window.canvas();
  const struct {
    const char* name;
    ContactHandle handle;
    QPoint drag;
  } kDrags[] = {{"handle_body", ContactHandle::Body, {0, 40}},
                {"handle_velocity", ContactHandle::Velocity, {60, 0}},
                {"handle_force", ContactHandle::Force, {0, 40}},
                {"contact_surface", ContactHandle::None, {60, 0}}};
  for (const auto& wanted : kDrags) {
    if (!camera.wants(wanted.name)) continue;
    std::optional<QPoint> at = placeOf(canvas, wanted.handle);
    if (!at) {
      std::printf("%s: the picture has no such label\n", wanted.name);
      continue;
    }
    point(canvas, *at);
    camera.shoot(std::string(wanted.name) + "_tip");
    // Labels move with the line: the drag begins where this one is by now.
    at = placeOf(canvas, wanted.handle).value_or(*at);
    QTest::mousePress(&canvas, Qt::LeftButton, {}, *at);
    for (int step = 1; step <= 5; ++step) {
      QTest::mouseMove(&canvas, *at + wanted.drag * step / 5);
      QTest::qWait(60);
    }
    QTest::qWait(kSettled);
    camera.shoot(std::string(wanted.name) + "_drag");
    QTest::keyClick(&canvas, Qt::Key_Escape);
    QTest::mouseRelease(&canvas, Qt::LeftButton, {}, *at + wanted.drag);
    QTest::qWait(kSettled);
    camera.shoot(std::string(wanted.name) + "_taken_back");
  }
}

/// A place of each reading that the chart has, as the pointer finds them on a grid.
std::vector<QPoint> placesOfReadings(ChartView& chart) {
  std::map<QString, QPoint> places;
  for (int y = 4; y < chart.height(); y += 12)
    for (int x = 4; x < chart.width(); x += 12) {
      QTest::mouseMove(&chart, {x, y});
      if (!chart.reading().isEmpty()) places.try_emplace(chart.reading(), x, y);
    }
  std::vector<QPoint> found;
  for (const auto& [text, place] : places) found.push_back(place);
  return found;
}

void shootTips(MainWindow& window, Camera& camera) {
  if (!camera.wants("tip")) return;
  const std::vector<QPoint> places = placesOfReadings(window.plotView());
  const std::size_t readings = std::min<std::size_t>(6, places.size());
  for (std::size_t i = 0; i < readings; ++i) {
    point(window.plotView(), places[i * places.size() / readings]);
    camera.shoot("tip_chart_" + std::to_string(i + 1));
  }
  int number = 0;
  const auto signs = [&] {
    return contactSigns(*window.canvas().frame(), shownOptions(window.canvas()));
  };
  for (const ContactSign& sign : signs()) {
    // Labels move with the line: the pointer goes where this one is by now.
    const std::vector<ContactSign> now = signs();
    const auto same = std::ranges::find_if(
        now, [&](const ContactSign& one) { return one.id == sign.id && one.box.y == sign.box.y; });
    point(window.canvas(), middleOf(same == now.end() ? sign.box : same->box));
    camera.shoot("tip_contact_" + std::to_string(++number));
  }
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
