// Entries of the panel: what is refused, taken back and given.
#include "ui/panels/value_entry.h"

#include <gtest/gtest.h>

#include "tests/ui/panels/parameter_panel_fixture.h"

namespace asperity {
namespace {

TEST_F(ParameterPanelTest, ARefusalGoesWhenThePresentTextIsBack) {
  ValueEntry& field = entry("surface.elements");
  field.setFocus();
  field.end(false);
  for (const Qt::Key back : {Qt::Key_Z, Qt::Key_Backspace}) {
    QTest::keyClicks(&field, "w");
    QTest::keyClick(&field, Qt::Key_Return);
    ASSERT_TRUE(field.hasError());
    QTest::keyClick(&field, back, back == Qt::Key_Z ? Qt::ControlModifier : Qt::NoModifier);
    EXPECT_EQ(field.text(), QString::number(panel_.scene().surface.elements));
    EXPECT_FALSE(field.hasError());
    EXPECT_FALSE(isShown("error:surface.elements"));
  }
}

/// The digits of an import are whole where they are edited.
TEST_F(ParameterPanelTest, ANumberThatDoesNotFitIsShownRounded) {
  panel_.activateWindow();
  Scene scene;
  scene.load.normalForce = 6.323258545019e-3;
  panel_.setScene(scene);
  ValueEntry& force = entry("load.normal_force");
  EXPECT_EQ(force.text(), "6.323258545019");
  EXPECT_EQ(force.shownText(), "6.32326");
  force.setFocus();
  ASSERT_TRUE(QTest::qWaitFor([&] { return force.hasFocus(); }));
  EXPECT_EQ(force.shownText(), "6.323258545019");
  QTest::keyClick(&force, Qt::Key_Return);
  EXPECT_EQ(spy_.count(), 0) << "nothing was typed";
  EXPECT_EQ(panel_.scene(), scene);
  EXPECT_EQ(entry("surface.hurst").shownText(), entry("surface.hurst").text());
}

/// A title that was cut off, and the end of a file's name, looked like the whole.
TEST_F(ParameterPanelTest, ATextThatDoesNotFitIsShownShortened) {
  panel_.activateWindow();
  Scene scene;
  scene.title = "A title that is far longer than the narrow entry of the panel";
  scene.surface.kind = SurfaceKind::Profile;
  scene.surface.file = "a/folder/with/a/rather/long/name/of/its/own/profile.csv";
  panel_.setScene(scene);
  const QString title = entry("title").shownText(), file = entry("surface.file").shownText();
  EXPECT_TRUE(title.startsWith("A title") && title.endsWith(u'…')) << title.toStdString();
  EXPECT_TRUE(file.startsWith(u'…') && file.endsWith("profile.csv")) << file.toStdString();
  entry("title").setFocus();
  ASSERT_TRUE(QTest::qWaitFor([&] { return entry("title").hasFocus(); }));
  EXPECT_EQ(entry("title").shownText().toStdString(), scene.title);
}

TEST_F(ParameterPanelTest, ASliderMendsARefusedText) {
  type("surface.hurst", "abc");
  QTest::keyClick(&slider("surface.hurst"), Qt::Key_Left);
  EXPECT_FALSE(entry("surface.hurst").hasError());
  EXPECT_EQ(entry("surface.hurst").text(), numberText(panel_.scene().surface.hurst));
}

TEST_F(ParameterPanelTest, EscapeTakesBackWhatWasTyped) {
  ValueEntry& force = entry("load.normal_force");
  force.setFocus();
  force.selectAll();
  QTest::keyClicks(&force, "99");
  QTest::keyClick(&force, Qt::Key_Escape);
  EXPECT_EQ(force.text(), "3.4");
  EXPECT_EQ(spy_.count(), 0);
}

TEST_F(ParameterPanelTest, EnterGivesTheKeysBackUnlessTheTextIsRefused) {
  panel_.activateWindow();
  entry("surface.hurst").setFocus();
  ASSERT_TRUE(QTest::qWaitFor([&] { return entry("surface.hurst").hasFocus(); }));
  type("surface.hurst", "7");
  EXPECT_TRUE(entry("surface.hurst").hasFocus());
  type("surface.hurst", "0.8");
  EXPECT_FALSE(entry("surface.hurst").hasFocus());
}

TEST_F(ParameterPanelTest, EscapeTakesTheComplaintBackToo) {
  type("surface.hurst", "abc");
  ASSERT_TRUE(isShown("error:surface.hurst"));
  ValueEntry& hurst = entry("surface.hurst");
  hurst.setFocus();
  QTest::keyClick(&hurst, Qt::Key_Escape);
  EXPECT_FALSE(isShown("error:surface.hurst"));
  EXPECT_EQ(hurst.text(), numberText(panel_.scene().surface.hurst));
}

}  // namespace
}  // namespace asperity
