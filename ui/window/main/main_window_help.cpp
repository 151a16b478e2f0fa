// The main window's help: the guided tour and its offer, the sheet of shortcuts, about.
#include <QAction>
#include <QMenu>
#include <QMessageBox>
#include <QSettings>
#include <algorithm>

#include "ui/panels/parameter_panel.h"
#include "ui/window/main/main_window.h"
#include "ui/window/main/message_bar.h"
#include "ui/window/main/scene_document.h"
#include "ui/window/main/scene_library.h"
#include "ui/window/main/session.h"
#include "ui/window/main/shortcut_sheet.h"
#include "ui/window/main/tour.h"
#include "ui/window/main/tour_bar.h"

namespace asperity {

namespace {

const QString kOffered = QStringLiteral("tour/offered");

}  // namespace

void MainWindow::buildHelpCommands() {
  tour_ = addCommand("tour", tr("Guided tour"), {}, Symbol::None, [this] { startTour(); });
  tourBack_ = addCommand("tourStepBack", tr("Tour: back"), Qt::ALT | Qt::Key_Left, Symbol::None,
                         [this] { showTourStep(tourBar_->step() - 1); });
  tourNext_ = addCommand("tourStepNext", tr("Tour: next"), Qt::ALT | Qt::Key_Right, Symbol::None,
                         [this] { showTourStep(tourBar_->step() + 1); });
  // A presenter's remote control sends the second ones.
  tourBack_->setShortcuts({Qt::ALT | Qt::Key_Left, Qt::Key_PageUp});
  tourNext_->setShortcuts({Qt::ALT | Qt::Key_Right, Qt::Key_PageDown});
  for (QAction* action : {tourBack_, tourNext_}) action->setEnabled(false);
  shortcuts_ = addCommand("shortcuts", tr("Keyboard shortcuts"), Qt::Key_F1, Symbol::None,
                          [this] { showShortcuts(); });
  shortcuts_->setShortcuts({Qt::Key_F1, Qt::Key_Question});
  about_ = addCommand("about", tr("About Asperity"), {}, Symbol::None, [this] { showAbout(); });
  connect(tourBar_, &TourBar::stepWanted, this, &MainWindow::showTourStep);
  connect(tourBar_, &TourBar::ended, this, &MainWindow::endTour);
  connect(hint_, &MessageBar::accepted, this, &MainWindow::startTour);
  connect(hint_, &MessageBar::closed, this, [] { QSettings().setValue(kOffered, true); });
}

void MainWindow::fillHelp(QMenu& menu) {
  menu.addAction(tour_);
  menu.addActions({tourBack_, tourNext_});
  menu.addSeparator();
  menu.addAction(shortcuts_);
  menu.addSeparator();
  menu.addAction(about_);
}

/// Once, and not again when it was taken or put away.
void MainWindow::offerTour() {
  if (QSettings().value(kOffered).toBool()) return;
  hint_->showOffer(tr("New here? A tour of six steps shows what there is to see."),
                   tr("Take the tour"));
}

void MainWindow::startTour() {
  QSettings().setValue(kOffered, true);
  hint_->hide();
  if (!mayLeaveScene()) return;
  closeFigures();
  isTouring_ = true;
  showTourStep(0);
}

/// What was tried in a step is play: the next one comes without a question.
void MainWindow::showTourStep(int step) {
  const auto count = static_cast<int>(tourSteps().size());
  if (!isTouring_ || step < 0 || step >= count) return;
  const QString name = QString::fromLatin1(tourSteps()[static_cast<std::size_t>(step)].scene);
  const std::vector<LibraryScene>& library = libraryScenes();
  const auto found = std::ranges::find(library, name, &LibraryScene::name);
  if (found == library.end()) return endTour();
  showScene({name, {}, found->scene});
  isTouring_ = true;
  showTourBar(step);
}

void MainWindow::showTourBar(int step) {
  tourBar_->showStep(step);
  description_->hide();
  tourBack_->setEnabled(step > 0);
  tourNext_->setEnabled(step + 1 < static_cast<int>(tourSteps().size()));
}

/// The scene stays, with what was tried.
void MainWindow::endTour() {
  isTouring_ = false;
  tourBar_->hide();
  for (QAction* action : {tourBack_, tourNext_}) action->setEnabled(false);
}

void MainWindow::showShortcuts() {
  auto* sheet = new ShortcutSheet(*this, this);
  sheet->setAttribute(Qt::WA_DeleteOnClose);
  sheet->open();
}

void MainWindow::showAbout() {
  auto* box = new QMessageBox(this);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setWindowTitle(tr("About Asperity"));
  box->setText(tr("<h3>Asperity %1</h3>").arg(ASPERITY_VERSION));
  box->setInformativeText(
      tr("Shows how a viscoelastic elastomer slides over a randomly rough rigid line, after Li et "
         "al., <i>Friction between a viscoelastic body and a rigid surface with random self-affine "
         "roughness</i>, Physical Review Letters 111, 034301 (2013).<br><br>The elements of the "
         "elastomer are independent of each other: long-range elastic coupling is not in the "
         "model.<br><br>Free software, GPL-3.0-or-later."));
  box->open();
}

}  // namespace asperity
