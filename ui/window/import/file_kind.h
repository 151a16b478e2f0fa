// Detects the kind of a dropped file from its content. It only reads the file; any thread.
#pragma once

#include <filesystem>
#include <string>

namespace asperity {

enum class FileKind {
  Scene,     // a scene, or what the program made from one; also what cannot be read at all
  Material,  // material.json
  Moduli,    // measured moduli, or a ready Prony series
  Friction,  // measured coefficients of friction
  Surface,   // anything else
};

FileKind kindOfFile(const std::filesystem::path& file);

}  // namespace asperity
