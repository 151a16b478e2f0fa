#include "ui/chart/occupancy_grid.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

constexpr Box kArea{100, 50, 400, 200};

TEST(OccupancyGrid, KnowsWhatIsUnderABox) {
  OccupancyGrid map(kArea, 4);
  EXPECT_EQ(map.under(kArea), 0);
  map.addBox({100, 50, 200, 200}, 1);
  EXPECT_NEAR(map.under(kArea), 0.5, 1e-6);
  EXPECT_EQ(map.under({320, 60, 100, 100}), 0);
  EXPECT_NEAR(map.under({120, 70, 40, 40}), 1, 1e-6);
  map.addBox({110, 60, 4, 4}, 100);
  EXPECT_EQ(map.greatestUnder({100, 50, 50, 50}), 100);
  map.addLine({{-500, 0}, {-400, 0}}, 1);  // outside
  EXPECT_NEAR(map.under({300, 50, 200, 200}), 0, 1e-6);
}

TEST(OccupancyGrid, LinesTakeWhatTheyCross) {
  OccupancyGrid map(kArea, 4);
  map.addLine({{100, 50}, {500, 250}}, 1);
  EXPECT_GT(map.under({290, 140, 20, 20}), 0.1);
  EXPECT_EQ(map.under({400, 60, 80, 80}), 0);
  EXPECT_EQ(map.under({120, 170, 80, 70}), 0);
}

TEST(FreestPlace, IsACornerWhereAllIsFree) {
  const Box place = freestBox(OccupancyGrid(kArea, 4), 60, 40, 10);
  EXPECT_EQ(place.x, 110);
  EXPECT_EQ(place.y, 60);
}

TEST(FreestPlace, AvoidsWhatIsTaken) {
  OccupancyGrid map(kArea, 4);
  map.addBox({100, 50, 400, 120}, 1);  // above
  map.addBox({100, 50, 300, 200}, 1);  // left
  const Box place = freestBox(map, 60, 40, 10);
  EXPECT_EQ(map.under(place), 0);
  EXPECT_EQ(place.right(), 490);
  EXPECT_EQ(place.bottom(), 240);
  EXPECT_EQ(freestBox(map, 500, 40, 10).width, 0);  // too wide
}

}  // namespace
}  // namespace asperity
