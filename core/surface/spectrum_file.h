// Measured spectra as text tables (core/base/text_table) whose header names the columns: wave
// number, spatial frequency or wavelength, and the spectrum. Units in the header ("q [1/um]", "C1
// (m^3)") or in a row of their own are obeyed, without them all is SI.
//
// What the numbers are: per wave number q where the table has that column, so that <h^2> = 2
// integral C1 dq, integral C1 dq or 2 pi integral C2 q dq by the kind; per spatial frequency f
// where it has spatial frequencies or wavelengths 1/f, so that the same holds with f for q. Pure;
// any thread. Failure: InputError with file, column or line, and what is allowed.
#pragma once

#include <filesystem>
#include <string_view>

#include "core/measured/roughness_spectrum.h"
#include "core/scene/scene.h"

namespace asperity {

/// The spectrum of the line, C1 two-sided per wave number; of a `c2` that of the equivalent line,
/// C_line = pi q C2. In bins where findBinEdges finds some, else in power laws between its points.
SpectralDensity parseSpectrum(std::string_view text, const std::string& name, SpectrumKind kind);

SpectralDensity readSpectrum(const std::filesystem::path& file, SpectrumKind kind);

}  // namespace asperity
