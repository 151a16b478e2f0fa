// What a person does with the chart: pointer, wheel and keys.
#include <gtest/gtest.h>

#include <QFontMetricsF>
#include <QGraphicsScene>
#include <QGraphicsView>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>
#include <cmath>
#include <memory>

#include "core/chart/curve_diagram.h"

#include "tests/ui/window/qt_application.h"
#include "ui/chart/chart_geometry.h"
#include "ui/chart/chart_legend.h"
#include "ui/chart/chart_marker.h"
#include "ui/chart/chart_view.h"

namespace asperity {
namespace {

DiagramSheet gestureSheet() {
  Diagram diagram;
  diagram.x = {"x", "", AxisScale::Logarithmic, 1e-3, 1e3};
  diagram.y = {"y", "", AxisScale::Logarithmic, 1e-4, 1};
  DiagramSeries points;
  points.name = "points";
  points.mark = SeriesMark::Circle;
  points.stroke = SeriesStroke::None;
  points.colour = 0;
  points.id = kPresentCurve;
  for (int i = 0; i < 5; ++i)
    points.points.push_back({std::pow(10, i - 2), 0.02, 0.019, 0.021, 10 + i});
  DiagramSeries pinned = points;
  pinned.name = "G = 20 MPa";
  pinned.id = 7;
  pinned.colour = 2;
  for (DiagramPoint& point : pinned.points) point.y = 0.002;
  diagram.series = {pinned, points};
  diagram.marker = DiagramMarker{"now", "v = 3 m/s", 3, 0.05};
  diagram.spans = {{1e-3, 1e3, "III plateau", "III", {"told of III"}}};
  DiagramSheet sheet;
  sheet.diagrams = {diagram};
  return sheet;
}

class ChartGestures : public testing::Test {
 protected:
  ChartGestures() : view_(std::make_unique<ChartView>()) {
    view_->resize(800, 400);
    view_->setSheet(gestureSheet());
    view_->setDescribe([](int id, int row) { return QString("%1:%2").arg(id).arg(row); });
    view_->show();
    QTest::qWait(1);  // the layout is made with the first events
  }

  QPoint at(double x, double y) const { return view_->mapToPosition(x, y).toPoint(); }
  void drag(QPoint from, QPoint to) {
    QTest::mousePress(view_.get(), Qt::LeftButton, {}, from);
    for (int i = 1; i <= 8; ++i) QTest::mouseMove(view_.get(), from + (to - from) * i / 8);
    QTest::mouseRelease(view_.get(), Qt::LeftButton, {}, to);
  }
  double pixelsPerDecade() const {
    return view_->mapToPosition(10, 0.1).x() - view_->mapToPosition(1, 0.1).x();
  }
  void turnWheel(QPoint place, int delta) {
    QWheelEvent event(place, view_->mapToGlobal(place), {}, {0, delta}, Qt::NoButton, {},
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(view_.get(), &event);
  }

  std::unique_ptr<ChartView> view_;
};

TEST_F(ChartGestures, DraggingTheMarkerTellsEveryPlaceWithoutSnapping) {
  QSignalSpy moved(view_.get(), &ChartView::markerMoved);
  const QPoint from = at(3, 0.3), to = at(0.047, 0.3);
  drag(from, to);
  ASSERT_GE(moved.count(), 7);
  for (int i = 1; i < moved.count(); ++i)
    EXPECT_LT(moved[i][0].toDouble(), moved[i - 1][0].toDouble());
  EXPECT_NEAR(moved.last()[0].toDouble() / 0.047, 1, 0.02) << "a pixel";
  EXPECT_FALSE(view_->isZoomed()) << "the view stays";
}

TEST_F(ChartGestures, AMarkerIsHeldWhereItIsGripped) {
  QSignalSpy moved(view_.get(), &ChartView::markerMoved);
  drag(at(3, 0.3) + QPoint(4, 0), at(0.1, 0.3) + QPoint(4, 0));
  EXPECT_NEAR(moved.last()[0].toDouble() / 0.1, 1, 0.02);
}

TEST_F(ChartGestures, AMarkerStaysInsideTheAxes) {
  QSignalSpy moved(view_.get(), &ChartView::markerMoved);
  drag(at(3, 0.3), QPoint(-200, at(3, 0.3).y()));
  EXPECT_NEAR(moved.last()[0].toDouble() / 1e-3, 1, 1e-9);
}

/// With Shift the marker goes a tenth of the pointer's way, from where it is.
TEST_F(ChartGestures, ShiftDragsFinely) {
  QSignalSpy moved(view_.get(), &ChartView::markerMoved);
  const QPoint from = at(3, 0.3), coarse = from - QPoint(50, 0), fine = coarse - QPoint(50, 0);
  QTest::mousePress(view_.get(), Qt::LeftButton, {}, from);
  QTest::mouseMove(view_.get(), coarse);
  EXPECT_FALSE(moved.last()[1].toBool());
  const double there = std::log10(moved.last()[0].toDouble());
  EXPECT_NEAR(there, std::log10(3) - 50 / pixelsPerDecade(), 0.01);
  const auto moveFinely = [&](QPoint to) {
    QMouseEvent event(QEvent::MouseMove, to, view_->mapToGlobal(to), Qt::NoButton, Qt::LeftButton,
                      Qt::ShiftModifier);
    QCoreApplication::sendEvent(view_.get(), &event);
  };
  moveFinely(coarse);  // the key goes down: nothing jumps
  EXPECT_TRUE(moved.last()[1].toBool());
  EXPECT_NEAR(std::log10(moved.last()[0].toDouble()), there, 1e-9);
  moveFinely(fine);
  EXPECT_NEAR(std::log10(moved.last()[0].toDouble()), there - 5 / pixelsPerDecade(), 1e-9);
  QTest::mouseRelease(view_.get(), Qt::LeftButton, {}, fine);
}

/// An axis that follows the marker would run away from under the pointer.
TEST_F(ChartGestures, TheAxisStandsStillWhileTheMarkerIsDragged) {
  const QPoint from = at(3, 0.3);
  QTest::mousePress(view_.get(), Qt::LeftButton, {}, from);
  QTest::mouseMove(view_.get(), from - QPoint(60, 0));
  DiagramSheet sheet = gestureSheet();
  Diagram& diagram = sheet.diagrams[0];
  diagram.x.to = 10;
  view_->setSheet(sheet);
  EXPECT_EQ(view_->visibleRange().x, (AxisRange{-3, 3}));
  QTest::mouseRelease(view_.get(), Qt::LeftButton, {}, from - QPoint(60, 0));
  EXPECT_EQ(view_->visibleRange().x, (AxisRange{-3, 1}));
}

TEST_F(ChartGestures, AMotionsMarkerIsNotDragged) {
  DiagramSheet sheet = gestureSheet();
  Diagram& diagram = sheet.diagrams[0];
  diagram.marker->isFixed = true;
  diagram.marker->trace = {{0.01, 0.01}, {1, 0.1}, {3, 0.05}};
  view_->setSheet(sheet);
  QSignalSpy moved(view_.get(), &ChartView::markerMoved);
  drag(at(3, 0.3), at(0.1, 0.3));
  view_->setFocus();
  QTest::keyClick(view_.get(), Qt::Key_Right);
  EXPECT_EQ(moved.count(), 0);
  // Its trace is drawn: the pixels in the middle of a stretch have the marker's vermilion.
  view_->setTheme(printTheme());
  view_->fit();
  const QImage image = view_->grab().toImage();
  const QPoint middle = at(0.1, std::sqrt(0.01 * 0.1));
  bool drawn = false;
  for (int dy = -2; dy <= 2; ++dy) {
    const QColor pixel = image.pixelColor(middle + QPoint(0, dy));
    drawn = drawn || (pixel.red() > 180 && pixel.green() < 150 && pixel.blue() < 110);
  }
  EXPECT_TRUE(drawn);
}

TEST_F(ChartGestures, ThePointerShowsWhatCanBeDone) {
  QTest::mouseMove(view_.get(), at(3, 0.3));
  EXPECT_EQ(view_->cursor().shape(), Qt::SizeHorCursor);
  QTest::mouseMove(view_.get(), at(0.01, 0.02));
  EXPECT_EQ(view_->cursor().shape(), Qt::PointingHandCursor);
  QTest::mouseMove(view_.get(), at(0.03, 0.3));
  EXPECT_EQ(view_->cursor().shape(), Qt::ArrowCursor);
}

TEST_F(ChartGestures, HoveringReadsPointsAndRegions) {
  QTest::mouseMove(view_.get(), at(0.1, 0.02));
  EXPECT_EQ(view_->reading(), "0:11");
  QTest::mouseMove(view_.get(), at(0.1, 0.002));
  EXPECT_EQ(view_->reading(), "7:11");
  QTest::mouseMove(view_.get(), at(0.03, 1) - QPoint(0, 9));
  EXPECT_EQ(view_->reading(), QStringLiteral("III plateau\nμ ≈ √2 ∇z_cont\ntold of III"));
  QTest::mouseMove(view_.get(), at(0.03, 0.3));
  EXPECT_EQ(view_->reading(), "");
}

/// What is read next stays in sight: the other points of a curve, and the names of other regions.
TEST_F(ChartGestures, AReadingDoesNotCoverItsNeighbours) {
  view_->setDescribe([](int, int) {
    return QString(
        "a reading with the values\nof a point in several lines,\nwider than two decades");
  });
  const auto& charts = *view_->findChild<QGraphicsView*>();
  const auto tip = [&] {
    for (const QGraphicsItem* item : charts.scene()->items())
      if (const auto* found = dynamic_cast<const TipItem*>(item)) return found->boundingRect();
    return QRectF();
  };
  const auto inCharts = [&](QPoint place) { return QPointF(charts.mapFrom(view_.get(), place)); };
  for (int i = 0; i < 5; ++i) {
    QTest::mouseMove(view_.get(), at(std::pow(10, i - 2), 0.02));
    ASSERT_FALSE(tip().isEmpty());
    EXPECT_GT(tip().width(), 1.2 * pixelsPerDecade());
    for (int k = 0; k < 5; ++k)
      EXPECT_FALSE(k != i && tip().contains(inCharts(at(std::pow(10, k - 2), 0.02)))) << i << k;
  }
  QTest::mouseMove(view_.get(), at(0.03, 1) - QPoint(0, 9));
  ASSERT_FALSE(view_->reading().isEmpty());
  EXPECT_GT(tip().top(), inCharts(at(0.03, 1)).y() - 3);
}

TEST_F(ChartGestures, AReadingOutlivesARefinementAndFollowsIt) {
  QTest::mouseMove(view_.get(), at(0.1, 0.02));
  DiagramSheet sheet = gestureSheet();
  Diagram& diagram = sheet.diagrams[0];
  diagram.series[1].points[1].row = 33;
  view_->setSheet(sheet);
  EXPECT_EQ(view_->reading(), "0:33");
  diagram.series[1].points[1].y = 0.9;
  view_->setSheet(sheet);
  EXPECT_EQ(view_->reading(), "");
}

TEST_F(ChartGestures, AClickTakesThePointUnderIt) {
  QSignalSpy chosen(view_.get(), &ChartView::pointChosen);
  QSignalSpy moved(view_.get(), &ChartView::markerMoved);
  QTest::mouseClick(view_.get(), Qt::LeftButton, {}, at(10, 0.002) + QPoint(3, 2));
  ASSERT_EQ(chosen.count(), 1);
  EXPECT_EQ(chosen[0][0].toInt(), 7);
  EXPECT_EQ(chosen[0][1].toInt(), 13);
  QTest::mouseClick(view_.get(), Qt::LeftButton, {}, at(0.03, 0.3));
  EXPECT_EQ(chosen.count(), 1);
  EXPECT_EQ(moved.count(), 0);
}

/// Another curve may arrive while the button is down.
TEST_F(ChartGestures, AClickTakesThePointThatWasPressed) {
  const QSignalSpy chosen(view_.get(), &ChartView::pointChosen);
  const QPoint place = at(10, 0.02);
  QTest::mousePress(view_.get(), Qt::LeftButton, {}, place);
  DiagramSheet sheet = gestureSheet();
  sheet.diagrams[0].series.pop_back();
  sheet.diagrams[0].series[0].points.resize(1);
  view_->setSheet(sheet);
  QTest::mouseRelease(view_.get(), Qt::LeftButton, {}, place);
  ASSERT_EQ(chosen.count(), 1);
  EXPECT_EQ(chosen[0][0].toInt(), kPresentCurve);
  EXPECT_EQ(chosen[0][1].toInt(), 13);
}

TEST_F(ChartGestures, APointUnderTheMarkerCanBeTakenToo) {
  DiagramSheet sheet = gestureSheet();
  Diagram& diagram = sheet.diagrams[0];
  diagram.marker->x = 1;
  view_->setSheet(sheet);
  QSignalSpy chosen(view_.get(), &ChartView::pointChosen);
  QTest::mouseClick(view_.get(), Qt::LeftButton, {}, at(1, 0.02));
  EXPECT_EQ(chosen.count(), 1);
}

TEST_F(ChartGestures, ArrowKeysMoveTheMarker) {
  view_->setFocus();
  QSignalSpy moved(view_.get(), &ChartView::markerMoved);
  QTest::keyClick(view_.get(), Qt::Key_Right);
  QTest::keyClick(view_.get(), Qt::Key_Right);
  ASSERT_EQ(moved.count(), 2);
  EXPECT_NEAR(moved[1][0].toDouble() / (3 * std::pow(10, 0.1)), 1, 1e-9)
      << "also before the first one has arrived";
  QTest::keyClick(view_.get(), Qt::Key_Left, Qt::ShiftModifier);
  EXPECT_NEAR(moved[2][0].toDouble() / (3 * std::pow(10, 0.095)), 1, 1e-9);
}

TEST_F(ChartGestures, WithControlArrowKeysGoFromPointToPoint) {
  QSignalSpy chosen(view_.get(), &ChartView::pointChosen);
  QTest::keyClick(view_.get(), Qt::Key_Right, Qt::ControlModifier);
  QTest::keyClick(view_.get(), Qt::Key_Right, Qt::ControlModifier);
  QTest::keyClick(view_.get(), Qt::Key_Left, Qt::ControlModifier);
  ASSERT_EQ(chosen.count(), 3);
  EXPECT_EQ(chosen[0][1].toInt(), 13);
  EXPECT_EQ(chosen[1][1].toInt(), 14);
  EXPECT_EQ(chosen[2][1].toInt(), 13);
}

TEST_F(ChartGestures, TheWheelZoomsAboutThePointerAndADoubleClickFits) {
  QSignalSpy fitted(view_.get(), &ChartView::fitRequested);
  const QPointF before = view_->mapToPosition(0.1, 0.02);
  turnWheel(before.toPoint(), 240);
  EXPECT_TRUE(view_->isZoomed());
  EXPECT_LT((view_->mapToPosition(0.1, 0.02) - before).manhattanLength(), 2);
  EXPECT_GT(view_->mapToPosition(1, 0.02).x() - view_->mapToPosition(0.1, 0.02).x(), 150);
  QTest::mouseDClick(view_.get(), Qt::LeftButton, {}, at(0.4, 0.1));
  EXPECT_FALSE(view_->isZoomed());
  EXPECT_EQ(fitted.count(), 1);
}

class NamesOfShades : public ChartGestures {
 protected:
  void show(std::vector<DiagramPoint> points) {
    DiagramSheet sheet = gestureSheet();
    Diagram& diagram = sheet.diagrams[0];
    diagram.marker.reset();
    diagram.spans.clear();
    diagram.shades = {{1, 1e3, "few contacts carry the load"}};
    diagram.series = {DiagramSeries{.points = std::move(points)}};
    view_->setSheet(sheet);
    QTest::qWait(1);
  }
  bool isNameAt(double y, int down) {
    QTest::mouseMove(view_.get(), at(std::sqrt(1e3), y) + QPoint(0, down));
    return view_->reading().contains("single summits");
  }
};

/// A curve through the foot of a shade would go through its name there.
TEST_F(NamesOfShades, KeepAwayFromCurves) {
  for (const double height : {1.2e-4, 0.8}) {
    show({{1e-2, height}, {1e3, height}});
    EXPECT_EQ(isNameAt(1, 10), height < 0.01);
    EXPECT_EQ(isNameAt(1e-4, -10), height > 0.01);
  }
}

/// Between curves in the middle and the edge of the shade there is a place, in more lines.
TEST_F(NamesOfShades, StandAsideOfCurves) {
  std::vector<DiagramPoint> zigzag;
  for (int i = 0; i <= 60; ++i)
    zigzag.push_back({std::pow(10, 1.6 + 0.02 * i), i % 2 == 0 ? 1e-4 : 1});
  show(zigzag);
  bool isThere = false;
  for (int down = 2; down < (at(1, 1e-4) - at(1, 1)).y(); down += 4) {
    QTest::mouseMove(view_.get(), at(6, 1) + QPoint(0, down));
    isThere |= view_->reading().contains("single summits");
  }
  EXPECT_TRUE(isThere);
}

/// Curves that are everywhere leave no room: a name over them would hide them.
TEST_F(NamesOfShades, AreLeftOutWhereCurvesAreEverywhere) {
  const auto isAnywhere = [&] {
    bool isThere = false;
    for (int down = 2; down < (at(1, 1e-4) - at(1, 1)).y(); down += 4)
      for (const double x : {3.0, 30.0, 300.0}) {
        QTest::mouseMove(view_.get(), at(x, 1) + QPoint(0, down));
        isThere |= view_->reading().contains("single summits");
      }
    return isThere;
  };
  show({{1e-2, 0.8}, {1e3, 0.8}});
  EXPECT_TRUE(isAnywhere());
  std::vector<DiagramPoint> zigzag;
  for (int i = 0; i <= 60; ++i) zigzag.push_back({std::pow(10, 0.05 * i), i % 2 == 0 ? 1e-4 : 1});
  show(zigzag);
  EXPECT_FALSE(isAnywhere());
}

TEST_F(ChartGestures, DraggingBesideTheMarkerPans) {
  QSignalSpy moved(view_.get(), &ChartView::markerMoved);
  const QPoint from = at(0.03, 0.3), by(60, 25);
  const QPointF before = view_->mapToPosition(0.1, 0.02);
  drag(from, from + by);
  EXPECT_EQ(moved.count(), 0);
  EXPECT_LT((view_->mapToPosition(0.1, 0.02) - before - by).manhattanLength(), 2);
}

/// However far and often it is dragged, at any zoom.
TEST_F(ChartGestures, PanningNeverEndsInEmptiness) {
  for (const double factor : {1.5, 1.0, 0.5, 0.1})
    for (const QPoint way :
         {QPoint(700, 0), {-700, 0}, {0, 350}, {0, -350}, {500, 300}, {-500, 300}}) {
      view_->fit();
      if (factor != 1)
        view_->setZoom(
            VisibleRange{{-3 * factor, 3 * factor}, {-2.7 - 2 * factor, -2.7 + 2 * factor}});
      for (int i = 0; i < 6; ++i) {
        const QPoint from = view_->rect().center() + QPoint(60, 20);
        drag(from, from + way);
      }
      EXPECT_TRUE(showsCurves(view_->visibleRange(), view_->sheet().diagrams[0]))
          << factor << ' ' << way.x() << ' ' << way.y();
    }
}

TEST_F(ChartGestures, AZoomedViewGoesWithTheRangesOfAnotherCurve) {
  view_->setZoom(VisibleRange{{-3, -2}, {-4, -3}});
  DiagramSheet sheet = gestureSheet();
  Diagram& diagram = sheet.diagrams[0];
  diagram.x.from = 1e5;
  diagram.x.to = 1e9;
  view_->setSheet(sheet);
  EXPECT_NEAR(view_->visibleRange().x.from, 4.5, 1e-9);
}

TEST_F(ChartGestures, AZoomedViewStaysWhileTheCurveIsRefined) {
  view_->zoom(0.5);
  const VisibleRange window = view_->visibleRange();
  DiagramSheet sheet = gestureSheet();
  Diagram& diagram = sheet.diagrams[0];
  diagram.y.from = 1e-5;
  view_->setSheet(sheet);
  EXPECT_EQ(view_->visibleRange(), window);
  QTest::keyClick(view_.get(), Qt::Key_Home);
  EXPECT_EQ(view_->visibleRange().y, (AxisRange{-5, 0}));
}

TEST_F(ChartGestures, ClickingItsEntryUnpinsACurve) {
  QSignalSpy unpin(view_.get(), &ChartView::unpinRequested);
  auto* legend = view_->findChild<ChartLegend*>("chartLegend");
  ASSERT_TRUE(legend);
  ASSERT_FALSE(legend->entryRect(7).isEmpty());
  QTest::mouseClick(legend, Qt::LeftButton, {},
                    legend->entryRect(kPresentCurve).center().toPoint());
  EXPECT_EQ(unpin.count(), 0);
  QTest::mouseClick(legend, Qt::LeftButton, {}, legend->entryRect(7).center().toPoint());
  ASSERT_EQ(unpin.count(), 1);
  EXPECT_EQ(unpin[0][0].toInt(), 7);
}

TEST_F(ChartGestures, TheLegendTakesMoreRowsAndCountsWhatHasNoRoom) {
  auto* legend = view_->findChild<ChartLegend*>("chartLegend");
  const int one = legend->height();
  DiagramSheet sheet = gestureSheet();
  Diagram& diagram = sheet.diagrams[0];
  for (int id = 10; id < 40; ++id) {
    diagram.series.push_back(diagram.series[0]);
    diagram.series.back().id = id;
  }
  view_->setSheet(sheet);
  QTest::qWait(1);
  EXPECT_GT(legend->height(), one);
  EXPECT_LT(legend->height(), 4 * one);
  EXPECT_FALSE(legend->entryRect(10).isEmpty());
  EXPECT_TRUE(legend->entryRect(39).isEmpty());
}

/// Rows that come and go with pinned curves leave room for the axis' labels and title below.
TEST_F(ChartGestures, TheChartGivesTheLegendItsRoomAtOnce) {
  DiagramSheet sheet = gestureSheet();
  Diagram& diagram = sheet.diagrams[0];
  for (int id = 10; id < 20; ++id) {
    diagram.series.push_back(diagram.series[0]);
    diagram.series.back().id = id;
  }
  const double line = QFontMetricsF(view_->font()).height();
  const auto bottom = [&] { return view_->mapToPosition(1, 1e-4).y(); };
  const double before = bottom();
  view_->setSheet(sheet);
  QTest::qWait(1);
  EXPECT_LE(bottom() + 2 * line, view_->height());
  view_->setSheet(gestureSheet());
  QTest::qWait(1);
  EXPECT_NEAR(bottom(), before, 1);
}

/// A name that says in much what a curve differs is broken into lines; its tooltip has all of it.
TEST_F(ChartGestures, LongNamesAreBrokenAndWholeInTheirTooltip) {
  DiagramSheet sheet = gestureSheet();
  Diagram& diagram = sheet.diagrams[0];
  QStringList parts;
  for (int i = 0; i < 14; ++i) parts += QStringLiteral("parameter %1 = %2 MPa").arg(i).arg(10 * i);
  diagram.series[0].name = parts.mid(0, 6).join(", ").toStdString();
  view_->setSheet(sheet);
  auto* legend = view_->findChild<ChartLegend*>();
  ASSERT_TRUE(legend);
  EXPECT_GE(legend->entryLines(7).size(), 2);
  EXPECT_EQ(legend->entryLines(7).join(' ').toStdString(),
            diagram.series[0].name.text);  // nothing is lost
  const QFontMetricsF metrics(legend->font());
  for (const QString& line : legend->entryLines(7))
    EXPECT_LE(metrics.horizontalAdvance(line), legend->width());
  diagram.series[0].name = parts.join(", ").toStdString();
  view_->setSheet(sheet);
  EXPECT_NE(legend->entryLines(7).join(' ').toStdString(), diagram.series[0].name.text);
  QTest::mouseMove(legend, legend->entryRect(7).center().toPoint());
  EXPECT_TRUE(legend->toolTip().contains(QString::fromStdString(diagram.series[0].name.text)));
}

/// Lists have semicolons in a language with decimal commas.
TEST_F(ChartGestures, LongNamesAreBrokenAndShortenedAtSemicolonsToo) {
  DiagramSheet sheet = gestureSheet();
  Diagram& diagram = sheet.diagrams[0];
  QStringList parts;
  for (int i = 0; i < 5; ++i) parts += QStringLiteral("Parameter %1 = %2,5 MPa").arg(i).arg(10 * i);
  diagram.series[0].name = parts.join("; ").toStdString();
  view_->setSheet(sheet);
  auto* legend = view_->findChild<ChartLegend*>();
  ASSERT_EQ(legend->entryLines(7).size(), 2);
  EXPECT_TRUE(legend->entryLines(7)[0].endsWith(u';'));
  EXPECT_EQ(legend->entryLines(7).join(' ').toStdString(), diagram.series[0].name.text);
  diagram.series[0].id = kPresentCurve;
  diagram.series[0].name = "kubisch x8; 200 Linien minus die Kurve darüber; mit allen Theorien";
  for (int i = 0; i < 2; ++i) diagram.series.push_back(diagram.series[0]);
  view_->setSheet(sheet);
  view_->resize(500, 220);
  EXPECT_TRUE(QTest::qWaitFor([&] {
    const QString name = legend->entryLines(kPresentCurve).join(' ');
    return name == "kubisch x8" || name == "kubisch x8; 200 Linien minus die Kurve darüber";
  })) << legend->entryLines(kPresentCurve).join(' ').toStdString();
}

/// Names of curves that differ in much are cut before an entry is left out.
TEST_F(ChartGestures, LongNamesLeaveNoEntryOut) {
  DiagramSheet sheet = gestureSheet();
  Diagram& diagram = sheet.diagrams[0];
  QStringList parts;
  for (int i = 0; i < 14; ++i) parts += QStringLiteral("parameter %1 = %2 MPa").arg(i).arg(10 * i);
  for (int id = 10; id < 14; ++id) {
    diagram.series.push_back(diagram.series[0]);
    diagram.series.back().id = id;
    diagram.series.back().name = parts.join(", ").toStdString();
  }
  view_->setSheet(sheet);
  QTest::qWait(1);
  auto* legend = view_->findChild<ChartLegend*>();
  ASSERT_TRUE(legend);
  for (int id = 10; id < 14; ++id) {
    const QRectF place = legend->entryRect(id);
    ASSERT_FALSE(place.isEmpty()) << id;
    EXPECT_LE(place.right(), legend->width()) << id;
    EXPECT_LE(place.bottom(), legend->height()) << id;
  }
  QTest::mouseMove(legend, legend->entryRect(12).center().toPoint());
  EXPECT_TRUE(legend->toolTip().contains(parts.join(", ")));
}

/// In a low view the chart keeps most of the height: the legend has the first parts of long names,
/// and the whole ones in tooltips. A high view has the whole names.
TEST_F(ChartGestures, TheLegendOfALowChartHasShorterNames) {
  DiagramSheet sheet = gestureSheet();
  Diagram& diagram = sheet.diagrams[0];
  diagram.series[0].id = kPresentCurve;
  diagram.series[0].name = "mean of 200 lines ± standard error";
  for (const char* name :
       {"Gaussian foundation, low velocity", "half-space, long-range elasticity"}) {
    diagram.series.push_back(diagram.series[0]);
    diagram.series.back().id = kLawCurve;
    diagram.series.back().isTheory = true;
    diagram.series.back().name = name;
  }
  view_->setSheet(sheet);
  auto* legend = view_->findChild<ChartLegend*>();
  ASSERT_TRUE(legend);
  const auto linesAt = [&](int height) {
    view_->resize(420, height);
    QTest::qWait(1);
    return legend->entryLines(kPresentCurve).join(' ');
  };
  const QString whole = QString::fromStdString(diagram.series[0].name.text);
  EXPECT_EQ(linesAt(600), whole);
  EXPECT_EQ(linesAt(240), QStringLiteral("mean of 200 lines"));
  EXPECT_LT(legend->height(), 0.25 * view_->height());
  QTest::mouseMove(legend, legend->entryRect(kPresentCurve).center().toPoint());
  EXPECT_TRUE(legend->toolTip().contains(whole)) << legend->toolTip().toStdString();
  EXPECT_EQ(linesAt(600), whole);
}

/// The box of a reading stays in the view, also where a chart of a small window is low.
TEST_F(ChartGestures, ALongReadingIsWiderInALowChart) {
  const QString text =
      QStringList(16, QStringLiteral("few contacts carry the load here")).join(' ');
  const ChartStyle style;
  TipItem tip;
  const auto boxIn = [&](double height) {
    const QRectF view(0, 0, 2000, height);
    tip.show(text, view.center(), false, view, style, {});
    EXPECT_LE(tip.boundingRect().height(), height + 4);
    return tip.boundingRect();
  };
  const QRectF usual = boxIn(1000);
  EXPECT_LT(usual.width(), 400);
  EXPECT_GT(boxIn(usual.height() / 2).width(), 400);
}

}  // namespace
}  // namespace asperity
