// What the interactive chart paints, read back from its pixels.
#include <gtest/gtest.h>

#include <QImage>
#include <QPainter>
#include <QTest>
#include <cmath>
#include <memory>

#include "core/chart/curve_diagram.h"
#include "tests/ui/window/qt_application.h"
#include "ui/chart/chart_view.h"

namespace asperity {
namespace {

ChartStyle look() {
  ChartStyle look;
  look.theme = printTheme();
  return look;
}

DiagramSeries seriesWith(int id, int colour, std::vector<DiagramPoint> points) {
  DiagramSeries series;
  series.mark = SeriesMark::Circle;
  series.stroke = SeriesStroke::None;
  series.colour = colour;
  series.id = id;
  series.points = std::move(points);
  return series;
}

QColor toQColor(int index) {
  return look().curve(seriesWith(0, index, {}));
}

/// A law, points with one error bar and one that has no place, and a marker.
DiagramSheet sampleSheet() {
  Diagram diagram;
  diagram.x = {"x", "", AxisScale::Logarithmic, 1e-3, 1e3};
  diagram.y = {"y", "", AxisScale::Logarithmic, 1e-4, 1};
  DiagramSeries law;
  law.name = "law";
  law.isTheory = true;
  law.id = kLawCurve;
  law.points = {{1e-3, 1e-3}, {1e3, 1e-3}};
  DiagramSeries points =
      seriesWith(kPresentCurve, 0, {{0.03, 0.02, 0.005, 0.035}, {0.3, -1, -1.1, -0.9}, {30, 0.1}});
  points.name = "points";
  diagram.series = {law, points};
  diagram.marker = DiagramMarker{"now", "v", 2, 0.05};
  DiagramSheet sheet;
  sheet.diagrams = {diagram};
  return sheet;
}

/// The sheet with a difference below the curve.
DiagramSheet sheetWithStrip(std::vector<DiagramPoint> points) {
  DiagramSheet sheet = sampleSheet();
  Diagram strip;
  strip.x = sheet.diagrams[0].x;
  strip.y = {"difference", "%", AxisScale::Linear, -10, 10};
  strip.height = 0.42;
  strip.series = {seriesWith(kDifferenceCurve, 3, std::move(points))};
  sheet.diagrams.push_back(strip);
  sheet.sharesAxis = true;
  return sheet;
}

class ChartViewTest : public testing::Test {
 protected:
  ChartViewTest() : view_(std::make_unique<ChartView>()) {
    view_->resize(800, 400);
    view_->setTheme(printTheme());
    view_->setSheet(sampleSheet());
    view_->show();
    QTest::qWait(1);  // the layout is made with the first events
  }

  QImage image() { return view_->grab().toImage(); }

  QPoint at(double x, double y) const { return view_->mapToPosition(x, y).toPoint(); }

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

  std::unique_ptr<ChartView> view_;
};

TEST_F(ChartViewTest, PaintsPointsWhereTheyBelong) {
  EXPECT_TRUE(has(toQColor(0), at(0.03, 0.02)));
  EXPECT_TRUE(has(toQColor(0), at(30, 0.1)));
  EXPECT_TRUE(has(look().text(), at(0.3, 1e-3)));
}

TEST_F(ChartViewTest, AxesAreLogarithmic) {
  const QPointF a = view_->mapToPosition(1e-2, 1e-3);
  const QPointF b = view_->mapToPosition(1e-1, 1e-2);
  const QPointF c = view_->mapToPosition(1, 1e-1);
  EXPECT_NEAR(b.x() - a.x(), c.x() - b.x(), 1e-6);
  EXPECT_NEAR(b.y() - a.y(), c.y() - b.y(), 1e-6);
  EXPECT_GT(b.x() - a.x(), 50);
  EXPECT_LT(b.y() - a.y(), -30);
}

TEST_F(ChartViewTest, GridLinesAreWholePixelsOfTheirColour) {
  const QImage picture = image();
  const auto colour = [&](double x, double y) {
    const QPointF place = view_->mapToPosition(x, y);
    return picture.pixelColor(static_cast<int>(place.x()), static_cast<int>(place.y()));
  };
  for (const double x : {1e-2, 1e-1, 1.0, 1e2}) EXPECT_EQ(colour(x, 3.3e-4), look().grid()) << x;
  for (const double x : {2e-2, 5e-1, 8.0}) EXPECT_EQ(colour(x, 3.3e-4), look().fineGrid()) << x;
  for (const double y : {1e-2, 1e-1}) EXPECT_EQ(colour(1.4e-2, y), look().grid()) << y;
  for (const double y : {3e-3, 4e-2}) EXPECT_EQ(colour(1.4e-2, y), look().fineGrid()) << y;
}

/// All four sides of the frame are one pixel wide, and so are the marks of its ticks.
TEST_F(ChartViewTest, TheSidesOfTheFrameAreAlike) {
  const QImage picture = image();
  const auto pixelsOfAxis = [&](QPoint from, QPoint step) {
    int pixels = 0;
    for (int i = 0; i < 16; ++i) {
      const QColor found = picture.pixelColor(from + i * step);
      if (found == look().axis())
        ++pixels;
      else
        EXPECT_GT(found.lightness(), look().grid().lightness() - 1) << i;  // no pale edge
    }
    return pixels;
  };
  const QPoint low = at(1.05e-3, 3.3e-4), high = at(950, 0.6);
  EXPECT_EQ(pixelsOfAxis(low, {-1, 0}), 1) << "left";
  EXPECT_EQ(pixelsOfAxis({low.x(), at(1, 1.2e-4).y()}, {0, 1}), 1) << "below";
  EXPECT_EQ(pixelsOfAxis(high, {1, 0}), 1) << "right";
  EXPECT_EQ(pixelsOfAxis({high.x(), at(1, 0.9).y()}, {0, -1}), 1) << "above";
  const auto floored = [&](double x, double y) {
    const QPointF place = view_->mapToPosition(x, y);
    return QPoint(static_cast<int>(place.x()), static_cast<int>(place.y()));
  };
  EXPECT_EQ(picture.pixelColor(floored(1, 1e-4) + QPoint(0, 3)), look().axis());
  const int left = at(1e-3, 1e-2).x() - static_cast<int>(kFrameEdge);
  EXPECT_EQ(picture.pixelColor(left - 3, floored(1, 1e-2).y()), look().axis());
}

TEST_F(ChartViewTest, PaintsErrorBarsUpAndDown) {
  EXPECT_TRUE(has(toQColor(0), at(0.03, 0.035)));
  EXPECT_TRUE(has(toQColor(0), at(0.03, 0.005)));
  EXPECT_TRUE(has(toQColor(0), at(0.03, 0.009)));
  EXPECT_FALSE(has(toQColor(0), at(0.03, 0.09)));
  EXPECT_FALSE(has(toQColor(0), at(30, 0.2)));  // an error that is not known has no bar
}

/// On a screen with a high density marks may lie between two of the window's pixels.
TEST_F(ChartViewTest, MarksLieOnTheirErrorBars) {
  DiagramSheet sheet = sampleSheet();
  Diagram& diagram = sheet.diagrams[0];
  diagram.marker.reset();
  std::vector<DiagramPoint> points;
  for (const double x : {0.0031, 0.017, 0.071, 0.37, 2.3, 17.0, 130.0})
    points.push_back({x, 0.02, 0.004, 0.1});
  diagram.series = {seriesWith(kPresentCurve, 0, points)};
  view_->setSheet(sheet);
  QTest::qWait(1);
  constexpr int kDensity = 2;
  QImage picture(kDensity * view_->size(), QImage::Format_RGB32);
  picture.setDevicePixelRatio(kDensity);
  view_->render(&picture);
  // The middle of the blue pixels in a row around a point.
  const auto middle = [&](double x, double y) {
    const QPoint place = kDensity * at(x, y);
    double weight = 0, sum = 0;
    for (int dx = -14; dx <= 14; ++dx) {
      const int red = picture.pixelColor(place + QPoint(dx, 0)).red();
      if (red > 180) continue;  // background and grid
      weight += 255 - red;
      sum += (255 - red) * (place.x() + dx);
    }
    EXPECT_GT(weight, 0);
    return sum / weight;
  };
  for (const DiagramPoint& point : points)
    EXPECT_NEAR(middle(point.x, 0.02), middle(point.x, 0.06), 0.2) << point.x;
}

TEST_F(ChartViewTest, SkipsNegativeValues) {
  for (double y = 2e-4; y < 1; y *= 1.1) EXPECT_FALSE(has(toQColor(0), at(0.3, y)));
}

TEST_F(ChartViewTest, MarksTheVelocity) {
  for (const double y : {2e-4, 3e-2, 0.5}) EXPECT_TRUE(has(look().marker(), at(2, y)));
  EXPECT_TRUE(has(look().marker(), at(2, 0.05) + QPoint(4, 0)));  // the dot is wider
  DiagramSheet sheet = sampleSheet();
  Diagram& diagram = sheet.diagrams[0];
  diagram.marker.reset();
  view_->setSheet(sheet);
  EXPECT_FALSE(has(look().marker(), at(2, 3e-2)));
}

TEST_F(ChartViewTest, FadesWhatIsStale) {
  DiagramSheet sheet = sampleSheet();
  Diagram& diagram = sheet.diagrams[0];
  for (DiagramSeries& series : diagram.series) series.isFaded = true;
  view_->setSheet(sheet);
  EXPECT_FALSE(has(toQColor(0), at(0.03, 0.02)));
  EXPECT_TRUE(has(QColor(0xb3, 0xd5, 0xe8), at(0.03, 0.02)));
  EXPECT_FALSE(has(look().text(), at(0.3, 1e-3)));
}

TEST_F(ChartViewTest, FollowsOtherRangesAndSizes) {
  DiagramSheet sheet = sampleSheet();
  Diagram& diagram = sheet.diagrams[0];
  diagram.x.from = 1e-6;
  diagram.y.from = 1e-12;
  diagram.y.to = 100;
  view_->setSheet(sheet);
  view_->resize(500, 260);
  QTest::qWait(1);
  EXPECT_TRUE(has(toQColor(0), at(0.03, 0.02)));
  EXPECT_TRUE(has(look().text(), at(0.3, 1e-3)));
  EXPECT_TRUE(has(look().marker(), at(2, 1e-9)));
}

TEST_F(ChartViewTest, AMarkerOutOfRangeStaysInsideTheFrame) {
  DiagramSheet sheet = sampleSheet();
  Diagram& diagram = sheet.diagrams[0];
  diagram.marker->y = 1.2;  // the axis ends at 1
  view_->setSheet(sheet);
  EXPECT_FALSE(has(look().marker(), at(2, 1.2) + QPoint(5, 0)));
}

TEST_F(ChartViewTest, SaysWhyItIsBlank) {
  DiagramSheet sheet = sampleSheet();
  Diagram& diagram = sheet.diagrams[0];
  diagram.series.clear();
  diagram.marker.reset();
  const auto darkPixels = [&] {
    const QImage picture = image();
    const QRect middle(at(0.1, 0.05), at(10, 2e-3));
    int count = 0;
    for (int x = middle.left(); x < middle.right(); ++x)
      for (int y = middle.top(); y < middle.bottom(); ++y)
        if (picture.pixelColor(x, y).lightness() < 100) ++count;
    return count;
  };
  view_->setSheet(sheet);
  EXPECT_EQ(darkPixels(), 0);
  diagram.blank = "nothing to see here";
  view_->setSheet(sheet);
  EXPECT_GT(darkPixels(), 50);
}

TEST_F(ChartViewTest, PaintsPinnedCurvesInTheirColourOnALine) {
  DiagramSheet sheet = sampleSheet();
  Diagram& diagram = sheet.diagrams[0];
  DiagramSeries pinned = seriesWith(3, 3, {{0.01, 0.3}, {0.1, 0.3}});
  pinned.stroke = SeriesStroke::Solid;
  diagram.series.push_back(pinned);
  view_->setSheet(sheet);
  EXPECT_TRUE(has(toQColor(3), at(0.01, 0.3)));
  EXPECT_TRUE(has(toQColor(3), at(0.03, 0.3)));
  EXPECT_FALSE(has(toQColor(0), at(0.01, 0.3)));
}

TEST_F(ChartViewTest, ShadesRegionsByTurns) {
  DiagramSheet sheet = sampleSheet();
  Diagram& diagram = sheet.diagrams[0];
  diagram.spans = {{1e-3, 0.1, "I linear", "I"}, {0.1, 1e3, "II transition", "II"}};
  view_->setSheet(sheet);
  QTest::qWait(1);
  // Between the lines of the fine grid, away from everything else.
  QImage tinted(1, 1, QImage::Format_ARGB32_Premultiplied);
  tinted.fill(look().background());
  QPainter(&tinted).fillRect(tinted.rect(), look().span());
  EXPECT_NE(tinted.pixelColor(0, 0), look().background());
  EXPECT_EQ(image().pixelColor(at(0.045, 0.35)), tinted.pixelColor(0, 0));
  EXPECT_EQ(image().pixelColor(at(15, 0.35)), look().background());
}

TEST_F(ChartViewTest, ADiagramStandsBelowOverTheSameAxis) {
  DiagramSheet sheet = sheetWithStrip({{0.03, 4, 3, 5}, {30, 8}});
  view_->setSheet(sheet);
  QTest::qWait(1);
  const QPointF zero = view_->mapToPosition(0.03, 0, 1);
  EXPECT_EQ(zero.x(), view_->mapToPosition(0.03, 0.02).x());
  EXPECT_GT(zero.y(), view_->mapToPosition(0.03, 1e-4).y());
  EXPECT_TRUE(has(toQColor(3), view_->mapToPosition(0.03, 4, 1).toPoint()));
  EXPECT_TRUE(has(toQColor(3), view_->mapToPosition(0.03, 4.9, 1).toPoint()));
  EXPECT_FALSE(has(toQColor(3), view_->mapToPosition(0.03, -4, 1).toPoint()));
  EXPECT_TRUE(has(toQColor(0), at(0.03, 0.02))) << "the curve is still there";
}

TEST_F(ChartViewTest, TheLowerDiagramIsNeverTallerThanTheUpperOne) {
  view_->setSheet(sheetWithStrip({{0.03, 4}}));
  for (const double letters : {1.0, 1.5}) {
    QFont font = QApplication::font();
    font.setPointSizeF(letters * font.pointSizeF());
    view_->setFont(font);
    for (const int height : {300, 400, 700}) {
      view_->resize(800, height);
      QTest::qWait(1);
      const double strip = view_->mapToPosition(1, -10, 1).y() - view_->mapToPosition(1, 10, 1).y();
      EXPECT_LT(strip, view_->mapToPosition(1, 1e-4).y() - view_->mapToPosition(1, 1).y())
          << height << ' ' << letters;
      EXPECT_GT(strip, 20);
    }
  }
}

/// In a presentation's large texts, too: a point at the upper left corner of its frame is seen
/// whatever its series is called.
TEST_F(ChartViewTest, TheNameOfALowerSeriesHidesNoPoint) {
  QFont large = view_->font();
  large.setPointSizeF(1.5 * large.pointSizeF());
  view_->setFont(large);
  std::vector<DiagramPoint> points;
  for (int i = 0; i < 20; ++i) points.push_back({1.2e-3 * std::pow(10, 0.1 * i), 8.5 - 0.05 * i});
  DiagramSheet sheet = sheetWithStrip(points);
  sheet.diagrams[1].series[0].name = "linear ×4, minus the curve above";
  view_->setSheet(sheet);
  for (const DiagramPoint& point : points)
    EXPECT_TRUE(has(toQColor(3), view_->mapToPosition(point.x, point.y, 1).toPoint())) << point.x;
}

/// Marks at the ends of the axis are whole: the frame reaches beyond them.
TEST_F(ChartViewTest, MarksAtTheEndsOfTheAxisAreWhole) {
  DiagramSheet sheet = sampleSheet();
  sheet.diagrams[0].series[1].points = {{1e-3, 0.1}, {1e3, 0.1}};
  view_->setSheet(sheet);
  for (const int way : {-3, 3}) {
    EXPECT_TRUE(has(toQColor(0), at(1e-3, 0.1) + QPoint(way, 0))) << way;
    EXPECT_TRUE(has(toQColor(0), at(1e3, 0.1) + QPoint(way, 0))) << way;
  }
}

TEST_F(ChartViewTest, TheMarkerAloneCanBeMoved) {
  DiagramMarker marker = *sampleSheet().diagrams[0].marker;
  marker.x = 100;
  view_->setMarker(marker);
  EXPECT_TRUE(has(look().marker(), at(100, 3e-2)));
  EXPECT_FALSE(has(look().marker(), at(2, 3e-2)));
}

/// The legend gives its rows back to the chart, whatever numbers its status has; only while a curve
/// grows, whose names change, the chart keeps its place.
TEST_F(ChartViewTest, AShorterLegendLeavesItsSpaceToTheChart) {
  DiagramSheet few = sampleSheet();
  few.status = "dashed: relaxation at the predicted rate 1/τ + v/ℓ = 12.5 s⁻¹";
  const auto top = [&](const DiagramSheet& sheet) {
    view_->setSheet(sheet);
    QTest::qWait(1);
    return view_->frame()->area.top();
  };
  const double usual = top(few);
  DiagramSheet many = few;
  for (int i = 0; i < 6; ++i) {
    DiagramSeries pinned = seriesWith(i + 1, 2, {{1, 0.1}});
    pinned.name = "a curve with a name that takes much of a row";
    many.diagrams[0].series.push_back(pinned);
  }
  EXPECT_GT(top(many), usual);
  EXPECT_EQ(top(few), usual);
  const double lower = top(many);
  few.isGrowing = true;
  EXPECT_EQ(top(few), lower);
}

TEST_F(ChartViewTest, AnEmptyPlotIsHarmless) {
  view_->setSheet({});
  EXPECT_FALSE(image().isNull());
}

/// Names of regions take room from the plot: a view that had none then shows what a new one shows.
TEST_F(ChartViewTest, AxesGoWithThePlotArea) {
  image();
  DiagramSheet sheet = sampleSheet();
  Diagram& diagram = sheet.diagrams[0];
  diagram.spans = {{1e-3, 0.1, "I linear", "I"}};
  view_->setSheet(sheet);
  const std::unique_ptr<ChartView> fresh(new ChartView);
  fresh->resize(view_->size());
  fresh->setTheme(printTheme());
  fresh->setSheet(sheet);
  fresh->show();
  QTest::qWait(1);
  EXPECT_EQ(image(), fresh->grab().toImage());
}

/// The sentence that says why there is no curve is not crossed by the line of the present state.
TEST_F(ChartViewTest, TheLineOfTheMarkerDoesNotCrossTheSentence) {
  DiagramSheet sheet = sampleSheet();
  sheet.diagrams[0].series.clear();
  sheet.diagrams[0].blank = "There is no friction: an elastic body gives back all the work.";
  sheet.diagrams[0].marker->x = 1;
  sheet.diagrams[0].marker->y = 0;
  view_->setSheet(sheet);
  EXPECT_TRUE(has(look().marker(), at(1, 0.1)));
  EXPECT_TRUE(has(look().marker(), at(1, 1e-3)));
  EXPECT_FALSE(has(look().marker(), at(1, 1e-2)));
}

}  // namespace
}  // namespace asperity
