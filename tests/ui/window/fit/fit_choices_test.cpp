// The choices for a fit: which parameters are offered under which names, and what is said of
// limits.
#include "ui/window/fit/fit_choices.h"

#include <gtest/gtest.h>

#include <QTableWidget>

#include "tests/ui/window/fit/fit_page_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "ui/window/fit/fit_page.h"

namespace asperity {
namespace {

using FitChoicesTest = FitPageTest;

TEST_F(FitChoicesTest, TheNamesOfTheParametersAreNotCut) {
  Scene scene = withData();
  scene.elastomer.rheology = Rheology::StandardSolid;
  FitPage& page = openPage(scene);
  ASSERT_TRUE(waitFor([&] { return page.isVisible(); }));
  QTableWidget& keys = keysOf(page);
  const QAbstractItemView& view = keys;
  EXPECT_GE(keys.columnWidth(0), view.sizeHintForColumn(0));
}

/// Measured friction always has local friction, so it is offered where the scene has none yet.
TEST_F(FitChoicesTest, LocalFrictionIsOfferedFromNone) {
  FitPage& page = openPage(withData());
  EXPECT_GE(rowOf(keysOf(page), "interface.friction_coefficient"), 0);
  EXPECT_LT(rowOf(keysOf(page), "interface.shear_stress"), 0) << "has no value to begin from";
}

TEST_F(FitChoicesTest, TheLawOfALocalShearIsOfferedWhereThereIsOne) {
  Scene scene = withData();
  scene.interface.shearVelocity = 0.1;
  scene.interface.shearWidth = 0.3;
  const auto isOffered = [](FitPage& page) {
    return rowOf(keysOf(page), "interface.shear_width") >= 0 &&
           rowOf(keysOf(page), "interface.shear_velocity") >= 0;
  };
  for (const double coefficient : {0.0, 0.2}) {
    scene.interface.frictionCoefficient = coefficient;
    FitPage& page = openPage(scene);
    EXPECT_LT(rowOf(keysOf(page), "interface.shear_width"), 0) << coefficient;
    EXPECT_LT(rowOf(keysOf(page), "interface.shear_velocity"), 0) << coefficient;
    EXPECT_GE(rowOf(keysOf(page), "interface.friction_coefficient"), 0) << coefficient;
  }
  scene.interface.frictionCoefficient = 0;
  scene.interface.shearStress = 10;
  EXPECT_TRUE(isOffered(openPage(scene)));
  scene.interface.shearVelocity = 0;
  EXPECT_LT(rowOf(keysOf(openPage(scene)), "interface.shear_width"), 0);
}

TEST_F(FitChoicesTest, ARefusedLimitIsSaidAndNothingRuns) {
  FitPage& page = openPage(withData());
  tick(page, "surface.rms_height");
  const int row = rowOf(keysOf(page), "surface.rms_height");
  keysOf(page).item(row, 2)->setText("3 kg");
  EXPECT_FALSE(page.errorText().isEmpty());
  button(page, "fitRun").click();
  EXPECT_FALSE(page.isFitting());
  // The scene's own value lies outside of these.
  keysOf(page).item(row, 2)->setText("1 m");
  keysOf(page).item(row, 3)->setText("2 m");
  button(page, "fitRun").click();
  EXPECT_FALSE(page.isFitting());
  EXPECT_FALSE(page.errorText().isEmpty());
}

}  // namespace
}  // namespace asperity
