// The calls of `asperity` that make the window's picture and curve without the window, as a person
// pastes them into a shell. Pure; GUI thread.
#pragma once

#include <QSize>
#include <QString>
#include <QStringList>
#include <memory>
#include <optional>

#include "core/chart/curve_set.h"
#include "ui/contact/contact_picture.h"
#include "ui/window/main/scene_document.h"

namespace asperity {

/// The curves in the diagram beside the scene's own.
struct CurveWish {
  std::optional<CurveSet> shown{};  // with axes and pinned ones; nothing before the first curve
  std::optional<CurveSetting> compared{};
};

/// What the picture is like, in the words of `asperity render`.
struct PictureWish {
  QString layout = QStringLiteral("contact");
  QSize size;        // of the contact, device pixels
  int below = 0;     // height of what is in front under it, device pixels
  double scale = 1;  // device pixels to one of the window system's, times the size of texts
  bool dark = false;
  QString overlay = QStringLiteral("pressure");
  std::shared_ptr<const Frame> frame;  // the moment that is shown; null: as the scene begins
  ContactPictureOptions options{};     // and where in it somebody looks
  bool hasCurves = false;              // whether the diagram is shown
  CurveWish curves{};
};

/// "asperity render figure_1.json --set load.normal_force=0.1 -o picture.png ...". A scene that
/// came from nowhere is said as a shipped one with all that differs.
QString renderCommand(const SceneOrigin& origin, const Scene& scene, const PictureWish& wish);

/// "asperity curve ... -o curve.csv", with what is compared beside the scene's own curve.
QString curveCommand(const SceneOrigin& origin, const Scene& scene, const CurveWish& curves = {});

/// One word for a POSIX shell, in quotes where it needs them.
QString shellQuoted(const QString& word);

}  // namespace asperity
