// The rows of the export dialog for the size of a picture: named sizes, width and height in pixels
// or millimetres, and the resolution. GUI thread; owned by the form.
#pragma once

#include <QObject>
#include <QSizeF>
#include <QString>
#include <optional>

#include "ui/window/export/asperity_command.h"
#include "ui/window/export/command_run.h"

class QComboBox;
class QFormLayout;
class QLineEdit;
class QWidget;

namespace asperity {

/// What is exported, on which the usual size depends.
struct ExportContent {
  ExportKind kind = ExportKind::Picture;
  QString word, style;      // "both"; empty style: none
  bool hasContact = false;  // the contact is drawn or listed, rather than diagrams alone
};

class ExportSizeFields : public QObject {
  Q_OBJECT

 public:
  /// Adds the rows to a form. shown: the state of the window.
  ExportSizeFields(QFormLayout& rows, const RenderCommandOptions& shown);

  /// Offers the sizes that this content can have. With another style the size becomes that of the
  /// style.
  void setContent(const ExportContent& content);

  /// Writes size and resolution into a request, unless the command chooses them.
  void writeTo(ExportRequest& request) const;

  bool isOnPaper() const;

  /// Returns the width and height in pixels as far as they are known; empty where the style or the
  /// command chooses them.
  QSizeF pixels() const;

  /// Returns what is wrong with the size; empty where nothing is.
  QString errorText() const;

  /// Returns the least height that holds the picture's diagrams, in the unit of the rows, where a
  /// command refused the present one.
  std::optional<double> heightEnough(const NeededHeight& needed) const;
  /// Sets this height where the size is the usual one, which the user did not choose. Returns
  /// whether it is.
  bool raiseHeight(double height);

  /// Returns the sentence for a refused size, if possible with one that is enough.
  QString tooSmallText(const NeededHeight& needed) const;

  const QLineEdit& density() const { return *density_; }

 signals:
  /// Emitted when another named size is chosen, or a size of one's own.
  void presetChanged();
  /// Emitted when a number or the unit has changed.
  void changed();

 private:
  void addSize();
  void fillPresets();
  void showSize();
  void convertSize();
  bool isChosenByCommand() const;

  QFormLayout& rows_;
  RenderCommandOptions shown_;
  ExportContent content_;
  QComboBox *preset_, *unit_;
  QWidget* size_;  // holds width, height and unit
  QLineEdit *width_, *height_, *density_;
};

/// Returns a number as a command reads it: people type a decimal comma, and marks between
/// thousands.
QString machineNumber(const QLineEdit& entry);

}  // namespace asperity
