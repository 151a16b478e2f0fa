#include "core/scene/scene_check.h"

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/material/element_law.h"
#include "core/scene/parameters.h"

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
  const std::int64_t row = scene.surface.reading.row, lines = scene.ensemble.realizations;
  if (scene.surface.kind == SurfaceKind::Measured && !hasRandomPhases(scene.surface) && row > 0 &&
      lines > 1)
    throw InputError(
        "", "ensemble.realizations",
        message("{} lines are too many: surface.row chooses row {}, which is one line; "
                "allowed is 0 or 1",
                lines, row));
  checkEffects(scene);
}

void checkEffects(const Scene& scene) {
  const ElementLaw law = elementLaw(scene.elastomer);
  if (law.kind() == ElementKind::Arms && scene.accuracy.scheme == Scheme::Nodal)
    throw InputError("", "accuracy.scheme",
                     "nodal is the paper's rule for Kelvin elements: where its force jumps arms "
                     "cannot close over a period; they need linear or cubic");
  if (scene.interface.frictionCoefficient > 0 && scene.interface.shearStress > 0)
    throw InputError(
        "", "interface.shear_stress",
        "cannot be combined with interface.friction_coefficient; only one of them may be above 0");
}

void requireSteadySliding(const Scene& scene, const Message& what) {
  if (scene.sliding.kind != SlidingKind::Steady) {
    const ParameterValue kind = parameterValue(*findParameter("sliding.kind"), scene);
    throw InputError("", "sliding.kind",
                     message("{} needs steady sliding, not {}", what, std::get<std::string>(kind)));
  }
  requireEquilibrium(scene);
}

void requireEquilibrium(const Scene& scene) {
  if (elementLaw(scene.elastomer).equilibriumModulus == 0)
    throw InputError("", "elastomer.equilibrium_modulus",
                     "is 0: without an equilibrium modulus an elastomer cannot carry a constant "
                     "load; it must be above 0");
}

void requireMotion(const Scene& scene, const Message& what) {
  if (scene.sliding.kind == SlidingKind::Steady)
    throw InputError("", "sliding.kind",
                     message("is steady, so nothing changes in time; {} needs start, step, "
                             "oscillation or reversal",
                             what));
}

void requireNoTarget(const Scene& scene, const Message& why) {
  if (choosesAccuracy(scene))
    throw InputError(
        "", "accuracy.target_relative_error",
        message("{}; give accuracy.scheme and ensemble.realizations instead of a target", why));
}

}  // namespace asperity
