// Resamples measured positions to a uniform grid. Pure; any thread.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/measured/surface_draft.h"

namespace asperity {

/// Stores the heights of a profile at uniform positions, and their spacing, in the draft. Positions
/// that are uniform except for the rounding of their digits are kept; a descending order is
/// reversed; heights at equal positions are replaced by their mean; missing positions of a uniform
/// grid become gaps; for any other positions the heights are interpolated linearly at as many
/// uniform positions, with a note. `lines`: the numbers of the lines in the file, for errors; may
/// be empty. Throws InputError where positions go back or are missing.
void resampleUniformly(std::vector<double> positions, std::vector<double> heights,
                       std::span<const std::uint32_t> lines, const SurfaceSource& source,
                       SurfaceDraft& draft);

/// Returns the spacing, of either sign, of positions that are uniform except for rounding; nothing
/// where they are not. NaN is skipped.
std::optional<double> uniformSpacing(std::span<const double> positions);

/// An axis of a grid: its first position, its spacing and the number of its positions.
struct GridAxis {
  double first = 0, spacing = 0;
  std::int64_t count = 1;
  double deviation = 0;  // the largest of a position, in steps, where it is more than rounding
};
/// Returns the axis on which all the numbers lie, except for rounding; nothing where there is no
/// such axis with at most `most` positions.
std::optional<GridAxis> findGridAxis(std::vector<double> numbers, std::int64_t most);

/// Returns the axis from which no number is further away than a fiftieth of a step, as where a
/// stage states its positions; nothing where there is no such axis with at most `most` positions.
std::optional<GridAxis> findNearGridAxis(std::vector<double> numbers, std::int64_t most);

/// Says that so many rows repeat a position, and that their heights are averaged.
Message repeatsNote(std::size_t rows);

}  // namespace asperity
