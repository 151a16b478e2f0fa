#include "ui/window/figures/made_figure.h"

#include <algorithm>
#include <thread>

#include "ui/chart/figure_drawing.h"

namespace asperity {

std::shared_ptr<const MadeFigure> makeFigureBeside(const BackgroundWork::Run& run,
                                                   const FigureMaker& maker, FigureName name,
                                                   std::int64_t realizations,
                                                   const std::function<void(double)>& progressed) {
  FigureOptions options;
  options.realizations = realizations;
  options.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1);
  options.stop = run.stop();
  options.progress = [&run, progressed, told = -1](double part) mutable {
    const int step = static_cast<int>(std::clamp(part, 0.0, 1.0) * 1000);
    if (step == told) return;
    told = step;
    run.tell([progressed, step] { progressed(step / 1000.0); });
  };
  MadeFigure made{maker(name, options), realizations, nullptr};
  made.contact = contactOf(made.figure);
  return std::make_shared<const MadeFigure>(std::move(made));
}

}  // namespace asperity
