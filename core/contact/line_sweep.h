// One line of elements without arms at many velocities, with the force balance met at each: the
// work behind friction curves. Velocities run side by side in the lanes of the machine's
// vectors and share the line's data. The scheme of the line chooses the kernel: runPasses in
// line_sweep.cpp runs the passes of linear and cubic lines, sweepNodal solves the balances of nodal
// ones. Threading: a function of its arguments. It allocates no memory that depends on the line.
#pragma once

#include <span>
#include <stop_token>

#include "core/contact/line/prepared_profile.h"
#include "core/contact/steady_sliding.h"
#include "core/scene/scene.h"

namespace asperity {

/// Computes results[i] for velocities[i] (m/s, ascending); both of one length.
/// `conditions.velocity` is not used. For resolved lines powerIn is not computed: NaN. Returns
/// false where `stop` was requested, which is checked inside passes, too; `passes` is then 0 in
/// missing results. others: the results of another line with the same spectrum at the same loads
/// and velocities, or none; they change the cost, but not the result beyond the residual.
bool slideSweep(const PreparedProfile& line, const SlidingConditions& conditions, const Load& load,
                std::span<const double> velocities, std::span<SteadyResult> results,
                const std::stop_token& stop = {}, std::span<const SteadyResult> others = {});

/// Computes several forces (N, ascending), which costs less than one after the other: depths found
/// at some forces and velocities lead to those at others. results[k * velocities.size() + i] is for
/// forces[k] and velocities[i]. Steady sliding depends only on F_N / G, and on F_N / (G h) with mu
/// in units of the rms slope: other moduli and rms heights of one line are equivalent to other
/// forces.
bool slideAtForces(const PreparedProfile& line, const SlidingConditions& conditions,
                   std::span<const double> forces, std::span<const double> velocities,
                   std::span<SteadyResult> results, const std::stop_token& stop = {},
                   std::span<const SteadyResult> others = {});

}  // namespace asperity
