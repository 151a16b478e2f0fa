#include "core/chart/influence_sheets.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

/// What differs from 0 by more than its error comes first, and sets the axis.
TEST(SensitivitySheet, WhatMayBeZeroIsLast) {
  const std::vector<Exponent> all{{"elastomer.temperature", 300, {3, 10}},
                                  {"surface.rms_height", 1e-6, {-1, 0.1}},
                                  {"surface.hurst", 0.7, {0.5, 0.1}}};
  Scene scene;
  scene.title = "My tyre";
  const DiagramSheet sheet = sensitivitySheet(scene, all);
  EXPECT_EQ(sheet.title.english(), "What friction depends on");
  EXPECT_TRUE(sheet.subtitle.english().starts_with("My tyre; "));
  const Diagram& diagram = sheet.diagrams.front();
  ASSERT_EQ(diagram.bars.size(), 3U);
  EXPECT_EQ(diagram.bars[0].value, -1);
  EXPECT_EQ(diagram.bars[1].value, 0.5);
  EXPECT_EQ(diagram.bars[2].value, 3);
  EXPECT_FALSE(diagram.bars[2].isSignificant());
  EXPECT_LT(diagram.x.from, -1.1);
  EXPECT_GT(diagram.x.to, 3);
  EXPECT_LT(diagram.x.to, 4);
}

TEST(SensitivitySheet, WhatHasNoErrorCounts) {
  EXPECT_TRUE((DiagramBar{"h", 0.1}.isSignificant()));
  EXPECT_FALSE((DiagramBar{"h", -0.1, 0.1}.isSignificant()));
  const DiagramSheet sheet = sensitivitySheet({}, {{"surface.hurst", 0.7, {0.5, 1}}});
  EXPECT_GT(sheet.diagrams.front().x.to, 1.5);  // where nothing counts, all is seen
}

}  // namespace
}  // namespace asperity
