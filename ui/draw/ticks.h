// Numbers for users: ticks at round values of linear and logarithmic axes, values with a prefixed
// unit. Pure; any thread. Texts are UTF-8 with a true minus, micro and multiplication sign.
#pragma once

#include <QString>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/number_text.h"

namespace asperity {

struct Tick {
  double value = 0;   // SI; on a logarithmic axis its decimal logarithm
  std::string label;  // in the axis' unit; "10⁻³", "2×10³"
};

inline constexpr int kFewTicks = 3;  // they show a scale better than two

/// Returns the width in pixels of the widest label in fonts of `size`.
float widestLabel(const std::vector<Tick>& ticks, float size);

struct AxisTicks {
  std::vector<Tick> ticks;  // ascending, inside [from, to]
  std::string unit;         // "mm"
  double unitSize = 1;      // SI value of one such unit
};

/// Returns the smallest of 1, 2, 5 times a power of ten that is at least `value` (> 0).
double roundUp125(double value);

/// Returns the next of 1, 1.5, 2, 2.5, 3, 4, 5, 6, 8 times a power of ten, as the end of a scale.
double roundUp(double value);

/// Returns at most `most` ticks with a step of 1, 2 or 5 times a power of ten; none if from >= to
/// or the step is lost in rounding. `unit` is the SI unit; its prefix follows the larger end. A
/// unit without prefixes ("", "%", "1/m", "m²") gets the power of ten of the largest tick where
/// plain numbers would be long, and so does any unit outside the range of prefixes.
AxisTicks linearTicks(double from, double to, int most, std::string_view unit);

/// Leaves out all ticks but the first and the last.
void keepOutermost(std::vector<Tick>& ticks);

/// Returns the minor ticks that split a step of 1, 2, 5 into 5, 4, 5; ascending, in [from, to].
/// Between two ticks with another distance there are none.
std::vector<double> minorTicks(const AxisTicks& axis, double from, double to);

/// Returns ticks whose labels, written side by side in fonts of `size`, fit `pixels`: two or more
/// wherever two fit, because a single tick does not show the scale.
AxisTicks sparseTicks(double from, double to, float pixels, float size, std::string_view unit);

/// Returns ticks of a vertical axis, `each` pixels for one of them. A low axis has closer ticks as
/// far as labels in fonts of `size` fit: three or more, otherwise two, because a single tick does
/// not show the scale.
AxisTicks yTicks(double from, double to, float pixels, float each, float size,
                 std::string_view unit);

/// Returns ticks between the decimal logarithms `from` and `to`, ascending, at most `most`:
/// decades, thinned where there are many; where there are fewer than three, as many multiples of
/// them as fit. None where from >= to, either is not finite, or most < 1.
std::vector<Tick> logTicks(double from, double to, int most);

/// Returns decimal logarithms of the minor ticks: 2, 3, ..., 9 times every decade, or 2 and 5 times
/// where `decadePixels` is below twelve times `apart`, or only the decades where those do not fit.
/// Ascending, none at a tick.
std::vector<double> minorLogTicks(double from, double to, const std::vector<Tick>& ticks,
                                  double decadePixels, double apart);

/// Returns a positive factor for people, "1,410,000": with three digits, and without a power of ten
/// where there is space for all of them.
std::string factorText(double factor);

/// These functions return printedNumber() and printedQuantity() in the current language, with its
/// groups of thousands: "12,300 s".
std::string shortNumber(double value, int digits = 3, Zeros zeros = Zeros::Drop);
std::string quantity(double value, std::string_view unit, int digits = 3,
                     Zeros zeros = Zeros::Drop);

/// Returns a part of a whole as "12.3 %", or "\u2013".
std::string shortPercent(double part);

/// Returns "0.00116 \u00B1 0.00012" or "(2.637 \u00B1 0.012)\u00D710\u207B\u2077": two digits of
/// the error, and the value to the same place, with at least three digits of the larger one.
/// Without an error above 0 it is shortNumber().
std::string numberWithError(double value, double error, Zeros zeros = Zeros::Drop);

/// Returns shortNumber() as widgets take it.
QString readingLabel(double value, int digits = 3, Zeros zeros = Zeros::Drop);

}  // namespace asperity
