// The friction diagram as files: the picture as `asperity curve` draws it with everything that is
// shown, and all plotted numbers as one table. Any thread on which no OpenGL context of the window
// is current, one at a time. Throw as writePicture and writeFileAtomically.
#pragma once

#include <QImage>
#include <filesystem>

#include "core/chart/curve_set.h"
#include "ui/contact/contact_picture.h"

namespace asperity {

/// PNG, SVG, PDF or CSV, by the extension.
void writeCurves(const std::filesystem::path& file, const CurveSet& set);

/// So many pixels at so many for one of the window system's.
QImage imageOf(const CurveSet& set, int width, int height, double scale, const Theme& theme);

}  // namespace asperity
