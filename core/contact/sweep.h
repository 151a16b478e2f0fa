// One line at many velocities, force balance met at each: the shipped path of every curve.
// Velocities run side by side in the lanes of the machine's vectors, sharing the line's data; the
// widest instruction set is chosen at run time.
// Threading: a function of its arguments. No allocation inside, beyond what the line holds.
#pragma once

#include <span>
#include <stop_token>

#include "core/contact/line/prepared_profile.h"
#include "core/contact/steady_sliding.h"
#include "core/scene/scene.h"

namespace asperity {

/// results[i] is for velocities[i] (m/s, ascending); both of one length. `conditions.velocity` is
/// not used. Of resolved lines powerIn is not gathered: NaN. Returns false where `stop` was
/// requested in between, which is looked at inside passes too; `passes` is 0 in results that are
/// then missing. others: the results of another line with the same spectrum at the same loads and
/// velocities, or none; they change the cost, not the answer beyond the residual.
bool slideSweep(const PreparedProfile& line, const SlidingConditions& conditions, const Load& load,
                std::span<const double> velocities, std::span<SteadyResult> results,
                const std::stop_token& stop = {}, std::span<const SteadyResult> others = {});

/// The same at several forces (N, ascending), which costs less than one after the other: depths
/// found at some forces and velocities lead to those at others. results[k * velocities.size() + i]
/// is for forces[k] and velocities[i].
/// Steady sliding depends on F_N / G alone, and on F_N / (G h) with mu in units of the rms slope:
/// moduli and rms heights of one line are forces too.
bool slideAtForces(const PreparedProfile& line, const SlidingConditions& conditions,
                   std::span<const double> forces, std::span<const double> velocities,
                   std::span<SteadyResult> results, const std::stop_token& stop = {},
                   std::span<const SteadyResult> others = {});

}  // namespace asperity
