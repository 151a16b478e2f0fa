// Undo and redo, the mark of unsaved changes and the question about them, recent files.
#include "ui/window/main/scene_document.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QMenu>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>

#include "core/scene/scene_file.h"
#include "tests/ui/window/main_window_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "ui/window/main/document_commands.h"
#include "ui/window/main/message_bar.h"
#include "ui/window/main/scene_library.h"

namespace asperity {
namespace {

using DocumentTest = MainWindowTest;

Scene withForce(Scene scene, double force) {
  scene.load.normalForce = force;
  return scene;
}

TEST(SceneDocument, EveryChangeGoesBackAndForth) {
  SceneDocument document(smallScene());
  std::vector<Scene> scenes{smallScene()};
  for (int i = 1; i <= 5; ++i) {
    scenes.push_back(withForce(scenes.back(), 0.1 * i));
    document.change(scenes.back(), static_cast<std::uint64_t>(i));
  }
  for (std::size_t i = scenes.size(); i-- > 1;) {
    EXPECT_EQ(document.scene(), scenes[i]);
    document.history().undo();
  }
  EXPECT_EQ(document.scene(), scenes.front());
  EXPECT_FALSE(document.history().canUndo());
  for (std::size_t i = 1; i < scenes.size(); ++i) {
    document.history().redo();
    EXPECT_EQ(document.scene(), scenes[i]);
  }
}

TEST(SceneDocument, OneGestureOnOneParameterIsOneStep) {
  SceneDocument document(smallScene());
  for (int i = 1; i <= 50; ++i) document.change(withForce(smallScene(), 0.01 * i), 7);
  EXPECT_EQ(document.history().count(), 1);
  Scene other = document.scene();
  other.sliding.velocity = 3;
  document.change(other, 7);  // of another parameter
  EXPECT_EQ(document.history().count(), 2);
  document.change(withForce(other, 4), 8);
  document.change(withForce(other, 5), 9);
  EXPECT_EQ(document.history().count(), 4);
}

TEST(SceneDocument, AGestureThatEndsWhereItBeganIsNoStep) {
  SceneDocument document(smallScene());
  document.change(withForce(smallScene(), 2), 1);
  EXPECT_TRUE(document.isChanged());
  document.change(smallScene(), 1);
  EXPECT_FALSE(document.isChanged());
  EXPECT_EQ(document.history().count(), 0);
}

TEST(SceneDocument, StepsAreNamedAfterWhatTheyChange) {
  SceneDocument document(smallScene());
  document.change(withForce(smallScene(), 2), 1);
  EXPECT_EQ(document.history().undoText(), "Normal force");
  Scene profile = document.scene();
  profile.surface.kind = SurfaceKind::Sine;
  profile.surface.elements = 99;
  EXPECT_EQ(stepName(document.scene(), profile), "Kind of line");
  Scene two = document.scene();
  two.surface.hurst = 0.1;
  two.surface.seed = 9;
  EXPECT_EQ(stepName(document.scene(), two), "2 parameters");
}

TEST(SceneDocument, ANewFileIsNamedAfterTheSceneThatItHolds) {
  Scene scene;
  SceneDocument document(scene);
  EXPECT_EQ(document.proposedFile(), "scene.json");
  for (const auto& [title, file] :
       {std::pair("Tread: H = 0.3, 10 mN", "tread_h_0_3_10_mn.json"),
        std::pair("../Glätte  é", "glatte_e.json"), std::pair("???", "scene.json")}) {
    scene.title = title;
    document.open({{}, {}, scene});
    EXPECT_EQ(document.proposedFile(), file);
  }
  document.open({"figure_1", {}, scene});
  EXPECT_EQ(document.proposedFile(), "figure_1.json");
  Scene other = scene;
  other.title = "asphalt";
  document.edit(other);  // as the import of a surface does
  EXPECT_EQ(document.proposedFile(), "asphalt.json");
  scene.title = std::string(300, 'x');
  document.open({{}, {}, scene});
  EXPECT_LE(document.proposedFile().size(), 65);
}

TEST_F(DocumentTest, AnEditIsUndoneAndRedoneByItsKeys) {
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  EXPECT_FALSE(action("undo").isEnabled());
  type("load.normal_force", "0.5 N");
  EXPECT_EQ(action("undo").text(), "Undo Normal force");
  EXPECT_TRUE(action("undo").toolTip().contains("Ctrl+Z"));
  QTest::keyClick(&window_, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(session().scene(), smallScene());
  EXPECT_EQ(window_.panel().scene(), smallScene());
  EXPECT_EQ(action("undo").text(), "Undo");
  EXPECT_EQ(action("redo").text(), "Redo Normal force");
  QTest::keyClick(&window_, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(session().scene().load.normalForce, 0.5);
  EXPECT_EQ(control<ValueEntry>("entry:load.normal_force").text(), "500");
  ASSERT_TRUE(waitForFrame());
  EXPECT_EQ(frame()->scene->load.normalForce, 0.5);
}

/// The focus stands in the field of an arm then, which has nothing of its own to undo.
TEST_F(DocumentTest, AnArmThatWasAddedOrRemovedIsUndoneByTheKey) {
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  Scene scene = smallScene();
  scene.elastomer.rheology = Rheology::Prony;
  scene.elastomer.arms = {{1e7, 1e-3}, {2e6, 0.1}};
  window_.document().open(scene);
  const auto arms = [&] { return session().scene().elastomer.arms.size(); };
  const auto undo = [] {
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Z, Qt::ControlModifier);
  };
  for (const auto& [button, count] : {std::pair{"armRemove:0", 1U}, {"armsAdd", 3U}}) {
    control<QAbstractButton>(button).click();
    ASSERT_TRUE(waitFor([&] {
      return arms() == count && qobject_cast<ValueEntry*>(QApplication::focusWidget());
    })) << button;
    undo();
    EXPECT_EQ(session().scene(), scene) << button;
  }
}

TEST_F(DocumentTest, WhatIsBeingTypedIsUndoneInItsField) {
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  press("load.normal_force");
  const Scene before = session().scene();
  auto& entry = control<ValueEntry>("entry:surface.hurst");
  const QString text = entry.text();
  entry.setFocus();
  QTest::keyClicks(&entry, "7");
  ASSERT_NE(entry.text(), text);
  QTest::keyClick(&entry, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(entry.text(), text);
  EXPECT_EQ(session().scene(), before);
  QTest::keyClick(&entry, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(session().scene(), smallScene());
}

TEST_F(DocumentTest, ADragOfASliderIsOneStep) {
  auto& slider = control<ValueSlider>("slider:load.normal_force");
  const int y = slider.height() / 2;
  for (int lap = 1; lap <= 2; ++lap) {
    QTest::mousePress(&slider, Qt::LeftButton, {}, QPoint(10, y));
    for (int x = 10; x <= slider.width() - 20 * lap; ++x) QTest::mouseMove(&slider, QPoint(x, y));
    QTest::mouseRelease(&slider, Qt::LeftButton, {}, QPoint(slider.width() - 20 * lap, y));
    EXPECT_EQ(window_.document().history().count(), lap);
  }
  action("undo").trigger();
  action("undo").trigger();
  EXPECT_EQ(session().scene(), smallScene());
}

TEST_F(DocumentTest, KeysPressedOneByOneAreStepsAndAHeldKeyIsOne) {
  press("load.normal_force");
  press("load.normal_force");
  EXPECT_EQ(window_.document().history().count(), 2);
  auto& slider = control<ValueSlider>("slider:load.normal_force");
  for (int i = 0; i < 20; ++i) {
    QKeyEvent held(QEvent::KeyPress, Qt::Key_Right, {}, {}, i > 0);
    QApplication::sendEvent(&slider, &held);
  }
  EXPECT_EQ(window_.document().history().count(), 3);
}

TEST_F(DocumentTest, EveryParameterGoesBackToItsDefaultAndBackAgain) {
  type("surface.hurst", "0.3");
  type("load.normal_force", "0.5 N");
  const Scene before = session().scene();
  action("resetAll").trigger();
  EXPECT_EQ(session().scene(), Scene{});
  EXPECT_EQ(window_.panel().scene(), Scene{});
  action("undo").trigger();
  EXPECT_EQ(session().scene(), before);
  action("revert").trigger();
  EXPECT_EQ(session().scene(), smallScene());
  EXPECT_FALSE(window_.isWindowModified());
  EXPECT_FALSE(action("revert").isEnabled());
}

TEST_F(DocumentTest, TheTitleIsMarkedWhileTheSceneDiffers) {
  EXPECT_FALSE(window_.isWindowModified());
  EXPECT_TRUE(window_.windowTitle().contains("[*]"));
  press("load.normal_force");
  EXPECT_TRUE(window_.isWindowModified());
  action("undo").trigger();
  EXPECT_FALSE(window_.isWindowModified());
}

TEST_F(DocumentTest, AnUnchangedSceneIsLeftWithoutAQuestion) {
  answer(QMessageBox::Cancel);
  action("scene:figure_2").trigger();
  action("scene:region_1").trigger();
  EXPECT_TRUE(window_.close());
  EXPECT_EQ(asked_, 0);
}

TEST(SceneDocument, AnotherSceneIsOneStepThatBringsBackChangesAndOrigin) {
  SceneDocument document(smallScene());
  document.begin({{{}, "/somewhere/mine.json", smallScene()}, smallScene()});
  document.change(withForce(smallScene(), 0.5), 1);
  Scene other = smallScene();
  other.title = "other";
  QSignalSpy opened(&document, &SceneDocument::opening);
  document.open({"figure_1", {}, other});
  EXPECT_EQ(document.history().count(), 2);
  EXPECT_TRUE(document.history().undoText().contains("other"));
  EXPECT_EQ(document.scene(), other);
  EXPECT_FALSE(document.isChanged());
  document.change(withForce(other, 3), 2);
  document.history().undo();
  document.history().undo();
  EXPECT_EQ(document.scene(), withForce(smallScene(), 0.5));
  EXPECT_EQ(document.file(), "/somewhere/mine.json");
  EXPECT_TRUE(document.isChanged());
  EXPECT_EQ(opened.count(), 2);  // there and back
  document.history().redo();
  EXPECT_EQ(document.scene(), other);
  EXPECT_EQ(document.origin().shipped, "figure_1");
  EXPECT_TRUE(document.file().isEmpty());
}

TEST(SceneDocument, TheSameSceneAgainIsNoStep) {
  SceneDocument document(smallScene());
  QSignalSpy changes(&document, &SceneDocument::sceneChanged);
  document.open(smallScene());
  EXPECT_EQ(document.history().count(), 0);
  EXPECT_EQ(changes.count(), 1);  // it begins anew
}

TEST(SceneDocument, AStepBackOverASaveKeepsTheFile) {
  SceneDocument document(smallScene());
  document.change(withForce(smallScene(), 0.5), 1);
  document.change(withForce(smallScene(), 0.6), 2);
  document.saved("/somewhere/mine.json");
  document.history().undo();
  EXPECT_EQ(document.file(), "/somewhere/mine.json");
  EXPECT_TRUE(document.isChanged());
  document.history().redo();
  EXPECT_FALSE(document.isChanged());
  EXPECT_EQ(document.file(), "/somewhere/mine.json");
  Scene other = smallScene();
  other.title = "other";
  document.open({"figure_1", {}, other});
  document.history().undo();
  EXPECT_EQ(document.file(), "/somewhere/mine.json");
  EXPECT_FALSE(document.isChanged());
  document.history().redo();
  EXPECT_EQ(document.origin().shipped, "figure_1");
}

/// A file is named once, with the state in which it was left last.
TEST(SceneDocument, KnowsTheFilesWhoseChangesAreNotSaved) {
  const auto stateOf = [](const char* file) {
    Scene scene = smallScene();
    scene.title = file;
    return SceneOrigin{{}, file, scene};
  };
  SceneDocument document(smallScene());
  document.change(withForce(smallScene(), 0.4), 1);
  EXPECT_TRUE(document.unsavedFiles().empty());  // no file
  document.open(stateOf("/a.json"));
  EXPECT_TRUE(document.unsavedFiles().empty());
  document.change(withForce(document.scene(), 0.5), 2);
  ASSERT_EQ(document.unsavedFiles().size(), 1U);
  document.open(stateOf("/b.json"));
  ASSERT_EQ(document.unsavedFiles().size(), 1U);
  EXPECT_EQ(document.unsavedFiles()[0].origin.file, "/a.json");
  EXPECT_EQ(document.unsavedFiles()[0].scene.load.normalForce, 0.5);
  document.change(withForce(document.scene(), 0.7), 3);
  ASSERT_EQ(document.unsavedFiles().size(), 2U);
  EXPECT_EQ(document.unsavedFiles()[0].origin.file, "/b.json");
  document.saved("/b.json");
  EXPECT_EQ(document.unsavedFiles().size(), 1U);
  document.open(stateOf("/a.json"));  // as it is on the disk
  EXPECT_TRUE(document.unsavedFiles().empty());
}

/// A long history forgets its first steps, but not that a file was not saved.
TEST(SceneDocument, AnUnsavedFileIsKnownBeyondTheHistory) {
  Scene mine = smallScene();
  mine.title = "mine";
  SceneDocument document(smallScene());
  document.open({{}, "/mine.json", mine});
  document.change(withForce(mine, 0.5), 1);
  document.open(smallScene());
  for (int i = 0; i < 1200; ++i)
    document.change(withForce(smallScene(), 1 + 0.001 * i), 2 + static_cast<std::uint64_t>(i));
  ASSERT_EQ(document.unsavedFiles().size(), 1U);
  EXPECT_EQ(document.unsavedFiles()[0].scene, withForce(mine, 0.5));
  document.open({{}, "/mine.json", mine});
  EXPECT_TRUE(document.unsavedFiles().empty());
}

TEST(SceneDocument, ATrialEndsWhereItBegan) {
  SceneDocument document(smallScene());
  document.change(withForce(smallScene(), 0.5), 1);
  document.history().undo();
  Scene tried = smallScene();
  tried.title = "tried";
  document.openTrial({"figure_1", {}, tried});
  EXPECT_TRUE(document.isTrial());
  EXPECT_FALSE(document.history().canUndo());
  document.change(withForce(tried, 9), 2);
  EXPECT_TRUE(document.history().canUndo());
  EXPECT_TRUE(document.unsavedFiles().empty());
  document.openTrial({"figure_2", {}, tried});
  EXPECT_FALSE(document.history().canUndo());
  QSignalSpy ended(&document, &SceneDocument::trialEnded);
  document.endTrial();
  document.endTrial();
  EXPECT_EQ(ended.count(), 1);
  EXPECT_EQ(document.scene(), smallScene());
  EXPECT_FALSE(document.history().canUndo());
  EXPECT_TRUE(document.history().canRedo());
  document.history().redo();
  EXPECT_EQ(document.scene().load.normalForce, 0.5);
}

TEST(SceneDocument, AnotherSceneEndsATrialAndIsAStepFromTheSceneOfBefore) {
  SceneDocument document(smallScene());
  document.change(withForce(smallScene(), 0.5), 1);
  Scene tried = smallScene(), chosen = smallScene();
  tried.title = "tried";
  chosen.title = "chosen";
  document.openTrial({{}, {}, tried});
  document.open(chosen);
  EXPECT_FALSE(document.isTrial());
  EXPECT_EQ(document.scene(), chosen);
  document.history().undo();
  EXPECT_EQ(document.scene(), withForce(smallScene(), 0.5));
}

/// Who is asked knows what would be lost, and answers by a letter.
TEST_F(DocumentTest, TheQuestionNamesTheSceneAndItsFileAndHasLetters) {
  const QTemporaryDir folder;
  const QString file = folder.filePath("mine.json");
  ASSERT_TRUE(window_.documentCommands().saveTo(file));
  press("load.normal_force");
  QString text, detail;
  QStringList buttons;
  whenAsked<QMessageBox>([&](QMessageBox& box) {
    text = box.text();
    detail = box.informativeText();
    for (const QAbstractButton* button : box.buttons()) {
      buttons += button->text();
      EXPECT_TRUE(button->icon().isNull());  // words alone, as in all dialogs
    }
    QTest::keyClick(&box, Qt::Key_C, Qt::AltModifier);
  });
  EXPECT_FALSE(window_.close());
  EXPECT_TRUE(text.contains("small")) << text.toStdString();
  EXPECT_TRUE(detail.contains(file)) << detail.toStdString();
  ASSERT_EQ(buttons.size(), 3);
  for (const QString& button : buttons) EXPECT_TRUE(button.contains('&')) << button.toStdString();
}

TEST_F(DocumentTest, AnotherSceneAsksNothingAndUndoBringsTheChangesBack) {
  const QTemporaryDir folder;
  ASSERT_TRUE(window_.documentCommands().saveTo(folder.filePath("mine.json")));
  press("load.normal_force");
  const Scene changed = session().scene();
  answer(QMessageBox::Cancel);
  action("scene:figure_2").trigger();
  EXPECT_EQ(asked_, 0);
  EXPECT_TRUE(session().scene().title.starts_with("Figure 2"));
  EXPECT_FALSE(window_.isWindowModified());
  action("undo").trigger();
  EXPECT_EQ(session().scene(), changed);
  EXPECT_EQ(window_.panel().scene(), changed);
  EXPECT_TRUE(window_.document().file().endsWith("mine.json"));
  EXPECT_TRUE(window_.isWindowModified());
}

/// The next start shows a scene without a file again.
TEST_F(DocumentTest, TheEndAsksOnlyAboutFiles) {
  press("load.normal_force");
  answer(QMessageBox::Cancel);
  EXPECT_TRUE(window_.close());
  EXPECT_EQ(asked_, 0);
}

TEST_F(DocumentTest, CancelStaysWithTheChangedScene) {
  const QTemporaryDir folder;
  ASSERT_TRUE(window_.documentCommands().saveTo(folder.filePath("mine.json")));
  press("load.normal_force");
  const Scene changed = session().scene();
  answer(QMessageBox::Cancel);
  EXPECT_FALSE(window_.close());
  EXPECT_EQ(asked_, 1);
  EXPECT_TRUE(window_.isVisible());
  EXPECT_EQ(session().scene(), changed);
  EXPECT_TRUE(window_.document().history().canUndo());
}

TEST_F(DocumentTest, DiscardLeavesTheFileAsItIs) {
  const QTemporaryDir folder;
  const QString file = folder.filePath("mine.json");
  ASSERT_TRUE(window_.documentCommands().saveTo(file));
  press("load.normal_force");
  answer(QMessageBox::Discard);
  EXPECT_TRUE(window_.close());
  EXPECT_EQ(asked_, 1);
  EXPECT_EQ(readSceneFile(file.toStdString()).load.normalForce, smallScene().load.normalForce);
}

TEST_F(DocumentTest, SaveWritesTheFileBeforeTheEnd) {
  const QTemporaryDir folder;
  const QString file = folder.filePath("mine.json");
  ASSERT_TRUE(window_.documentCommands().saveTo(file));
  type("load.normal_force", "0.75 N");
  answer(QMessageBox::Save);
  EXPECT_TRUE(window_.close());
  EXPECT_EQ(asked_, 1);
  EXPECT_EQ(readSceneFile(file.toStdString()).load.normalForce, 0.75);
}

/// A file that was left for another scene is asked about, too: nothing can be undone after the end.
TEST_F(DocumentTest, AFileThatWasLeftIsSavedAtTheEnd) {
  const QTemporaryDir folder;
  const QString file = folder.filePath("mine.json");
  ASSERT_TRUE(window_.documentCommands().saveTo(file));
  type("load.normal_force", "0.75 N");
  action("scene:figure_2").trigger();
  answer(QMessageBox::Save);
  EXPECT_TRUE(window_.close());
  EXPECT_EQ(asked_, 1);
  EXPECT_EQ(readSceneFile(file.toStdString()).load.normalForce, 0.75);
  EXPECT_TRUE(session().scene().title.starts_with("Figure 2"));
}

TEST_F(DocumentTest, SaveThatFailsStays) {
  QTemporaryDir folder;
  ASSERT_TRUE(window_.documentCommands().saveTo(folder.filePath("mine.json")));
  folder.remove();
  press("load.normal_force");
  const Scene changed = session().scene();
  answer(QMessageBox::Save);
  EXPECT_FALSE(window_.close());
  EXPECT_EQ(session().scene(), changed);
  EXPECT_TRUE(window_.messages().isVisible());
}

TEST_F(DocumentTest, ADropIsAStepToo) {
  const QTemporaryDir folder;
  const QString file = folder.filePath("other.json");
  QFile other(file);
  ASSERT_TRUE(other.open(QIODevice::WriteOnly));
  Scene scene = smallScene();
  scene.title = "dropped";
  other.write(writeScene(scene).c_str());
  other.close();
  press("load.normal_force");
  const Scene changed = session().scene();
  answer(QMessageBox::Cancel);
  drop(file);
  ASSERT_TRUE(waitFor([&] { return session().scene().title == "dropped"; }));
  EXPECT_EQ(asked_, 0);
  action("undo").trigger();
  EXPECT_EQ(session().scene(), changed);
}

TEST_F(DocumentTest, SettingsOfTestsAreTheirOwn) {
  EXPECT_TRUE(QSettings().fileName().startsWith(QDir::tempPath()));
  EXPECT_EQ(QApplication::organizationName(), "Asperity");
}

TEST_F(DocumentTest, RecentFilesAreOfferedWhileTheyAreThere) {
  clearRecentFiles();
  const QTemporaryDir folder;
  auto& menu = control<QMenu>("recentMenu");
  for (int i = 0; i < kMaxRecentFiles + 2; ++i)
    ASSERT_TRUE(
        window_.documentCommands().saveTo(folder.filePath(QStringLiteral("%1.json").arg(i))));
  EXPECT_EQ(recentFiles().size(), kMaxRecentFiles);
  EXPECT_EQ(menu.actions().first()->text(), "9.json");
  ASSERT_TRUE(QFile::remove(folder.filePath("9.json")));
  EXPECT_EQ(recentFiles().size(), kMaxRecentFiles - 1);
  ASSERT_TRUE(open(folder.filePath("5.json")));
  EXPECT_EQ(menu.actions().first()->text(), "5.json");
  menu.actions().at(1)->trigger();
  EXPECT_TRUE(waitFor([&] { return window_.document().file().endsWith("8.json"); }));
  menu.actions().last()->trigger();
  EXPECT_TRUE(recentFiles().isEmpty());
  ASSERT_EQ(menu.actions().size(), 1);
  EXPECT_EQ(menu.actions().first()->text().remove('&'), "No scene was opened or saved yet");
  EXPECT_FALSE(menu.actions().first()->isEnabled());
}

TEST_F(DocumentTest, AnOpenedFileIsSavedWhereItCameFrom) {
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  const QTemporaryDir folder;
  const QString file = folder.filePath("mine.json");
  ASSERT_TRUE(window_.documentCommands().saveTo(file));
  window_.document().open(Scene{});
  EXPECT_TRUE(window_.document().file().isEmpty());
  ASSERT_TRUE(open(file));
  type("sliding.velocity", "0.125 m/s");
  QTest::keyClick(&window_, Qt::Key_S, Qt::ControlModifier);
  EXPECT_EQ(readSceneFile(file.toStdString()).sliding.velocity, 0.125);
  EXPECT_FALSE(window_.isWindowModified());
}

}  // namespace
}  // namespace asperity
