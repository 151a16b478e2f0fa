// The guided tour: every step runs, what is tried in it is play, and it is offered once.
#include "ui/window/main/tour.h"

#include <gtest/gtest.h>

#include <QDialog>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QToolButton>
#include <cmath>
#include <set>

#include "tests/ui/window/main_window_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "ui/window/main/message_bar.h"
#include "ui/window/main/scene_document.h"
#include "ui/window/main/scene_library.h"

namespace asperity {
namespace {

class TourTest : public MainWindowTest {
 protected:
  TourTest() { QSettings().clear(); }

  QWidget& bar() { return control<QWidget>("tourBar"); }
  QPushButton& button(const char* name) { return control<QPushButton>(name); }
  QString said() { return control<QLabel>("tourText").text(); }
  void click(const char* name) { QTest::mouseClick(&button(name), Qt::LeftButton); }
};

TEST_F(TourTest, SixStepsEachWithASceneThatRuns) {
  ASSERT_EQ(Tour::steps().size(), 6U);
  EXPECT_FALSE(bar().isVisible());
  action("tour").trigger();
  EXPECT_TRUE(bar().isVisible());
  for (std::size_t i = 0; i < Tour::steps().size(); ++i) {
    const TourStep& step = Tour::steps()[i];
    EXPECT_EQ(window_.document().origin().shipped, step.scene);
    EXPECT_TRUE(said().contains(QStringLiteral("%1 of 6").arg(i + 1)));
    EXPECT_TRUE(said().contains(Tour::tr(step.title)));
    ASSERT_TRUE(waitForFrame()) << step.scene;
    EXPECT_TRUE(frameError(*frame()).empty()) << step.scene;
    EXPECT_EQ(button("tourBack").isEnabled(), i > 0);
    EXPECT_EQ(button("tourNext").isEnabled(), i + 1 < Tour::steps().size());
    if (i + 1 < Tour::steps().size()) click("tourNext");
  }
  click("tourEnd");
  EXPECT_FALSE(bar().isVisible());
  EXPECT_FALSE(window_.tour().isRunning());
}

TEST_F(TourTest, GoesForwardAndBackByKeys) {
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  EXPECT_FALSE(action("tourStepNext").isEnabled());
  action("tour").trigger();
  QTest::keyClick(&window_, Qt::Key_Right, Qt::AltModifier);
  QTest::keyClick(&window_, Qt::Key_Right, Qt::AltModifier);
  EXPECT_TRUE(said().contains("3 of 6"));
  QTest::keyClick(&window_, Qt::Key_Left, Qt::AltModifier);
  EXPECT_TRUE(said().contains("2 of 6"));
}

/// Who clicks on "Next" again and again finds it in the same place.
TEST_F(TourTest, TheButtonsStayWhereTheyAre) {
  window_.resize(900, 700);
  action("tour").trigger();
  const auto place = [&] { return button("tourNext").mapTo(&window_, QPoint()); };
  std::set<int> needed;
  const auto settle = [&] {
    QCoreApplication::sendPostedEvents();
    QCoreApplication::processEvents();
    const auto& text = control<QLabel>("tourText");
    needed.insert(text.heightForWidth(text.width()));
  };
  ASSERT_TRUE(waitForFrame());
  settle();
  needed.clear();
  const QPoint first = place();
  for (std::size_t i = 0; i + 1 < Tour::steps().size(); ++i) {
    action("tourStepNext").trigger();
    settle();
    EXPECT_EQ(place(), first) << i;
    EXPECT_LE(*needed.rbegin(), control<QLabel>("tourText").height());
  }
}

TEST_F(TourTest, WhatIsTriedIsNotAskedAbout) {
  action("tour").trigger();
  answer(QMessageBox::Cancel);
  press("load.normal_force");
  click("tourNext");
  EXPECT_TRUE(said().contains("2 of 6"));
  EXPECT_FALSE(window_.isWindowModified());
  press("load.normal_force");
  action("scene:figure_2").trigger();
  EXPECT_EQ(asked_, 0);
  EXPECT_FALSE(window_.tour().isRunning());
  EXPECT_FALSE(bar().isVisible());
  EXPECT_TRUE(session().scene().title.starts_with("Figure 2"));
  action("undo").trigger();
  EXPECT_EQ(session().scene(), smallScene());
}

/// However it ends, it leaves scene, changes and history as they were.
TEST_F(TourTest, ItsEndBringsBackTheOwnScene) {
  press("load.normal_force");
  const Scene own = session().scene();
  answer(QMessageBox::Cancel);
  for (const bool isCancelled : {false, true}) {
    action("tour").trigger();
    EXPECT_NE(session().scene(), own);
    press("sliding.velocity");
    if (!isCancelled)
      while (button("tourNext").isEnabled()) click("tourNext");
    click("tourEnd");
    EXPECT_FALSE(window_.tour().isRunning());
    EXPECT_EQ(session().scene(), own);
    EXPECT_EQ(window_.panel().scene(), own);
    EXPECT_EQ(window_.document().history().count(), 1);
  }
  EXPECT_EQ(asked_, 0);
  action("undo").trigger();
  EXPECT_EQ(session().scene(), smallScene());
}

/// The frame surrounds the row that the step speaks of, wherever the row goes.
TEST_F(TourTest, AFrameSurroundsTheControlOfEachStep) {
  auto& halo = control<QWidget>("halo");
  EXPECT_FALSE(halo.isVisible());
  action("tour").trigger();
  const auto surrounds = [&](const char* key) {
    auto& row = control<QWidget>(QStringLiteral("row:") + key);
    return waitFor([&] {
      const QRect place(row.mapTo(&window_, QPoint()), row.size());
      return halo.isVisible() && halo.geometry().contains(place.center()) &&
             halo.geometry().left() <= place.left() && halo.geometry().top() <= place.top() &&
             halo.width() < place.width() + 30 && halo.height() < place.height() + 30;
    });
  };
  for (std::size_t i = 0; i < Tour::steps().size(); ++i) {
    EXPECT_TRUE(surrounds(Tour::steps()[i].key)) << Tour::steps()[i].key;
    if (i + 1 < Tour::steps().size()) click("tourNext");
  }
  window_.resize(window_.width() + 120, window_.height() - 60);
  EXPECT_TRUE(surrounds(Tour::steps().back().key)) << "after a resize";
  EXPECT_EQ(window_.childAt(halo.geometry().center()) == &halo, false) << "takes no mouse";
  window_.findChild<QWidget*>("parameterDock")->hide();
  EXPECT_TRUE(waitFor([&] { return !halo.isVisible(); }));
  window_.findChild<QWidget*>("parameterDock")->show();
  EXPECT_TRUE(surrounds(Tour::steps().back().key)) << "when the panel is back";
  click("tourEnd");
  EXPECT_TRUE(waitFor([&] { return !halo.isVisible(); }));
}

TEST_F(TourTest, IsOfferedUntilTaken) {
  auto& hint = control<MessageBar>("hintBar");
  EXPECT_FALSE(hint.isVisible());
  window_.tour().offer();
  EXPECT_TRUE(hint.isVisible());
  EXPECT_FALSE(window_.tour().isRunning());  // offered, not forced
  QTest::mouseClick(hint.findChild<QPushButton*>("acceptOffer"), Qt::LeftButton);
  EXPECT_TRUE(window_.tour().isRunning());
  EXPECT_FALSE(hint.isVisible());
  window_.tour().offer();
  EXPECT_FALSE(hint.isVisible());
}

/// In a low window the offer and a long description would leave the contact too low for its labels.
TEST_F(TourTest, TheOfferShortensTheDescriptionInALowWindow) {
  window_.resize(1024, 700);
  window_.document().open({"figure_1", {}, findLibraryScene("figure_1")->scene});
  auto& description = control<MessageBar>("descriptionBar");
  const auto height = [&] { return description.sizeHint().height(); };
  ASSERT_TRUE(waitFor([&] { return description.isVisible(); }));
  const int whole = height();
  window_.tour().offer();
  EXPECT_LT(height(), whole);
  window_.resize(1024, 900);
  EXPECT_TRUE(waitFor([&] { return height() == whole; })) << "there is room for both";
  window_.resize(1024, 700);
  EXPECT_TRUE(waitFor([&] { return height() < whole; }));
  QTest::mouseClick(control<MessageBar>("hintBar").findChild<QToolButton*>("closeMessage"),
                    Qt::LeftButton);
  EXPECT_EQ(height(), whole);
}

TEST_F(TourTest, IsOfferedUntilPutAway) {
  auto& hint = control<MessageBar>("hintBar");
  window_.tour().offer();
  QTest::mouseClick(hint.findChild<QToolButton*>("closeMessage"), Qt::LeftButton);
  EXPECT_FALSE(hint.isVisible());
  window_.tour().offer();
  EXPECT_FALSE(hint.isVisible());
}

/// What the sentences promise.
TEST_F(TourTest, TheScenesShowWhatTheTourSays) {
  const auto mu = [&](const char* name, double velocity) {
    Scene scene;
    for (const LibraryScene& entry : libraryScenes())
      if (entry.name == name) scene = entry.scene;
    if (velocity >= 0) scene.sliding.velocity = velocity;
    window_.document().open(scene);
    EXPECT_TRUE(waitForFrame());
    return frame()->state.mu;
  };
  EXPECT_EQ(mu("pressed", -1), 0);
  EXPECT_LT(frame()->state.contactFraction, 0.1);
  const double slow = mu("region_1", 0.003);
  EXPECT_NEAR(mu("region_1", 0.006) / slow, 2, 0.1);
  EXPECT_NEAR(mu("region_3", 2) / mu("region_3", 1), 1, 0.1);
  const double summit = mu("one_sided", -1);
  EXPECT_LT(mu("one_sided", 0.001), 0.05 * summit);
  EXPECT_LT(mu("region_4", -1), 0.8 * mu("region_4", 3));
  EXPECT_GE(mu("full_contact", -1), 0);
  EXPECT_EQ(frame()->state.contactFraction, 1);
}

}  // namespace
}  // namespace asperity
