// The controls of the export dialog: content, size and style of the output, and the time of a film.
// They make an ExportRequest; the command that runs with it reports invalid values. GUI thread;
// owned by its parent.
#pragma once

#include <QWidget>
#include <vector>

#include "ui/window/export/asperity_command.h"
#include "ui/window/export/command_run.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;

namespace asperity {

class ExportSizeFields;

class ExportForm : public QWidget {
  Q_OBJECT

 public:
  /// isMotion: the scene has a motion in time. shown: the state of the window.
  ExportForm(bool isMotion, const RenderCommandOptions& shown, QWidget* parent = nullptr);

  void setKind(ExportKind kind);
  ExportKind kind() const;
  ExportRequest request() const;

  /// Chooses what is exported, if this kind has it.
  void setContent(const QString& content);

  /// Returns the extension of the file: ".png"; empty: files in a folder.
  QString extension() const;

  /// Chooses the format of files with this extension, if the kind has one.
  void chooseExtension(const QString& extension);

  ExportSizeFields& size() { return *size_; }

  /// Returns whether the user typed this option, such as "--threads", among the other ones.
  bool isTyped(const QString& option) const;

  /// Returns what is wrong with the size of the picture, another number or the other options; empty
  /// where nothing is.
  QString errorText() const;

  /// Returns the reason that a command gave, with the label of a control in place of its option.
  /// Options that the user typed keep their names. The numbers of a size are those of the preview;
  /// they are given as those of the form.
  QString inWords(const QString& reason, const NeededHeight& needed) const;

 signals:
  void changed();

 private:
  void addFilm();
  void connectControls();
  void fillContents();
  void fillFormats();
  void followChoice(const QComboBox* box);
  void fitSize();
  bool hasContact() const;
  bool canBeTransparent() const;
  bool isSlow() const;
  bool hasDuration() const;
  void showRows();
  std::vector<const QLineEdit*> numbers() const;

  bool isMotion_;
  RenderCommandOptions shown_;
  QFormLayout* rows_;
  QComboBox *kind_, *content_, *format_, *theme_, *style_, *speed_;
  ExportSizeFields* size_;
  QLineEdit *duration_, *rate_, *speedValue_, *columns_, *realizations_, *further_;
  QWidget* speedRow_;
  QCheckBox *transparent_, *asShown_;
};

}  // namespace asperity
