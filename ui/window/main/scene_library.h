// The scenes that are shipped with the program, from resources/scenes through Qt's resource system.
// They do not change after the first call. Any thread.
#pragma once

#include <QString>
#include <filesystem>
#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace asperity {

struct LibraryScene {
  QString name;  // file name without its extension
  Scene scene;
};

/// Returns the scenes by chapter, from the paper to later extensions, then in the order of their
/// files. A scene that cannot be read is left out. They are read at the first call.
const std::vector<LibraryScene>& libraryScenes();

/// Returns the shipped scene of this name; null where there is none.
const LibraryScene* findLibraryScene(const QString& name);

/// Reads the scene file of this name in the folder (empty: the current one) or, where there is
/// none, the shipped scene of this name, with or without ".json". Throws InputError where it cannot
/// be read.
Scene readNamedScene(const std::string& name, const std::filesystem::path& folder,
                     const std::vector<std::string>& assignments);

}  // namespace asperity
