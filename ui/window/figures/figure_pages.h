// Two pages of the window, of which one is shown: the views of the scene, and the page of the
// paper's figures, which is made when it is first needed. The figures are computed on while the
// views are shown. GUI thread; belongs to its parent.
#pragma once

#include <QStackedWidget>

#include "core/scene/scene.h"
#include "ui/contact/contact_picture.h"

class QMenu;

namespace asperity {

class Commands;
class GalleryPage;

class FigurePages : public QStackedWidget {
  Q_OBJECT

 public:
  explicit FigurePages(QWidget* views, QWidget* parent = nullptr);

  void addTo(Commands& commands);
  /// Adds an entry for each figure, with its key.
  void fillMenu(QMenu& menu);

  void openFigures();
  void closeFigures();
  bool isShowingFigures() const;
  GalleryPage& gallery();
  void setTheme(const Theme& theme);

 signals:
  /// Emitted when the other page came to the front.
  void switched(bool isShowingFigures);
  /// Emitted when another figure, or none, is shown on its page.
  void figureShown();
  /// Emitted with the scene of a figure that the user wants to edit.
  void sceneWanted(const asperity::Scene& scene);

 private:
  Commands* commands_ = nullptr;
  GalleryPage* gallery_ = nullptr;
  Theme theme_ = lightTheme();
};

}  // namespace asperity
