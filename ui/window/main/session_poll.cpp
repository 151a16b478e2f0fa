#include "ui/window/main/session_poll.h"

#include <QTimer>
#include <QWidget>

#include "ui/window/main/session.h"
#include "ui/window/main/window_pages.h"
#include "ui/window/main/window_visibility.h"

namespace asperity {

namespace {

constexpr int kPollInterval = 16;  // ms, 60 times a second
constexpr int kIdlePoll = 100;     // ms, while the run is paused and nothing is computed
constexpr int kHiddenPoll = 250;   // ms, while the window is hidden

}  // namespace

SessionPoll::SessionPoll(Session& session, const WindowPages& pages, QWidget& window)
    : QObject(&window),
      session_(session),
      pages_(pages),
      visibility_(new WindowVisibility(window)),
      timer_(new QTimer(this)) {
  timer_->setTimerType(Qt::PreciseTimer);
  connect(timer_, &QTimer::timeout, this, [this] {
    session_.poll();
    update();
  });
  connect(&session_, &Session::commandSent, this, &SessionPoll::update);
  connect(visibility_, &WindowVisibility::changed, this, &SessionPoll::update);
  connect(&pages_, &WindowPages::pageChanged, this, &SessionPoll::update);
  timer_->start(kPollInterval);
}

void SessionPoll::update() {
  const bool isVisible = visibility_->isVisible();
  const int interval = !isVisible ? kHiddenPoll : session_.isIdle() ? kIdlePoll : kPollInterval;
  if (timer_->interval() != interval) timer_->setInterval(interval);
  const bool areViewsVisible = isVisible && pages_.isShowingViews();
  if (session_.isVisible() != areViewsVisible) session_.setVisible(areViewsVisible);
}

}  // namespace asperity
