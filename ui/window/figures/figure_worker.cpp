#include "ui/window/figures/figure_worker.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "core/friction/study.h"
#include "ui/chart/figure_drawing.h"
#include "ui/language/translated.h"

namespace asperity {

namespace {

/// One is left for the window.
int figureThreads() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1);
}

}  // namespace

FigureWorker::FigureWorker(FigureWorkerEvents events, FigureMaker maker)
    : events_(std::move(events)), maker_(std::move(maker)) {}

void FigureWorker::start(FigureJob job) {
  thread_ = std::jthread([this, job](const std::stop_token& stop) { run(job, stop); });
}

void FigureWorker::run(const FigureJob& job, const std::stop_token& stop) const {
  try {
    events_.finished(made(job, stop));
  } catch (const StudyStopped&) {
    events_.stopped(job.name);
  } catch (const std::exception& error) {
    events_.failed(job.name, translatedError(error));
  }
}

std::shared_ptr<const MadeFigure> FigureWorker::made(const FigureJob& job,
                                                     const std::stop_token& stop) const {
  FigureOptions options;
  options.realizations = job.realizations;
  options.threads = figureThreads();
  options.stop = stop;
  options.progress = [this, &job, told = -1](double part) mutable {
    const int step = static_cast<int>(std::clamp(part, 0.0, 1.0) * 1000);
    if (step == told) return;
    told = step;
    events_.progressed(job.name, step / 1000.0);
  };
  MadeFigure made{maker_(job.name, options), job.realizations, nullptr};
  made.contact = contactOf(made.figure);
  return std::make_shared<const MadeFigure>(std::move(made));
}

}  // namespace asperity
