// The states of the main window that a person can reach, each with what leads to it. For tests and
// for pictures of all of them; GUI thread.
#pragma once

#include <QDialog>
#include <QPointer>
#include <QStringList>
#include <QTemporaryDir>
#include <functional>
#include <string>
#include <vector>

#include "core/scene/scene.h"
#include "ui/window/main/main_window.h"

namespace asperity {

struct WindowState {
  std::string name;   // "motion_strips"; of its picture, too
  std::string scene;  // that it needs: a shipped one, or a name of this header
  std::function<void(MainWindow&)> enter;
  std::function<void(MainWindow&)> leave = [](MainWindow&) {};
};

inline constexpr const char* kUsualScene = "figure_2";
inline constexpr const char* kMeasuredScene = "measured line";

/// Returns the states, those of the same scene together.
std::vector<WindowState> windowStates();

/// The scenes that states need.
class StateScenes {
 public:
  /// `isQuick`: with few elements and few random lines.
  explicit StateScenes(bool isQuick) : isQuick_(isQuick) {}

  Scene scene(const std::string& name) const;

 private:
  bool isQuick_;
  QTemporaryDir folder_;  // of the measured line
};

/// Waits for the first frame and the whole curve of the scene, so that warnings and readings are
/// there.
bool waitForScene(MainWindow& window);

/// Puts everything back that a state may have changed, except for the scene.
void leaveState(MainWindow& window, const WindowState& state);

}  // namespace asperity
