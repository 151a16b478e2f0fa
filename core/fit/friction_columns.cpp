#include "core/fit/friction_columns.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <numeric>
#include <utility>

#include "core/base/text.h"
#include "core/base/text_clause.h"
#include "core/base/text_dialect.h"
#include "core/base/text_number.h"
#include "core/base/text_units.h"
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
     "\u0441\u043A\u043E\u0440\u043E\u0441\u0442\u044C "
     "\u0441\u043A\u043E\u0440\u043E\u0441\u0442\u044C\u0441\u043A\u043E\u043B\u044C\u0436\u0435"
     "\u043D\u0438\u044F "
     "h\u0131z kaymah\u0131z\u0131 rychlost kluzn\u00E1rychlost rychlostskluzu "
     "velocity v speed slidingvelocity slidingspeed vslide vs slipvelocity slipspeed vslip "
     "geschwindigkeit "
     "gleitgeschwindigkeit gleitgeschw geschw vgleit vitesse vitessedeglissement velocit\u00E0 "
     "velocita velocit\u00E0distrisciamento velocidad velocidaddedeslizamiento "
     "velocidade velocidadededeslizamento hastighet glidhastighet "
     "pr\u0119dko\u015B\u0107po\u015Blizgu snelheid glijsnelheid "
     "pr\u0119dko\u015B\u0107 "
     "\uC18D\uB3C4 "
     "\u901F\u5EA6 \u3059\u3079\u308A\u901F\u5EA6 \u6ED1\u308A\u901F\u5EA6 "
     "\u6ED1\u52A8\u901F\u5EA6"},
    {Quantity::Mu, "coefficient of friction",
     "\u043A\u043E\u044D\u0444\u0444\u0438\u0446\u0438\u0435\u043D\u0442\u0442\u0440\u0435\u043D"
     "\u0438\u044F "
     "\u043A\u043E\u044D\u0444\u0444\u0438\u0446\u0438\u0435\u043D\u0442\u0442\u0440\u0435\u043D"
     "\u0438\u044F\u0441\u043A\u043E\u043B\u044C\u0436\u0435\u043D\u0438\u044F "
     "s\u00FCrt\u00FCnmekatsay\u0131s\u0131 sou\u010Dinitelt\u0159en\u00ED "
     "koeficientt\u0159en\u00ED "
     "mu mue m\u00FC \u00B5 \u03BC cof friction frictionfactor frictioncoefficient frictioncoeff "
     "frictioncoef "
     "coefficientoffriction coeffoffriction coefoffriction coefficient reibwert "
     "reibungszahl reibbeiwert reibungskoeffizient muk mukin mukinetic mudyn mudynamic "
     "\u00B5k \u03BCk mud \u00B5d \u03BCd kineticfriction dynamicfriction slidingfriction "
     "kineticcof dynamiccof slidingcof cofkinetic cofdynamic kineticfrictioncoefficient "
     "dynamicfrictioncoefficient kineticcoefficientoffriction dynamiccoefficientoffriction "
     "coefficientofkineticfriction coefficientofdynamicfriction mugleit muegleit \u00B5gleit "
     "\u03BCgleit "
     "gleitreibung gleitreibwert gleitreibungszahl "
     "gleitreibungskoeffizient coefficientdefrottement coefdefrottement coefficientediattrito "
     "coefficientedattrito "
     "coeffdiattrito coeficientedefricci\u00F3n coeficientedefriccion coeficientederozamiento "
     "coeficientedeatrito friktionskoefficient friktionstal wrijvingsco\u00EBffici\u00EBnt "
     "wrijvingscoefficient "
     "wsp\u00F3\u0142czynniktarcia "
     "\u6469\u64E6\u4FC2\u6570 \u6469\u64E6\u7CFB\u6570 \uB9C8\uCC30\uACC4\uC218"},
    {Quantity::Force, "normal force",
     "\u043D\u0430\u0433\u0440\u0443\u0437\u043A\u0430 "
     "\u043D\u043E\u0440\u043C\u0430\u043B\u044C\u043D\u0430\u044F\u043D\u0430\u0433\u0440\u0443"
     "\u0437\u043A\u0430 "
     "\u043D\u043E\u0440\u043C\u0430\u043B\u044C\u043D\u0430\u044F\u0441\u0438\u043B\u0430 "
     "normaly\u00FCk normalkuvvet y\u00FCk norm\u00E1lov\u00E1s\u00EDla "
     "zat\u00ED\u017Een\u00ED norm\u00E1lov\u00E9zat\u00ED\u017Een\u00ED "
     "normalforce fn fz f force load normalload w n normalkraft kraft last normallast belastung "
     "auflast anpresskraft radlast wheelload verticalforce verticalload vertikalkraft "
     "vertikallast forcenormale chargenormale forzanormale cariconormale caricoverticale "
     "fuerzanormal normaalkracht "
     "carganormal for\u00E7anormal obci\u0105\u017Cenie si\u0142anormalna nacisk charge carico "
     "carga \u8F7D\u8377 \u6CD5\u5411\u8F7D\u8377 \uD558\uC911 "
     "\uC218\uC9C1\uD558\uC911 \u8377\u91CD \u5782\u76F4\u8377\u91CD \u6CD5\u5411\u529B"},
    {Quantity::Pressure, "nominal pressure",
     "\u0434\u0430\u0432\u043B\u0435\u043D\u0438\u0435 "
     "\u043A\u043E\u043D\u0442\u0430\u043A\u0442\u043D\u043E\u0435\u0434\u0430\u0432\u043B\u0435"
     "\u043D\u0438\u0435 "
     "\u043D\u043E\u043C\u0438\u043D\u0430\u043B\u044C\u043D\u043E\u0435\u0434\u0430\u0432\u043B"
     "\u0435\u043D\u0438\u0435 "
     "bas\u0131n\u00E7 temasbas\u0131nc\u0131 tlak kontaktn\u00EDtlak "
     "nominalpressure pressure contactpressure normalpressure nominalcontactpressure normalstress "
     "pression pressione presion presi\u00F3n \u9762\u5727 p p0 pn pnom sigma \u03C3 sigma0 "
     "\u03C30 sigman \u03C3n sigmaz \u03C3z druck fl\u00E4chenpressung flaechenpressung "
     "pressung normalspannung nenndruck"},
    {Quantity::Temperature, "temperature",
     "\u0442\u0435\u043C\u043F\u0435\u0440\u0430\u0442\u0443\u0440\u0430 "
     "\u0442\u0435\u043C\u043F\u0435\u0440\u0430\u0442\u0443\u0440\u0430\u043E\u0431\u0440\u0430"
     "\u0437\u0446\u0430 "
     "s\u0131cakl\u0131k teplota "
     "temperature temp t \u03D1 temperatur sampletemperature specimentemperature rubbertemperature "
     "tsample tspecimen trubber probentemperatur gummitemperatur tprobe tgummi testtemperature "
     "temperaturerubber temperaturesample temperaturespecimen pr\u00FCftemperatur prueftemperatur "
     "temp\u00E9rature temperatura \u6E29\u5EA6 temperaturgummi temperaturprobe messtemperatur "
     "temperatuur \uC628\uB3C4 "
     "versuchstemperatur"},
    {Quantity::Label, "label",
     "\u043E\u0431\u0440\u0430\u0437\u0435\u0446 numune vzorek "
     "run lauf wiederholung label sample name set series specimen probe bezeichnung comment track "
     "surface"},
    {Quantity::MuError, "error of the coefficient of friction", ""},
    {Quantity::VelocityError, "error of the velocity", ""}};

/// Returns the rest of a word without the part that marks an error; nothing where there is no such
/// part.
std::optional<std::string> withoutError(std::string word) {
  constexpr WordList kSigns(
      "\u6807\u51C6\u5DEE \u6807\u51C6\u504F\u5DEE desviopadr\u00E3o standardavvikelse "
      "\u00E9carttype \u00C9carttype ecarttype deviazionestandard desviaci\u00F3nest\u00E1ndar "
      "desviacionestandar incertitude incertezza incertidumbre \u6A19\u6E96\u504F\u5DEE stabw "
      "\u0441\u0442\u0430\u043D\u0434\u0430\u0440\u0442\u043D\u043E\u0435\u043E\u0442\u043A\u043B"
      "\u043E\u043D\u0435\u043D\u0438\u0435 "
      "\u043F\u043E\u0433\u0440\u0435\u0448\u043D\u043E\u0441\u0442\u044C "
      "standartsapma sm\u011Brodatn\u00E1odchylka "
      "standarderror standarddeviation standarduncertainty standardabweichung standardabw stdabw "
      "standardunsicherheit standardfehler messunsicherheit uncertainty error stdev stddev sigma "
      "unsicherheit abweichung fehler err std dev sd se \u00B1 \u03C3 delta \u0394");
  for (const std::string_view sign : kSigns) {
    const std::size_t index = word.find(sign);
    // Two letters mark an error only at the beginning or end of a word: "sets" has no error.
    if (index == std::string::npos) continue;
    if (sign.size() == 2 && sign[0] < 'z' && index != 0 && index + 2 != word.size()) continue;
    word.erase(index, sign.size());
    if (word.starts_with("of")) word.erase(0, 2);
    if (word.starts_with("in")) word.erase(0, 2);
    // "COF" is no "of".
    if (word.ends_with("of") && !quantityNamed(word)) word.resize(word.size() - 2);
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
  return isOneOf(word,
                 "t \u03D1 n w f charge carico carga sigma \u03C3 sigman \u03C3n sigmaz \u03C3z");
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
  for (const std::string& word : words) appendItem(kept, word, " ");
  return kept;
}

/// Returns whether a name can be split into words and a symbol that both say the same.
bool isStatedTwice(const std::string& name,
                   const std::function<bool(const std::string&, const std::string&)>& agree) {
  constexpr std::size_t kMaxWords = 8;
  const std::vector<std::string> words = nameWords(name);
  for (std::size_t i = 1; i < words.size() && words.size() <= kMaxWords; ++i) {
    std::string front, back;
    for (std::size_t j = 0; j < words.size(); ++j) (j < i ? front : back) += words[j];
    if (agree(front, back)) return true;
  }
  return false;
}

/// Returns the quantity that a name states in words and by its symbol: "Normal force F_N",
/// "Temperature T".
std::optional<Quantity> namedTwice(const std::string& name) {
  std::optional<Quantity> quantity;
  const bool isTwice = isStatedTwice(name, [&](const std::string& front, const std::string& back) {
    quantity = quantityNamed(front);
    return quantity && !isAmbiguous(front) && quantity == quantityNamed(back);
  });
  return isTwice ? quantity : std::nullopt;
}

}  // namespace

std::vector<std::string> nameWords(std::string text) {
  std::ranges::replace(text, '_', ' ');
  std::ranges::replace(text, '-', ' ');
  std::vector<std::string> words;
  for (const std::string_view word : splitWords(text)) words.push_back(plainWord(word));
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

std::optional<FrictionQuantity> quantityInText(const std::string& word) {
  constexpr std::size_t kFewLetters = 3;
  return word.size() > kFewLetters ? quantityNamed(word) : std::nullopt;
}

std::optional<Unit> unitOfQuantity(const std::string& unit, Quantity quantity) {
  if (unit.empty()) return {};
  if (quantity == Quantity::Force) return unitInAnyCase(unit, "N");
  if (quantity == Quantity::Pressure) return unitInAnyCase(unit, "Pa");
  if (quantity == Quantity::Velocity) return unitInAnyCase(unit, "m/s");
  return quantity == Quantity::Temperature ? temperatureUnit(unit) : std::nullopt;
}

bool measures(const std::string& unit, Quantity quantity) {
  return unitOfQuantity(unit, quantity).has_value();
}

std::optional<FrictionQuantity> quantityOfUnit(const std::string& unit) {
  for (const Quantity quantity : kLoadsAndTemperature)
    if (measures(unit, quantity)) return quantity;
  return {};
}

std::optional<FrictionQuantity> stateOfUnit(const std::string& unit) {
  return measures(unit, Quantity::Velocity) ? Quantity::Velocity : quantityOfUnit(unit);
}

bool isAmbiguousName(const std::string& name) {
  return isAmbiguous(plainWord(name)) || withoutAverage(name);
}

bool isNameOfSliding(const std::string& name) {
  const std::string word = plainWord(name);
  return word == "vs" || containsOneOf(word,
                                       "slid slip gleit \u0441\u043A\u043E\u043B\u044C\u0436 kayma "
                                       "kluz glissement strisciamento deslizamiento "
                                       "\u3059\u3079\u308A \u6ED1\u308A");
}

bool isRelativeError(const std::string& name) {
  return std::ranges::any_of(nameWords(name),
                             [](const std::string& word) { return word.starts_with("rel"); });
}

bool isScatter(const std::string& name) {
  const std::string word = plainWord(name);
  if (containsOneOf(word, "err fehler")) return false;
  return containsOneOf(
             word,
             "std stdev stddev deviation abw deviazione desviaci \u00E9carttype ecarttype "
             "\u6A19\u6E96\u504F\u5DEE varian") ||
         hasOneOf(nameWords(name), "sd s rsd cv sigma \u03C3") ||
         (word.starts_with('s') && quantityNamed(word.substr(1)) == Quantity::Mu);
}

bool isErrorOfMean(const std::string& name) {
  return hasOneOf(nameWords(name), "sem se") ||
         containsOneOf(plainWord(name), "standarderr stderr standardfehler errorofthemean");
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
               "fric tang later shear drag tract longi pull reib quer l\u00E4ngs umfang zug "
               "schub modul");
  };
  return isOther(std::accumulate(words.begin(), words.end(), std::string())) ||
         std::ranges::any_of(words, isOther);
}

bool isForceOfFriction(const std::string& name) {
  return isOneOf(plainWord(name),
                 "fx ft fr ff frictionforce frictionalforce tangentialforce reibkraft "
                 "reibungskraft tangentialkraft forcedefrottement forcetangentielle "
                 "\u0441\u0438\u043B\u0430\u0442\u0440\u0435\u043D\u0438\u044F "
                 "s\u00FCrt\u00FCnmekuvveti t\u0159ec\u00EDs\u00EDla "
                 "forzadiattrito forzatangenziale fuerzadefricci\u00F3n fuerzadefriccion "
                 "fuerzaderozamiento fuerzatangencial");
}

bool meansForceOfFriction(const std::string& name) {
  const auto plain = withoutAverage(name);
  return isForceOfFriction(name) || (plain && isForceOfFriction(*plain)) ||
         isStatedTwice(name, [](const std::string& front, const std::string& back) {
           return isForceOfFriction(front) && isForceOfFriction(back);
         });
}

std::string stateNamed(const std::string& word, const std::string& unit) {
  const auto state = stateOfUnit(unit);
  const bool isNamed = state && quantityNamed(word) && findMeaning(word, unit) == state;
  return isNamed ? meaningOf(*state) : "";
}

std::optional<FrictionQuantity> findMeaning(const std::string& name, const std::string& unit) {
  const std::string word = plainWord(name);
  const auto named = quantityNamed(word);
  // "Load (MPa)", but not "Normal force (MPa)"
  if (named == Quantity::Force && measures(unit, Quantity::Pressure) &&
      containsOneOf(word,
                    "load last belastung charge carico carga "
                    "\u043D\u0430\u0433\u0440\u0443\u0437\u043A\u0430 y\u00FCk "
                    "zat\u00ED\u017Een\u00ED \u8F7D\u8377 \uD558\uC911 \u8377\u91CD"))
    return Quantity::Pressure;
  if (named && (!isAmbiguous(word) || unit == kAnyUnit || measures(unit, *named))) return named;
  if (const auto twice = namedTwice(name)) return twice;
  if (const auto plain = withoutAverage(name)) return findMeaning(*plain, unit);
  const std::string error = isRelativeError(name) ? withoutRelative(word) : word;
  std::optional<std::string> subject = withoutError(error);
  if (!subject) subject = withoutErrorLetter(error);
  if (!subject) return {};
  if (subject->empty()) return Quantity::MuError;
  const auto ofError = quantityNamed(*subject);
  if (ofError == Quantity::Mu) return Quantity::MuError;
  if (ofError == Quantity::Velocity) return Quantity::VelocityError;
  return {};
}

std::optional<FrictionQuantity> findMeaning(const TextColumn& column) {
  const auto scale = findErrorScale(column);
  if (!scale) return findMeaning(column.name, column.unit);
  return scale->isIndefinite ? std::nullopt : findMeaning(scale->name, scale->unit);
}

namespace {

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
  bool isMultiple = false, hasFactor = false, isError = false;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    const std::string before = i > 0 ? words[i - 1] : "",
                      next = i + 1 < words.size() ? words[i + 1] : "";
    const bool isCounted = beginsWithOneOf(next, "sigma \u03C3 std sd se standard stabw") ||
                           (next == "s" && i + 2 == words.size());
    if (areDigits(word) && halfWidth(word) > 0) {
      hasFactor = true;
      scale.divisor = halfWidth(word);
      // In "CI95 (%)" the sign may belong to the probability or to the error.
      scale.isIndefinite = scale.isIndefinite || (next.empty() && scale.unit == "%");
    } else if (areDigits(word) && (before == "k" || isCounted)) {
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
    } else if (!(word == "k" && areDigits(next)) &&
               !(word.front() == 'n' && areDigits(word.substr(1)))) {
      appendItem(scale.name, word, " ");
    }
  }
  if (!isError && !hasFactor) return {};
  if (scale.name == "u") scale.name.clear();
  if (scale.name.empty() || (isError && !isErrorName(scale.name))) scale.name += " error";
  if (isMultiple && !hasFactor) scale.isIndefinite = true;
  const auto quantity = findMeaning(scale.name, scale.unit);
  if (quantity != Quantity::MuError && quantity != Quantity::VelocityError) return {};
  return scale;
}

}  // namespace asperity
