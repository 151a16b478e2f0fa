#include "core/material/prony_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/material/dma_columns.h"
#include "core/material/element_law.h"
#include "core/material/prony_fit.h"
#include "core/material/prony_keywords.h"
#include "core/material/prony_table.h"
#include "core/material/stated_temperature.h"

namespace asperity {
namespace {

void checkTerms(const RawSeries& series, const std::string& name) {
  if (series.terms.empty()) throw InputError(name, "", "holds no term of a Prony series");
  if (series.terms.size() > kMaxTerms)
    throw InputError(name, "",
                     message("has {} terms; allowed is {}", series.terms.size(), kMaxTerms));
  for (const RawSeries::Term& term : series.terms) {
    const std::string line = fmt::format("line {}", term.line);
    if (!(term.weight >= 0))
      throw InputError(name, line,
                       message("the modulus is {}, which must be at least 0", plain(term.weight)));
    constexpr double kLongest = 1e12;  // s
    if (!(term.time > 0 && term.time <= kLongest))
      throw InputError(
          name, line,
          message("the relaxation time is {} s, which must be above 0 and at most {} s",
                  plain(term.time), plain(kLongest)));
  }
  const double sum = series.totalWeight();
  if (series.isRelative && sum > 1 + 1e-6)
    throw InputError(
        name, "",
        message("the parts of the instantaneous modulus add up to {:.6g}, more than 1", sum));
}

/// Returns the unit of the moduli, Pa.
double unitOfModuli(const RawSeries& series, const PronyChoices& choices) {
  if (choices.modulusUnit.empty()) return series.unit;
  const auto chosen = unitSize(choices.modulusUnit, "Pa");
  if (!chosen)
    throw InputError(
        "", "--modulus-unit",
        notOneOf(choices.modulusUnit, std::vector<std::string_view>{"Pa", "kPa", "MPa", "GPa"}));
  return *chosen;
}

/// The moduli beside the arms, Pa; NaN where neither the file nor the user states one and none
/// follows.
struct EndModuli {
  double instantaneous = RawSeries::kNotStated, equilibrium = RawSeries::kNotStated;
};

/// A smaller part of a modulus is rounding.
constexpr double kLeastPart = 1e-9;

/// Returns the part of the instantaneous modulus that the arms leave.
double equilibriumPart(const RawSeries& series) {
  return std::max(0.0, 1 - series.totalWeight());
}

/// Returns the moduli that the user or else the file states, and the instantaneous one of parts.
/// unit: of the moduli in the file, Pa.
EndModuli endModuli(const RawSeries& series, double unit, const std::string& name,
                    const PronyChoices& choices) {
  EndModuli moduli{series.instantaneous * unit, series.equilibrium * unit};
  if (std::isfinite(choices.instantaneousModulus))
    moduli = {choices.instantaneousModulus, RawSeries::kNotStated};
  if (std::isfinite(choices.equilibriumModulus)) moduli.equilibrium = choices.equilibriumModulus;
  if (series.isRelative && !std::isfinite(moduli.instantaneous)) {
    if (!std::isfinite(moduli.equilibrium))
      throw InputError(name, series.material.empty() ? "" : "material " + series.material,
                       "has parts of a modulus and not the modulus itself; give the instantaneous "
                       "shear modulus with --instantaneous-modulus, or --equilibrium-modulus");
    if (!(equilibriumPart(series) > kLeastPart))
      throw InputError(name, "",
                       "has parts that add up to 1, so that its long-term modulus is 0; give "
                       "--instantaneous-modulus, and --liquid if that is meant");
    moduli.instantaneous = moduli.equilibrium / equilibriumPart(series);
  }
  if (std::isfinite(moduli.instantaneous) && !(moduli.instantaneous > 0))
    throw InputError(name, "instantaneous modulus", "is not above 0");
  return moduli;
}

/// Returns the stated equilibrium modulus, Pa, or else the one that the arms leave. Adds a note
/// where these contradict each other.
double equilibriumModulus(const RawSeries& series, double unit, const EndModuli& moduli,
                          std::vector<Message>& notes) {
  const auto [instantaneous, equilibrium] = moduli;
  const double part = equilibriumPart(series);
  const double left =
      series.isRelative ? instantaneous * part : instantaneous - series.totalWeight() * unit;
  if (!std::isfinite(equilibrium)) {
    if (series.isRelative && !(part > kLeastPart)) return 0;
    return std::isfinite(instantaneous) ? left : 0;
  }
  constexpr double kSame = 0.02;  // of the instantaneous modulus
  if (std::isfinite(instantaneous) && std::abs(left - equilibrium) > kSame * instantaneous)
    notes.push_back(
        message("the moduli contradict each other: the arms leave {} MPa of the instantaneous "
                "modulus, and an equilibrium modulus of {} MPa is stated, which is taken",
                printed(left / 1e6, 4), printed(equilibrium / 1e6, 4)));
  return equilibrium;
}

/// Returns the series in Pa, of shear.
PronyFile finished(const RawSeries& series, const std::string& name, const PronyChoices& choices) {
  checkTerms(series, name);
  const double unit = unitOfModuli(series, choices);
  const EndModuli moduli = endModuli(series, unit, name, choices);
  PronyFile file;
  file.format = series.format;
  file.shift = series.shift;
  file.temperature = series.temperature;
  file.notes = series.notes;
  const double ofWeights = series.isRelative ? moduli.instantaneous : unit;
  for (const RawSeries::Term& term : series.terms)
    if (term.weight > 0) file.arms.push_back({term.weight * ofWeights, term.time});
  if (file.arms.empty()) throw InputError(name, "", "has no arm with a modulus above 0");
  file.arms = joinedArms(std::move(file.arms));
  file.equilibriumModulus = equilibriumModulus(series, unit, moduli, file.notes);
  if (!choices.isLiquid && !(file.equilibriumModulus > 0))
    throw InputError(name, "equilibrium modulus",
                     "is not above 0, as of a liquid, which cannot carry a load for ever; give "
                     "--equilibrium-modulus, or allow it with --liquid");
  file.equilibriumModulus = std::max(0.0, file.equilibriumModulus);
  double stiffest = file.equilibriumModulus;
  for (const Arm& arm : file.arms) stiffest += arm.modulus;
  if (!series.isUnitKnown && choices.modulusUnit.empty())
    refuseSoftModulus(name, "modulus", stiffest);
  return file;
}

/// Reads arms that are named numbers, and a table of shift factors beside them.
std::optional<RawSeries> namedSeries(std::string_view text, const TextTable* table,
                                     const std::string& name, const PronyChoices& choices) {
  std::vector<TextBlock> shifts;
  const std::span<const TextBlock> blocks =
      table ? std::span(table->blocks) : std::span<const TextBlock>();
  for (const TextBlock& block : blocks) {
    if (isShiftTable(block)) {
      shifts.push_back(block);
      shifts.back().header.clear();  // its lines are read with the arms
    } else if (std::ranges::count(block.columns, false, &TextColumn::isText) > 1) {
      return {};  // a table of several numbers in each row is one of measurements
    }
  }
  auto arms = tableOfNamedArms(text, name);
  if (!arms) return {};
  std::ranges::move(shifts, std::back_inserter(arms->blocks));
  return tableSeries(std::move(*arms), name, choices);
}

}  // namespace

std::optional<PronyFile> readPronyFile(std::string_view text, const TextTable* table,
                                       const std::string& name, const PronyChoices& choices) {
  std::optional<RawSeries> series = keywordSeries(text, name, choices);
  if (!series && table) series = tableSeries(*table, name, choices);
  if (!series) series = namedSeries(text, table, name, choices);
  if (!series) return {};
  return finished(*series, name, choices);
}

}  // namespace asperity
