// Exports of the window: the contact and the curve as they are shown, in a file or on the
// clipboard; the export dialog; and the shell commands of `asperity` that make picture and curve
// without the window. Files are written in the background, one after the other. Owned by the main
// window; GUI thread. What the diagrams of the tabs save is reported in the same way. Failure: the
// reason appears in the message bar.
#pragma once

#include <QImage>
#include <QObject>
#include <QString>
#include <functional>
#include <memory>
#include <optional>

#include "ui/language/language.h"
#include "ui/window/export/asperity_command.h"
#include "ui/window/main/scene_document.h"
#include "ui/window/tasks/background_work.h"

class QWidget;

namespace asperity {

class Appearance;
class Commands;
class ContactCanvas;
class CurveCommands;
class ExportDialog;
class WindowPages;
class MessageBar;
class SceneTabs;
class Session;
class StatusLine;

/// A picture of the contact as it is on the screen, with its title.
struct ContactShot {
  std::shared_ptr<const Frame> frame;  // never null
  ContactPictureOptions options;
};

/// Returns the frame without the texts of a moving picture: the slow motion, and in steady sliding
/// the readings of the last steps.
std::shared_ptr<const Frame> stillCopy(const Frame& frame);

/// Parts of the window that are exported, or that show messages about exports.
struct ExportParts {
  QWidget& window;
  SceneDocument& document;
  Session& session;
  ContactCanvas& canvas;
  SceneTabs& tabs;
  WindowPages& pages;
  Appearance& appearance;
  MessageBar& messages;
  StatusLine& status;
};

class Exports : public QObject {
  Q_OBJECT

 public:
  explicit Exports(const ExportParts& parts);

  void addTo(Commands& commands);
  /// Sets the source of the curves that are shown.
  void setCurves(const CurveCommands& curves) { curves_ = &curves; }

  /// Saves the contact as it is shown, with its title, as .png, .svg or .pdf, in the background.
  void savePicture(const QString& file);

  /// Opens the export dialog for this kind.
  ExportDialog& openDialog(ExportKind kind);
  /// Sets the program that the dialog runs, instead of this one.
  void setProgram(const QString& program) { program_ = program; }

  /// These functions work in the background: `write` makes the file, `draw` the picture for the
  /// clipboard. The status line then shows the result, or the message bar the error.
  void save(const QString& file, std::function<void()> write);
  void copy(std::function<QImage()> draw, const LiveText& copied);

 private:
  std::optional<ContactShot> shot() const;
  bool hasPicture() const;
  void copyPicture();
  void askPicture();
  void showSaved(const QString& file);
  void showSuccess(const LiveText& text);
  void showFailure(const LiveText& reason) const;
  void enableCommands(Commands& commands) const;
  CurveCommandOptions shownCurves() const;
  RenderCommandOptions shownOptions() const;
  QString pictureCommand() const;
  void copyText(const QString& text);

  ExportParts parts_;
  const CurveCommands* curves_ = nullptr;
  QString program_;
  BackgroundWork work_{RequestPolicy::RunInOrder};  // last: its thread ends first
};

}  // namespace asperity
