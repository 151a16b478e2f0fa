// The line of a scene as text: the points as CSV that the profile reader takes back, statistics
// and spectrum as JSON. Pure functions; equal scenes give equal bytes.
#pragma once

#include <string>

#include "core/scene/scene.h"
#include "core/surface/line.h"
#include "core/surface/line_source.h"

namespace asperity {

/// "position,height" in metres.
std::string lineCsv(const Line& line);

/// Statistics (ISO names in the keys' documentation: Rq is rms_height, Rdq is rms_slope) and the
/// power spectral density C(q) (m^3) over q (1/m) for lines that have modes.
std::string surfaceJson(const Scene& scene, const LineSource& source, const Line& line);

}  // namespace asperity
