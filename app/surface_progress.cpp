#include "app/surface_progress.h"

#include <cmath>

#include "app/progress_bar.h"
#include "core/base/input_error.h"
#include "core/surface/measured_lines.h"
#include "ui/language/translated.h"
#include "ui/language/words.h"

namespace asperity {

void findLinesWithProgress(const Scene& scene, bool quiet) {
  if (scene.surface.kind != SurfaceKind::Measured) return;
  constexpr std::int64_t kParts = 1000;
  ProgressBar bar(Words::tr("parts of the surface"), quiet);
  try {
    MeasuredLines::of(scene, {},
                      [&bar](double part) { bar.show(std::lround(kParts * part), kParts); });
  } catch (const InputError&) {
  }
}

std::vector<std::string> surfaceAssumptions(const Scene& scene) {
  std::vector<std::string> sentences;
  if (scene.surface.kind != SurfaceKind::Measured) return sentences;
  for (const Message& assumption : readMeasuredSurface(scene)->facts.assumptions)
    sentences.push_back(translated(assumption));
  return sentences;
}

}  // namespace asperity
