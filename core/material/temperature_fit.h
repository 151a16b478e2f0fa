// Fits formulas to a table of temperature shifts: Williams, Landel and Ferry, and Arrhenius
// (core/material/element_law.h has both). Pure functions; any thread.
#pragma once

#include <optional>
#include <span>

#include "core/material/elastomer.h"

namespace asperity {

/// A fitted formula and its residual.
struct TemperatureFit {
  TemperatureShift shift;  // of kind Wlf or Arrhenius
  double rms = 0;          // decades, over the rows of the table
  double offset = 0;       // decades, of the table at the reference, where it is free
  bool isDefined = false;  // whether there are rows enough: three for Wlf, two for Arrhenius
};

/// Fit log10 a_T by least squares with equal weight of all rows; both formulas are exactly 0 at the
/// reference (K). c1 and E_a are not negative; c2 is above the distance from the reference to the
/// coldest row. isOffsetFree: the table may refer to another temperature.
TemperatureFit fitWlf(std::span<const ShiftPoint> table, double referenceTemperature,
                      bool isOffsetFree = false);
TemperatureFit fitArrhenius(std::span<const ShiftPoint> table, double referenceTemperature,
                            bool isOffsetFree = false);

/// A formula with a smaller rms (decades) may replace the table: overlaps are hardly more accurate.
inline constexpr double kGoodShiftFit = 0.05;

/// Returns the formula that interpolates the shift between the rows: chosen as by chosenShift, with
/// a free offset. Nothing where no formula is good.
std::optional<TemperatureFit> interpolatingFormula(std::span<const ShiftPoint> table,
                                                   double temperature);

/// Returns the table itself, with a row at the reference where it would not be 0 there.
TemperatureShift tableShift(std::span<const ShiftPoint> table, double referenceTemperature);

/// Returns Wlf, or else Arrhenius, where it is good and has fewer constants than there are rows
/// beside that of the reference; else the table.
TemperatureShift chosenShift(std::span<const ShiftPoint> table, double referenceTemperature);

}  // namespace asperity
