#include "core/material/isotherms.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/statistics.h"
#include "core/base/text.h"
#include "core/base/units.h"
#include "core/material/temperature_drift.h"

namespace asperity {
namespace {

void checkModulus(const DynamicModulus& modulus) {
  // Nothing is measured beyond these limits, and sums would lose their digits.
  constexpr double kLowest = 1e-9, kHighest = 1e12;         // Hz
  constexpr double kMinModulus = 1e-3, kMaxModulus = 1e13;  // Pa
  if (!(modulus.frequency >= kLowest && modulus.frequency <= kHighest))
    throw InputError("", "frequency",
                     message("{} Hz is outside {} to {} Hz", plain(modulus.frequency),
                             plain(kLowest), plain(kHighest)));
  for (const double pascals : {modulus.storage, modulus.loss})
    if (!(pascals >= kMinModulus && pascals <= kMaxModulus))
      throw InputError(
          "", "modulus",
          message("{} is outside {} to {}; --modulus-unit says what the file means",
                  printed(pascals, "Pa"), printed(kMinModulus, "Pa"), printed(kMaxModulus, "Pa")));
}

/// Makes one sweep: it is sorted by frequency, and equal frequencies become their geometric mean.
MeasuredSweep gathered(std::vector<MeasuredModulus> rows) {
  std::ranges::stable_sort(rows, {},
                           [](const MeasuredModulus& row) { return row.modulus.frequency; });
  MeasuredSweep made;
  Isotherm& sweep = made.isotherm;
  double temperatures = 0;
  for (std::size_t i = 0; i < rows.size();) {
    std::size_t end = i;
    DynamicModulus least = rows[i].modulus, most = least;
    double frequency = 0, storage = 0, loss = 0, kelvins = 0;
    while (end < rows.size() &&
           rows[end].modulus.frequency <= rows[i].modulus.frequency * (1 + kSameFrequency)) {
      frequency += std::log(rows[end].modulus.frequency);
      storage += std::log(rows[end].modulus.storage);
      loss += std::log(rows[end].modulus.loss);
      temperatures += rows[end].temperature;
      kelvins += rows[end].temperature;
      least.storage = std::min(least.storage, rows[end].modulus.storage);
      least.loss = std::min(least.loss, rows[end].modulus.loss);
      most.storage = std::max(most.storage, rows[end].modulus.storage);
      most.loss = std::max(most.loss, rows[end].modulus.loss);
      ++end;
    }
    sweep.repeats += end - i - 1;
    sweep.repeatRatio =
        std::max({sweep.repeatRatio, most.storage / least.storage, most.loss / least.loss});
    const auto count = static_cast<double>(end - i);
    made.temperatures.push_back(kelvins / count);
    sweep.points.push_back(end - i == 1
                               ? rows[i].modulus
                               : DynamicModulus{std::exp(frequency / count),
                                                std::exp(storage / count), std::exp(loss / count)});
    i = end;
  }
  // Rounding may make the mean of equal temperatures another number.
  const auto [coldest, warmest] = std::ranges::minmax(rows, {}, &MeasuredModulus::temperature);
  sweep.temperature = coldest.temperature == warmest.temperature
                          ? coldest.temperature
                          : temperatures / static_cast<double>(rows.size());
  return made;
}

}  // namespace

std::vector<std::span<const MeasuredModulus>> sweepsOf(std::span<const MeasuredModulus> rows,
                                                       double tolerance) {
  std::vector<std::span<const MeasuredModulus>> sweeps;
  for (std::size_t begin = 0, end = 0; begin < rows.size(); begin = end) {
    for (++end;
         end < rows.size() && rows[end].temperature - rows[end - 1].temperature <= tolerance;)
      ++end;
    sweeps.push_back(rows.subspan(begin, end - begin));
  }
  return sweeps;
}

std::vector<Isotherm> groupIsotherms(std::vector<MeasuredModulus> rows, double tolerance) {
  if (rows.empty()) throw InputError("", "", "holds no row of frequency and moduli");
  for (const MeasuredModulus& row : rows) checkModulus(row.modulus);
  std::ranges::stable_sort(rows, {}, &MeasuredModulus::temperature);
  std::vector<MeasuredSweep> sweeps;
  for (const std::span<const MeasuredModulus> ofSweep : sweepsOf(rows, tolerance)) {
    sweeps.push_back(gathered({ofSweep.begin(), ofSweep.end()}));
    const double coldest = ofSweep.front().temperature, warmest = ofSweep.back().temperature;
    // A slow temperature ramp has no gaps, and all its sweeps would become one.
    const bool isWide = warmest - coldest > kWideSweep * tolerance;
    const Isotherm& sweep = sweeps.back().isotherm;
    if (isWide || sweep.points.size() < 2) {
      std::vector<Isotherm> ofRamp = isothermsOfRamp(rows, tolerance);
      if (!ofRamp.empty()) return ofRamp;
    }
    if (isWide)
      throw InputError("", "temperature",
                       message("runs from {} to {} without a gap of more than {} K; sweeps at "
                               "constant temperatures are needed (--temperature-tolerance says how "
                               "far the rows of one sweep may lie apart)",
                               celsius(coldest), celsius(warmest), tolerance));
    if (sweep.points.size() < 2)
      throw InputError(
          "", "frequency",
          message("there is one frequency alone at {}, {} Hz; a shift needs sweeps of at "
                  "least two frequencies at each temperature (--temperature-tolerance says how far "
                  "the rows of one sweep may lie apart)",
                  celsius(sweep.temperature), sweep.points.front().frequency));
  }
  removeDrift(sweeps, tolerance);
  std::vector<Isotherm> isotherms;
  for (MeasuredSweep& sweep : sweeps) isotherms.push_back(std::move(sweep.isotherm));
  return isotherms;
}

// ---- Strain amplitudes --------------------------------------------------------------------------

namespace {

constexpr double kLikeStrain = 1.5;  // the ratio up to which one is what a user means

/// Groups amplitudes that follow each other closely, in ascending order.
std::vector<std::vector<double>> groupAmplitudes(const std::vector<MeasuredModulus>& rows) {
  std::vector<double> strains;
  for (const MeasuredModulus& row : rows)
    if (std::isfinite(row.strainAmplitude)) strains.push_back(row.strainAmplitude);
  std::ranges::sort(strains);
  std::vector<std::vector<double>> groups;
  for (const double strain : strains) {
    if (groups.empty() || strain > kSameStrain * groups.back().back()) groups.emplace_back();
    groups.back().push_back(strain);
  }
  return groups;
}

std::size_t groupIndex(const std::vector<std::vector<double>>& groups, double strain) {
  const auto found = std::ranges::find_if(
      groups, [strain](const std::vector<double>& group) { return strain <= group.back(); });
  return static_cast<std::size_t>(found - groups.begin());
}

/// Returns whether two groups have frequencies in common at one temperature.
bool areMixed(std::vector<MeasuredModulus> rows, const std::vector<std::vector<double>>& groups,
              double tolerance) {
  struct Span {
    double from, to;
  };
  std::ranges::sort(rows, {}, &MeasuredModulus::temperature);
  for (const std::span<const MeasuredModulus> sweep : sweepsOf(rows, tolerance)) {
    std::map<std::size_t, Span> spans;  // of the sweep so far
    for (const MeasuredModulus& row : sweep) {
      if (!std::isfinite(row.strainAmplitude)) continue;
      const double frequency = row.modulus.frequency;
      const std::size_t own = groupIndex(groups, row.strainAmplitude);
      Span& span = spans.try_emplace(own, Span{frequency, frequency}).first->second;
      span = {std::min(span.from, frequency), std::max(span.to, frequency)};
      for (const auto& [group, other] : spans)
        if (group != own && other.from <= span.to && span.from <= other.to) return true;
    }
  }
  return false;
}

std::string listAmplitudes(const std::vector<std::vector<double>>& groups) {
  std::string list;
  for (const std::vector<double>& group : groups)
    appendItem(list, printedNumber(100 * upperMedian(group), 3) + " %");
  return list;
}

}  // namespace

double chooseStrain(std::vector<MeasuredModulus>& rows, std::optional<double> chosen,
                    double tolerance, const std::string& name) {
  const std::vector<std::vector<double>> groups = groupAmplitudes(rows);
  if (chosen) {
    if (groups.empty())
      throw InputError("", "--strain", message("{} states no strain amplitude", name));
    const auto distance = [&](const std::vector<double>& group) {
      return std::abs(std::log(upperMedian(group) / *chosen));
    };
    const auto nearest = std::ranges::min_element(groups, {}, distance);
    if (distance(*nearest) > std::log(kLikeStrain))
      throw InputError("", "--strain",
                       message("{} % was not measured; there is {}", printed(100 * *chosen, 3),
                               listAmplitudes(groups)));
    const auto wanted = static_cast<std::size_t>(nearest - groups.begin());
    std::erase_if(rows, [&](const MeasuredModulus& row) {
      return !std::isfinite(row.strainAmplitude) ||
             groupIndex(groups, row.strainAmplitude) != wanted;
    });
    return upperMedian(*nearest);
  }
  if (groups.empty()) return kNaN;
  if (groups.size() > 1 && areMixed(rows, groups, tolerance))
    throw InputError(name, "strain",
                     message("differs between sweeps at one temperature, and so do the moduli "
                             "(Payne effect); choose one amplitude with --strain: {}",
                             listAmplitudes(groups)));
  std::vector<double> strains;
  for (const std::vector<double>& group : groups)
    strains.insert(strains.end(), group.begin(), group.end());
  return upperMedian(std::move(strains));
}

}  // namespace asperity
