// The commands of the contact view: what they switch, their words and keys, and that keys change
// the scene as drags do.

#include <gtest/gtest.h>

#include <QAction>
#include <QSignalSpy>

#include "tests/ui/window/contact/contact_canvas_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "ui/window/contact/contact_canvas.h"

namespace asperity {
namespace {

using ContactViewActionsTest = ContactCanvasTest;

TEST_F(ContactViewActionsTest, CommandsSwitchAndShowWhatIsOn) {
  action("magnify").trigger();
  EXPECT_TRUE(canvas_.viewer().magnifies());
  EXPECT_TRUE(action("magnify").isChecked());
  action("followLine").trigger();
  EXPECT_TRUE(canvas_.viewer().navigation().followsLine());
  canvas_.magnify(false);
  EXPECT_FALSE(action("magnify").isChecked());
  action("steeper").trigger();
  EXPECT_FALSE(canvas_.viewer().navigation().hasFittedHeights());
  action("fitHeights").trigger();
  EXPECT_TRUE(canvas_.viewer().navigation().hasFittedHeights());
}

TEST_F(ContactViewActionsTest, ColoursAskForTheirFields) {
  QSignalSpy wanted(&canvas_, &ContactCanvas::fieldsChanged);
  menu_.findChild<QAction*>();
  const auto trigger = [this](const char* name) {
    for (QAction* one : canvas_.findChildren<QAction*>(name)) one->trigger();
  };
  trigger("overlay:power");
  EXPECT_EQ(canvas_.viewer().overlay(), ContactOverlay::Power);
  ASSERT_EQ(wanted.count(), 1);
  EXPECT_TRUE(wanted.back()[0].value<FrameFields>().power);
  action("nextOverlay").trigger();
  EXPECT_EQ(canvas_.viewer().overlay(), ContactOverlay::None);
  action("nextOverlay").trigger();
  EXPECT_EQ(canvas_.viewer().overlay(), ContactOverlay::Pressure);
  EXPECT_EQ(canvas_.fields(), FrameFields{});
}

TEST_F(ContactViewActionsTest, EveryCommandSaysWhatItDoesAndKeysAreTheirOwn) {
  QStringList keys;
  for (const QAction* one : canvas_.findChildren<QAction*>()) {
    if (one->isSeparator()) continue;
    EXPECT_FALSE(one->text().isEmpty());
    EXPECT_FALSE(one->toolTip().isEmpty());
    for (const QKeySequence& key : one->shortcuts()) keys += key.toString();
  }
  const auto count = keys.size();
  EXPECT_EQ(keys.removeDuplicates(), 0) << count;
}

TEST_F(DraggedCanvasTest, KeysDoAsDragsDo) {
  const Scene start = scene_;
  action("pressHarder").trigger();
  EXPECT_GT(scene_.load.normalForce, start.load.normalForce);
  EXPECT_TRUE(canvas_.accessibleDescription().contains("normal force"));
  action("pressLess").trigger();
  EXPECT_NEAR(scene_.load.normalForce, start.load.normalForce, 1e-3 * start.load.normalForce);
  action("slideFaster").trigger();
  EXPECT_GT(scene_.sliding.velocity, start.sliding.velocity);
  action("slideSlower").trigger();
  action("slideSlower").trigger();
  EXPECT_LT(scene_.sliding.velocity, start.sliding.velocity);
}

}  // namespace
}  // namespace asperity
