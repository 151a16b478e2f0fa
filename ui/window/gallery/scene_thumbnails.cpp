#include "ui/window/gallery/scene_thumbnails.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QSaveFile>
#include <QStandardPaths>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "core/accuracy/compute_curve.h"
#include "core/base/stop.h"
#include "core/chart/curve_diagram.h"
#include "core/chart/curve_set.h"
#include "core/run/simulation.h"
#include "core/run/steady_frames.h"
#include "core/run/transient_diagram.h"
#include "core/scene/scene_file.h"
#include "ui/chart/diagram_picture.h"
#include "ui/contact/contact_picture.h"
#include "ui/draw/fonts.h"
#include "ui/draw/pixel_context.h"
#include "ui/window/main/scene_library.h"

namespace asperity {

// ---- Drawing a picture

namespace {

constexpr std::int64_t kLines = 6;  // of a friction curve; smooth enough for a small picture
constexpr int kParts = 100;         // of a motion, between which it can be stopped

/// Draws the list without its texts and returns the part inside of the axes.
QImage cropped(DrawList list, const QRectF& part) {
  list.texts.clear();
  const QRect whole = part.toAlignedRect().intersected(QRect(0, 0, list.width, list.height));
  return renderImage(contextOfThread(), list)
      .copy(whole)
      .scaled(kScenePicture, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

/// Sets the size of a picture so that the part inside of its axes has this size: what is cropped to
/// that part is not stretched. `inside`: returns that part for the present options.
template <class Options, class Inside>
void sizeAround(Options& options, const QSize& part, const Inside& inside) {
  options.width = part.width();
  options.height = part.height();
  for (int i = 0; i < 3; ++i) {  // wider axes have other numbers beside them
    const Box box = inside();
    options.width += static_cast<int>(std::lround(static_cast<float>(part.width()) - box.width));
    options.height += static_cast<int>(std::lround(static_cast<float>(part.height()) - box.height));
  }
}

/// Returns the view of the contact under the greatest pressure, as wide as shows its summit.
ContactView closeUp(const Frame& frame) {
  constexpr double kPart = 0.26;  // of the period
  ContactView view = fittedView(frame);
  const auto count = static_cast<std::int64_t>(frame.pressure.size());
  if (count == 0) return view;
  const auto most = std::ranges::max_element(frame.pressure) - frame.pressure.begin();
  view.width = kPart * frame.length;
  view.left = (static_cast<double>(most) + 0.5) * frame.spacing - 0.5 * view.width;
  // Heights from below the contact to the middle height of the line beside it.
  const auto half = static_cast<std::int64_t>(0.5 * kPart * static_cast<double>(count));
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest, deepest = lowest;
  for (std::int64_t i = most - half; i <= most + half; ++i) {
    const auto at = static_cast<std::size_t>(((i % count) + count) % count);
    lowest = std::min(lowest, static_cast<double>(frame.lineHeight[at]));
    highest = std::max(highest, static_cast<double>(frame.lineHeight[at]));
    deepest = std::min(deepest, static_cast<double>(frame.surfaceHeight[at]));
  }
  const double size = 0.6 * (highest - lowest);
  if (!(size > 0)) return view;
  view.bottom = std::min(lowest, deepest) - 0.75 * size;
  view.top = lowest + size;
  return view;
}

QImage contactImage(const Scene& scene, const Theme& theme, bool isClose) {
  const Frame frame = SteadyFrames(std::make_shared<const Scene>(scene), {},
                                   isClose ? 0.1 * scene.surface.length : 0)
                          .frameAt(0, 0, 0);
  ContactPictureOptions options;
  options.theme = theme;
  options.title = options.names = false;
  options.lineWidth = 2.5F;
  options.view = isClose ? closeUp(frame) : fittedView(frame);
  sizeAround(options, kScenePicture, [&] { return contactPlotArea(frame, options); });
  const Box plot = contactPlotArea(frame, options);
  return cropped(composeContact(frame, options), {plot.x, plot.y, plot.width, plot.height});
}

/// Draws the first diagram of a sheet, with thick curves.
QImage diagramImage(DiagramSheet sheet, const Theme& theme) {
  sheet.title = {};
  sheet.note = {};
  sheet.diagrams.resize(1);
  DiagramOptions options;
  options.scale = 3;
  options.theme = theme;
  options.format.lineWidth = 9;
  options.format.legend = LegendMode::None;
  options.format.ticks = TickSide::None;
  const QSize finer = 2 * kScenePicture;
  const auto frame = [&] {
    const std::vector<ChartGeometry> frames = diagramFrames(sheet, options);
    return frames.empty() ? QRectF(QPointF(), QSizeF(finer)) : frames.front().area;
  };
  sizeAround(options, finer, [&] { return toBox(frame()); });
  return cropped(composeDiagrams(sheet, options), frame());
}

QImage curveImage(Scene scene, const Theme& theme, const std::stop_token& stop) {
  scene.ensemble.realizations = std::min(scene.ensemble.realizations, kLines);
  scene.accuracy.targetRelativeError = 0;
  const Curve curve = computeCurve(scene, {.threads = 1, .stop = stop});
  throwIfStopped(stop);
  CurveSet set;
  set.present = {{}, scene, curve.points, 0, kPresentCurve};
  if (hasComparisons(set)) addComparisons(set, readComparisonData(scene), {.stop = stop});
  return diagramImage(curveSheet(set), theme);
}

/// Draws friction in time, which is the second strip of a motion.
QImage motionImage(const Scene& scene, const Theme& theme, const std::stop_token& stop) {
  Simulation motion(std::make_shared<const Scene>(scene), 0,
                    std::numeric_limits<double>::infinity());
  for (int i = 0; i < kParts; ++i) {
    throwIfStopped(stop);
    motion.advance(1.0 / kParts, 1.0 / 25);
  }
  const Frame frame = motion.frame();
  if (!frame.transient) return contactImage(scene, theme, false);
  DiagramSheet sheet = transientSheet(scene, *frame.transient, frame.spacing, frame.length);
  if (sheet.diagrams.size() > 1) sheet.diagrams.erase(sheet.diagrams.begin());
  return diagramImage(std::move(sheet), theme);
}

}  // namespace

QImage drawScenePicture(const Scene& scene, SceneView view, const Theme& theme,
                        const std::stop_token& stop) {
  throwIfStopped(stop);
  switch (view) {
    case SceneView::Curve:
      return curveImage(scene, theme, stop);
    case SceneView::Motion:
      return motionImage(scene, theme, stop);
    case SceneView::Contact:
    case SceneView::CloseUp:
      break;
  }
  return contactImage(scene, theme, view == SceneView::CloseUp);
}

// ---- The pictures and their files

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
  work_.cancel();
}

QPixmap SceneThumbnails::picture(const QString& scene) {
  request(scene);
  return pictures_.value(scene);
}

void SceneThumbnails::requestAll() {
  for (const LibraryScene& entry : libraryScenes()) request(entry.name);
}

void SceneThumbnails::request(const QString& name) {
  if (requested_.contains(name)) return;
  requested_ += name;
  const LibraryScene* found = findLibraryScene(name);
  const SceneCard* card = findCard(name);
  if (!found || !card) return;
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
      [this, name](const QImage& image) {
        if (image.isNull()) return;
        pictures_[name] = QPixmap::fromImage(image);
        emit changed(name);
      });
}

}  // namespace asperity
