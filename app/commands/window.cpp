// asperity [SCENE]: the window.
#include <QApplication>
#include <cstdlib>
#include <optional>
#include <stdexcept>

#include "app/command_line.h"
#include "core/run/runner.h"
#include "core/scene/input_error.h"
#include "ui/window/run_window.h"

namespace asperity {
namespace {

bool hasDisplay() {
  for (const char* variable : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}) {
    const char* value = std::getenv(variable);
    if (value && *value) return true;
  }
  return false;
}

}  // namespace

int runWindowCommand(const CommonOptions& command) {
  if (command.scene.empty() && !command.assignments.empty())
    throw InputError("", "--set", "needs a scene");
  const std::optional<Scene> scene =
      command.scene.empty() ? std::nullopt : std::optional(sceneOf(command));
  if (!hasDisplay())
    throw std::runtime_error(
        "there is no display for the window; 'asperity render SCENE -o DIR' needs none");
  int count = 1;
  char name[] = "asperity";
  char* arguments[] = {name, nullptr};
  QApplication application(count, arguments);
  RunnerOptions options;
  options.threads = command.threads;
  return runWindow(application, scene, options);
}

}  // namespace asperity
