// The shift of relaxation times with temperature: the factor a_T by the formulas of Williams,
// Landel and Ferry and of Arrhenius or by a table, and the fits of both formulas to a table. Pure
// functions; any thread.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "core/material/elastomer.h"

namespace asperity {

/// The largest shift that has a meaning, in decades.
inline constexpr double kMaxDecades = 30;

/// Limits of the constants of a shift, as in scenes.
inline constexpr double kMaxC1 = 1000, kMinC2 = 1e-3, kMaxC2 = 1e4;  // the latter two K
inline constexpr double kMaxActivationEnergy = 1e7;                  // J/mol

/// The words for the kinds of shift in scenes, options and files, in the order of ShiftKind.
inline constexpr std::array<std::string_view, 3> kShiftNames{"wlf", "arrhenius", "table"};
constexpr std::string_view shiftName(ShiftKind kind) {
  return kShiftNames[static_cast<std::size_t>(kind)];
}

/// J/(mol K), the molar gas constant (exact since the SI of 2019).
inline constexpr double kGasConstant = 8.31446261815324;

/// Returns log10 of the factor a_T by which temperature (K) multiplies every relaxation time and
/// the viscosity.
/// Wlf: log10 a_T = -c1 (T - T_r) / (c2 + T - T_r), Williams, Landel and Ferry, J. Am. Chem. Soc.
/// 77, 3701 (1955), valid from the glass transition to about 100 K above it.
/// Arrhenius: ln a_T = E/R (1/T - 1/T_r). Table: linear in T between the rows.
/// The moduli do not change, so mu(v, T) = mu(v a_T, T_r). The result is exactly 0 at the reference
/// temperature. Throws InputError (elastomer.temperature) at or below T_r - c2, where there is no
/// shift, outside of a table, and beyond kMaxDecades.
double log10ShiftFactor(const TemperatureShift& shift, double temperature);

/// Returns a_T itself.
double shiftFactor(const TemperatureShift& shift, double temperature);

/// Returns whether the temperature changes the relaxation times, or has no shift at all.
bool shiftsTimes(const Elastomer& elastomer);

/// Returns a_T of an elastomer at its own temperature; 1 for an elastic one, which has no times.
double temperatureShift(const Elastomer& elastomer);

/// Returns a_T of an elastomer at one temperature over that at another: the factor by which
/// velocities are shifted from the first to the second.
double temperatureShift(Elastomer elastomer, double from, double to);

// ---- Fits

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

/// Returns the formula that interpolates the shift between the rows: chosen as by chosenShift, with
/// a free offset. Nothing where no formula is good.
std::optional<TemperatureFit> interpolatingFormula(std::span<const ShiftPoint> table,
                                                   double temperature);

/// Returns the table itself with the shift 0 at the reference (K) within it, where it has a row of
/// its own if the rows beside it would give another shift.
TemperatureShift tableShift(std::span<const ShiftPoint> table, double referenceTemperature);

/// Returns Wlf, or else Arrhenius, where it is good and has fewer constants than there are rows
/// beside that of the reference; else the table.
TemperatureShift chosenShift(std::span<const ShiftPoint> table, double referenceTemperature);

}  // namespace asperity
