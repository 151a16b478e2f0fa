// Exports of the window: the contact as it is shown, as a picture in a file or on the clipboard,
// and the shell commands of `asperity` that make picture and curve without the window. Files are
// written in the background, one after the other. Owned by the main window; GUI thread. Failure:
// the reason appears in the message bar.
#pragma once

#include <QObject>
#include <QSize>
#include <QString>
#include <functional>
#include <memory>
#include <optional>

#include "core/chart/curve_set.h"
#include "ui/contact/contact_picture.h"
#include "ui/window/main/scene_document.h"
#include "ui/window/tasks/background_work.h"

class QWidget;

namespace asperity {

class Appearance;
class Commands;
class ContactCanvas;
class CurveCommands;
class FigurePages;
class MessageBar;
class SceneTabs;
class Session;
class StatusLine;
struct ContactShot;

/// The options that make the other curves in the diagram.
struct CurveCommandOptions {
  std::optional<CurveSet> shown{};  // with axes and pinned curves; nothing before the first curve
  std::optional<CurveSetting> compared{};
};

/// The options of `asperity render` that make the picture as it is shown.
struct RenderCommandOptions {
  QString layout = QStringLiteral("contact");
  QSize size;        // of the contact, device pixels
  int below = 0;     // height of the front tab below it, device pixels
  double scale = 1;  // device pixels per logical pixel, times the factor of texts
  bool dark = false;
  QString overlay = QStringLiteral("pressure");
  std::shared_ptr<const Frame> frame;  // the frame that is shown; null: the scene's beginning
  ContactPictureOptions options{};     // with the view of the user
  bool hasCurves = false;              // whether the diagram is shown
  CurveCommandOptions curves{};
};

/// Returns "asperity render figure_1.json --set load.normal_force=0.1 -o picture.png ...". A scene
/// without origin is written as a shipped scene with all differences.
QString renderCommand(const SceneOrigin& origin, const Scene& scene,
                      const RenderCommandOptions& options);

/// Returns "asperity curve ... -o curve.csv", with the other curves in the diagram.
QString curveCommand(const SceneOrigin& origin, const Scene& scene,
                     const CurveCommandOptions& curves = {});

/// Returns one word for a POSIX shell, in quotes where it needs them.
QString shellQuoted(const QString& word);

/// Parts of the window that are exported, or that show messages about exports.
struct ExportParts {
  QWidget& window;
  SceneDocument& document;
  Session& session;
  ContactCanvas& canvas;
  SceneTabs& tabs;
  FigurePages& figures;
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

  /// Saves the contact as it is shown, with its title, as .png, .svg or .pdf, in the background;
  /// exported() or an error in the message bar follows.
  void savePicture(const QString& file);

  /// Runs `work` in the background, then `done`; or shows the error.
  void run(std::function<void()> work, std::function<void()> done);

 signals:
  /// Emitted when a picture is on the clipboard (empty) or in this file.
  void exported(const QString& file);

 private:
  std::optional<ContactShot> shot() const;
  void copyPicture();
  void askPicture();
  void showCommands(Commands& commands) const;
  CurveCommandOptions shownCurves() const;
  QString pictureCommand() const;
  void copyText(const QString& text);

  ExportParts parts_;
  const CurveCommands* curves_ = nullptr;
  BackgroundWork work_{Overtaking::WaitsForItsTurn};  // last: its thread ends first
};

}  // namespace asperity
