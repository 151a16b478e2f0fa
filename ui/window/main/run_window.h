// The window as a program: fonts, style, one MainWindow, the event loop.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/run/runner.h"
#include "core/scene/scene.h"

class QApplication;

namespace asperity {

class MainWindow;
struct FoundScene;

/// Style and fonts for the whole application; call once, before the first widget.
void prepareApplication(QApplication& application);

/// How the window begins.
struct WindowStart {
  std::string_view language{};        // its code, "de"; empty: the remembered one or the desktop's
  bool timing = false;                // says on standard error how long the start takes
  const FoundScene* found = nullptr;  // shown as MainWindow::showFound() does; null: none
  std::string file{};                 // that it was found in
};

/// Shows the scene, or the first of the library, until the window is closed; returns the exit code.
int runWindow(QApplication& application, const std::optional<Scene>& scene,
              RunnerOptions options = {}, const WindowStart& start = {});

/// Runs until the window is closed, and destroys it; returns the exit code. What works in the
/// background and does not stop within half a second ends with the process.
int runUntilClosed(QApplication& application, std::unique_ptr<MainWindow> window);

}  // namespace asperity
