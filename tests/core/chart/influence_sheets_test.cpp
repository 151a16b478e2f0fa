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

/// Friction falls to half between cut-offs of 1 mm and 10 mm, in the middle of their logarithms.
TEST(DescribeCutoff, SaysWhichWavesMakeFriction) {
  std::vector<CutoffPoint> points(4);
  const double wavelengths[] = {1e-1, 1e-2, 1e-3, 1e-4}, mu[] = {0.0, 0.2, 0.6, 0.8};
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i].wavelength = wavelengths[i];
    points[i].state.mu = mu[i];
    points[i].shareOfDecade.value = i > 0 ? (mu[i] - mu[i - 1]) / mu[3] : kNotApplicable;
  }
  std::vector<Message> lines = describeCutoff(points);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].english(),
            "without waves shorter than 3.2 mm friction of deformation is half as large");
  EXPECT_TRUE(lines[1].english().find("makes 25 % of friction: shorter waves") != std::string::npos)
      << lines[1].english();
  points.back().shareOfDecade.value = 0.05;
  EXPECT_EQ(describeCutoff(points).size(), 1U);
  EXPECT_TRUE(describeCutoff({}).empty());
  for (CutoffPoint& point : points) point.state.mu = 0;  // an elastic body, or a line at rest
  EXPECT_TRUE(describeCutoff(points).empty());
}

TEST(SensitivitySheet, WhatHasNoErrorCounts) {
  EXPECT_TRUE((DiagramBar{"h", 0.1}.isSignificant()));
  EXPECT_FALSE((DiagramBar{"h", -0.1, 0.1}.isSignificant()));
  const DiagramSheet sheet = sensitivitySheet({}, {{"surface.hurst", 0.7, {0.5, 1}}});
  EXPECT_GT(sheet.diagrams.front().x.to, 1.5);  // where nothing counts, all is seen
}

}  // namespace
}  // namespace asperity
