// From measured positions to a uniform grid. Pure; any thread.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/measured/surface_draft.h"

namespace asperity {

/// Puts the heights of a profile at uniform places into the draft, and their spacing. Positions
/// that are uniform but for the rounding of their digits stay as they are; falling ones are turned
/// round; of heights at one position the mean is taken; missing places of a uniform grid become
/// gaps; other positions are interpolated linearly onto as many uniform places, with a note.
/// `lines` are those of the file, for errors; may be empty. Throws InputError where positions go
/// back or are missing.
void resampleUniformly(std::vector<double> positions, std::vector<double> heights,
                       std::span<const std::uint32_t> lines, const SurfaceSource& source,
                       SurfaceDraft& draft);

/// The spacing, of either sign, of positions that are uniform but for rounding; none where they are
/// not. NaN is passed over.
std::optional<double> uniformSpacing(std::span<const double> positions);

/// The sorted places of a grid axis on which all the numbers lie, but for rounding: the first place
/// and the spacing. None where there is no such axis with at most `most` places.
struct GridAxis {
  double first = 0, spacing = 0;
  std::int64_t places = 1;
};
std::optional<GridAxis> findGridAxis(std::vector<double> numbers, std::int64_t most);

}  // namespace asperity
