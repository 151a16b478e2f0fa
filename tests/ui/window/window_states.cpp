#include "tests/ui/window/window_states.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QFile>
#include <QLineEdit>
#include <QMenu>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabWidget>
#include <QTest>
#include <algorithm>
#include <cmath>

#include "core/surface/line_source.h"
#include "tests/ui/window/window_in.h"
#include "ui/chart/chart_view.h"
#include "ui/panels/parameter_panel.h"
#include "ui/window/contact/contact_canvas.h"
#include "ui/window/main/document_commands.h"
#include "ui/window/main/message_bar.h"
#include "ui/window/main/scene_document.h"
#include "ui/window/main/scene_library.h"
#include "ui/window/main/session.h"
#include "ui/window/main/tour.h"
#include "ui/window/main/window_layout.h"
#include "ui/window/main/window_pages.h"

namespace asperity {

namespace {

void run(MainWindow& window, const char* action) {
  window.findChild<QAction*>(action)->trigger();
}

std::function<void(MainWindow&)> running(const char* action) {
  return [action](MainWindow& window) { run(window, action); };
}

QStringList sectionNames() {
  return {"sliding", "load",     "elastomer",  "surface", "interface",
          "sweep",   "accuracy", "comparison", "texts"};
}

QScrollBar& panelScroll(MainWindow& window) {
  return *window.panel().findChild<QScrollArea*>()->verticalScrollBar();
}

/// All rows of one section, or of all where `section` is empty, scrolled down by a part.
std::function<void(MainWindow&)> panelOf(const QString& section, double part = 0) {
  return [section, part](MainWindow& window) {
    QStringList folded = sectionNames();
    if (section.isEmpty())
      folded.clear();
    else
      folded.removeOne(section);
    window.panel().setView({true, folded});
    QApplication::processEvents();
    QScrollBar& bar = panelScroll(window);
    bar.setValue(static_cast<int>(part * bar.maximum()));
  };
}

std::function<void(MainWindow&)> filterOf(const char* words) {
  return [words](MainWindow& window) {
    window.findChild<QLineEdit*>("parameterFilter")->setText(words);
  };
}

std::function<void(MainWindow&)> editing(std::function<void(Scene&)> change) {
  return [change](MainWindow& window) {
    Scene scene = window.document().scene();
    change(scene);
    window.document().edit(scene);
  };
}

void type(MainWindow& window, const char* key, const char* text) {
  window.panel().reveal(key);
  auto* entry = window.findChild<ValueEntry*>(QStringLiteral("entry:") + key);
  entry->setFocus();
  entry->selectAll();
  QTest::keyClicks(entry, text);
  QTest::keyClick(entry, Qt::Key_Return);
}

void pinTwo(MainWindow& window) {
  for (const double force : {2.0, 4.0}) {
    run(window, "pinCurve");
    Scene scene = window.document().scene();
    scene.load.normalForce *= force;
    window.document().edit(scene);
    waitForScene(window);
  }
}

void closeDialogs() {
  for (QWidget* each : QApplication::topLevelWidgets())
    if (auto* dialog = qobject_cast<QDialog*>(each); dialog && dialog->isVisible())
      dialog->reject();
  QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
}

void endTour(MainWindow& window) {
  if (window.tour().isRunning()) window.findChild<QAbstractButton*>("tourEnd")->click();
}

void present(MainWindow& window, bool isOn, bool withPanel) {
  const QSize size = window.size();
  window.windowLayout().setPresenting(isOn);
  if (!isOn) return;
  window.showNormal();  // the screen may be larger than what is asked for
  window.resize(size);
  if (withPanel) window.findChild<QDockWidget*>("parameterDock")->show();
}

}  // namespace

std::vector<WindowState> windowStates() {
  std::vector<WindowState> states;
  const auto add = [&](
                       std::string name, const std::string& scene,
                       std::function<void(MainWindow&)> enter = [](MainWindow&) {},
                       std::function<void(MainWindow&)> leave = [](MainWindow&) {}) {
    states.push_back({std::move(name), scene, std::move(enter), std::move(leave)});
  };
  // ---- tabs and panel of a usual scene
  add("essentials", kUsualScene);
  for (const char* go : {"go:spectrumView", "go:statisticsView", "go:materialView",
                         "go:accuracyPanel", "go:planList", "go:mapPanel", "go:influencePage"})
    add("tab_" + std::string(go).substr(3), kUsualScene, running(go));
  const auto compare = [](MainWindow& window, bool isOn) {
    run(window, "go:accuracyPanel");
    window.findChild<QAbstractButton*>("comparisonWanted")->setChecked(isOn);
  };
  add(
      "tab_accuracy_compared", kUsualScene, [=](MainWindow& window) { compare(window, true); },
      [=](MainWindow& window) { compare(window, false); });
  for (const QString& section : sectionNames())
    add("panel_" + section.toStdString(), kUsualScene, panelOf(section));
  add(
      "panel_comparison_open", kUsualScene,
      [](MainWindow& window) {
        panelOf("comparison")(window);
        window.findChild<QComboBox*>("list:comparison.theory")->showPopup();
      },
      [](MainWindow&) {
        if (QWidget* list = QApplication::activePopupWidget()) list->close();
      });
  add("panel_all", kUsualScene, panelOf({}));
  add("panel_all_middle", kUsualScene, panelOf({}, 0.5));
  add("panel_all_end", kUsualScene, panelOf({}, 1));
  add("panel_folded", kUsualScene, [](MainWindow& window) {
    window.panel().setView({true, sectionNames()});
  });
  add("filter_temperature", kUsualScene, filterOf("temp"));
  add("filter_newton", kUsualScene, filterOf("N"));
  add("filter_nothing", kUsualScene, filterOf("xyzzy"));
  add("warning_steep", kUsualScene, editing([](Scene& scene) { scene.surface.rmsHeight = 4e-4; }));
  add("warning_few_contacts", kUsualScene,
      editing([](Scene& scene) { scene.load.normalForce = 1e-6; }));
  add("warning_refused", kUsualScene,
      [](MainWindow& window) { type(window, "surface.hurst", "1.7"); });
  add("warning_unit", kUsualScene,
      [](MainWindow& window) { type(window, "load.normal_force", "0.5 kg"); });
  add("dock_hidden", kUsualScene,
      [](MainWindow& window) { window.findChild<QDockWidget*>("parameterDock")->hide(); });
  add("scene_changed", kUsualScene, editing([](Scene& scene) { scene.sliding.velocity = 3; }));
  add("axes_dimensionless", kUsualScene, running("dimensionlessAxes"));
  add("curves_pinned", kUsualScene, pinTwo, running("unpinAll"));
  add("theories", kUsualScene, [](MainWindow& window) {
    for (QAction* action : window.findChildren<QAction*>())
      if (action->objectName().startsWith("theory:") && action->isEnabled()) action->trigger();
  });
  add("contact_magnified", kUsualScene, running("magnify"), running("magnify"));
  add("contact_power", kUsualScene, running("overlay:power"), running("overlay:pressure"));
  add("contact_relaxation", kUsualScene, running("overlay:relaxation"),
      running("overlay:pressure"));
  add("contact_uncoloured", kUsualScene, running("overlay:none"), running("overlay:pressure"));
  add("message_scene", kUsualScene, editing([](Scene& scene) {
        scene.elastomer.rheology = Rheology::Prony;
        scene.elastomer.equilibriumModulus = 0;
        scene.elastomer.arms.clear();
      }));
  add("message_file", kUsualScene, [](MainWindow& window) {
    openIn(window, QStringLiteral("/no/such/folder/with a rather long name of its own/scene.json"));
  });
  add(
      "hint_tour", kUsualScene, [](MainWindow& window) { window.tour().offer(); },
      [](MainWindow& window) { window.findChild<MessageBar*>("hintBar")->hide(); });
  add("gallery", kUsualScene, [](MainWindow& window) { window.openGallery(); });
  add("gallery_filter", kUsualScene, [](MainWindow& window) {
    window.openGallery();
    window.findChild<QLineEdit*>("sceneFilter")->setText("xyzzy");
  });
  add("keys", kUsualScene, running("shortcuts"));
  add("about", kUsualScene, running("about"));
  add(
      "present", kUsualScene, [](MainWindow& window) { present(window, true, false); },
      [](MainWindow& window) { present(window, false, false); });
  add(
      "present_panel", kUsualScene, [](MainWindow& window) { present(window, true, true); },
      [](MainWindow& window) { present(window, false, false); });
  // ---- other kinds of scenes
  add("motion_oscillation", "oscillation", running("go:transientStrips"));
  add("motion_panel", "oscillation", panelOf("sliding"));
  add("motion_curve", "oscillation", running("go:frictionPlot"));
  add("motion_stop", "stop", running("go:transientStrips"));
  add("motion_reversal", "reversal", running("go:transientStrips"));
  add("arms", "tread_compound", panelOf("elastomer"));
  add("arms_table", "tread_compound", [](MainWindow& window) {
    panelOf("elastomer")(window);
    window.findChild<QAbstractButton*>("armsFold")->click();
  });
  add("arms_material", "tread_compound", running("go:materialView"));
  add("temperature", "temperature_tread", panelOf("elastomer", 1));
  add("temperature_essentials", "temperature_tread");
  add("interface_shear", "interface_shear", panelOf("interface"));
  add("pressure", "rubber_on_sandpaper", panelOf("load"));
  add("half_space", "foundation_and_half_space");
  add("region_4", "region_4");
  add("full_contact", "full_contact");
  add("wedge", "wedge", panelOf("surface"));
  add("at_rest", kUsualScene, editing([](Scene& scene) { scene.sliding.velocity = 0; }));
  add("measured", kMeasuredScene, panelOf("surface"));
  add("measured_essentials", kMeasuredScene);
  add("measured_spectrum", kMeasuredScene, running("go:spectrumView"));
  // ---- the tour has scenes of its own
  for (std::size_t step = 0; step < Tour::steps().size(); ++step)
    add("tour_" + std::to_string(step + 1), kUsualScene, [step](MainWindow& window) {
      run(window, "tour");
      for (std::size_t i = 0; i < step; ++i) run(window, "tourStepNext");
    });
  return states;
}

Scene StateScenes::scene(const std::string& name) const {
  Scene scene;
  if (name == kMeasuredScene) {
    const QString path = folder_.filePath("ground_steel.csv");
    QFile file(path);
    if (file.open(QIODevice::WriteOnly)) {
      file.write("x [mm];z [um]\n");
      for (int i = 0; i < 400; ++i)
        file.write(QStringLiteral("%1;%2\n")
                       .arg(i * 1e-3)
                       .arg(std::sin(0.2 * i) + 0.5 * std::cos(0.77 * i) + 0.001 * i)
                       .toUtf8());
    }
    scene.folder = folder_.path().toStdString();
    scene.title = "ground_steel";  // as the import of the file names it
    scene.surface.kind = SurfaceKind::Measured;
    scene.surface.file = "ground_steel.csv";
    scene.surface.length = 0;
    scene.surface.elements = 0;
    scene.ensemble.realizations = 0;
    return scene;
  }
  for (const LibraryScene& entry : libraryScenes())
    if (entry.name.toStdString() == name) scene = entry.scene;
  if (isQuick_) {
    scene.surface.elements = std::min<std::int64_t>(scene.surface.elements, 256);
    scene.sweep.points = std::min<std::int64_t>(scene.sweep.points, 7);
    if (scene.ensemble.realizations > 2) scene.ensemble.realizations = 2;
  }
  return scene;
}

bool waitForScene(MainWindow& window) {
  const Session& session = window.session();
  return QTest::qWaitFor(
      [&] {
        const Frame* frame = session.frame().get();
        return frame && frame->sceneNumber == session.sceneNumber() &&
               window.session().friction().progress() >= 1;
      },
      kWindowPatience);
}

void leaveState(MainWindow& window, const WindowState& state) {
  state.leave(window);
  closeDialogs();
  endTour(window);
  window.pages().showViews();
  window.findChild<QLineEdit*>("parameterFilter")->clear();
  window.panel().setView(ParameterPanel::defaultView());
  window.panel().clearErrors();
  panelScroll(window).setValue(0);
  window.findChild<QDockWidget*>("parameterDock")->show();
  window.messages().forget();
  window.findChild<QTabWidget*>("tabs")->setCurrentIndex(0);
  if (QAction* axes = window.findChild<QAction*>("dimensionlessAxes"); axes && axes->isChecked())
    axes->trigger();
}

}  // namespace asperity
