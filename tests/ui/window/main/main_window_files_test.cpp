// Scenes saved, opened and dropped on the main window, and what is said where that fails.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QLineEdit>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <fstream>
#include <utility>

#include "core/scene/scene_file.h"
#include "tests/ui/window/main_window_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "ui/draw/picture_file.h"
#include "ui/panels/parameter_panel.h"
#include "ui/panels/value_entry.h"
#include "ui/window/export/export_dialog.h"
#include "ui/window/main/file_dialogs.h"
#include "ui/window/main/message_bar.h"
#include "ui/window/main/scene_document.h"
#include "ui/window/main/session.h"

namespace asperity {
namespace {

TEST_F(MainWindowTest, WhatIsSaidOfAFileStaysWhileTheSceneRuns) {
  QSignalSpy runs(&session(), &Session::sceneRuns);
  window_.messages().showMessage([] { return QStringLiteral("said of a file"); });
  press("elastomer.shear_modulus");
  ASSERT_TRUE(waitForFrame());
  EXPECT_TRUE(waitFor([&] { return !runs.isEmpty(); }));
  EXPECT_TRUE(window_.messages().isVisible());
  window_.document().open(smallScene());
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
  EXPECT_FALSE(window_.documentCommands().saveTo(folder.filePath("scene.json")));
  EXPECT_TRUE(window_.messages().text().contains("choose a profile file"));
}

/// What went wrong is said until it goes well, and what it covered comes back.
TEST_F(MainWindowTest, AFailureIsOverOnceItGoesWell) {
  const QTemporaryDir folder;
  ASSERT_TRUE(waitForFrame());
  const QString nowhere = folder.filePath("no_such_folder/picture.png");
  EXPECT_FALSE(savePicture(nowhere));
  EXPECT_TRUE(window_.messages().isVisible());
  EXPECT_FALSE(window_.documentCommands().saveTo(folder.filePath("no_such_folder/scene.json")));
  EXPECT_TRUE(savePicture(folder.filePath("picture.png")));
  EXPECT_TRUE(window_.messages().isVisible()) << "of the scene that was not saved";
  EXPECT_TRUE(window_.documentCommands().saveTo(folder.filePath("scene.json")));
  EXPECT_FALSE(window_.messages().isVisible());

  window_.document().edit(refusedScene());
  ASSERT_TRUE(waitFor([&] { return window_.messages().isVisible(); }));
  const QString complaint = window_.messages().text();
  EXPECT_FALSE(savePicture(nowhere));
  EXPECT_NE(window_.messages().text(), complaint);
  EXPECT_TRUE(savePicture(folder.filePath("picture.png")));
  EXPECT_EQ(window_.messages().text(), complaint) << "the scene still cannot run";
  EXPECT_TRUE(window_.messages().isVisible());
}

TEST_F(MainWindowTest, ScenesAreSavedAndOpened) {
  const QTemporaryDir folder;
  const QString file = folder.filePath("scene.json");
  QTest::keyClick(&control<ValueSlider>("slider:load.normal_force"), Qt::Key_Right);
  const Scene changed = window_.panel().scene();
  ASSERT_TRUE(window_.documentCommands().saveTo(file));
  EXPECT_EQ(said(), "Saved scene.json");
  window_.document().open(Scene{});
  ASSERT_TRUE(open(file));
  EXPECT_EQ(writeScene(window_.panel().scene()), writeScene(changed));
  EXPECT_EQ(writeScene(session().scene()), writeScene(changed));
}

/// A picture dropped on the window brings its scene back, and is not saved over.
TEST_F(MainWindowTest, APictureDroppedOnItOpensItsScene) {
  QTemporaryDir folder;
  const QString file = folder.filePath("picture.svg");
  Scene scene = smallScene();
  scene.title = "from a picture";
  writePicture(file.toStdString(), DrawList{}, {"a title", pictureOrigin("render", scene)});

  drop(file);
  ASSERT_TRUE(waitFor([&] { return session().scene().title == "from a picture"; }));
  EXPECT_EQ(window_.windowTitle(), "from a picture[*] – Asperity");
  EXPECT_EQ(window_.document().file(), "");

  drop(folder.filePath("gone.png"));
  ASSERT_TRUE(waitFor([&] { return window_.messages().text().contains("gone.png"); }));
  EXPECT_EQ(session().scene().title, "from a picture");
}

/// A pipe that nobody writes to is refused, as a file and as a profile; nothing waits for it.
TEST_F(MainWindowTest, APipeKeepsNothingWaiting) {
  const QTemporaryDir folder;
  const QString pipe = folder.filePath("pipe.png");
  ASSERT_EQ(::mkfifo(pipe.toUtf8().constData(), 0600), 0);
  EXPECT_FALSE(open(pipe));
  EXPECT_TRUE(window_.messages().text().contains("only regular files"));
  Scene scene = smallScene();
  scene.folder = folder.path().toStdString();
  scene.surface.kind = SurfaceKind::Profile;
  scene.surface.file = "pipe.png";
  QSignalSpy complaints(&session(), &Session::errorOccurred);
  window_.document().open(scene);
  EXPECT_TRUE(waitFor([&] { return !complaints.isEmpty(); }));
  EXPECT_TRUE(window_.messages().text().contains("only regular files"));
}

/// Of two files the one that was opened last is shown, and none that was opened before the scene on
/// the screen.
TEST_F(MainWindowTest, TheNewestOpeningWins) {
  const QTemporaryDir folder;
  for (const char* name : {"a", "b"}) {
    Scene scene = smallScene();
    scene.title = name;
    std::ofstream(folder.filePath(name).toStdString()) << writeScene(scene);
  }
  window_.documentCommands().openFile(folder.filePath("a"));
  EXPECT_TRUE(open(folder.filePath("b")));
  EXPECT_EQ(session().scene().title, "b");
  window_.documentCommands().openFile(folder.filePath("a"));
  Scene chosen = smallScene();
  chosen.title = "chosen meanwhile";
  window_.document().open(chosen);
  EXPECT_FALSE(open(folder.filePath("gone")));  // read after the first one
  EXPECT_EQ(session().scene().title, "chosen meanwhile");
}

/// A lesson is no scene, but also what was opened last.
TEST_F(MainWindowTest, ALessonIsTheNewestOpeningToo) {
  const QTemporaryDir folder;
  std::ofstream(folder.filePath("scene").toStdString()) << writeScene(smallScene());
  std::ofstream(folder.filePath("lesson").toStdString()) << R"({"schema": "asperity-lesson/1"})";
  const QSignalSpy opened(&window_.document(), &SceneDocument::opening);
  window_.documentCommands().openFile(folder.filePath("scene"));
  window_.documentCommands().openFile(folder.filePath("lesson"));
  EXPECT_TRUE(window_.messages().text().contains("title"));
  QTest::qWait(300);
  EXPECT_TRUE(opened.isEmpty());
}

/// Somebody's picture does not make the window read files elsewhere, or take the whole memory,
/// before its reader agreed.
TEST_F(MainWindowTest, AForeignSceneThatWantsMuchIsAskedAbout) {
  const QTemporaryDir folder;
  const auto picture = [&](const char* name, const Scene& scene) {
    const QString file = folder.filePath(name);
    writePicture(file.toStdString(), DrawList{}, {"", pictureOrigin("render", scene)});
    return file;
  };
  Scene reads = smallScene();
  reads.surface.kind = SurfaceKind::Profile;
  reads.surface.file = "/etc/shadow";
  Scene large = smallScene();
  large.surface.elements = 16777216;
  Scene long_ = smallScene();
  long_.ensemble.realizations = 1000000;
  long_.surface.elements = 100000;
  for (const QString& file :
       {picture("reads.svg", reads), picture("large.svg", large), picture("long.svg", long_)}) {
    answer(QMessageBox::Cancel);
    EXPECT_FALSE(open(file)) << file.toStdString();
    EXPECT_EQ(asked_, 1) << file.toStdString();
    EXPECT_EQ(session().scene().title, "small");
  }
  answer(QMessageBox::Open);
  EXPECT_TRUE(open(picture("reads.svg", reads)));
  EXPECT_EQ(asked_, 1);
  EXPECT_EQ(session().scene().surface.file, "/etc/shadow");
  // What lies beside the picture is read unasked, and so is what a scene file of one's own names.
  reads.surface.file = "line.csv";
  answer(QMessageBox::Cancel);
  EXPECT_TRUE(open(picture("beside.svg", reads)));
  reads.surface.file = "/no/such/line.csv";
  std::ofstream(folder.filePath("own.json").toStdString()) << writeScene(reads);
  EXPECT_TRUE(open(folder.filePath("own.json")));
  EXPECT_EQ(asked_, 0);
}

TEST_F(MainWindowTest, FilesAreFoundFromWhereverTheirSceneIsSaved) {
  const QTemporaryDir folder;
  ASSERT_TRUE(QDir(folder.path()).mkpath("a/b"));
  QFile profile(folder.filePath("line.csv"));
  ASSERT_TRUE(profile.open(QIODevice::WriteOnly));
  profile.write("position,height\n");
  for (int i = 0; i < 64; ++i)
    profile.write(QStringLiteral("%1,%2\n").arg(i * 1e-4).arg(1e-6 * ((i * 7) % 13)).toUtf8());
  profile.close();
  std::ofstream(folder.filePath("friction.csv").toStdString()) << "velocity,mu\n0.1,0.2\n1,0.3\n";
  Scene scene = smallScene();
  scene.folder = folder.path().toStdString();
  scene.surface.kind = SurfaceKind::Profile;
  scene.surface.file = "line.csv";
  scene.comparison.data = {{"friction.csv", {}}};
  scene.surface.length = 0;
  scene.surface.elements = 0;
  window_.document().open(scene);
  ASSERT_TRUE(waitForFrame());
  EXPECT_EQ(control<ValueEntry>("entry:surface.length").placeholderText(), "6.4");
  EXPECT_EQ(control<ValueEntry>("entry:surface.elements").placeholderText(), "64");
  ASSERT_TRUE(window_.documentCommands().saveTo(folder.filePath("a/b/scene.json")));
  ASSERT_TRUE(open(folder.filePath("a/b/scene.json")));
  EXPECT_EQ(window_.panel().scene().surface.file, "../../line.csv");
  EXPECT_EQ(window_.panel().scene().comparison.data.front().file, "../../friction.csv");
  ASSERT_TRUE(waitForFrame());
}

/// What the dialog adds to a name that has no ending.
TEST_F(MainWindowTest, ANameWithoutAnEndingGetsTheOneOfItsKind) {
  for (const auto& [command, ending] : {std::pair{"saveAs", "json"}, {"savePicture", "png"}}) {
    QString added;
    whenAsked<QFileDialog>([&](QFileDialog& dialog) {
      EXPECT_EQ(dialog.acceptMode(), QFileDialog::AcceptSave);
      added = dialog.defaultSuffix();
      dialog.reject();
    });
    action(command).trigger();
    EXPECT_EQ(added, ending);
  }
}

/// Whatever is saved: pictures, results of a lesson, handouts. A name with a folder keeps it.
TEST_F(MainWindowTest, AFileIsSavedWhereTheLastOneWas) {
  const QTemporaryDir folder, other;
  const QString filter = "Texts (*.txt)";
  whenAsked<QFileDialog>([&](QFileDialog& dialog) {
    dialog.findChild<QLineEdit*>("fileNameEdit")->setText(folder.filePath("first"));
    static_cast<QDialog&>(dialog).accept();
  });
  EXPECT_EQ(askSaveFile(&window_, "Save", "first.txt", filter), folder.filePath("first.txt"));
  const auto folderFor = [&](const QString& name) {
    QDir shown;
    whenAsked<QFileDialog>([&](QFileDialog& dialog) {
      shown = dialog.directory();
      dialog.reject();
    });
    EXPECT_EQ(askSaveFile(&window_, "Save", name, filter), "");
    return shown.absolutePath();
  };
  EXPECT_EQ(folderFor("second.txt"), folder.path());
  EXPECT_EQ(folderFor(other.filePath("third.txt")), other.path());
  EXPECT_EQ(folderFor("fourth.txt"), folder.path());  // no file was chosen in the other one
  QSettings().remove("files/saveFolder");
}

/// Every dialog begins where the document lies, or else where the last file was.
TEST_F(MainWindowTest, AFileIsLookedForBesideTheDocument) {
  const QTemporaryDir beside, last;
  rememberFolder(last.filePath("results.json"));
  EXPECT_EQ(proposedFolder(), last.path());
  EXPECT_EQ(proposedFolder(beside.filePath("scene.json")), beside.path());
  EXPECT_EQ(proposedFolder("/no/such/folder/scene.json"), last.path());
  ASSERT_TRUE(window_.documentCommands().saveTo(beside.filePath("scene.json")));
  ExportDialog& dialog = window_.exports().openDialog(ExportKind::Picture);
  EXPECT_EQ(QFileInfo(dialog.file()).absolutePath(), beside.path());
  dialog.close();
  QSettings().remove("files/saveFolder");
}

/// All that `asperity open` takes, without choosing a filter.
TEST_F(MainWindowTest, WhatCarriesASceneIsOffered) {
  QStringList offered;
  whenAsked<QFileDialog>([&](QFileDialog& dialog) {
    offered = dialog.nameFilters().constFirst().section('(', 1).chopped(1).split(' ');
    dialog.reject();
  });
  action("open").trigger();
  for (const char* ending : {"json", "png", "svg", "pdf", "csv", "mp4", "webm", "gif", "webp"})
    EXPECT_TRUE(offered.contains(QStringLiteral("*.") + ending)) << ending;
}

TEST_F(MainWindowTest, FilesThatDoNotReadOrWriteAreExplained) {
  const QTemporaryDir folder;
  const Scene before = window_.panel().scene();
  EXPECT_FALSE(open(folder.filePath("missing.json")));
  EXPECT_TRUE(window_.messages().isVisible());
  EXPECT_TRUE(window_.messages().text().contains("missing.json"));
  EXPECT_FALSE(window_.documentCommands().saveTo(folder.filePath("no/such/folder.json")));
  EXPECT_EQ(window_.panel().scene(), before);
}

}  // namespace
}  // namespace asperity
