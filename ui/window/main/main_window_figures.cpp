// The main window's page of the paper's figures: its menu, and how it changes places with the
// views.
#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QStackedWidget>
#include <QStatusBar>

#include "ui/language/translated.h"
#include "ui/panels/number_text.h"
#include "ui/window/main/contact_canvas.h"
#include "ui/window/figures/gallery_page.h"
#include "ui/window/main/main_window.h"
#include "ui/window/main/scene_document.h"
#include "ui/window/main/session.h"

namespace asperity {

namespace {

/// Of a page behind the other one, which otherwise takes the width that it would need in front.
constexpr QSizePolicy::Policy kNoRoom = QSizePolicy::Ignored;

/// As it stands in the menu: "Figure 2: Typical dependence …"; the two others by their headlines.
QString menuText(const FigureEntry& entry, const QString& numbered) {
  const QString headline = translatedText(entry.headline);
  return entry.name < FigureName::Master ? numbered.arg(figureLabel(entry.name), headline)
                                         : headline;
}

}  // namespace

void MainWindow::buildFigures() {
  figures_ =
      addCommand("figures", tr("All figures"), Qt::CTRL | Qt::Key_G, Symbol::Figures, [this] {
        if (isShowingFigures()) return closeFigures();
        openFigures();
        gallery().choose(gallery().chosen(), true);
      });
  figures_->setIconText(QChar(0x2002) + tr("Figures"));
  figures_->setCheckable(true);
}

GalleryPage& MainWindow::gallery() {
  if (!gallery_) makeGallery(std::make_unique<FigureGallery>());
  return *gallery_;
}

void MainWindow::makeGallery(std::unique_ptr<FigureGallery> figures) {
  gallery_ = new GalleryPage(std::move(figures));
  gallery_->setTheme(dark_ ? darkTheme() : lightTheme());
  gallery_->setSizePolicy(kNoRoom, kNoRoom);
  pages_->addWidget(gallery_);
  connect(gallery_, &GalleryPage::closed, this, &MainWindow::closeFigures);
  connect(gallery_, &GalleryPage::figureShown, this, &MainWindow::showExports);
  connect(gallery_, &GalleryPage::sceneWanted, this, [this](const Scene& scene) {
    closeFigures();
    replaceScene({{}, {}, scene});
  });
}

void MainWindow::fillFigures(QMenu& menu) {
  int key = Qt::Key_1;
  for (const FigureEntry& entry : figureEntries()) {
    QAction* action =
        menu.addAction(menuText(entry, tr("%1: %2")), this, [this, name = entry.name] {
          openFigures();
          gallery().choose(name, true);
        });
    action->setObjectName("figure:" + fromUtf8(entry.word));
    if (entry.name < FigureName::Master) action->setProperty("shortText", figureLabel(entry.name));
    action->setShortcut(QKeySequence(Qt::CTRL | static_cast<Qt::Key>(key++)));
  }
  menu.addSeparator();
  menu.addAction(figures_);
}

bool MainWindow::isShowingFigures() const {
  return gallery_ && pages_->currentWidget() == gallery_;
}

/// Parameters and facts, which are of the contact, make room; the run's keys are the page's: Space
/// is for its buttons.
void MainWindow::openFigures() {
  figures_->setChecked(true);
  if (isShowingFigures()) return;
  hadDock_ = !dock_->isHidden();
  hadStatus_ = !statusBar()->isHidden();
  dock_->hide();
  statusBar()->hide();
  for (QAction* action : {play_, step_, reset_}) action->setEnabled(false);
  gallery().setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
  pages_->setCurrentWidget(gallery_);
  followSight();
  showScreenMode();  // Escape is the page's
  showExports();
}

void MainWindow::closeFigures() {
  figures_->setChecked(false);
  if (!isShowingFigures()) return;
  if (hadDock_) dock_->show();
  statusBar()->setVisible(hadStatus_);
  for (QAction* action : {play_, step_, reset_}) action->setEnabled(true);
  gallery_->setSizePolicy(kNoRoom, kNoRoom);
  pages_->setCurrentIndex(0);
  followSight();
  showScreenMode();
  showExports();
  if (session_->frame()) canvas_->setFrame(session_->frame());
  canvas_->setFocus();
}

}  // namespace asperity
