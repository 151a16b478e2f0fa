// The scenes that come with the program, from resources/scenes through Qt's resource system.
#pragma once

#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace asperity {

struct LibraryScene {
  QString name;  // of the file, without its ending
  Scene scene;
};

/// By chapter, from the paper to what goes beyond it, then in alphabetical order of their files. A
/// scene that does not read is left out. Read at the first call.
const std::vector<LibraryScene>& libraryScenes();

/// The file of a shipped scene, by its name with ".json"; none where no scene has this name.
std::optional<std::string> libraryFile(const std::string& name);

}  // namespace asperity
