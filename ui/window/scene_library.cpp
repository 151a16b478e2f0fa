#include "ui/window/scene_library.h"

#include <QDir>
#include <QFile>

#include "core/scene/input_error.h"
#include "core/scene/scene_file.h"

// Outside of the namespace, as the resource compiler's function is.
static void openResources() {
  Q_INIT_RESOURCE(asperity_scenes);
}

namespace asperity {

std::vector<LibraryScene> libraryScenes() {
  openResources();
  std::vector<LibraryScene> scenes;
  const QDir folder(QStringLiteral(":/asperity/scenes"));
  for (const QFileInfo& entry : folder.entryInfoList({"*.json"}, QDir::Files, QDir::Name)) {
    QFile file(entry.filePath());
    if (!file.open(QIODevice::ReadOnly)) continue;
    try {
      scenes.push_back({entry.completeBaseName(),
                        readScene(file.readAll().toStdString(), entry.fileName().toStdString())});
    } catch (const InputError& error) {
      qWarning("%s", error.what());
    }
  }
  return scenes;
}

}  // namespace asperity
