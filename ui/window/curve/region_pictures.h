// The diagrams of a figure one at a time, each as large as the room allows, with a button for each
// over them: work against precision, region by region. Or a line of text where there is no figure.
// GUI thread; belongs to its parent.
#pragma once

#include <QWidget>
#include <memory>

#include "ui/contact/contact_picture.h"
#include "ui/window/figures/made_figure.h"

class QButtonGroup;
class QHBoxLayout;
class QLabel;

namespace asperity {

class FigurePicture;

class RegionPictures : public QWidget {
  Q_OBJECT

 public:
  explicit RegionPictures(QWidget* parent = nullptr);

  /// The diagram that was chosen last comes first, if there is one with its name.
  void showFigure(std::shared_ptr<const MadeFigure> made);
  void showText(const QString& text);
  void setTheme(const Theme& theme);

  /// The place of the diagram in sight; -1: there is none. Choosing what is not there does nothing.
  int chosen() const;
  void choose(int index);

  /// None where there is text.
  std::shared_ptr<const MadeFigure> figure() const { return made_; }
  FigurePicture& picture() { return *picture_; }

 private:
  void clearButtons();

  std::shared_ptr<const MadeFigure> made_;
  QWidget* bar_;
  QHBoxLayout* places_;
  QButtonGroup* buttons_;
  QLabel* range_;  // what the chosen diagram's title says beyond its name
  FigurePicture* picture_;
  QString chosen_;  // its name
};

}  // namespace asperity
