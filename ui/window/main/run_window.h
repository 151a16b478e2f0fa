// The window as a program: fonts, style, language, one MainWindow, the event loop, and a quick end.
// Main thread.
#pragma once

#include <QObject>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

#include "core/run/runner.h"
#include "core/scene/scene.h"

class QApplication;

namespace asperity {

class MainWindow;
struct FoundScene;

/// Sets style and fonts for the whole application; call it once, before the first widget.
void prepareApplication(QApplication& application);

/// Returns the code of the window's language: the one that was chosen and is remembered between
/// runs; otherwise the first available one of the desktop's; otherwise English. Call it after
/// prepareApplication.
std::string_view windowLanguage();
/// Returns the chosen language; empty where none was chosen. Choosing an empty code follows the
/// desktop.
std::string_view chosenLanguage();
void chooseLanguage(const QString& code);

/// Options for the start of the window.
struct WindowStart {
  std::string_view language{};        // its code, "de"; empty: windowLanguage()
  bool timing = false;                // prints to stderr how long the start takes
  const FoundScene* found = nullptr;  // shown as DocumentCommands::showFound() does; null: none
  std::string file{};                 // the file in which it was found, or the scene was read
  std::string lesson{};               // name or file of a lesson to begin; empty: none
};

/// Shows the scene, or the first of the library, until the window is closed; returns the exit code.
int runWindow(QApplication& application, const std::optional<Scene>& scene,
              RunnerOptions options = {}, const WindowStart& start = {});

/// Runs until the window is closed, and destroys it; returns the exit code. Background work that
/// does not stop within half a second ends with the process.
int runUntilClosed(QApplication& application, std::unique_ptr<MainWindow> window);

/// A watchdog: ends the process with `status` if the end of the program takes longer than `limit`
/// after the construction of this object. Background work is asked to stop, and mostly does within
/// milliseconds; a transform of millions of points, or a disk that does not answer, cannot stop. A
/// sudden end does not harm files: each is complete or absent. Threading: constructed and destroyed
/// on one thread.
class QuitLimit {
 public:
  QuitLimit(std::chrono::milliseconds limit, int status);
  ~QuitLimit();
  QuitLimit(const QuitLimit&) = delete;
  QuitLimit& operator=(const QuitLimit&) = delete;

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool isOver_ = false;
  std::thread thread_;  // last: uses the above
};

/// Returns the seconds since the process was started, by the system's own clock (to 0.01 s); 0
/// where this is unknown.
double secondsSinceStart();

/// Prints "NAME after 0.312 s, 0.210 s of them computing": the processor time of this thread
/// distinguishes a slow start from a busy machine.
void printTime(const char* name);

/// Watches the window until all times have been printed. Owned by the window.
class StartTimes : public QObject {
 public:
  explicit StartTimes(MainWindow& window);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace asperity
