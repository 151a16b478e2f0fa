// Shows the diagrams of a figure one at a time, as large as possible, with a button for each above
// them: work-precision diagrams by region. Shows a line of text where there is no figure. GUI
// thread; owned by its parent.
#pragma once

#include <QWidget>
#include <memory>

#include "ui/contact/contact_picture.h"
#include "ui/window/figures/computed_figure.h"

class QButtonGroup;
class QHBoxLayout;
class QLabel;

namespace asperity {

class FigurePicture;

class RegionPictures : public QWidget {
  Q_OBJECT

 public:
  explicit RegionPictures(QWidget* parent = nullptr);

  /// Shows a figure. The diagram that was chosen last comes first, if there is one with its name.
  void showFigure(std::shared_ptr<const ComputedFigure> made);
  void showText(const QString& text);
  void setTheme(const Theme& theme);

  /// Returns the index of the visible diagram; -1: there is none. Choosing a missing one does
  /// nothing.
  int chosen() const;
  void choose(int index);

  /// Returns the figure; null where there is text.
  std::shared_ptr<const ComputedFigure> figure() const { return figure_; }
  FigurePicture& picture() { return *picture_; }

 private:
  void clearButtons();

  std::shared_ptr<const ComputedFigure> figure_;
  QWidget* bar_;
  QHBoxLayout* places_;
  QButtonGroup* buttons_;
  QLabel* range_;  // rest of the chosen diagram's title after its name
  FigurePicture* picture_;
  QString chosen_;  // name of the chosen diagram
};

}  // namespace asperity
