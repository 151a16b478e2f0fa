// The tab of the map while its map is not that of the present scene: before a new one is computed,
// or where there cannot be one.
#include "ui/window/map/map_panel.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QSignalSpy>
#include <QTest>
#include <algorithm>

#include "tests/core/small_scene.h"
#include "tests/ui/window/qt_application.h"
#include "ui/panels/boxes.h"
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

/// A scene that is pressed by a pressure has no normal force to choose.
TEST_F(MapPanelTest, TheLoadIsTheVerticalAxisWhateverItsKind) {
  ASSERT_TRUE(waitForMap());
  const auto& y = *panel_.findChild<ChoiceBox*>("mapY");
  EXPECT_EQ(y.currentData().toString(), "load.normal_force");
  Scene pressed = scene_;
  pressed.load.kind = LoadKind::Pressure;
  pressed.load.nominalPressure = 1e5;
  panel_.showScene(pressed);
  EXPECT_EQ(y.currentData().toString(), "load.nominal_pressure");
}

/// What was changed since the map was computed would be lost.
TEST_F(MapPanelTest, TheCrossOfAnotherScenesMapDoesNotBringThatSceneBack) {
  ASSERT_TRUE(waitForMap());
  Scene other = scene_;
  other.surface.rmsHeight *= 2;
  panel_.showScene(other);
  QSignalSpy edited(&panel_, &MapPanel::sceneEdited);
  moveCross();
  EXPECT_EQ(edited.count(), 0);
}

/// The first map takes a while; an empty page would look as if there were none.
TEST_F(MapPanelTest, SaysThatTheFirstMapIsBeingComputed) {
  EXPECT_EQ(panel_.view().placeholder(), QStringLiteral("The map is being computed…"));
  ASSERT_TRUE(waitForMap());
  EXPECT_EQ(panel_.view().placeholder(), QString());
  EXPECT_TRUE(panel_.findChild<QLabel*>("mapProgress")->text().endsWith("100 %"));
}

/// A stage is the mean of fewer lines than its scene states, so a file of it would be wrong.
TEST_F(MapPanelTest, AMapCanBeSavedOnceItIsComplete) {
  Scene many = scene_;
  many.surface.elements = 512;
  many.ensemble.realizations = 8;
  panel_.showScene(many);
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return panel_.map() && !panel_.map()->isFinal; }, kMapPatience));
  EXPECT_TRUE(panel_.view().files().isEmpty());
  EXPECT_EQ(panel_.view().focusPolicy(), Qt::StrongFocus) << "its cross moves by keys";
  ASSERT_TRUE(waitForMap());
  EXPECT_FALSE(panel_.view().files().isEmpty());
}

/// All cells have the stated lines; the document keeps its target.
TEST_F(MapPanelTest, ASceneWithATargetHasAMapOfItsStatedLines) {
  ASSERT_TRUE(waitForMap());
  const auto& message = *panel_.findChild<QLabel*>("mapMessage");
  EXPECT_FALSE(message.isVisible());
  Scene target = scene_;
  target.accuracy.scheme = Scheme::Cubic;
  target.accuracy.targetRelativeError = 0.05;
  target.surface.rmsHeight *= 2;
  panel_.showScene(target);
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        return panel_.map()->isFinal &&
               panel_.map()->scene.surface.rmsHeight > scene_.surface.rmsHeight;
      },
      kMapPatience));
  EXPECT_EQ(panel_.map()->points.front().realizations, scene_.ensemble.realizations);
  EXPECT_TRUE(message.isVisible());
  EXPECT_TRUE(message.text().contains("target error")) << message.text().toStdString();
  QSignalSpy edited(&panel_, &MapPanel::sceneEdited);
  moveCross();
  ASSERT_EQ(edited.count(), 1);
  EXPECT_EQ(edited.front().front().value<Scene>().accuracy.targetRelativeError, 0.05);
}

/// Over the map it would hide cells.
TEST_F(MapPanelTest, TheReadingStandsBesideTheCut) {
  ASSERT_TRUE(waitForMap());
  MapView& view = panel_.view();
  ASSERT_TRUE(QTest::qWaitFor([&] { return view.isPainted() && view.frames().size() == 2; }));
  const QImage before = view.grab().toImage();
  view.setReading("12.3 mm/s, 3.4 mN: 0.00123");
  const QRectF place = view.placeBesideCut();
  ASSERT_FALSE(place.isEmpty());
  const QRect map = view.frames().back().area.toRect();
  const QImage after = view.grab().toImage();
  EXPECT_NE(before, after);
  EXPECT_EQ(before.copy(map), after.copy(map));
  EXPECT_FALSE(place.intersects(map));
}

/// In a low view, map and cut stand beside each other, and the reading would lie over the axis.
TEST_F(MapPanelTest, TheReadingOfALowViewIsNotBetweenCutAndMap) {
  panel_.resize(640, 230);
  ASSERT_TRUE(waitForMap());
  MapView& view = panel_.view();
  const auto areSideBySide = [&] {
    return view.isPainted() && view.frames().size() == 2 &&
           view.frames().front().area.right() < view.frames().back().area.left();
  };
  ASSERT_TRUE(QTest::qWaitFor(areSideBySide));
  view.setReading("12.3 mm/s, 3.4 mN: 0.00123");
  EXPECT_TRUE(view.placeBesideCut().isEmpty());
}

/// A short name leaves its space to a long one.
TEST_F(MapPanelTest, NamesAreWholeWhereThereIsRoom) {
  panel_.resize(900, 500);
  auto& y = *panel_.findChild<ChoiceBox*>("mapY");
  int longest = 0;
  for (int i = 0; i < y.count(); ++i)
    if (y.itemText(i).size() > y.itemText(longest).size()) longest = i;
  y.setCurrentIndex(longest);
  QTest::qWait(1);
  for (const char* name : {"mapX", "mapY", "mapQuantity"}) {
    const auto& box = *panel_.findChild<ChoiceBox*>(name);
    EXPECT_GE(box.width(), std::min(box.sizeHint().width(), box.maximumWidth())) << name;
  }
}

TEST_F(MapPanelTest, TheWordBeforeTheQuantityGivesWayToNames) {
  const auto& quantity = *panel_.findChild<ChoiceBox*>("mapQuantity");
  const auto isNamed = [&] {
    for (const auto* label : panel_.findChildren<QLabel*>())
      if (label->buddy() == &quantity) return label->isVisible();
    return false;
  };
  const auto areWhole = [&] {
    for (const char* name : {"mapX", "mapY", "mapQuantity"}) {
      const auto& box = *panel_.findChild<ChoiceBox*>(name);
      if (box.width() < box.sizeHint().width()) return false;
    }
    return true;
  };
  int narrowest = 900;  // in which all is whole
  for (panel_.resize(900, 300); isNamed(); panel_.resize(panel_.width() - 4, 300)) {
    QTest::qWait(1);
    ASSERT_TRUE(!isNamed() || areWhole()) << panel_.width();
    narrowest = panel_.width();
  }
  QTest::qWait(1);
  EXPECT_TRUE(areWhole()) << "without the word there is room";
  panel_.resize(narrowest, 300);
  EXPECT_TRUE(isNamed());
}

TEST_F(MapPanelTest, ALabelIsNearerToItsListThanToTheOneBefore) {
  int before = 0, labels = 0;  // right end of the list before; number of labels with one
  for (const auto* label : panel_.findChildren<QLabel*>()) {
    const QWidget* list = label->buddy();
    if (!list) continue;
    if (before > 0) {
      EXPECT_GT(label->x() - before, list->x() - label->geometry().right());
    }
    before = list->geometry().right();
    ++labels;
  }
  EXPECT_EQ(labels, 3);
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
