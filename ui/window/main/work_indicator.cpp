#include "ui/window/main/work_indicator.h"

#include <QHBoxLayout>
#include <QProgressBar>
#include <QToolButton>

#include "ui/language/language.h"
#include "ui/panels/controls.h"
#include "ui/window/main/session.h"

namespace asperity {

namespace {

constexpr int kWorkBarWidth = 90;  // pixels of the progress bar
constexpr int kWorkSpacing = 4;    // pixels between the progress bar and its button

const QString kStopSign = QStringLiteral("✕"), kRestartSign = QStringLiteral("↻");

}  // namespace

Work presentWork(const Session& session) {
  Work work;
  // The last rate is that of another scene's curve.
  work.simulationsPerSecond = session.isRefused() ? 0 : session.simulationsPerSecond();
  work.progress = session.friction().progress();
  if (session.isWaiting())
    work.state = Work::State::Waiting;
  else if (session.averaging() == Session::Averaging::Running)
    work.state = Work::State::Running;
  else if (session.averaging() == Session::Averaging::Stopped && !session.isRefused())
    work.state = Work::State::Stopped;
  return work;
}

WorkIndicator::WorkIndicator(QWidget* parent)
    : QWidget(parent),
      progress_(thinProgress("workProgress", kWorkBarWidth)),
      button_(named<QToolButton>("workStop")) {
  button_->setAutoRaise(true);
  button_->setFocusPolicy(Qt::TabFocus);
  connect(button_, &QToolButton::clicked, this, &WorkIndicator::pressButton);
  QSize size;
  for (const QString& sign : {kStopSign, kRestartSign}) {
    button_->setText(sign);
    size = size.expandedTo(button_->sizeHint());
  }
  button_->setFixedSize(size);
  auto* row = marginless<QHBoxLayout>(this, kWorkSpacing);
  row->addWidget(progress_);
  row->addWidget(button_);
  keepTranslated(*this, [this] { showWork(work_); });
}

void WorkIndicator::pressButton() {
  if (work_.state == Work::State::Running) emit stopRequested();
  if (work_.state == Work::State::Stopped) emit restartRequested();
  if (work_.state == Work::State::Waiting) emit backRequested();
}

void WorkIndicator::showWork(const Work& work) {
  work_ = work;
  const bool isWaiting = work.state == Work::State::Waiting;
  const bool isStopped = work.state == Work::State::Stopped;
  if (isWaiting)
    progress_->setRange(0, 0);
  else
    showPart(*progress_, work.progress);
  progress_->setAccessibleName(isWaiting ? tr("making the line") : tr("progress of the curve"));
  button_->setText(isStopped ? kRestartSign : kStopSign);
  const QString text = isWaiting   ? tr("Making the line… Back to the previous scene")
                       : isStopped ? tr("The curve is not complete: average it again")
                                   : tr("Stop averaging the curve");
  button_->setToolTip(text);
  button_->setAccessibleName(text);
  setVisible(work.state != Work::State::Idle);
}

}  // namespace asperity
