#include "core/material/isotherm_overlap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/input_error.h"
#include "core/material/overlap_fit.h"
#include "core/material/stray_points.h"

namespace asperity {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kScanStep = 0.01;      // decades
constexpr double kMinOverlap = 0.15;    // decades that two isotherms must have in common, or a
constexpr double kMinPart = 0.25;       // quarter of the shorter one
constexpr double kMaxMismatch = 0.2;    // decades of modulus, beyond which nothing fits
constexpr double kEdgeMismatch = 0.02;  // the same where the overlap is the least allowed
constexpr int kComparisons = 33;        // frequencies at which two isotherms are compared
constexpr double kOpenVertical = 0.02;  // decades, error beyond which a vertical shift is open
constexpr double kWrongWay = 0.3;       // decades against the order of temperatures

LogSweep logarithms(const Isotherm& isotherm) {
  LogSweep sweep;
  for (const DynamicModulus& point : isotherm.points) {
    sweep.x.push_back(std::log10(point.frequency));
    sweep.storage.push_back(std::log10(point.storage));
    sweep.loss.push_back(std::log10(point.loss));
  }
  return sweep;
}

/// Interpolates linearly between the points; x lies within them.
double interpolated(const std::vector<double>& xs, const std::vector<double>& ys, double x) {
  const auto above = std::ranges::lower_bound(xs, x);
  const auto i =
      std::clamp<std::size_t>(static_cast<std::size_t>(above - xs.begin()), 1, xs.size() - 1);
  const double part = (x - xs[i - 1]) / (xs[i] - xs[i - 1]);
  return ys[i - 1] + part * (ys[i] - ys[i - 1]);
}

/// Returns the rms difference of both moduli over the common range, in decades, after a vertical
/// shift.
double mismatchAt(const LogSweep& colder, const LogSweep& warmer, double shift,
                  double vertical = 0) {
  const CommonRange range = commonRange(colder, warmer, shift);
  double squares = 0;
  for (int i = 0; i < kComparisons; ++i) {
    const double x = range.from + range.width() * i / (kComparisons - 1);
    const double storage = interpolated(colder.x, colder.storage, x - shift) -
                           interpolated(warmer.x, warmer.storage, x) - vertical;
    const double loss = interpolated(colder.x, colder.loss, x - shift) -
                        interpolated(warmer.x, warmer.loss, x) - vertical;
    squares += storage * storage + loss * loss;
  }
  return std::sqrt(squares / (2 * kComparisons));
}

/// Returns the best of all shifts with a sufficient common range, after a vertical shift (decades);
/// nothing where the two do not overlap.
std::optional<double> scannedShift(const LogSweep& colder, const LogSweep& warmer,
                                   double vertical = 0) {
  const double coldWidth = colder.x.back() - colder.x.front();
  const double warmWidth = warmer.x.back() - warmer.x.front();
  const double least = std::min(kMinOverlap, kMinPart * std::min(coldWidth, warmWidth));
  const double from = warmer.x.front() + least - colder.x.back();
  const double to = warmer.x.back() - least - colder.x.front();
  const int steps = std::max(2, static_cast<int>(std::ceil((to - from) / kScanStep)));
  int best = 0;
  double bestMismatch = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= steps; ++i) {
    const double mismatch = mismatchAt(colder, warmer, from + (to - from) * i / steps, vertical);
    if (mismatch < bestMismatch) best = i, bestMismatch = mismatch;
  }
  const bool isAtEdge = best == 0 || best == steps;
  if (bestMismatch > (isAtEdge ? kEdgeMismatch : kMaxMismatch)) return {};
  return from + (to - from) * best / steps;
}

[[noreturn]] void refuseGap(const Isotherm& colder, const Isotherm& warmer) {
  throw InputError(
      "", "",
      message("the isotherms at {} and {} do not overlap: no shift brings their moduli "
              "together; a sweep at a temperature between them or over more "
              "frequencies is needed, or leave the isotherms beyond the gap out",
              celsius(colder.temperature), celsius(warmer.temperature)));
}

/// Refuses a pair of isotherms that overlap but for a point that is wrong.
void refuseStray(const Isotherm& cold, const Isotherm& warm) {
  const std::vector<Isotherm> pair{cold, warm};
  const std::vector<StrayPoint> strays = strayPoints(pair);
  if (strays.empty() || !scannedShift(logarithms(withoutStrays(cold, 0, strays)),
                                      logarithms(withoutStrays(warm, 1, strays))))
    return;
  throw InputError("", "",
                   message("the isotherms at {} and {} overlap only without a point that leaves "
                           "its curve: {}; correct its row, or take it out",
                           celsius(cold.temperature), celsius(warm.temperature),
                           describe(strays.front(), pair)));
}

[[noreturn]] void refuseWithoutVertical(const Isotherm& colder, const Isotherm& warmer) {
  throw InputError(
      "", "",
      message("the isotherms at {} and {} do not overlap: only a vertical shift, as of an entropic "
              "spring, brings their moduli together; allow it with --vertical-shifts",
              celsius(colder.temperature), celsius(warmer.temperature)));
}

/// Throws InputError where shifts rise with temperature: a material that becomes slower as it
/// becomes warmer has its temperatures mixed up.
void checkOrder(const Isotherm& cold, const Isotherm& warm, const Overlap& overlap) {
  const double error = std::isfinite(overlap.standardError) ? overlap.standardError : 0;
  if (overlap.log10Shift > -kWrongWay - 3 * error) return;
  throw InputError(
      "", "temperature",
      message("the isotherm at {} is slower than that at {} by {:.2f} decades: the "
              "temperatures are out of order; correct the column, or leave an isotherm "
              "out",
              celsius(warm.temperature), celsius(cold.temperature), -overlap.log10Shift));
}

}  // namespace

NeighbourShifts neighbourShifts(const Isotherm& cold, const Isotherm& warm, bool isVertical) {
  const LogSweep colder = logarithms(cold), warmer = logarithms(warm);
  const double entropic = std::log10(cold.temperature / warm.temperature);
  std::optional<double> start = scannedShift(colder, warmer);
  // Plateaus of different height are joined by a vertical shift alone.
  if (!start) {
    refuseStray(cold, warm);
    start = scannedShift(colder, warmer, entropic);
    if (!start) refuseGap(cold, warm);
    if (!isVertical) refuseWithoutVertical(cold, warm);
  }
  std::optional<double> expected;
  if (isVertical) expected = entropic;
  const auto fitted = fittedShift(colder, warmer, *start, expected, ShiftModuli::Both);
  NeighbourShifts found;
  Overlap& both = found.both;
  const FittedShifts common = fitted.value_or(FittedShifts{{*start, kNaN}, {0, kNaN}});
  both.log10Shift = common.horizontal.value;
  both.standardError = common.horizontal.error;
  both.log10Vertical = common.vertical.value;
  both.verticalError = common.vertical.error;
  found.residuals = common.residuals;
  const double ofVertical = common.residuals.verticalError;
  both.isVerticalOpen = !std::isnan(ofVertical) && ofVertical > kOpenVertical;
  both.decades = commonRange(colder, warmer, both.log10Shift).width();
  if (both.decades > 0)
    both.mismatch = mismatchAt(colder, warmer, both.log10Shift, both.log10Vertical);
  // One modulus alone cannot tell a vertical shift from a horizontal one.
  LogSweep level = colder;
  for (std::vector<double>* values : {&level.storage, &level.loss})
    for (double& value : *values) value -= both.log10Vertical;
  const auto alone = [&](ShiftModuli moduli) {
    const auto one = fittedShift(level, warmer, both.log10Shift, {}, moduli);
    return one ? one->horizontal : ShiftEstimate{kNaN, kNaN};
  };
  found.storage = alone(ShiftModuli::Storage);
  found.loss = alone(ShiftModuli::Loss);
  checkOrder(cold, warm, both);
  return found;
}

}  // namespace asperity
