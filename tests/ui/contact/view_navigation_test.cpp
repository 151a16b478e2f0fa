// Zooming and moving in the contact picture, without a widget.
#include "ui/contact/view_navigation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace asperity {
namespace {

constexpr double kPeriod = 0.02, kFinest = 1e-3;
constexpr ContactView kFitted{0, 0, -1.5e-6, 1.5e-6, 200};

ContactView viewOf(const ViewNavigation& navigation, double distance = 0) {
  return navigation.applied(kFitted, kPeriod, distance);
}

double positionAt(const ContactView& view, const ViewPosition& place) {
  return view.left + place.x * view.width;
}

double heightAt(const ContactView& view, const ViewPosition& place) {
  return view.bottom + place.y * (view.top - view.bottom);
}

/// The difference of two positions on the periodic line.
double apart(double a, double b) {
  return std::abs(std::remainder(a - b, kPeriod));
}

TEST(ViewNavigation, BeginsFitted) {
  const ContactView view = viewOf({});
  EXPECT_EQ(view.left, 0);
  EXPECT_EQ(view.width, kPeriod);
  EXPECT_EQ(view.bottom, kFitted.bottom);
  EXPECT_EQ(view.top, kFitted.top);
  EXPECT_EQ(view.pressure, kFitted.pressure);
  EXPECT_TRUE(ViewNavigation{}.isFitted());
}

TEST(ViewNavigation, ZoomKeepsWhatIsUnderTheCursor) {
  ViewNavigation navigation;
  const ViewPosition at{0.3, 0.6};
  for (const double factor : {2.0, 3.0, 1.1, 0.7, 5.0}) {
    const ContactView before = viewOf(navigation);
    navigation = navigation.zoomed(at, factor, factor, kFinest);
    const ContactView after = viewOf(navigation);
    EXPECT_NEAR(after.width, before.width / factor, 1e-15);
    EXPECT_LT(apart(positionAt(before, at), positionAt(after, at)), 1e-12);
    EXPECT_NEAR(heightAt(before, at), heightAt(after, at), 1e-17);
  }
}

TEST(ViewNavigation, ZoomingInAndOutAgainEndsFitted) {
  ViewNavigation navigation;
  for (int i = 0; i < 7; ++i) navigation = navigation.zoomed({0.8, 0.3}, 1.25, 1.25, kFinest);
  EXPECT_FALSE(navigation.isFitted());
  for (int i = 0; i < 9; ++i) navigation = navigation.zoomed({0.1, 0.9}, 0.8, 0.8, kFinest);
  EXPECT_EQ(viewOf(navigation).width, kPeriod);
}

TEST(ViewNavigation, PanningMovesTheContentsAndWrapsAround) {
  const ViewNavigation zoomed = ViewNavigation{}.zoomed({0.5, 0.5}, 4, 1, kFinest);
  const ContactView before = viewOf(zoomed);
  const ContactView after = viewOf(zoomed.panned(0.5, 0));
  EXPECT_LT(apart(after.left, before.left - 0.5 * before.width), 1e-15);
  EXPECT_EQ(after.width, before.width);
  ViewNavigation around = zoomed;
  for (int i = 0; i < 8; ++i) around = around.panned(0.5, 0);
  EXPECT_LT(apart(viewOf(around).left, before.left), 1e-12);
}

TEST(ViewNavigation, ExaggerationAloneLeavesTheViewAlongAsItIs) {
  const ViewNavigation zoomed = ViewNavigation{}.zoomed({0.2, 0.5}, 3, 3, kFinest);
  const ViewNavigation steeper = zoomed.zoomed({0.2, 0.5}, 1, 2, kFinest);
  EXPECT_EQ(viewOf(steeper).left, viewOf(zoomed).left);
  EXPECT_EQ(viewOf(steeper).width, viewOf(zoomed).width);
  EXPECT_NEAR(viewOf(steeper).top - viewOf(steeper).bottom, 0.5e-6, 1e-12);
  EXPECT_TRUE(steeper.withFittedHeights().hasFittedHeights());
  EXPECT_EQ(viewOf(steeper.withFittedHeights()).left, viewOf(zoomed).left);
}

TEST(ViewNavigation, LessExaggerationHoldsAllHeights) {
  const ContactView flat = viewOf(ViewNavigation{}.zoomed({0.5, 0.1}, 1, 1e-3, kFinest));
  EXPECT_NEAR(flat.top - flat.bottom, 3e-3, 1e-12);
  EXPECT_LE(flat.bottom, kFitted.bottom);
  EXPECT_GE(flat.top, kFitted.top);
}

/// Whatever is done, something of the contact is seen: the view lies within the period and, where
/// enlarged, within the fitted heights, and is wide enough for a few elements.
TEST(ViewNavigation, IsNeverLost) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(-0.5, 1.5), step(-5, 5);
  ViewNavigation navigation;
  for (int i = 0; i < 2000; ++i) {
    if (i % 3 == 0)
      navigation = navigation.panned(step(random), step(random));
    else
      navigation = navigation.zoomed({share(random), share(random)}, std::exp(step(random)),
                                     std::exp(step(random)), kFinest);
    const ContactView view = viewOf(navigation);
    const double size = view.top - view.bottom, whole = kFitted.top - kFitted.bottom;
    ASSERT_GE(view.left, 0);
    ASSERT_LT(view.left, kPeriod);
    ASSERT_GE(view.width, kFinest * kPeriod * (1 - 1e-9));
    ASSERT_LE(view.width, kPeriod);
    ASSERT_GT(size, 0);
    if (size <= whole) {
      ASSERT_GE(view.bottom, kFitted.bottom - 1e-9 * whole);
      ASSERT_LE(view.top, kFitted.top + 1e-9 * whole);
    } else {
      ASSERT_LE(view.bottom, kFitted.bottom + 1e-9 * size);
      ASSERT_GE(view.top, kFitted.top - 1e-9 * size);
    }
  }
}

TEST(ViewNavigation, WhatIsNotANumberChangesNothing) {
  const ViewNavigation zoomed = ViewNavigation{}.zoomed({0.5, 0.5}, 4, 2, kFinest);
  EXPECT_EQ(zoomed.panned(NAN, INFINITY), zoomed);
  EXPECT_EQ(viewOf(zoomed.zoomed({0.5, 0.5}, NAN, -1, kFinest)).width, viewOf(zoomed).width);
}

TEST(ViewNavigation, FollowsTheLineWithoutAJump) {
  const ViewNavigation zoomed = ViewNavigation{}.zoomed({0.7, 0.5}, 10, 1, kFinest);
  const double slid = 0.0312;
  const ViewNavigation follows = zoomed.following(true, kPeriod, slid);
  EXPECT_LT(apart(viewOf(follows, slid).left, viewOf(zoomed, slid).left), 1e-15);
  EXPECT_LT(apart(viewOf(follows, slid + 0.001).left, viewOf(zoomed).left + 0.001), 1e-15);
  const ViewNavigation stands = follows.following(false, kPeriod, slid + 0.001);
  EXPECT_LT(apart(viewOf(stands, slid + 0.5).left, viewOf(zoomed).left + 0.001), 1e-15);
  EXPECT_TRUE(follows.fitted().followsLine());
}

}  // namespace
}  // namespace asperity
