#include "core/material/prony_table.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/text.h"
#include "core/base/text_clause.h"
#include "core/base/text_number.h"
#include "core/material/stated_temperature.h"
#include "core/material/table_forms.h"

namespace asperity {
namespace {

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
ModulusKind kindOfModulus(std::string_view word) {
  if (containsOneOf(word, "young tensile") || word.starts_with("zug")) return ModulusKind::Tension;
  if (containsOneOf(word, "shear schub cisaillement taglio corte")) return ModulusKind::Shear;
  if (word.starts_with("e") && !word.starts_with("equilibrium")) return ModulusKind::Tension;
  if (word.starts_with("g") && !beginsWithOneOf(word, "glassy gleichgewicht"))
    return ModulusKind::Shear;
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
  const ModulusKind ofWord = kindOfModulus(word);
  return StatedModulus{statement->quantity.number, statement->unit(),
                       ofWord == ModulusKind::Unknown ? kindOfModulus(whole) : ofWord,
                       isInstantaneous(word), statement->key};
}

/// Returns the moduli that the lines around the table of a series state: above and below it, and
/// above a table of shift factors or one without names. Other tables have headers of their own.
std::vector<StatedModulus> statedModuli(const TextPart& in) {
  const bool isOnly = std::ranges::all_of(in.table.blocks, [&in](const TextBlock& one) {
    return &one == &in.block || isShiftTable(one) || !one.hasNames();
  });
  std::vector<StatedModulus> found;
  const auto read = [&found](const std::vector<TextEntry>& entries) {
    for (const TextEntry& entry : entries) {
      const std::string line = joinEntry(entry);
      for (const std::string_view clause : splitClauses(line))
        if (auto stated = statedModulus(clause)) found.push_back(std::move(*stated));
    }
  };
  for (const TextBlock& one : in.table.blocks)
    if (isOnly || &one == &in.block) read(one.header);
  if (isOnly) read(in.table.trailer);
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
void assumeUnits(const SeriesBlock& in, const SeriesRows& rows,
                 std::vector<StatedModulus>& stated) {
  if (in.series.isRelative) return;
  const auto note = [&in](const std::string& key, const std::string& unit) {
    in.series.notes.push_back(message("{} has no unit: {} is assumed, which fits the other moduli",
                                      Message::name(key), Message::name(unit)));
  };
  for (StatedModulus& one : stated) {
    if (one.number == 0 || one.unit.empty() == !in.series.isUnitKnown) continue;
    if (in.series.isUnitKnown) {
      const bool inOthers = fitsStated(rows.sum, one.number, one.isInstantaneous);
      const bool inPascals = fitsStated(rows.sum * in.series.unit, one.number, one.isInstantaneous);
      if (in.series.unit == 1 ? !inOthers : inOthers == inPascals)
        throw InputError(in.name, one.key,
                         message("has no unit, and {} is in {}; write its unit after the number",
                                 Message::name(rows.column.name), Message::name(rows.column.unit)));
      one.unit = inOthers ? rows.column.unit : "Pa";
      note(one.key, one.unit);
      continue;
    }
    const double size = modulusSize(one.unit, in.name, one.key);
    const bool inOthers = fitsStated(rows.sum, one.number, one.isInstantaneous);
    const bool inPascals = fitsStated(rows.sum, one.number * size, one.isInstantaneous);
    // Small letters are those of parts, which may be in per cent.
    const bool isPart = rows.column.name.starts_with('g') || rows.column.name.starts_with('e');
    // Neither a modulus nor the part of one fits: what is wrong is said of parts.
    constexpr double kWhole = 1, kMaxParts = 10;
    if (isPart && one.isInstantaneous && rows.sum > kWhole && rows.sum < kMaxParts)
      throw InputError(
          in.name, rows.column.name,
          message("has no unit and adds up to {:.6g}; parts of the instantaneous modulus add up to "
                  "at most 1, and moduli need their unit: correct the parts, or say with "
                  "--modulus-unit which unit the moduli have",
                  rows.sum));
    if (size == 1 ? !inOthers : inOthers == inPascals || (isPart && inOthers))
      throw InputError(
          in.name, rows.column.name,
          message("has no unit, and {} is in {}; say with --modulus-unit which unit both have",
                  Message::name(one.key), Message::name(one.unit)));
    in.series.unit = inOthers ? size : 1;
    in.series.isUnitKnown = true;
    note(rows.column.name, inOthers ? std::string(withoutBrackets(one.unit)) : "Pa");
    return;
  }
}

/// Returns the kind of moduli of a series. The user's word precedes the file's; without both they
/// are of shear, which a note says.
ModulusKind kindOfSeries(ModulusKind stated, const SeriesBlock& in) {
  if (in.choices.modulus != ModulusKind::Unknown) return in.choices.modulus;
  if (stated != ModulusKind::Unknown) return stated;
  in.series.notes.push_back(
      "the file does not say of which kind its moduli are: shear is assumed; --modulus tension "
      "says otherwise");
  return ModulusKind::Shear;
}

/// Reads the moduli that the row of equilibrium and the lines around the table state, and turns all
/// of them into those of shear.
void readModuli(const SeriesBlock& in, const SeriesRows& rows) {
  std::vector<StatedModulus> above;
  for (const StatedModulus& stated : statedModuli(in)) {
    // Without a unit and below 1 it is a part of the instantaneous modulus, which the others
    // leave.
    const bool isPart = in.series.isRelative && rows.parts != PartsOf::Equilibrium &&
                        stated.unit.empty() && stated.number < 1;
    if (!isPart) above.push_back(stated);
  }
  if (in.choices.modulusUnit.empty()) assumeUnits(in, rows, above);
  const double wanted = unitSize(in.choices.modulusUnit, "Pa").value_or(in.series.unit);
  // The letter g of a part says nothing about the modulus of which it is one, and eta is that of no
  // kind.
  const std::string letter = modulusLetter(rows.column.name);
  const ModulusKind ofColumn =
      isArmViscosity(letter) ? ModulusKind::Unknown : kindOfModulus(letter);
  ModulusKind kind = in.series.isRelative ? ModulusKind::Unknown : ofColumn;
  for (const StatedModulus& stated : above)
    if (kind == ModulusKind::Unknown) kind = stated.kind;
  if (kind == ModulusKind::Unknown && ofColumn == ModulusKind::Tension) kind = ModulusKind::Tension;
  if (!in.series.isRelative || !above.empty() || !in.choices.statesModulus())
    kind = kindOfSeries(kind, in);
  const auto shearFactor = [&](ModulusKind one) {
    return one == ModulusKind::Tension ? shearFromYoungs(1, in.choices.poissonRatio) : 1;
  };
  bool isDivided = !in.series.isRelative && kind == ModulusKind::Tension;
  if (!in.series.isRelative)
    for (RawSeries::Term& term : in.series.terms) term.weight *= shearFactor(kind);
  // Below 1 it is a part, too: what the others leave.
  if (std::isfinite(rows.equilibrium) &&
      (!in.series.isRelative || (rows.parts == PartsOf::Unknown && rows.equilibrium >= 1)))
    in.series.equilibrium = rows.equilibrium * shearFactor(kind);
  for (const StatedModulus& stated : above) {
    const bool isOwn =
        in.choices.modulus == ModulusKind::Unknown && stated.kind != ModulusKind::Unknown;
    const ModulusKind own = isOwn ? stated.kind : kind;
    const double size =
        stated.unit.empty() ? 1 : modulusSize(stated.unit, in.name, stated.key) / wanted;
    double& modulus = stated.isInstantaneous ? in.series.instantaneous : in.series.equilibrium;
    const double value = stated.number * size * shearFactor(own);
    // One of shear and one of tension may be stated with a rounded Poisson's ratio.
    constexpr double kSame = 0.02;
    if (std::isfinite(modulus) && std::abs(modulus - value) > kSame * std::abs(value))
      throw InputError(
          in.name, stated.key,
          message("is stated twice, with the shear moduli {} and {}; leave one of them out",
                  printed(modulus * wanted, "Pa"), printed(value * wanted, "Pa")));
    modulus = value;
    isDivided = isDivided || own == ModulusKind::Tension;
  }
  if (isDivided) {
    in.series.notes.push_back(dividedForShear(in.choices.poissonRatio));
    if (auto note = otherPoissonNote(in, in.choices.poissonRatio))
      in.series.notes.push_back(std::move(*note));
  } else if (kind == ModulusKind::Shear) {
    in.series.notes.push_back("moduli of shear, not divided");
  }
}

/// Reads the temperature and the shift that a table states. The user's temperature precedes, and is
/// that of a shift without a reference.
void readTemperature(const SeriesBlock& in) {
  in.series.temperature = in.choices.temperature;
  std::optional<double> reference = in.choices.temperature;
  try {
    const auto stated = statedTemperature(in, in.name, in.choices.temperatureUnit, true);
    const auto inFile = stated ? std::optional(stated->kelvin) : std::nullopt;
    if (!in.choices.temperature) in.series.temperature = inFile;
    if (!in.choices.temperature && stated)
      in.series.notes.push_back(message("temperature: {} (line {}: {})", celsius(stated->kelvin),
                                        stated->line, Message::name(shortened(stated->text))));
    constexpr double kSame = 1e-6;  // K, of converted degrees
    if (inFile && !(reference && std::abs(*inFile - *reference) < kSame)) reference = inFile;
  } catch (const InputError&) {
    if (!in.choices.temperature) throw;
  }
  if (!reference) return;
  StatedShift stated = statedShift(in.table, *reference, in.name, in.choices.temperatureUnit);
  in.series.shift = std::move(stated.shift);
  std::ranges::move(stated.notes, std::back_inserter(in.series.notes));
}

/// Returns whether a table has relaxation times and moduli of arms by the names of its columns.
bool hasSeriesColumns(const TextBlock& block) {
  const auto has = [&block](const auto& isName) {
    return std::ranges::any_of(
        block.columns, [&](const TextColumn& column) { return isName(seriesWord(column.name)); });
  };
  return has(isRelaxationTime) && has(isArmModulus);
}

/// Returns the table that is none of shift factors, with names where one has some, and of these the
/// one with the most numbers; null where there is none.
TextBlock* largestSeries(TextTable& table) {
  const auto rank = [](const TextBlock& block) {
    return std::pair(block.hasNames(), block.values.size());
  };
  TextBlock* largest = nullptr;
  for (TextBlock& one : table.blocks)
    if (!isShiftTable(one) && (!largest || rank(one) > rank(*largest))) largest = &one;
  return largest;
}

}  // namespace

std::optional<RawSeries> tableSeries(TextTable table, const std::string& name,
                                     const PronyChoices& choices) {
  RawSeries series;
  transposeRows(table, hasSeriesColumns, series.notes);
  separateCells(table, name, series.notes);
  moveLinesAbove(table, name);
  TextBlock* const block = largestSeries(table);
  if (!block) return {};
  series.format = "a table of relaxation times and moduli";
  const std::optional<SeriesRows> rows = readArms(table, *block, name, choices, series);
  if (!rows) return {};
  const SeriesBlock in{{table, *block}, name, choices, series};
  readModuli(in, *rows);
  readTemperature(in);
  std::ranges::move(doubtsAbout(table), std::back_inserter(series.notes));
  return series;
}

std::string seriesWord(std::string_view text) {
  std::string word = compactName(text);
  for (const std::string_view infinity : WordList("\u221E infinity infty"))
    replaceAll(word, infinity, "inf");
  for (const std::string_view tau : WordList("\u03C4 \u03A4")) replaceAll(word, tau, "tau");
  for (const std::string_view eta : WordList("\u03B7 \u0397")) replaceAll(word, eta, "eta");
  constexpr WordList kIndices(
      "\u2080 \u2081 \u2082 \u2083 \u2084 \u2085 \u2086 \u2087 \u2088 \u2089");
  for (const std::string_view letter : WordList("\u1D62 \u2C7C \u2096"))
    replaceAll(word, letter, "i");
  std::size_t digit = 0;
  for (const std::string_view index : kIndices) replaceAll(word, index, std::to_string(digit++));
  return word;
}

bool isEquilibrium(std::string_view word) {
  return isOneOf(
      word,
      "ginf einf equilibriummodulus longtermmodulus rubberymodulus ge ee geq eeq gequilibrium "
      "eequilibrium inf longtermmodulusg longtermmoduluse equilibriummodulusg "
      "equilibriummoduluse gleichgewichtsmodul langzeitmodul");
}

bool isInstantaneous(std::string_view word) {
  return isOneOf(
      word,
      "g0 e0 gg eg instantaneousmodulus shorttermmodulus glassymodulus gglassy eglassy ginst "
      "einst ginstantaneous einstantaneous");
}

bool isRelaxationTime(std::string_view word) {
  return beginsWithOneOf(word, "tau lambda relaxationtime relaxationszeit tempsderelax") ||
         isOneOf(word, "ti times") || (isDecayRate(word) && word != "omega");
}

bool isDecayRate(std::string_view word) {
  return beginsWithOneOf(word, "beta relaxationrate relaxationsrate decayrate") ||
         isOneOf(word, "omega omegai omegak");
}

bool isArmModulus(std::string_view name) {
  const std::string word = seriesWord(name);
  return isOneOf(modulusLetter(name), "g gi e ei") || partsByName(word) != PartsOf::Unknown ||
         isOneOf(word,
                 "g gi e ei modulus moduli relaxationmodulus alpha alphai gimod shearmodulus "
                 "relativemodulus gk ek gn en gj ej "
                 "modul schubmodul moduledecisaillement moduloditaglio modulodecorte");
}

bool isArmViscosity(std::string_view word) {
  return isOneOf(word,
                 "eta etai etak viscosity viscosities viscosityeta viscosityetai viskositaet "
                 "viskositaeteta viskositaetetai");
}

bool hasArmIndex(std::string_view word) {
  return isOneOf(
      word,
      "gi ei gi/g0 ei/e0 gi/ginf ei/einf gi/ge ei/ee gi/geq ei/eeq gk ek gn en gj ej etai etak");
}

PartsOf partsByName(std::string_view word) {
  if (isOneOf(word, "gi/g0 ei/e0 g/g0 e/e0 gk/g0 ek/e0")) return PartsOf::Instantaneous;
  if (isOneOf(word,
              "gi/ginf ei/einf g/ginf e/einf gk/ginf ek/einf gi/ge ei/ee g/ge e/ee gi/geq ei/eeq"))
    return PartsOf::Equilibrium;
  return PartsOf::Unknown;
}

}  // namespace asperity
