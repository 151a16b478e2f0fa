// The options that every command takes, and the scene that they name: how it is read, which files
// it is read from, and what the summaries of several commands tell of it. Main thread.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/command_options.h"
#include "core/base/input_error.h"
#include "core/scene/notes.h"
#include "core/scene/provenance.h"
#include "core/scene/scene.h"

namespace asperity {

struct CommonOptions {
  std::string scene;
  std::vector<std::string> assignments;  // --set KEY=VALUE
  std::string language;                  // language of texts; empty: English, or the window's own
  int threads = 0;                       // 0: as many as the machine has
  bool quiet = false;
  bool json = false;
  bool timing = false;
  std::vector<GivenOption> given;  // that shape outputs
  // instead of the file `scene`, which names it in errors
  std::optional<FoundScene> remade = {};
  bool isPart = false;  // the output folder is temporary: one of its files is kept

  bool hidesSummary() const { return quiet || isPart; }
};

/// Returns the scene of a command with its assignments. The scene comes from a file or, where no
/// file has the name, from the shipped scenes. Throws InputError.
Scene loadScene(const CommonOptions& options);

/// Returns the files that were read for the scene; no output may replace them.
std::vector<std::filesystem::path> inputFiles(const CommonOptions& options, const Scene& scene);

/// Runs the work of a command. Where an InputError names neither a file nor an option, it gets the
/// name of the scene's file.
template <class Work>
auto withSceneContext(const CommonOptions& options, const Work& work) {
  try {
    return work();
  } catch (const InputError& error) {
    throw error.file().empty() && !error.isOfOption() ? error.in(options.scene) : error;
  }
}

/// Reads the scene's measured surface, if it has one, and finds its lines with a progress bar. Both
/// are then cached for the code that makes lines of the scene (core/surface/measured_lines.h). That
/// code also reports errors, because it knows their context.
void findLinesWithProgress(const Scene& scene, bool quiet);

/// Returns the assumptions about the scene's measured surface, if it has one, that its file does
/// not state: "they are taken as metres", and what is left out or interpolated. Sentences in the
/// present language.
std::vector<std::string> surfaceAssumptions(const Scene& scene);

/// Returns a line for each note: its word and its sentence in the present language.
std::string noteLines(const NoteSet& notes);

}  // namespace asperity
