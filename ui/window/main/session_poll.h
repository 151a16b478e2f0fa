// Takes what the runner of a session has made: often while something moves, rarely while the window
// is idle or hidden, so that it then takes almost no processor time. A hidden window pauses the
// moving picture; curves are still computed. GUI thread; owned by the window. Cannot fail.
#pragma once

#include <QObject>

class QTimer;
class QWidget;

namespace asperity {

class Session;
class WindowPages;
class WindowVisibility;

class SessionPoll : public QObject {
 public:
  /// pages: of the window, whose views show the session. Session::begin() follows.
  SessionPoll(Session& session, const WindowPages& pages, QWidget& window);

 private:
  void update();

  Session& session_;
  const WindowPages& pages_;
  WindowVisibility* visibility_;
  QTimer* timer_;
};

}  // namespace asperity
