// A Prony series as a file states it, before its modulus is known: parts of a modulus, or moduli,
// and one modulus. prony_table.h and prony_keywords.h read it; prony_file.h finishes it. Plain
// values; any thread.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/material/elastomer.h"

namespace asperity {

struct RawSeries {
  static constexpr double kNotStated = std::numeric_limits<double>::quiet_NaN();
  struct Term {
    double weight = 0, time = 0;
    std::size_t line = 0;
  };
  std::vector<Term> terms{};
  bool isRelative = true;             // weights are parts of the instantaneous modulus
  double instantaneous = kNotStated;  // in the file's unit, of shear
  double equilibrium = kNotStated;    // the same
  double unit = 1;                    // Pa
  bool isUnitKnown = false;
  std::optional<TemperatureShift> shift{};
  std::optional<double> temperature{};  // K, at which the file states its values
  std::string material{};               // "TREAD"; empty where the file names none
  Message format{};
  std::vector<Message> notes{};
};

}  // namespace asperity
