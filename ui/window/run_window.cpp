#include "ui/window/run_window.h"

#include <QApplication>
#include <QFont>
#include <QStyleFactory>

#include "ui/language/language.h"
#include "ui/picture/text_painter.h"
#include "ui/window/appearance.h"
#include "ui/window/main_window.h"
#include "ui/window/scene_library.h"
#include "ui/window/start_times.h"
#include "ui/window/window_language.h"

namespace asperity {

namespace {

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
  MainWindow window(scene ? *scene : firstScene(), options);
  window.rememberLayout();
  window.offerTour();
  if (start.timing) new StartTimes(window);
  window.show();
  return application.exec();
}

}  // namespace asperity
