// Temperature shifts all times of an elastomer together.
// log10 a_T = -c1 (T - T_r) / (c2 + T - T_r): Williams, Landel and Ferry, J. Am. Chem. Soc. 77,
// 3701 (1955). Valid from the glass transition to about 100 K above it; the moduli stay as they
// are. mu(v, T) = mu(v a_T, T_r). Pure function; costs nothing per element.
#pragma once

#include "core/material/elastomer.h"

namespace asperity {

/// Decades beyond which a shift says nothing any more.
inline constexpr double kMostDecades = 30;

/// a_T > 0, by which every relaxation time and the viscosity are multiplied; exactly 1 at the
/// reference temperature. Throws InputError (elastomer.temperature) at or below T_r - c2, where
/// there is no shift, and beyond kMostDecades.
double shiftFactor(const TemperatureShift& shift, double temperature);

}  // namespace asperity
