// What the diagram of work against precision says of the scene's own method.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/accuracy/work_precision_sheet.h"
#include "tests/core/small_scene.h"

namespace asperity {
namespace {

WorkPrecision comparison() {
  WorkPrecision made;
  made.present = {Method::Cubic, 2};
  made.lines = 3;
  RegionPrecision region;
  region.region = "III";
  region.velocities = {0.63, 630};
  double seconds = 1e-6;
  for (const MethodChoice& choice : allMethods()) {
    WorkPrecisionPoint point;
    point.choice = choice;
    point.seconds = seconds *= 2;
    point.lineSeconds = 41e-3;
    point.secondsWithLine = point.seconds + 1e-3;
    point.error = 1e-9 / seconds;
    region.points.push_back(point);
  }
  made.regions = {region, region};
  return made;
}

TEST(WorkPrecisionSheet, TheScenesMethodIsRingedAndNamedInEveryRegion) {
  const WorkPrecision made = comparison();
  const DiagramSheet sheet = workPrecisionSheet(made);
  ASSERT_EQ(sheet.diagrams.size(), made.regions.size());
  for (const Diagram& diagram : sheet.diagrams) {
    const auto ring = std::ranges::find(diagram.series, SeriesMark::Ring, &DiagramSeries::mark);
    ASSERT_NE(ring, diagram.series.end());
    EXPECT_EQ(ring->name.english(), "this scene: cubic \u00D72");
    const auto& points = made.regions[0].points;
    const auto own = std::ranges::find(points, made.present, &WorkPrecisionPoint::choice);
    ASSERT_EQ(ring->points.size(), 1U);
    EXPECT_EQ(ring->points[0].x, own->secondsWithLine);
    EXPECT_EQ(ring->points[0].y, own->error);
  }
}

/// A method that cannot compute the scene has neither curve nor entry.
TEST(WorkPrecisionSheet, EveryEntryOfTheLegendHasACurve) {
  WorkPrecision made = comparison();
  for (RegionPrecision& region : made.regions)
    std::erase_if(region.points, [](const WorkPrecisionPoint& point) {
      return point.choice.method == Method::Literal;
    });
  for (const Diagram& diagram : workPrecisionSheet(made).diagrams)
    for (const DiagramSeries& series : diagram.series)
      EXPECT_FALSE(series.points.empty()) << series.name.english();
}

/// A finer line takes longer to make, too.
TEST(WorkPrecisionSheet, TheMakingOfTheLineIsCounted) {
  Scene scene = sceneOfSize(200, 9, 2);
  WorkPrecisionOptions options{.lines = 1, .repeats = 1};
  const WorkPrecision made = workPrecision(scene, options);
  for (const RegionPrecision& region : made.regions)
    for (const WorkPrecisionPoint& point : region.points) {
      EXPECT_GT(point.lineSeconds, 0);
      EXPECT_DOUBLE_EQ(point.secondsWithLine, point.seconds + point.lineSeconds / 9);
      for (const WorkPrecisionPoint& other : region.points)
        EXPECT_FALSE(point.isOnFront && !other.isDifference && other.error < point.error &&
                     other.secondsWithLine < point.secondsWithLine);
    }
  EXPECT_NE(workPrecisionCsv(made).find(",line_seconds,seconds_with_line,"), std::string::npos);
}

TEST(WorkPrecisionSheet, VelocitiesArePrintedNotDumped) {
  EXPECT_EQ(workPrecisionSheet(comparison()).diagrams[0].title.english(),
            "region III: 0.63 to 630 m/s");
}

}  // namespace
}  // namespace asperity
