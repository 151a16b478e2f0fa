// The window as a program: fonts, style, one MainWindow, the event loop.
#pragma once

#include <optional>
#include <string_view>

#include "core/run/runner.h"
#include "core/scene/scene.h"

class QApplication;

namespace asperity {

/// Style and fonts for the whole application; call once, before the first widget.
void prepareApplication(QApplication& application);

/// How the window begins.
struct WindowStart {
  std::string_view language{};  // its code, "de"; empty: the remembered one or the desktop's
  bool timing = false;          // says on standard error how long the start takes
};

/// Shows the scene, or the first of the library, until the window is closed; returns the exit code.
int runWindow(QApplication& application, const std::optional<Scene>& scene,
              RunnerOptions options = {}, const WindowStart& start = {});

}  // namespace asperity
