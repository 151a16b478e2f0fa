#include "core/material/master_curve.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/stop.h"
#include "core/material/joint_fit.h"
#include "core/material/temperature_shift.h"

namespace asperity {
namespace {

// See isThermorheologicallySimple.
constexpr double kSimpleDifference = 0.1;  // decades of frequency
constexpr double kSimpleMisfit = 0.002;    // decades of modulus, half a per cent

/// Sums of the shifts of neighbours, counted from the reference temperature.
class Accumulated {
 public:
  Accumulated(std::span<const Isotherm> isotherms, double reference)
      : isotherms_(isotherms), reference_(reference) {}

  /// steps[i]: from isotherm i to the next warmer one. Errors are those of the steps between the
  /// reference and the isotherm; a step that contains the reference counts with its part.
  std::vector<Estimate> from(const std::vector<Estimate>& steps) const {
    std::vector<Estimate> sums(isotherms_.size());
    for (std::size_t i = 0; i < isotherms_.size(); ++i) {
      double value = 0, variance = 0;
      for (std::size_t k = 0; k < steps.size(); ++k) {
        const double part = partBetween(k, isotherms_[i].temperature);
        if (part == 0) continue;
        value += part * steps[k].value;
        variance += part * part * steps[k].standardError * steps[k].standardError;
      }
      sums[i] = {value, std::sqrt(variance)};
    }
    return sums;
  }

  /// Returns the weights of the isotherms whose mean is the reference.
  std::vector<double> weights() const {
    std::vector<double> all(isotherms_.size(), 0);
    for (std::size_t k = 0; k + 1 < all.size(); ++k) {
      const double low = isotherms_[k].temperature, high = isotherms_[k + 1].temperature;
      if (reference_ < low || reference_ > high) continue;
      const double part = (reference_ - low) / (high - low);
      all[k] = 1 - part;
      all[k + 1] = part;
      break;
    }
    return all;
  }

 private:
  /// Returns the part of step k that lies between the temperature and the reference; negative above
  /// it.
  double partBetween(std::size_t k, double temperature) const {
    const double low = isotherms_[k].temperature, high = isotherms_[k + 1].temperature;
    const double from = std::clamp(temperature, low, high);
    const double to = std::clamp(reference_, low, high);
    return (to - from) / (high - low);
  }

  std::span<const Isotherm> isotherms_;
  double reference_;
};

/// Moves the reference of the sums to the reference temperature. Between two isotherms the sums are
/// linear in T, which is exact at an isotherm. Where a formula fits all shifts, the reference is
/// moved to its value, which is exact for a formula that holds.
void moveReference(std::span<const Isotherm> isotherms, double reference,
                   std::vector<Estimate>& both, std::vector<Estimate>& storage,
                   std::vector<Estimate>& loss) {
  std::vector<ShiftPoint> table;
  for (std::size_t i = 0; i < isotherms.size(); ++i) {
    if (std::abs(isotherms[i].temperature - reference) <= kIsothermTolerance) return;
    table.push_back({isotherms[i].temperature, both[i].value});
  }
  const auto law = interpolatingFormula(table, reference);
  if (!law) return;
  for (auto* estimates : {&both, &storage, &loss})
    for (Estimate& estimate : *estimates) {
      estimate.value -= law->offset;
      estimate.standardError = std::hypot(estimate.standardError, law->rms);
    }
}

/// Returns the shifts without lone jumps: a step that differs much from those beside it, per
/// kelvin, becomes their median. Moduli that ripple along a plateau also agree one ripple further
/// on.
std::vector<double> withoutJumps(std::span<const Isotherm> isotherms,
                                 const std::vector<double>& shifts) {
  constexpr double kJump = 0.5;  // decades
  constexpr std::ptrdiff_t kBeside = 3;
  std::vector<double> rates, smooth(shifts);
  const auto width = [&](std::size_t i) {
    return isotherms[i + 1].temperature - isotherms[i].temperature;
  };
  for (std::size_t i = 0; i + 1 < shifts.size(); ++i)
    rates.push_back((shifts[i + 1] - shifts[i]) / width(i));
  for (std::size_t i = 0; i < rates.size(); ++i) {
    const auto at = static_cast<std::ptrdiff_t>(i);
    const auto from = rates.begin() + std::max<std::ptrdiff_t>(0, at - kBeside);
    const auto to = rates.begin() + std::min<std::ptrdiff_t>(std::ssize(rates), at + kBeside + 1);
    const double usual = median({from, to});
    const bool isJump = std::abs(rates[i] - usual) * width(i) > kJump;
    smooth[i + 1] = smooth[i] + (isJump ? usual : rates[i]) * width(i);
  }
  return smooth;
}

/// Fits all isotherms together, also from a start without lone jumps. Of two fits that explain the
/// moduli as well, the one in which neighbours overlap more is right.
JointShifts fittedTogether(std::span<const Isotherm> isotherms, const std::vector<double>& start,
                           const std::vector<double>& weights, const std::stop_token& stop) {
  constexpr double kAsWell = 1.2;
  const std::vector<LogSweep> sweeps = logarithms(isotherms);
  const JointShifts plain = jointShifts(sweeps, start, weights, ShiftModuli::Both, stop);
  const std::vector<double> smooth = withoutJumps(isotherms, start);
  if (smooth == start) return plain;
  const JointShifts other = jointShifts(sweeps, smooth, weights, ShiftModuli::Both, stop);
  const bool isBetter =
      plain.shifts.empty() || (!other.shifts.empty() && other.noise < kAsWell * plain.noise);
  return isBetter ? other : plain;
}

/// Replaces the sums of the shifts of neighbours by the shifts of a joint fit of all isotherms
/// where these differ by more than the stated errors. Then the polynomials of neighbours do not
/// follow the moduli between the points, with an error of one sign at every step. Returns whether
/// it does.
bool refine(std::span<const Isotherm> isotherms, const std::vector<double>& weights,
            std::vector<Estimate>& both, std::vector<Estimate>& storage,
            std::vector<Estimate>& loss, const std::stop_token& stop) {
  constexpr double kClear = 2;  // standard errors
  if (isotherms.size() < 3) return false;
  std::vector<double> start;
  for (const Estimate& shift : both) start.push_back(shift.value);
  const std::vector<Estimate> joint = fittedTogether(isotherms, start, weights, stop).shifts;
  bool isClear = false;
  for (std::size_t i = 0; i < joint.size(); ++i) {
    const double error = both[i].standardError;
    isClear = isClear ||
              (std::isfinite(error) && std::abs(joint[i].value - both[i].value) > kClear * error);
  }
  if (!isClear) return false;
  both = joint;
  for (std::size_t i = 0; i < joint.size(); ++i) start[i] = joint[i].value;
  const std::vector<LogSweep> sweeps = logarithms(isotherms);
  for (const auto& [moduli, alone] :
       {std::pair(ShiftModuli::Storage, &storage), std::pair(ShiftModuli::Loss, &loss)}) {
    const JointShifts fitted = jointShifts(sweeps, start, weights, moduli, stop);
    if (!fitted.shifts.empty()) *alone = fitted.shifts;
  }
  return true;
}

void addPoints(std::span<const Isotherm> isotherms, MasterCurve& curve) {
  for (std::size_t i = 0; i < isotherms.size(); ++i) {
    const double factor = std::pow(10, curve.shifts[i].log10Shift);
    const double vertical = std::pow(10, curve.shifts[i].log10Vertical);
    for (const DynamicModulus& point : isotherms[i].points)
      curve.points.push_back(
          {{point.frequency * factor, point.storage / vertical, point.loss / vertical}, i});
  }
  std::ranges::stable_sort(curve.points, {},
                           [](const MasterPoint& point) { return point.modulus.frequency; });
}

/// Finds out whether one shift serves both moduli and all frequencies. The shifts of one modulus
/// from its flat side are noise; such pairs count as equal.
void compareModuli(const OverlapNoise& noise, const Accumulated& sums,
                   const std::vector<NeighbourShifts>& steps, MasterCurve& curve) {
  curve.shapeMisfit = noise.misfitOfShape();
  if (curve.shapeMisfit > kSimpleMisfit) curve.isThermorheologicallySimple = false;
  constexpr double kClear = 2;  // standard errors
  const std::vector<double> deviations = noise.deviations(&OverlapResiduals::difference);
  if (!noise.areSignificant(deviations)) return;
  std::vector<Estimate> differences;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double difference = steps[i].loss.value - steps[i].storage.value;
    const bool isClear = std::abs(deviations[i]) > kClear && std::isfinite(difference);
    differences.push_back({isClear ? difference : 0, 0});
    curve.largestStep = std::max(curve.largestStep, std::abs(differences.back().value));
  }
  for (const Estimate& sum : sums.from(differences))
    curve.largestDifference = std::max(curve.largestDifference, std::abs(sum.value));
  if (std::max(curve.largestStep, curve.largestDifference) > kSimpleDifference)
    curve.isThermorheologicallySimple = false;
}

/// Finds out what vertical shifts would change. Returns the changes of the steps; they are no
/// noise, and errors of the same sign add up from one isotherm to the next.
std::vector<Estimate> considerVertical(const OverlapNoise& noise,
                                       const std::vector<NeighbourShifts>& steps,
                                       VerticalEvidence& evidence) {
  std::vector<Estimate> changes(steps.size(), Estimate{0, 0});
  const std::vector<double> deviations = noise.deviations(&OverlapResiduals::vertical);
  evidence.isSignificant = noise.areSignificant(deviations);
  if (!evidence.isSignificant) return changes;
  double squares = 0, degreesOfFreedom = 0, explained = 0, count = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const OverlapResiduals& residuals = steps[i].residuals;
    squares += residuals.squares;
    degreesOfFreedom += residuals.degreesOfFreedom;
    if (!std::isfinite(residuals.vertical.value)) continue;
    explained += residuals.vertical.explained;
    ++count;
    changes[i].value = residuals.vertical.shiftChange;
    if (std::abs(deviations[i]) > 1)
      evidence.largestShift = std::max(evidence.largestShift, std::abs(residuals.vertical.value));
  }
  evidence.residual = std::sqrt(squares / degreesOfFreedom);
  evidence.residualWith =
      std::sqrt((squares - explained) / std::max(1.0, degreesOfFreedom - count));
  return changes;
}

}  // namespace

MasterCurve masterCurve(std::span<const Isotherm> isotherms, double referenceTemperature,
                        bool isVertical, const std::stop_token& stop) {
  if (isotherms.empty()) throw InputError("", "", "holds no isotherm");
  const double lowest = isotherms.front().temperature, highest = isotherms.back().temperature;
  if (!(referenceTemperature >= lowest && referenceTemperature <= highest))
    throw InputError(
        "", "--reference-temperature",
        message("{} K is outside of the measured temperatures, {} to {} K ({} to {}); "
                "a temperature may be written as 20C",
                referenceTemperature, PrintedNumber{printedDecimals(lowest, 2)},
                PrintedNumber{printedDecimals(highest, 2)}, celsius(lowest), celsius(highest)));
  MasterCurve curve;
  curve.referenceTemperature = referenceTemperature;
  std::vector<NeighbourShifts> steps;
  std::vector<OverlapResiduals> residuals;
  std::vector<Estimate> both, vertical, storage, loss, ofEntropy;
  for (std::size_t i = 0; i + 1 < isotherms.size(); ++i) {
    throwIfStopped(stop);
    const NeighbourShifts& step =
        steps.emplace_back(neighbourShifts(isotherms[i], isotherms[i + 1], isVertical));
    residuals.push_back(step.residuals);
    curve.overlaps.push_back(step.both);
    both.push_back({step.both.log10Shift, step.both.standardError});
    vertical.push_back({step.both.log10Vertical, step.both.verticalError});
    ofEntropy.push_back({step.both.ofEntropy, 0});
    storage.push_back(step.storage);
    loss.push_back(step.loss);
  }
  const OverlapNoise misfit(residuals, OverlapNoise::Of::Misfit);
  const OverlapNoise noise(residuals, OverlapNoise::Of::Noise);
  for (Estimate& step : both) step.standardError *= std::sqrt(misfit.correlation());
  const Accumulated sums(isotherms, referenceTemperature);
  auto horizontal = sums.from(both), ofStorage = sums.from(storage), ofLoss = sums.from(loss);
  const auto up = sums.from(vertical);
  const auto changes = sums.from(considerVertical(misfit, steps, curve.vertical));
  compareModuli(noise, sums, steps, curve);
  // A joint fit needs one curve.
  if (!isVertical && curve.isThermorheologicallySimple && !curve.vertical.isSignificant)
    curve.isFittedTogether = refine(isotherms, sums.weights(), horizontal, ofStorage, ofLoss, stop);
  moveReference(isotherms, referenceTemperature, horizontal, ofStorage, ofLoss);
  // A material that is not entropic differs from b_T ~ T by the same at every step.
  const auto assumed = sums.from(ofEntropy);
  for (std::size_t i = 0; i < isotherms.size(); ++i) {
    const double change = std::abs(changes[i].value);
    const double systematic = std::hypot(change, assumed[i].value);
    curve.vertical.largestChange = std::max(curve.vertical.largestChange, change);
    curve.shifts.push_back({isotherms[i].temperature, horizontal[i].value,
                            std::hypot(horizontal[i].standardError, systematic), up[i].value,
                            ofStorage[i].value, ofLoss[i].value});
  }
  addPoints(isotherms, curve);
  return curve;
}

double usualReference(std::span<const Isotherm> isotherms) {
  constexpr double kUsual = 298.15;  // K
  const double nearest = std::ranges::min_element(isotherms, {}, [](const Isotherm& isotherm) {
                           return std::abs(isotherm.temperature - kUsual);
                         })->temperature;
  const bool isWithin =
      kUsual >= isotherms.front().temperature && kUsual <= isotherms.back().temperature;
  return isWithin && std::abs(nearest - kUsual) <= kIsothermTolerance ? kUsual : nearest;
}

std::vector<ShiftPoint> shiftTable(const MasterCurve& curve) {
  std::vector<ShiftPoint> table;
  for (const IsothermShift& shift : curve.shifts)
    table.push_back({shift.temperature, shift.log10Shift});
  return table;
}

}  // namespace asperity
