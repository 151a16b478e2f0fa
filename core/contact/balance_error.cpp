#include "core/contact/balance_error.h"

#include <fmt/format.h>

#include "core/contact/force_balance.h"

namespace asperity {

TextError unmetBalance(const SteadyResult& result, double velocity, const Message& where) {
  const Message place = sentences({message("at velocity {:.4g} m/s", velocity), where});
  if (result.residual <= kAcceptedResidual)
    return TextError(message(
        "contact is too short, or moduli are too far apart, for the digits that numbers have, {}",
        place));
  return TextError(
      message("the force balance is not met {}: relative residual {:.2g}", place, result.residual));
}

void requireBalance(const SteadyResult& result, double velocity, const Message& where) {
  if (result.status != SteadyStatus::Balanced) throw unmetBalance(result, velocity, where);
}

}  // namespace asperity
