#include "core/material/temperature_shift.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/input_error.h"

namespace asperity {

double shiftFactor(const TemperatureShift& shift, double temperature) {
  const double above = temperature - shift.referenceTemperature;
  if (above == 0) return 1;
  if (!(above > -shift.c2))
    throw InputError("", "elastomer.temperature",
                     message("{} K is not above {} K, reference_temperature - c2, where the "
                             "shift ends",
                             temperature, shift.referenceTemperature - shift.c2));
  const double decades = -shift.c1 * above / (shift.c2 + above);
  if (!(std::abs(decades) <= kMostDecades))
    throw InputError("", "elastomer.temperature",
                     message("{} K shifts the times by {:.3g} decades; allowed is {}", temperature,
                             decades, kMostDecades));
  return std::pow(10, decades);
}

}  // namespace asperity
