// The box that says with which setting the friction curve is compared.
#include "ui/window/accuracy/comparison_box.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QSignalSpy>
#include <QSpinBox>

#include "tests/ui/window/qt_application.h"

namespace asperity {
namespace {

class ComparisonBoxTest : public testing::Test {
 protected:
  template <class Control>
  Control& control(const char* name) {
    return *box_.findChild<Control*>(QLatin1String(name));
  }

  ComparisonBox box_;
  QSignalSpy changed_{&box_, &ComparisonBox::settingChanged};
};

TEST_F(ComparisonBoxTest, SaysWithWhatTheCurveIsCompared) {
  EXPECT_FALSE(box_.setting());
  control<QCheckBox>("comparisonWanted").setChecked(true);
  EXPECT_EQ(box_.setting(), CurveSetting{});
  control<QComboBox>("comparisonScheme").setCurrentIndex(static_cast<int>(Scheme::Nodal));
  EXPECT_EQ(box_.setting()->oversampling, 1);
  EXPECT_FALSE(control<QSpinBox>("comparisonOversampling").isEnabled());
  control<QSpinBox>("comparisonLines").setValue(1);
  EXPECT_EQ(control<QSpinBox>("comparisonLines").suffix(), " line");
  control<QSpinBox>("comparisonLines").setValue(7);
  EXPECT_EQ(control<QSpinBox>("comparisonLines").suffix(), " lines");
  EXPECT_EQ(box_.setting()->realizations, 7);
  EXPECT_EQ(changed_.count(), 4);
}

/// Fewer lines would add their own scatter to the difference; but a chosen number stays.
TEST_F(ComparisonBoxTest, HasTheLinesOfTheSceneUnlessOthersAreChosen) {
  control<QCheckBox>("comparisonWanted").setChecked(true);
  for (const int lines : {40, 9}) {
    box_.suggestLines(lines);
    EXPECT_EQ(box_.setting()->realizations, lines);
  }
  control<QSpinBox>("comparisonLines").setValue(7);
  box_.suggestLines(40);
  EXPECT_EQ(box_.setting()->realizations, 7);
}

TEST_F(ComparisonBoxTest, ATargetAccuracyLeavesNothingToCompareWith) {
  auto& wanted = control<QCheckBox>("comparisonWanted");
  wanted.setChecked(true);
  changed_.clear();
  box_.allow(false);
  EXPECT_FALSE(box_.setting());
  EXPECT_TRUE(wanted.text().contains("only without a target accuracy"));
  box_.allow(true);
  EXPECT_TRUE(box_.setting()) << "the choice is kept";
  EXPECT_EQ(changed_.count(), 2);
}

}  // namespace
}  // namespace asperity
