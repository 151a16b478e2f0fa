#include "core/material/prony_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/text.h"
#include "core/base/text_number.h"
#include "core/material/dma_columns.h"
#include "core/material/element_law.h"
#include "core/material/prony_keywords.h"

namespace asperity {
namespace {

// ---- A table -----------------------------------------------------------------------------------

/// Returns a name in lower case, without blanks and marks and with "inf" and "tau" for the signs of
/// infinity and tau: "ginf" for "G_∞".
std::string plainWord(std::string_view text) {
  std::string word = lowerCase(text);
  for (const std::string_view infinity : {"\u221E", "infinity", "infty"})
    replaceAll(word, infinity, "inf");
  for (const std::string_view tau : {"\u03C4", "\u03A4"}) replaceAll(word, tau, "tau");
  std::erase_if(word, [](char letter) {
    return letter == ' ' || letter == '_' || letter == '-' || letter == '.' || letter == '{' ||
           letter == '}' || letter == '(' || letter == ')';
  });
  return word;
}

/// Returns whether a plain word names the equilibrium modulus.
bool isEquilibrium(const std::string& word) {
  return isOneOf(word, {"ginf", "einf", "equilibriummodulus", "longtermmodulus", "rubberymodulus",
                        "ge", "ee", "gequilibrium", "inf"});
}

bool isInstantaneous(const std::string& word) {
  return isOneOf(word, {"g0", "e0", "instantaneousmodulus", "shorttermmodulus", "glassymodulus",
                        "gglassy", "eglassy"});
}

std::optional<RawSeries> tableSeries(const TextTable& table, const std::string& name,
                                     const PronyChoices& choices) {
  const TextBlock& block = table.largest();
  constexpr auto kNone = static_cast<std::size_t>(-1);
  std::size_t timeAt = kNone, weightAt = kNone;
  for (std::size_t i = 0; i < block.columns.size(); ++i) {
    const std::string word = plainWord(block.columns[i].name);
    if (dmaColumn(block.columns[i].name, block.columns[i].unit).quantity == DmaQuantity::Frequency)
      return {};
    if (timeAt == kNone && (word.starts_with("tau") || word.starts_with("relaxationtime") ||
                            word.starts_with("relaxationszeit") || isOneOf(word, {"ti", "times"})))
      timeAt = i;
    else if (weightAt == kNone &&
             (isOneOf(word, {"g", "gi", "e", "ei", "modulus", "moduli", "alpha", "alphai", "gimod",
                             "shearmodulus", "relativemodulus", "gi/g0", "ei/e0", "g/g0", "e/e0",
                             "gk", "ek"})))
      weightAt = i;
  }
  if (timeAt == kNone && weightAt == kNone) return {};
  // No table of dynamic moduli has a relaxation time or a modulus with an index.
  if (timeAt == kNone || weightAt == kNone) {
    const std::string& known = block.columns[timeAt == kNone ? weightAt : timeAt].name;
    const std::string word = plainWord(known);
    if (timeAt == kNone && !isOneOf(word, {"gi", "ei", "gi/g0", "ei/e0", "gk", "ek"})) return {};
    throw InputError(name, known,
                     timeAt == kNone
                         ? Message("looks like the moduli of a Prony series, but there is no "
                                   "column of relaxation times; such a table has columns as tau "
                                   "(s) and G (MPa), or g_i for parts of the instantaneous modulus")
                         : Message("looks like the relaxation times of a Prony series, but there "
                                   "is no column of moduli; such a table has columns as tau (s) "
                                   "and G (MPa), or g_i for parts of the instantaneous modulus"));
  }

  RawSeries series;
  series.format = "a table of relaxation times and moduli";
  const TextColumn& weights = block.columns[weightAt];
  const auto pressure = unitSize(weights.unit, "Pa");
  series.isUnitKnown = pressure.has_value();
  if (pressure) series.unit = *pressure;
  const double timeSize = unitSize(block.columns[timeAt].unit, "s").value_or(1);

  ModulusKind kind = choices.modulus;
  if (kind == ModulusKind::Unknown)
    kind = plainWord(weights.name).starts_with("e") ? ModulusKind::Tension : ModulusKind::Shear;
  const double shear = kind == ModulusKind::Tension ? shearFromYoungs(1, choices.poissonRatio) : 1;

  // A row without a relaxation time, or with an infinite one, is the equilibrium modulus.
  double sum = 0, largest = 0;
  for (std::size_t row = 0; row < block.rows; ++row) {
    const double time = block.at(row, timeAt), weight = block.at(row, weightAt);
    if (!std::isfinite(weight)) continue;
    if (!std::isfinite(time)) {
      series.equilibrium = weight * shear;
      continue;
    }
    series.terms.push_back({weight, time * timeSize, block.lines[row]});
    sum += weight;
    largest = std::max(largest, weight);
  }
  for (const TextEntry& entry : block.header)
    if (const auto quantity = parseQuantity(entry.value)) {
      const std::string word = plainWord(entry.key);
      const double size = unitSize(quantity->unit, "Pa").value_or(series.unit) / series.unit;
      if (isEquilibrium(word)) series.equilibrium = quantity->number * size * shear;
      if (isInstantaneous(word)) series.instantaneous = quantity->number * size * shear;
    }
  // Parts of the instantaneous modulus have no unit, and their sum is at most 1.
  series.isRelative = !series.isUnitKnown && largest < 1 && sum <= 1 + 1e-6;
  if (!series.isRelative)
    for (RawSeries::Term& term : series.terms) term.weight *= shear;
  if (series.isRelative && std::isfinite(series.equilibrium) && series.equilibrium < shear)
    series.equilibrium = RawSeries::kNotStated;  // a part, too: what is left of 1
  if (series.terms.empty()) throw InputError(name, "", "holds no relaxation time");
  return series;
}

// ---- All ---------------------------------------------------------------------------------------

void checkTerms(const RawSeries& series, const std::string& name) {
  if (series.terms.empty()) throw InputError(name, "", "holds no term of a Prony series");
  constexpr std::size_t kMostTerms = 64;
  if (series.terms.size() > kMostTerms)
    throw InputError(name, "",
                     message("has {} terms; allowed is {}", series.terms.size(), kMostTerms));
  double sum = 0;
  for (const RawSeries::Term& term : series.terms) {
    const std::string line = fmt::format("line {}", term.line);
    if (!(term.weight >= 0))
      throw InputError(name, line,
                       message("the modulus is {}, which must be at least 0", plain(term.weight)));
    if (!(term.time > 0 && term.time <= 1e12))
      throw InputError(
          name, line,
          message("the relaxation time is {} s, which must be above 0", plain(term.time)));
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
