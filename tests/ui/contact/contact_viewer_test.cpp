// Looking around in the contact, without a widget.
#include "ui/contact/contact_viewer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/ui/contact/sample_frame.h"

namespace asperity {
namespace {

std::shared_ptr<const Frame> frameAt(double distance, int points = 500) {
  SampleOptions options;
  options.points = points;
  options.distance = distance;
  return sampleFrame(options);
}

ContactViewer viewerOf(std::shared_ptr<const Frame> frame) {
  ContactViewer viewer;
  viewer.setFrame(std::move(frame));
  return viewer;
}

TEST(ContactViewer, ShowsEverythingAtFirst) {
  const auto frame = frameAt(0);
  const ContactPictureOptions options = viewerOf(frame).options();
  EXPECT_NEAR(options.view.width, frame->length, 1e-15);
  EXPECT_EQ(options.view.bottom, fittedView(*frame).bottom);
  EXPECT_EQ(options.overlay, ContactOverlay::Pressure);
  EXPECT_FALSE(options.probe || options.magnifier);
  EXPECT_EQ(viewerOf(frame).fields(), FrameFields{});
}

TEST(ContactViewer, FitsANewScenesHeightsWhileItIsZoomed) {
  ContactViewer viewer = viewerOf(frameAt(0));
  viewer.zoom({0.5, 0.5}, 4);
  SampleOptions rougher;
  rougher.points = 500;
  rougher.rmsHeight = 5e-6;
  const auto next = sampleFrame(rougher);
  viewer.setFrame(next);
  const ContactView view = viewer.options().view, whole = fittedView(*next);
  EXPECT_LT(view.width, 0.5 * next->length);
  EXPECT_GE(view.bottom, whole.bottom);
  EXPECT_LE(view.top, whole.top);
  EXPECT_GT(view.top - view.bottom, 0.2 * (whole.top - whole.bottom));
}

/// Nothing is hidden beside it, and its positions begin at 0.
TEST(ContactViewer, AViewOfTheWholePeriodKeepsItsAxis) {
  ContactViewer viewer = viewerOf(frameAt(0));
  viewer.pan(0.15, 0);
  EXPECT_TRUE(viewer.navigation().isFitted());
  viewer.zoom({0.5, 0.5}, 4);
  const double left = viewer.options().view.left;
  viewer.pan(0.15, 0);
  EXPECT_LT(viewer.options().view.left, left);
}

TEST(ContactViewer, AnotherLengthIsShownAsAWhole) {
  ContactViewer viewer = viewerOf(frameAt(0));
  viewer.zoom({0.5, 0.5}, 4);
  SampleOptions longer;
  longer.points = 500;
  longer.length = 0.1;
  viewer.setFrame(sampleFrame(longer));
  EXPECT_NEAR(viewer.options().view.width, 0.1, 1e-12);
}

/// Another scene, the end of settling and the beginning of a motion have a scale of their own;
/// within each of them it keeps still.
TEST(ContactViewer, ColoursRememberNothingOfWhatWasShownBefore) {
  const auto frame = [](double greatest, std::uint64_t scene, bool settles, double time) {
    Frame made = *frameAt(0);
    for (std::vector<double>* values : {&made.power, &made.sinceContact})
      values->assign(made.pressure.size(), greatest * 1e-3);
    made.pressure.assign(made.pressure.size(), greatest);
    made.sceneNumber = scene;
    made.isSettling = settles;
    made.time = time;
    return std::make_shared<const Frame>(made);
  };
  const auto ends = [](const ContactViewer& viewer) {
    const ContactView view = viewer.options().view;
    return std::array{view.pressure, view.age, view.power};
  };
  const auto fresh = ends(viewerOf(frame(1, 1, false, 0)));
  ContactViewer viewer = viewerOf(frame(2, 1, false, 0));
  viewer.setFrame(frame(1, 1, false, 1));
  EXPECT_NE(ends(viewer), fresh) << "it keeps still";
  viewer.setFrame(frame(1, 2, false, 1));
  EXPECT_EQ(ends(viewer), fresh) << "another scene";
  viewer.setFrame(frame(2, 3, true, 1));
  viewer.setFrame(frame(1, 3, true, 2));
  EXPECT_NE(ends(viewer), fresh);
  viewer.setFrame(frame(1, 3, false, 3));
  EXPECT_EQ(ends(viewer), fresh) << "settled";
  viewer.setFrame(frame(2, 3, false, 4));
  viewer.setFrame(frame(1, 3, false, 0));
  EXPECT_EQ(ends(viewer), fresh) << "begun anew";
}

TEST(ContactViewer, ZoomingOutEndsWithEverything) {
  ContactViewer viewer = viewerOf(frameAt(0));
  viewer.zoom({0.2, 0.3}, 5);
  viewer.exaggerate({0.5, 0.5}, 2);
  for (int i = 0; i < 6; ++i) viewer.zoom({0.9, 0.9}, -1);
  EXPECT_TRUE(viewer.navigation().isFitted());
}

TEST(ContactViewer, NeverShowsLessThanAFewElements) {
  const auto frame = frameAt(0);
  ContactViewer viewer = viewerOf(frame);
  for (int i = 0; i < 100; ++i) viewer.zoom({0.4, 0.4}, 3);
  EXPECT_GT(viewer.options().view.width, 5 * frame->spacing);
}

/// The crosshair stays under the cursor while the line moves, on the elastomer where it stands
/// still in the picture, along with the line where that is followed.
TEST(ContactViewer, CrosshairStaysUnderTheCursor) {
  ContactViewer viewer = viewerOf(frameAt(0));
  viewer.pointAt(ViewPosition{0.3, 0.5});
  const double before = *viewer.pointer();
  viewer.setFrame(frameAt(1e-3));
  EXPECT_EQ(*viewer.pointer(), before);
  viewer.follow(true);
  viewer.setFrame(frameAt(2e-3));
  EXPECT_NEAR(*viewer.pointer(), before + 1e-3, 1e-12);
  EXPECT_TRUE(viewer.fields().lineSlope);
  viewer.pointAt({});
  EXPECT_FALSE(viewer.reading());
  EXPECT_FALSE(viewer.fields().lineSlope);
}

TEST(ContactViewer, KeysMoveTheCrosshairElementByElement) {
  const auto frame = frameAt(0);
  ContactViewer viewer = viewerOf(frame);
  viewer.movePointer(0);
  const std::size_t first = viewer.reading()->point;
  EXPECT_NEAR(static_cast<double>(first), 250, 1);
  viewer.movePointer(3);
  EXPECT_EQ(viewer.reading()->point, first + 3);
  viewer.movePointer(-10);
  EXPECT_EQ(viewer.reading()->point, first - 7);
  for (int i = 0; i < 500; ++i) {  // once around, always in sight
    viewer.movePointer(1);
    const ContactView view = viewer.options().view;
    ASSERT_GE(*viewer.pointer(), view.left - frame->spacing);
    ASSERT_LE(*viewer.pointer(), view.left + view.width + frame->spacing);
  }
}

TEST(ContactViewer, MagnifierFindsTheAsperityPressedMostAndGoesWithIt) {
  const auto first = frameAt(0);
  const auto most = std::max_element(first->pressure.begin(), first->pressure.end());
  ContactViewer viewer = viewerOf(first);
  viewer.magnify(true);
  const double at = viewer.options().magnifier->position;
  EXPECT_NEAR(at, first->spacing * static_cast<double>(most - first->pressure.begin()), 1e-12);
  for (int i = 1; i <= 40; ++i) viewer.setFrame(frameAt(i * 1e-4));
  EXPECT_NEAR(std::remainder(viewer.options().magnifier->position - at - 4e-3, first->length), 0,
              1.5 * first->spacing);
}

/// A line that slides on leaves the view at one end and enters it again at the other.
TEST(ContactViewer, TheMagnifiedAsperityIsAlwaysInTheView) {
  ContactViewer viewer = viewerOf(frameAt(0));
  viewer.magnify(true);
  const auto isInView = [&] {
    const ContactPictureOptions shown = viewer.options();
    const double from = shown.magnifier->position - shown.view.left;
    return from >= 0 && from <= shown.view.width;
  };
  for (int i = 1; i <= 60; ++i) {
    viewer.setFrame(frameAt(i * 1e-3));  // three periods
    ASSERT_TRUE(isInView()) << i;
  }
  // Also in a part of the period, which it leaves for good, while no frame comes, and without
  // contact.
  for (const double x : {0.0, 0.3, 0.6, 1.0}) {
    viewer.fit();
    viewer.zoom({x, 0.5}, 6);
    ASSERT_TRUE(isInView()) << x;
  }
  viewer.setFrame(frameAt(0.061));
  EXPECT_TRUE(isInView());
}

TEST(ContactViewer, MagnifierFollowsTheCrosshair) {
  ContactViewer viewer = viewerOf(frameAt(0));
  viewer.magnify(true);
  viewer.pointAt(ViewPosition{0.25, 0.5});
  EXPECT_EQ(viewer.options().magnifier->position, *viewer.pointer());
}

TEST(ContactViewer, BearsFramesWithoutPoints) {
  ContactViewer viewer;
  viewer.zoom({}, 3);
  viewer.follow(true);
  viewer.movePointer(2);
  viewer.magnify(true);
  viewer.setFrame(std::make_shared<const Frame>());
  viewer.movePointer(2);
  viewer.pointAt(ViewPosition{});
  EXPECT_GT(viewer.options().view.width, 0);
  EXPECT_FALSE(viewer.reading());
}

}  // namespace
}  // namespace asperity
