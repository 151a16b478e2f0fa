#include "core/material/isotherm_overlap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/statistics.h"
#include "core/material/overlap_fit.h"
#include "core/material/stray_points.h"

namespace asperity {
namespace {

constexpr double kRarity = 0.0027;  // of three standard errors of a normal distribution

double part(double numerator, double denominator) {
  return denominator > 0 ? numerator / denominator : 0;
}

/// Returns the probability that noise alone has a mean square of `count` deviations above this, by
/// Paulson's approximation of the F distribution (Abramowitz and Stegun, 26.6.15).
double rarityOfMeanSquare(double meanSquare, double count, double degreesOfFreedom) {
  const double root = std::cbrt(meanSquare), ofCount = 2 / (9 * count),
               ofFreedom = 2 / (9 * degreesOfFreedom);
  const double normal =
      ((1 - ofFreedom) * root - (1 - ofCount)) / std::sqrt(ofFreedom * root * root + ofCount);
  return normalProbability(-normal);
}

}  // namespace

OverlapNoise::OverlapNoise(std::span<const OverlapResiduals> overlaps, Of of)
    : overlaps_(overlaps), of_(of) {
  OverlapResiduals::Modulus storage, loss;
  const auto add = [](OverlapResiduals::Modulus& sum, const OverlapResiduals::Modulus& one) {
    sum.squares += one.squares;
    sum.degreesOfFreedom += one.degreesOfFreedom;
    sum.products += one.products;
    sum.whiteProducts += one.whiteProducts;
    sum.neighbours += one.neighbours;
    sum.noiseSquares += one.noiseSquares;
    sum.noiseFreedom += one.noiseFreedom;
  };
  for (const OverlapResiduals& overlap : overlaps) {
    add(storage, overlap.storage);
    add(loss, overlap.loss);
  }
  // Sparse sweeps leave no residuals about their own curves.
  constexpr double kMinFreedom = 40;
  if (of_ == Of::Noise && storage.noiseFreedom + loss.noiseFreedom >= kMinFreedom) {
    storage_ = part(storage.noiseSquares, storage.noiseFreedom);
    loss_ = part(loss.noiseSquares, loss.noiseFreedom);
    freedom_ = storage.noiseFreedom + loss.noiseFreedom;
    return;
  }
  of_ = Of::Misfit;
  storage_ = part(storage.squares, storage.degreesOfFreedom);
  loss_ = part(loss.squares, loss.degreesOfFreedom);
  freedom_ = storage.degreesOfFreedom + loss.degreesOfFreedom;
  // White noise has products of both signs; only more than that is a correlation.
  constexpr double kSure = 2.5, kMax = 0.9;
  const double products = part(storage.products, storage_) - storage.whiteProducts +
                          part(loss.products, loss_) - loss.whiteProducts;
  const double neighbours = storage.neighbours + loss.neighbours;
  if (!(products > kSure * std::sqrt(neighbours))) return;
  const double correlation = std::min(kMax, products / neighbours);
  correlation_ = (1 + correlation) / (1 - correlation);
  freedom_ /= correlation_;
}

double OverlapNoise::ownScale(const OverlapResiduals& overlap) const {
  const OverlapResiduals::Modulus &storage = overlap.storage, &loss = overlap.loss;
  if (of_ == Of::Noise)
    return part(part(storage.noiseSquares, storage_) + part(loss.noiseSquares, loss_),
                storage.noiseFreedom + loss.noiseFreedom);
  return part(part(storage.squares, storage_) + part(loss.squares, loss_),
              storage.degreesOfFreedom + loss.degreesOfFreedom);
}

std::vector<double> OverlapNoise::deviations(Contrast OverlapResiduals::*contrast) const {
  std::vector<double> all;
  for (const OverlapResiduals& overlap : overlaps_) {
    const Contrast& one = overlap.*contrast;
    const double square = (one.storageGain * storage_ + one.lossGain * loss_) *
                          std::max(1.0, ownScale(overlap)) * correlation_;
    all.push_back(std::isfinite(one.value) && square > 0 ? one.value / std::sqrt(square) : 0);
  }
  return all;
}

double OverlapNoise::misfitOfShape() const {
  if (of_ != Of::Noise) return 0;
  double squares = 0, scaled = 0, noise = 0, degreesOfFreedom = 0, values = 0;
  for (const OverlapResiduals& overlap : overlaps_) {
    const double storage = overlap.storage.squares - overlap.storage.noiseSquares;
    const double loss = overlap.loss.squares - overlap.loss.noiseSquares;
    squares += storage + loss;
    scaled += (part(storage, storage_) + part(loss, loss_)) / std::max(1.0, ownScale(overlap));
    const double ofStorage = overlap.storage.degreesOfFreedom - overlap.storage.noiseFreedom;
    const double ofLoss = overlap.loss.degreesOfFreedom - overlap.loss.noiseFreedom;
    noise += ofStorage * storage_ + ofLoss * loss_;
    degreesOfFreedom += ofStorage + ofLoss;
    values += overlap.values;
  }
  if (!(degreesOfFreedom >= 1 && scaled > 0)) return 0;
  if (!(rarityOfMeanSquare(scaled / degreesOfFreedom, degreesOfFreedom, freedom_) < kRarity))
    return 0;
  return std::sqrt(std::max(0.0, squares - noise) / values);
}

bool OverlapNoise::areSignificant(const std::vector<double>& deviations) const {
  if (!(freedom_ >= 1)) return false;
  const double degreesOfFreedom = std::floor(freedom_);
  double largest = 0, squares = 0, count = 0;
  for (const double deviation : deviations) {
    if (deviation == 0) continue;
    largest = std::max(largest, std::abs(deviation));
    squares += deviation * deviation;
    ++count;
  }
  if (count == 0) return false;
  // Two tests share the allowed rarity.
  return count * (1 - studentProbability(largest, degreesOfFreedom)) < kRarity / 2 ||
         rarityOfMeanSquare(squares / count, count, degreesOfFreedom) < kRarity / 2;
}

namespace {

constexpr double kScanStep = 0.01;      // decades
constexpr double kMinOverlap = 0.15;    // decades that two isotherms must have in common, or a
constexpr double kMinPart = 0.25;       // quarter of the shorter one
constexpr double kMaxMismatch = 0.2;    // decades of modulus, beyond which nothing fits
constexpr double kEdgeMismatch = 0.02;  // the same where the overlap is the least allowed
constexpr int kComparisons = 33;        // frequencies at which two isotherms are compared
constexpr double kOpenVertical = 0.02;  // decades, error beyond which a vertical shift is open
constexpr double kWrongWay = 0.3;       // decades against the order of temperatures

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
              "temperatures are out of order, or the moduli change too little to tell; "
              "correct the column, or leave an isotherm out",
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
  const FittedShifts common = fitted.value_or(FittedShifts{{*start}, {0}});
  both.log10Shift = common.horizontal.value;
  both.standardError = common.horizontal.standardError;
  both.log10Vertical = common.vertical.value;
  both.verticalError = common.vertical.standardError;
  both.ofEntropy = common.ofExpected;
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
    return one ? one->horizontal : Estimate{};
  };
  found.storage = alone(ShiftModuli::Storage);
  found.loss = alone(ShiftModuli::Loss);
  checkOrder(cold, warm, both);
  return found;
}

}  // namespace asperity
