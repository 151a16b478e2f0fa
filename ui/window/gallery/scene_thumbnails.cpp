#include "ui/window/gallery/scene_thumbnails.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QSaveFile>
#include <QStandardPaths>
#include <algorithm>

#include "core/scene/scene_file.h"
#include "ui/window/main/appearance.h"
#include "ui/window/main/scene_library.h"

namespace asperity {

namespace {

constexpr int kMaxFiles = 400;  // in the cache; older ones are removed

QImage readPicture(const QString& file) {
  const QImage image(file);
  // Other files in the folder are not pictures of this program.
  return image.width() > 0 && image.width() <= 2000 && image.height() <= 2000 ? image : QImage();
}

/// Writes the picture, so that the file is whole or absent.
void keepPicture(const QString& file, const QImage& image) {
  const QDir folder = QFileInfo(file).dir();
  if (!folder.mkpath(QStringLiteral("."))) return;
  QSaveFile out(file);
  if (!out.open(QIODevice::WriteOnly)) return;
  if (image.save(&out, "PNG")) out.commit();
  const QFileInfoList all = folder.entryInfoList({"*.png"}, QDir::Files, QDir::Time);
  for (int i = kMaxFiles; i < all.size(); ++i) QFile::remove(all[i].filePath());
}

}  // namespace

QString thumbnailName(const Scene& scene, SceneView view, const Theme& theme) {
  // Another build of the program may draw differently.
  static const QByteArray program =
      QByteArray(ASPERITY_VERSION) + ' ' +
      QByteArray::number(
          QFileInfo(QCoreApplication::applicationFilePath()).lastModified().toMSecsSinceEpoch());
  QCryptographicHash hash(QCryptographicHash::Sha256);
  hash.addData(program);
  hash.addData(isDark(theme) ? " dark " : " light ");
  hash.addData(QByteArray::number(static_cast<int>(view)));
  hash.addData(QByteArray::fromStdString(writeScene(scene)));
  return QString::fromLatin1(hash.result().toHex().left(32)) + QStringLiteral(".png");
}

QString thumbnailFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::CacheLocation) +
         QStringLiteral("/thumbnails");
}

SceneThumbnails::SceneThumbnails(Drawing draw, const QString& folder, QObject* parent)
    : QObject(parent),
      draw_(std::move(draw)),
      folder_(folder.isEmpty() ? thumbnailFolder() : folder) {}

void SceneThumbnails::setTheme(const Theme& theme) {
  if (isDark(theme) == isDark(theme_) && !requested_.isEmpty()) return;
  theme_ = theme;
  requested_.clear();
  waiting_.clear();
  work_.cancel();
  isDrawing_ = false;
}

QPixmap SceneThumbnails::picture(const QString& scene) {
  request(scene);
  return pictures_.value(scene);
}

void SceneThumbnails::requestAll() {
  for (const LibraryScene& entry : libraryScenes()) {
    if (requested_.contains(entry.name)) continue;
    requested_ += entry.name;
    waiting_.push_back(entry.name);
  }
  drawNext();
}

void SceneThumbnails::request(const QString& scene) {
  if (requested_.contains(scene)) return;
  requested_ += scene;
  waiting_.push_back(scene);
  drawNext();
}

void SceneThumbnails::drawNext() {
  if (isDrawing_ || waiting_.empty()) return;
  const QString name = waiting_.front();
  waiting_.pop_front();
  const std::vector<LibraryScene>& library = libraryScenes();
  const auto found = std::ranges::find(library, name, &LibraryScene::name);
  const SceneCard* card = findCard(name);
  if (found == library.end() || !card) return drawNext();
  isDrawing_ = true;
  const auto done = [this, name](const QImage& image) {
    isDrawing_ = false;
    if (!image.isNull()) {
      pictures_[name] = QPixmap::fromImage(image);
      emit changed(name);
    }
    drawNext();
  };
  work_.request(
      [draw = draw_, scene = found->scene, view = card->view, theme = theme_,
       folder = folder_](const BackgroundWork::Run& run) {
        const QString file = folder + '/' + thumbnailName(scene, view, theme);
        QImage image = readPicture(file);
        if (!image.isNull()) return image;
        image = draw(scene, view, theme, run.stop());
        keepPicture(file, image);
        return image;
      },
      done, [done](const QString&) { done({}); });
}

}  // namespace asperity
