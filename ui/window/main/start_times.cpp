#include "ui/window/main/start_times.h"

#include <time.h>
#include <unistd.h>

#include <QEvent>
#include <QFile>
#include <QWindow>
#include <cstdio>

#include "ui/window/main/contact_canvas.h"
#include "ui/window/main/main_window.h"
#include "ui/window/main/session.h"

namespace asperity {

namespace {

constexpr int kStartField = 19;  // of /proc/self/stat, behind the name

}  // namespace

double secondsSinceStart() {
  QFile file(QStringLiteral("/proc/self/stat"));
  timespec now{};
  if (!file.open(QIODevice::ReadOnly) || clock_gettime(CLOCK_BOOTTIME, &now) != 0) return 0;
  const QByteArray text = file.readAll();
  const QList<QByteArray> fields = text.mid(text.lastIndexOf(')') + 2).split(' ');
  if (fields.size() <= kStartField) return 0;
  const double start = fields[kStartField].toDouble() / static_cast<double>(sysconf(_SC_CLK_TCK));
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec) - start;
}

void sayTime(const char* name) {
  timespec busy{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &busy);
  std::fprintf(stderr, "%s after %.3f s, %.3f s of them computing\n", name, secondsSinceStart(),
               static_cast<double>(busy.tv_sec) + 1e-9 * static_cast<double>(busy.tv_nsec));
}

StartTimes::StartTimes(MainWindow& window) : QObject(&window) {
  sayTime("window made");
  window.installEventFilter(this);
  connect(&window.canvas(), &ContactCanvas::painted, this, [this, &window] {
    sayTime("first picture of the contact");
    disconnect(&window.canvas(), nullptr, this, nullptr);
  });
  connect(&window.session(), &Session::plotChanged, this, [this, &window] {
    const CurveUpdate* curve = window.session().curve();
    if (!curve) return;
    sayTime("first curve");
    disconnect(&window.session(), nullptr, this, nullptr);
  });
}

/// What is painted at the first exposure is on the screen when the event has been handled.
bool StartTimes::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Paint) {
    watched->removeEventFilter(this);
    QMetaObject::invokeMethod(
        this, [] { sayTime("window on the screen"); }, Qt::QueuedConnection);
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace asperity
