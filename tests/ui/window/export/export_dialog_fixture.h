// The main window with its export dialog, and a person who exports. For tests on the GUI thread.
#pragma once

#include <QComboBox>
#include <QFile>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPointer>
#include <QProcess>
#include <QSettings>
#include <QTemporaryDir>
#include <memory>

#include "tests/ui/window/main_window_fixture.h"
#include "ui/window/export/export_dialog.h"

namespace asperity {

inline constexpr int kExportPatience = 60000;  // ms, for films on a busy machine

inline QByteArray exportedBytes(const QString& file) {
  QFile in(file);
  return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray();
}

class ExportDialogTest : public MainWindowTest {
 protected:
  void SetUp() override {
    ASSERT_TRUE(waitForFrame());
    session().setPlaying(false);
    window_.exports().setProgram(ASPERITY_PROGRAM);
  }
  void TearDown() override {
    delete dialog_.data();
    QSettings().remove("export");
  }

  void openDialog(ExportKind kind) {
    dialog_ = &window_.exports().openDialog(kind);
    exports_ = std::make_unique<QSignalSpy>(dialog_, &ExportDialog::exported);
  }
  template <class Widget>
  Widget& in(const char* name) {
    return *dialog_->findChild<Widget*>(QLatin1String(name));
  }
  void choose(const char* box, const QString& data) {
    auto& choices = in<QComboBox>(box);
    const int index = choices.findData(data);
    ASSERT_GE(index, 0) << box << " " << data.toStdString();
    choices.setCurrentIndex(index);
  }
  void enter(const char* entry, const QString& text) {
    auto& field = in<QLineEdit>(entry);
    field.setFocus();
    field.selectAll();
    QTest::keyClicks(&field, text);
  }
  /// Waits for the preview of the present values. Returns whether it could be made.
  bool waitForPreview() {
    EXPECT_TRUE(QTest::qWaitFor(
        [&] { return in<QLabel>("exportNote").text() != "The preview is being made…"; },
        kExportPatience));
    return reason().isEmpty();
  }
  QString reason() { return in<QLabel>("exportFailure").text(); }
  QString command() { return in<QPlainTextEdit>("exportCommand").toPlainText(); }

  /// Returns a file that is there already.
  QString fileOfBefore(const QString& name) {
    QFile file(folder_.filePath(name));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("before");
    return file.fileName();
  }

  /// Writes the file by the dialog and then, in its place, by the command in a shell.
  void expectSameBytes(const QString& name) {
    SCOPED_TRACE(name.toStdString());
    const QString file = folder_.filePath(name);
    dialog_->setFile(file);
    const QString text = command();
    dialog_->write();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !exports_->isEmpty() || !reason().isEmpty(); },
                                kExportPatience));
    ASSERT_FALSE(exports_->isEmpty()) << reason().toStdString();
    const QByteArray made = exportedBytes(file);
    EXPECT_GT(made.size(), 300);
    ASSERT_TRUE(QFile::remove(file));
    QProcess shell;
    shell.setWorkingDirectory(folder_.path());
    shell.start("/bin/sh", {"-c", "asperity() { \"" ASPERITY_PROGRAM "\" \"$@\"; }; " + text});
    ASSERT_TRUE(shell.waitForFinished(kExportPatience));
    EXPECT_EQ(shell.exitCode(), 0) << shell.readAllStandardError().toStdString();
    EXPECT_TRUE(exportedBytes(file) == made) << text.toStdString();
  }

  QTemporaryDir folder_;
  QPointer<ExportDialog> dialog_;
  std::unique_ptr<QSignalSpy> exports_;
};

}  // namespace asperity
