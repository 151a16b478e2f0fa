// Profiles in text tables: positions and heights, or heights alone.
#include <cmath>

#include "core/measured/length_unit.h"
#include "core/measured/text_surface.h"
#include "core/measured/uniform_positions.h"

namespace asperity {
namespace {

std::optional<StatedUnit> unitOfColumn(const SurfaceSource& source, const TextTable& table,
                                       const TextBlock& block, int column, bool ofHeights) {
  const std::string& unit = block.columns[static_cast<std::size_t>(column)].unit;
  const bool isChosen =
      (ofHeights ? source.choices.heightUnit : source.choices.positionUnit) != "auto";
  if (unit.empty()) return headerUnit(table, block, ofHeights);
  if (const auto metres = metresPer(unit)) return StatedUnit{unit, *metres};
  if (isChosen) return {};
  throw InputError(source.name, ofHeights ? "surface.height_unit" : "surface.position_unit",
                   message("{} is in '{}', which is no unit of length; the key can say another one",
                           columnText(block, column), unit));
}

}  // namespace

SurfaceDraft readTextProfile(const TextTable& table, const TextBlock& block,
                             const SurfaceSource& source) {
  const ColumnRoles roles = columnRoles(block, source);
  if (roles.z < 0) source.fail("has no column of heights");
  SurfaceDraft draft;
  draft.facts.format = "profile";
  draft.facts.heightColumn = columnText(block, roles.z).english();
  std::vector<double> heights = block.column(static_cast<std::size_t>(roles.z));
  if (roles.validity >= 0) {
    for (std::size_t i = 0; i < block.rows; ++i) {
      const double valid = block.at(i, static_cast<std::size_t>(roles.validity));
      if (std::isnan(valid) || (valid == 1) != roles.validIsOne) heights[i] = std::nan("");
    }
    draft.facts.notes.push_back(message("{} says which points are valid; the others are gaps.",
                                        columnText(block, roles.validity)));
  }
  draft.heightUnit = unitOfColumn(source, table, block, roles.z, true);
  if (roles.heights.size() > 1 && source.choices.heightColumn == 0)
    draft.facts.notes.push_back(message(
        "Heights are {}, the first of {} columns that could be; surface.height_column chooses "
        "another.",
        columnText(block, roles.z), roles.heights.size()));

  Topography& grid = draft.grid;
  grid.rows = 1;
  if (roles.x >= 0) {
    draft.facts.positionColumn = columnText(block, roles.x).english();
    draft.positionUnit = unitOfColumn(source, table, block, roles.x, false);
    PlacedProfile placed = placeUniformly(block.column(static_cast<std::size_t>(roles.x)),
                                          std::move(heights), block.lines, source);
    grid.height = std::move(placed.height);
    grid.columnSpacing = placed.spacing;
    draft.facts.spacingVariation = placed.variation;
    draft.facts.resampled = placed.resampled;
    draft.facts.notes.insert(draft.facts.notes.end(), placed.notes.begin(), placed.notes.end());
  } else {
    grid.height = std::move(heights);
    const auto spacing = headerLength(table, block,
                                      {"spacing",
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
                                       "data spacing"});
    draft.hasPositions = spacing.has_value();
    grid.columnSpacing = spacing ? spacing->value : 1;
    draft.positionUnit = spacing && spacing->unit ? spacing->unit : headerUnit(table, block, false);
  }
  grid.columns = static_cast<std::int64_t>(grid.height.size());
  return draft;
}

}  // namespace asperity
