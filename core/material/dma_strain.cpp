#include "core/material/dma_strain.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/statistics.h"
#include "core/base/text_number.h"

namespace asperity {
namespace {

constexpr double kSame = 1.2;  // the ratio up to which two amplitudes count as one
constexpr double kLike = 1.5;  // the ratio up to which one is what a user means

/// Groups amplitudes that follow each other closely, in ascending order.
std::vector<std::vector<double>> groupAmplitudes(const std::vector<MeasuredModulus>& rows) {
  std::vector<double> strains;
  for (const MeasuredModulus& row : rows)
    if (std::isfinite(row.strainAmplitude)) strains.push_back(row.strainAmplitude);
  std::ranges::sort(strains);
  std::vector<std::vector<double>> groups;
  for (const double strain : strains) {
    if (groups.empty() || strain > kSame * groups.back().back()) groups.emplace_back();
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
  std::map<std::size_t, Span> spans;  // of the isotherm so far
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i > 0 && rows[i].temperature - rows[i - 1].temperature > tolerance) spans.clear();
    if (!std::isfinite(rows[i].strainAmplitude)) continue;
    const double frequency = rows[i].modulus.frequency;
    const std::size_t own = groupIndex(groups, rows[i].strainAmplitude);
    Span& span = spans.try_emplace(own, Span{frequency, frequency}).first->second;
    span = {std::min(span.from, frequency), std::max(span.to, frequency)};
    for (const auto& [group, other] : spans)
      if (group != own && other.from <= span.to && span.from <= other.to) return true;
  }
  return false;
}

std::string listAmplitudes(const std::vector<std::vector<double>>& groups) {
  std::string list;
  for (const std::vector<double>& group : groups)
    list += (list.empty() ? "" : ", ") + printedNumber(100 * upperMedian(group), 3) + " %";
  return list;
}

}  // namespace

std::optional<double> parseStrain(std::string_view text) {
  const auto quantity = parseQuantity(text);
  if (!quantity || !(quantity->unit.empty() || quantity->unit == "%")) return {};
  const double strain = quantity->unit.empty() ? quantity->number : quantity->number / 100;
  return strain > 0 && std::isfinite(strain) ? std::optional(strain) : std::nullopt;
}

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
    if (distance(*nearest) > std::log(kLike))
      throw InputError(
          "", "--strain",
          message("{} % was not measured; there is {}",
                  PrintedNumber{printedNumber(100 * *chosen, 3)}, listAmplitudes(groups)));
    const auto wanted = static_cast<std::size_t>(nearest - groups.begin());
    std::erase_if(rows, [&](const MeasuredModulus& row) {
      return !std::isfinite(row.strainAmplitude) ||
             groupIndex(groups, row.strainAmplitude) != wanted;
    });
    return upperMedian(*nearest);
  }
  if (groups.empty()) return std::numeric_limits<double>::quiet_NaN();
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
