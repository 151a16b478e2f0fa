#include "core/fit/friction_columns.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <numeric>
#include <utility>

#include "core/base/text.h"
#include "core/base/text_dialect.h"
#include "core/base/text_header.h"
#include "core/base/text_number.h"
#include "core/material/dma_columns.h"

namespace asperity {
namespace {

using Quantity = FrictionQuantity;

/// What a quantity is called in messages, and the names of its columns as plain words.
struct QuantityNames {
  Quantity quantity;
  const char* meaning;
  WordList names;
};

constexpr QuantityNames kKnownNames[] = {
    {Quantity::Velocity, "velocity",
     "velocity v speed slidingvelocity slidingspeed vslide vs geschwindigkeit "
     "gleitgeschwindigkeit gleitgeschw geschw vgleit vitesse vitessedeglissement velocit\u00E0 "
     "velocita velocit\u00E0distrisciamento velocidad velocidaddedeslizamiento "
     "\u901F\u5EA6 \u3059\u3079\u308A\u901F\u5EA6 \u6ED1\u308A\u901F\u5EA6"},
    {Quantity::Mu, "coefficient of friction",
     "mu \u00B5 \u03BC cof friction frictioncoefficient coefficientoffriction coefficient reibwert "
     "reibungszahl reibbeiwert reibungskoeffizient muk mukin mukinetic mudyn mudynamic "
     "kineticfriction dynamicfriction slidingfriction gleitreibwert gleitreibungszahl "
     "gleitreibungskoeffizient coefficientdefrottement coefdefrottement coefficientediattrito "
     "coeffdiattrito coeficientedefricci\u00F3n coeficientedefriccion coeficientederozamiento "
     "\u6469\u64E6\u4FC2\u6570"},
    {Quantity::Force, "normal force",
     "normalforce fn fz f force load normalload w n normalkraft kraft last normallast belastung "
     "auflast anpresskraft radlast wheelload verticalforce verticalload vertikalkraft "
     "vertikallast forcenormale chargenormale forzanormale caricoverticale fuerzanormal "
     " carganormal \u8377\u91CD \u5782\u76F4\u8377\u91CD"},
    {Quantity::Pressure, "nominal pressure",
     "nominalpressure pressure contactpressure normalpressure nominalcontactpressure normalstress "
     "pression pressione presion presi\u00F3n \u9762\u5727 p p0 pn pnom sigma \u03C3 sigma0 "
     "\u03C30 sigman \u03C3n sigmaz \u03C3z druck "
     "fl\u00E4chenpressung flaechenpressung pressung normalspannung nenndruck"},
    {Quantity::Temperature, "temperature",
     "temperature temp t temperatur sampletemperature specimentemperature rubbertemperature "
     "tsample tspecimen trubber probentemperatur gummitemperatur tprobe tgummi testtemperature "
     "temperaturerubber temperaturesample temperaturespecimen pr\u00FCftemperatur prueftemperatur "
     "temp\u00E9rature temperatura \u6E29\u5EA6 temperaturgummi temperaturprobe messtemperatur "
     "versuchstemperatur"},
    {Quantity::Label, "label",
     "run lauf wiederholung label sample name set series specimen probe bezeichnung comment track "
     "surface"},
    {Quantity::MuError, "error of the coefficient of friction", ""},
    {Quantity::VelocityError, "error of the velocity", ""}};

/// Returns the rest of a word without the part that marks an error; nothing where there is no such
/// part.
std::optional<std::string> withoutError(std::string word) {
  constexpr WordList kSigns(
      "\u00E9carttype \u00C9carttype ecarttype deviazionestandard desviaci\u00F3nest\u00E1ndar "
      "desviacionestandar incertitude incertezza incertidumbre \u6A19\u6E96\u504F\u5DEE stabw "
      "standarderror standarddeviation standarduncertainty standardabweichung standardabw stdabw "
      "standardunsicherheit standardfehler messunsicherheit uncertainty error stdev stddev sigma "
      "unsicherheit abweichung fehler err std dev sd se \u00B1 \u03C3 delta \u0394");
  for (const std::string_view sign : kSigns) {
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

/// Returns a word without "relative" at its beginning or end.
std::string withoutRelative(std::string word) {
  for (const std::string_view sign : WordList("relative relativer relativ rel")) {
    if (word.starts_with(sign)) return word.substr(sign.size());
    if (word.ends_with(sign)) return word.substr(0, word.size() - sign.size());
  }
  return word;
}

/// Returns whether a name has several meanings, such as t for temperature and time, so that it
/// needs a unit of its quantity.
bool isAmbiguous(const std::string& word) {
  return isOneOf(word, "t n w f sigma \u03C3 sigman \u03C3n sigmaz \u03C3z");
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
    if (isCount || isOneOf(inner, "1sigma 1\u03C3 \u00B11sigma \u00B11\u03C3 1s 1sd k1"))
      name.resize(open);
  }
  std::vector<std::string> words = nameWords(name);
  std::erase_if(words, [](const std::string& word) {
    return isOneOf(word, "mean the average avg mittel mittelwert mittlere mittlerer");
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
  return std::ranges::find(kKnownNames, quantity, &QuantityNames::quantity)->meaning;
}

std::optional<FrictionQuantity> quantityNamed(const std::string& word) {
  for (const QuantityNames& known : kKnownNames)
    if (isOneOf(word, known.names)) return known.quantity;
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
  return isOneOf(word, "ofmu ofvalue vonmu") || word.starts_with("rel");
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
  const auto isOther = [](const std::string& word) {
    return isOneOf(word, "fx fy ft fr ff fs tau \u03C4 e g") ||
           beginsWithOneOf(
               word,
               "fric tang later shear drag tract longi pull reib quer l\u00E4ngs umfang "
               "zug schub modul");
  };
  return isOther(std::accumulate(words.begin(), words.end(), std::string())) ||
         std::ranges::any_of(words, isOther);
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

std::optional<FrictionQuantity> findMeaning(const TextColumn& column) {
  const auto scale = findErrorScale(column);
  if (!scale) return findMeaning(column.name, column.unit);
  return scale->isIndefinite ? std::nullopt : findMeaning(scale->name, scale->unit);
}

namespace {

bool isNumber(std::string_view word) {
  return !word.empty() && std::ranges::all_of(word, isDigit);
}

/// Returns the words and whole numbers of a name: "2" and "sigma" of "\u00B12 sigma" and "2*sigma",
/// "ci" and "95" of "CI95".
std::vector<std::string> wordsAndNumbers(const std::string& name) {
  std::vector<std::string> words;
  for (std::string word : nameWords(name)) {
    constexpr std::string_view kPlusMinus = "\u00B1";
    if (word.starts_with(kPlusMinus) && word.size() > kPlusMinus.size())
      word.erase(0, kPlusMinus.size());
    const std::size_t digit = word.find_first_of("0123456789");
    if (digit != word.npos && isOneOf(word.substr(0, digit), "k ci u")) {
      words.push_back(word.substr(0, digit));
      word.erase(0, digit);
    }
    const std::size_t letter = std::min(word.find_first_not_of("0123456789"), word.size());
    if (letter > 0) words.push_back(word.substr(0, letter));
    if (letter < word.size()) words.push_back(word.substr(letter));
  }
  return words;
}

/// Returns the half width of an interval with this probability (%) of a normal distribution, in
/// standard deviations; 0 where it is not a usual one.
double halfWidth(std::string_view percent) {
  constexpr std::pair<std::string_view, double> kUsual[] = {
      {"68", 1}, {"90", 1.645}, {"95", 1.96}, {"99", 2.576}};
  const auto found =
      std::ranges::find(kUsual, percent, &std::pair<std::string_view, double>::first);
  return found == std::end(kUsual) ? 0 : found->second;
}

}  // namespace

std::optional<ErrorScale> findErrorScale(const TextColumn& column) {
  ErrorScale scale;
  // "u_mu [k=2]" has no unit.
  const bool hasUnit = column.unit.empty() || isKnownUnit(column.unit) || isShareUnit(column.unit);
  if (hasUnit) scale.unit = column.unit;
  const std::vector<std::string> words =
      wordsAndNumbers(hasUnit ? column.name : column.name + " " + column.unit);
  bool isScaled = false, isMultiple = false, hasFactor = false, isError = false;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    const std::string before = i > 0 ? words[i - 1] : "",
                      next = i + 1 < words.size() ? words[i + 1] : "";
    const bool isCounted = beginsWithOneOf(next, "sigma \u03C3 std sd se standard stabw") ||
                           (next == "s" && i + 2 == words.size());
    if (isNumber(word) && halfWidth(word) > 0) {
      hasFactor = true;
      scale.divisor = halfWidth(word);
      // In "CI95 (%)" the sign may belong to the probability or to the error.
      scale.isIndefinite = scale.isIndefinite || (next.empty() && scale.unit == "%");
    } else if (isNumber(word) && (before == "k" || isCounted)) {
      hasFactor = true;
      constexpr std::string_view kLargest = "6";
      if (word.size() > 1 || word == "0" || word > kLargest) scale.isIndefinite = true;
      scale.divisor = word.front() - '0';
      // "mu_error (2 sigma)" names the error twice.
      if (isCounted && isErrorName(scale.name)) ++i;
    } else if (isOneOf(word,
                       "ci confidence interval konfidenzintervall vertrauensbereich "
                       "vertrauensintervall level expanded erweiterte")) {
      isMultiple = isError = true;
    } else if (isOneOf(word, "rsd cv variationskoeffizient")) {
      scale.isShare = isError = true;
    } else if (isOneOf(word, "variance varianz")) {
      scale.isVariance = isError = true;
    } else if (isOneOf(word, "range spannweite streubreite")) {
      scale.isIndefinite = isError = true;
    } else if (word == "sem") {
      isError = true;
    } else if (!(word == "k" && isNumber(next)) &&
               !(word.front() == 'n' && isNumber(word.substr(1)))) {
      scale.name += (scale.name.empty() ? "" : " ") + word;
    }
  }
  isScaled = isError || hasFactor;
  if (!isScaled) return {};
  if (scale.name == "u") scale.name.clear();
  if (scale.name.empty() || (isError && !isErrorName(scale.name))) scale.name += " error";
  if (isMultiple && !hasFactor) scale.isIndefinite = true;
  const auto quantity = findMeaning(scale.name, scale.unit);
  if (quantity != Quantity::MuError && quantity != Quantity::VelocityError) return {};
  return scale;
}

// ---- Columns -----------------------------------------------------------------------------------

namespace {

/// Calls use(column, end) for each column with a known meaning that the words from `begin` to `end`
/// make, `most` words at the most, until it returns true. Returns whether it did.
template <class Use>
bool anyColumn(const std::vector<std::string>& words, std::size_t begin, std::size_t most,
               const Use& use) {
  std::string text;
  for (std::size_t i = begin; i < std::min(words.size(), begin + most); ++i) {
    text += (text.empty() ? "" : " ") + words[i];
    const TextColumn column = parseColumnName(text);
    if (findMeaning(column) && use(column, i + 1)) return true;
  }
  return false;
}

/// Finds all ways to make so many known columns of the words from `begin` on.
void findNames(const std::vector<std::string>& words, std::size_t begin, std::size_t count,
               std::vector<TextColumn>& made, std::vector<std::vector<TextColumn>>& ways) {
  constexpr std::size_t kMostWords = 6, kMostWays = 2;
  if (ways.size() >= kMostWays) return;
  if (made.size() == count || begin == words.size()) {
    if (made.size() == count && begin == words.size()) ways.push_back(made);
    return;
  }
  // A unit in brackets begins no name.
  if (words[begin].starts_with('(') || words[begin].starts_with('[')) return;
  anyColumn(words, begin, kMostWords, [&](const TextColumn& column, std::size_t end) {
    made.push_back(column);
    findNames(words, end, count, made, ways);
    made.pop_back();
    return false;
  });
}

}  // namespace

bool namesQuantity(const std::string& line) {
  constexpr std::size_t kMostWords = 3;
  const std::vector<std::string> words = blankSeparated(line);
  for (std::size_t i = 0; i < words.size(); ++i)
    if (anyColumn(words, i, kMostWords, [](const TextColumn& column, std::size_t) {
          return findMeaning(column) != Quantity::Label && column.name.size() > 1;
        }))
      return true;
  return false;
}

void prepareColumns(TextBlock& block) {
  const bool hasNames = std::ranges::any_of(
      block.columns, [](const TextColumn& column) { return !column.name.empty(); });
  if (!hasNames && !block.header.empty()) {
    std::vector<std::vector<TextColumn>> ways;
    std::vector<TextColumn> made;
    findNames(blankSeparated(lineOf(block.header.back(), " ")), 0, block.columns.size(), made,
              ways);
    for (std::size_t i = 0; ways.size() == 1 && i < block.columns.size(); ++i) {
      block.columns[i].name = ways.front()[i].name;
      block.columns[i].unit = ways.front()[i].unit;
    }
  }
  for (TextColumn& column : block.columns) {
    const std::size_t open = column.name.rfind('(');
    if (!column.unit.empty() || open == std::string::npos || open == 0) continue;
    const std::string unit(withoutBrackets(column.name.substr(open)));
    if (!isShareUnit(unit)) continue;
    column.unit = unit;
    column.name = trimmedBlanks(column.name.substr(0, open));
  }
}

// ---- Lines above the table ---------------------------------------------------------------------

namespace {

using namespace std::string_view_literals;

bool isLoadUnit(const std::string& unit) {
  return std::ranges::any_of(kLoadsAndTemperature,
                             [&](Quantity quantity) { return measures(unit, quantity); });
}

bool isLoad(std::optional<Quantity> quantity) {
  return std::ranges::find(kLoadsAndTemperature, quantity) != kLoadsAndTemperature.end();
}

/// Words that do not change what a name or a value means.
bool isFiller(const std::string& word) {
  return isOneOf(word,
                 "at bei with mit constant const konst konstant konstante konstanter approx "
                 "approximately about ca circa etwa ungef\u00E4hr");
}

/// Returns whether a text names a thing whose load or temperature is not that of the contact.
bool namesOther(std::string_view text) {
  std::vector<std::string> words = wordsIn(text);
  std::erase(words, "g");  // the unit of a mass
  constexpr WordList kOtherThings(
      "track road air water oil storage store aged ageing aging vulc cure curing tg glass cell "
      "sensor "
      "supply pneum tire tyre inflat preload vorlast tensile tear strength young hardness ref tref "
      "strecke fahrbahn luft wasser \u00F6l lager gealtert alter vulk glas zugfest reifen "
      "f\u00FCll umgebung");
  return isOtherLoad(words) || std::ranges::any_of(words, [&](const std::string& word) {
           return beginsWithOneOf(word, kOtherThings) || containsOneOf(word, "aufnehmer modul");
         });
}

/// Returns whether a word belongs to a heading in front of a statement, as in "Test 3: T = 23 °C".
bool isHeading(const std::string& word) {
  constexpr WordList kHeadings(
      "test tests condition conditions parameter parameters measurement experiment setup bedingung "
      "bedingungen versuch versuche messung messbedingungen pr\u00FCfbedingungen pruefbedingungen "
      "versuchsbedingungen randbedingungen");
  return isOneOf(word, kHeadings) || std::ranges::all_of(word, isDigit);
}

/// A value with its unit, and the words behind it: "30 N (constant)".
struct Value {
  double number = 0;
  std::string unit{};
  std::string remark{};
  bool isUnclear = false;  // the mark in the number may separate thousands
  std::string groupedNumber{};
};

/// Splits a text behind a number into a unit of a load or temperature and a remark. Units may have
/// blanks, as in "deg C".
void splitUnit(std::string_view text, Value& value) {
  constexpr std::size_t kLongest = 24;  // bytes of a unit and the blank behind it
  const std::size_t most = text.size() > kLongest ? text.find_last_of(" (", kLongest) : text.size();
  for (std::size_t end = most; end != std::string_view::npos && end > 0;
       end = text.find_last_of(" (", end - 1)) {
    const std::string unit(withoutBrackets(withoutEnd(trimmedBlanks(text.substr(0, end)), ".,;")));
    if (!isLoadUnit(unit)) continue;
    value.unit = unit;
    value.remark = trimmedBlanks(text.substr(end));
    return;
  }
  value.remark = text;
}

/// Returns the position of a sign of tolerance and its length; npos where there is none.
std::pair<std::size_t, std::size_t> findTolerance(std::string_view text) {
  for (const std::string_view sign : WordList("\u00B1 +/- +-"))
    if (const std::size_t at = text.find(sign); at != std::string_view::npos)
      return {at, sign.size()};
  return {std::string_view::npos, 0};
}

/// Reads "30 N", "30 N (constant)", "23 ± 1 °C", "30 N +/- 5 %" and "(23 ± 1) °C".
std::optional<Value> readValue(std::string_view text, HeaderMark mark) {
  text = trimmedField(text);
  std::string opened;
  if (const std::size_t end = text.find(')'); text.starts_with('(') && end != text.npos) {
    opened = std::string(text.substr(1, end - 1)) + " " + std::string(text.substr(end + 1));
    text = opened;
  }
  const auto read = parseQuantity(text, mark.decimal);
  if (!read) return {};
  Value value;
  value.number = read->number;
  if (!mark.isKnown) {
    const auto other = parseQuantity(text, mark.decimal == '.' ? ',' : '.');
    value.isUnclear = !other || other->number != read->number;
  }
  if (read->isGrouped)
    value.groupedNumber = trimmedBlanks(text.substr(0, text.size() - read->unit.size()));
  const std::string_view rest = read->unit;
  const auto [at, size] = findTolerance(rest);
  if (at == std::string_view::npos) {
    splitUnit(rest, value);
    return value;
  }
  const auto tolerance = parseQuantity(rest.substr(at + size), mark.decimal);
  if (!tolerance) return {};
  splitUnit(trimmedBlanks(rest.substr(0, at)), value);
  if (!value.unit.empty()) return value;
  splitUnit(tolerance->unit, value);
  return value;
}

/// Returns the position of the first number that begins a word.
std::size_t findNumber(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!isDigit(text[i])) continue;
    std::size_t begin = i;
    // The bytes of all dashes are among these.
    constexpr std::string_view kSigns = "+-.,\xE2\x88\x92\x80\x90\x91\x93";
    while (begin > 0 && kSigns.find(text[begin - 1]) != std::string_view::npos) --begin;
    const auto before = static_cast<unsigned char>(begin > 0 ? text[begin - 1] : ' ');
    const bool isWithinWord = std::isalnum(before) != 0 || before == '_' || before >= 0x80;
    if (!isWithinWord) return begin;
    while (i + 1 < text.size() && isDigit(text[i + 1])) ++i;
  }
  return std::string_view::npos;
}

/// Returns the load or temperature that has this unit.
std::optional<Quantity> quantityOfUnit(const std::string& unit) {
  for (const Quantity quantity : kLoadsAndTemperature)
    if (measures(unit, quantity)) return quantity;
  return {};
}

/// Returns the load or temperature that has the unit of some number at the beginning of the text,
/// which may be very long.
std::optional<Quantity> findLoadUnit(std::string_view text) {
  constexpr std::size_t kMostBytes = 2000;
  text = text.substr(0, kMostBytes);
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!isDigit(text[i]) || (i > 0 && std::isalnum(static_cast<unsigned char>(text[i - 1])) != 0))
      continue;
    constexpr std::size_t kLongest = 80;  // bytes of a number and its unit
    const auto quantity = parseQuantity(text.substr(i, kLongest));
    Value value;
    if (quantity) splitUnit(quantity->unit, value);
    if (!value.unit.empty()) return quantityOfUnit(value.unit);
  }
  return {};
}

/// Returns a text without its fillers.
std::string withoutFillers(std::string_view text) {
  std::string kept;
  for (const std::string& word : blankSeparated(text)) {
    const std::vector<std::string> plain = nameWords(word);
    if (plain.size() != 1 || !isFiller(plain.front())) kept += (kept.empty() ? "" : " ") + word;
  }
  return kept;
}

/// Reads one statement, such as "Load = 30 N", "T 23 °C" and "Conditions: p [MPa] = 0.2". Nothing
/// where it has no name, no number, or names another quantity; without a quantity where it has a
/// unit of a load or temperature and is not understood.
std::optional<HeaderStatement> readStatement(std::string_view clause, HeaderMark mark) {
  const std::size_t sign = clause.find_last_of(":=");
  const std::size_t begin = sign == clause.npos ? findNumber(clause) : sign + 1;
  if (begin == clause.npos) return {};
  std::string_view written = trimmedBlanks(clause.substr(begin));
  // "approx. 25 \u00B0C"
  if (const std::size_t blank = written.find(' ');
      blank != written.npos && isFiller(plainWord(written.substr(0, blank))))
    written.remove_prefix(blank);
  const auto value = readValue(written, mark);
  if (!value) return {};
  std::string_view front = trimmedBlanks(withoutEnd(clause.substr(0, begin), " :=\t"));
  // In "Temperature - 5 °C" the dash may be a minus sign.
  if (sign == clause.npos && endsWithOneOf(front, "- \u2212 \u2010 \u2011 \u2013 \u2014"))
    return {};
  const std::string_view key = keyBefore(front);
  front = withoutEnd(front.substr(0, front.size() - key.size()), " :=\t");
  TextColumn name = parseColumnName(withoutFillers(key));
  if (name.name.empty()) return {};
  const std::string& unit = value->unit.empty() ? name.unit : value->unit;
  const auto named = findMeaning(name.name, unit);
  const bool isLoadName = isLoad(named);
  // "Line load: 30 N/m"
  const std::vector<std::string> keyWords = nameWords(name.name);
  constexpr std::size_t kShortest = 4;  // letters; shorter names mean something else in a text
  const auto ofLastWord = keyWords.size() > 1 && keyWords.back().size() >= kShortest
                              ? quantityNamed(keyWords.back())
                              : std::nullopt;
  const bool mayBeLoad = isLoad(ofLastWord) && !(value->unit + value->remark).empty();
  // "Temperature: 23 °C (rubber)"
  const std::string remark = withoutFillers(value->remark);
  if (!remark.empty()) name.name += " " + remark;
  const auto quantity = findMeaning(name.name, unit);
  if (quantity ? !isLoad(quantity) : !isLoadName && !isLoadUnit(unit) && !mayBeLoad) return {};
  HeaderStatement statement;
  statement.candidate = isLoadUnit(unit) ? quantityOfUnit(unit) : isLoadName ? named : ofLastWord;
  const std::vector<std::string> headings = nameWords(std::string(front));
  const bool isOfTable =
      std::ranges::all_of(headings, isHeading) || findMeaning(std::string(front), unit) == quantity;
  const auto known = quantity ? unitOfQuantity(unit, *quantity) : std::nullopt;
  if (!known || !isOfTable || value->isUnclear) return statement;
  statement.quantity = quantity;
  statement.value = known->toSi(value->number);
  statement.number = value->number;
  statement.groupedNumber = value->groupedNumber;
  return statement;
}

/// Splits a clause where a second statement begins without a comma: "p = 0.2 MPa T = 23 C",
/// "Load 30 N / T 23 C".
std::vector<std::string_view> splitStatements(std::string_view clause) {
  std::vector<std::string_view> parts;
  for (const std::string_view part : splitText(clause, " / ")) {
    std::size_t begin = 0;
    for (std::size_t sign = part.find_first_of(":="); sign != part.npos;) {
      const std::size_t second = part.find_first_of(":=", sign + 1);
      if (second == part.npos) break;
      const std::string_view front = withoutEnd(part.substr(0, second), " ");
      const std::size_t name = front.find_last_of(" \t");
      if (name != front.npos && name > sign &&
          findNumber(part.substr(sign + 1, name - sign - 1)) != part.npos) {
        parts.push_back(trimmedBlanks(part.substr(begin, name - begin)));
        begin = name + 1;
      }
      sign = second;
    }
    parts.push_back(trimmedBlanks(part.substr(begin)));
  }
  return parts;
}

}  // namespace

bool isRoomTemperature(std::string_view text) {
  const std::vector<std::string> words = wordsIn(text);
  return hasOneOf(words, "rt ambient") ||
         containsOneOf(plainWord(text), "roomtemperature raumtemperatur zimmertemperatur");
}

std::vector<HeaderStatement> readStatements(const TextEntry& entry, HeaderMark mark) {
  const std::string line = lineOf(entry), asWritten = lineOf(entry, ": ");
  const auto complete = [&entry](HeaderStatement statement, std::string text) {
    if (namesOther(text)) statement.candidate.reset();
    statement.text = std::move(text);
    statement.line = entry.line;
    return statement;
  };
  const auto whole = readStatement(line, mark);
  if (whole && whole->quantity) return {complete(*whole, asWritten)};
  // "Aged 168 h, T = 20 \u00B0C" in a table with commas has a statement in front of its key.
  const std::size_t number = findNumber(entry.key);
  const auto first =
      parseQuantity(std::string_view(entry.key).substr(std::min(number, entry.key.size())));
  const bool hasFront = entry.value.find_first_of(":=") != entry.value.npos && first &&
                        !first->unit.empty() && isKnownUnit(first->unit);
  const std::string separated = hasFront ? lineOf(entry, "; ") : line;
  std::vector<std::string_view> clauses;
  for (const std::string_view clause : clausesOf(separated))
    std::ranges::copy(splitStatements(clause), std::back_inserter(clauses));
  std::vector<HeaderStatement> statements;
  for (const std::string_view clause : clauses) {
    // "Load: 30 N; 60 N" states two loads.
    if (const auto value = readValue(clause, mark); value && !statements.empty()) {
      HeaderStatement& before = statements.back();
      if (before.quantity && measures(value->unit, *before.quantity)) before.quantity.reset();
    }
    const std::string text = clauses.size() == 1 ? asWritten : std::string(clause);
    if (const auto statement = readStatement(clause, mark))
      statements.push_back(complete(*statement, text));
    else if (const auto quantity = findLoadUnit(clause))
      statements.push_back(complete({.candidate = quantity}, text));
    else if (isRoomTemperature(clause))
      statements.push_back(complete({.candidate = Quantity::Temperature}, text));
  }
  if (statements.empty() && whole) statements.push_back(complete(*whole, asWritten));
  return statements;
}

}  // namespace asperity
