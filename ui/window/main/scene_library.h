// The scenes that come with the program, from resources/scenes through Qt's resource system.
#pragma once

#include <QString>
#include <filesystem>
#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace asperity {

struct LibraryScene {
  QString name;  // of the file, without its ending
  Scene scene;
};

/// The scenes by chapter, from the paper to what goes beyond it, then in the order of their files.
/// A scene that does not read is left out. Read at the first call.
const std::vector<LibraryScene>& libraryScenes();

/// The scene file of this name in the folder (empty: the present one) or, where there is none, the
/// shipped scene of this name with ".json". Throws InputError where it does not read.
Scene readNamedScene(const std::string& name, const std::filesystem::path& folder,
                     const std::vector<std::string>& assignments);

}  // namespace asperity
