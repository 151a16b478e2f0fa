// Where the power goes: what the dashpots of each element turn into heat. Pure; any thread.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "core/contact/arms/retardation.h"
#include "core/scene/scene.h"

namespace asperity {

/// Of the terms of a balance: what is less beside them is rounding.
inline constexpr double kRounding = 16 * std::numeric_limits<double>::epsilon();

/// Pa, of p/4: what is less than this beside pressures p (N/m) is rounding of their balance.
double pressureRounding(std::span<const double> pressure);

/// W/m, now, of elements under pressures p (N/m) with creeping amplitudes a_j (m), [mode][element]
/// as TimeMarch holds them. Each amplitude is a spring and a dashpot side by side that follow
/// a_j' = -rate_j a_j + fluidity_j p/4, so that the dashpots take 4 sum a_j'^2 / fluidity_j; of
/// Kelvin elements 4 eta u'^2, in contact or free. Its integral over a period of steady sliding is
/// F_x v. Zeros for elastic elements, and where what is left to creep is rounding: at rest.
std::vector<double> dissipatedPower(const RetardationModes& modes, std::span<const double> pressure,
                                    std::span<const double> amplitudes);

/// Adds to the power (W/m) of each element what local friction turns into heat where p (N/m) is
/// above 0, at this velocity (m/s, either sign).
void addLocalFriction(std::span<double> power, std::span<const double> pressure,
                      const Interface& interface, double velocity);

}  // namespace asperity
