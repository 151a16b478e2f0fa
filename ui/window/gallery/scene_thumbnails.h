// The small pictures of scenes in the gallery: contact, curve or motion without texts and margins,
// drawn in the same way as all other pictures. They are drawn in the background, one at a time, and
// kept as PNG files in the user's cache, named by the content of the scene, the theme and the
// program. Owned by the gallery; GUI thread. Failure: a scene without a picture; a cache that
// cannot be read or written is passed over.
#pragma once

#include <QHash>
#include <QImage>
#include <QObject>
#include <QPixmap>
#include <QSet>
#include <functional>
#include <stop_token>

#include "core/scene/scene.h"
#include "ui/draw/theme.h"
#include "ui/window/gallery/scene_cards.h"
#include "ui/window/tasks/background_work.h"

namespace asperity {

/// Pixels of every picture of a scene; no card shows it larger.
inline constexpr QSize kScenePicture{520, 312};

/// Draws the picture. A friction curve is the mean of a few lines only, a motion is that of the
/// scene. Any thread on which no OpenGL context of Qt is current. Throws StopRequested where it is
/// stopped, another std::exception where the scene cannot run or no backend can draw.
QImage drawScenePicture(const Scene& scene, SceneView view, const Theme& theme,
                        const std::stop_token& stop = {});

class SceneThumbnails : public QObject {
  Q_OBJECT

 public:
  using Drawing =
      std::function<QImage(const Scene&, SceneView, const Theme&, const std::stop_token&)>;

  /// draw: makes a picture (drawScenePicture). folder: of the cache; empty: that of the user.
  explicit SceneThumbnails(Drawing draw, const QString& folder = {}, QObject* parent = nullptr);

  /// Begins with the pictures of this theme; those of another theme stay until they are replaced.
  void setTheme(const Theme& theme);

  /// Returns the picture of a shipped scene; null before changed() was emitted for it. The first
  /// call requests it.
  QPixmap picture(const QString& scene);

  /// Requests all further pictures after the present ones.
  void requestAll();

  /// Returns whether pictures are still to come.
  bool isWorking() const { return work_.isBusy(); }

 signals:
  void changed(const QString& scene);

 private:
  void request(const QString& name);

  const Drawing draw_;
  const QString folder_;
  Theme theme_ = lightTheme();
  QHash<QString, QPixmap> pictures_;
  QSet<QString> requested_;  // in this theme
  // Last: its thread ends before other members are destroyed.
  BackgroundWork work_{RequestPolicy::RunUntilEnd};
};

/// Returns the name of a picture's file in the cache: a digest of all that shapes it.
QString thumbnailName(const Scene& scene, SceneView view, const Theme& theme);

/// Returns the folder of pictures in the user's cache.
QString thumbnailFolder();

}  // namespace asperity
