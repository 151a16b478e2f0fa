// Calls of `asperity` as words and as text for a shell: a picture as it is shown in the window, the
// friction curve, and the requests of the export dialog. The window runs the same words as a
// process of its own, so a call gives the same bytes as the dialog. GUI thread (the language of the
// window is read).
#pragma once

#include <QSize>
#include <QString>
#include <QStringList>
#include <memory>
#include <optional>

#include "core/chart/curve_set.h"
#include "core/run/frame.h"
#include "ui/contact/contact_picture.h"
#include "ui/window/main/scene_document.h"

namespace asperity {

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

/// Returns the pixels of the picture in this layout of `asperity render`, in which the contact is
/// as large as in the window.
QSize renderSize(const RenderCommandOptions& options, const QString& layout);

/// Returns the height (pixels) of a picture of the curves of at least this size in which all their
/// diagrams fit: the curve and, below it, differences. scale: of letters.
int curveHeight(const CurveCommandOptions& curves, QSize size, double scale);

/// Returns "asperity curve ... -o curve.csv", with the other curves in the diagram.
QString curveCommand(const SceneOrigin& origin, const Scene& scene,
                     const CurveCommandOptions& curves = {});

/// Returns one word for a POSIX shell, in quotes where it needs them.
QString shellQuoted(const QString& word);

/// The kind of output.
enum class ExportKind { Picture, Film, Table, Figure };

/// The choices in the export dialog. Texts and numbers are those of the options of the command
/// line, which checks them; an empty text is an option that is not given.
struct ExportRequest {
  ExportKind kind = ExportKind::Picture;
  /// The content: a layout of `asperity render` (contact, both, transient), a table of the contact
  /// (shape, contacts), curve or motion; for figures a name of `asperity figure`.
  QString content = QStringLiteral("contact");
  QString size, scale, theme, style;
  bool isTransparent = false;
  bool asShown = true;  // the part of the contact and the moment as in the window
  QString duration, framesPerSecond, cycles, slowMotion;  // of a film
  QString columns;                                        // of a table
  QString realizations;                                   // of figures
  QStringList further{};                                  // e.g. --threads 1
};

/// Returns the words of the call that writes `file`: "asperity", "render", ... shown: the window's
/// view, whose size, scale and theme do not matter. Figures are those of the paper and do not
/// depend on the scene; they and the frames of a film without an extension are written into a
/// folder.
QStringList exportWords(const SceneOrigin& origin, const Scene& scene, const ExportRequest& request,
                        const RenderCommandOptions& shown, const QString& file);

/// Returns the words as a text for a shell.
QString commandText(const QStringList& words);

}  // namespace asperity
