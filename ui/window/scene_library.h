// The scenes that come with the program, from resources/scenes through Qt's resource system.
#pragma once

#include <QString>
#include <vector>

#include "core/scene/scene.h"

namespace asperity {

struct LibraryScene {
  QString name;  // of the file, without its ending
  Scene scene;
};

/// By chapter, from the paper to what goes beyond it, then in alphabetical order of their files. A
/// scene that does not read is left out.
std::vector<LibraryScene> libraryScenes();

}  // namespace asperity
