// The window as a program: fonts, style, language, one MainWindow, the event loop, and an end that
// does not keep a user waiting.
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

/// Style and fonts for the whole application; call once, before the first widget.
void prepareApplication(QApplication& application);

/// The code of the window's language: the one that was chosen and is remembered between runs; else
/// the first of the desktop's that is there; else English. After prepareApplication.
std::string_view windowLanguage();
/// Empty where none was chosen. Choosing an empty code follows the desktop from now on.
std::string_view chosenLanguage();
void chooseLanguage(const QString& code);

/// How the window begins.
struct WindowStart {
  std::string_view language{};        // its code, "de"; empty: windowLanguage()
  bool timing = false;                // says on standard error how long the start takes
  const FoundScene* found = nullptr;  // shown as DocumentCommands::showFound() does; null: none
  std::string file{};                 // that it was found in
};

/// Shows the scene, or the first of the library, until the window is closed; returns the exit code.
int runWindow(QApplication& application, const std::optional<Scene>& scene,
              RunnerOptions options = {}, const WindowStart& start = {});

/// Runs until the window is closed, and destroys it; returns the exit code. What works in the
/// background and does not stop within half a second ends with the process.
int runUntilClosed(QApplication& application, std::unique_ptr<MainWindow> window);

/// A watchdog: ends the process with `status` if the end of the program takes longer than `limit`
/// after the construction of this object. Work in the background is asked to stop and mostly does
/// within milliseconds; a transform of millions of points, or a disk that does not answer, cannot
/// be asked. Files are safe from a sudden end: each is whole or not there. Threading: constructed
/// and destroyed on one thread.
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

/// Seconds since the process was started, by the system's own clock (to 0.01 s); 0 where it is not
/// known.
double secondsSinceStart();

/// Says "NAME after 0.312 s, 0.210 s of them computing": the processor time of this thread tells a
/// slow start from a busy machine.
void sayTime(const char* name);

/// Watches the window until all is said. Owned by the window.
class StartTimes : public QObject {
 public:
  explicit StartTimes(MainWindow& window);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace asperity
