#include "ui/window/main/last_session.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QSettings>
#include <QTimer>
#include <exception>
#include <filesystem>
#include <string>

#include "core/base/input_error.h"
#include "core/scene/scene_file.h"
#include "core/scene/scene_files.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/window/contact/contact_canvas.h"
#include "ui/window/main/main_window.h"
#include "ui/window/main/scene_document.h"
#include "ui/window/main/scene_library.h"
#include "ui/window/main/scene_tabs.h"
#include "ui/window/main/status_line.h"

namespace asperity {

namespace {

struct LastSessionText {
  Q_DECLARE_TR_FUNCTIONS(asperity::LastSessionText)
};

const QString kGroup = QStringLiteral("lastSession");

/// Reads the origin of the scene again; returns an unknown origin where it no longer exists.
SceneOrigin findOrigin(const QString& shipped, const QString& file) {
  if (const LibraryScene* found = findLibraryScene(shipped)) return {shipped, {}, found->scene};
  if (!file.isEmpty() && QFileInfo(file).isFile())
    return {{}, file, readSceneFile(file.toStdString())};
  return {};
}

/// Throws InputError where a file is missing that the scene reads only when it runs.
void checkFiles(const Scene& scene) {
  if (!hasSurfaceFile(scene.surface)) return;
  const std::filesystem::path file = scene.folder / scene.surface.file;
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) throw InputError(file.string(), "", "is not there");
}

/// Reads the scene. Throws InputError or std::exception where it cannot be read.
SceneState readLastScene(const QSettings& settings) {
  SceneState state;
  state.origin =
      findOrigin(settings.value("shipped").toString(), settings.value("file").toString());
  const bool isKnown = state.origin.isKnown();
  if (isKnown && !settings.value("isChanged").toBool()) {
    state.scene = state.origin.scene;
  } else {
    std::filesystem::path folder = settings.value("folder").toString().toStdString();
    if (isKnown) folder = state.origin.scene.folder;
    state.scene = readScene(settings.value("scene").toString().toStdString(), {}, folder);
    if (!isKnown) state.origin.scene = state.scene;
  }
  checkFiles(state.scene);
  return state;
}

void restoreView(ContactCanvas& canvas, const QSettings& settings) {
  canvas.setNavigation(ViewNavigation::fromText(settings.value("view").toString().toStdString()));
  const std::string word = settings.value("overlay").toString().toStdString();
  if (const auto overlay = findChoice(kContactOverlays, word)) canvas.setOverlay(*overlay);
}

}  // namespace

void saveLastSession(MainWindow& window, SessionMoment moment) {
  const SceneState state = window.document().lastingState();
  const SceneOrigin& origin = state.origin;
  const bool isDiscarded = moment == SessionMoment::End && state.isUnsavedFile();
  Scene scene = isDiscarded ? origin.scene : state.scene;
  const bool isChanged = !(scene == origin.scene);
  std::filesystem::path folder = std::filesystem::current_path() / scene.folder;
  // The scene may have been saved in another folder than the one from which it came. The next start
  // reads it in that of its file.
  if (!origin.file.isEmpty()) {
    folder = std::filesystem::absolute(origin.file.toStdString()).parent_path();
    scene = withFilesRelativeTo(folder, scene);
  }
  QSettings settings;
  settings.beginGroup(kGroup);
  settings.setValue("scene", QString::fromStdString(writeScene(scene)));
  settings.setValue("isChanged", isChanged);
  settings.setValue("folder", QString::fromStdString(folder.string()));
  settings.setValue("shipped", origin.shipped);
  settings.setValue("file",
                    origin.file.isEmpty() ? QString() : QFileInfo(origin.file).absoluteFilePath());
  const ContactViewer& viewer = window.canvas().viewer();
  settings.setValue("view", QString::fromStdString(viewer.navigation().toText()));
  settings.setValue("overlay", fromUtf8(choiceWord(kContactOverlays, viewer.overlay())));
  settings.setValue("tab", window.tabs().currentWidget()->objectName());
  settings.sync();
}

void keepLastSession(MainWindow& window) {
  auto* timer = new QTimer(&window);
  timer->setSingleShot(true);
  timer->setInterval(kSessionDelay);
  QObject::connect(timer, &QTimer::timeout, &window,
                   [&window] { saveLastSession(window, SessionMoment::Running); });
  // Changes that follow each other do not put the writing off.
  const auto start = [timer] {
    if (!timer->isActive()) timer->start();
  };
  const SceneDocument& document = window.document();
  QObject::connect(&document, &SceneDocument::sceneChanged, timer, start);
  QObject::connect(&document, &SceneDocument::historyChanged, timer, start);
}

bool restoreLastSession(MainWindow& window, bool hasScene) {
  QSettings settings;
  settings.beginGroup(kGroup);
  if (!settings.contains("scene")) return false;
  if (!hasScene) {
    try {
      window.document().begin(readLastScene(settings));
      restoreView(window.canvas(), settings);
    } catch (const std::exception& error) {
      window.status().showMessage(LastSessionText::tr("The scene of last time cannot be shown: %1")
                                      .arg(translatedError(error)));
    }
  }
  window.tabs().bringToFront(settings.value("tab").toString());
  return true;
}

}  // namespace asperity
