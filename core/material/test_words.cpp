#include "core/material/test_words.h"

#include <algorithm>

#include "core/base/text.h"
#include "core/base/text_clause.h"
#include "core/base/text_header.h"
#include "core/base/text_number.h"
#include "core/material/dma_columns.h"
#include "core/material/text_quantities.h"

namespace asperity {
namespace {

/// Returns whether a word says that a temperature is none of the test: a property of the sample, a
/// number of the program or of the oven, a constant of the shift.
bool isOfOther(const std::string& word) {
  static constexpr WordList kStems(
      "instrument ger\u00E4t device glas dens dicht hardn h\u00E4rte toler oven ofen furnace range "
      "bereich maxim minim limit grenz heat heiz aufheiz cool k\u00FChl soak halte ramp increment "
      "schritt differ offset gradient accur abk\u00FChl genauig h\u00F6chst resolution britt "
      "verspr\u00F6 spr\u00F6d crystal kristall soften erweich precision stabil pr\u00E4zis "
      "uniform deviation abweich fluctuat schwank variation error fehler uncertain unsicher "
      "repeatab sensor f\u00FChler thermocouple thermoelement mooney vicat bath mdr t90 tc90 ts2");
  return isOfMaking(word) || beginsWithOneOf(word, kStems) ||
         isOneOf(word,
                 "bis tg rate wlf c1 c2 c\u2081 c\u2082 max min tmax tmin dt delta \u03B4t \u0394t "
                 "start end final stop anfang ende tm drift limits heizrate twlf tb hdt tr10 tr30 "
                 "tr50 tr70 ml ltb vst dvr irm uv dsc bad oil \u00F6l");
}

}  // namespace

bool isOfMaking(const std::string& word) {
  static constexpr WordList kStems(
      "vulc vulk cure curing mix misch mold mould press aged ageing aging alter gealtert lager "
      "gelager melt schmelz extru calib kalib getemper vernetz verarbeit processing crossli drying "
      "dried trockn getrockn cuisson stockage anneal r\u00E9ticul vorbehandl pretreat stored");
  // "tempered", "Tempern", but not "temperature" and "temperiert" (held at a temperature).
  const bool isTempering =
      word.starts_with("temper") && !word.starts_with("temperat") && !word.starts_with("temperier");
  // "T_cure"
  const bool isIndex = word.starts_with('t') && beginsWithOneOf(word.substr(1), kStems);
  return isTempering || isIndex || beginsWithOneOf(word, kStems);
}

bool isMixture(const std::string& word) {
  return isOneOf(word, "mischung mixture mix");
}

std::vector<std::string> withoutNamesOfMixtures(std::vector<std::string> words) {
  for (std::size_t i = 0; i + 1 < words.size();) {
    const std::string& name = words[i + 1];
    const bool isTemperature =
        findTemperature(name + (i + 2 < words.size() ? words[i + 2] : "")).has_value();
    const bool isNamed = isMixture(words[i]) && !isTemperature &&
                         !isOneOf(name, "at bei auf for to von of on in mit");
    if (isNamed)
      words.erase(words.begin() + static_cast<std::ptrdiff_t>(i));
    else
      ++i;
  }
  return words;
}

bool areOfOther(const std::vector<std::string>& all) {
  const std::vector<std::string> words = withoutNamesOfMixtures(all);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (word == "min" && i > 0 && isDigit(words[i - 1].back())) continue;
    const bool isModulus = i + 1 < words.size() && (words[i + 1].starts_with("mod") ||
                                                    isOneOf(words[i + 1], "g e shear and und"));
    // "Process temperature"; a process may also be that of the test.
    const bool isProcess =
        word == "process" && i + 1 < words.size() && words[i + 1].starts_with("temp");
    // "TR 10": the temperature of a retraction of 10 %
    const bool isRetraction =
        word == "tr" && i + 1 < words.size() && isOneOf(words[i + 1], "10 30 50 70");
    if (isOfOther(word) || isProcess || isRetraction || (word == "storage" && !isModulus))
      return true;
  }
  return false;
}

bool isTestWord(const std::string& word) {
  static constexpr WordList kStems(
      "test measur gemess mess pr\u00FCf gepr\u00FCf mesur isotherm sweep ttest master essai prova "
      "misur ensayo medid \u6E2C\u5B9A \u8A66\u9A13 \u6D4B");
  return beginsWithOneOf(word, kStems) || isOneOf(word, "run curve kurve");
}

bool areOfTest(const std::vector<std::string>& words) {
  return std::ranges::any_of(words, isTestWord);
}

bool stateDuration(const std::vector<std::string>& words) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::size_t unit = words[i].find_first_not_of("0123456789.,");
    if (unit == 0) continue;
    const std::string text = unit != std::string::npos ? words[i].substr(unit)
                             : i + 1 < words.size()    ? words[i + 1]
                                                       : std::string();
    if (isOneOf(text,
                "h hr hrs hour hours std stunden heures ore horas min minutes minuten s sec d day "
                "days tage jours giorni dias weeks wochen \u6642\u9593 \u5206"))
      return true;
  }
  return false;
}

bool areOnlyOfTest(const std::vector<std::string>& words) {
  constexpr WordList kStems(
      "sampl probe specimen piece compound \u00E9chantillon campion muestra frequen fr\u00E9quen "
      "frecuen temperat moduli modulus module shear tension tensile compress torsion bending schub "
      "zug strain amplitude deform dynami storage loss stiffness mode step point process during "
      "actual current average mean chamber plate celsius kelvin grad degree \u6E29\u5EA6 rubber "
      "gummi kautschuk elastomer polymer epdm hnbr xnbr ssbr essbr silicon silikon pdms sylgard "
      "shore carbon ru\u00DF silica unfilled filled");
  constexpr std::size_t kShort = 3;  // bytes
  return std::ranges::all_of(withoutNamesOfMixtures(words), [&](const std::string& word) {
    // "50phr" and "100hz" are numbers, too.
    const std::size_t letters = std::min(word.find_first_not_of("0123456789.,"), word.size());
    return isTestWord(word) || beginsWithOneOf(word, kStems) || isDigit(word.back()) ||
           word.size() - letters <= kShort || word.substr(letters) == "degc";
  });
}

bool areOfShift(const std::vector<std::string>& words) {
  return hasOneOf(words, "wlf twlf c1 c2 c\u2081 c\u2082");
}

bool areOfGlass(const std::vector<std::string>& words) {
  return std::ranges::any_of(words, [](const std::string& word) {
    return isOneOf(word, "tg tglas tglass") || word.starts_with("glas");
  });
}

bool isVague(const std::string& word) {
  constexpr WordList kStems("ambient raum umgebung soll target nominal program setpoint lab");
  return beginsWithOneOf(word, kStems) || isOneOf(word, "room set tset tsoll");
}

bool isOfReference(const std::string& word) {
  constexpr WordList kStems("refer bezug");
  return beginsWithOneOf(word, kStems) || isOneOf(word, "ref tref tr t0 tbezug");
}

bool isTemperatureWord(std::string_view key) {
  return dmaColumn(key, "").quantity == DmaQuantity::Temperature;
}

bool namesOneTemperature(std::string_view key) {
  if (key == "T") return true;
  const std::vector<std::string> words = wordsIn(parseColumnName(key).name);
  const auto isNamed = [](std::string_view word) {
    return endsWithOneOf(word, "temp temperature temperatur temp\u00E9rature");
  };
  if (words.empty()) return false;
  for (const std::string& word : words) {
    constexpr WordList kStems(
        "number anzahl point punkt sensor profil control regel chann kanal count program nombre");
    if (beginsWithOneOf(word, kStems)) return false;
  }
  const bool isOfSomething =
      words.size() > 1 && isNamed(words[0]) && isOneOf(words[1], "of de du der des");
  return isNamed(words.back()) || words.back() == "tref" || isOfSomething;
}

}  // namespace asperity
