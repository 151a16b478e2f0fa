// The page on which a measured surface becomes the line of the scene, as a person uses it.
#include "ui/window/import/surface_import.h"
#include "ui/panels/parameter_text.h"

#include <gtest/gtest.h>

#include <QAbstractEventDispatcher>
#include <QEvent>
#include <QFile>
#include <QHash>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "core/base/jobs.h"
#include "core/friction/ensemble.h"
#include "core/surface/line_source.h"
#include "tests/app/program.h"
#include "tests/ui/window/import/surface_import_fixture.h"
#include "tests/ui/window/main_window_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "ui/language/language.h"
#include "ui/window/figures/diagram_view.h"
#include "ui/window/import/import_commands.h"
#include "ui/window/main/scene_library.h"

namespace asperity {
namespace {

TEST_F(SurfaceImportTest, MakesTheFileTheSceneInOneStep) {
  const Scene before = scene();
  openPage(sineFile());
  ASSERT_TRUE(waitForPage());
  ASSERT_TRUE(page_->isReady()) << page_->errorText().toStdString();
  // A whole number of waves: Pq is the amplitude over sqrt 2, up to the line that is removed and
  // the six decimals of the file.
  EXPECT_NEAR(page_->summary()->used.pq, kSineAmplitude / std::sqrt(2), 0.02 * kSineAmplitude);
  EXPECT_TRUE(inPage<QLabel>("surfaceValues").text().contains("Pq"));
  EXPECT_FALSE(inPage<QLabel>("surfaceFacts").text().isEmpty());
  EXPECT_EQ(scene(), before);
  click("importAccept");
  ASSERT_TRUE(waitFor([&] { return page_.isNull(); }));
  EXPECT_EQ(scene().surface.kind, SurfaceKind::Measured);
  EXPECT_EQ(scene().ensemble.realizations, 0);
  EXPECT_EQ(window_.document().history().count(), 1);
  ASSERT_TRUE(waitForFrame());
  EXPECT_NEAR(frame()->length, 2e-3, 1e-8);  // mirrored
  window_.document().history().undo();
  EXPECT_EQ(scene(), before);
}

/// Legends beside the charts left them a third of the width, and were cut themselves.
TEST_F(SurfaceImportTest, ChartsAreWideInASmallWindow) {
  useLanguage("de");
  openPage(sineFile(0.05));
  page_->resize(984, 620);
  ASSERT_TRUE(waitForPage());
  const auto& spectrum = inPage<DiagramView>("surfaceSpectrum");
  ASSERT_TRUE(waitFor([&] { return spectrum.isPainted() && spectrum.frames().size() == 2; }));
  for (const ChartGeometry& frame : spectrum.frames())
    EXPECT_GT(frame.area.width(), 0.25 * spectrum.width());
  useLanguage("en");
}

/// What was imported is seen, also where a gallery was in front, and does not keep the title of a
/// shipped scene.
TEST_F(SurfaceImportTest, ClosesTheGalleryAndTakesTheNameOfTheFile) {
  const LibraryScene& shipped = libraryScenes().front();
  window_.document().open(shipped.scene);
  ASSERT_TRUE(waitForFrame());
  window_.pages().openFigures();
  openPage(sineFile());
  ASSERT_TRUE(waitForPage());
  click("importAccept");
  ASSERT_TRUE(waitFor([&] { return page_.isNull(); }));
  EXPECT_TRUE(window_.pages().isShowingViews());
  EXPECT_NE(scene().title, shipped.scene.title);
  EXPECT_NE(scene().title.find("profile"), std::string::npos) << scene().title;
}

/// A title that came from a surface goes with it; one that the user wrote stays.
TEST_F(SurfaceImportTest, TheTitleFollowsTheSurfaceUnlessItWasWritten) {
  window_.document().open(libraryScenes().front().scene);
  const auto take = [&](const QString& file) {
    openPage(file);
    EXPECT_TRUE(waitForPage());
    click("importAccept");
    EXPECT_TRUE(waitFor([&] { return page_.isNull(); }));
    return scene().title;
  };
  const QString file = sineFile(), other = folder_.filePath("other.csv");
  ASSERT_TRUE(QFile::copy(file, other));
  EXPECT_EQ(take(file), "profile");
  EXPECT_EQ(take(other), "other");
  Scene mine = scene();
  mine.title = "my road";
  window_.document().edit(mine);
  EXPECT_EQ(take(file), "my road");
}

/// A column of a table as the program writes it; numbers read back to the same bits.
std::vector<double> columnOf(const std::string& csv, const std::string& name) {
  std::istringstream lines(csv);
  std::string line;
  while (std::getline(lines, line) && line.starts_with("#")) {
  }
  const auto split = [](const std::string& row) {
    std::vector<std::string> cells;
    std::istringstream in(row);
    for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
    return cells;
  };
  const std::vector<std::string> names = split(line);
  const auto column = std::ranges::find(names, name) - names.begin();
  std::vector<double> values;
  while (std::getline(lines, line))
    values.push_back(
        std::strtod(split(line).at(static_cast<std::size_t>(column)).c_str(), nullptr));
  return values;
}

/// `asperity surface FILE`, `asperity curve SCENE` and the page make the same line of a file, bit
/// for bit: the heights of the first and of the page, the friction of the second and of the page.
TEST_F(SurfaceImportTest, TheProgramAndThePageMakeTheSameLine) {
  const std::string file = sineFile(0.01).toStdString();
  openPage(QString::fromStdString(file));
  ASSERT_TRUE(waitForPage());
  click("importAccept");
  ASSERT_TRUE(waitFor([&] { return page_.isNull(); }));
  const Line ofPage = LineSource(scene(), 1).make(0);

  const Program program;
  Said said = program.run("surface '" + file + "' -o line.csv --quiet");
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_EQ(columnOf(TemporaryFolder::read(program.folder / "line.csv"), "height"), ofPage.height);

  Scene few = scene();
  few.sweep = {1e-3, 1, 4};
  write("scene.json", R"({"surface": {"kind": "measured", "file": "profile.csv"},
                         "ensemble": {"realizations": 0},
                         "sweep": {"velocity_from": 1e-3, "velocity_to": 1, "points": 4}})");
  said = program.run("curve '" + folder_.filePath("scene.json").toStdString() + "' --quiet");
  ASSERT_EQ(said.status, 0) << said.err;
  Scene alike = few;  // what else the page's scene says is not the file's
  alike.elastomer = {};
  alike.load = {};
  alike.accuracy = {};
  std::vector<double> friction;
  for (const CurvePoint& point : frictionCurve(alike).points) friction.push_back(point.mu);
  EXPECT_EQ(columnOf(said.out, "mu"), friction);
}

TEST_F(SurfaceImportTest, AStepIsShownAtOnce) {
  openPage(sineFile(0.05));
  ASSERT_TRUE(waitForPage());
  // A tilt of 0.05 over 1 mm has an rms height of 0.05 mm / sqrt 12.
  EXPECT_NEAR(page_->summary()->raw.pq, 0.05e-3 / std::sqrt(12.0), 1e-6);
  const double withoutTilt = page_->summary()->used.pq;
  EXPECT_LT(withoutTilt, kSineAmplitude);
  choose("surface.form", "mean");
  ASSERT_TRUE(page_->isReading());
  EXPECT_FALSE(inPage<QPushButton>("importAccept").isEnabled());
  ASSERT_TRUE(waitForPage());
  EXPECT_NEAR(page_->summary()->used.pq, page_->summary()->raw.pq, 1e-9);
  auto& sheet = inPage<DiagramView>("surfaceProfile");
  EXPECT_TRUE(waitFor([&] { return sheet.isPainted(); }));
}

/// Without a unit, 400 units of length would be 400 m: the page asks, and goes on with the answer.
TEST_F(SurfaceImportTest, AsksForAUnitThatIsMissing) {
  std::string text;
  for (int i = 0; i < kSinePoints; ++i)
    text += std::to_string(i) + " " + std::to_string(100 * std::sin(i * 0.3)) + "\n";
  openPage(write("plain.txt", text));
  ASSERT_TRUE(waitForPage());
  EXPECT_FALSE(page_->isReady());
  EXPECT_FALSE(page_->errorText().isEmpty());
  EXPECT_FALSE(page_->errorText().contains('\n'));
  EXPECT_FALSE(inPage<QPushButton>("importAccept").isEnabled());
  choose("surface.position_unit", "um");
  ASSERT_TRUE(waitForPage());
  choose("surface.height_unit", "nm");
  ASSERT_TRUE(waitForPage());
  EXPECT_TRUE(page_->isReady()) << page_->errorText().toStdString();
  EXPECT_NEAR(page_->summary()->spacing, 1e-6, 1e-12);
}

/// The unit of a column can be chosen in the page, by the label that it has there.
TEST_F(SurfaceImportTest, AnUnknownUnitNamesTheControlThatChoosesAnother) {
  openPage(sineFile(0, "x [s];z [µm]\n"));
  ASSERT_TRUE(waitForPage());
  const QString label = labelText(*findParameter("surface.position_unit"));
  EXPECT_TRUE(page_->errorText().contains(QStringLiteral("“%1” can name another").arg(label)))
      << page_->errorText().toStdString();
}

TEST_F(SurfaceImportTest, SaysWhatIsWrongInOneLine) {
  openPage(write("nothing.csv", "these are words and no numbers\n"));
  ASSERT_TRUE(waitForPage());
  EXPECT_FALSE(page_->isReady());
  EXPECT_FALSE(page_->errorText().isEmpty());
  EXPECT_FALSE(page_->errorText().contains('\n'));
  openPage(folder_.filePath("gone.sdf"));
  ASSERT_TRUE(waitForPage());
  EXPECT_FALSE(page_->isReady());
}

TEST_F(SurfaceImportTest, ShowsATopographyAndItsRows) {
  std::string text = "x [um] y [um] z [nm]\n";
  for (int row = 0; row < 8; ++row)
    for (int column = 0; column < 32; ++column)
      text += std::to_string(column) + " " + std::to_string(2 * row) + " " +
              std::to_string(100 * std::sin(0.7 * column + row)) + "\n";
  openPage(write("points.txt", text));
  ASSERT_TRUE(waitForPage());
  ASSERT_TRUE(page_->isReady()) << page_->errorText().toStdString();
  EXPECT_TRUE(inPage<QWidget>("topographyPicture").isVisible());
  EXPECT_EQ(page_->summary()->rowsUsed, 8);
  auto& entry = inPage<ValueEntry>("entry:surface.row");
  entry.setFocus();
  entry.selectAll();
  QTest::keyClicks(&entry, "3");
  QTest::keyClick(&entry, Qt::Key_Return);
  ASSERT_TRUE(waitForPage());
  EXPECT_EQ(page_->summary()->rowsUsed, 1);
  EXPECT_EQ(page_->summary()->rowInFile, 3);
  choose("surface.direction", "along_y");
  ASSERT_TRUE(waitForPage());
  ASSERT_TRUE(page_->isReady()) << page_->errorText().toStdString();
  EXPECT_NEAR(page_->summary()->spacing, 2e-6, 1e-12);
}

/// Counts how often each widget's style is worked out, which is most of what a page costs to build.
class StyleChanges : public QObject {
 public:
  StyleChanges() { qApp->installEventFilter(this); }
  int of(const QObject* widget) const { return counts_.value(widget); }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::StyleChange) ++counts_[watched];
    return false;
  }

 private:
  QHash<const QObject*, int> counts_;
};

TEST_F(SurfaceImportTest, EveryWidgetOfThePageIsStyledOnce) {
  const QString file = sineFile();
  const StyleChanges changes;
  openPage(file);
  const QList<QWidget*> widgets = page_->findChildren<QWidget*>();
  int all = 0;
  for (const QWidget* widget : widgets) all += changes.of(widget);
  EXPECT_GT(widgets.size(), 120);
  EXPECT_LT(all, 1.25 * static_cast<double>(widgets.size()));
}

/// The longest time that the window's thread works between two waits, in time of its processor.
class LongestWork : public QObject {
 public:
  LongestWork() {
    const QAbstractEventDispatcher* events = QAbstractEventDispatcher::instance();
    connect(events, &QAbstractEventDispatcher::awake, this, [this] { begin_ = threadSeconds(); });
    connect(events, &QAbstractEventDispatcher::aboutToBlock, this,
            [this] { longest_ = std::max(longest_, threadSeconds() - begin_); });
  }
  double seconds() const { return longest_; }

 private:
  double begin_ = threadSeconds(), longest_ = 0;
};

/// A square topography in Gwyddion's simple form, with heights of some micrometres over 1 mm.
std::string squareFile(int points) {
  const std::string header = "Gwyddion Simple Field 1.0\nXRes = " + std::to_string(points) +
                             "\nYRes = " + std::to_string(points) +
                             "\nXReal = 1e-3\nYReal = 1e-3\nXYUnits = m\nZUnits = m\n";
  std::string bytes = header + std::string(4 - header.size() % 4, '\0');
  std::vector<float> row(static_cast<std::size_t>(points));
  for (int y = 0; y < points; ++y) {
    for (int x = 0; x < points; ++x)
      row[static_cast<std::size_t>(x)] = static_cast<float>((x * 7919 + y * 104729) % 1009) * 1e-9F;
    bytes.append(reinterpret_cast<const char*>(row.data()), row.size() * sizeof(float));
  }
  return bytes;
}

/// Opens a page of its own and returns the longest work of the window's thread for it.
double longestWorkFor(const QString& file) {
  SurfaceImport page(Scene{}, file);
  page.show();
  EXPECT_TRUE(QTest::qWaitForWindowExposed(&page));
  const LongestWork work;
  const auto& spectrum = *page.findChild<DiagramView*>("surfaceSpectrum");
  EXPECT_TRUE(QTest::qWaitFor([&] { return page.isReady() && spectrum.isPainted(); }, 60000))
      << page.errorText().toStdString();
  return work.seconds();
}

/// Reading 4096 x 4096 heights, their picture and their values are made elsewhere.
TEST_F(SurfaceImportTest, ALargeFileDoesNotKeepTheWindowsThread) {
  const QString small = write("small.gsf", squareFile(64));
  const QString large = write("large.gsf", squareFile(4096));
  const double usual = longestWorkFor(small);
  const double least = std::min(longestWorkFor(large), longestWorkFor(large));
  EXPECT_LT(least, 2 * usual + 0.02);
}

/// Stopped in the middle of 4096 x 4096 heights nothing more of them arrives.
TEST_F(SurfaceImportTest, ALargeFileCanBeStopped) {
  openPage(write("large.gsf", squareFile(4096)));
  auto& progress = inPage<QProgressBar>("importProgress");
  ASSERT_TRUE(waitFor([&] { return progress.value() > 0 || !page_->isReading(); }));
  ASSERT_TRUE(page_->isReading());
  click("importStop");
  EXPECT_FALSE(page_->isReading());
  const int reached = progress.value();
  QTest::qWait(300);
  EXPECT_EQ(progress.value(), reached);
  EXPECT_FALSE(page_->isReading());
  EXPECT_FALSE(page_->isReady());
  EXPECT_FALSE(page_->summary());
}

TEST_F(SurfaceImportTest, ADroppedFileOpensThePage) {
  drop(sineFile());
  ASSERT_TRUE(waitFor([&] { return window_.findChild<SurfaceImport*>() != nullptr; }));
  page_ = window_.findChild<SurfaceImport*>();
  ASSERT_TRUE(waitForPage());
  EXPECT_TRUE(page_->isReady()) << page_->errorText().toStdString();
}

/// The same file again begins with the choices that were made for it.
TEST_F(SurfaceImportTest, KeepsTheChoicesOfTheSameFile) {
  const QString file = sineFile();
  openPage(file);
  ASSERT_TRUE(waitForPage());
  choose("surface.form", "parabola");
  ASSERT_TRUE(waitForPage());
  click("importAccept");
  ASSERT_TRUE(waitFor([&] { return page_.isNull(); }));
  openPage(file);
  ASSERT_TRUE(waitForPage());
  EXPECT_EQ(page_->panel().scene().surface.processing.form, FormRemoval::Parabola);
}

TEST_F(SurfaceImportTest, SteepLinesAreNotedInTheStatusLine) {
  auto& notes = control<QToolButton>("factNotes");
  ASSERT_TRUE(waitFor([&] { return session().friction().progress() >= 1; }));
  Scene pressed = scene();
  pressed.load.normalForce = 1;  // so that many summits touch
  window_.document().edit(pressed);
  ASSERT_TRUE(waitFor([&] { return !notes.isVisible(); }));
  const int height = window_.canvas().height();
  Scene steep = scene();
  steep.surface.rmsHeight = 1e-3;
  window_.document().edit(steep);
  ASSERT_TRUE(waitFor([&] { return notes.isVisible(); }));
  EXPECT_TRUE(notes.toolTip().contains("0.3")) << notes.toolTip().toStdString();
  EXPECT_EQ(window_.canvas().height(), height);
}

}  // namespace
}  // namespace asperity
