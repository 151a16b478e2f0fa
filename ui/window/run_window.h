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

/// Shows the scene, or the first of the library, until the window is closed; returns the exit code.
/// Without a language (a code, "de") the remembered one or the desktop's.
int runWindow(QApplication& application, const std::optional<Scene>& scene,
              RunnerOptions options = {}, std::string_view language = {});

}  // namespace asperity
