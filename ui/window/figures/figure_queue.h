// The paper's figures in the window: each with its picture's data, its name and its files, which
// are named as on the command line; and the state of all figures in this session: which are made,
// which one is being computed and how far it is, which ones wait. Figures are computed one at a
// time, in the order of the requests, and kept until the program ends. Threading: a figure is made
// on the thread of a BackgroundWork; the result is immutable. Files may be written on any thread,
// but PNG not on the GUI thread, which it would block for a while. FigureQueue: GUI thread; owned
// by the page of the figures. Failure: the errors of makeFigure become one sentence in the figure's
// status; InputError for another extension and std::runtime_error where a file cannot be drawn or
// written.
#pragma once

#include <QObject>
#include <QString>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/paper/figure.h"
#include "core/run/frame.h"
#include "ui/language/language.h"
#include "ui/window/tasks/background_work.h"

namespace asperity {

struct ComputedFigure {
  Figure figure;
  std::int64_t realizations = 0;
  std::shared_ptr<const Frame> contact;  // of a figure without diagrams, which shows a contact
};

/// The function makeFigure, or another one in tests.
using FigureMaker = std::function<Figure(FigureName, const FigureOptions&)>;

/// Returns the file name, for example "figure_5.csv" for ".csv".
QString figureFile(FigureName name, const QString& extension);

/// Writes the figure for print, as PNG, SVG or PDF by the extension. Throws InputError for another
/// extension and std::runtime_error where the figure cannot be drawn or written.
void writeFigurePicture(const std::filesystem::path& file, const ComputedFigure& made);

/// Writes the table (.csv) or the claims (.json). Throws the same errors.
void writeFigureData(const std::filesystem::path& file, const ComputedFigure& made);

/// Returns the short name: "Figure 3", "Master curve", "Spacing".
QString figureLabel(FigureName name);

/// Returns "Figure 2: Typical dependence of friction on velocity"; the headline alone for a figure
/// that the paper does not have.
QString figureTitle(const FigureEntry& entry);

enum class FigureStage { None, Waiting, Computing };

struct FigureStatus {
  FigureStage work = FigureStage::None;
  double part = 0;                             // finished part of the computation, 0 to 1
  std::shared_ptr<const ComputedFigure> made;  // the newest; null: none yet
  LiveText error;  // why the newest computation failed; empty: it succeeded
};

/// The figures of this session and their computation.
class FigureQueue : public QObject {
  Q_OBJECT

 public:
  explicit FigureQueue(FigureMaker maker = makeFigure, QObject* parent = nullptr);

  const FigureStatus& status(FigureName name) const { return of(name); }

  /// Returns the figure that is being computed.
  std::optional<FigureName> computing() const {
    return queue_.empty() ? std::nullopt : std::optional(queue_.front());
  }

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
  void begin(FigureName name);
  void end(FigureName name);

  std::vector<FigureStatus> statuses_;
  std::deque<FigureName> queue_;  // the first one is being computed
  const FigureMaker maker_;
  // Last: its thread ends before other members are destroyed.
  BackgroundWork work_{RequestPolicy::RunUntilEnd};
};

}  // namespace asperity
