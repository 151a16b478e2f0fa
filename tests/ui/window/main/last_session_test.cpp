// The scene and the view of the last session at the next start, where what cannot be read is left
// out.
#include "ui/window/main/last_session.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QLabel>
#include <QSettings>
#include <QTemporaryDir>
#include <filesystem>

#include "core/scene/scene_file.h"
#include "tests/core/temporary_folder.h"
#include "tests/ui/window/main_window_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "ui/window/main/main_window.h"
#include "ui/window/main/scene_library.h"
#include "ui/window/main/scene_tabs.h"

namespace asperity {
namespace {

class LastSessionTest : public MainWindowTest {
 protected:
  LastSessionTest() { QSettings().clear(); }

  /// What the next start shows, which begins with the first scene of the library.
  SceneState restored(bool wasKept = true, bool hasScene = false) {
    MainWindow next(libraryScenes().front().scene);
    EXPECT_EQ(restoreLastSession(next, hasScene), wasKept);
    EXPECT_FALSE(next.document().history().canUndo());
    said_ = next.findChild<QLabel*>("statusMessage")->text();
    tab_ = next.tabs().currentWidget()->objectName();
    navigation_ = next.canvas().viewer().navigation();
    overlay_ = next.canvas().viewer().overlay();
    return {next.document().origin(), next.document().scene()};
  }
  QString said_, tab_;
  ViewNavigation navigation_;
  ContactOverlay overlay_ = ContactOverlay::None;
};

TEST_F(LastSessionTest, AFirstStartHasNone) {
  EXPECT_EQ(restored(false).scene, libraryScenes().front().scene);
  EXPECT_EQ(said_, "");
}

TEST_F(LastSessionTest, AChangedShippedSceneReturnsWithItsChangesAndItsOrigin) {
  action("scene:region_2").trigger();
  type("load.normal_force", "12 mN");
  const Scene left = session().scene();
  saveLastSession(window_);
  const SceneState next = restored();
  EXPECT_EQ(next.scene, left);
  EXPECT_EQ(next.origin.shipped, "region_2");
  EXPECT_FALSE(next.scene == next.origin.scene);
}

TEST_F(LastSessionTest, ASceneWithoutAnOriginReturns) {
  type("load.normal_force", "12 mN");
  const Scene left = session().scene();
  saveLastSession(window_);
  const SceneState next = restored();
  EXPECT_EQ(writeScene(next.scene), writeScene(left));
  EXPECT_FALSE(next.origin.isKnown());
}

/// A file that was edited meanwhile is shown as it is now.
TEST_F(LastSessionTest, AFileIsReadAgain) {
  const QTemporaryDir folder;
  const QString file = folder.filePath("mine.json");
  ASSERT_TRUE(window_.documentCommands().saveTo(file));
  saveLastSession(window_);
  Scene edited = smallScene();
  edited.load.normalForce = 0.321;
  QFile out(file);
  ASSERT_TRUE(out.open(QIODevice::WriteOnly));
  out.write(writeScene(edited).c_str());
  out.close();
  const SceneState next = restored();
  EXPECT_EQ(next.scene.load.normalForce, 0.321);
  EXPECT_EQ(next.origin.file, file);
  ASSERT_TRUE(QFile::remove(file));
  EXPECT_EQ(writeScene(restored().scene), writeScene(smallScene())) << "the file is gone";
}

/// At the end the user was asked and did not save them.
TEST_F(LastSessionTest, DiscardedChangesOfAFileDoNotReturn) {
  const QTemporaryDir folder;
  ASSERT_TRUE(window_.documentCommands().saveTo(folder.filePath("mine.json")));
  type("load.normal_force", "12 mN");
  saveLastSession(window_);
  const SceneState next = restored();
  EXPECT_EQ(next.scene.load.normalForce, smallScene().load.normalForce);
}

/// A crash asks nothing: what was changed until some seconds before returns, marked as not saved.
TEST_F(LastSessionTest, ARunningSessionIsKeptWithUnsavedChanges) {
  const QTemporaryDir folder;
  const QString file = folder.filePath("mine.json");
  keepLastSession(window_);
  ASSERT_TRUE(window_.documentCommands().saveTo(file));
  type("load.normal_force", "12 mN");
  const Scene left = session().scene();
  const auto isKept = [] { return QSettings().value("lastSession/isChanged").toBool(); };
  EXPECT_FALSE(isKept());
  ASSERT_TRUE(waitFor(isKept));
  const SceneState next = restored();
  EXPECT_EQ(next.scene.load.normalForce, left.load.normalForce);
  EXPECT_EQ(next.origin.file, file);
  EXPECT_TRUE(next.isUnsavedFile());
}

TEST_F(LastSessionTest, AfterSavingInAnotherFolderAChangedSceneFindsItsFiles) {
  const TemporaryFolder folder;
  for (const char* name : {"a", "b"}) std::filesystem::create_directory(folder / name);
  const std::filesystem::path table = folder.write("a/table.csv", "velocity,mu\n0.1,0.2\n1,0.3\n");
  Scene scene = smallScene();
  scene.comparison.data = {{"table.csv", {}}};
  scene.folder = folder / "a";
  window_.document().open(scene);
  ASSERT_TRUE(
      window_.documentCommands().saveTo(QString::fromStdString((folder / "b/mine.json").string())));
  type("load.normal_force", "12 mN");
  saveLastSession(window_, SessionMoment::Running);
  const SceneState next = restored();
  EXPECT_EQ(next.scene.load.normalForce, 0.012);
  ASSERT_EQ(next.scene.comparison.data.size(), 1U);
  EXPECT_EQ((next.scene.folder / next.scene.comparison.data[0].file).lexically_normal(), table);
  EXPECT_EQ(next.scene.comparison, next.origin.scene.comparison) << "as they are in the file";
}

/// The steps of a tour or a lesson are not the user's scene.
TEST_F(LastSessionTest, ATrialIsNotKept) {
  type("load.normal_force", "12 mN");
  const Scene left = session().scene();
  window_.document().openTrial({"region_2", {}, libraryScenes().back().scene});
  saveLastSession(window_, SessionMoment::Running);
  EXPECT_EQ(writeScene(restored().scene), writeScene(left));
}

TEST_F(LastSessionTest, TabZoomAndColoursReturn) {
  ASSERT_TRUE(waitForFrame());
  action("go:spectrumView").trigger();
  window_.canvas().zoom(7);
  window_.canvas().setOverlay(ContactOverlay::Power);
  const ViewNavigation left = window_.canvas().viewer().navigation();
  ASSERT_FALSE(left.isFitted());
  saveLastSession(window_);
  restored();
  EXPECT_EQ(tab_, "spectrumView");
  EXPECT_EQ(navigation_, left);
  EXPECT_EQ(overlay_, ContactOverlay::Power);
}

TEST_F(LastSessionTest, ASceneThatWasAskedForWins) {
  action("go:spectrumView").trigger();
  window_.canvas().zoom(7);
  saveLastSession(window_);
  const SceneState next = restored(true, true);
  EXPECT_EQ(next.scene, libraryScenes().front().scene);
  EXPECT_TRUE(navigation_.isFitted());
  EXPECT_EQ(tab_, "spectrumView");
}

TEST_F(LastSessionTest, WhatCannotBeReadIsLeftOutAndSaid) {
  saveLastSession(window_);
  for (const char* broken : {"", "{", "[1, 2]", R"({"schema": "asperity-scene/99"})",
                             R"({"schema": "asperity-scene/1", "load": {"normal_force": -1}})"}) {
    QSettings().setValue("lastSession/scene", broken);
    EXPECT_EQ(restored().scene, libraryScenes().front().scene) << broken;
    EXPECT_TRUE(said_.contains("last time")) << broken;
  }
  Scene gone = smallScene();
  gone.surface.kind = SurfaceKind::Profile;
  gone.surface.file = "/no/such/profile.csv";
  QSettings().setValue("lastSession/scene", QString::fromStdString(writeScene(gone)));
  restored();
  EXPECT_TRUE(said_.contains("profile.csv"));
}

TEST(ViewAsText, ReadsBackAndRefusesNonsense) {
  ViewNavigation view;
  view = view.zoomed({0.3, 0.7}, 17, 5, 1e-6).panned(0.123, 0.01);
  EXPECT_EQ(ViewNavigation::fromText(view.toText()), view);
  EXPECT_TRUE(ViewNavigation::fromText(view.following(true, 1, 0).toText()).followsLine());
  for (const char* text : {"", "rubber", "rubber 0 1", "rubber 0 0 0 1", "rubber 0 nan 0 1",
                           "rubber 0 1 1 0", "rubber 0 -1 0 1", "rubber inf 1 0 1", "what 0 1 0 1"})
    EXPECT_EQ(ViewNavigation::fromText(text), ViewNavigation()) << text;
}

}  // namespace
}  // namespace asperity
