// What drags in the picture of the contact change.
#include "ui/contact/contact_handles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/ui/contact/sample_frame.h"
#include "ui/draw/ticks.h"

namespace asperity {
namespace {

ContactPictureOptions usual() {
  ContactPictureOptions options;
  options.width = 1200;
  options.height = 600;
  return options;
}

Scene sceneWith(LoadKind kind) {
  Scene scene;
  scene.load.kind = kind;
  scene.load.normalForce = 0.02;
  scene.load.depth = 5e-7;
  scene.load.nominalPressure = 1e4;
  scene.sliding.velocity = 0.25;
  return scene;
}

TEST(ContactHandles, TheLoadsKindDecidesWhatABodyChanges) {
  EXPECT_EQ(draggedKey(ContactHandle::Body, sceneWith(LoadKind::Force)), "load.normal_force");
  EXPECT_EQ(draggedKey(ContactHandle::Force, sceneWith(LoadKind::Force)), "load.normal_force");
  EXPECT_EQ(draggedKey(ContactHandle::Body, sceneWith(LoadKind::Pressure)),
            "load.nominal_pressure");
  EXPECT_EQ(draggedKey(ContactHandle::Body, sceneWith(LoadKind::Indentation)), "load.depth");
  EXPECT_EQ(draggedKey(ContactHandle::Force, sceneWith(LoadKind::Indentation)), "");
  EXPECT_EQ(draggedKey(ContactHandle::Velocity, sceneWith(LoadKind::Force)), "sliding.velocity");
  EXPECT_EQ(draggedKey(ContactHandle::None, sceneWith(LoadKind::Force)), "");
}

/// A given indentation changes by what the pointer moves, so that the body stays under it.
TEST(ContactHandles, ABodyStaysUnderThePointer) {
  const Scene start = sceneWith(LoadKind::Indentation);
  const Scene deeper = dragged(start, ContactHandle::Body, {0, 0.1, 2e-6});
  EXPECT_NEAR(deeper.load.depth, start.load.depth + 0.1 * 2e-6, 1e-10);
  const Scene lifted = dragged(start, ContactHandle::Body, {0.5, -0.9, 2e-6});
  EXPECT_GT(lifted.load.depth, 0);
  EXPECT_LT(lifted.load.depth, 0.01 * start.load.depth);
}

/// Equal distances are equal factors, so that two drags are the same as one of their length.
TEST(ContactHandles, ForcesAndVelocitiesChangeByFactors) {
  const Scene start = sceneWith(LoadKind::Force);
  const auto force = [&](double down) {
    return dragged(start, ContactHandle::Force, {0, down, 1e-6}).load.normalForce;
  };
  EXPECT_GT(force(0.1), start.load.normalForce);
  EXPECT_LT(force(-0.1), start.load.normalForce);
  EXPECT_NEAR(force(0.3) * force(-0.3), start.load.normalForce * start.load.normalForce,
              1e-3 * start.load.normalForce * start.load.normalForce);
  const Scene once = dragged(start, ContactHandle::Velocity, {0.1, 0, 1e-6});
  const Scene twice = dragged(once, ContactHandle::Velocity, {0.1, 0, 1e-6});
  EXPECT_NEAR(twice.sliding.velocity,
              dragged(start, ContactHandle::Velocity, {0.2, 0, 1e-6}).sliding.velocity,
              1e-3 * twice.sliding.velocity);
  EXPECT_GT(once.sliding.velocity, start.sliding.velocity);
}

TEST(ContactHandles, WithoutAWayNothingChangesAndNoDragLeavesWhatIsAllowed) {
  Scene start = sceneWith(LoadKind::Force);
  start.load.normalForce = 0.0123456789;  // not even rounded
  EXPECT_EQ(dragged(start, ContactHandle::Body, {0.7, 0, 1e-6}), start);
  EXPECT_EQ(dragged(start, ContactHandle::Velocity, {0, 0.7, 1e-6}), start);
  for (const double far : {-1e3, 1e3})
    for (const ContactHandle handle :
         {ContactHandle::Body, ContactHandle::Force, ContactHandle::Velocity})
      for (const LoadKind kind : {LoadKind::Force, LoadKind::Indentation, LoadKind::Pressure}) {
        const Scene after = dragged(sceneWith(kind), handle, {far, far, 1e-6});
        EXPECT_TRUE(std::isfinite(after.load.normalForce + after.load.depth +
                                  after.load.nominalPressure + after.sliding.velocity));
        EXPECT_GT(after.load.depth, 0);
      }
}

TEST(ContactHandles, ALineAtRestIsStartedToTheRight) {
  Scene start = sceneWith(LoadKind::Force);
  start.sliding.velocity = 0;
  EXPECT_GT(dragged(start, ContactHandle::Velocity, {0.01, 0, 1e-6}).sliding.velocity, 0);
  EXPECT_EQ(dragged(start, ContactHandle::Velocity, {-0.1, 0, 1e-6}), start);
}

/// The label with the velocity, wherever the picture has it, drags the velocity; that of the
/// normal force the force.
TEST(ContactHandles, LabelsAndArrowsAreWhereTheyAreDrawn) {
  const auto frame = sampleFrame({});
  const ContactPictureOptions options = usual();
  const DrawList list = composeContact(*frame, options);
  const auto handleOf = [&](const std::string& part) {
    const Box plot = contactPlotArea(*frame, options);
    for (const DrawText& text : list.texts)
      if (text.utf8.find(part) != std::string::npos && text.y > plot.y && text.x > plot.x)
        return handleAt(*frame, options, text.x + 2, text.y - 3);
    ADD_FAILURE() << part;
    return ContactHandle::None;
  };
  EXPECT_EQ(handleOf("v = "), ContactHandle::Velocity);
  EXPECT_EQ(handleOf(" = " + quantity(frame->normalForce, "N")), ContactHandle::Force);
  for (const HandlePosition& place : contactHandles(*frame, options)) {
    EXPECT_GE(place.box.width, 12);
    EXPECT_EQ(handleAt(*frame, options, place.box.x + place.box.width / 2,
                       place.box.y + place.box.height / 2),
              place.handle);
  }
}

/// Everything on and above the line is the body; the gap, the elastomer and what is around the plot
/// only move the view.
TEST(ContactHandles, TheBodyBeginsAtTheLine) {
  const auto frame = sampleFrame({});
  const ContactPictureOptions options = usual();
  const Box plot = contactPlotArea(*frame, options);
  const ContactView view = resolvedView(*frame, options.view);
  int checked = 0;
  for (std::size_t i = 7; i < frame->lineHeight.size(); i += 31) {
    const auto x = static_cast<float>(
        plot.x + plot.width * (static_cast<double>(i) * frame->spacing - view.left) / view.width);
    const auto y = static_cast<float>(plot.y + plot.height * (view.top - frame->lineHeight[i]) /
                                                   (view.top - view.bottom));
    if (x < plot.x + 1 || x > plot.x + plot.width - 1) continue;
    if (y < plot.y + 4 || y + 20 > plot.y + plot.height) continue;
    EXPECT_NE(handleAt(*frame, options, x, y - 3), ContactHandle::None) << i;
    EXPECT_EQ(handleAt(*frame, options, x, y + 16), ContactHandle::None) << i;
    ++checked;
  }
  EXPECT_GT(checked, 5);
  EXPECT_EQ(handleAt(*frame, options, plot.x - 5, plot.y + 5), ContactHandle::None);
  EXPECT_EQ(handleAt(*frame, options, plot.x + 5, plot.y + plot.height + 9), ContactHandle::None);
}

/// The arrow shows the velocity at this moment, which is not the mean that the scene states.
TEST(ContactHandles, TheArrowOfAnOscillationSetsItsAmplitude) {
  Scene start = sceneWith(LoadKind::Force);
  start.sliding.kind = SlidingKind::Oscillation;
  start.sliding.velocity = 0;
  start.sliding.amplitude = 0.5;
  const Scene after = dragged(start, ContactHandle::Velocity, {0.1, 0, 1e-6});
  EXPECT_EQ(after.sliding.velocity, 0);
  EXPECT_GT(after.sliding.amplitude, 0.5);
}

}  // namespace
}  // namespace asperity
