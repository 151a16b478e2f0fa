// Friction against the short-wave cut-off: the same lines without their waves below a length
// lambda_c, in quarters of a decade, up to the whole line. How friction rises from step to step
// says which waves make it. All states slide on common random lines, so that the scatter of the
// lines cancels in the differences. Waves are removed sharply from random lines and spectra, and
// from profiles; from a measured surface by the Gaussian filter of ISO 16610-21, as its key
// `surface.short_wave_cut` does.
// Threading, failure: as slideStates; InputError for a line without short waves to remove.
#pragma once

#include <vector>

#include "core/friction/jackknife.h"
#include "core/friction/steady_states.h"

namespace asperity {

struct CutoffPoint {
  double wavelength = 0;  // m, lambda_c: waves shorter than it are removed
  CurvePoint state;
  /// d mu / d log10(1/lambda_c) over the friction of the whole line: the part of all friction that
  /// one decade of wavelengths makes. It is the difference from the previous step and belongs to
  /// the middle between the two.
  Estimate shareOfDecade;
};

/// Returns the points from long to short wavelengths; the last one is the scene itself. A cancelled
/// computation throws StopRequested.
std::vector<CutoffPoint> frictionOverCutoff(const Scene& scene, const StateOptions& options = {});

}  // namespace asperity
