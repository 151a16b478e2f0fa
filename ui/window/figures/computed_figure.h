// One of the paper's figures with its picture's data, made in the background, and its files, with
// the same names as on the command line. Threading: a figure is made on the thread of a
// BackgroundWork; the result is immutable. Files may be written on any thread, but PNG not on the
// GUI thread, which it would block for a while. Failure: StopRequested where the work was stopped,
// otherwise the errors of makeFigure; InputError for another extension and std::runtime_error where
// a file cannot be drawn or written.
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

struct ComputedFigure {
  Figure figure;
  std::int64_t realizations = 0;
  std::shared_ptr<const Frame> contact;  // of a figure without diagrams, which shows a contact
};

/// The function makeFigure, or another one in tests or for another diagram.
using FigureMaker = std::function<Figure(FigureName, const FigureOptions&)>;

/// Makes a figure in the background. `progressed` is called on the window's thread with the
/// finished part, in steps of a thousandth or more. One processor is left for the window.
std::shared_ptr<const ComputedFigure> computeFigure(const BackgroundWork::Run& run,
                                                    const FigureMaker& maker, FigureName name,
                                                    std::int64_t realizations,
                                                    const std::function<void(double)>& progressed);

/// Returns the file name, for example "figure_5.csv" for ".csv".
QString figureFile(FigureName name, const QString& extension);

/// Writes the figure for print, as PNG, SVG or PDF by the extension. Throws InputError for another
/// extension and std::runtime_error where the figure cannot be drawn or written.
void writeFigurePicture(const std::filesystem::path& file, const ComputedFigure& made);

/// Writes the table (.csv) or the claims (.json). Throws the same errors.
void writeFigureData(const std::filesystem::path& file, const ComputedFigure& made);

}  // namespace asperity
