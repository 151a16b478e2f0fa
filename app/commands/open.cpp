// asperity open: the window, with the scene that made a picture, a film or a table.
#include <fmt/format.h>

#include "app/command_line.h"
#include "core/scene/provenance.h"
#include "core/scene/scene_file.h"

namespace asperity {

int runOpen(const OpenCommand& command) {
  const CommonOptions& common = command.common;
  const Scene found = readProvenance(common.scene);
  const Scene scene = readScene(writeScene(found), common.scene, found.folder, common.assignments);
  if (!common.json) return showWindow(scene, common);
  fmt::print("{}", writeScene(scene));
  return kDone;
}

}  // namespace asperity
