// The paper's figures in a list: label, headline, and the progress of each in the queue. GUI
// thread; owned by its parent.
#pragma once

#include <QListWidget>

#include "ui/window/figures/figure_queue.h"

namespace asperity {

class FigureList : public QListWidget {
  Q_OBJECT

 public:
  /// queue: the state of the figures that are listed.
  explicit FigureList(const FigureQueue& queue, QWidget* parent = nullptr);

  FigureName chosen() const;
  void choose(FigureName name);

  /// Returns a width at which label and state fit beside each other, and no word is broken.
  QSize minimumSizeHint() const override;

 signals:
  void chosenChanged(asperity::FigureName name);
  /// Emitted for the chosen figure by Enter or a double click.
  void computeRequested();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void showTexts();
  void showStatus(FigureName name);

  const FigureQueue& queue_;
};

/// Returns "not computed", "waiting", "42 %", "ready, 20 lines" or "failed".
QString stateText(FigureName name, const FigureStatus& status);

}  // namespace asperity
