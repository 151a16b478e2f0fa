// A call of the program as a process of its own: its output, its progress, why it failed, and its
// end.
#include "ui/window/export/command_run.h"

#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <QProcess>
#include <QPushButton>
#include <QSignalSpy>

#include "tests/ui/window/export/export_dialog_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "ui/window/export/export_dialog.h"
#include "ui/window/export/export_form.h"

namespace asperity {
namespace {

/// A shell stands for the program: it says what the program would say.
class CommandRunTest : public testing::Test {
 protected:
  void say(const QString& script) { run_.run({"asperity", "-c", script}, "/"); }
  bool waitForEnd() {
    return QTest::qWaitFor([this] { return !run_.isRunning(); }, kExportPatience);
  }

  CommandRun run_{"/bin/sh"};
  QSignalSpy done_{&run_, &CommandRun::done}, failed_{&run_, &CommandRun::failed};
  QSignalSpy progressed_{&run_, &CommandRun::progressed};
};

TEST_F(CommandRunTest, TheOutputComesWithTheEndAndTheProgressBefore) {
  say("echo 'progress 3 12 frames' >&2; echo made");
  ASSERT_TRUE(waitForEnd());
  ASSERT_EQ(done_.count(), 1);
  EXPECT_EQ(done_[0][0].toByteArray(), "made\n");
  ASSERT_EQ(progressed_.count(), 1);
  EXPECT_EQ(progressed_[0][0].toDouble(), 0.25);
  EXPECT_EQ(progressed_[0][1].toString(), "frames");
}

/// The reason is the sentence that the program says to a person, without its name.
TEST_F(CommandRunTest, AFailureHasTheReasonOfTheProgram) {
  say("echo 'height 40 160' >&2; echo 'asperity: too low' >&2; exit 2");
  ASSERT_TRUE(waitForEnd());
  ASSERT_EQ(failed_.count(), 1);
  EXPECT_EQ(failed_[0][0].toString(), "too low");
  EXPECT_EQ(failed_[0][1].value<NeededHeight>().enough, 160);
  say("exit 3");
  ASSERT_TRUE(waitForEnd());
  ASSERT_EQ(failed_.count(), 2);
  EXPECT_EQ(failed_[1][0].toString(), "The program ended without a reason");
}

TEST_F(CommandRunTest, TheNewestCallWins) {
  say("sleep 60; echo old");
  say("echo new");
  ASSERT_TRUE(waitForEnd());
  ASSERT_EQ(done_.count(), 1);
  EXPECT_EQ(done_[0][0].toByteArray(), "new\n");
}

TEST_F(ExportDialogTest, AProgramThatCannotBeStartedIsSaid) {
  window_.exports().setProgram("/no/such/program");
  openDialog(ExportKind::Picture);
  EXPECT_FALSE(waitForPreview());
  EXPECT_TRUE(reason().contains("/no/such/program"));
}

/// Escape cancels the export first and then closes the dialog; a file of before is untouched.
TEST_F(ExportDialogTest, ACancelledExportLeavesTheFileAsItWas) {
  openDialog(ExportKind::Film);
  choose("exportContent", "contact");
  choose("exportPreset", "hd");
  enter("exportDuration", "600");
  const QString file = fileOfBefore("film.webp");
  choose("exportFormat", ".webp");
  dialog_->setFile(file);
  answer(QMessageBox::Yes);
  dialog_->write();
  EXPECT_EQ(asked_, 1);
  QTest::qWait(500);
  EXPECT_FALSE(dialog_->form().isEnabled());
  EXPECT_FALSE(
      in<QPushButton>("exportBrowse").isEnabled());  // another name would be told as written
  dialog_->reject();
  ASSERT_TRUE(dialog_);
  EXPECT_TRUE(dialog_->form().isEnabled());
  // The call ends by itself, and takes what it has begun with it.
  ASSERT_TRUE(QTest::qWaitFor([&] { return dialog_->findChildren<QProcess*>().isEmpty(); },
                              kExportPatience));
  EXPECT_EQ(exportedBytes(file), "before");
  EXPECT_EQ(QDir(folder_.path()).entryList(QDir::Files | QDir::Hidden).size(), 1);
  dialog_->reject();
  EXPECT_TRUE(waitFor([&] { return dialog_.isNull(); }));
}

TEST_F(ExportDialogTest, ClosingTheWindowEndsWhatRuns) {
  auto window = std::make_unique<MainWindow>(smallScene());
  window->exports().setProgram(ASPERITY_PROGRAM);
  ExportDialog& dialog = window->exports().openDialog(ExportKind::Film);
  dialog.setFile(folder_.filePath("film.webp"));
  dialog.write();
  QElapsedTimer time;
  time.start();
  window.reset();
  EXPECT_LT(time.elapsed(), 3000);
}

}  // namespace
}  // namespace asperity
