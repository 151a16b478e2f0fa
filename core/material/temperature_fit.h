// Formulas through a table of temperature shifts: Williams, Landel and Ferry, and Arrhenius
// (core/material/element_law.h has both). Pure functions; any thread.
#pragma once

#include <span>

#include "core/material/elastomer.h"

namespace asperity {

/// A formula and how well it goes through the table.
struct TemperatureFit {
  TemperatureShift shift;  // of kind Wlf or Arrhenius
  double rms = 0;          // decades, over the rows of the table
  bool isDefined = false;  // whether there are rows enough: three for Wlf, two for Arrhenius
};

/// Least squares of log10 a_T, all rows alike; both formulas are exactly 0 at the reference (K).
/// c1 and E_a are not below 0, c2 lies above the distance from the reference to the coldest row.
TemperatureFit fitWlf(std::span<const ShiftPoint> table, double referenceTemperature);
TemperatureFit fitArrhenius(std::span<const ShiftPoint> table, double referenceTemperature);

/// Below this rms (decades) a formula stands for the table: about what overlaps can tell.
inline constexpr double kGoodShiftFit = 0.05;

/// Wlf, else Arrhenius, where it is as good as that with more rows than it has constants; else the
/// table.
TemperatureShift chosenShift(std::span<const ShiftPoint> table, double referenceTemperature);

}  // namespace asperity
