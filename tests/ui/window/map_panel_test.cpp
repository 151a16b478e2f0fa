// The tab of the map while its map is not that of the present scene: before a new one is computed,
// or where there cannot be one.
#include "ui/window/map/map_panel.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>

#include "tests/core/small_scene.h"
#include "tests/ui/window/qt_application.h"
#include "ui/window/map/map_view.h"

namespace asperity {
namespace {

constexpr int kMapPatience = 60000;  // ms, far more than anything here takes

class MapPanelTest : public testing::Test {
 protected:
  MapPanelTest() {
    panel_.resize(700, 500);
    panel_.show();
    panel_.showScene(scene_);
  }
  bool waitForMap() {
    return QTest::qWaitFor([&] { return panel_.map() && panel_.map()->isFinal; }, kMapPatience);
  }
  void moveCross() {
    emit panel_.view().crossMoved(2 * scene_.sliding.velocity, 2 * scene_.load.normalForce);
  }

  Scene scene_ = sceneOfSize(64, 9, 2);
  MapPanel panel_;
};

TEST_F(MapPanelTest, TheCrossSetsTwoParametersAndIsDescribed) {
  ASSERT_TRUE(waitForMap());
  QSignalSpy edited(&panel_, &MapPanel::sceneEdited);
  moveCross();
  ASSERT_EQ(edited.count(), 1);
  const Scene moved = edited.front().front().value<Scene>();
  EXPECT_NE(moved.load.normalForce, scene_.load.normalForce);
  const QString before = panel_.view().accessibleDescription();
  EXPECT_TRUE(before.contains("N")) << before.toStdString();
  panel_.showScene(moved);
  EXPECT_NE(panel_.view().accessibleDescription(), before);
}

/// What was changed since the map was computed would be lost.
TEST_F(MapPanelTest, TheCrossOfAnotherScenesMapDoesNotBringThatSceneBack) {
  ASSERT_TRUE(waitForMap());
  Scene without = scene_;
  without.accuracy.scheme = Scheme::Cubic;
  without.accuracy.targetRelativeError = 0.05;  // a scene that has no map
  panel_.showScene(without);
  QSignalSpy edited(&panel_, &MapPanel::sceneEdited);
  moveCross();
  EXPECT_EQ(edited.count(), 0);
}

/// The first map takes a while; an empty page would look as if there were none.
TEST_F(MapPanelTest, SaysThatTheFirstMapIsBeingComputed) {
  EXPECT_EQ(panel_.view().placeholder(), QStringLiteral("The map is being computed…"));
  ASSERT_TRUE(waitForMap());
  EXPECT_EQ(panel_.view().placeholder(), QString());
}

TEST_F(MapPanelTest, AHiddenMapIsNotComputedOn) {
  ASSERT_TRUE(waitForMap());
  const auto before = panel_.map();
  Scene other = scene_;
  other.surface.rmsHeight *= 2;
  panel_.showScene(other);
  panel_.hide();
  constexpr int kTime = 1000;  // ms; the first stage of this map takes far less
  EXPECT_FALSE(QTest::qWaitFor([&] { return panel_.map() != before; }, kTime));
}

}  // namespace
}  // namespace asperity
