#include "core/fit/friction_columns.h"

#include <algorithm>
#include <cctype>

#include "core/base/text.h"
#include "core/base/text_dialect.h"
#include "core/material/dma_columns.h"

namespace asperity {
namespace {

using Quantity = FrictionQuantity;

struct QuantityNames {
  Quantity quantity;
  const char* meaning;
  std::initializer_list<std::string_view> names;  // letters and digits alone, in lower case
};

const std::array<QuantityNames, 8>& knownNames() {
  static const std::array<QuantityNames, 8> known{{
      {Quantity::Velocity,
       "velocity",
       {"velocity", "v", "speed", "slidingvelocity", "slidingspeed", "vslide", "vs",
        "geschwindigkeit", "gleitgeschwindigkeit"}},
      {Quantity::Mu,
       "coefficient of friction",
       {"mu", "\u00B5", "\u03BC", "cof", "friction", "frictioncoefficient", "coefficientoffriction",
        "coefficient", "reibwert", "reibungszahl", "reibbeiwert", "reibungskoeffizient"}},
      {Quantity::Force,
       "normal force",
       {"normalforce",
        "fn",
        "fz",
        "f",
        "force",
        "load",
        "normalload",
        "w",
        "n",
        "normalkraft",
        "kraft",
        "last",
        "normallast",
        "belastung",
        "auflast",
        "anpresskraft",
        "radlast",
        "wheelload",
        "verticalforce",
        "verticalload",
        "vertikalkraft",
        "vertikallast"}},
      {Quantity::Pressure,
       "nominal pressure",
       {"nominalpressure",
        "pressure",
        "contactpressure",
        "normalpressure",
        "nominalcontactpressure",
        "normalstress",
        "p",
        "p0",
        "pn",
        "pnom",
        "sigma",
        "\u03C3",
        "sigma0",
        "\u03C30",
        "sigman",
        "\u03C3n",
        "sigmaz",
        "\u03C3z",
        "druck",
        "fl\u00E4chenpressung",
        "flaechenpressung",
        "pressung",
        "normalspannung",
        "nenndruck"}},
      {Quantity::Temperature,
       "temperature",
       {"temperature",
        "temp",
        "t",
        "temperatur",
        "sampletemperature",
        "specimentemperature",
        "rubbertemperature",
        "tsample",
        "tspecimen",
        "trubber",
        "probentemperatur",
        "gummitemperatur",
        "tprobe",
        "tgummi",
        "testtemperature",
        "temperaturerubber",
        "temperaturesample",
        "temperaturespecimen",
        "pr\u00FCftemperatur",
        "prueftemperatur",
        "temperaturgummi",
        "temperaturprobe",
        "messtemperatur",
        "versuchstemperatur"}},
      {Quantity::Label,
       "label",
       {"label", "sample", "name", "set", "series", "specimen", "probe", "bezeichnung", "comment",
        "track", "surface"}},
      {Quantity::MuError, "error of the coefficient of friction", {}},
      {Quantity::VelocityError, "error of the velocity", {}},
  }};
  return known;
}

/// Returns the letters and digits of a name in lower case, without signs and blanks.
std::string plainWord(std::string_view text) {
  std::string word;
  for (const unsigned char letter : text)
    if (std::isalnum(letter) || letter >= 0x80) word += static_cast<char>(std::tolower(letter));
  return word;
}

/// Returns the rest of a word without the part that marks an error; nothing where there is no such
/// part.
std::optional<std::string> withoutError(std::string word) {
  for (const std::string_view sign : {"standarderror",
                                      "standarddeviation",
                                      "standarduncertainty",
                                      "standardabweichung",
                                      "standardabw",
                                      "stdabw",
                                      "standardunsicherheit",
                                      "standardfehler",
                                      "messunsicherheit",
                                      "uncertainty",
                                      "error",
                                      "stdev",
                                      "stddev",
                                      "sigma",
                                      "unsicherheit",
                                      "abweichung",
                                      "fehler",
                                      "err",
                                      "std",
                                      "dev",
                                      "sd",
                                      "se",
                                      "\u00B1",
                                      "\u03C3",
                                      "delta",
                                      "\u0394"}) {
    const std::size_t index = word.find(sign);
    // Two letters mark an error only at the beginning or end of a word: "sets" has no error.
    if (index == std::string::npos) continue;
    if (sign.size() == 2 && sign[0] < 'z' && index != 0 && index + 2 != word.size()) continue;
    word.erase(index, sign.size());
    if (word.ends_with("of")) word.resize(word.size() - 2);
    if (word.starts_with("of")) word.erase(0, 2);
    if (word.starts_with("in")) word.erase(0, 2);
    return word;
  }
  return {};
}

/// Returns the rest of a word without the letter of an uncertainty in front of it, as in "u(mu)",
/// "dmu" and "s_mu"; nothing where there is no such letter.
std::optional<std::string> withoutErrorLetter(const std::string& word) {
  constexpr std::string_view kLetters = "uds";
  if (word.size() < 2 || kLetters.find(word.front()) == std::string_view::npos) return {};
  return word.substr(1);
}

constexpr std::array<std::string_view, 4> kRelative{"relative", "relativer", "relativ", "rel"};

/// Returns a word without "relative" at its beginning or end.
std::string withoutRelative(std::string word) {
  for (const std::string_view sign : kRelative) {
    if (word.starts_with(sign)) return word.substr(sign.size());
    if (word.ends_with(sign)) return word.substr(0, word.size() - sign.size());
  }
  return word;
}

/// Returns whether a name has several meanings, such as t for temperature and time, so that it
/// needs a unit of its quantity.
bool isAmbiguous(const std::string& word) {
  constexpr std::array<std::string_view, 10> kAmbiguous{
      "t", "n", "w", "f", "sigma", "\u03C3", "sigman", "\u03C3n", "sigmaz", "\u03C3z"};
  return std::ranges::find(kAmbiguous, word) != kAmbiguous.end();
}

/// Returns the words of a name without those of its average: "mu mean", "mu std (n=3)", "mu_err (1
/// sigma)". Nothing where there are none. "(2 sigma)" stays, because it doubles the error.
std::optional<std::string> withoutAverage(std::string name) {
  const std::size_t all = nameWords(name).size();
  const std::size_t open = name.find_last_of("([");
  if (open != std::string::npos && open > 0) {
    const std::string inner = plainWord(name.substr(open));
    const bool isCount = inner.size() > 1 && inner.front() == 'n' &&
                         inner.find_first_not_of("0123456789", 1) == std::string::npos;
    if (isCount ||
        isOneOf(inner, {"1sigma", "1\u03C3", "\u00B11sigma", "\u00B11\u03C3", "1s", "1sd", "k1"}))
      name.resize(open);
  }
  std::vector<std::string> words = nameWords(name);
  std::erase_if(words, [](const std::string& word) {
    return isOneOf(word,
                   {"mean", "average", "avg", "mittel", "mittelwert", "mittlere", "mittlerer"});
  });
  if (words.empty() || words.size() == all) return {};
  std::string kept;
  for (const std::string& word : words) kept += (kept.empty() ? "" : " ") + word;
  return kept;
}

/// Returns the quantity that a name states in words and by its symbol: "Normal force F_N",
/// "Temperature T".
std::optional<Quantity> namedTwice(const std::string& name) {
  constexpr std::size_t kMostWords = 8;
  const std::vector<std::string> words = nameWords(name);
  if (words.size() > kMostWords) return {};
  for (std::size_t i = 1; i < words.size(); ++i) {
    std::string front, back;
    for (std::size_t j = 0; j < words.size(); ++j) (j < i ? front : back) += words[j];
    const auto quantity = quantityNamed(front);
    if (quantity && !isAmbiguous(front) && quantity == quantityNamed(back)) return quantity;
  }
  return {};
}

}  // namespace

std::vector<std::string> blankSeparated(std::string_view text) {
  std::vector<std::string_view> fields;
  splitFields(text, TextDialect::Separator::Blanks, fields);
  return {fields.begin(), fields.end()};
}

std::vector<std::string> nameWords(std::string text) {
  std::ranges::replace(text, '_', ' ');
  std::ranges::replace(text, '-', ' ');
  std::vector<std::string> words;
  for (const std::string& word : blankSeparated(text)) words.push_back(plainWord(word));
  std::erase(words, std::string());
  return words;
}

const char* meaningOf(Quantity quantity) {
  return std::ranges::find(knownNames(), quantity, &QuantityNames::quantity)->meaning;
}

std::optional<FrictionQuantity> quantityNamed(const std::string& word) {
  for (const QuantityNames& known : knownNames())
    if (std::ranges::find(known.names, word) != known.names.end()) return known.quantity;
  return {};
}

std::optional<Unit> unitOfQuantity(const std::string& unit, Quantity quantity) {
  if (unit.empty()) return {};
  if (quantity == Quantity::Force) return unitInAnyCase(unit, "N");
  if (quantity == Quantity::Pressure) return unitInAnyCase(unit, "Pa");
  return quantity == Quantity::Temperature ? temperatureUnit(unit) : std::nullopt;
}

bool measures(const std::string& unit, Quantity quantity) {
  return unitOfQuantity(unit, quantity).has_value();
}

bool isAmbiguousName(const std::string& name) {
  return isAmbiguous(plainWord(name)) || withoutAverage(name);
}

bool isRelativeError(const std::string& name) {
  return std::ranges::any_of(nameWords(name),
                             [](const std::string& word) { return word.starts_with("rel"); });
}

bool isShareUnit(std::string_view unit) {
  if (!unit.starts_with('%')) return false;
  const std::string word = plainWord(unit);
  return word == "ofmu" || word == "ofvalue" || word == "vonmu" || word.starts_with("rel");
}

bool isErrorName(const std::string& name) {
  const std::string word = plainWord(name);
  if (withoutError(word)) return true;
  const std::optional<std::string> subject = withoutErrorLetter(word);
  return subject && std::ranges::any_of(kLoadsAndTemperature, [&](Quantity quantity) {
           return quantityNamed(*subject) == quantity;
         });
}

bool isOtherLoad(const std::vector<std::string>& words) {
  std::string whole;
  for (const std::string& word : words) whole += word;
  const auto isOther = [](const std::string& word) {
    constexpr std::array<std::string_view, 15> kBeginnings{
        "fric", "tang", "later",      "shear",  "drag", "tract", "longi", "pull",
        "reib", "quer", "l\u00E4ngs", "umfang", "zug",  "schub", "modul"};
    constexpr std::array<std::string_view, 10> kWords{"fx", "fy",  "ft",     "fr", "ff",
                                                      "fs", "tau", "\u03C4", "e",  "g"};
    return std::ranges::find(kWords, word) != kWords.end() ||
           std::ranges::any_of(kBeginnings,
                               [&](std::string_view begin) { return word.starts_with(begin); });
  };
  return isOther(whole) || std::ranges::any_of(words, isOther);
}

std::optional<FrictionQuantity> findMeaning(const std::string& name, const std::string& unit) {
  const std::string word = plainWord(name);
  if (const auto named = quantityNamed(word);
      named && (!isAmbiguous(word) || unit == kAnyUnit || measures(unit, *named)))
    return named;
  if (const auto named = namedTwice(name)) return named;
  if (const auto plain = withoutAverage(name)) return findMeaning(*plain, unit);
  const std::string error = isRelativeError(name) ? withoutRelative(word) : word;
  std::optional<std::string> subject = withoutError(error);
  if (!subject) subject = withoutErrorLetter(error);
  if (!subject) return {};
  if (subject->empty()) return Quantity::MuError;
  const auto named = quantityNamed(*subject);
  if (named == Quantity::Mu) return Quantity::MuError;
  if (named == Quantity::Velocity) return Quantity::VelocityError;
  return {};
}

}  // namespace asperity
