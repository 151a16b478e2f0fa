// What leaves the window: its picture, and the command line that makes it, which the program's own
// readers take.
#include "ui/window/export/asperity_command.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QFile>
#include <QImage>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTabWidget>
#include <QTemporaryDir>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/scene/provenance.h"
#include "core/scene/scene_file.h"
#include "tests/core/temporary_folder.h"
#include "tests/ui/window/main_window_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "ui/chart/chart_view.h"
#include "ui/window/contact/contact_canvas.h"
#include "ui/window/main/exports.h"
#include "ui/window/main/message_bar.h"
#include "ui/window/main/scene_library.h"

namespace asperity {
namespace {

using AsperityCommandTest = MainWindowTest;

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
  return findScene(answer.fileName().toStdString()).scene;
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

TEST_F(AsperityCommandTest, AShippedSceneIsSaidByItsNameAndWhatDiffers) {
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

TEST_F(AsperityCommandTest, AFileIsSaidByItsPathHoweverItIsCalled) {
  const QTemporaryDir folder;
  const QString file = folder.filePath("it's mine.json");
  ASSERT_TRUE(window_.documentCommands().saveTo(file));
  type("sliding.velocity", "0.125 m/s");
  action("copyCurveCommand").trigger();
  const QStringList words = wordsOf(clipboardText());
  EXPECT_EQ(words.mid(0, 3), (QStringList{"asperity", "curve", file}));
  EXPECT_EQ(writeScene(sceneSaid(words)), writeScene(session().scene()));
}

/// The file names a table relative to its own folder, the scene in memory as it was opened.
TEST_F(AsperityCommandTest, AFileThatWasSavedElsewhereIsSaidByItsPath) {
  const TemporaryFolder folder;
  for (const char* name : {"a", "b"}) {
    std::filesystem::create_directory(folder / name);
    folder.write(std::string(name) + "/table.csv", "velocity,mu\n0.1,0.2\n1,0.3\n");
  }
  const QString file = QString::fromStdString((folder / "b/mine.json").string());
  for (const std::string& table : {std::string("table.csv"), (folder / "b/table.csv").string()}) {
    Scene scene = smallScene();
    scene.folder = folder / "a";
    scene.comparison.data = {{table, {}}};
    window_.document().open(scene);
    ASSERT_TRUE(window_.documentCommands().saveTo(file));
    QStringList words = wordsOf(curveCommand(window_.document().origin(), scene));
    EXPECT_EQ(words.mid(0, 3), (QStringList{"asperity", "curve", file})) << table;
    EXPECT_FALSE(words.contains("--set")) << words.join(' ').toStdString();
    scene.load.normalForce *= 2;
    words = wordsOf(curveCommand(window_.document().origin(), scene));
    EXPECT_EQ(words.value(2), file);
    EXPECT_EQ(words.count("--set"), 1) << words.join(' ').toStdString();
  }
}

/// The call reads the scene in the folder of its file, and not in that of the pinned curve.
TEST_F(AsperityCommandTest, APinnedCurveOfAnotherFileIsSaidByTheAbsoluteName) {
  Scene scene = smallScene();
  scene.folder = "/measured";
  scene.surface.kind = SurfaceKind::Profile;
  scene.surface.file = "present.csv";
  Scene pinned = scene;
  pinned.surface.file = "pinned.csv";
  CurveCommandOptions options;
  options.shown.emplace().pinned = {{{}, pinned, {}}};
  const QStringList words = wordsOf(curveCommand({}, scene, options));
  EXPECT_EQ(words.value(words.indexOf("--with") + 1), "surface.file=/measured/pinned.csv");
}

TEST_F(AsperityCommandTest, ASceneFromNowhereIsSaidWithAllThatDiffers) {
  Scene scene = smallScene();
  scene.title = "it's \"new\"";
  scene.description = "two\nlines";
  scene.elastomer.rheology = Rheology::Prony;
  scene.elastomer.arms = {{1e6, 1e-4}, {2e6, 1e-2}};
  window_.document().open(scene);
  action("copyCommand").trigger();
  EXPECT_EQ(writeScene(sceneSaid(wordsOf(clipboardText()))), writeScene(scene));
}

TEST_F(AsperityCommandTest, EveryShippedSceneComesBack) {
  for (const LibraryScene& entry : libraryScenes()) {
    Scene scene = entry.scene;
    scene.load.normalForce *= 1.5;
    const QString text = renderCommand({entry.name, {}, entry.scene}, scene, {});
    EXPECT_EQ(writeScene(sceneSaid(wordsOf(text))), writeScene(scene)) << text.toStdString();
  }
}

TEST_F(AsperityCommandTest, ColoursAreSaidWhereTheyAreNotTheUsualOnes) {
  action("copyCommand").trigger();
  EXPECT_FALSE(wordsOf(clipboardText()).contains("--overlay"));
  window_.canvas().setOverlay(ContactOverlay::Power);
  action("copyCommand").trigger();
  const QStringList words = wordsOf(clipboardText());
  EXPECT_EQ(words.value(words.indexOf("--overlay") + 1), "power");
}

TEST_F(AsperityCommandTest, ThePictureIsSaidAsItIsShown) {
  window_.appearance().setDark(true);
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
  window_.appearance().setDark(false);
}

/// What a copied call draws.
class CallTest : public MainWindowTest {
 protected:
  void pause() {
    if (session().isPlaying()) session().setPlaying(false);
    ASSERT_TRUE(waitForFrame());
    ASSERT_TRUE(waitForRest());
  }
  QStringList copied() {
    action("copyCommand").trigger();
    return wordsOf(clipboardText());
  }
  static void drop(QStringList& words, const QString& option) {
    const qsizetype at = words.indexOf(option);
    if (at >= 0) words.remove(at, 2);
  }
  QImage drawn(QStringList words) {
    const QString file = folder_.filePath("drawn.png");
    words.removeFirst();
    words[words.indexOf("-o") + 1] = file;
    QProcess program;
    program.start(ASPERITY_PROGRAM, words + QStringList{"--json"});
    EXPECT_TRUE(program.waitForFinished(60000));
    EXPECT_EQ(program.exitCode(), 0) << program.readAllStandardError().toStdString();
    said_ = QJsonDocument::fromJson(program.readAllStandardOutput()).object();
    return QImage(file);
  }
  QImage shown() {
    const QString file = folder_.filePath("shown.png");
    EXPECT_TRUE(savePicture(file));
    return QImage(file);
  }
  /// Pixels of the whole picture that are not the same to the last bit.
  static int differing(const QImage& a, const QImage& b) {
    if (a.size() != b.size()) return a.width() * a.height();
    int differ = 0;
    for (int y = 0; y < a.height(); ++y)
      for (int x = 0; x < a.width(); ++x) differ += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0;
    return differ;
  }
  /// Share of the pixels in the plot that are not much the same: the readings above it and the
  /// points between which lines are straight may differ.
  double difference(const QImage& a, const QImage& b) {
    const QRect plot = window_.canvas().plotArea().toRect();
    int differ = 0;
    for (int y = plot.top(); y < plot.bottom(); ++y)
      for (int x = plot.left(); x < plot.right(); ++x) {
        const QColor p = a.pixelColor(x, y), q = b.pixelColor(x, y);
        const int apart = std::abs(p.red() - q.red()) + std::abs(p.green() - q.green()) +
                          std::abs(p.blue() - q.blue());
        differ += apart > 90 ? 1 : 0;
      }
    return static_cast<double>(differ) / (plot.width() * plot.height());
  }

  const QTemporaryDir folder_;
  QJsonObject said_;
};

TEST_F(CallTest, DrawsTheMomentAndThePlaceThatAreShown) {
  ASSERT_TRUE(waitFor([&] { return frame() && frame()->distance > 0.1 * frame()->length; }));
  pause();
  control<QTabWidget>("tabs").setCurrentIndex(2);
  ContactCanvas& canvas = window_.canvas();
  for (int i = 0; i < 5; ++i) canvas.zoom(1);
  canvas.exaggerate(-1);
  const QStringList words = copied();
  const QImage inWindow = shown(), byCall = drawn(words);
  ASSERT_EQ(inWindow.size(), byCall.size());
  EXPECT_LT(difference(inWindow, byCall), 0.03);
  for (const char* option : {"--view", "--slid", "--heights"}) {
    QStringList without = words;
    ASSERT_TRUE(words.contains(option)) << words.join(' ').toStdString();
    drop(without, option);
    EXPECT_GT(difference(inWindow, drawn(without)), 0.05) << option;
  }
}

TEST_F(CallTest, DrawsColoursCrosshairAndMagnifier) {
  pause();
  control<QTabWidget>("tabs").setCurrentIndex(2);
  ContactCanvas& canvas = window_.canvas();
  canvas.setOverlay(ContactOverlay::Power);
  canvas.magnify(true);
  QTest::mouseMove(&canvas, canvas.plotArea().center().toPoint());
  ASSERT_TRUE(waitFor([&] { return !frame()->power.empty() && !frame()->lineSlope.empty(); }));
  const QStringList words = copied();
  for (const char* option : {"--overlay", "--colours-to", "--probe", "--magnify"})
    EXPECT_TRUE(words.contains(option)) << words.join(' ').toStdString();
  EXPECT_LT(difference(shown(), drawn(words)), 0.04);
}

Scene motionOf(SlidingKind kind) {
  Scene scene = smallScene();
  scene.sliding.kind = kind;
  scene.sliding.velocity = kind == SlidingKind::Oscillation ? 0 : 0.02;
  scene.sliding.velocityAfter = 0.05;
  scene.sliding.amplitude = 0.05;
  scene.sliding.frequency = 20;
  scene.sliding.duration = 0.1;
  return scene;
}

/// To the last pixel, with crosshair and magnifier, whatever the colours say.
TEST_F(CallTest, DrawsTheMomentOfAMotion) {
  ContactCanvas& canvas = window_.canvas();
  for (const auto& [kind, overlay] : {std::pair{SlidingKind::Oscillation, ContactOverlay::Pressure},
                                      {SlidingKind::Step, ContactOverlay::Relaxation},
                                      {SlidingKind::Start, ContactOverlay::Power}}) {
    canvas.setOverlay(overlay);
    canvas.magnify(true);
    window_.document().open(motionOf(kind));
    session().setPlaying(true);
    ASSERT_TRUE(waitFor([&] {
      return frame() && frame()->sceneNumber == session().sceneNumber() && frame()->time > 0.005;
    }));
    pause();
    control<QTabWidget>("tabs").setCurrentIndex(2);
    QTest::mouseMove(&canvas, canvas.plotArea().topLeft().toPoint() + QPoint(40, 40));
    QTest::mouseMove(&canvas, canvas.plotArea().center().toPoint());
    ASSERT_TRUE(waitFor([&] { return !frame()->lineSlope.empty(); }));
    const QStringList words = copied();
    for (const char* option : {"--at", "--probe", "--magnify"})
      EXPECT_TRUE(words.contains(option)) << words.join(' ').toStdString();
    EXPECT_EQ(differing(shown(), drawn(words)), 0) << words.join(' ').toStdString();
    EXPECT_EQ(said_["mu"].toDouble(), frame()->state.mu);
    // No more digits than tell the moment from the next step.
    const QString at = words.value(words.indexOf("--at") + 1);
    EXPECT_GE(at.toDouble(), frame()->time);
    EXPECT_LT(at.toDouble(), frame()->time + frame()->nextStep);
    EXPECT_LE(at.size(), 8) << at.toStdString();
    // The chart in front is drawn, too, under the same picture.
    control<QTabWidget>("tabs").setCurrentWidget(&window_.plotView());
    const QStringList both = copied();
    EXPECT_EQ(both.value(both.indexOf("--layout") + 1), "both");
    const QImage picture = drawn(both), contact = shown();
    EXPECT_LT(difference(contact, picture), 0.001);
    EXPECT_GT(picture.height(), 1.5 * canvas.height());
  }
}

TEST_F(CallTest, AStillSaysNothingOfItsMovingOnTheScreen) {
  ASSERT_TRUE(waitFor([&] { return frame() && frame()->timeScale > 0; }));
  const auto still = stillCopy(*frame());
  EXPECT_EQ(still->timeScale, 0);
  EXPECT_EQ(still->time, frame()->time);
}

TEST_F(CallTest, DrawsWhatTheCurveIsComparedWith) {
  ASSERT_TRUE(waitFor([&] { return session().averaging() == Session::Averaging::Done; }));
  action("pinCurve").trigger();
  type("load.normal_force", "0.02 N");
  control<QComboBox>("comparisonScheme").setCurrentIndex(static_cast<int>(Scheme::Linear));
  control<QSpinBox>("comparisonOversampling").setValue(3);
  control<QSpinBox>("comparisonLines").setValue(5);
  control<QCheckBox>("comparisonWanted").setChecked(true);
  ASSERT_TRUE(waitFor([&] { return session().averaging() == Session::Averaging::Done; }));
  action("dimensionlessAxes").trigger();
  pause();
  const QStringList words = copied();
  EXPECT_EQ(words.value(words.indexOf("--compare") + 1), "linear:3:5");
  EXPECT_EQ(words.value(words.indexOf("--axes") + 1), "dimensionless");
  const int height = words.value(words.indexOf("--size") + 1).section('x', 1).toInt();
  EXPECT_GE(height, window_.canvas().height() + window_.plotView().height());
  EXPECT_EQ(words.value(words.indexOf("--with") + 1), "load.normal_force=0.0034");
  EXPECT_FALSE(drawn(words).isNull());
  action("copyCurveCommand").trigger();
  const QStringList curve = wordsOf(clipboardText());
  for (const char* option : {"--compare", "--axes", "--with"})
    EXPECT_TRUE(curve.contains(option)) << option;
  QProcess program;
  program.setWorkingDirectory(folder_.path());
  program.start(ASPERITY_PROGRAM, curve.mid(1));
  EXPECT_TRUE(program.waitForFinished(60000));
  EXPECT_EQ(program.exitCode(), 0) << program.readAllStandardError().toStdString();
  EXPECT_TRUE(QFile::exists(folder_.filePath("curve.csv")));
}

TEST_F(AsperityCommandTest, ThePictureGoesToTheClipboard) {
  ASSERT_TRUE(waitForFrame());
  const QSize size = window_.canvas().size();
  QTest::keyClick(&window_, Qt::Key_C, Qt::ControlModifier);
  ASSERT_TRUE(waitFor([&] { return said() == "The picture is on the clipboard"; }));
  const QImage image = QGuiApplication::clipboard()->image();
  EXPECT_EQ(image.size(), size);
}

TEST_F(AsperityCommandTest, PicturesAreSavedAndOpenAsTheirScene) {
  ASSERT_TRUE(waitForFrame());
  const QTemporaryDir folder;
  for (const char* name : {"a.png", "a.svg", "a.pdf"}) {
    const QString file = folder.filePath(name);
    ASSERT_TRUE(savePicture(file)) << name;
    EXPECT_EQ(writeScene(findScene(file.toStdString()).scene), writeScene(smallScene())) << name;
  }
  EXPECT_FALSE(savePicture(folder.filePath("a.bmp")));
  EXPECT_TRUE(window_.messages().text().contains(".bmp"));
}

}  // namespace
}  // namespace asperity
