#include "core/contact/balance_error.h"

#include <fmt/format.h>

#include "core/contact/force_balance.h"

namespace asperity {

std::runtime_error unmetBalance(const SteadyResult& result, double velocity,
                                const std::string& where) {
  const std::string place = fmt::format("at velocity {:.4g} m/s{}", velocity, where);
  if (result.residual <= kAcceptedResidual)
    return std::runtime_error(
        "contact is too short, or moduli are too far apart, for the digits that numbers have, " +
        place);
  return std::runtime_error(fmt::format("the force balance is not met {}: relative residual {:.2g}",
                                        place, result.residual));
}

void requireBalance(const SteadyResult& result, double velocity, const std::string& where) {
  if (result.status != SteadyStatus::Balanced) throw unmetBalance(result, velocity, where);
}

}  // namespace asperity
