// Formulas through a table of temperature shifts: Williams, Landel and Ferry, and Arrhenius
// (core/material/element_law.h has both). Pure functions; any thread.
#pragma once

#include <optional>
#include <span>

#include "core/material/elastomer.h"

namespace asperity {

/// A formula and how well it goes through the table.
struct TemperatureFit {
  TemperatureShift shift;  // of kind Wlf or Arrhenius
  double rms = 0;          // decades, over the rows of the table
  double offset = 0;       // decades, of the table at the reference, where it is free
  bool isDefined = false;  // whether there are rows enough: three for Wlf, two for Arrhenius
};

/// Least squares of log10 a_T, all rows alike; both formulas are exactly 0 at the reference (K).
/// c1 and E_a are not below 0, c2 lies above the distance from the reference to the coldest row.
/// isOffsetFree: the table may count from another temperature.
TemperatureFit fitWlf(std::span<const ShiftPoint> table, double referenceTemperature,
                      bool isOffsetFree = false);
TemperatureFit fitArrhenius(std::span<const ShiftPoint> table, double referenceTemperature,
                            bool isOffsetFree = false);

/// Below this rms (decades) a formula stands for the table: about what overlaps can tell.
inline constexpr double kGoodShiftFit = 0.05;

/// The law whose smooth course tells the shift between the rows: as chosenShift, with a free
/// offset. Nothing where none is good.
std::optional<TemperatureFit> lawBetween(std::span<const ShiftPoint> table, double temperature);

/// The table itself, with a row at the reference where it would not be 0 there.
TemperatureShift tableShift(std::span<const ShiftPoint> table, double referenceTemperature);

/// Wlf, else Arrhenius, where it is as good as that with more rows than it has constants; else the
/// table.
TemperatureShift chosenShift(std::span<const ShiftPoint> table, double referenceTemperature);

}  // namespace asperity
