// The main window's files: scenes opened, saved and dropped on it.
#include <QDir>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QTimer>
#include <QUrl>
#include <exception>
#include <filesystem>
#include <string>

#include "core/base/atomic_file.h"
#include "core/base/input_error.h"
#include "core/scene/provenance.h"
#include "core/scene/scene_file.h"
#include "ui/language/translated.h"
#include "ui/panels/parameter_panel.h"
#include "ui/window/main/ask_file.h"
#include "ui/window/main/command_words.h"
#include "ui/window/main/main_window.h"
#include "ui/window/main/message_bar.h"
#include "ui/window/main/recent_files.h"
#include "ui/window/main/scene_document.h"
#include "ui/window/tasks/latest_work.h"

namespace asperity {

namespace {

/// The scene as it has to be written into `folder`: a profile is named relative to its scene's
/// file.
Scene writtenInto(const std::filesystem::path& folder, Scene scene) {
  const std::filesystem::path profile = scene.surface.file;
  if (profile.empty() || profile.is_absolute()) return scene;
  scene.surface.file =
      std::filesystem::absolute(scene.folder / profile)
          .lexically_normal()
          .lexically_proximate(std::filesystem::absolute(folder).lexically_normal())
          .string();
  return scene;
}

}  // namespace

void MainWindow::buildFileCommands() {
  open_ = addCommand("open", tr("Open scene…"), QKeySequence::Open, Symbol::Open,
                     [this] { askOpen(); });
  save_ =
      addCommand("save", tr("Save scene"), QKeySequence::Save, Symbol::Save, [this] { save(); });
  save_->setIconText(buttonText(tr("Save")));
  saveAs_ = addCommand("saveAs", tr("Save scene as…"), Qt::CTRL | Qt::SHIFT | Qt::Key_S,
                       Symbol::None, [this] { askSave(); });
}

void MainWindow::fillFiles(QMenu& menu) {
  menu.addAction(open_);
  recent_ = menu.addMenu(tr("Open recent"));
  recent_->setObjectName("recentMenu");
  connect(&menu, &QMenu::aboutToShow, this, &MainWindow::fillRecent);
  menu.addSeparator();
  menu.addActions({save_, saveAs_});
  menu.addAction(savePicture_);
  menu.addSeparator();
  menu.addAction(
      addCommand("quit", tr("Quit"), QKeySequence::Quit, Symbol::None, [this] { close(); }));
  fillRecent();
}

/// Two files of one name are told apart by the tooltips.
void MainWindow::fillRecent() {
  recent_->clear();
  const QStringList files = recentFiles();
  for (const QString& file : files) {
    QAction* action =
        recent_->addAction(QFileInfo(file).fileName().replace('&', "&&"), this, [this, file] {
          if (mayLeaveScene()) openScene(file);
        });
    action->setToolTip(file);
  }
  recent_->setToolTipsVisible(true);
  recent_->setEnabled(!files.isEmpty());
  if (files.isEmpty()) return;
  recent_->addSeparator();
  recent_->addAction(tr("Clear this list"), this, [this] {
    clearRecentFiles();
    fillRecent();
  });
}

void MainWindow::openScene(const QString& file) {
  if (!reader_) reader_ = std::make_unique<LatestWork>();
  reader_->request([this, file, number = ++openings_](const std::stop_token&) {
    std::shared_ptr<const FoundScene> found;
    Message error;
    try {
      found = std::make_shared<const FoundScene>(findScene(file.toStdString()));
    } catch (const std::exception& failure) {
      error = messageOf(failure);
    }
    const auto take = [this, file, number, found, error] {
      if (number != openings_) return;  // another scene was shown meanwhile
      if (found) return showFound(file, *found);
      messages_->showFailure(MessageBar::Failure::Files, translatedText(error));
      emit sceneRead(file, false);
    };
    QMetaObject::invokeMethod(this, take, Qt::QueuedConnection);
  });
}

void MainWindow::showFound(const QString& file, const FoundScene& found) {
  const bool mayShow = mayShowFound(file, found);
  if (mayShow) {
    // What was opened from a picture is not saved over it.
    showScene({{}, found.isCarried ? QString() : file, found.scene});
    addRecentFile(file);
    fillRecent();
  }
  emit sceneRead(file, mayShow);
}

/// Asks where a scene that another person may have put into a file wants more than to be shown.
bool MainWindow::mayShowFound(const QString& file, const FoundScene& found) {
  const SceneDemands demands = found.isCarried ? demandsOf(found.scene) : SceneDemands{};
  if (!demands.any()) return true;
  QStringList wants;
  if (!demands.file.empty())
    wants += tr("It reads a file that does not lie beside it: %1")
                 .arg(QDir::toNativeSeparators(QString::fromStdString(demands.file.string())));
  if (demands.memory > 0)
    wants +=
        tr("It takes about %1 GB of memory.").arg(QLocale().toString(demands.memory / 1e9, 'f', 1));
  if (demands.seconds > 0)
    wants += tr("Its curve takes about %1 minutes of processor time.")
                 .arg(QLocale().toString(demands.seconds / 60, 'g', 2));
  QMessageBox box(QMessageBox::Warning, tr("Asperity"), {}, QMessageBox::Open | QMessageBox::Cancel,
                  this);
  box.setObjectName("demandQuestion");
  box.setTextFormat(Qt::PlainText);  // names of files are no markup
  box.setText(tr("Open the scene in “%1”?").arg(QFileInfo(file).fileName()) + "\n\n" +
              wants.join('\n'));
  box.setDefaultButton(QMessageBox::Cancel);
  box.button(QMessageBox::Open)->setText(tr("&Open"));
  box.button(QMessageBox::Cancel)->setText(tr("&Cancel"));
  return box.exec() == QMessageBox::Open;
}

bool MainWindow::saveScene(const QString& file) {
  try {
    if (const Missing missing = missingOf(panel_->scene()); !missing.text.isEmpty())
      throw InputError("", std::string(missing.key), missing.text.toStdString());
    const std::filesystem::path path = std::filesystem::absolute(file.toStdString());
    checkWritable(path);
    writeFileAtomically(path, writeScene(writtenInto(path.parent_path(), document_->scene())));
  } catch (const std::exception& error) {
    messages_->showFailure(MessageBar::Failure::Files, translatedError(error));
    return false;
  }
  endFailure(MessageBar::Failure::Files);
  document_->saved(file);
  addRecentFile(file);
  fillRecent();
  return true;
}

bool MainWindow::save() {
  return document_->file().isEmpty() ? askSave() : saveScene(document_->file());
}

bool MainWindow::askSave() {
  const QString name = document_->file().isEmpty() ? document_->proposedFile() : document_->file();
  const QString file = askSaveFile(this, tr("Save scene"), name, tr("Scenes (*.json)"));
  return !file.isEmpty() && saveScene(file);
}

void MainWindow::askOpen() {
  if (!mayLeaveScene()) return;
  const QString file = QFileDialog::getOpenFileName(
      this, tr("Open scene"), document_->file(),
      tr("Scenes, and what was made from one (*.json *.png *.svg *.pdf *.csv *.mp4 *.webm *.gif "
         "*.webp);;Scenes (*.json);;All files (*)"));
  if (!file.isEmpty()) openScene(file);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  const QList<QUrl> urls = event->mimeData()->urls();
  if (urls.size() == 1 && urls.front().isLocalFile()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const QList<QUrl> urls = event->mimeData()->urls();
  if (urls.size() != 1 || !urls.front().isLocalFile()) return;
  event->acceptProposedAction();
  const QString file = urls.front().toLocalFile();
  if (!document_->isChanged() || isTouring_) return openScene(file);
  QTimer::singleShot(0, this, [this, file] {  // who dropped it does not wait for an answer
    if (mayLeaveScene()) openScene(file);
  });
}

}  // namespace asperity
