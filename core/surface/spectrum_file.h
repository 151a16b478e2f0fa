// Reads measured spectra from text tables (core/base/text_table) whose header names the columns:
// wave number, spatial frequency or wavelength, and the spectrum. Units in the header ("q [1/um]",
// "C1 (m^3)") or in a row of their own are applied; without them all values are in SI units.
//
// Meaning of the numbers: per wave number q where the table has that column, so that <h^2> is 2
// integral C1 dq, integral C1 dq or 2 pi integral C2 q dq, depending on the kind; per spatial
// frequency f where the table has spatial frequencies or wavelengths 1/f, so that the same holds
// with f instead of q. Pure; any thread. Failure: InputError with file, column or line, and what is
// allowed.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"
#include "core/measured/roughness_spectrum.h"
#include "core/scene/scene.h"

namespace asperity {

/// Return the spectrum of the line, C1 two-sided per wave number; of a `c2` that of the equivalent
/// line, C_line = pi q C2. It is given in bins where findBinEdges finds some, else in power laws
/// between its points.
SpectralDensity parseSpectrum(std::string_view text, const std::string& name, SpectrumKind kind);

/// The same spectrum, and how its columns, units and numbers were understood, one sentence each.
struct SpectrumTable {
  SpectralDensity density{};
  std::vector<Message> facts{};
};
SpectrumTable parseSpectrumTable(std::string_view text, const std::string& name, SpectrumKind kind);
SpectrumTable readSpectrumTable(const std::filesystem::path& file, SpectrumKind kind);

}  // namespace asperity
