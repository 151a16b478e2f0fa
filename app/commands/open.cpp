// asperity open: opens the window with the scene that made a picture, a film or a table.
#include <fmt/format.h>

#include "app/command_line.h"
#include "core/scene/provenance.h"
#include "core/scene/scene_file.h"

namespace asperity {

int runOpen(const OpenCommand& command) {
  const CommonOptions& common = command.common;
  FoundScene found = findScene(common.scene);
  found.scene =
      readScene(writeScene(found.scene), common.scene, found.scene.folder, common.assignments);
  if (common.json) {
    fmt::print("{}", writeScene(found.scene));
    return kDone;
  }
  // The window asks before it shows a scene that needs much time or memory. Until the answer it
  // shows the first scene of the library.
  if (found.isEmbedded && sceneDemands(found.scene).any()) return showWindow({}, common, &found);
  return showWindow(found.scene, common);
}

}  // namespace asperity
