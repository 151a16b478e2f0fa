// What is timed, as functions: the shipped path and the scalar pass over given lines, velocities
// and forces. Threading: the main thread.
#pragma once

#include <span>
#include <vector>

#include "core/contact/line/prepared_profile.h"
#include "core/contact/steady_sliding.h"
#include "tests/bench/samples.h"

namespace asperity::bench {

inline constexpr double kModulus = 1e7;          // Pa
inline constexpr double kRelaxation = 1e-3;      // s
inline constexpr double kFigure2Force = 0.0034;  // N
inline constexpr double kSlow = 0.01;            // m/s, where contact fractions are chosen

/// The 41 velocities of Fig. 2 (m/s).
const std::vector<double>& figure2Velocities();

/// 16 velocities (m/s) from kSlow to 1.35 kSlow: two full vectors of neighbours at one contact
/// fraction.
const std::vector<double>& nearlyOneVelocity();

/// The 20 forces of Fig. 4, 1e-3 to 1e2 N.
std::vector<double> figure4Forces();

/// `count` values from low to high, evenly spaced in their logarithm.
std::vector<double> logarithmic(double low, double high, int count);

/// The force (N) at which this part of the line is in contact at kSlow; 1: contact just complete.
double forceForContact(const PreparedProfile& line, double fraction);

/// The shipped path: the whole sweep at one force. Every balance is checked to be met; throws
/// std::runtime_error where one is not.
/// others: of another line, as in every ensemble; or none.
Tally shippedSweep(const PreparedProfile& line, double force, std::span<const double> velocities,
                   std::span<const SteadyResult> others = {});

/// What the shipped path finds; for the others of shippedSweep.
std::vector<SteadyResult> shippedResults(const PreparedProfile& line, double force,
                                         std::span<const double> velocities);

/// One velocity after the other by the scalar pass, each without a starting value.
Tally scalarSweep(const PreparedProfile& line, double force, std::span<const double> velocities);

void add(Tally& sum, const Tally& part);

}  // namespace asperity::bench
