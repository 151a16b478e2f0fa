// Diagrams made in the background for the window's tabs.
#include "ui/window/figures/diagram_view.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTabWidget>
#include <QTest>
#include <atomic>
#include <stdexcept>

#include "core/run/line_diagrams.h"
#include "tests/ui/window/qt_application.h"
#include "ui/window/main/main_window.h"
#include "ui/window/main/session.h"
#include "ui/window/map/map_view.h"

namespace asperity {
namespace {

constexpr int kWait = 20000;  // ms, at most

TEST(DiagramView, MakesNothingUntilItIsSeen) {
  DiagramView view;
  view.resize(600, 300);
  std::atomic<int> made = 0;
  view.show([&made] {
    ++made;
    return spectrumSheet({});
  });
  EXPECT_EQ(made, 0);
  QSignalSpy seen(&view, &DiagramView::visibilityChanged);
  view.QWidget::show();
  EXPECT_EQ(seen.count(), 1);
  ASSERT_TRUE(QTest::qWaitFor([&] { return view.isPainted(); }, kWait));
  EXPECT_GE(made, 1);
  EXPECT_EQ(view.image().size(), view.size());
}

TEST(DiagramView, HasTextsAsLargeAsTheWindows) {
  const auto dark = [](const QImage& image) {
    int pixels = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) pixels += qGray(image.pixel(x, y)) < 100 ? 1 : 0;
    return pixels;
  };
  DiagramView view;
  view.resize(900, 500);
  view.show([] {
    DiagramSheet sheet;
    sheet.title = "a long title of the sheet";
    return sheet;
  });
  view.QWidget::show();
  ASSERT_TRUE(QTest::qWaitFor([&] { return view.isPainted(); }, kWait));
  const int usual = dark(view.image());
  QFont large = view.font();
  large.setPointSizeF(3 * large.pointSizeF());
  view.setFont(large);
  ASSERT_TRUE(QTest::qWaitFor([&] { return view.isPainted(); }, kWait));
  EXPECT_GT(dark(view.image()), 4 * usual);
}

TEST(DiagramView, ShowsTheNewestOfManyWishes) {
  DiagramView view;
  view.resize(500, 260);
  view.QWidget::show();
  std::atomic<int> last = -1, made = 0;
  for (int i = 0; i < 50; ++i)
    view.show([&, i] {
      ++made;
      last = i;
      return spectrumSheet({});
    });
  ASSERT_TRUE(QTest::qWaitFor([&] { return view.isPainted() && last == 49; }, kWait));
  EXPECT_LT(made, 10);
}

TEST(DiagramView, SaysWhatCannotBeMade) {
  DiagramView view;
  view.resize(500, 260);
  view.QWidget::show();
  view.show([]() -> DiagramSheet { throw std::runtime_error("no such profile"); });
  ASSERT_TRUE(QTest::qWaitFor([&] { return view.isPainted(); }, kWait));
  const QImage complaint = view.image();
  view.show([] { return spectrumSheet({}); });  // and goes on
  ASSERT_TRUE(QTest::qWaitFor([&] { return view.isPainted(); }, kWait));
  EXPECT_NE(complaint, view.image());
}

TEST(DiagramView, APictureThatCannotBeDrawnDoesNotLeaveTheOneBefore) {
  DiagramView view;
  view.setPause(0);
  view.resize(500, 260);
  view.QWidget::show();
  view.show([] { return spectrumSheet({}); });
  ASSERT_TRUE(QTest::qWaitFor([&] { return view.isPainted(); }, kWait));
  QSignalSpy failures(&view, &DiagramView::failed);
  view.showPicture([](const DiagramOptions&) -> DrawList { throw std::runtime_error("no room"); });
  ASSERT_TRUE(QTest::qWaitFor([&] { return !failures.empty(); }, kWait));
  EXPECT_FALSE(view.isPainted());
  EXPECT_TRUE(view.image().isNull());
  EXPECT_TRUE(view.frames().empty());
}

TEST(DiagramView, TakesTheFocusWhereItCanBeSaved) {
  DiagramView view;
  view.show([] { return spectrumSheet({}); });
  EXPECT_EQ(view.focusPolicy(), Qt::NoFocus);
  view.show([] { return spectrumSheet({}); }, {"spectrum", {}, {}, {}});
  EXPECT_EQ(view.focusPolicy(), Qt::StrongFocus);
}

/// Side by side there is room for symbols alone. They stand in the legend beside the colour of
/// their curve, however the curves run.
TEST(DiagramView, SymbolsOfLowDiagramsStandInTheLegend) {
  DiagramSheet sheet;
  sheet.columns = 1;
  for (int i = 0; i < 3; ++i) {
    Diagram diagram;
    diagram.x = {"frequency f", "Hz"};
    diagram.y = {"moduli G\u2032, G\u2033", "Pa"};
    for (const char* name : {"storage modulus G\u2032", "loss modulus G\u2033"}) {
      DiagramSeries series;
      series.name = name;
      series.points = {{1, 1e6}, {1e3, 1e7}};
      diagram.series.push_back(series);
    }
    sheet.diagrams.push_back(diagram);
  }
  const DiagramSheet shown = readableSheet(sheet, {900, 230, 1, lightTheme(), 0.85F});
  ASSERT_EQ(shown.columns, 3);
  for (const Diagram& diagram : shown.diagrams) {
    EXPECT_TRUE(diagram.labels.empty());
    ASSERT_EQ(diagram.series.size(), 2);
    EXPECT_EQ(diagram.series[0].name.text, "G\u2032");
    EXPECT_EQ(diagram.series[1].name.text, "G\u2033");
  }
}

TEST(MapView, ArrowKeysMoveTheCross) {
  MapView view;
  view.resize(500, 300);
  view.QWidget::show();
  view.show([] {
    Diagram diagram;
    diagram.x = {"x", "", AxisScale::Linear, 0, 10};
    diagram.y = {"y", "", AxisScale::Linear, 0, 10};
    DiagramSheet sheet;
    sheet.diagrams = {diagram};
    return sheet;
  });
  ASSERT_TRUE(QTest::qWaitFor([&] { return view.isPainted(); }, kWait));
  view.setCross(5, 5);
  QSignalSpy moves(&view, &MapView::crossMoved);
  QTest::keyClick(&view, Qt::Key_Right);
  QTest::keyClick(&view, Qt::Key_Up);
  QTest::keyClick(&view, Qt::Key_Left, Qt::ShiftModifier);
  ASSERT_EQ(moves.count(), 3);
  EXPECT_NEAR(moves[0][0].toDouble(), 5.2, 1e-3);
  EXPECT_NEAR(moves[0][1].toDouble(), 5, 1e-3);
  EXPECT_NEAR(moves[1][1].toDouble(), 5.2, 1e-3);
  EXPECT_NEAR(moves[2][0].toDouble(), 5.16, 1e-3);
}

TEST(DiagramView, TabsShowSpectrumAndStatisticsOfTheScene) {
  Scene scene;
  scene.surface.elements = 300;
  scene.ensemble.realizations = 2;
  MainWindow window(scene);
  window.show();
  auto* tabs = window.findChild<QTabWidget*>("tabs");
  for (const char* name : {"spectrumView", "statisticsView"}) {
    auto* view = window.findChild<DiagramView*>(name);
    ASSERT_TRUE(view);
    tabs->setCurrentWidget(view);
    EXPECT_TRUE(QTest::qWaitFor([&] { return view->image().width() > 0; }, kWait)) << name;
  }
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        const auto frame = window.session().frame();
        return frame && !frame->lineSlope.empty();
      },
      kWait));
  tabs->setCurrentIndex(0);  // slopes are no longer wanted
  EXPECT_TRUE(QTest::qWaitFor([&] { return window.session().frame()->lineSlope.empty(); }, kWait));
}

}  // namespace
}  // namespace asperity
