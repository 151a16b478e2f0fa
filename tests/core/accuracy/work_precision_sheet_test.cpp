// What the diagram of work against precision says of the scene's own method.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/accuracy/work_precision_file.h"

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
    EXPECT_EQ(ring->name, "this scene: cubic \u00D72");
    const auto& points = made.regions[0].points;
    const auto own = std::ranges::find(points, made.present, &WorkPrecisionPoint::choice);
    ASSERT_EQ(ring->points.size(), 1U);
    EXPECT_EQ(ring->points[0].x, own->seconds);
    EXPECT_EQ(ring->points[0].y, own->error);
  }
}

TEST(WorkPrecisionSheet, VelocitiesArePrintedNotDumped) {
  EXPECT_EQ(workPrecisionSheet(comparison()).diagrams[0].title, "region III: 0.63 to 630 m/s");
}

}  // namespace
}  // namespace asperity
