#include "ui/window/command_text.h"

#include <QFileInfo>
#include <QRegularExpression>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/scene/assignments.h"
#include "ui/language/language.h"
#include "ui/panels/number_text.h"
#include "ui/window/scene_library.h"

namespace asperity {

namespace {

/// A profile is found wherever the command is given.
Scene withAbsoluteProfile(Scene scene) {
  if (scene.surface.kind == SurfaceKind::Profile)
    scene.surface.file =
        std::filesystem::absolute(scene.folder / scene.surface.file).lexically_normal().string();
  return scene;
}

std::vector<std::string> assignmentsOver(const SceneOrigin& origin, const Scene& scene) {
  const bool sameFolder = !origin.file.isEmpty() && origin.scene.folder == scene.folder;
  return assignmentsFrom(origin.scene, sameFolder ? scene : withAbsoluteProfile(scene));
}

/// Of the shipped scenes the one that needs the fewest words.
SceneOrigin nearestShipped(const Scene& scene) {
  SceneOrigin nearest;
  std::optional<std::size_t> fewest;
  for (const LibraryScene& entry : libraryScenes()) {
    const SceneOrigin origin{entry.name, {}, entry.scene};
    const std::size_t count = assignmentsOver(origin, scene).size();
    if (fewest && *fewest <= count) continue;
    fewest = count;
    nearest = origin;
  }
  return nearest;
}

QStringList sceneWords(const SceneOrigin& known, const Scene& scene) {
  const SceneOrigin origin = known.isKnown() ? known : nearestShipped(scene);
  QStringList words{origin.file.isEmpty() ? origin.shipped + ".json"
                                          : QFileInfo(origin.file).absoluteFilePath()};
  for (const std::string& assignment : assignmentsOver(origin, scene))
    words += {QStringLiteral("--set"), QString::fromStdString(assignment)};
  return words;
}

QString command(const QStringList& words) {
  QStringList quoted;
  for (const QString& word : words) quoted += shellQuoted(word);
  return quoted.join(' ');
}

}  // namespace

QString renderCommand(const SceneOrigin& origin, const Scene& scene, const PictureWish& wish) {
  QStringList words{"asperity", "render"};
  words += sceneWords(origin, scene);
  words += {"-o", "picture.png"};
  if (wish.layout != "contact") words += {"--layout", wish.layout};
  if (!wish.size.isEmpty())
    words += {"--size", QStringLiteral("%1x%2").arg(wish.size.width()).arg(wish.size.height())};
  if (wish.scale != 1) words += {"--scale", numberText(wish.scale)};
  if (wish.dark) words += {"--theme", "dark"};
  if (wish.overlay != "pressure") words += {"--overlay", wish.overlay};
  if (presentLanguage() != "en") words += {"--language", fromUtf8(presentLanguage())};
  return command(words);
}

QString curveCommand(const SceneOrigin& origin, const Scene& scene) {
  return command(QStringList{"asperity", "curve"} + sceneWords(origin, scene) +
                 QStringList{"-o", "curve.csv"});
}

QString shellQuoted(const QString& word) {
  static const QRegularExpression plain(QStringLiteral("^[A-Za-z0-9_@%+=:,./-]+$"));
  if (plain.match(word).hasMatch()) return word;
  QString inside = word;
  return '\'' + inside.replace('\'', QStringLiteral("'\\''")) + '\'';
}

}  // namespace asperity
