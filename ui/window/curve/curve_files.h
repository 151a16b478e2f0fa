// The friction diagram as files: the picture that `asperity curve` would draw with everything that
// is shown, and all plotted numbers as one table. Any thread on which no OpenGL context of the
// window is current, one at a time. The functions throw as writePicture and writeFileAtomically do.
#pragma once

#include <QImage>
#include <filesystem>

#include "core/chart/curve_set.h"
#include "ui/contact/contact_picture.h"

namespace asperity {

/// Writes PNG, SVG, PDF or CSV, by the extension.
void writeCurves(const std::filesystem::path& file, const CurveSet& set);

/// Draws an image of width x height pixels; scale: device pixels per logical pixel.
QImage renderCurves(const CurveSet& set, int width, int height, double scale, const Theme& theme);

}  // namespace asperity
