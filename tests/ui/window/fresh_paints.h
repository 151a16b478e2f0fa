// Watches what is painted of the diagram after a slider has moved: when the first picture of the
// new curve is whole, and whether new and old are ever mixed. GUI thread.
#pragma once

#include <QElapsedTimer>
#include <QEvent>
#include <QEventLoop>
#include <QMetaObject>
#include <QTimer>
#include <QWidget>

#include "core/chart/curve_diagram.h"
#include "ui/chart/chart_view.h"
#include "ui/window/main/session.h"

namespace asperity {

class FreshPaints : public QObject {
 public:
  FreshPaints(Session& session, ChartView& view) : session_(session), view_(view) {
    for (QWidget* part : view.findChildren<QWidget*>()) part->installEventFilter(this);
  }

  /// Call it before the slider moves.
  void start() {
    isWhole_ = false;
    clock_.start();
  }

  /// In an event loop, as in the program: QTest's waiting sleeps between its looks. False where no
  /// such picture comes within 20 s.
  bool waitForPicture() {
    QTimer::singleShot(20000, &loop_, &QEventLoop::quit);
    if (!isWhole_) loop_.exec();
    return isWhole_;
  }

  int mixed = 0;            // pictures with curves of both
  double milliseconds = 0;  // from the start to the first whole picture

 protected:
  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() != QEvent::Paint) return false;
    const std::vector<DiagramSeries>& all = view_.sheet().diagrams[0].series;
    if (all.empty()) return false;
    const bool fades = all.back().isFaded;
    for (const DiagramSeries& series : all)
      if (series.id <= kPresentCurve && series.isFaded != fades) ++mixed;
    if (!session_.friction().isStale() && !fades && !isWhole_)
      // After this and all other painting of this turn.
      QMetaObject::invokeMethod(
          this, [this] { becomeWhole(); }, Qt::QueuedConnection);
    return false;
  }

 private:
  void becomeWhole() {
    if (isWhole_) return;
    milliseconds = 1e-6 * static_cast<double>(clock_.nsecsElapsed());
    isWhole_ = true;
    loop_.quit();
  }

  Session& session_;
  ChartView& view_;
  bool isWhole_ = true;
  QEventLoop loop_;
  QElapsedTimer clock_;
};

}  // namespace asperity
