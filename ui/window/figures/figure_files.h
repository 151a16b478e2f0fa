// Figures as pictures and as files, with the names that the command line gives them too.
// Pure functions but for the files; any thread but the GUI thread for PNG, which draws with OSMesa.
#pragma once

#include <QString>
#include <filesystem>

#include "ui/window/figures/made_figure.h"

namespace asperity {

/// "figure_5.csv" for ".csv".
QString figureFile(FigureName name, const QString& extension);

/// Fit for print, as PNG, SVG or PDF by the extension. Throws InputError for another one and
/// std::runtime_error where it cannot be drawn or written.
void writeFigurePicture(const std::filesystem::path& file, const MadeFigure& made);

/// The table (.csv) or the claims (.json). Throws likewise.
void writeFigureData(const std::filesystem::path& file, const MadeFigure& made);

}  // namespace asperity
