// What the window shows of a frame: a contact of the scene before is dimmed and says so.
#include "ui/window/main/frame_display.h"

#include <gtest/gtest.h>

#include <QProgressBar>
#include <QToolButton>

#include "tests/core/elastomers.h"
#include "tests/ui/window/main_window_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "ui/window/curve/curve_reading.h"
#include "ui/window/main/status_line.h"

namespace asperity {
namespace {

using FrameDisplayTest = MainWindowTest;

/// There is no work on a scene that cannot be computed, and the contact is still the previous one.
TEST_F(FrameDisplayTest, ARefusedSceneIsNoWorkAndItsContactIsDimmed) {
  ASSERT_TRUE(waitFor([this] { return session().friction().progress() >= 1; }));
  ASSERT_TRUE(waitForFrame());
  Scene scene = session().scene();
  scene.elastomer = prony(0, {});
  window_.document().edit(scene);
  ASSERT_TRUE(waitFor([this] { return window_.messages().isVisible(); }));
  const auto& progress = control<QProgressBar>("workProgress");
  EXPECT_TRUE(waitFor([&] { return !progress.isVisible(); }));
  EXPECT_FALSE(control<QToolButton>("workStop").isVisible());
  const auto& veil = control<QLabel>("contactVeil");
  EXPECT_TRUE(veil.isVisible());
  EXPECT_TRUE(veil.text().contains("previous scene"));
  EXPECT_TRUE(session().friction().marker()->isFaded);
  const auto areReadingsFaded = [this] {
    return !control<QLabel>("factMu").isEnabled() && !control<QLabel>("factForce").isEnabled() &&
           !control<QLabel>("factRegime").isEnabled();
  };
  EXPECT_TRUE(areReadingsFaded());
  EXPECT_TRUE(waitFor([&] { return fact("factSimulations").isEmpty(); }));
  action("undo").trigger();
  EXPECT_TRUE(waitFor([&] { return !veil.isVisible(); }));
  EXPECT_TRUE(waitFor([&] { return !session().friction().marker()->isFaded; }));
  EXPECT_FALSE(areReadingsFaded());
}

/// A line of 2^21 elements takes its time on any machine, and leaving it does not.
TEST_F(FrameDisplayTest, WhatIsOfTheSceneBeforeSaysSo) {
  ASSERT_TRUE(waitFor([this] { return session().friction().progress() >= 1; }));
  ASSERT_TRUE(waitForFrame());
  auto& veil = control<QLabel>("contactVeil");
  EXPECT_FALSE(veil.isVisible());
  const auto marker = [this] { return *session().friction().marker(); };
  EXPECT_FALSE(marker().isFaded);
  Scene scene = session().scene();
  scene.surface.elements = 2097152;
  window_.document().edit(scene);
  ASSERT_TRUE(waitFor([&] { return veil.isVisible(); }));
  EXPECT_EQ(veil.size(), window_.canvas().size());
  EXPECT_TRUE(marker().isFaded);
  EXPECT_EQ(marker().name.english(), "before the change");
  action("undo").trigger();
  ASSERT_TRUE(waitFor([&] { return !veil.isVisible(); }));
  EXPECT_FALSE(marker().isFaded);
}

/// While time is paused no further frame makes up for what the first one could not know.
TEST_F(FrameDisplayTest, WhilePausedTheReadingsAreThoseOfTheWholeCurve) {
  ASSERT_TRUE(waitForFrame());
  session().setPlaying(false);
  Scene scene = smallScene();
  scene.ensemble.realizations = 200;
  scene.load.normalForce = 0.05;
  scene.sliding.velocity = 0.01;
  window_.document().edit(scene);
  ASSERT_TRUE(waitForFrame());
  ASSERT_TRUE(waitForRest());
  ASSERT_TRUE(waitFor([&] { return session().averaging() == Session::Averaging::Done; }));
  const CurveReading reading = readCurve(*frame(), session().curve());
  ASSERT_FALSE(reading.regime.isEmpty());
  EXPECT_EQ(fact("factRegime"), reading.regime);
  StatusLine expected;
  expected.showFrame(*frame(), reading);
  EXPECT_EQ(fact("factMu"), expected.findChild<QLabel*>("factMu")->text());
}

}  // namespace
}  // namespace asperity
