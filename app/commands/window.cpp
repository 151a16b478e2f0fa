// asperity [SCENE or LESSON]: opens the window.
#include <QApplication>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <stdexcept>

#include "app/command_line.h"
#include "core/lesson/lesson_file.h"
#include "core/run/runner.h"
#include "ui/window/main/run_window.h"
#include "ui/window/main/scene_library.h"

namespace asperity {
namespace {

bool hasDisplay() {
  for (const char* variable : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}) {
    const char* value = std::getenv(variable);
    if (value && *value) return true;
  }
  return false;
}

/// Qt ends the program where it finds no platform. This handler reports that in one line instead,
/// and hides Qt's messages about earlier attempts.
void endOnFatal(QtMsgType type, const QMessageLogContext&, const QString&) {
  if (type != QtFatalMsg) return;
  std::fputs("asperity: the display cannot be reached; 'asperity render SCENE -o DIR' needs none\n",
             stderr);
  std::_Exit(kRunFailed);
}

}  // namespace

int showWindow(const std::optional<Scene>& scene, const CommonOptions& command,
               const FoundScene* found, const std::string& lesson) {
  if (!hasDisplay())
    throw std::runtime_error(
        "there is no display for the window; 'asperity render SCENE -o DIR' needs none");
  int count = 1;
  char name[] = "asperity";
  char* arguments[] = {name, nullptr};
  const QtMessageHandler usual = qInstallMessageHandler(endOnFatal);
  QApplication application(count, arguments);
  qInstallMessageHandler(usual);
  RunnerOptions options;
  options.threads = command.threads;
  return runWindow(application, scene, options,
                   {command.language, command.timing, found, command.scene, lesson});
}

int runWindowCommand(const CommonOptions& command) {
  if (command.assignments.empty() && isLessonFile(command.scene)) {
    readLessonFile(command.scene, readNamedScene);  // errors are reported before the window opens
    return showWindow(std::nullopt, command, nullptr, command.scene);
  }
  const bool isDefault = command.scene.empty() && command.assignments.empty();
  return showWindow(isDefault ? std::nullopt : std::optional(loadScene(command)), command);
}

}  // namespace asperity
