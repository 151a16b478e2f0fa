#include "core/material/prony_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/material/dma_columns.h"
#include "core/material/element_law.h"
#include "core/material/prony_keywords.h"
#include "core/material/prony_table.h"

namespace asperity {
namespace {

void checkTerms(const RawSeries& series, const std::string& name) {
  if (series.terms.empty()) throw InputError(name, "", "holds no term of a Prony series");
  constexpr std::size_t kMaxTerms = 64;
  if (series.terms.size() > kMaxTerms)
    throw InputError(name, "",
                     message("has {} terms; allowed is {}", series.terms.size(), kMaxTerms));
  double sum = 0;
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
    sum += term.weight;
  }
  if (series.isRelative && sum > 1 + 1e-6)
    throw InputError(
        name, "",
        message("the parts of the instantaneous modulus add up to {:.6g}, more than 1", sum));
}

PronyFile finished(const RawSeries& series, const std::string& name, const PronyChoices& choices) {
  checkTerms(series, name);
  double unit = series.unit;
  if (!choices.modulusUnit.empty()) {
    const auto chosen = unitSize(choices.modulusUnit, "Pa");
    if (!chosen)
      throw InputError(
          "", "--modulus-unit",
          notOneOf(choices.modulusUnit, std::vector<std::string_view>{"Pa", "kPa", "MPa", "GPa"}));
    unit = *chosen;
  }
  double sum = 0;
  for (const RawSeries::Term& term : series.terms) sum += term.weight;
  double equilibrium = series.equilibrium * unit, instantaneous = series.instantaneous * unit;
  if (std::isfinite(choices.instantaneousModulus)) {
    instantaneous = choices.instantaneousModulus;
    equilibrium = RawSeries::kNotStated;
  }
  if (std::isfinite(choices.equilibriumModulus)) equilibrium = choices.equilibriumModulus;
  if (series.isRelative && !std::isfinite(instantaneous) && !std::isfinite(equilibrium))
    throw InputError(name, series.material.empty() ? "" : "material " + series.material,
                     "has parts of a modulus and not the modulus itself; give the instantaneous "
                     "shear modulus with --instantaneous-modulus, or --equilibrium-modulus");
  const double rest = std::max(0.0, 1 - sum);
  if (series.isRelative && !std::isfinite(instantaneous)) {
    if (!(rest > 1e-9))
      throw InputError(name, "",
                       "has parts that add up to 1, so that its long-term modulus is 0; give "
                       "--instantaneous-modulus, and --liquid if that is meant");
    instantaneous = equilibrium / rest;
  }
  if (std::isfinite(instantaneous) && !(instantaneous > 0))
    throw InputError(name, "instantaneous modulus", "is not above 0");
  PronyFile file;
  file.format = series.format;
  file.shift = series.shift;
  file.temperature = series.temperature;
  file.notes = series.notes;
  for (const RawSeries::Term& term : series.terms)
    if (term.weight > 0)
      file.arms.push_back({term.weight * (series.isRelative ? instantaneous : unit), term.time});
  if (file.arms.empty()) throw InputError(name, "", "has no arm with a modulus above 0");
  file.arms = joinedArms(std::move(file.arms));
  if (std::isfinite(equilibrium) && std::isfinite(instantaneous)) {
    const double left = series.isRelative ? instantaneous * rest : instantaneous - sum * unit;
    constexpr double kSame = 0.02;  // of the instantaneous modulus
    if (std::abs(left - equilibrium) > kSame * instantaneous)
      file.notes.push_back(
          message("the moduli contradict each other: the arms leave {} MPa of the instantaneous "
                  "modulus, and an equilibrium modulus of {} MPa is stated, which is taken",
                  PrintedNumber{printedNumber(left / 1e6, 4)},
                  PrintedNumber{printedNumber(equilibrium / 1e6, 4)}));
  }
  if (std::isfinite(equilibrium))
    file.equilibriumModulus = equilibrium;
  else if (series.isRelative)
    file.equilibriumModulus = instantaneous * (rest > 1e-9 ? rest : 0);
  else if (std::isfinite(instantaneous))
    file.equilibriumModulus = instantaneous - sum * unit;
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

}  // namespace

std::optional<PronyFile> readPronyFile(std::string_view text, const TextTable* table,
                                       const std::string& name, const PronyChoices& choices) {
  std::optional<RawSeries> series = keywordSeries(text, name, choices);
  if (!series && table) series = tableSeries(*table, name, choices);
  if (!series) return {};
  return finished(*series, name, choices);
}

}  // namespace asperity
