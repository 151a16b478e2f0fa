// One of the paper's figures as it was made in the background, ready to be shown and written.
// Threading: a figure is made on the thread of a BackgroundWork; what was made is immutable.
// Failure: StudyStopped where the work was stopped, else as makeFigure.
#pragma once

#include <cstdint>
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

}  // namespace asperity
