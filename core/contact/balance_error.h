// A force balance that is not met, said in one way by whoever meets it: curves, pictures, motions,
// comparisons. Pure; any thread.
#pragma once

#include "core/base/input_error.h"
#include "core/contact/steady_sliding.h"

namespace asperity {

/// What is wrong with the result at this velocity (m/s): the balance is not met, or numbers have
/// too few digits for it. where: " on realization 3"; empty: nothing to say.
TextError unmetBalance(const SteadyResult& result, double velocity, const Message& where = {});

/// Throws it where the result is not balanced.
void requireBalance(const SteadyResult& result, double velocity, const Message& where = {});

}  // namespace asperity
