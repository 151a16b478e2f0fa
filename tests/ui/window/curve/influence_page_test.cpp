// The page of influences: it computes while it is seen.
#include "ui/window/curve/influence_page.h"

#include <gtest/gtest.h>

#include <QComboBox>

#include "tests/ui/window/curve/curve_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "ui/window/figures/diagram_view.h"

namespace asperity {
namespace {

using InfluencePageTest = CurveTest;

TEST_F(InfluencePageTest, InfluencesAreComputedWhileTheirTabIsSeen) {
  action("go:influencePage").trigger();
  auto& view = control<DiagramView>("influenceView");
  EXPECT_TRUE(view.placeholder().startsWith("The influences are being computed"));
  ASSERT_TRUE(waitFor([&] { return view.isPainted(); }));
  const QImage first = view.image();
  auto& choice = control<QComboBox>("influenceChoice");
  choice.setCurrentIndex(1);
  // The other diagram would pass for that of the wavelengths.
  EXPECT_TRUE(view.image().isNull());
  EXPECT_TRUE(view.placeholder().startsWith("The influences are being computed"));
  ASSERT_TRUE(waitFor([&] { return view.isPainted() && view.image() != first; }));
}

}  // namespace
}  // namespace asperity
