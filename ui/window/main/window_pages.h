// The pages of the window, of which one is shown: the views of the scene, the page of the paper's
// figures, and the gallery of scenes. The last two are made when they are first needed. The figures
// are computed on while another page is shown. GUI thread; owned by its parent.
#pragma once

#include <QStackedWidget>

#include "core/scene/scene.h"

class QMenu;

namespace asperity {

class Commands;
class FiguresPage;
class SceneGallery;

class WindowPages : public QStackedWidget {
  Q_OBJECT

 public:
  explicit WindowPages(QWidget* views, QWidget* parent = nullptr);

  void addTo(Commands& commands);
  /// Adds an entry for each figure, with its key.
  void fillMenu(QMenu& menu);

  void openFigures();
  /// Shows the gallery with the card of this shipped scene as the current one.
  void openGallery(const QString& scene);
  /// Shows the views in place of another page.
  void showViews();
  bool isShowingFigures() const;
  bool isShowingGallery() const;
  bool isShowingViews() const { return currentIndex() == 0; }
  FiguresPage& figuresPage();
  SceneGallery& gallery();

 signals:
  /// Emitted when the views were covered by another page, or came to the front again.
  void pageChanged(bool areViewsCovered);
  /// Emitted when another figure, or none, is shown on its page.
  void figureShown();
  /// Emitted with the scene of a figure when the user requests to edit it.
  void sceneRequested(const asperity::Scene& scene);
  /// Emitted with the name of a shipped scene that the user chose.
  void shippedSceneRequested(const QString& scene);
  /// Emitted when the user requests the gallery, which openGallery() then shows.
  void galleryRequested();

 private:
  template <class Page>
  Page* addPage();
  void show(QWidget& page);

  Commands* commands_ = nullptr;
  FiguresPage* figuresPage_ = nullptr;
  SceneGallery* gallery_ = nullptr;
};

}  // namespace asperity
