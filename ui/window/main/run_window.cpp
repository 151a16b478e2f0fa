#include "ui/window/main/run_window.h"

#include <time.h>
#include <unistd.h>
#include <QApplication>
#include <QEvent>
#include <QFile>
#include <QFileInfo>
#include <QFont>
#include <QLocale>
#include <QSettings>
#include <QTimer>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <utility>

#include "core/scene/provenance.h"
#include "core/scene/scene_file.h"
#include "ui/draw/fonts.h"
#include "ui/language/language.h"
#include "ui/window/contact/contact_canvas.h"
#include "ui/window/lesson/lessons.h"
#include "ui/window/main/document_commands.h"
#include "ui/window/main/last_session.h"
#include "ui/window/main/main_window.h"
#include "ui/window/main/scene_document.h"
#include "ui/window/main/scene_library.h"
#include "ui/window/main/session.h"
#include "ui/window/main/tour.h"
#include "ui/window/main/window_layout.h"
#include "ui/window/main/window_pages.h"
#include "ui/window/main/window_style.h"

namespace asperity {

namespace {

const QString kLanguage = QStringLiteral("language");

/// Together with the work before and after it, this is less than half a second.
constexpr std::chrono::milliseconds kQuitTime{400};

/// Returns the first scene of the library.
SceneState firstScene() {
  const std::vector<LibraryScene>& scenes = libraryScenes();
  if (scenes.empty()) return {};
  return {{scenes.front().name, {}, scenes.front().scene}, scenes.front().scene};
}

/// Returns the scene with its origin: the file of this name, or the shipped scene of this name.
SceneState stateWithOrigin(const Scene& scene, const std::string& name) {
  SceneState state{{{}, {}, scene}, scene};
  try {
    const QFileInfo file(QString::fromStdString(name));
    // Values of the command line are no changes of the file that would have to be saved.
    if (file.isFile() && readSceneFile(name) == scene)
      state.origin = {{}, file.absoluteFilePath(), scene};
    if (!file.exists())
      for (const LibraryScene& entry : libraryScenes())
        if (entry.name + ".json" == QString::fromStdString(name))
          state.origin = {entry.name, {}, entry.scene};
  } catch (const std::exception&) {
    // With its assignments the scene could be read; without them the file cannot.
  }
  return state;
}

}  // namespace

std::string_view chosenLanguage() {
  return languageFor(QSettings().value(kLanguage).toString().toStdString());
}

void chooseLanguage(const QString& code) {
  if (code.isEmpty())
    QSettings().remove(kLanguage);
  else
    QSettings().setValue(kLanguage, code);
}

std::string_view windowLanguage() {
  if (const std::string_view code = chosenLanguage(); !code.empty()) return code;
  for (const QString& locale : QLocale::system().uiLanguages())
    if (const std::string_view code = languageFor(locale.toStdString()); !code.empty()) return code;
  return "en";
}

namespace {

/// Gives screen readers the tooltips without markup, which Qt would pass on as it is. A widget that
/// has a description of its own keeps it.
class SpokenTooltips : public QObject {
 public:
  using QObject::QObject;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    auto* widget =
        event->type() == QEvent::ToolTipChange ? qobject_cast<QWidget*>(watched) : nullptr;
    if (widget) describe(*widget);
    return QObject::eventFilter(watched, event);
  }

 private:
  static void describe(QWidget& widget) {
    constexpr const char* kSpoken = "spokenTooltip";  // what this class has set
    const QString description = widget.accessibleDescription();
    if (!description.isEmpty() && description != widget.property(kSpoken).toString()) return;
    const QString tip = widget.toolTip();
    const QString spoken = Qt::mightBeRichText(tip) ? spokenText(tip) : QString();
    if (spoken == description) return;
    widget.setProperty(kSpoken, spoken);
    widget.setAccessibleDescription(spoken);
  }
};

}  // namespace

void prepareApplication(QApplication& application) {
  application.installEventFilter(new SpokenTooltips(&application));
  QApplication::setOrganizationName(QStringLiteral("Asperity"));
  QApplication::setApplicationName(QStringLiteral("asperity"));
  QApplication::setApplicationDisplayName({});
  QApplication::setApplicationVersion(QStringLiteral(ASPERITY_VERSION));
  QApplication::setStyle(new WindowStyle);
  loadFonts();
  QFont font = application.font();
  if (font.pointSizeF() > 0 && font.pointSizeF() < 9.5) font.setPointSizeF(9.5);
  QApplication::setFont(font);
}

int runWindow(QApplication& application, const std::optional<Scene>& scene, RunnerOptions options,
              const WindowStart& start) {
  if (start.timing) printTime("connected to the display");
  prepareApplication(application);
  useLanguage(start.language.empty() ? windowLanguage() : start.language);
  const SceneState first = scene ? stateWithOrigin(*scene, start.file) : firstScene();
  auto window = std::make_unique<MainWindow>(first.scene, options);
  window->document().begin(first);
  window->windowLayout().remember();
  const bool isRequested = scene.has_value() || start.found;
  if (!restoreLastSession(*window, isRequested) && !isRequested) window->openGallery();
  keepLastSession(*window);
  window->tour().offer();
  if (start.timing) new StartTimes(*window);
  // Otherwise the first button would have the focus, which the space bar then presses.
  if (window->pages().isShowingViews()) window->canvas().setFocus();
  window->show();
  if (start.found)
    QTimer::singleShot(0, window.get(), [&start, shown = window.get()] {
      shown->documentCommands().showFound(QString::fromStdString(start.file), *start.found);
    });
  if (!start.lesson.empty())
    QTimer::singleShot(0, window.get(), [&start, shown = window.get()] {
      shown->lessons().open(QString::fromStdString(start.lesson));
    });
  return runUntilClosed(application, std::move(window));
}

int runUntilClosed(QApplication& application, std::unique_ptr<MainWindow> window) {
  const int status = application.exec();
  const QuitLimit limit(kQuitTime, status);
  window.reset();
  return status;
}

// ---- The end

QuitLimit::QuitLimit(std::chrono::milliseconds limit, int status)
    : thread_([this, limit, status] {
        std::unique_lock lock(mutex_);
        if (!changed_.wait_for(lock, limit, [this] { return isOver_; })) std::_Exit(status);
      }) {}

QuitLimit::~QuitLimit() {
  {
    const std::lock_guard lock(mutex_);
    isOver_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

// ---- The start

namespace {

constexpr int kStartField = 19;  // field of /proc/self/stat after the name

double toSeconds(const timespec& time) {
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

double secondsSinceStart() {
  QFile file(QStringLiteral("/proc/self/stat"));
  timespec now{};
  if (!file.open(QIODevice::ReadOnly) || clock_gettime(CLOCK_BOOTTIME, &now) != 0) return 0;
  const QByteArray text = file.readAll();
  const QList<QByteArray> fields = text.mid(text.lastIndexOf(')') + 2).split(' ');
  if (fields.size() <= kStartField) return 0;
  const double start = fields[kStartField].toDouble() / static_cast<double>(sysconf(_SC_CLK_TCK));
  return toSeconds(now) - start;
}

void printTime(const char* name) {
  timespec busy{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &busy);
  std::fprintf(stderr, "%s after %.3f s, %.3f s of them computing\n", name, secondsSinceStart(),
               toSeconds(busy));
}

StartTimes::StartTimes(MainWindow& window) : QObject(&window) {
  printTime("window made");
  window.installEventFilter(this);
  connect(&window.canvas(), &ContactCanvas::painted, this, [this, &window] {
    printTime("first picture of the contact");
    disconnect(&window.canvas(), nullptr, this, nullptr);
  });
  connect(&window.session(), &Session::plotChanged, this, [this, &window] {
    const CurveUpdate* curve = window.session().curve();
    if (!curve) return;
    printTime("first curve");
    disconnect(&window.session(), nullptr, this, nullptr);
  });
}

/// The first picture is on the screen once the event that paints it has been handled.
bool StartTimes::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Paint) {
    watched->removeEventFilter(this);
    QMetaObject::invokeMethod(
        this, [] { printTime("window on the screen"); }, Qt::QueuedConnection);
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace asperity
