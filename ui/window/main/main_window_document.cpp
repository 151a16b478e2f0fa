// The main window's document: steps of the scene, undone and done again; the question before what
// is not saved would be lost; the title.
#include <QAction>
#include <QCloseEvent>
#include <QDir>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>

#include "ui/language/translated.h"
#include "ui/panels/parameter_panel.h"
#include "ui/window/main/command_words.h"
#include "ui/window/main/gesture_counter.h"
#include "ui/window/main/main_window.h"
#include "ui/window/main/message_bar.h"
#include "ui/window/main/scene_document.h"
#include "ui/window/main/session.h"

namespace asperity {

void MainWindow::connectDocument() {
  connect(document_, &SceneDocument::sceneWanted, this, [this](const Scene& wanted) {
    panel_->setScene(wanted);
    session_->setScene(wanted);
    showAboutScene();
    showDescription();
  });
  connect(document_, &SceneDocument::changed, this, &MainWindow::showHistory);
}

void MainWindow::buildEditCommands() {
  undo_ = addCommand("undo", tr("Undo"), QKeySequence::Undo, Symbol::Undo,
                     [this] { document_->history().undo(); });
  redo_ = addCommand("redo", tr("Redo"), QKeySequence::Redo, Symbol::Redo,
                     [this] { document_->history().redo(); });
  QList<QKeySequence> again = QKeySequence::keyBindings(QKeySequence::Redo);
  if (const QKeySequence y(Qt::CTRL | Qt::Key_Y); !again.contains(y)) again += y;
  redo_->setShortcuts(again);
  // What the next step is called does not belong to the meaning of its key.
  undo_->setProperty("shortText", tr("Undo"));
  redo_->setProperty("shortText", tr("Redo"));
  revert_ = addCommand("revert", tr("Back to the scene as opened"), {}, Symbol::None, [this] {
    editScene(document_->origin().scene, QT_TR_NOOP("Back to the scene as opened"));
  });
  resetAll_ = addCommand("resetAll", tr("All parameters to their defaults"), {}, Symbol::None,
                         [this] { resetAll(); });
}

void MainWindow::fillEdit(QMenu& menu) {
  menu.addActions({undo_, redo_});
  menu.addSeparator();
  menu.addActions({copyPicture_, copyRender_, copyCurve_});
  menu.addSeparator();
  menu.addActions({revert_, resetAll_});
}

void MainWindow::showHistory() {
  const QUndoStack& history = document_->history();
  const auto say = [](QAction& action, const QString& plain, const QString& named, bool can,
                      const QString& what) {
    setCommandText(action, can ? named.arg(what) : plain);
    action.setEnabled(can);
  };
  say(*undo_, tr("Undo"), tr("Undo %1"), history.canUndo(), history.undoText());
  say(*redo_, tr("Redo"), tr("Redo %1"), history.canRedo(), history.redoText());
  undo_->setIconText(buttonText(tr("Undo")));
  redo_->setIconText(buttonText(tr("Redo")));
  revert_->setEnabled(document_->isChanged());
  showTitle();
}

/// Its title, or else its file's name; may be empty.
QString MainWindow::nameOfScene() const {
  const QString title = sceneText(document_->scene().title);
  return title.isEmpty() ? QFileInfo(document_->file()).fileName() : title;
}

void MainWindow::showTitle() {
  const QString name = nameOfScene();
  setWindowTitle(name.isEmpty() ? tr("Asperity[*]") : tr("%1[*] – Asperity").arg(name));
  setWindowModified(document_->isChanged());
}

/// What the panel of parameters has made of the scene.
void MainWindow::takeStep(const Scene& scene) {
  document_->change(scene, gestures_->present());
  session_->setScene(scene);
  showAboutScene();
}

void MainWindow::editScene(const Scene& scene, const char* what) {
  if (scene == document_->scene()) return;
  document_->change(scene, gestures_->present(), what);
  panel_->setScene(scene);
  session_->setScene(scene);
  showAboutScene();
  showDescription();
}

/// What a scene says of itself holds for its parameters.
void MainWindow::resetAll() {
  Scene scene;
  scene.folder = document_->scene().folder;
  editScene(scene, QT_TR_NOOP("All parameters"));
}

void MainWindow::showScene(const Scene& scene) {
  showScene(SceneOrigin{{}, {}, scene});
}

void MainWindow::showScene(const SceneOrigin& origin) {
  ++openings_;
  endTour();
  messages_->hide();  // whatever was said of the scene before
  complaint_.reset();
  described_.reset();
  document_->open(origin);
  panel_->setScene(origin.scene);
  session_->setScene(origin.scene, Session::Begin::Opened);
  showAboutScene();
  showDescription();
}

void MainWindow::replaceScene(const SceneOrigin& origin) {
  if (mayLeaveScene()) showScene(origin);
}

/// Whether the present scene may go: it is unchanged, was saved just now, or nobody wants it; what
/// was tried on the tour is not asked about.
bool MainWindow::mayLeaveScene() {
  if (!document_->isChanged() || isTouring_) return true;
  const QString name = nameOfScene();
  QMessageBox box(QMessageBox::Question, tr("Asperity"),
                  name.isEmpty() ? tr("The scene was changed. Save the changes?")
                                 : tr("“%1” was changed. Save the changes?").arg(name),
                  QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
  box.setObjectName("saveQuestion");
  const QString file = document_->file();
  box.setInformativeText(
      (file.isEmpty() ? tr("They go into a new file.")
                      : tr("They go into %1.")
                            .arg(QDir::toNativeSeparators(QFileInfo(file).absoluteFilePath()))) +
      ' ' + tr("Otherwise they are lost."));
  box.setDefaultButton(QMessageBox::Save);
  // Not every desktop gives its standard buttons a letter.
  box.button(QMessageBox::Save)->setText(tr("&Save"));
  box.button(QMessageBox::Discard)->setText(tr("&Discard"));
  box.button(QMessageBox::Cancel)->setText(tr("&Cancel"));
  switch (box.exec()) {
    case QMessageBox::Save:
      return save();
    case QMessageBox::Discard:
      return true;
    default:
      return false;
  }
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!mayLeaveScene()) return event->ignore();
  if (remembers_) saveLayout();
  QMainWindow::closeEvent(event);
}

}  // namespace asperity
