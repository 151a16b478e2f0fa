// The calls of `asperity` that make the window's picture and curve without the window, as a person
// pastes them into a shell. Pure; GUI thread.
#pragma once

#include <QSize>
#include <QString>
#include <QStringList>

#include "ui/window/scene_document.h"

namespace asperity {

/// What the picture is like, in the words of `asperity render`.
struct PictureWish {
  QString layout = QStringLiteral("contact");
  QSize size;        // device pixels
  double scale = 1;  // device pixels to one of the window system's
  bool dark = false;
  QString overlay = QStringLiteral("pressure");
};

/// "asperity render figure_1.json --set load.normal_force=0.1 -o picture.png ...". A scene that
/// came from nowhere is said as a shipped one with all that differs.
QString renderCommand(const SceneOrigin& origin, const Scene& scene, const PictureWish& wish);

/// "asperity curve ... -o curve.csv".
QString curveCommand(const SceneOrigin& origin, const Scene& scene);

/// One word for a POSIX shell, in quotes where it needs them.
QString shellQuoted(const QString& word);

}  // namespace asperity
