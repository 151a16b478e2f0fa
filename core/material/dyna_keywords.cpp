// Keywords of LS-DYNA (LS-DYNA Keyword User's Manual, Volume II): *MAT_GENERAL_VISCOELASTIC
// (*MAT_076), G(t) = sum G_i exp(-beta_i t), and *MAT_VISCOELASTIC (*MAT_006), G(t) = G_inf + (G_0
// - G_inf) exp(-beta t). Such a file states no units; the density of a rubber tells them.
#include <cmath>
#include <string_view>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/text.h"
#include "core/base/text_number.h"
#include "core/base/units.h"
#include "core/material/prony_keywords.h"

namespace asperity {
namespace {

constexpr std::string_view kTitle = "_title";

/// Returns a keyword without the mark of a line with a title.
std::string_view withoutTitle(std::string_view keyword) {
  return keyword.ends_with(kTitle) ? keyword.substr(0, keyword.size() - kTitle.size()) : keyword;
}

bool isGeneral(std::string_view keyword) {
  return isOneOf(withoutTitle(keyword), "*mat_general_viscoelastic *mat_076");
}

bool isSimple(std::string_view keyword) {
  return isOneOf(withoutTitle(keyword), "*mat_viscoelastic *mat_006");
}

// ---- Cards --------------------------------------------------------------------------------------

/// Returns a card with its fields as words: 10 characters each, unless commas separate them. Throws
/// InputError where a field has a blank or a tab in it, as in lines that are separated by blanks.
KeywordLine cardOf(const KeywordLine& line) {
  if (line.text.find(',') != std::string_view::npos) return line;
  constexpr std::size_t kWidth = 10, kFields = 8;
  KeywordLine card{line.file, line.text, line.number};
  for (std::size_t i = 0; i < kFields && i * kWidth < line.text.size(); ++i) {
    const std::string_view field = trimmedBlanks(line.text.substr(i * kWidth, kWidth));
    if (field.find_first_of(" \t") != std::string_view::npos)
      line.fail("has fields that are neither 10 characters wide nor separated by commas");
    card.words.push_back(lowerCase(field));
  }
  return card;
}

/// Returns the cards of the keyword in line i: the lines up to the next keyword, without comments
/// ($) and without the title. A blank line is a card, too.
std::vector<KeywordLine> cardsOf(const KeywordFile& file, std::size_t i) {
  std::vector<KeywordLine> cards;
  bool hasTitle = file.lines[i].words.front().ends_with(kTitle);
  for (std::size_t k = i + 1; k < file.lines.size(); ++k) {
    const KeywordLine& line = file.lines[k];
    if (line.text.starts_with('*')) break;
    if (line.text.starts_with('$')) continue;
    if (hasTitle)
      hasTitle = false;
    else
      cards.push_back(cardOf(line));
  }
  return cards;
}

/// Returns a number of a card; 0 where the card or its field is blank. Throws InputError where it
/// is negative unless that is allowed: the number is then that of a curve.
double fieldAt(const std::vector<KeywordLine>& cards, std::size_t card, std::size_t field,
               bool mayBeNegative = false) {
  if (card >= cards.size()) return 0;
  const double number = cards[card].optionalNumberAt(field).value_or(0);
  if (number < 0 && !mayBeNegative)
    cards[card].fail(message("has {} in place {}, where a number of at least 0 is read",
                             plain(number), field + 1));
  return number;
}

/// Returns the title of the material in line i, or its number.
std::string materialName(const KeywordFile& file, std::size_t i,
                         const std::vector<KeywordLine>& cards) {
  const bool hasTitle = file.lines[i].words.front().ends_with(kTitle);
  for (std::size_t k = i + 1; hasTitle && k < file.lines.size(); ++k)
    if (!file.lines[k].text.starts_with('$')) return std::string(trimmedBlanks(file.lines[k].text));
  return cards.empty() ? std::string() : cards.front().word(0);
}

// ---- Units --------------------------------------------------------------------------------------

/// Units of density, modulus and time that belong together.
struct UnitSystem {
  const char* density;
  double densitySize;  // kg/m3
  const char* modulus;
  double modulusSize;  // Pa
  const char* time;
  double timeSize;  // s
};

constexpr UnitSystem kUnitSystems[] = {
    {"kg/m3", 1, "Pa", 1, "s", 1},
    {"t/mm3", 1e12, "MPa", 1e6, "s", 1},
    {"kg/mm3", 1e9, "GPa", 1e9, "ms", 1e-3},
    {"kg/mm3", 1e9, "kPa", 1e3, "s", 1},
    {"g/mm3", 1e6, "MPa", 1e6, "ms", 1e-3},
    {"g/mm3", 1e6, "Pa", 1, "s", 1},
    {"t/m3", 1e3, "kPa", 1e3, "s", 1},
    {"mg/mm3", 1e3, "kPa", 1e3, "ms", 1e-3},
    {"g/cm3", 1e3, "Mbar", 1e11, "\u00B5s", 1e-6},
    {"g/cm3", 1e3, "dyn/cm2", 0.1, "s", 1},
    {"lbf s2/in4", 1.06868e7, "psi", 6894.757, "s", 1},
};

/// Returns whether a density and the modulus of a sudden deformation are those of a rubber in a
/// system of units.
bool fitsRubber(const UnitSystem& system, double density, double glassy) {
  constexpr double kLightest = 700, kHeaviest = 3000;           // kg/m3
  constexpr double kSoftestSolid = 3e4, kStiffestSolid = 3e10;  // Pa
  const double kilograms = density * system.densitySize, pascals = glassy * system.modulusSize;
  return kilograms >= kLightest && kilograms <= kHeaviest && pascals >= kSoftestSolid &&
         pascals < kStiffestSolid;
}

/// Returns the only system of units in which the numbers are those of a rubber, and in which moduli
/// are in the user's unit, if there is one. Throws InputError where there is none, or several.
const UnitSystem& unitsOf(const PronyChoices& choices, const KeywordLine& card, double density,
                          double glassy) {
  const auto stated = unitSize(choices.modulusUnit, "Pa");
  const UnitSystem* found = nullptr;
  bool isUnclear = false;
  for (const UnitSystem& system : kUnitSystems) {
    constexpr double kSame = 1e-3;
    const bool isStatedUnit = !stated || std::abs(system.modulusSize / *stated - 1) < kSame;
    if (!isStatedUnit || !fitsRubber(system, density, glassy)) continue;
    isUnclear = isUnclear || found;
    found = &system;
  }
  if (!found || isUnclear)
    card.fail(
        message("does not tell its units: a density of {} and a modulus of {} are those of a "
                "rubber in no or in several systems of units; write the Prony series as a table "
                "with columns such as tau (s) and G (MPa), whose tau is 1/beta, and the "
                "equilibrium modulus in a row with tau = inf",
                plain(density), plain(glassy)));
  return *found;
}

// ---- Materials ----------------------------------------------------------------------------------

void readGeneral(const std::vector<KeywordLine>& cards, const PronyChoices& choices,
                 RawSeries& series) {
  if (fieldAt(cards, 0, 4) != 0)
    cards.front().fail("is of an elastic layer (EF), without a series");
  if (fieldAt(cards, 1, 0) != 0)
    cards[1].fail("takes its constants from a curve (LCID), which is not read");
  series.equilibrium = 0;
  for (std::size_t i = 2; i < cards.size(); ++i) {
    const double modulus = fieldAt(cards, i, 0), rate = fieldAt(cards, i, 1);
    // A term that does not decay is the equilibrium modulus; one without G is of the bulk modulus.
    if (rate == 0)
      series.equilibrium += modulus;
    else if (modulus > 0)
      series.terms.push_back({modulus, 1 / rate, cards[i].number});
  }
  const auto isStated = [&](std::size_t field) { return fieldAt(cards, 0, field, true) != 0; };
  constexpr std::size_t kReference = 5, kA = 6, kB = 7;
  if (!isStated(kA) && !isStated(kB)) return;
  if (isStated(kReference))
    series.temperature = readReference(cards.front().numberAt(kReference), {}, choices, series);
  series.notes.push_back(
      "the shift with temperature by TREF, A and B is left out, because the sign and the base of "
      "the logarithm that A belongs to are not certain; the series holds at TREF");
}

void readSimple(const std::vector<KeywordLine>& cards, RawSeries& series) {
  const double instantaneous = fieldAt(cards, 0, 3);
  series.equilibrium = fieldAt(cards, 0, 4);
  const double rate = fieldAt(cards, 0, 5);
  if (!(instantaneous > series.equilibrium && rate > 0))
    cards.front().fail("does not relax: G0 must be above GI, and BETA above 0");
  series.terms.push_back({instantaneous - series.equilibrium, 1 / rate, cards.front().number});
}

}  // namespace

std::optional<RawSeries> dynaSeries(const KeywordFile& file) {
  std::optional<std::size_t> found;
  std::size_t materials = 0;
  bool isLong = false;
  for (std::size_t i = 0; i < file.lines.size(); ++i) {
    const KeywordLine& line = file.lines[i];
    const std::string& keyword = line.words.front();
    if (keyword.starts_with("*keyword") && keyword.find("long=") != keyword.npos) isLong = true;
    if (keyword.starts_with("*mat_") && !keyword.starts_with("*mat_add")) ++materials;
    if (!isGeneral(keyword) && !isSimple(keyword)) continue;
    if (found) line.fail("is a second viscoelastic material; keep the one that is meant alone");
    found = i;
  }
  if (!found) return {};
  const KeywordLine& keyword = file.lines[*found];
  if (isLong) keyword.fail("is written in the long format, which is not read");
  const std::vector<KeywordLine> cards = cardsOf(file, *found);
  RawSeries series;
  series.format = "keywords of LS-DYNA";
  series.isRelative = false;
  series.material = materialName(file, *found, cards);
  addMaterialNote(series.material, materials, series);
  if (cards.empty()) keyword.fail("is a keyword of LS-DYNA without numbers");
  if (isGeneral(keyword.words.front()))
    readGeneral(cards, file.choices, series);
  else
    readSimple(cards, series);
  if (series.terms.empty()) keyword.fail("is a keyword of LS-DYNA without a pair of GI and BETAI");
  const double density = fieldAt(cards, 0, 1);
  const UnitSystem& units =
      unitsOf(file.choices, cards.front(), density, series.equilibrium + series.totalWeight());
  series.unit = units.modulusSize;
  series.isUnitKnown = true;
  for (RawSeries::Term& term : series.terms) term.time *= units.timeSize;
  series.notes.push_back(
      message("the file states no units; a density of {} is that of a rubber in {}, so moduli are "
              "read in {} and times in {}",
              plain(density), Message::name(units.density), Message::name(units.modulus),
              Message::name(units.time)));
  return series;
}

}  // namespace asperity
