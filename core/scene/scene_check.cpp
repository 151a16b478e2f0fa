#include "core/scene/scene_check.h"

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/scene/effects.h"

namespace asperity {

void checkScene(const Scene& scene) {
  if (scene.surface.kind == SurfaceKind::Profile && scene.surface.file.empty())
    throw InputError("", "surface.file", "is missing; a profile needs a file");
  if (scene.surface.kind == SurfaceKind::Measured && scene.surface.file.empty())
    throw InputError("", "surface.file", "is missing; a measured surface needs a file");
  if (scene.surface.kind == SurfaceKind::Spectrum && scene.surface.file.empty())
    throw InputError("", "surface.file", "is missing; a spectrum needs a file");
  if (scene.surface.kind == SurfaceKind::Spectrum &&
      scene.surface.spectrumKind == SpectrumKind::Unstated)
    throw InputError("", "surface.spectrum_kind",
                     "is missing; allowed is one of c1_two_sided, c1_one_sided, c2");
  const ProcessingChoices& processing = scene.surface.processing;
  if (processing.longWaveCut > 0 && processing.longWaveCut <= processing.shortWaveCut)
    throw InputError("", "surface.long_wave_cut",
                     message("{} is not above surface.short_wave_cut, {}",
                             plain(processing.longWaveCut), plain(processing.shortWaveCut)));
  checkEffects(scene);
}

}  // namespace asperity
