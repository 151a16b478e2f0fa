// Walks the friction diagram through what it can show and saves a picture of the window for each.
// Usage: chart_screenshot FOLDER [--dark] [--size WxH]; offscreen unless QT_QPA_PLATFORM says
// otherwise. For the eye; the tests check the same by themselves.
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QCommandLineParser>
#include <QDir>
#include <QFile>
#include <QMouseEvent>
#include <QSpinBox>
#include <QTabWidget>
#include <QTest>
#include <cstdio>

#include "ui/chart/chart_view.h"
#include "ui/window/curve/curve_commands.h"
#include "ui/window/main/appearance.h"
#include "ui/window/main/main_window.h"
#include "ui/window/main/run_window.h"
#include "ui/window/main/scene_document.h"
#include "ui/window/main/scene_library.h"
#include "ui/window/main/session.h"
#include "ui/window/main/window_layout.h"

namespace {

using namespace asperity;

class Walk {
 public:
  Walk(MainWindow& window, const QString& folder) : window_(window), folder_(folder) {}

  void save(const char* name) {
    QTest::qWait(150);
    window_.grab().save(QDir(folder_).filePath(QString(name) + ".png"));
  }
  void trigger(const char* name) {
    if (auto* action = window_.findChild<QAction*>(name)) action->trigger();
  }
  void show(const std::function<void(Scene&)>& change) {
    Scene scene = window_.session().scene();
    change(scene);
    window_.document().edit(scene);
    complete();
  }
  void complete() {
    (void)QTest::qWaitFor(
        [&] {
          return !window_.session().friction().isStale() &&
                 window_.session().friction().progress() >= 1;
        },
        20000);
  }
  void write(const char* name) {
    window_.curveCommands().save(QDir(folder_).filePath(name));
    (void)QTest::qWaitFor([&] { return QFile::exists(QDir(folder_).filePath(name)); }, 20000);
  }
  void present(bool on) {
    const QSize size = window_.size();
    window_.windowLayout().setPresenting(on);
    window_.resize(size);
  }
  void tab(int index) { window_.findChild<QTabWidget*>("tabs")->setCurrentIndex(index); }
  void compare(Scheme scheme, int oversampling) {
    pointer({2, 2});
    window_.findChild<QComboBox*>("comparisonScheme")->setCurrentIndex(static_cast<int>(scheme));
    window_.findChild<QSpinBox*>("comparisonOversampling")->setValue(oversampling);
    window_.findChild<QCheckBox*>("comparisonWanted")->setChecked(true);
    (void)QTest::qWaitFor(
        [&] {
          const auto& difference = window_.session().friction().difference();
          return difference && difference->done == difference->total;
        },
        20000);
  }
  /// The pointer over a point of the plot's series.
  void hover(std::size_t series, std::size_t point) {
    const DiagramPoint& at = plot().sheet().diagrams[0].series[series].points[point];
    pointer(plot().mapToPosition(at.x, at.y));
  }
  void pointer(QPointF place) { QTest::mouseMove(&plot(), place.toPoint()); }
  ChartView& plot() { return window_.plotView(); }

 private:
  MainWindow& window_;
  QString folder_;
};

void walk(Walk& walk) {
  walk.complete();
  walk.save("1_regions");
  walk.hover(1, walk.plot().sheet().diagrams[0].series[1].points.size() / 2);
  walk.save("2_reading");
  const auto& span = walk.plot().sheet().diagrams[0].spans;
  if (!span.empty()) {
    const double top = walk.plot().visibleRange().y.to;
    walk.pointer(walk.plot().mapToPosition(1.5 * span.back().from, std::pow(10, top)) -
                 QPointF(0, 8));
    walk.save("3_region");
  }
  walk.pointer({2, 2});
  walk.trigger("pinCurve");
  walk.show([](Scene& scene) { scene.elastomer.shearModulus *= 4; });
  walk.trigger("pinCurve");
  walk.show([](Scene& scene) { scene.load.normalForce *= 30; });
  walk.trigger("pinCurve");
  walk.show([](Scene& scene) { scene.surface.hurst = 0.3; });
  walk.save("4_pins");
  walk.trigger("dimensionlessAxes");
  walk.save("5_dimensionless");
  walk.trigger("dimensionlessAxes");
  walk.plot().zoom(0.4);
  walk.save("6_zoomed");
  walk.plot().fit();
  walk.trigger("unpinAll");
  walk.compare(Scheme::Linear, 4);
  walk.save("7_difference");
  walk.compare(Scheme::Nodal, 1);
  walk.save("8_difference_nodal");
  walk.present(true);
  walk.save("8_presented");
  walk.present(false);
  walk.trigger("pinCurve");
  walk.show([](Scene& scene) { scene.elastomer.shearModulus *= 4; });
  walk.compare(Scheme::Linear, 4);
  walk.write("10_saved.png");
  walk.tab(2);
  walk.save("9_accuracy");
}

}  // namespace

int main(int argc, char** argv) {
  if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  QApplication application(argc, argv);
  QCommandLineParser parser;
  parser.addPositionalArgument("FOLDER", "where the pictures go");
  parser.addOptions({{"dark", "dark colours"}, {"size", "of the window, WxH", "WxH", "1280x720"}});
  parser.process(application);
  if (parser.positionalArguments().size() != 1) parser.showHelp(1);
  prepareApplication(application);
  const std::vector<LibraryScene> library = libraryScenes();
  const auto scene = std::ranges::find(library, QStringLiteral("figure_2"), &LibraryScene::name);
  MainWindow window(scene == library.end() ? Scene{} : scene->scene);
  window.appearance().setDark(parser.isSet("dark"));
  const QStringList sides = parser.value("size").split('x');
  window.resize(sides[0].toInt(), sides[1].toInt());
  window.show();
  QDir().mkpath(parser.positionalArguments().constFirst());
  Walk steps(window, parser.positionalArguments().constFirst());
  walk(steps);
  return 0;
}
