// Where a label hides no contact and is crossed by no line, in a picture whose pixels are metres.
#include "ui/contact/label_placement.h"

#include <gtest/gtest.h>

#include <utility>

namespace asperity {
namespace {

/// A picture of 200 by 100 pixels, in which the height 0 is in row 50.
ContactLayout layoutOfMetres() {
  ContactLayout layout;
  layout.plot = {0, 0, 200, 100};
  layout.view.left = 0;
  layout.view.width = 200;
  layout.view.top = 50;
  layout.view.bottom = -50;
  return layout;
}

/// A line at the height 20, which is pressed in by 5 between each pair of places.
Frame frameWith(std::vector<std::pair<std::size_t, std::size_t>> contacts) {
  Frame frame;
  frame.spacing = 1;
  frame.length = 200;
  frame.lineHeight.assign(200, 20);
  frame.surfaceHeight.assign(200, 0);
  frame.pressure.assign(200, 0);
  for (const auto& [from, to] : contacts)
    for (std::size_t i = from; i < to; ++i) {
      frame.lineHeight[i] = frame.surfaceHeight[i] = -5;
      frame.pressure[i] = 1;
    }
  return frame;
}

TEST(LabelPlacement, ALabelHidesNoContact) {
  const ContactLayout layout = layoutOfMetres();
  constexpr float kTop = 60, kWidth = 50, kMargin = 5;
  const auto place = [&](const Frame& frame, std::optional<float> last = {}) {
    return labelPlacement(frame, layout, kTop, kWidth, kMargin, last);
  };
  EXPECT_EQ(place(frameWith({})), 5);
  EXPECT_EQ(place(frameWith({{20, 40}})), 145);
  EXPECT_EQ(place(frameWith({{20, 40}, {150, 160}})), 75);
  EXPECT_EQ(place(frameWith({{20, 40}, {100, 102}, {150, 160}})), std::nullopt);
  EXPECT_EQ(place(frameWith({{20, 40}}), 80.0F), 80) << "it stays where it was";
  EXPECT_EQ(place(frameWith({{20, 40}}), 30.0F), 145) << "except on a contact";
}

/// A contact that is too narrow for its points is marked by a dot, which no label hides.
TEST(LabelPlacement, ADotIsAContact) {
  ContactLayout layout = layoutOfMetres();
  layout.marked = 30;
  EXPECT_EQ(labelPlacement(frameWith({}), layout, 40, 50, 5), 145);
  EXPECT_FALSE(clearAcross(frameWith({}), layout, 40));
}

/// The brighter half of the glow is a tenth of the height of the plot.
TEST(LabelPlacement, IsFixedWhereNoContactEverComes) {
  const ContactLayout layout = layoutOfMetres();
  EXPECT_FALSE(clearAcross(frameWith({{20, 40}}), layout, 64));
  EXPECT_TRUE(clearAcross(frameWith({{20, 40}}), layout, 66));
  EXPECT_TRUE(clearAcross(frameWith({}), layout, 20));
}

TEST(LabelPlacement, ALineMissesTheRowsBesideIt) {
  const ContactLayout layout = layoutOfMetres();
  const Frame frame = frameWith({{20, 40}});  // rows 30 and 55
  EXPECT_TRUE(lineStaysBelow(frame, layout, 29));
  EXPECT_FALSE(lineStaysBelow(frame, layout, 31));
  EXPECT_TRUE(lineMisses(frame, layout, 5, 29));
  EXPECT_FALSE(lineMisses(frame, layout, 35, 50));
  EXPECT_TRUE(lineMisses(frame, layout, 56, 70));
}

TEST(LabelPlacement, ABoxMovesAsideFromACrestNoFartherThanItMust) {
  const ContactLayout layout = layoutOfMetres();
  Frame frame = frameWith({});
  for (std::size_t i = 90; i < 110; ++i) frame.lineHeight[i] = 45;  // row 5
  const CurveRows line = curveRows(frame, frame.lineHeight, layout);
  const Box box{80, 0, 40, 20};
  EXPECT_TRUE(line.crosses(box));
  EXPECT_FALSE(line.crosses({20, 0, 40, 20}));
  const std::optional<float> left = freeSpanAbove(line, box, 0, 200);
  ASSERT_TRUE(left);
  EXPECT_NEAR(*left + box.width, 89, 4);
  const std::optional<float> right = freeSpanAbove(line, box, 60, 200);
  ASSERT_TRUE(right);
  EXPECT_NEAR(*right, 110, 4);
  EXPECT_EQ(freeSpanAbove(line, box, 60, 140), std::nullopt);
}

TEST(LabelPlacement, ANameIsOnItsOwnBody) {
  const ContactLayout layout = layoutOfMetres();
  const Frame frame = frameWith({{20, 40}});
  const Box above{60, 2, 30, 20}, below{60, 70, 30, 20}, gap{60, 33, 30, 14};
  EXPECT_TRUE(isOnBody(Body::Rigid, frame, layout, above));
  EXPECT_FALSE(isOnBody(Body::Elastomer, frame, layout, above));
  EXPECT_TRUE(isOnBody(Body::Elastomer, frame, layout, below));
  EXPECT_FALSE(isOnBody(Body::Rigid, frame, layout, below));
  EXPECT_FALSE(isOnBody(Body::Rigid, frame, layout, gap));
  EXPECT_FALSE(isOnBody(Body::Elastomer, frame, layout, gap));
}

}  // namespace
}  // namespace asperity
