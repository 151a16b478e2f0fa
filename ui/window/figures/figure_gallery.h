// The state of the paper's figures in this session: which are made, which one is being computed and
// how far it is, which ones wait. Figures are computed one at a time in the background, in the
// order of the requests, and kept until the program ends. Owned by the gallery page; GUI thread.
// Failure: one sentence in the figure's status.
#pragma once

#include <QObject>
#include <QString>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "ui/window/figures/computed_figure.h"

namespace asperity {

/// Returns the short name: "Figure 3", "Master curve", "Spacing".
QString figureLabel(FigureName name);

enum class FigureStage { None, Waiting, Computing };

struct FigureStatus {
  FigureStage work = FigureStage::None;
  double part = 0;                             // finished part of the computation, 0 to 1
  std::shared_ptr<const ComputedFigure> made;  // the newest; null: none yet
  QString error;  // why the newest computation failed; empty: it succeeded
};

class FigureGallery : public QObject {
  Q_OBJECT

 public:
  explicit FigureGallery(FigureMaker maker = makeFigure, QObject* parent = nullptr);

  const FigureStatus& status(FigureName name) const { return of(name); }

  /// Returns the figure that is being computed.
  std::optional<FigureName> computing() const { return computing_; }

  /// Computes a figure after those that wait. It does nothing where the figure already runs or
  /// waits.
  void compute(FigureName name, std::int64_t realizations);

  /// Cancels the present computation and all that wait.
  void cancel();

 signals:
  void changed(asperity::FigureName name);

 private:
  FigureStatus& of(FigureName name) { return statuses_[static_cast<std::size_t>(name)]; }
  const FigureStatus& of(FigureName name) const {
    return statuses_[static_cast<std::size_t>(name)];
  }
  void startNext();
  void end(FigureName name);

  std::vector<FigureStatus> statuses_;
  struct Job {
    FigureName name = FigureName::Contact;
    std::int64_t realizations = 20;
  };
  std::deque<Job> waiting_;
  std::optional<FigureName> computing_;
  const FigureMaker maker_;
  BackgroundWork work_;  // last: its thread ends before other members are destroyed
};

}  // namespace asperity
