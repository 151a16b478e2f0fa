// The main window with its friction curve, whose points and marker are dragged and clicked. For
// tests on the GUI thread.
#pragma once

#include <QTest>
#include <cmath>

#include "tests/ui/window/main_window_fixture.h"

namespace asperity {

class CurveTest : public MainWindowTest {
 protected:
  bool waitForCurve() {
    return waitFor([this] {
      return !session().friction().isStale() && session().friction().progress() >= 1 &&
             !chart().series.empty() && !chart().series.back().isFaded &&
             chart().marker.has_value();
    });
  }
  ChartView& plot() { return window_.plotView(); }
  double velocity() { return session().scene().sliding.velocity; }
  QPoint at(double x, double y) { return plot().mapToPosition(x, y).toPoint(); }
  double middle() {
    return std::pow(10, 0.5 * (plot().visibleRange().y.from + plot().visibleRange().y.to));
  }
  void drag(QPoint from, QPoint to) {
    QTest::mousePress(&plot(), Qt::LeftButton, {}, from);
    for (int i = 1; i <= 6; ++i) QTest::mouseMove(&plot(), from + (to - from) * i / 6);
    QTest::mouseRelease(&plot(), Qt::LeftButton, {}, to);
  }
};

}  // namespace asperity
