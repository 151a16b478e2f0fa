// Nothing is animated where nobody sees it. A covered window is tested by covered_window.cpp on a
// display.
#include "ui/window/main/window_visibility.h"

#include <gtest/gtest.h>

#include "tests/ui/window/main_window_fixture.h"
#include "tests/ui/window/qt_application.h"

namespace asperity {
namespace {

using WindowVisibilityTest = MainWindowTest;

/// The curve, which is kept, goes on; and the picture where it was, once it is seen again.
TEST_F(WindowVisibilityTest, NothingIsSteppedWhereNobodySeesIt) {
  ASSERT_TRUE(waitFor([&] { return frame() && frame()->step > 3; }));
  const auto expectRest = [&](const char* where) {
    ASSERT_TRUE(waitForRest());
    const std::uint64_t step = frame()->step;
    for (int i = 0; i < 3; ++i) ASSERT_TRUE(waitForRest());
    EXPECT_EQ(frame()->step, step) << where;
    EXPECT_TRUE(session().isPlaying()) << where;
  };
  window_.showMinimized();
  ASSERT_TRUE(waitFor([&] { return !session().isVisible(); }));
  expectRest("minimized");
  type("elastomer.shear_modulus", "20 MPa");
  ASSERT_TRUE(waitFor([&] { return session().friction().progress() >= 1; }));
  EXPECT_EQ(session().curve()->scene->elastomer.shearModulus, 2e7);
  window_.showNormal();
  ASSERT_TRUE(waitFor([&] { return session().isVisible(); }));
  const std::uint64_t step = frame()->step;
  ASSERT_TRUE(waitFor([&] { return frame()->step > step + 3; }));

  action("figures").trigger();
  ASSERT_FALSE(session().isVisible());
  expectRest("behind the figures");
  action("figures").trigger();
  ASSERT_TRUE(session().isVisible());
  const std::uint64_t behind = frame()->step;
  ASSERT_TRUE(waitFor([&] { return frame()->step > behind + 3; }));
}

}  // namespace
}  // namespace asperity
