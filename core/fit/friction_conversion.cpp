#include "core/fit/friction_roles.h"

#include <algorithm>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/text.h"
#include "core/material/dma_columns.h"

namespace asperity {
namespace {

/// Finds the conversion of an error of mu. In per cent it is a share of mu, unless mu itself is
/// in per cent: then a name that does not say "relative" means percentage points of mu.
FrictionConversion errorConversion(const TextColumn& column, const TextBlock& block) {
  const Unit percent = *findUnit("%");
  const auto mu = std::ranges::find_if(block.columns, [](const TextColumn& other) {
    return findMeaning(other) == FrictionQuantity::Mu;
  });
  const bool isMuInPercent = mu != block.columns.end() && mu->unit == "%";
  const bool isShare = isRelativeError(column.name) || isShareUnit(column.unit) ||
                       (column.unit == "%" && !isMuInPercent);
  const bool isInPercent = column.unit.starts_with('%');
  if (isShare && !isInPercent) return {.isShare = true, .unitText = "share of the value"};
  if (isShare) return {.unit = percent, .isShare = true, .unitText = "% of the value"};
  if (isInPercent || (column.unit.empty() && isMuInPercent))
    return {.unit = percent, .unitText = "percentage points"};
  return {};
}

FrictionConversion unscaledConversion(FrictionQuantity quantity, const TextColumn& column,
                                      const TextBlock& block, const std::string& name) {
  const auto unitOf = [&](std::string_view si, const std::string& known) {
    if (column.unit.empty()) return FrictionConversion{Unit{si}};
    const auto unit = quantity == FrictionQuantity::Temperature ? temperatureUnit(column.unit)
                                                                : unitInAnyCase(column.unit, si);
    // Nothing slides at megametres per second; mm/s is meant, or something else.
    if (!unit || column.unit.starts_with("Mm"))
      throw InputError(name, "",
                       message("column {}: the unit {} is unknown; known are {}",
                               shortened(column.name), shortened(column.unit), known));
    return FrictionConversion{*unit};
  };
  const FrictionConversion share{
      .unit = *findUnit("%"), .isShare = true, .unitText = "% of the value"};
  switch (quantity) {
    case FrictionQuantity::Velocity:
      return unitOf("m/s", unitNames("m/s"));
    case FrictionQuantity::VelocityError:
      return column.unit == "%" || isShareUnit(column.unit)
                 ? share
                 : unitOf("m/s", unitNames("m/s") + ", %");
    case FrictionQuantity::Force:
      return unitOf("N", unitNames("N") + ", mN, uN, kN");
    case FrictionQuantity::Pressure:
      return unitOf("Pa", unitNames("Pa"));
    case FrictionQuantity::Mu:
      return isPureUnit(column.unit) ? FrictionConversion{} : unitOf("", "1, %");
    case FrictionQuantity::MuError:
      return isPureUnit(column.unit) || column.unit == "%" || isShareUnit(column.unit)
                 ? errorConversion(column, block)
                 : unitOf("", "1, %");
    case FrictionQuantity::Temperature:
      return unitOf("K", "K, C, F");
    default:
      return {};
  }
}

}  // namespace

bool isPureUnit(std::string_view unit) {
  return unit.empty() || unit == "1" || unit == "-" || unit == "\u2013" || unit == "N/N";
}

FrictionConversion findConversion(FrictionQuantity quantity, const TextColumn& column,
                                  const TextBlock& block, const std::string& name) {
  const auto scale = findErrorScale(column);
  if (!scale) return unscaledConversion(quantity, column, block, name);
  const std::string relative = scale->isShare ? "relative " : "";
  FrictionConversion scaled =
      unscaledConversion(quantity, {relative + scale->name, scale->unit}, block, name);
  scaled.divisor = scale->divisor;
  scaled.isVariance = scale->isVariance;
  if (scale->isVariance)
    scaled.unitText = "its square root";
  else if (scale->divisor != 1 && scaled.unitText.empty())
    scaled.unitText = message("divided by {} for one standard error", plain(scale->divisor));
  else if (scale->divisor != 1)
    scaled.unitText =
        message("{}, divided by {} for one standard error", scaled.unitText, plain(scale->divisor));
  return scaled;
}

}  // namespace asperity
