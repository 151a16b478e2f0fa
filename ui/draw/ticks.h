// Numbers for people: round places on a linear axis, values with a prefixed unit. Pure; any thread.
// Texts are UTF-8 with a true minus, micro and multiplication sign.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/number_text.h"

namespace asperity {

struct Tick {
  double value;       // SI
  std::string label;  // in the axis' unit
};

struct AxisTicks {
  std::vector<Tick> ticks;  // ascending, inside [from, to]
  std::string unit;         // "mm"
  double unitSize = 1;      // SI value of one such unit
};

/// The smallest of 1, 2, 5 times a power of ten that is at least `value` (> 0).
double roundUp125(double value);

/// The next of 1, 1.5, 2, 2.5, 3, 4, 5, 6, 8 times a power of ten: ends for a scale.
double roundUp(double value);

/// At most `most` places with a step of 1, 2 or 5 times a power of ten; none if from >= to or the
/// step is lost in rounding. `unit` is the SI unit; its prefix follows the larger end. A unit that
/// takes none ("", "%", "1/m", "m²") counts in a power of ten where plain numbers would be long,
/// and so does any unit beyond all prefixes: that of the largest tick.
AxisTicks linearTicks(double from, double to, int most, std::string_view unit);

/// The places between the ticks that split a step of 1, 2, 5 into 5, 4, 5; ascending, in [from,
/// to].
std::vector<double> minorTicks(const AxisTicks& axis, double from, double to);

/// printedNumber() and printedQuantity() in the language in use.
std::string shortNumber(double value, int digits = 3, Zeros zeros = Zeros::Drop);
std::string quantity(double value, std::string_view unit, int digits = 3,
                     Zeros zeros = Zeros::Drop);

}  // namespace asperity
