// What a scene leaves open, as the panel of parameters shows it.
#include "ui/panels/profile_defaults.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QToolButton>

#include "tests/ui/panels/parameter_panel_fixture.h"

namespace asperity {
namespace {

TEST_F(ParameterPanelTest, AProfileAsksForItsFileAndIsNotPassedOnWithout) {
  choose("surface.kind", "profile");
  EXPECT_EQ(spy_.count(), 0);
  EXPECT_TRUE(isShown("note:surface.file"));
  EXPECT_EQ(control<QLabel>("note:surface.file")->text(), "choose a profile file");
  EXPECT_FALSE(isShown("error:surface.file"));

  type("surface.file", "line.csv");
  EXPECT_EQ(spy_.count(), 1);
  EXPECT_EQ(panel_.scene().surface.file, "line.csv");
  EXPECT_FALSE(isShown("note:surface.file"));

  type("surface.file", "");
  EXPECT_EQ(spy_.count(), 1);
  EXPECT_TRUE(isShown("note:surface.file"));
}

TEST_F(ParameterPanelTest, LengthAndElementsComeBackWithTheirKind) {
  type("surface.elements", "1000");
  type("surface.length", "0.03 m");
  spy_.clear();
  choose("surface.kind", "profile");
  EXPECT_EQ(panel_.scene().surface.length, 0);
  EXPECT_EQ(panel_.scene().surface.elements, 0);
  choose("surface.kind", "self_affine");
  EXPECT_EQ(panel_.scene().surface.length, 0.03);
  EXPECT_EQ(panel_.scene().surface.elements, 1000);
  EXPECT_EQ(spy_.count(), 0);  // nothing has changed

  choose("surface.kind", "profile");
  type("surface.file", "line.csv");
  type("surface.elements", "64");
  choose("surface.kind", "sine");
  EXPECT_EQ(panel_.scene().surface.elements, 1000);
  choose("surface.kind", "profile");
  EXPECT_EQ(panel_.scene().surface.elements, 64);
  EXPECT_EQ(panel_.scene().surface.length, 0);
}

TEST_F(ParameterPanelTest, AProfileAloneLeavesDefaultsToOtherKinds) {
  Scene scene;
  scene.surface.kind = SurfaceKind::Profile;
  scene.surface.file = "line.csv";
  scene.surface.length = 0;
  scene.surface.elements = 0;
  panel_.setScene(scene);
  choose("surface.kind", "self_affine");
  EXPECT_EQ(panel_.scene().surface.length, Surface{}.length);
  EXPECT_EQ(panel_.scene().surface.elements, Surface{}.elements);
}

TEST_F(ParameterPanelTest, WhatTheFileSaysStandsInPaleLetters) {
  choose("surface.kind", "profile");
  type("surface.file", "line.csv");
  EXPECT_EQ(entry("surface.length").text(), "");
  EXPECT_EQ(entry("surface.length").placeholderText(), "as in file");
  panel_.showLine({0.0128, 1024});
  EXPECT_EQ(entry("surface.length").placeholderText(), "12.8");
  EXPECT_EQ(entry("surface.length").unit(), "mm");
  EXPECT_EQ(entry("surface.elements").placeholderText(), "1024");
  EXPECT_EQ(panel_.scene().surface.length, 0);

  type("surface.length", "0.1 m");
  EXPECT_EQ(panel_.scene().surface.length, 0.1);
  auto* reset = control<QToolButton>("reset:surface.length");
  QTest::mouseClick(reset, Qt::LeftButton);
  EXPECT_EQ(panel_.scene().surface.length, 0);
  EXPECT_FALSE(reset->isEnabled());
  type("surface.elements", "64");
  type("surface.elements", "");
  EXPECT_EQ(panel_.scene().surface.elements, 0);
  EXPECT_FALSE(entry("surface.elements").hasError());

  type("surface.file", "other.csv");  // says something else
  EXPECT_EQ(entry("surface.length").placeholderText(), "as in file");
}

TEST_F(ParameterPanelTest, AButtonFindsTheFile) {
  Scene scene;
  scene.folder = "/measured/here";
  panel_.setScene(scene);
  EXPECT_FALSE(isShown("browse:surface.file"));
  choose("surface.kind", "profile");
  ASSERT_TRUE(isShown("browse:surface.file"));
  auto* browse = control<QToolButton>("browse:surface.file");
  QString answer, folder;
  panel_.setFileChooser([&](QWidget*, const QString& from) {
    folder = from;
    return answer;
  });
  browse->click();  // and nothing chosen
  EXPECT_EQ(spy_.count(), 0);
  EXPECT_EQ(folder, "/measured/here");

  answer = "/measured/here/today/line.csv";
  browse->click();
  EXPECT_EQ(panel_.scene().surface.file, "today/line.csv");
  EXPECT_EQ(entry("surface.file").text(), "today/line.csv");
  EXPECT_TRUE(entry("surface.file").toolTip().contains("today/line.csv")) << "it may be cut";
  answer = "/measured/hereafter/line.csv";
  browse->click();
  EXPECT_EQ(folder, "/measured/here/today");
  EXPECT_EQ(panel_.scene().surface.file, "/measured/hereafter/line.csv");
  EXPECT_EQ(spy_.count(), 2);
}

TEST_F(ParameterPanelTest, AnOversamplingThatIsChosenStandsInPaleLetters) {
  EXPECT_EQ(panel_.scene().accuracy.oversampling, 0);
  EXPECT_EQ(entry("accuracy.oversampling").text(), "");
  EXPECT_EQ(entry("accuracy.oversampling").placeholderText(), "4 (curve: 2)");  // line / curve
  auto* reset = control<QToolButton>("reset:accuracy.oversampling");
  EXPECT_FALSE(reset->isEnabled());
  choose("surface.kind", "sine");
  EXPECT_EQ(entry("accuracy.oversampling").placeholderText(), "chosen: 4");
  type("accuracy.oversampling", "2");
  EXPECT_EQ(panel_.scene().accuracy.oversampling, 2);
  EXPECT_EQ(entry("accuracy.oversampling").text(), "2");
  EXPECT_EQ(reset->toolTip(), "Back to the default, chosen by the scene");
  QTest::mouseClick(reset, Qt::LeftButton);
  EXPECT_EQ(panel_.scene().accuracy.oversampling, 0);
  for (const char* open : {"0", ""}) {
    type("accuracy.oversampling", "8");
    type("accuracy.oversampling", open);
    EXPECT_EQ(panel_.scene().accuracy.oversampling, 0);
    EXPECT_FALSE(entry("accuracy.oversampling").hasError());
  }
}

TEST_F(ParameterPanelTest, OnlyRandomLinesHaveRealizations) {
  choose("surface.kind", "sine");
  EXPECT_FALSE(slider("ensemble.realizations").isEnabled());
  EXPECT_EQ(entry("ensemble.realizations").placeholderText(), "1");
  EXPECT_EQ(entry("ensemble.realizations").text(), "");
  choose("surface.kind", "self_affine");
  EXPECT_TRUE(slider("ensemble.realizations").isEnabled());
  EXPECT_EQ(entry("ensemble.realizations").text(), "200");
}

/// A scene with one row and several realizations could not be opened again.
TEST_F(ParameterPanelTest, OneRowIsOneLine) {
  choose("surface.kind", "measured");
  type("surface.file", "topography.x3p");
  type("ensemble.realizations", "3");
  ASSERT_EQ(panel_.scene().ensemble.realizations, 3);
  type("surface.row", "5");
  EXPECT_EQ(panel_.scene().surface.reading.row, 5);
  EXPECT_EQ(panel_.scene().ensemble.realizations, 1);
}

}  // namespace
}  // namespace asperity
