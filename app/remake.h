// Makes a file again from its metadata: its scene, the command that made it and the options that
// shaped it become a command line. A file of a folder of outputs is made with the whole folder, in
// a temporary folder. Main thread.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/scene/provenance.h"

namespace asperity {

struct OpenCommand;

struct Remake {
  std::vector<std::string> words;     // of the command line, without the program's name
  std::optional<FoundScene> found{};  // what the command has instead of a scene file
  std::string output;                 // the new file; "-": standard output
  /// The name of the file in the folder, for a command that writes a folder; the command line lacks
  /// the folder. Empty: the command writes one file.
  std::string part{};
  bool hasSeveralScenes = false;  // the file shows many scenes, of which some may fail
  bool hasTimes = false;          // the file holds run times, which are never the same
};

/// Returns the command line that makes the file again, with the options of the user instead of its
/// own. Throws InputError where the file has no metadata, where one of its inputs is missing or has
/// changed, and where the new file is impossible.
Remake prepareRemake(const OpenCommand& command);

/// A temporary folder, which is removed in the end.
class RemakeFolder {
 public:
  /// Throws std::runtime_error.
  RemakeFolder();
  ~RemakeFolder();
  RemakeFolder(const RemakeFolder&) = delete;
  RemakeFolder& operator=(const RemakeFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// Moves the requested file to its destination. Throws InputError where the command made none.
  void take(const Remake& remake) const;

 private:
  std::filesystem::path path_;
};

}  // namespace asperity
