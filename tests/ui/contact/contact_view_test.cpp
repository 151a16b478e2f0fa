#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/ui/contact/sample_frame.h"
#include "ui/contact/contact_picture.h"

namespace asperity {
namespace {

struct Heights {
  double low, high;
};

Heights heightsOf(const Frame& frame) {
  const auto [low, high] = std::minmax_element(frame.lineHeight.begin(), frame.lineHeight.end());
  return {*low, *high};
}

TEST(ContactView, ShowsTheInterfaceWithRoomAroundIt) {
  for (const double depth : {1e-8, 1e-6, 5e-5, 1e-3}) {
    SampleOptions options;
    options.points = 500;
    options.depth = depth;
    const auto frame = sampleFrame(options);
    const ContactView view = fittedView(*frame);
    const Heights heights = heightsOf(*frame);
    const double fill = (heights.high - heights.low) / (view.top - view.bottom);
    EXPECT_GT(fill, 0.5) << depth;
    EXPECT_LT(fill, 0.75) << depth;
    EXPECT_GT(heights.low, view.bottom);
    EXPECT_LT(heights.high, view.top);
  }
}

TEST(ContactView, StandsStillWhileTheLineSlidesBy) {
  SampleOptions options;
  options.points = 400;
  const ContactView first = fittedView(*sampleFrame(options));
  ContactView view = first;
  for (int step = 1; step < 30; ++step) {
    options.distance = 0.00071 * step;
    view = fittedView(*sampleFrame(options), view);
    EXPECT_EQ(view, first) << step;
  }
}

TEST(ContactView, FollowsWhenItMust) {
  SampleOptions options;
  options.points = 400;
  const ContactView first = fittedView(*sampleFrame(options));
  options.depth = 2e-5;
  const auto deep = sampleFrame(options);
  const ContactView second = fittedView(*deep, first);
  EXPECT_LT(second.top, first.bottom);
  EXPECT_GT(second.pressure, first.pressure);
}

TEST(ContactView, KeepsTheUsersPlace) {
  SampleOptions options;
  options.points = 100;
  ContactView zoomed;
  zoomed.left = 0.003;
  zoomed.width = 0.001;
  const ContactView view = fittedView(*sampleFrame(options), zoomed);
  EXPECT_EQ(view.left, 0.003);
  EXPECT_EQ(view.width, 0.001);
  EXPECT_LT(view.bottom, view.top);
}

TEST(ContactView, FitsTheHeightsOfThePartThatIsShown) {
  SampleOptions options;
  options.points = 500;
  const auto frame = sampleFrame(options);
  const double period = frame->length;
  const double whole = resolvedView(*frame, {}).top - resolvedView(*frame, {}).bottom;
  for (const double left : {0.1 * period, 0.95 * period, -2.02 * period}) {
    ContactView view{.left = left, .width = 0.05 * period};
    fitToPart(*frame, view);
    EXPECT_LT(view.top - view.bottom, whole);
    Heights heights{1, -1};
    for (int k = 0; k < 25; ++k) {
      const double part = left / period + 0.05 * (k + 0.5) / 25;
      const auto point = static_cast<std::size_t>(500 * (part - std::floor(part)));
      for (const double height : {frame->lineHeight[point], frame->surfaceHeight[point]}) {
        heights.low = std::min(heights.low, height);
        heights.high = std::max(heights.high, height);
      }
    }
    EXPECT_GT(heights.low, view.bottom) << left;
    EXPECT_LT(heights.high, view.top) << left;
    EXPECT_GT(heights.high - heights.low, 0.4 * (view.top - view.bottom)) << left;
  }
}

TEST(ContactView, FlatLineHasAView) {
  for (const double depth : {0.0, 1e-6}) {
    SampleOptions options;
    options.points = 50;
    options.rmsHeight = 0;
    options.depth = depth;
    const ContactView view = resolvedView(*sampleFrame(options), {});
    EXPECT_LT(view.bottom, -depth);
    EXPECT_GT(view.top, 0);
    EXPECT_DOUBLE_EQ(view.width, 0.02);
    EXPECT_EQ(view.pressure > 0, depth > 0);  // none is made up
  }
}

TEST(ContactView, SurvivesFramesWithoutSense) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Frame frame;
  EXPECT_LT(resolvedView(frame, {}).bottom, resolvedView(frame, {}).top);
  SampleOptions options;
  options.points = 10;
  frame = *sampleFrame(options);
  frame.lineHeight[3] = nan;
  frame.surfaceHeight[4] = -std::numeric_limits<double>::infinity();
  frame.pressure[5] = nan;
  ContactView asked;
  asked.left = nan;
  asked.top = nan;
  const ContactView view = resolvedView(frame, asked);
  EXPECT_TRUE(std::isfinite(view.left) && std::isfinite(view.top - view.bottom));
}

}  // namespace
}  // namespace asperity
