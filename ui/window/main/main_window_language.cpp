// The main window's language, changed while it is open: everything with words in it is made anew
// around the session, the document and the contact view, which have none and go on. What was set up
// by hand is put back afterwards.
#include <QAction>
#include <QActionGroup>
#include <QDialog>
#include <QDockWidget>
#include <QMenuBar>
#include <QSplitter>
#include <QStatusBar>
#include <QTabWidget>
#include <QToolBar>
#include <memory>

#include "ui/chart/chart_view.h"
#include "ui/language/language.h"
#include "ui/panels/parameter_panel.h"
#include "ui/window/accuracy/accuracy_panel.h"
#include "ui/window/main/contact_canvas.h"
#include "ui/window/figures/figure_gallery.h"
#include "ui/window/figures/gallery_page.h"
#include "ui/window/main/main_window.h"
#include "ui/window/main/message_bar.h"
#include "ui/window/main/scene_document.h"
#include "ui/window/main/session.h"
#include "ui/window/main/status_line.h"
#include "ui/window/main/tour_bar.h"

namespace asperity {

/// What is neither in the session nor in the document.
struct MainWindow::Arrangement {
  QByteArray docks, split;
  QList<bool> tabs;  // in order: wanted
  int tab = 0;
  std::optional<ChartWindow> zoom;  // of the friction curve
  Scene typed;                     // in the panel, where it may miss something yet
  PanelState panel;
  QString focus;  // name of what had it
  std::optional<CurveSetting> comparison;
  std::optional<ComparedMethods> methods;
  QString message;  // that is no complaint of the scene; in the language of its time
  MessageBar::Failure failure = MessageBar::Failure::None;
  bool isDescribed = false, isOffered = false, isTouring = false;
  int tourStep = 0;
  std::unique_ptr<FigureGallery> figures;
  GalleryState gallery;
  bool isShowingFigures = false;
};

void MainWindow::setLanguage(std::string_view code) {
  const std::string_view known = languageFor(code);
  if (known.empty() || known == presentLanguage()) return;
  setPresenting(false);
  Arrangement arrangement = arrangementNow();
  takeApart();
  useLanguage(known);
  document_->nameSteps();
  putTogether();
  arrange(std::move(arrangement));
}

MainWindow::Arrangement MainWindow::arrangementNow() {
  Arrangement now;
  if (const QWidget* focused = focusWidget()) now.focus = focused->objectName();
  now.isShowingFigures = isShowingFigures();
  closeFigures();
  now.docks = saveState();
  now.split = splitter_->saveState();
  for (const QAction* action : std::as_const(tabActions_)) now.tabs += action->isChecked();
  now.tab = tabs_->currentIndex();
  if (plot_->isZoomed()) now.zoom = plot_->window();
  now.typed = panel_->scene();
  now.panel = panel_->state();
  now.comparison = accuracy_->comparison();
  now.methods = accuracy_->comparedMethods();
  if (!messages_->isHidden() && messages_->failure() != MessageBar::Failure::Scene) {
    now.message = messages_->text();
    now.failure = messages_->failure();
  }
  now.isDescribed = !description_->isHidden();
  now.isOffered = !hint_->isHidden();
  now.isTouring = isTouring_;
  now.tourStep = tourBar_->step();
  if (gallery_) {
    now.gallery = gallery_->state();
    now.figures = gallery_->takeFigures();
  }
  return now;
}

/// The canvas stays in the window, so that it keeps its OpenGL context. A part that goes loses the
/// focus, and an entry then gives what is typed in it: nobody here listens any more.
void MainWindow::takeApart() {
  for (QObject* source :
       std::initializer_list<QObject*>{session_, document_, canvas_, panel_, accuracy_, plot_})
    source->disconnect(this);
  canvas_->setParent(this);
  for (QDialog* dialog : findChildren<QDialog*>(Qt::FindDirectChildrenOnly)) delete dialog;
  delete menuBar();
  removeToolBar(tools_);
  delete tools_;
  delete parts_;
  qDeleteAll(canvas_->actions());
  qDeleteAll(canvas_->findChildren<QActionGroup*>(Qt::FindDirectChildrenOnly));
  removeDockWidget(dock_);
  delete dock_;
  delete takeCentralWidget();
  statusBar()->removeWidget(status_);
  delete status_;
  gallery_ = nullptr;
  for (QList<QAction*>* actions : {&tabActions_, &colourActions_}) actions->clear();
}

void MainWindow::arrange(Arrangement arrangement) {
  centralWidget()->show();  // at once: a layout shows what it is given later
  restoreState(arrangement.docks);
  splitter_->restoreState(arrangement.split);
  setDark(dark_);
  colourActions_.at(static_cast<int>(colours_))->setChecked(true);
  showAboutScene();
  if (!(arrangement.typed == session_->scene())) panel_->setScene(arrangement.typed);
  accuracy_->setComparison(arrangement.comparison);
  if (arrangement.methods) accuracy_->showComparedMethods(*arrangement.methods);
  for (int i = 0; i < tabActions_.size(); ++i) tabActions_[i]->setChecked(arrangement.tabs[i]);
  if (tabs_->isTabVisible(arrangement.tab)) tabs_->setCurrentIndex(arrangement.tab);

  isTouring_ = arrangement.isTouring;
  if (isTouring_) showTourBar(arrangement.tourStep);
  if (arrangement.isOffered) offerTour();
  described_.reset();
  showDescription();
  if (!arrangement.isDescribed) description_->hide();
  if (complaint_) showComplaint();
  if (!arrangement.message.isEmpty())
    messages_->showFailure(arrangement.failure, arrangement.message);

  showHistory();
  showPlaying(session_->isPlaying());
  showScreenMode();
  if (session_->frame()) showFrame();
  if (arrangement.figures) {
    makeGallery(std::move(arrangement.figures));
    gallery_->setState(arrangement.gallery);
  }
  if (arrangement.isShowingFigures) openFigures();
  plot_->setZoom(arrangement.zoom);
  panel_->setState(arrangement.panel);
  if (arrangement.focus.isEmpty()) return;
  if (auto* focused = findChild<QWidget*>(arrangement.focus)) focused->setFocus();
}

}  // namespace asperity
