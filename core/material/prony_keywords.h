// A Prony series before its modulus is known, and its readers in files of finite-element programs.
// Pure; any thread.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"
#include "core/material/elastomer.h"
#include "core/material/prony_file.h"

namespace asperity {

/// The content of all of these files: parts of the instantaneous modulus, or moduli, and one
/// modulus.
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
  Message format{};
  std::vector<Message> notes{};
};

/// Reads the keywords of Abaqus or the commands of Ansys; nothing where the text has neither.
/// Throws InputError (`name`), also for the keywords of LS-DYNA, which are not read.
std::optional<RawSeries> keywordSeries(std::string_view text, const std::string& name,
                                       const PronyChoices& choices);

}  // namespace asperity
