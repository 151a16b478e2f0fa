// asperity [SCENE or LESSON] opens the window; asperity open FILE opens it with the scene that made
// a picture, a film or a table.
#include <fmt/format.h>

#include <QApplication>
#include <cstdlib>
#include <optional>
#include <stdexcept>

#include "app/command_line.h"
#include "app/output.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/lesson_results.h"
#include "core/run/runner.h"
#include "core/scene/provenance.h"
#include "core/scene/scene_demands.h"
#include "core/scene/scene_file.h"
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
  printError("the display cannot be reached; 'asperity render SCENE -o DIR' needs none");
  std::_Exit(kRunFailed);
}

/// Opens the window with this scene. Throws std::runtime_error where there is no display. `found`:
/// a scene from inside the file options.scene; the window asks before it shows that scene.
/// `lesson`: the file of a lesson that begins at once; empty: none.
int showWindow(const std::optional<Scene>& scene, const CommonOptions& options,
               const FoundScene* found = nullptr, const std::string& lesson = {}) {
  if (!hasDisplay())
    throw std::runtime_error(
        "there is no display for the window; 'asperity render SCENE -o DIR' needs none");
  int count = 1;
  char name[] = "asperity";
  char* arguments[] = {name, nullptr};
  const QtMessageHandler usual = qInstallMessageHandler(endOnFatal);
  QApplication application(count, arguments);
  qInstallMessageHandler(usual);
  RunnerOptions running;
  running.threads = options.threads;
  return runWindow(application, scene, running,
                   {options.language, options.timing, found, options.scene, lesson});
}

}  // namespace

int runWindowCommand(const CommonOptions& command) {
  if (command.assignments.empty() && isLessonFile(command.scene)) {
    readLessonFile(command.scene, readNamedScene);  // errors are reported before the window opens
    return showWindow(std::nullopt, command, nullptr, command.scene);
  }
  if (command.assignments.empty() && isResultsFile(command.scene)) {
    readResultsFile(command.scene);
    return showWindow(std::nullopt, command, nullptr, command.scene);
  }
  const bool isDefault = command.scene.empty() && command.assignments.empty();
  return showWindow(isDefault ? std::nullopt : std::optional(loadScene(command)), command);
}

int runOpen(const OpenCommand& command) {
  const CommonOptions& common = command.common;
  FoundScene found = findScene(common.scene);
  found.scene = changedScene(found.scene, common.assignments, common.scene);
  if (common.json) {
    fmt::print("{}", writeScene(found.scene));
    return kDone;
  }
  // The window asks before it shows a scene that needs much time or memory. Until the answer it
  // shows the first scene of the library.
  if (found.isEmbedded && sceneDemands(found.scene).any()) return showWindow({}, common, &found);
  return showWindow(found.scene, common);
}

}  // namespace asperity
