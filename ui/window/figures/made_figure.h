// One of the paper's figures as it was made in the background, ready to be shown, and the files
// that are written of it, with the names that the command line gives them too.
// Threading: a figure is made on the thread of a BackgroundWork; what was made is immutable. Files
// may be written on any thread but the GUI thread for PNG, which draws with OSMesa.
// Failure: StudyStopped where the work was stopped, else as makeFigure; InputError for another
// extension and std::runtime_error where a file cannot be drawn or written.
#pragma once

#include <QString>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>

#include "core/paper/figure.h"
#include "core/run/frame.h"
#include "ui/window/tasks/background_work.h"

namespace asperity {

struct MadeFigure {
  Figure figure;
  std::int64_t realizations = 0;
  std::shared_ptr<const Frame> contact;  // of a figure without diagrams, which is drawn as one
};

/// makeFigure, or what stands for it in a test or draws another diagram in a figure's place.
using FigureMaker = std::function<Figure(FigureName, const FigureOptions&)>;

/// `progressed` is called on the window's thread with the part that is done, in steps of a
/// thousandth or more. One processor is left for the window.
std::shared_ptr<const MadeFigure> makeFigureBeside(const BackgroundWork::Run& run,
                                                   const FigureMaker& maker, FigureName name,
                                                   std::int64_t realizations,
                                                   const std::function<void(double)>& progressed);

/// "figure_5.csv" for ".csv".
QString figureFile(FigureName name, const QString& extension);

/// Fit for print, as PNG, SVG or PDF by the extension. Throws InputError for another one and
/// std::runtime_error where it cannot be drawn or written.
void writeFigurePicture(const std::filesystem::path& file, const MadeFigure& made);

/// The table (.csv) or the claims (.json). Throws likewise.
void writeFigureData(const std::filesystem::path& file, const MadeFigure& made);

}  // namespace asperity
