// The plan of a scene as a list: it follows the scene, and is whole in large letters.
#include "ui/window/accuracy/plan_list.h"

#include <gtest/gtest.h>

#include <QTreeWidget>

#include "core/scene/plan.h"
#include "tests/ui/window/main_window_fixture.h"
#include "tests/ui/window/qt_application.h"

namespace asperity {
namespace {

using PlanListTest = MainWindowTest;

TEST_F(PlanListTest, ThePlanFollowsTheScene) {
  auto& plan = control<QTreeWidget>("planList");
  const auto runs = [&](const QString& stage) {
    const auto found = plan.findItems(stage, Qt::MatchExactly);
    return found.isEmpty() ? QString() : found.first()->text(1);
  };
  EXPECT_EQ(plan.topLevelItemCount(), 0);  // nobody sees it, so that nothing waits for it
  action("go:planList").trigger();
  ASSERT_EQ(plan.topLevelItemCount(), static_cast<int>(kStages));
  EXPECT_EQ(runs(QString::fromStdString(std::string(stageName(Stage::Interface)))), "no");
  type("interface.friction_coefficient", "0.2");
  EXPECT_EQ(runs(QString::fromStdString(std::string(stageName(Stage::Interface)))), "yes");
}

TEST_F(PlanListTest, ThePlanIsWholeInAPresentation) {
  action("go:planList").trigger();
  auto& plan = control<QTreeWidget>("planList");
  for (const bool presenting : {true, false}) {
    window_.windowLayout().setPresenting(presenting);
    QCoreApplication::processEvents();
    const QFontMetrics metrics(plan.font());
    for (int row = 0; row < plan.topLevelItemCount(); ++row)
      for (const int column : {0, 1})
        EXPECT_GE(plan.columnWidth(column),
                  metrics.horizontalAdvance(plan.topLevelItem(row)->text(column)))
            << presenting << row;
  }
}

}  // namespace
}  // namespace asperity
