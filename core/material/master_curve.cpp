#include "core/material/master_curve.h"

#include <algorithm>
#include <cmath>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/statistics.h"
#include "core/base/stop.h"
#include "core/material/temperature_shift.h"

namespace asperity {
namespace {

constexpr double kSimpleDifference = 0.1;  // decades, see isThermorheologicallySimple
constexpr double kSignificant = 3;         // standard errors of such a difference

/// Sums of the shifts of neighbours, counted from the reference temperature.
class Accumulated {
 public:
  Accumulated(std::span<const Isotherm> isotherms, double reference)
      : isotherms_(isotherms), reference_(reference) {}

  /// steps[i]: from isotherm i to the next warmer one. Errors are those of the steps between the
  /// reference and the isotherm; a step that contains the reference counts with its part.
  std::vector<ShiftEstimate> from(const std::vector<ShiftEstimate>& steps) const {
    std::vector<ShiftEstimate> sums(isotherms_.size());
    for (std::size_t i = 0; i < isotherms_.size(); ++i) {
      double value = 0, variance = 0;
      for (std::size_t k = 0; k < steps.size(); ++k) {
        const double part = partBetween(k, isotherms_[i].temperature);
        if (part == 0) continue;
        value += part * steps[k].value;
        variance += part * part * steps[k].error * steps[k].error;
      }
      sums[i] = {value, std::sqrt(variance)};
    }
    return sums;
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

/// Widens errors that are too small by chance, because a step left few residuals: one modulus
/// scatters at least as much in each step as in all of them together. kSignificant of the errors
/// are then as rare as of a known one.
void widenErrors(std::vector<ShiftEstimate>& steps) {
  double squares = 0;
  int freedom = 0;
  for (const ShiftEstimate& step : steps) {
    squares += step.squares;
    freedom += step.freedom;
  }
  if (freedom == 0) return;
  const double common = std::sqrt(squares / freedom);
  const double rarity = studentDeviations(kSignificant, freedom) / kSignificant;
  for (ShiftEstimate& step : steps)
    if (step.freedom > 0) step.error = rarity * std::max(step.error, step.sensitivity * common);
}

/// Moves the reference of the sums to the reference temperature. Between two isotherms the sums are
/// linear in T, which is exact at an isotherm. Where a formula fits all shifts, the reference is
/// moved to its value, which is exact for a formula that holds.
void moveReference(std::span<const Isotherm> isotherms, double reference,
                   std::vector<ShiftEstimate>& both, std::vector<ShiftEstimate>& storage,
                   std::vector<ShiftEstimate>& loss) {
  std::vector<ShiftPoint> table;
  for (std::size_t i = 0; i < isotherms.size(); ++i) {
    if (std::abs(isotherms[i].temperature - reference) <= kIsothermTolerance) return;
    table.push_back({isotherms[i].temperature, both[i].value});
  }
  const auto law = interpolatingFormula(table, reference);
  if (!law) return;
  for (auto* estimates : {&both, &storage, &loss})
    for (ShiftEstimate& estimate : *estimates) {
      estimate.value -= law->offset;
      estimate.error = std::hypot(estimate.error, law->rms);
    }
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

double differenceOf(const IsothermShift& shift) {
  return std::abs(shift.fromStorage - shift.fromLoss);
}

/// Returns whether the moduli ask for different shifts of an isotherm.
bool isDifferent(const IsothermShift& shift) {
  const double difference = differenceOf(shift);
  return std::isfinite(difference) && std::isfinite(shift.differenceError) &&
         difference > kSimpleDifference && difference > kSignificant * shift.differenceError;
}

void compareModuli(MasterCurve& curve) {
  for (const IsothermShift& shift : curve.shifts) {
    const double difference = differenceOf(shift);
    if (!std::isfinite(difference) || !std::isfinite(shift.differenceError)) continue;
    curve.largestDifference = std::max(curve.largestDifference, difference);
    if (isDifferent(shift)) curve.isThermorheologicallySimple = false;
  }
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
  std::vector<ShiftEstimate> both, vertical, storage, loss;
  for (std::size_t i = 0; i + 1 < isotherms.size(); ++i) {
    throwIfStopped(stop);
    const NeighbourShifts step = neighbourShifts(isotherms[i], isotherms[i + 1], isVertical);
    curve.overlaps.push_back(step.both);
    both.push_back({step.both.log10Shift, step.both.standardError});
    vertical.push_back({step.both.log10Vertical, step.both.verticalError});
    storage.push_back(step.storage);
    loss.push_back(step.loss);
    const double difference = std::abs(step.storage.value - step.loss.value);
    if (std::isfinite(difference)) curve.largestStep = std::max(curve.largestStep, difference);
  }
  widenErrors(storage);
  widenErrors(loss);
  const Accumulated sums(isotherms, referenceTemperature);
  auto horizontal = sums.from(both), ofStorage = sums.from(storage), ofLoss = sums.from(loss);
  const auto up = sums.from(vertical);
  moveReference(isotherms, referenceTemperature, horizontal, ofStorage, ofLoss);
  for (std::size_t i = 0; i < isotherms.size(); ++i)
    curve.shifts.push_back({isotherms[i].temperature, horizontal[i].value, horizontal[i].error,
                            up[i].value, ofStorage[i].value, ofLoss[i].value,
                            std::hypot(ofStorage[i].error, ofLoss[i].error)});
  addPoints(isotherms, curve);
  compareModuli(curve);
  return curve;
}

bool explainsDifferences(const MasterCurve& vertical, const MasterCurve& plain) {
  if (!vertical.isThermorheologicallySimple) return false;
  for (std::size_t i = 0; i < plain.shifts.size(); ++i) {
    const IsothermShift& shift = plain.shifts[i];
    if (!isDifferent(shift)) continue;
    const double explained = differenceOf(shift) - differenceOf(vertical.shifts[i]);
    if (!(explained > kSignificant * shift.differenceError)) return false;
  }
  return true;
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
