// A force balance that is not met, said in one way by whoever meets it: curves, pictures, motions,
// comparisons. Pure; any thread.
#pragma once

#include <stdexcept>
#include <string>

#include "core/contact/steady_sliding.h"

namespace asperity {

/// What is wrong with the result at this velocity (m/s): the balance is not met, or numbers have
/// too few digits for it. where: " on realization 3"; empty: nothing to say.
std::runtime_error unmetBalance(const SteadyResult& result, double velocity,
                                const std::string& where = {});

/// Throws it where the result is not balanced.
void requireBalance(const SteadyResult& result, double velocity, const std::string& where = {});

}  // namespace asperity
