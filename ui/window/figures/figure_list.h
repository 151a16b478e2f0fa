// The paper's figures in a list: label, headline, and the progress of each. GUI thread; owned by
// its parent.
#pragma once

#include <QListWidget>
#include <vector>

#include "ui/window/figures/figure_queue.h"

namespace asperity {

class FigureList : public QListWidget {
  Q_OBJECT

 public:
  explicit FigureList(QWidget* parent = nullptr);

  FigureName chosen() const;
  void choose(FigureName name);
  void showStatus(FigureName name, const FigureStatus& status);

  /// Returns a width at which label and state fit beside each other, and no word is broken.
  QSize minimumSizeHint() const override;

 signals:
  void chosenChanged(asperity::FigureName name);
  /// Emitted by Enter or a double click.
  void computeRequested(asperity::FigureName name);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void showTexts();

  std::vector<FigureStatus> statuses_;
};

/// Returns "not computed", "waiting", "42 %", "ready, 20 lines" or "failed".
QString stateText(FigureName name, const FigureStatus& status);

}  // namespace asperity
