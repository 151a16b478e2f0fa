// The export dialog: pictures, films and tables of the scene with a preview, and the command line
// that makes the same file. Preview and output are made by that command, which runs as a separate
// process, so they cannot differ and a value is checked in one place. GUI thread; owned by the
// window. Failure: the dialog shows the error message of the command.
#pragma once

#include <QDialog>
#include <QTemporaryDir>

#include "ui/window/export/asperity_command.h"
#include "ui/window/export/command_run.h"

class QFileInfo;
class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QProgressBar;
class QPushButton;
class QTimer;

namespace asperity {

class ExportForm;
class ExportPreview;

class ExportDialog : public QDialog {
  Q_OBJECT

 public:
  /// The exported scene and view, as they were when the dialog was opened.
  struct Subject {
    SceneOrigin origin;
    Scene scene;
    RenderCommandOptions shown;
    QString name;  // proposed for the file, without an extension
  };

  /// program: the executable that runs the commands; empty: this program.
  ExportDialog(Subject subject, ExportKind kind, const QString& program, QWidget* parent = nullptr);
  ~ExportDialog() override;

  ExportForm& form() { return *form_; }
  ExportPreview& preview() { return *preview_; }

  /// Returns the file that is written, and sets it.
  QString file() const;
  void setFile(const QString& file);

  /// Returns the words of the command that writes the file.
  QStringList words() const;

  /// Writes the file; exported() or an error in the dialog follows. Asks before it replaces a file
  /// that was not chosen in the file dialog.
  void write();

 signals:
  void exported(const QString& file);

 public slots:
  void reject() override;

 private:
  /// Returns why a call failed that ended well: "--help" among the other options writes nothing.
  static QString noFileReason() { return tr("The program has written no file."); }
  QWidget* makeBottom();
  void askFile();
  void fileChanged();
  void renameFile();
  QString defaultName() const;
  bool confirmReplace(const QFileInfo& target);
  void requestChanged();
  void showCommand();
  ExportRequest previewOfFigure(ExportRequest request, QStringList& notes) const;
  void requestPreview();
  void shrink(ExportRequest& request) const;
  void takePreview();
  void previewFailed(const QString& reason, const NeededHeight& needed);
  void refuse(const QString& reason);
  void showFailure(const QString& reason);
  void showRunning(bool isRunning);

  Subject subject_;
  ExportForm* form_;
  ExportPreview* preview_;
  QLineEdit* file_;
  QPlainTextEdit* command_;
  QLabel* failure_;
  QProgressBar* progress_;
  QPushButton *browse_, *write_, *close_;
  QTimer* quiet_;         // until the user pauses in changing values
  QTemporaryDir folder_;  // of previews; also where commands run
  CommandRun *previews_, *writing_;
  QString previewFile_, previewNote_;
  QString raised_;         // that the picture was made higher than the window's; empty: it was not
  QString previewFigure_;  // word of the figure in the folder of that name; empty: a single file
  QString chosenFile_;     // in the file dialog, which asked about replacing it
  QString extension_;      // of the format that was chosen last; empty: a folder
  QString defaultName_;    // the name that was proposed last
  int number_ = 0;         // of the newest preview
  bool hasWriteFailed_ = false;  // the message that is shown is of the file, not of the preview
};

}  // namespace asperity
