// Reads profiles in text tables: positions and heights, or heights alone.
#include <cmath>

#include "core/base/number_text.h"
#include "core/measured/text_surface.h"
#include "core/measured/uniform_positions.h"

namespace asperity {

namespace {

/// Returns the step between points that the lines above them state.
std::optional<HeaderLength> statedSpacing(const TextTable& table, const TextBlock& block) {
  const std::vector<std::string> keys{"spacing",
                                      "x spacing",
                                      "spacing x",
                                      "dx",
                                      "delta x",
                                      "deltax",
                                      "increment",
                                      "x increment",
                                      "x-increment",
                                      "xincrement",
                                      "step",
                                      "step size",
                                      "x step",
                                      "sampling interval",
                                      "sampling step",
                                      "sample interval",
                                      "point spacing",
                                      "pixel size",
                                      "pixelsize",
                                      "punktabstand",
                                      "messpunktabstand",
                                      "schrittweite",
                                      "abtastweite",
                                      "abtastabstand",
                                      "data spacing",
                                      "pitch",
                                      "x pitch",
                                      "data pitch",
                                      "point pitch",
                                      "sampling pitch",
                                      "measuring pitch"};
  if (const auto spacing = headerLength(table, block, keys)) return spacing;
  return countedStep(table, block, static_cast<std::int64_t>(block.rows), true);
}

/// Throws InputError for heights that no surface can have: some files write such a number for a
/// missing point.
void requireHeights(const std::vector<double>& heights, const TextBlock& block,
                    const SurfaceSource& source) {
  constexpr double kNoHeight = 1e30;  // in any unit
  for (std::size_t i = 0; i < heights.size(); ++i)
    if (!std::isnan(heights[i]) && std::abs(heights[i]) > kNoHeight)
      source.fail(message("line {}: {} is no height; a missing point is left empty or is NaN",
                          block.lines[i], plain(heights[i])));
}

}  // namespace

SurfaceDraft readTextProfile(const TextTable& table, const TextBlock& block,
                             const SurfaceSource& source) {
  ColumnRoles roles = columnRoles(block, source);
  if (roles.z < 0) source.fail("has no column of heights");
  SurfaceDraft draft;
  const auto spacing = statedSpacing(table, block);
  const bool isGiven = source.choices.spacing > 0 && source.choices.positionUnit == "auto";
  if ((spacing || isGiven) && mayNumberPoints(block, roles, source)) {
    draft.facts.notes.push_back(message(
        "The points are as far apart as is stated: {} numbers them.", columnText(block, roles.x)));
    roles.x = -1;
  }
  draft.facts.format = "profile";
  draft.facts.heightColumn = columnText(block, roles.z).english();
  std::vector<double> heights = block.column(static_cast<std::size_t>(roles.z));
  requireHeights(heights, block, source);
  if (roles.validity >= 0) {
    for (std::size_t i = 0; i < block.rows; ++i) {
      const double valid = block.at(i, static_cast<std::size_t>(roles.validity));
      if (std::isnan(valid) || (valid == 1) != roles.validIsOne) heights[i] = std::nan("");
    }
    draft.facts.notes.push_back(message("{} says which points are valid; the others are gaps.",
                                        columnText(block, roles.validity)));
  }
  draft.heightUnit = columnUnit(source, table, block, roles.z, true);
  if (!draft.heightUnit) draft.unknownHeightUnit = unknownUnit(table, block, roles.z, true);
  if (roles.candidates > 1 && source.choices.heightColumn == 0)
    draft.facts.notes.push_back(message(
        "Heights are {}, the first of {} columns that could be; surface.height_column chooses "
        "another.",
        columnText(block, roles.z), roles.candidates));

  Topography& grid = draft.grid;
  grid.rows = 1;
  if (roles.x >= 0) {
    draft.facts.positionColumn = columnText(block, roles.x).english();
    draft.facts.notes.insert(draft.facts.notes.begin(),
                             message("Positions are {}, heights {}.", columnText(block, roles.x),
                                     columnText(block, roles.z)));
    draft.positionUnit = columnUnit(source, table, block, roles.x, false);
    if (!draft.positionUnit) draft.unknownPositionUnit = unknownUnit(table, block, roles.x, false);
    resampleUniformly(block.column(static_cast<std::size_t>(roles.x)), std::move(heights),
                      block.lines, source, draft);
  } else {
    grid.height = std::move(heights);
    grid.columns = static_cast<std::int64_t>(grid.height.size());
    draft.hasPositions = spacing.has_value();
    grid.columnSpacing = spacing ? spacing->value : 1;
    // The entry "Unit" may be the unit of the heights, which tells nothing about a step.
    draft.positionUnit =
        spacing && spacing->unit
            ? spacing->unit
            : headerUnit(table, block, false, spacing ? UnitEntries::AndCommon : UnitEntries::Own);
  }
  return draft;
}

}  // namespace asperity
