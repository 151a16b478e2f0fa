// What the plot's widget paints, read back from its pixels.
#include <gtest/gtest.h>

#include <QImage>
#include <QTest>
#include <cmath>
#include <memory>

#include "tests/ui/window/qt_application.h"
#include "ui/chart/plot_view.h"

namespace asperity {
namespace {

const PlotColours kColours{.background = Qt::white,
                           .text = Qt::black,
                           .faintText = Qt::darkGray,
                           .axis = Qt::black,
                           .grid = QColor(0xdd, 0xdd, 0xdd),
                           .fineGrid = QColor(0xf0, 0xf0, 0xf0),
                           .points = QColor(0, 0, 0xff),
                           .line = QColor(0, 0x90, 0),
                           .marker = QColor(0xff, 0, 0),
                           .span = QColor(0xee, 0xee, 0xee),
                           .shade = QColor(0xff, 0xee, 0xcc, 0x80),
                           .difference = QColor(0x80, 0, 0x80),
                           .pinned = {QColor(0, 0xcc, 0xcc), QColor(0xcc, 0, 0xcc), Qt::cyan,
                                      Qt::cyan, Qt::cyan, Qt::cyan}};

Plot samplePlot() {
  Plot plot;
  plot.x = {QStringLiteral("x"), {}, {-3, 3}};
  plot.y = {QStringLiteral("y"), {}, {-4, 0}};
  plot.series = {{QStringLiteral("law"), PlotStyle::Line, false, {{1e-3, 1e-3}, {1e3, 1e-3}}},
                 {QStringLiteral("points"),
                  PlotStyle::Points,
                  false,
                  {{0.03, 0.02, 0.015}, {0.3, -1, 0.1}, {30, 0.1, std::nan("")}}}};
  plot.marker = PlotMarker{QStringLiteral("now"), QStringLiteral("v"), 2, 0.05};
  return plot;
}

class PlotViewTest : public testing::Test {
 protected:
  PlotViewTest() : view_(makePlotView()) {
    view_->resize(800, 400);
    view_->setColours(kColours);
    view_->setPlot(samplePlot());
    view_->show();
    QTest::qWait(1);  // the layout is made with the first events
  }

  QImage image() { return view_->grab().toImage(); }

  QPoint at(double x, double y) const { return view_->positionOf(x, y).toPoint(); }

  /// Whether the colour occurs within two pixels.
  bool has(const QColor& colour, QPoint place) {
    const QImage picture = image();
    for (int dx = -2; dx <= 2; ++dx)
      for (int dy = -2; dy <= 2; ++dy) {
        const QColor found = picture.pixelColor(place + QPoint(dx, dy));
        if (std::abs(found.red() - colour.red()) + std::abs(found.green() - colour.green()) +
                std::abs(found.blue() - colour.blue()) <
            60)
          return true;
      }
    return false;
  }

  std::unique_ptr<PlotView> view_;
};

TEST_F(PlotViewTest, PaintsPointsWhereTheyBelong) {
  EXPECT_TRUE(has(kColours.points, at(0.03, 0.02)));
  EXPECT_TRUE(has(kColours.points, at(30, 0.1)));
  EXPECT_TRUE(has(kColours.line, at(0.3, 1e-3)));
}

TEST_F(PlotViewTest, AxesAreLogarithmic) {
  const QPointF a = view_->positionOf(1e-2, 1e-3);
  const QPointF b = view_->positionOf(1e-1, 1e-2);
  const QPointF c = view_->positionOf(1, 1e-1);
  EXPECT_NEAR(b.x() - a.x(), c.x() - b.x(), 1e-6);
  EXPECT_NEAR(b.y() - a.y(), c.y() - b.y(), 1e-6);
  EXPECT_GT(b.x() - a.x(), 50);
  EXPECT_LT(b.y() - a.y(), -30);
}

TEST_F(PlotViewTest, GridLinesAreWholePixelsOfTheirColour) {
  const QImage picture = image();
  const auto colour = [&](double x, double y) {
    const QPointF place = view_->positionOf(x, y);
    return picture.pixelColor(static_cast<int>(place.x()), static_cast<int>(place.y()));
  };
  for (const double x : {1e-2, 1e-1, 1.0, 1e2}) EXPECT_EQ(colour(x, 3.3e-4), kColours.grid) << x;
  for (const double x : {2e-2, 5e-1, 8.0}) EXPECT_EQ(colour(x, 3.3e-4), kColours.fineGrid) << x;
  for (const double y : {1e-2, 1e-1}) EXPECT_EQ(colour(1.4e-2, y), kColours.grid) << y;
  for (const double y : {3e-3, 4e-2}) EXPECT_EQ(colour(1.4e-2, y), kColours.fineGrid) << y;
}

TEST_F(PlotViewTest, PaintsErrorBarsUpAndDown) {
  EXPECT_TRUE(has(kColours.points, at(0.03, 0.035)));
  EXPECT_TRUE(has(kColours.points, at(0.03, 0.005)));
  EXPECT_TRUE(has(kColours.points, at(0.03, 0.009)));
  EXPECT_FALSE(has(kColours.points, at(0.03, 0.09)));
  EXPECT_FALSE(has(kColours.points, at(30, 0.2)));  // an error that is not known has no bar
}

TEST_F(PlotViewTest, SkipsNegativeValues) {
  for (double y = 2e-4; y < 1; y *= 1.1) EXPECT_FALSE(has(kColours.points, at(0.3, y)));
}

TEST_F(PlotViewTest, MarksTheVelocity) {
  for (const double y : {2e-4, 3e-2, 0.5}) EXPECT_TRUE(has(kColours.marker, at(2, y)));
  EXPECT_TRUE(has(kColours.marker, at(2, 0.05) + QPoint(4, 0)));  // the dot is wider
  Plot plot = samplePlot();
  plot.marker.reset();
  view_->setPlot(plot);
  EXPECT_FALSE(has(kColours.marker, at(2, 3e-2)));
}

TEST_F(PlotViewTest, FadesWhatIsStale) {
  Plot plot = samplePlot();
  for (PlotSeries& series : plot.series) series.faded = true;
  view_->setPlot(plot);
  EXPECT_FALSE(has(kColours.points, at(0.03, 0.02)));
  EXPECT_TRUE(has(QColor(0xb3, 0xb3, 0xff), at(0.03, 0.02)));
  EXPECT_FALSE(has(kColours.line, at(0.3, 1e-3)));
}

TEST_F(PlotViewTest, FollowsOtherRangesAndSizes) {
  Plot plot = samplePlot();
  plot.x.range = {-6, 3};
  plot.y.range = {-12, 2};
  view_->setPlot(plot);
  view_->resize(500, 260);
  QTest::qWait(1);
  EXPECT_TRUE(has(kColours.points, at(0.03, 0.02)));
  EXPECT_TRUE(has(kColours.line, at(0.3, 1e-3)));
  EXPECT_TRUE(has(kColours.marker, at(2, 1e-9)));
}

TEST_F(PlotViewTest, AMarkerOutOfRangeStaysInsideTheFrame) {
  Plot plot = samplePlot();
  plot.marker->y = 1.2;  // the axis ends at 1
  view_->setPlot(plot);
  EXPECT_FALSE(has(kColours.marker, at(2, 1.2) + QPoint(5, 0)));
}

TEST_F(PlotViewTest, SaysWhyItIsBlank) {
  Plot plot = samplePlot();
  plot.series.clear();
  plot.marker.reset();
  const auto darkPixels = [&] {
    const QImage picture = image();
    const QRect middle(at(0.1, 0.05), at(10, 2e-3));
    int count = 0;
    for (int x = middle.left(); x < middle.right(); ++x)
      for (int y = middle.top(); y < middle.bottom(); ++y)
        if (picture.pixelColor(x, y).lightness() < 100) ++count;
    return count;
  };
  view_->setPlot(plot);
  EXPECT_EQ(darkPixels(), 0);
  plot.blank = QStringLiteral("nothing to see here");
  view_->setPlot(plot);
  EXPECT_GT(darkPixels(), 50);
}

TEST_F(PlotViewTest, PaintsPinnedCurvesInTheirColourOnALine) {
  Plot plot = samplePlot();
  PlotSeries pinned = plot.series[1];
  pinned.id = 3;
  pinned.place = 1;
  pinned.points = {{0.01, 0.3}, {0.1, 0.3}};
  plot.series.push_back(pinned);
  view_->setPlot(plot);
  EXPECT_TRUE(has(kColours.pinned[1], at(0.01, 0.3)));
  EXPECT_TRUE(has(kColours.pinned[1], at(0.03, 0.3)));
  EXPECT_FALSE(has(kColours.points, at(0.01, 0.3)));
}

TEST_F(PlotViewTest, ShadesRegionsByTurns) {
  Plot plot = samplePlot();
  plot.spans = {{"I", "linear", {}, 1e-3, 0.1, false}, {"II", "transition", {}, 0.1, 1e3, false}};
  view_->setPlot(plot);
  QTest::qWait(1);
  // Between the lines of the fine grid, away from everything else.
  EXPECT_EQ(image().pixelColor(at(0.045, 0.35)), kColours.span);
  EXPECT_EQ(image().pixelColor(at(15, 0.35)), kColours.background);
}

TEST_F(PlotViewTest, AStripStandsBelowOverTheSameAxis) {
  Plot plot = samplePlot();
  plot.strip = PlotStrip{"difference", "linear", "", -10, 10, false, {{0.03, 4, 1}, {30, 80}}};
  view_->setPlot(plot);
  QTest::qWait(1);
  const QPointF zero = view_->stripPositionOf(0.03, 0);
  EXPECT_EQ(zero.x(), view_->positionOf(0.03, 0.02).x());
  EXPECT_GT(zero.y(), view_->positionOf(0.03, 1e-4).y());
  EXPECT_TRUE(has(kColours.difference, view_->stripPositionOf(0.03, 4).toPoint()));
  EXPECT_TRUE(has(kColours.difference, view_->stripPositionOf(0.03, 4.9).toPoint()));
  EXPECT_FALSE(has(kColours.difference, view_->stripPositionOf(0.03, -4).toPoint()));
  // Beyond the range: an arrowhead at its edge.
  EXPECT_TRUE(has(kColours.difference, view_->stripPositionOf(30, 10).toPoint() + QPoint(0, 5)));
  EXPECT_TRUE(has(kColours.points, at(0.03, 0.02))) << "the curve is still there";
}

TEST_F(PlotViewTest, TheStripIsNeverTallerThanThePlot) {
  Plot plot = samplePlot();
  plot.strip = PlotStrip{"difference", "linear", "", -10, 10, false, {}};
  view_->setPlot(plot);
  for (const double letters : {1.0, 1.5}) {
    QFont font = QApplication::font();
    font.setPointSizeF(letters * font.pointSizeF());
    view_->setFont(font);
    for (const int height : {300, 400, 700}) {
      view_->resize(800, height);
      QTest::qWait(1);
      const double strip = view_->stripPositionOf(1, -10).y() - view_->stripPositionOf(1, 10).y();
      EXPECT_LT(strip, view_->positionOf(1, 1e-4).y() - view_->positionOf(1, 1).y())
          << height << ' ' << letters;
      EXPECT_GT(strip, 20);
    }
  }
}

/// In a presentation's large texts, too: a point at the upper left corner of its strip is seen
/// whatever the strip is called.
TEST_F(PlotViewTest, TheNameOfAStripHidesNoPoint) {
  QFont large = view_->font();
  large.setPointSizeF(1.5 * large.pointSizeF());
  view_->setFont(large);
  Plot plot = samplePlot();
  plot.strip = PlotStrip{"difference", "linear", "", -10, 10, false, {}};
  for (int i = 0; i < 20; ++i)
    plot.strip->points.push_back({1.2e-3 * std::pow(10, 0.1 * i), 8.5 - 0.05 * i});
  const auto without = [&](const QString& name) {
    plot.strip->name = name;
    view_->setPlot(plot);
    const QRect box(view_->stripPositionOf(1e-3, 10).toPoint(),
                    view_->stripPositionOf(1e3, -10).toPoint());
    return image().copy(box);
  };
  const QImage empty = without({});
  EXPECT_EQ(without("linear ×4, less the curve above"), empty);
}

TEST_F(PlotViewTest, TheMarkerAloneCanBeMoved) {
  PlotMarker marker = *samplePlot().marker;
  marker.x = 100;
  view_->setMarker(marker);
  EXPECT_TRUE(has(kColours.marker, at(100, 3e-2)));
  EXPECT_FALSE(has(kColours.marker, at(2, 3e-2)));
}

TEST_F(PlotViewTest, AnEmptyPlotIsHarmless) {
  view_->setPlot({});
  EXPECT_FALSE(image().isNull());
}

/// Names of regions take room from the plot: a view that had none then shows what a new one shows.
TEST_F(PlotViewTest, AxesGoWithThePlotArea) {
  image();
  Plot plot = samplePlot();
  plot.spans = {{"I", "linear", {}, 1e-3, 0.1, false}};
  view_->setPlot(plot);
  const std::unique_ptr<PlotView> fresh(makePlotView());
  fresh->resize(view_->size());
  fresh->setColours(kColours);
  fresh->setPlot(plot);
  fresh->show();
  QTest::qWait(1);
  EXPECT_EQ(image(), fresh->grab().toImage());
}

}  // namespace
}  // namespace asperity
