// What leaves the window: the contact as it is shown, as a picture in a file or on the clipboard,
// and the calls of `asperity` that make picture and curve without the window, as a user pastes
// them into a shell. Files are written in the background, each in its turn. Owned by the main
// window; GUI thread. Failure: the reason appears in the bar of messages.
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

/// The options that make the curves in the diagram beside the scene's own.
struct CurveCommandOptions {
  std::optional<CurveSet> shown{};  // with axes and pinned ones; nothing before the first curve
  std::optional<CurveSetting> compared{};
};

/// The options of `asperity render` that make the picture as it is shown.
struct RenderCommandOptions {
  QString layout = QStringLiteral("contact");
  QSize size;        // of the contact, device pixels
  int below = 0;     // height of what is in front under it, device pixels
  double scale = 1;  // device pixels to one of the window system's, times the size of texts
  bool dark = false;
  QString overlay = QStringLiteral("pressure");
  std::shared_ptr<const Frame> frame;  // the moment that is shown; null: as the scene begins
  ContactPictureOptions options{};     // and where in it somebody looks
  bool hasCurves = false;              // whether the diagram is shown
  CurveCommandOptions curves{};
};

/// "asperity render figure_1.json --set load.normal_force=0.1 -o picture.png ...". A scene that
/// came from nowhere is said as a shipped one with all that differs.
QString renderCommand(const SceneOrigin& origin, const Scene& scene,
                      const RenderCommandOptions& options);

/// "asperity curve ... -o curve.csv", with what is compared beside the scene's own curve.
QString curveCommand(const SceneOrigin& origin, const Scene& scene,
                     const CurveCommandOptions& curves = {});

/// One word for a POSIX shell, in quotes where it needs them.
QString shellQuoted(const QString& word);

/// Parts of the window that are exported, or that say so.
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
  /// The curves that are shown are asked of these.
  void setCurves(const CurveCommands& curves) { curves_ = &curves; }

  /// The contact as it is shown, with its title, as .png, .svg or .pdf. In the background;
  /// exported() or a complaint in the message bar follows.
  void savePicture(const QString& file);

  /// Runs `work` in the background, then `done`; or complains.
  void run(std::function<void()> work, std::function<void()> done);

 signals:
  /// A picture is on the clipboard (empty) or in this file.
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
  BackgroundWork work_{Overtaking::WaitsForItsTurn};  // last: ends before anything else here goes
};

}  // namespace asperity
