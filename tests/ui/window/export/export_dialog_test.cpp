// The export dialog: a preview of the newest wish, what is wrong with a value, and a file that has
// the same bytes as that of the command it shows.
#include "ui/window/export/export_dialog.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QFile>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>

#include "core/scene/scene_file.h"
#include "tests/ui/window/export/export_dialog_fixture.h"
#include "tests/ui/window/main_window_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "ui/window/export/export_form.h"
#include "ui/window/export/export_preview.h"
#include "ui/window/export/export_size_fields.h"
#include "ui/window/figures/figures_page.h"

namespace asperity {
namespace {

TEST_F(ExportDialogTest, APictureHasTheBytesOfItsCommand) {
  type("load.normal_force", "12 mN");
  window_.canvas().zoom(3);
  ASSERT_TRUE(waitForFrame());
  openDialog(ExportKind::Picture);
  choose("exportContent", "contact");
  expectSameBytes("contact.png");
  openDialog(ExportKind::Picture);
  choose("exportContent", "both");
  choose("exportPreset", "slide");
  choose("exportTheme", "dark");
  in<QCheckBox>("exportTransparent").setChecked(true);
  expectSameBytes("both.png");
}

TEST_F(ExportDialogTest, VectorsAndStylesHaveTheBytesOfTheirCommands) {
  openDialog(ExportKind::Picture);
  choose("exportContent", "curve");
  choose("exportFormat", ".pdf");
  choose("exportStyle", "journal");
  EXPECT_EQ(in<QComboBox>("exportPreset").currentData(), "style");
  EXPECT_EQ(in<QLineEdit>("exportWidth").text(), "86");
  EXPECT_EQ(in<QLineEdit>("exportDensity").text(), "600");
  EXPECT_EQ(in<QComboBox>("exportTheme").currentData(), "");
  EXPECT_TRUE(command().contains("--style journal"));
  EXPECT_FALSE(command().contains("--size"));
  expectSameBytes("curve.pdf");
  openDialog(ExportKind::Picture);
  choose("exportContent", "contact");
  choose("exportFormat", ".svg");
  choose("exportPreset", "column");
  EXPECT_TRUE(command().contains("--size 86mmx62mm --scale 600dpi"));
  expectSameBytes("contact.svg");
}

/// Dialog, preview and file agree about the size, with a curve below the contact, too.
TEST_F(ExportDialogTest, ASlideHasTheSizeThatTheDialogShows) {
  openDialog(ExportKind::Picture);
  choose("exportContent", "both");
  choose("exportStyle", "slides");
  EXPECT_EQ(in<QLineEdit>("exportWidth").text(), "1920");
  EXPECT_EQ(in<QLineEdit>("exportHeight").text(), "1080");
  EXPECT_EQ(in<QComboBox>("exportUnit").currentData(), "");
  ASSERT_TRUE(waitForPreview()) << reason().toStdString();
  const QSize preview = dialog_->preview().image().size();
  EXPECT_EQ(9 * preview.width(), 16 * preview.height());
  const QString file = folder_.filePath("slide.png");
  dialog_->setFile(file);
  dialog_->write();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !exports_->isEmpty() || !reason().isEmpty(); },
                              kExportPatience));
  ASSERT_FALSE(exports_->isEmpty()) << reason().toStdString();
  EXPECT_EQ(QImage(file).size(), QSize(1920, 1080));
}

TEST_F(ExportDialogTest, ATableHasTheBytesOfItsCommand) {
  openDialog(ExportKind::Table);
  enter("exportColumns", "velocity, mu");
  EXPECT_TRUE(command().contains("--columns velocity,mu"));
  expectSameBytes("curve.csv");
  openDialog(ExportKind::Table);
  choose("exportContent", "shape");
  choose("exportFormat", ".json");
  expectSameBytes("shape.json");
}

/// Whatever else the command can do is within reach, and quotes are those of a shell.
TEST_F(ExportDialogTest, OtherOptionsReachTheCommand) {
  openDialog(ExportKind::Picture);
  choose("exportContent", "curve");
  enter("exportFurther", "--font-size 9 --title \"two words\"");
  EXPECT_TRUE(command().endsWith("--font-size 9 --title 'two words'")) << command().toStdString();
  expectSameBytes("curve.svg");
  openDialog(ExportKind::Picture);
  enter("exportFurther", "--no-such-option");
  EXPECT_FALSE(waitForPreview());
  EXPECT_TRUE(reason().contains("--no-such-option")) << reason().toStdString();
}

/// A table may have several files: the preview would write this one without a question.
TEST_F(ExportDialogTest, TheOtherOptionsNameNoFile) {
  const QString file = fileOfBefore("data.csv");
  openDialog(ExportKind::Table);
  for (const char* option : {"-o %1", "--output=%1", "-o%1"}) {
    enter("exportFurther", QString(option).arg(file));
    EXPECT_FALSE(waitForPreview()) << option;
    EXPECT_TRUE(reason().contains("file")) << reason().toStdString();
    EXPECT_FALSE(in<QPushButton>("exportWrite").isEnabled());
    EXPECT_EQ(exportedBytes(file), "before");
  }
}

TEST_F(ExportDialogTest, TheNumberOfThreadsCanBeTyped) {
  openDialog(ExportKind::Table);
  enter("exportFurther", "--threads 2");
  EXPECT_TRUE(waitForPreview()) << reason().toStdString();
}

TEST_F(ExportDialogTest, WhatWritesNoFileIsNoExport) {
  openDialog(ExportKind::Table);
  enter("exportFurther", "--help");
  EXPECT_FALSE(waitForPreview());
  EXPECT_TRUE(reason().contains("no file")) << reason().toStdString();
  dialog_->setFile(folder_.filePath("curve.csv"));
  dialog_->write();
  ASSERT_TRUE(waitFor([&] { return !dialog_ || dialog_->form().isEnabled(); }));
  EXPECT_TRUE(exports_->isEmpty());
  EXPECT_TRUE(dialog_ && dialog_->isVisible());
}

TEST_F(ExportDialogTest, AFilmHasTheBytesOfItsCommand) {
  openDialog(ExportKind::Film);
  choose("exportContent", "contact");
  choose("exportFormat", ".gif");
  enter("exportWidth", "320");
  enter("exportHeight", "200");
  enter("exportDuration", "0,4");  // as people write it
  enter("exportRate", "10");
  enter("exportSpeedValue", "0.5");
  EXPECT_TRUE(command().contains("--size 320x200"));
  EXPECT_TRUE(command().contains("--duration 0.4 --fps 10 --cycles 0.5"));
  expectSameBytes("film.gif");
}

/// Marks between thousands are no decimal signs, here as in every other entry of the window.
TEST_F(ExportDialogTest, NumbersMayHaveMarksBetweenThousands) {
  openDialog(ExportKind::Film);
  enter("exportWidth", "1,280");
  enter("exportDuration", "1,200");
  EXPECT_TRUE(command().contains("--size 1280x")) << command().toStdString();
  EXPECT_TRUE(command().contains("--duration 1200 ")) << command().toStdString();
}

TEST_F(ExportDialogTest, AMotionHasItsOwnContentsAndSpeeds) {
  Scene moving = smallScene();
  moving.sliding.kind = SlidingKind::Start;
  moving.sliding.duration = 0.01;
  window_.document().open(moving);
  ASSERT_TRUE(waitForFrame());
  openDialog(ExportKind::Film);
  EXPECT_EQ(in<QComboBox>("exportContent").currentData(), "transient");
  choose("exportSpeed", "slow");
  enter("exportSpeedValue", "100");
  EXPECT_FALSE(in<QLineEdit>("exportDuration").isEnabled());
  EXPECT_TRUE(command().contains("--slow-motion 100"));
  EXPECT_FALSE(command().contains("--duration"));
  dialog_->form().setKind(ExportKind::Table);
  EXPECT_EQ(in<QComboBox>("exportContent").currentData(), "motion");
  expectSameBytes("motion.csv");
}

TEST_F(ExportDialogTest, ThePreviewShowsTheNewestWish) {
  openDialog(ExportKind::Picture);
  choose("exportContent", "contact");
  ASSERT_TRUE(waitForPreview());
  const QImage light = dialog_->preview().image();
  ASSERT_FALSE(light.isNull());
  EXPECT_LE(std::max(light.width(), light.height()), 1000);
  // Many wishes, of which the last counts.
  for (const char* theme : {"print", "paper", "light", "dark"}) choose("exportTheme", theme);
  ASSERT_TRUE(waitForPreview());
  EXPECT_LT(dialog_->preview().image().pixelColor(2, 2).lightness(), 100);
  EXPECT_GT(light.pixelColor(2, 2).lightness(), 150);
  in<QCheckBox>("exportTransparent").setChecked(true);
  ASSERT_TRUE(waitForPreview());
  EXPECT_EQ(dialog_->preview().image().pixelColor(2, 2).alpha(), 0);
  dialog_->form().setKind(ExportKind::Table);
  ASSERT_TRUE(waitForPreview());
  EXPECT_TRUE(dialog_->preview().text().contains("velocity,mu"));
}

/// The preview of a large picture has its shape, and the same layout on less pixels.
TEST_F(ExportDialogTest, ThePreviewOfALargePictureIsSmall) {
  openDialog(ExportKind::Picture);
  choose("exportContent", "contact");
  choose("exportPreset", "4k");
  ASSERT_TRUE(waitForPreview());
  const QSize size = dialog_->preview().image().size();
  EXPECT_LE(size.width(), 1000);
  EXPECT_NEAR(1.0 * size.width() / size.height(), 16.0 / 9, 0.01);
  choose("exportPreset", "page");
  ASSERT_TRUE(waitForPreview());
  const QSize paper = dialog_->preview().image().size();
  EXPECT_NEAR(1.0 * paper.width() / paper.height(), 178.0 / 130, 0.02);
}

TEST_F(ExportDialogTest, ABadValueIsSaidAndCannotBeExported) {
  openDialog(ExportKind::Picture);
  choose("exportContent", "contact");
  const struct {
    const char *entry, *bad, *good, *said;
  } cases[] = {{"exportWidth", "20", "800", "a width of 20 pixels; 160 to 16384"},
               {"exportWidth", "wide", "800", "numbers above 0"},
               {"exportHeight", "", "600", "numbers above 0"},
               {"exportHeight", "1e300", "600", "160 to 16384"},
               {"exportDensity", "-3", "96", "numbers above 0"},
               {"exportDensity", "nan", "96", "numbers above 0"},
               {"exportDensity", "1e6", "96", "Resolution (dpi): "}};
  for (const auto& [entry, bad, good, said] : cases) {
    in<QLineEdit>(entry).clear();
    enter(entry, bad);
    emit in<QLineEdit>(entry).textEdited(bad);
    EXPECT_FALSE(waitForPreview()) << entry << " " << bad;
    EXPECT_TRUE(reason().contains(said)) << bad << ": " << reason().toStdString();
    EXPECT_FALSE(in<QPushButton>("exportWrite").isEnabled());
    enter(entry, good);
    EXPECT_TRUE(waitForPreview()) << entry << " " << good << reason().toStdString();
    EXPECT_EQ(reason(), "");
    EXPECT_TRUE(in<QPushButton>("exportWrite").isEnabled());
  }
  dialog_->form().setKind(ExportKind::Table);
  enter("exportColumns", "velocity,no_such_column");
  EXPECT_FALSE(waitForPreview());
  EXPECT_TRUE(reason().contains("no_such_column")) << reason().toStdString();
  dialog_->form().setKind(ExportKind::Film);
  for (const char* entry : {"exportDuration", "exportRate", "exportSpeedValue"}) {
    enter(entry, "soon");
    EXPECT_FALSE(waitForPreview()) << entry;
    EXPECT_TRUE(reason().contains("“soon” is not a number above 0")) << reason().toStdString();
    enter(entry, "1");
  }
}

/// The usual size leaves room for the difference below the curve, however low the window is.
TEST_F(ExportDialogTest, TheUsualSizeHasRoomForTheDifference) {
  window_.resize(1000, 620);
  ASSERT_TRUE(waitFor([&] { return session().averaging() == Session::Averaging::Done; }));
  control<QCheckBox>("comparisonWanted").setChecked(true);
  ASSERT_TRUE(waitFor([&] { return session().averaging() == Session::Averaging::Done; }));
  openDialog(ExportKind::Picture);
  for (const char* content : {"both", "curve"}) {
    choose("exportContent", content);
    EXPECT_TRUE(waitForPreview()) << content << ": " << reason().toStdString();
  }
  choose("exportContent", "both");
  enter("exportHeight", "200");
  EXPECT_FALSE(waitForPreview());
  EXPECT_FALSE(reason().contains("--")) << reason().toStdString();
  EXPECT_TRUE(reason().contains("too small")) << reason().toStdString();
}

/// A refusal names the size that is enough; with it there is a preview.
TEST_F(ExportDialogTest, ARefusedSizeIsAnsweredByOneThatIsEnough) {
  ASSERT_TRUE(waitFor([&] { return session().averaging() == Session::Averaging::Done; }));
  control<QCheckBox>("comparisonWanted").setChecked(true);
  ASSERT_TRUE(waitFor([&] { return session().averaging() == Session::Averaging::Done; }));
  openDialog(ExportKind::Picture);
  choose("exportContent", "both");
  enter("exportHeight", "300");
  EXPECT_FALSE(waitForPreview());
  const QRegularExpression size("\\d+ × (\\d+) ");
  const auto match = size.match(reason());
  ASSERT_TRUE(match.hasMatch()) << reason().toStdString();
  enter("exportHeight", match.captured(1));
  EXPECT_TRUE(waitForPreview()) << reason().toStdString();
}

/// The ending of a typed name is the format; the name is not changed.
TEST_F(ExportDialogTest, ATypedEndingChoosesTheFormat) {
  openDialog(ExportKind::Picture);
  for (const char* ending : {".pdf", ".svg", ".png"}) {
    enter("exportFile", folder_.filePath("curve") + ending);
    EXPECT_EQ(in<QComboBox>("exportFormat").currentData().toString(), ending);
    EXPECT_EQ(in<QLineEdit>("exportFile").text(), folder_.filePath("curve") + ending);
  }
}

TEST_F(ExportDialogTest, ReturnPressesTheButtonWithTheFocus) {
  openDialog(ExportKind::Table);
  dialog_->setFile(folder_.filePath("curve.csv"));
  ASSERT_TRUE(QTest::qWaitForWindowActive(dialog_));
  EXPECT_TRUE(in<QPushButton>("exportWrite").isDefault());
  in<QPushButton>("exportClose").setFocus();
  QTest::keyClick(&in<QPushButton>("exportClose"), Qt::Key_Return);
  EXPECT_FALSE(dialog_ && dialog_->isVisible());
  EXPECT_FALSE(QFile::exists(folder_.filePath("curve.csv")));
}

TEST_F(ExportDialogTest, AFolderThatIsNotThereIsSaid) {
  openDialog(ExportKind::Table);
  dialog_->setFile(folder_.filePath("no_such_folder/curve.csv"));
  dialog_->write();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !reason().isEmpty(); }, kExportPatience));
  EXPECT_TRUE(reason().contains("no_such_folder")) << reason().toStdString();
  EXPECT_TRUE(dialog_->isVisible());
  EXPECT_TRUE(exports_->isEmpty());
}

/// What was wrong was the file; another name is another try.
TEST_F(ExportDialogTest, AnotherFileNameCanBeExportedAfterAFailure) {
  openDialog(ExportKind::Table);
  ASSERT_TRUE(waitForPreview());
  dialog_->setFile(folder_.filePath("no_such_folder/curve.csv"));
  dialog_->write();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !reason().isEmpty(); }, kExportPatience));
  EXPECT_FALSE(in<QPushButton>("exportWrite").isEnabled());
  const QString file = folder_.filePath("curve.csv");
  enter("exportFile", file);
  EXPECT_EQ(dialog_->file(), file);
  EXPECT_EQ(reason(), "");
  EXPECT_TRUE(in<QPushButton>("exportWrite").isEnabled());
  in<QPushButton>("exportWrite").click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !exports_->isEmpty(); }, kExportPatience));
  EXPECT_TRUE(QFile::exists(file));
}

/// A file name does not cure what is wrong with the picture.
TEST_F(ExportDialogTest, ABadValueStaysRefusedWithAnotherFileName) {
  openDialog(ExportKind::Picture);
  choose("exportContent", "contact");
  ASSERT_TRUE(waitForPreview());
  EXPECT_FALSE(dialog_->preview().image().isNull());
  enter("exportWidth", "wide");
  EXPECT_FALSE(waitForPreview());
  EXPECT_TRUE(dialog_->preview().image().isNull());
  EXPECT_EQ(in<QLabel>("exportNote").text(), "No preview.");
  enter("exportFile", folder_.filePath("contact.png"));
  EXPECT_TRUE(reason().contains("numbers above 0")) << reason().toStdString();
  EXPECT_FALSE(in<QPushButton>("exportWrite").isEnabled());
}

TEST_F(ExportDialogTest, AnExistingFileIsReplacedOnlyAfterAQuestion) {
  const QString file = fileOfBefore("curve.csv");
  openDialog(ExportKind::Table);
  dialog_->setFile(file);
  answer(QMessageBox::Cancel);
  dialog_->write();
  EXPECT_EQ(asked_, 1);
  EXPECT_EQ(exportedBytes(file), "before");
  answer(QMessageBox::Yes);
  dialog_->write();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !exports_->isEmpty(); }, kExportPatience));
  EXPECT_NE(exportedBytes(file), "before");
}

/// The proposed name follows what is exported; the frames are numbered in a folder.
TEST_F(ExportDialogTest, FramesOfAFilmGoIntoAFolder) {
  openDialog(ExportKind::Film);
  EXPECT_TRUE(dialog_->file().endsWith("small.mp4")) << dialog_->file().toStdString();
  choose("exportFormat", "");
  EXPECT_TRUE(dialog_->file().endsWith("/small_frames")) << dialog_->file().toStdString();
  choose("exportFormat", ".webm");
  EXPECT_TRUE(dialog_->file().endsWith("/small.webm")) << dialog_->file().toStdString();
  choose("exportFormat", "");
  choose("exportContent", "contact");
  enter("exportWidth", "320");
  enter("exportHeight", "200");
  enter("exportDuration", "0.2");
  enter("exportRate", "20");
  const QString frames = folder_.filePath("frames");
  dialog_->setFile(frames);
  ASSERT_TRUE(waitForPreview()) << reason().toStdString();
  EXPECT_TRUE(command().contains("--fps 20")) << command().toStdString();
  dialog_->write();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !exports_->isEmpty(); }, kExportPatience));
  EXPECT_EQ(QDir(frames).entryList(QDir::Files),
            (QStringList{"frame_0001.png", "frame_0002.png", "frame_0003.png", "frame_0004.png"}));
  EXPECT_EQ(QImage(QDir(frames).filePath("frame_0003.png")).size(), QSize(320, 200));
  // A folder that has files is not written into without a question.
  openDialog(ExportKind::Film);
  choose("exportFormat", "");
  dialog_->setFile(frames);
  answer(QMessageBox::Cancel);
  dialog_->write();
  EXPECT_EQ(asked_, 1);
}

TEST_F(ExportDialogTest, FiguresOfThePaperAreExportedWithTheirDataAndClaims) {
  openDialog(ExportKind::Figure);
  EXPECT_TRUE(dialog_->file().endsWith("/paper_figures")) << dialog_->file().toStdString();
  EXPECT_TRUE(command().startsWith("asperity figure paper -o")) << command().toStdString();
  EXPECT_FALSE(in<QCheckBox>("exportAsShown").isVisibleTo(dialog_));
  choose("exportContent", "2");
  enter("exportFurther", "--set sweep.points=5 --set surface.elements=200");
  ASSERT_TRUE(waitForPreview()) << reason().toStdString();
  EXPECT_TRUE(in<QLabel>("exportNote").text().contains("200"));
  enter("exportRealizations", "3");
  const QString figures = folder_.filePath("figures");
  dialog_->setFile(figures);
  EXPECT_TRUE(command().contains("--realizations 3")) << command().toStdString();
  EXPECT_FALSE(command().contains("--size")) << command().toStdString();
  dialog_->write();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !exports_->isEmpty(); }, kExportPatience));
  EXPECT_EQ(
      QDir(figures).entryList(QDir::Files),
      (QStringList{"claims.json", "figure_2.csv", "figure_2.pdf", "figure_2.png", "figure_2.svg"}));
  // What is wrong with a value is said by the command.
  openDialog(ExportKind::Figure);
  enter("exportRealizations", "many");
  EXPECT_FALSE(waitForPreview());
  EXPECT_TRUE(reason().contains("many")) << reason().toStdString();
}

/// From the page of figures the dialog begins with the figure that is shown there.
TEST_F(ExportDialogTest, TheFigureInSightIsChosen) {
  window_.pages().openFigures();
  window_.pages().figuresPage().choose(FigureName::Plateau, false);
  EXPECT_FALSE(action("exportPicture").isEnabled());
  action("exportFigure").trigger();
  dialog_ = window_.findChild<ExportDialog*>();
  ASSERT_TRUE(dialog_);
  EXPECT_EQ(dialog_->form().request().content, "6");
}

/// The command has to make what the window shows, whatever became of the file meanwhile.
TEST_F(ExportDialogTest, AFileThatWasChangedMeanwhileIsNotTakenForTheScene) {
  const QString file = folder_.filePath("mine.json");
  ASSERT_TRUE(window_.documentCommands().saveTo(file));
  openDialog(ExportKind::Table);
  EXPECT_TRUE(command().contains("mine.json"));
  Scene other = smallScene();
  other.load.normalForce *= 3;
  QFile changed(file);
  ASSERT_TRUE(changed.open(QIODevice::WriteOnly));
  changed.write(writeScene(other).c_str());
  changed.close();
  openDialog(ExportKind::Table);
  EXPECT_FALSE(command().contains("mine.json"));
  EXPECT_TRUE(command().contains("--set"));
}

TEST_F(ExportDialogTest, TheFormatIsThatOfTheFileAndTheCommandIsCopied) {
  openDialog(ExportKind::Picture);
  dialog_->setFile(folder_.filePath("my.results.png"));
  choose("exportFormat", ".svg");
  EXPECT_TRUE(dialog_->file().endsWith("my.results.svg"));
  dialog_->form().setKind(ExportKind::Film);
  EXPECT_TRUE(dialog_->file().endsWith("my.results.mp4"));
  in<QPushButton>("exportCopy").click();
  EXPECT_EQ(QGuiApplication::clipboard()->text(), command());
}

TEST_F(ExportDialogTest, EveryControlHasANameAndFitsASmallScreen) {
  for (const ExportKind kind : {ExportKind::Picture, ExportKind::Film, ExportKind::Table}) {
    openDialog(kind);
    dialog_->resize(900, 560);
    QCoreApplication::processEvents();
    EXPECT_LE(dialog_->minimumSizeHint().width(), 940);
    EXPECT_LE(dialog_->minimumSizeHint().height(), 620);
    auto* area = dialog_->findChild<QScrollArea*>();
    EXPECT_GE(area->viewport()->width(), dialog_->form().minimumSizeHint().width());
    for (QWidget* widget : dialog_->findChildren<QWidget*>()) {
      if (!widget->isVisible() || widget->focusPolicy() == Qt::NoFocus) continue;
      if (!qobject_cast<QComboBox*>(widget) && !qobject_cast<QLineEdit*>(widget)) continue;
      EXPECT_FALSE(widget->accessibleName().isEmpty()) << widget->objectName().toStdString();
    }
  }
}

TEST_F(ExportDialogTest, AnotherUnitIsTheSameSize) {
  openDialog(ExportKind::Picture);
  choose("exportContent", "contact");
  enter("exportWidth", "1219");
  enter("exportHeight", "600");
  choose("exportUnit", "mm");
  EXPECT_NEAR(in<QLineEdit>("exportWidth").text().toDouble(), 1219 * 25.4 / 96, 0.001);
  EXPECT_NEAR(dialog_->form().size().pixels().width(), 1219, 0.01);
  EXPECT_NEAR(dialog_->form().size().pixels().height(), 600, 0.01);
  choose("exportUnit", "");
  EXPECT_EQ(in<QLineEdit>("exportWidth").text(), "1219");
  EXPECT_EQ(in<QLineEdit>("exportHeight").text(), "600");
}

TEST_F(ExportDialogTest, ASizeThatNoWholeNumberHoldsIsRefused) {
  openDialog(ExportKind::Picture);
  choose("exportUnit", "mm");
  enter("exportWidth", "1e300");
  choose("exportUnit", "");
  EXPECT_GT(in<QLineEdit>("exportWidth").text().toDouble(), 1e300);
  EXPECT_TRUE(dialog_->form().errorText().contains("width"))
      << dialog_->form().errorText().toStdString();
}

/// An extension alone would be a hidden file of no format.
TEST_F(ExportDialogTest, AFileWithoutANameKeepsTheProposedOne) {
  openDialog(ExportKind::Picture);
  enter("exportFile", " ");
  choose("exportFormat", ".svg");
  EXPECT_EQ(in<QLineEdit>("exportFile").text().trimmed(), "");
  EXPECT_TRUE(dialog_->words().at(dialog_->words().indexOf("-o") + 1).endsWith("/small.svg"))
      << dialog_->words().join(' ').toStdString();
}

TEST_F(ExportDialogTest, NoTransparencyIsOfferedToAFormatWithoutIt) {
  openDialog(ExportKind::Film);
  auto& transparent = in<QCheckBox>("exportTransparent");
  choose("exportFormat", ".webm");
  transparent.setChecked(true);
  EXPECT_TRUE(command().contains("--transparent"));
  choose("exportFormat", ".mp4");
  EXPECT_FALSE(transparent.isEnabled());
  EXPECT_TRUE(transparent.toolTip().contains("MP4"));
  EXPECT_FALSE(command().contains("--transparent"));
  choose("exportFormat", ".gif");
  EXPECT_TRUE(transparent.isEnabled());
  EXPECT_TRUE(command().contains("--transparent"));
  // A film begins at time 0, and the option does not say otherwise.
  EXPECT_FALSE(in<QCheckBox>("exportAsShown").text().contains("moment"));
  dialog_->form().setKind(ExportKind::Picture);
  EXPECT_TRUE(in<QCheckBox>("exportAsShown").text().contains("moment"));
}

}  // namespace
}  // namespace asperity
