// Makes the paper's figures on a thread of its own, one at a time.
// Threading: the constructor, the destructor, start() and stop() on any one thread, none of which
// waits for a computation but the destructor, and that only until the computation has noticed that
// it is to stop (within one pass over a line); the events come on the worker's thread. What is
// handed over is immutable.
// Failure: one sentence in `failed`; the worker goes on with the next start().
#pragma once

#include <QString>
#include <cstdint>
#include <functional>
#include <memory>
#include <thread>

#include "core/paper/figure.h"
#include "core/run/frame.h"

namespace asperity {

struct FigureJob {
  FigureName name = FigureName::Contact;
  std::int64_t realizations = 20;
};

struct MadeFigure {
  Figure figure;
  std::int64_t realizations = 0;
  std::shared_ptr<const Frame> contact;  // of a figure without diagrams, which is drawn as one
};

/// The last event of a job is one of finished, failed and stopped.
struct FigureWorkerEvents {
  std::function<void(FigureName, double part)> progressed;  // in steps of a thousandth or more
  std::function<void(std::shared_ptr<const MadeFigure>)> finished;
  std::function<void(FigureName, const QString& reason)> failed;
  std::function<void(FigureName)> stopped;
};

using FigureMaker = std::function<Figure(FigureName, const FigureOptions&)>;

class FigureWorker {
 public:
  explicit FigureWorker(FigureWorkerEvents events, FigureMaker maker = makeFigure);

  /// After the last event of the job before.
  void start(FigureJob job);
  void stop() { thread_.request_stop(); }

 private:
  void run(const FigureJob& job, const std::stop_token& stop) const;
  std::shared_ptr<const MadeFigure> made(const FigureJob& job, const std::stop_token& stop) const;

  FigureWorkerEvents events_;
  FigureMaker maker_;
  std::jthread thread_;  // last: its thread ends before anything else here goes
};

}  // namespace asperity
