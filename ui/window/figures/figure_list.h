// The paper's figures one below the other: label, headline, and how far each is. GUI thread;
// belongs to its parent.
#pragma once

#include <QListWidget>
#include <vector>

#include "ui/window/figures/figure_gallery.h"

namespace asperity {

class FigureList : public QListWidget {
  Q_OBJECT

 public:
  explicit FigureList(QWidget* parent = nullptr);

  FigureName chosen() const;
  void choose(FigureName name);
  void showStatus(FigureName name, const FigureStatus& status);

  /// Label and state stand beside each other, and no word is broken.
  QSize minimumSizeHint() const override;

 signals:
  void chosenChanged(asperity::FigureName name);
  /// By Enter or a double click.
  void wanted(asperity::FigureName name);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void showTexts();

  std::vector<FigureStatus> statuses_;
};

/// "not computed", "waiting", "42 %", "ready, 20 lines", "failed".
QString stateText(FigureName name, const FigureStatus& status);

}  // namespace asperity
