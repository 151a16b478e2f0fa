#include "core/material/prony_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/text.h"
#include "core/base/text_header.h"
#include "core/base/text_number.h"
#include "core/material/dma_columns.h"
#include "core/material/element_law.h"
#include "core/material/isotherms.h"
#include "core/material/prony_keywords.h"
#include "core/material/stated_temperature.h"

namespace asperity {
namespace {

// ---- A table -----------------------------------------------------------------------------------

/// Returns a name as compactName does, with "inf" and "tau" for the signs of infinity and tau:
/// "ginf" for "G_∞".
std::string seriesWord(std::string_view text) {
  std::string word = compactName(text);
  for (const std::string_view infinity : WordList("\u221E infinity infty"))
    replaceAll(word, infinity, "inf");
  for (const std::string_view tau : WordList("\u03C4 \u03A4")) replaceAll(word, tau, "tau");
  return word;
}

/// Returns whether a plain word names the equilibrium modulus.
bool isEquilibrium(const std::string& word) {
  return isOneOf(word,
                 "ginf einf equilibriummodulus longtermmodulus rubberymodulus ge ee gequilibrium "
                 "eequilibrium inf longtermmodulusg longtermmoduluse equilibriummodulusg "
                 "equilibriummoduluse");
}

bool isInstantaneous(const std::string& word) {
  return isOneOf(word,
                 "g0 e0 instantaneousmodulus shorttermmodulus glassymodulus gglassy eglassy ginst "
                 "einst ginstantaneous einstantaneous");
}

/// Returns the plain name of a column of moduli without the words around its letter: "g" for
/// "Schubmodul G", "ei" for "Young's modulus E_i". A name of such words alone stays.
std::string modulusLetter(std::string_view name) {
  const std::string whole = seriesWord(name);
  std::string word = whole;
  for (const std::string_view part :
       WordList("young's youngs young shear tensile relaxations relaxation schub zug elastizitaets "
                "moduli modulus modul of"))
    replaceAll(word, part, "");
  return word.empty() ? whole : word;
}

/// Returns the kind of modulus that a plain word names: "e0", "einf", "gi", "youngsmodulus".
ModulusKind kindOf(const std::string& word) {
  if (word.find("young") != word.npos || word.find("tensile") != word.npos)
    return ModulusKind::Tension;
  if (word.starts_with("zug")) return ModulusKind::Tension;
  if (word.find("shear") != word.npos || word.find("schub") != word.npos) return ModulusKind::Shear;
  if (word.starts_with("e") && !word.starts_with("equilibrium")) return ModulusKind::Tension;
  if (word.starts_with("g") && !word.starts_with("glassy")) return ModulusKind::Shear;
  return ModulusKind::Unknown;
}

/// A modulus that the lines above a table state.
struct StatedModulus {
  double number = 0;
  std::string unit{};
  ModulusKind kind = ModulusKind::Unknown;
  bool isInstantaneous = false;
  std::string key{};
};

/// Reads "E0 = 600 MPa", "Young's modulus E_inf: 3 MPa", "G_inf (MPa): 1".
std::optional<StatedModulus> statedModulus(std::string_view clause) {
  const auto statement = parseStatement(clause);
  if (!statement) return {};
  const std::string& name = statement->name.name;
  const std::string whole = seriesWord(name);
  std::string word = whole;
  for (const std::string_view kind : WordList("young's youngs young shear tensile"))
    replaceAll(word, kind, "");
  if (!isEquilibrium(word) && !isInstantaneous(word))
    word = seriesWord(std::string_view(name).substr(name.find_last_of(' ') + 1));
  if (!isEquilibrium(word) && !isInstantaneous(word)) return {};
  const ModulusKind ofWord = kindOf(word);
  return StatedModulus{statement->quantity.number, statement->unit(),
                       ofWord == ModulusKind::Unknown ? kindOf(whole) : ofWord,
                       isInstantaneous(word), statement->key};
}

/// Returns the size of a unit of modulus in Pa; what stands behind it in a header does not count:
/// "3 MPa (at 20 °C)". Throws InputError where it is none.
double modulusSize(const std::string& unit, const std::string& name, const std::string& key) {
  for (const std::string_view text :
       {std::string_view(unit), withoutBrackets(unit),
        std::string_view(unit).substr(0, unit.find_first_of(" ,;(["))})
    if (const auto size = unitSize(text, "Pa")) return *size;
  throw InputError(
      name, key,
      message("has the unit {}, which is not one of {}", shortened(unit), unitNames("Pa")));
}

/// Returns the size of a unit of time in s; nothing where it is none.
std::optional<double> timeSize(std::string_view unit) {
  const std::string word = lowerCase(unit);
  if (isOneOf(word, "second seconds sekunde sekunden")) return 1;
  if (isOneOf(word, "msec millisecond milliseconds")) return 1e-3;
  if (isOneOf(word, "usec \u00B5sec \u03BCsec microsecond microseconds")) return 1e-6;
  if (isOneOf(word, "minute minutes minuten")) return 60;
  if (isOneOf(word, "hr hrs hour hours stunde stunden")) return 3600;
  if (isOneOf(word, "d day days tag tage")) return 86400;
  return unitSize(unit, "s");
}

/// Returns the size in s of the unit of a column of relaxation times. A text in brackets, or behind
/// a stroke, at the end of its name is a unit, too. Throws InputError where it is not known; adds a
/// note where there is none.
double timeSizeOf(const TextColumn& column, const std::string& name, RawSeries& series) {
  std::string unit = column.unit;
  if (unit.empty())
    if (const std::size_t begin = column.name.find_last_of("([/");
        begin != std::string::npos && begin > 0) {
      unit = withoutBrackets(trimmedBlanks(std::string_view(column.name).substr(begin)));
      if (unit.starts_with('/')) unit = trimmedBlanks(unit.substr(1));
    }
  const std::string word = seriesWord(unit);
  // "tau (relaxation time)"
  const bool isName = word.starts_with("tau") || word.starts_with("relaxation");
  if (word.empty() || isName) {
    series.notes.push_back(
        message("{} has no unit: seconds are assumed", Message::name(column.name)));
    return 1;
  }
  if (const auto size = timeSize(unit)) return *size;
  throw InputError(name, column.name,
                   message("has the unit {}, which is not one of {}", shortened(unit),
                           "s, ms, \u00B5s, min, h, days"));
}

/// Returns the kind of moduli of a series. The user's word precedes the file's; without both they
/// are of shear, which a note says.
ModulusKind kindOfSeries(ModulusKind stated, const PronyChoices& choices, RawSeries& series) {
  if (choices.modulus != ModulusKind::Unknown) return choices.modulus;
  if (stated != ModulusKind::Unknown) return stated;
  series.notes.push_back(
      "the file does not say of which kind its moduli are: shear is assumed; --modulus tension "
      "says otherwise");
  return ModulusKind::Shear;
}

/// Reads the temperature and the shift that a table states. The user's temperature precedes, and is
/// that of a shift without a reference.
void readTemperature(const TextTable& table, const TextBlock& block, const std::string& name,
                     const PronyChoices& choices, RawSeries& series) {
  series.temperature = choices.temperature;
  std::optional<double> reference = choices.temperature;
  try {
    const auto stated = statedTemperature(table, block, name, choices.temperatureUnit, true);
    const auto inFile = stated ? std::optional(stated->kelvin) : std::nullopt;
    if (!choices.temperature) series.temperature = inFile;
    if (!choices.temperature && stated)
      series.notes.push_back(message("temperature: {} (line {}: {})", celsius(stated->kelvin),
                                     stated->line, Message::name(shortened(stated->text))));
    constexpr double kSame = 1e-6;  // K, of converted degrees
    if (inFile && !(reference && std::abs(*inFile - *reference) < kSame)) reference = inFile;
  } catch (const InputError&) {
    if (!choices.temperature) throw;
  }
  if (!reference) return;
  StatedShift stated = statedShift(table, *reference, name, choices.temperatureUnit);
  series.shift = std::move(stated.shift);
  std::ranges::move(stated.notes, std::back_inserter(series.notes));
}

/// Returns the moduli that the lines around the table of a series state: above and below it, and
/// above a table of shift factors. Other tables have headers of their own.
std::vector<StatedModulus> statedModuli(const TextTable& table, const TextBlock& block) {
  const bool isOnly = std::ranges::all_of(
      table.blocks, [&block](const TextBlock& one) { return &one == &block || isShiftTable(one); });
  std::vector<StatedModulus> found;
  const auto read = [&found](const std::vector<TextEntry>& entries) {
    for (const TextEntry& entry : entries) {
      const std::string line = lineOf(entry);
      for (const std::string_view clause : clausesOf(line))
        if (auto stated = statedModulus(clause)) found.push_back(std::move(*stated));
    }
  };
  for (const TextBlock& one : table.blocks)
    if (isOnly || &one == &block) read(one.header);
  if (isOnly) read(table.trailer);
  return found;
}

/// Returns whether the sum of the arms fits a stated modulus: they leave something of the
/// instantaneous one, and an equilibrium modulus is between 1e-5 of theirs and 30 times theirs.
bool fitsStated(double sum, double stated, bool isInstantaneous) {
  const double ratio = sum / stated;
  return isInstantaneous ? ratio >= 0.01 && ratio <= 1.02 : ratio >= 0.03 && ratio <= 1e5;
}

/// Gives moduli without a unit one where others have one: that of the others, or Pa, whichever
/// alone makes both fit, which a note says. Throws InputError where neither or both would.
/// sum: of the numbers of the arms.
void assumeUnits(const TextColumn& weights, double sum, std::vector<StatedModulus>& stated,
                 const std::string& name, RawSeries& series) {
  if (series.isRelative) return;
  const auto note = [&series](const std::string& key, const std::string& unit) {
    series.notes.push_back(message("{} has no unit: {} is assumed, which fits the other moduli",
                                   Message::name(key), Message::name(unit)));
  };
  for (StatedModulus& one : stated) {
    if (one.number == 0 || one.unit.empty() == !series.isUnitKnown) continue;
    if (series.isUnitKnown) {
      const bool inOthers = fitsStated(sum, one.number, one.isInstantaneous);
      const bool inPascals = fitsStated(sum * series.unit, one.number, one.isInstantaneous);
      if (series.unit != 1 && inOthers == inPascals)
        throw InputError(name, one.key,
                         message("has no unit, and {} is in {}; write its unit behind the number",
                                 Message::name(weights.name), Message::name(weights.unit)));
      one.unit = inOthers ? weights.unit : "Pa";
      note(one.key, one.unit);
      continue;
    }
    const double size = modulusSize(one.unit, name, one.key);
    const bool inOthers = fitsStated(sum, one.number, one.isInstantaneous);
    const bool inPascals = fitsStated(sum, one.number * size, one.isInstantaneous);
    // Small letters are those of parts, which may be in per cent.
    const bool isPart = weights.name.starts_with('g') || weights.name.starts_with('e');
    if (size != 1 && (inOthers == inPascals || (isPart && inOthers)))
      throw InputError(
          name, weights.name,
          message("has no unit, and {} is in {}; say with --modulus-unit which unit both have",
                  Message::name(one.key), Message::name(one.unit)));
    series.unit = inOthers ? size : 1;
    series.isUnitKnown = true;
    note(weights.name, inOthers ? std::string(withoutBrackets(one.unit)) : "Pa");
    return;
  }
}

std::optional<RawSeries> tableSeries(const TextTable& table, const std::string& name,
                                     const PronyChoices& choices) {
  const TextBlock* largest = nullptr;
  for (const TextBlock& one : table.blocks)
    if (!isShiftTable(one) && (!largest || one.values.size() > largest->values.size()))
      largest = &one;
  if (!largest) return {};
  const TextBlock& block = *largest;
  constexpr auto kNone = static_cast<std::size_t>(-1);
  std::size_t timeAt = kNone, weightAt = kNone;
  for (std::size_t i = 0; i < block.columns.size(); ++i) {
    const std::string word = seriesWord(block.columns[i].name);
    if (dmaColumn(block.columns[i].name, block.columns[i].unit).quantity == DmaQuantity::Frequency)
      return {};
    if (timeAt == kNone &&
        (word.starts_with("tau") || word.starts_with("relaxationtime") ||
         word.starts_with("relaxationszeit") || word.starts_with("tempsderelax") ||
         isOneOf(word, "ti times lambda lambdai beta betai")))
      timeAt = i;
    else if (weightAt == kNone &&
             (isOneOf(modulusLetter(block.columns[i].name), "g gi e ei") ||
              isOneOf(word,
                      "g gi e ei modulus moduli alpha alphai gimod shearmodulus relativemodulus "
                      "gi/g0 ei/e0 g/g0 e/e0 gk ek")))
      weightAt = i;
  }
  if (timeAt == kNone && weightAt == kNone) return {};
  // No table of dynamic moduli has a relaxation time or a modulus with an index.
  if (timeAt == kNone || weightAt == kNone) {
    const std::string& known = block.columns[timeAt == kNone ? weightAt : timeAt].name;
    const std::string word = seriesWord(known);
    if (timeAt == kNone && !isOneOf(word, "gi ei gi/g0 ei/e0 gk ek")) return {};
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
  const bool isPercent = weights.unit == "%";
  const bool hasUnit = !weights.unit.empty() && weights.unit != "-" && weights.unit != "1";
  if (hasUnit && !isPercent) series.unit = modulusSize(weights.unit, name, weights.name);
  series.isUnitKnown = hasUnit && !isPercent;
  // The rates of LS-DYNA are 1/tau.
  const TextColumn& times = block.columns[timeAt];
  const bool isRate = seriesWord(times.name).starts_with("beta");
  if (isRate && (times.unit.empty() || !frequencyUnit(times.unit, true)))
    throw InputError(name, times.name,
                     "may be a rate or a time; write its unit, as 1/s, behind the name");
  const double time = isRate ? 1 : timeSizeOf(times, name, series);

  // A row without a relaxation time, or with an infinite one, is the equilibrium modulus.
  double sum = 0, most = 0, ofRow = RawSeries::kNotStated;
  for (std::size_t row = 0; row < block.rows; ++row) {
    const double weight = block.at(row, weightAt) * (isPercent ? 0.01 : 1);
    if (!std::isfinite(weight)) continue;
    if (!std::isfinite(block.at(row, timeAt))) {
      ofRow = weight;
      continue;
    }
    const double stated = block.at(row, timeAt) * time;
    series.terms.push_back({weight, isRate ? 1 / stated : stated, block.lines[row]});
    sum += weight;
    most = std::max(most, weight);
  }
  if (series.terms.empty()) throw InputError(name, "", "holds no relaxation time");
  // Parts of the instantaneous modulus have no unit, and their sum is at most 1.
  series.isRelative = !series.isUnitKnown && most < 1 && sum <= 1 + 1e-6;

  std::vector<StatedModulus> above;
  for (const StatedModulus& stated : statedModuli(table, block)) {
    // Without a unit and below 1 it is a part of the instantaneous modulus, which the others
    // leave.
    const bool isPart = series.isRelative && stated.unit.empty() && stated.number < 1;
    if (!isPart) above.push_back(stated);
  }
  if (choices.modulusUnit.empty()) assumeUnits(weights, sum, above, name, series);
  const double wanted = unitSize(choices.modulusUnit, "Pa").value_or(series.unit);
  // The letter g of a part says nothing about the modulus of which it is one.
  const ModulusKind ofColumn = kindOf(modulusLetter(weights.name));
  ModulusKind kind = series.isRelative ? ModulusKind::Unknown : ofColumn;
  for (const StatedModulus& stated : above)
    if (kind == ModulusKind::Unknown) kind = stated.kind;
  if (kind == ModulusKind::Unknown && ofColumn == ModulusKind::Tension) kind = ModulusKind::Tension;
  const bool isGiven =
      std::isfinite(choices.instantaneousModulus) || std::isfinite(choices.equilibriumModulus);
  if (!series.isRelative || !above.empty() || !isGiven) kind = kindOfSeries(kind, choices, series);
  const auto shearFactor = [&](ModulusKind one) {
    return one == ModulusKind::Tension ? shearFromYoungs(1, choices.poissonRatio) : 1;
  };
  bool isDivided = !series.isRelative && kind == ModulusKind::Tension;
  if (!series.isRelative)
    for (RawSeries::Term& term : series.terms) term.weight *= shearFactor(kind);
  // Below 1 it is a part, too: what the others leave.
  if (!series.isRelative || (std::isfinite(ofRow) && ofRow >= 1))
    series.equilibrium = ofRow * shearFactor(kind);
  for (const StatedModulus& stated : above) {
    const bool isOwn =
        choices.modulus == ModulusKind::Unknown && stated.kind != ModulusKind::Unknown;
    const ModulusKind own = isOwn ? stated.kind : kind;
    const double size =
        stated.unit.empty() ? 1 : modulusSize(stated.unit, name, stated.key) / wanted;
    (stated.isInstantaneous ? series.instantaneous : series.equilibrium) =
        stated.number * size * shearFactor(own);
    isDivided = isDivided || own == ModulusKind::Tension;
  }
  if (isDivided)
    series.notes.push_back(dividedForShear(choices.poissonRatio));
  else if (kind == ModulusKind::Shear)
    series.notes.push_back("moduli of shear, not divided");
  readTemperature(table, block, name, choices, series);
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
