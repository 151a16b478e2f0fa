#include "app/common_options.h"

#include <cstdio>

#include "app/progress_bar.h"
#include "core/scene/scene_file.h"
#include "core/surface/measured_lines.h"
#include "core/surface/measured_summary.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/window/main/scene_library.h"

namespace asperity {
namespace {

/// Returns what standard input holds. Throws InputError where it is more than a scene may be.
std::string standardInput() {
  std::string text;
  char part[4096];
  while (const std::size_t count = std::fread(part, 1, sizeof part, stdin)) {
    text.append(part, count);
    if (text.size() > kLargestScene)
      throw InputError("standard input", "", "is larger than a scene may be");
  }
  return text;
}

}  // namespace

Scene loadScene(const CommonOptions& options) {
  if (options.remade)
    return readScene(writeScene(options.remade->scene), options.scene, options.remade->scene.folder,
                     options.assignments);
  if (options.scene.empty()) return readScene("{}", "--set", {}, options.assignments);
  if (options.scene == "-")
    return readScene(standardInput(), "standard input", {}, options.assignments);
  return readNamedScene(options.scene, {}, options.assignments);
}

std::vector<std::filesystem::path> inputFiles(const CommonOptions& options, const Scene& scene) {
  std::vector<std::filesystem::path> inputs;
  if (!options.remade) inputs.emplace_back(options.scene);  // a remade file may replace itself
  for (const GivenOption& option : options.given)
    if (option.isFile) inputs.insert(inputs.end(), option.values.begin(), option.values.end());
  const std::vector<std::filesystem::path> named = filesReadBy(scene);
  inputs.insert(inputs.end(), named.begin(), named.end());
  return inputs;
}

void findLinesWithProgress(const Scene& scene, bool quiet) {
  if (scene.surface.kind != SurfaceKind::Measured) return;
  ProgressBar bar(Words::tr("parts of the surface"), quiet);
  try {
    MeasuredLines::of(scene, {}, [&bar](double part) { bar.showPart(part); });
  } catch (const InputError&) {
  }
}

std::vector<std::string> surfaceAssumptions(const Scene& scene) {
  std::vector<std::string> sentences;
  if (scene.surface.kind != SurfaceKind::Measured) return sentences;
  const auto lines = MeasuredLines::of(scene);
  for (const auto& facts : {lines->file().facts.assumptions, factsOf(lines->missingHeights())})
    for (const Message& fact : facts) sentences.push_back(translated(fact));
  return sentences;
}

std::string noteLines(const NoteSet& notes) {
  std::string text;
  for (const Note note : notes.list())
    text += std::string(noteWord(note)) + ": " + translated(noteSentence(note)) + "\n";
  return text;
}

}  // namespace asperity
