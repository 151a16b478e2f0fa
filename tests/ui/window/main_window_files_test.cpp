// Scenes saved, opened and dropped on the main window, and what is said where that fails.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <utility>

#include "core/scene/provenance.h"
#include "core/scene/scene_file.h"
#include "tests/ui/window/main_window_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "ui/panels/parameter_panel.h"
#include "ui/panels/value_entry.h"
#include "ui/window/message_bar.h"
#include "ui/window/session.h"

namespace asperity {
namespace {

TEST_F(MainWindowTest, WhatIsSaidOfAFileStaysWhileTheSceneRuns) {
  QSignalSpy runs(&session(), &Session::sceneRuns);
  window_.messages().showMessage("said of a file");
  press("elastomer.shear_modulus");
  ASSERT_TRUE(waitForFrame());
  EXPECT_TRUE(waitFor([&] { return !runs.isEmpty(); }));
  EXPECT_TRUE(window_.messages().isVisible());
  window_.showScene(smallScene());
  EXPECT_FALSE(window_.messages().isVisible());
}

TEST_F(MainWindowTest, AProfileWithoutAFileIsNeitherRunNorSaved) {
  ASSERT_TRUE(waitForFrame());
  const std::uint64_t before = session().sceneNumber();
  auto& kind = control<QComboBox>("choice:surface.kind");
  kind.setCurrentIndex(kind.findData("profile"));
  emit kind.activated(kind.currentIndex());
  QSignalSpy frames(&session(), &Session::frameArrived);
  ASSERT_TRUE(waitFor([&] { return frames.count() > 5; }));
  EXPECT_EQ(session().sceneNumber(), before);
  EXPECT_FALSE(window_.messages().isVisible());
  const QTemporaryDir folder;
  EXPECT_FALSE(window_.saveScene(folder.filePath("scene.json")));
  EXPECT_TRUE(window_.messages().text().contains("choose a profile file"));
}

/// What went wrong is said until it goes well, and what it covered comes back.
TEST_F(MainWindowTest, AFailureIsOverOnceItGoesWell) {
  const QTemporaryDir folder;
  ASSERT_TRUE(waitForFrame());
  const auto save = [&](const QString& file, bool isSaved) {
    QSignalSpy saved(&window_, &MainWindow::exported);
    window_.savePicture(file);
    ASSERT_TRUE(
        waitFor([&] { return saved.count() == 1 || window_.messages().text().contains(file); }));
    EXPECT_EQ(saved.count() == 1, isSaved);
  };
  const QString nowhere = folder.filePath("no_such_folder/picture.png");
  save(nowhere, false);
  EXPECT_TRUE(window_.messages().isVisible());
  EXPECT_FALSE(window_.saveScene(folder.filePath("no_such_folder/scene.json")));
  save(folder.filePath("picture.png"), true);
  EXPECT_TRUE(window_.messages().isVisible()) << "of the scene that was not saved";
  EXPECT_TRUE(window_.saveScene(folder.filePath("scene.json")));
  EXPECT_FALSE(window_.messages().isVisible());

  Scene broken = smallScene();
  broken.surface.kind = SurfaceKind::Sine;
  broken.surface.waves = 8;
  broken.surface.elements = 10;
  window_.showScene(broken);
  ASSERT_TRUE(waitFor([&] { return window_.messages().isVisible(); }));
  const QString complaint = window_.messages().text();
  save(nowhere, false);
  EXPECT_NE(window_.messages().text(), complaint);
  save(folder.filePath("picture.png"), true);
  EXPECT_EQ(window_.messages().text(), complaint) << "the scene still cannot run";
  EXPECT_TRUE(window_.messages().isVisible());
}

TEST_F(MainWindowTest, ScenesAreSavedAndOpened) {
  const QTemporaryDir folder;
  const QString file = folder.filePath("scene.json");
  QTest::keyClick(&control<ValueSlider>("slider:load.normal_force"), Qt::Key_Right);
  const Scene changed = window_.panel().scene();
  ASSERT_TRUE(window_.saveScene(file));
  window_.showScene(Scene{});
  ASSERT_TRUE(window_.openScene(file));
  EXPECT_EQ(writeScene(window_.panel().scene()), writeScene(changed));
  EXPECT_EQ(writeScene(session().scene()), writeScene(changed));
}

/// A picture dropped on the window brings its scene back, and is not saved over.
TEST_F(MainWindowTest, APictureDroppedOnItOpensItsScene) {
  QTemporaryDir folder;
  const QString file = folder.filePath("picture.png");
  Scene scene = smallScene();
  scene.title = "from a picture";
  QFile picture(file);
  ASSERT_TRUE(picture.open(QIODevice::WriteOnly));
  picture.write(("\x89PNG" + provenanceLine(provenance("render", scene))).c_str());
  picture.close();

  drop(file);
  EXPECT_EQ(session().scene().title, "from a picture");
  EXPECT_EQ(window_.windowTitle(), "from a picture[*] – Asperity");

  drop(folder.filePath("gone.png"));
  EXPECT_TRUE(window_.messages().text().contains("gone.png"));
  EXPECT_EQ(session().scene().title, "from a picture");
}

TEST_F(MainWindowTest, AProfileIsFoundFromWhereverItsSceneIsSaved) {
  const QTemporaryDir folder;
  ASSERT_TRUE(QDir(folder.path()).mkpath("a/b"));
  QFile profile(folder.filePath("line.csv"));
  ASSERT_TRUE(profile.open(QIODevice::WriteOnly));
  profile.write("position,height\n");
  for (int i = 0; i < 64; ++i)
    profile.write(QStringLiteral("%1,%2\n").arg(i * 1e-4).arg(1e-6 * ((i * 7) % 13)).toUtf8());
  profile.close();
  Scene scene = smallScene();
  scene.folder = folder.path().toStdString();
  scene.surface.kind = SurfaceKind::Profile;
  scene.surface.file = "line.csv";
  scene.surface.length = 0;
  scene.surface.elements = 0;
  window_.showScene(scene);
  ASSERT_TRUE(waitForFrame());
  EXPECT_EQ(control<ValueEntry>("entry:surface.length").placeholderText(), "0.0064");
  EXPECT_EQ(control<ValueEntry>("entry:surface.elements").placeholderText(), "64");
  ASSERT_TRUE(window_.saveScene(folder.filePath("a/b/scene.json")));
  ASSERT_TRUE(window_.openScene(folder.filePath("a/b/scene.json")));
  EXPECT_EQ(window_.panel().scene().surface.file, "../../line.csv");
  ASSERT_TRUE(waitForFrame());
}

/// What the dialog adds to a name that has no ending.
TEST_F(MainWindowTest, ANameWithoutAnEndingGetsTheOneOfItsKind) {
  for (const auto& [command, ending] : {std::pair{"saveAs", "json"}, {"savePicture", "png"}}) {
    QString added;
    QTimer::singleShot(0, [&] {
      auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      ASSERT_TRUE(dialog);
      EXPECT_EQ(dialog->acceptMode(), QFileDialog::AcceptSave);
      added = dialog->defaultSuffix();
      dialog->reject();
    });
    action(command).trigger();
    EXPECT_EQ(added, ending);
  }
}

/// All that `asperity open` takes, without choosing a filter.
TEST_F(MainWindowTest, WhatCarriesASceneIsOffered) {
  QStringList offered;
  QTimer::singleShot(0, [&] {
    auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
    ASSERT_TRUE(dialog);
    offered = dialog->nameFilters().constFirst().section('(', 1).chopped(1).split(' ');
    dialog->reject();
  });
  action("open").trigger();
  for (const char* ending : {"json", "png", "svg", "pdf", "csv", "mp4", "webm", "gif", "webp"})
    EXPECT_TRUE(offered.contains(QStringLiteral("*.") + ending)) << ending;
}

TEST_F(MainWindowTest, FilesThatDoNotReadOrWriteAreExplained) {
  const QTemporaryDir folder;
  const Scene before = window_.panel().scene();
  EXPECT_FALSE(window_.openScene(folder.filePath("missing.json")));
  EXPECT_TRUE(window_.messages().isVisible());
  EXPECT_TRUE(window_.messages().text().contains("missing.json"));
  EXPECT_FALSE(window_.saveScene(folder.filePath("no/such/folder.json")));
  EXPECT_EQ(window_.panel().scene(), before);
}

}  // namespace
}  // namespace asperity
