// Values of the options of `asperity material`, which are the arguments of asperity.material() in
// Python, too: choices, temperatures and moduli. Pure; any thread. Throw InputError with the name
// of the option.
#pragma once

#include <cmath>
#include <optional>
#include <string>

#include "core/base/input_error.h"
#include "core/base/named_choices.h"
#include "core/base/text_number.h"
#include "core/base/units.h"
#include "core/material/dma_columns.h"
#include "core/material/elastomer.h"

namespace asperity {

inline constexpr NamedChoices<std::optional<ShiftKind>, 4> kShiftChoices{
    {{"auto", std::nullopt},
     {"wlf", ShiftKind::Wlf},
     {"arrhenius", ShiftKind::Arrhenius},
     {"table", ShiftKind::Table}}};
inline constexpr NamedChoices<ModulusKind, 3> kModulusChoices{{{"auto", ModulusKind::Unknown},
                                                               {"shear", ModulusKind::Shear},
                                                               {"tension", ModulusKind::Tension}}};

/// Returns a temperature in K, such as 20C, 293.15K or 68F.
inline double kelvinsFrom(const std::string& text, const std::string& option) {
  constexpr double kHottest = 2000;
  const auto temperature = parseTemperature(text);
  if (!temperature || !(*temperature > 0 && *temperature <= kHottest))
    throw InputError("", option,
                     message("'{}' is not a temperature such as 20C, 293.15K or 68F", text));
  return *temperature;
}

/// Returns a modulus in Pa; the text may have a unit: 2.3MPa.
inline double pascalsFrom(const std::string& text, const std::string& option) {
  const auto quantity = parseQuantity(text);
  const auto unit = quantity ? unitSize(quantity->unit.empty() ? "Pa" : quantity->unit, "Pa")
                             : std::optional<double>();
  if (!unit || !(quantity->number > 0) || !std::isfinite(quantity->number * *unit))
    throw InputError("", option, message("'{}' is not a modulus such as 2.3MPa", text));
  return quantity->number * *unit;
}

}  // namespace asperity
