// The main window's files: scenes opened, saved and dropped on it.
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QMimeData>
#include <QUrl>
#include <exception>
#include <filesystem>
#include <string>

#include "core/scene/atomic_file.h"
#include "core/scene/input_error.h"
#include "core/scene/provenance.h"
#include "core/scene/scene_file.h"
#include "ui/panels/parameter_panel.h"
#include "ui/window/main_window.h"
#include "ui/window/message_bar.h"

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

bool MainWindow::openScene(const QString& file) {
  try {
    showScene(readProvenance(file.toStdString()));
  } catch (const InputError& error) {
    messages_->showMessage(QString::fromUtf8(error.what()));
    return false;
  }
  // What was opened from a picture is not saved over it.
  file_ = file.endsWith(QLatin1String(".json"), Qt::CaseInsensitive) ? file : QString();
  showTitle();
  return true;
}

bool MainWindow::saveScene(const QString& file) {
  try {
    if (const Missing missing = missingOf(panel_->scene()); !missing.text.isEmpty())
      throw InputError("", std::string(missing.key), missing.text.toStdString());
    const std::filesystem::path path = std::filesystem::absolute(file.toStdString());
    checkWritable(path);
    writeFileAtomically(path, writeScene(writtenInto(path.parent_path(), panel_->scene())));
  } catch (const std::exception& error) {
    messages_->showMessage(QString::fromUtf8(error.what()));
    return false;
  }
  file_ = file;
  showTitle();
  return true;
}

void MainWindow::askOpen() {
  const QString file = QFileDialog::getOpenFileName(
      this, tr("Open scene"), file_,
      tr("Scenes (*.json);;Pictures and tables (*.png *.svg *.pdf *.csv *.mp4 "
         "*.webm *.gif *.webp)"));
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
  openScene(urls.front().toLocalFile());
}

void MainWindow::askSave() {
  const QString file = QFileDialog::getSaveFileName(
      this, tr("Save scene"), file_.isEmpty() ? QStringLiteral("scene.json") : file_,
      tr("Scenes (*.json)"));
  if (!file.isEmpty()) saveScene(file);
}

}  // namespace asperity
