// What leaves the window: its picture, and the command line that makes it, which the program's own
// readers take.
#include <gtest/gtest.h>

#include <QClipboard>
#include <QFile>
#include <QImage>
#include <QProcess>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTemporaryDir>

#include "core/scene/provenance.h"
#include "core/scene/scene_file.h"
#include "tests/ui/window/main_window_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "ui/window/command_text.h"
#include "ui/window/contact_canvas.h"
#include "ui/window/message_bar.h"
#include "ui/window/scene_library.h"

namespace asperity {
namespace {

using CopyTest = MainWindowTest;

/// The words as a shell takes them from the text.
QStringList wordsOf(const QString& command) {
  QProcess shell;
  shell.start("/bin/sh", {"-c", "set -- " + command + "\nprintf '%s\\0' \"$@\""});
  EXPECT_TRUE(shell.waitForFinished());
  QStringList words = QString::fromUtf8(shell.readAllStandardOutput()).split(QChar(0));
  words.removeLast();
  return words;
}

/// The scene that the words say, read by the program itself.
Scene sceneSaid(QStringList words) {
  QProcess program;
  QStringList arguments{"check", words.at(2), "--json", "--quiet"};
  for (int i = 3; i < words.size(); ++i)
    if (words.at(i - 1) == "--set") arguments += {"--set", words.at(i)};
  program.start(ASPERITY_PROGRAM, arguments);
  EXPECT_TRUE(program.waitForFinished());
  EXPECT_EQ(program.exitCode(), 0) << program.readAllStandardError().toStdString();
  const QTemporaryDir folder;
  QFile answer(folder.filePath("answer.json"));
  EXPECT_TRUE(answer.open(QIODevice::WriteOnly));
  answer.write(program.readAllStandardOutput());
  answer.close();
  return readProvenance(answer.fileName().toStdString());
}

QString clipboardText() {
  return QGuiApplication::clipboard()->text();
}

TEST(ShellQuoted, LeavesPlainWordsAlone) {
  EXPECT_EQ(shellQuoted("load.normal_force=0.1"), "load.normal_force=0.1");
  EXPECT_EQ(shellQuoted("a b"), "'a b'");
  EXPECT_EQ(shellQuoted(""), "''");
  for (const QString& word : {QStringLiteral("it's \"$HOME\" `x` \\ ! *"),
                              QStringLiteral("two\nlines"), QStringLiteral("τ = 1")})
    EXPECT_EQ(wordsOf(shellQuoted(word)), QStringList{word});
}

TEST_F(CopyTest, AShippedSceneIsSaidByItsNameAndWhatDiffers) {
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  action("scene:region_2").trigger();
  QTest::keyClick(&window_, Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(clipboardText().startsWith("asperity render region_2.json -o picture.png"));
  EXPECT_FALSE(clipboardText().contains("--set"));
  type("load.normal_force", "0.02 N");
  action("copyCommand").trigger();
  const QStringList words = wordsOf(clipboardText());
  EXPECT_EQ(words.count("--set"), 1);
  EXPECT_TRUE(words.contains("load.normal_force=0.02"));
  EXPECT_EQ(writeScene(sceneSaid(words)), writeScene(session().scene()));
}

TEST_F(CopyTest, AFileIsSaidByItsPathHoweverItIsCalled) {
  const QTemporaryDir folder;
  const QString file = folder.filePath("it's mine.json");
  ASSERT_TRUE(window_.saveScene(file));
  type("sliding.velocity", "0.125 m/s");
  action("copyCurveCommand").trigger();
  const QStringList words = wordsOf(clipboardText());
  EXPECT_EQ(words.mid(0, 3), (QStringList{"asperity", "curve", file}));
  EXPECT_EQ(writeScene(sceneSaid(words)), writeScene(session().scene()));
}

TEST_F(CopyTest, ASceneFromNowhereIsSaidWithAllThatDiffers) {
  Scene scene = smallScene();
  scene.title = "it's \"new\"";
  scene.description = "two\nlines";
  scene.elastomer.rheology = Rheology::Prony;
  scene.elastomer.arms = {{1e6, 1e-4}, {2e6, 1e-2}};
  window_.showScene(scene);
  action("copyCommand").trigger();
  EXPECT_EQ(writeScene(sceneSaid(wordsOf(clipboardText()))), writeScene(scene));
}

TEST_F(CopyTest, EveryShippedSceneComesBack) {
  for (const LibraryScene& entry : libraryScenes()) {
    Scene scene = entry.scene;
    scene.load.normalForce *= 1.5;
    const QString text = renderCommand({entry.name, {}, entry.scene}, scene, {});
    EXPECT_EQ(writeScene(sceneSaid(wordsOf(text))), writeScene(scene)) << text.toStdString();
  }
}

TEST_F(CopyTest, ColoursAreSaidWhereTheyAreNotTheUsualOnes) {
  action("copyCommand").trigger();
  EXPECT_FALSE(wordsOf(clipboardText()).contains("--overlay"));
  window_.canvas().setOverlay(ContactOverlay::Power);
  action("copyCommand").trigger();
  const QStringList words = wordsOf(clipboardText());
  EXPECT_EQ(words.value(words.indexOf("--overlay") + 1), "power");
}

TEST_F(CopyTest, ThePictureIsSaidAsItIsShown) {
  window_.setDark(true);
  window_.resize(1000, 700);
  action("copyCommand").trigger();
  QStringList words = wordsOf(clipboardText());
  EXPECT_TRUE(words.contains("dark"));
  EXPECT_EQ(words.value(words.indexOf("--layout") + 1), "both");
  control<QTabWidget>("tabs").setCurrentIndex(2);
  action("copyCommand").trigger();
  words = wordsOf(clipboardText());
  EXPECT_FALSE(words.contains("--layout"));
  const QSize size = window_.canvas().size();
  EXPECT_EQ(words.value(words.indexOf("--size") + 1),
            QStringLiteral("%1x%2").arg(size.width()).arg(size.height()));
  window_.setDark(false);
}

TEST_F(CopyTest, ThePictureGoesToTheClipboard) {
  ASSERT_TRUE(waitForFrame());
  QSignalSpy exported(&window_, &MainWindow::exported);
  const QSize size = window_.canvas().size();
  QTest::keyClick(&window_, Qt::Key_C, Qt::ControlModifier);
  ASSERT_TRUE(waitFor([&] { return exported.count() == 1; }));
  const QImage image = QGuiApplication::clipboard()->image();
  EXPECT_EQ(image.size(), size);
  EXPECT_TRUE(fact("said").contains("clipboard"));
}

TEST_F(CopyTest, PicturesAreSavedAndOpenAsTheirScene) {
  ASSERT_TRUE(waitForFrame());
  const QTemporaryDir folder;
  QSignalSpy exported(&window_, &MainWindow::exported);
  int count = 0;
  for (const char* name : {"a.png", "a.svg", "a.pdf"}) {
    const QString file = folder.filePath(name);
    window_.savePicture(file);
    ASSERT_TRUE(waitFor([&] { return exported.count() == count + 1; })) << name;
    ++count;
    EXPECT_EQ(writeScene(readProvenance(file.toStdString())), writeScene(smallScene())) << name;
  }
  window_.savePicture(folder.filePath("a.bmp"));
  ASSERT_TRUE(waitFor([&] { return window_.messages().isVisible(); }));
  EXPECT_TRUE(window_.messages().text().contains(".bmp"));
}

}  // namespace
}  // namespace asperity
