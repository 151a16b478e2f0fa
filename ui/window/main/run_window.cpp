#include "ui/window/main/run_window.h"

#include <QApplication>
#include <QFont>
#include <QStyleFactory>
#include <QTimer>
#include <utility>

#include "core/scene/provenance.h"
#include "ui/draw/fonts.h"
#include "ui/language/language.h"
#include "ui/window/main/appearance.h"
#include "ui/window/main/main_window.h"
#include "ui/window/main/quit_limit.h"
#include "ui/window/main/scene_library.h"
#include "ui/window/main/start_times.h"
#include "ui/window/main/window_language.h"

namespace asperity {

namespace {

/// With what comes before and after it less than half a second.
constexpr std::chrono::milliseconds kQuitTime{400};

Scene firstScene() {
  const std::vector<LibraryScene>& scenes = libraryScenes();
  return scenes.empty() ? Scene{} : scenes.front().scene;
}

}  // namespace

void prepareApplication(QApplication& application) {
  QApplication::setOrganizationName(QStringLiteral("Asperity"));
  QApplication::setApplicationName(QStringLiteral("asperity"));
  QApplication::setApplicationDisplayName({});
  QApplication::setApplicationVersion(QStringLiteral(ASPERITY_VERSION));
  QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
  systemIsDark();  // while the palette is the desktop's
  loadFonts();
  QFont font = application.font();
  if (font.pointSizeF() > 0 && font.pointSizeF() < 9.5) font.setPointSizeF(9.5);
  QApplication::setFont(font);
}

int runWindow(QApplication& application, const std::optional<Scene>& scene, RunnerOptions options,
              const WindowStart& start) {
  if (start.timing) sayTime("connected to the display");
  prepareApplication(application);
  useLanguage(start.language.empty() ? windowLanguage() : start.language);
  auto window = std::make_unique<MainWindow>(scene ? *scene : firstScene(), options);
  window->rememberLayout();
  window->offerTour();
  if (start.timing) new StartTimes(*window);
  window->show();
  if (start.found)
    QTimer::singleShot(0, window.get(), [&start, shown = window.get()] {
      shown->showFound(QString::fromStdString(start.file), *start.found);
    });
  return runUntilClosed(application, std::move(window));
}

int runUntilClosed(QApplication& application, std::unique_ptr<MainWindow> window) {
  const int status = application.exec();
  const QuitLimit limit(kQuitTime, status);
  window.reset();
  return status;
}

}  // namespace asperity
