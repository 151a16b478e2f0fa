#include "core/material/dma_columns.h"

#include <algorithm>
#include <cctype>
#include <span>
#include <utility>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/text.h"
#include "core/base/text_cell.h"
#include "core/base/text_clause.h"
#include "core/base/text_number.h"
#include "core/material/text_quantities.h"

namespace asperity {
namespace {

/// Words after which a letter is the label of a sample.
constexpr WordList kWordsBeforeLabels(
    "sample specimen probe proben pr\u00FCfk\u00F6rper pr\u00FCfling material compound mischung "
    "batch charge lot run series serie type typ \u00E9chantillon campione muestra amostra "
    "pr\u00F3bka "
    "vzorek numune \u043E\u0431\u0440\u0430\u0437\u0435\u0446");

constexpr double kSoftest = 1e3, kStiffest = 1e12;  // Pa, of rubber

ModulusKind modulusKind(std::string_view word) {
  if (containsOneOf(word, "shear schub torsion \u0441\u0434\u0432\u0438\u0433 kayma smyk"))
    return ModulusKind::Shear;
  if (containsOneOf(
          word,
          "young elastizitaetsmod tensil tension zug bend biege compress "
          "\u0440\u0430\u0441\u0442\u044F\u0436 \u044E\u043D\u0433\u0430 \u00E7ekme tahov"))
    return ModulusKind::Tension;
  if (beginsWithOneOf(word, "j |j eta |eta \u03B7 |\u03B7") ||
      containsOneOf(word, "viscosi viskosi"))
    return ModulusKind::Shear;
  if (beginsWithOneOf(word, "d' d* |d") || containsOneOf(word, "complianced' complianced*"))
    return ModulusKind::Tension;
  if (containsOneOf(word, "j' j*")) return ModulusKind::Shear;
  // "g'", "|e*|", "storagemodulusg'", "estorage"
  if (word.starts_with("g") && word != "gamma") return ModulusKind::Shear;
  if (word.starts_with("|g")) return ModulusKind::Shear;
  if (word.starts_with("|e") || (word.starts_with("e") && !word.starts_with("elasti")))
    return ModulusKind::Tension;
  if (word.find("g'") != word.npos || word.find("g*") != word.npos) return ModulusKind::Shear;
  if (word.find("e'") != word.npos || word.find("e*") != word.npos) return ModulusKind::Tension;
  return ModulusKind::Unknown;
}

/// Returns whether a name without blanks names a temperature: not "attempt", nor "temps", the time
/// in French.
bool namesTemperature(std::string_view word) {
  if (word == "temps" || word.starts_with("tempsde")) return false;
  if (isOneOf(word,
              "\u0442\u0435\u043C\u043F\u0435\u0440\u0430\u0442\u0443\u0440\u0430 "
              "\u0442\u0435\u043C\u043F\u0435\u0440\u0430\u0442\u0443\u0440\u0430\u043E\u0431\u0440"
              "\u0430\u0437\u0446\u0430 "
              "s\u0131cakl\u0131k sicaklik teplota "
              "\u6E29\u5EA6 \u6E2C\u5B9A\u6E29\u5EA6 \u8A66\u9A13\u6E29\u5EA6 "
              "\u8A66\u6599\u6E29\u5EA6 \u6D4B\u8BD5\u6E29\u5EA6 \uC628\uB3C4"))
    return true;
  return word.find("temp") != word.npos && word.find("ref") == word.npos &&
         !containsOneOf(word, "attempt template tempor contemp");
}

/// Returns whether a column of this name states a viscosity or a compliance.
MeasuredForm formOfName(std::string_view word) {
  if (containsOneOf(word, "viscosity viskositaet viscosite viscosita viscosidad \u7C98\u5EA6") ||
      beginsWithOneOf(word, "eta |eta \u03B7 |\u03B7"))
    return MeasuredForm::Viscosity;
  if (containsOneOf(word, "compliance nachgiebigkeit") ||
      beginsWithOneOf(word, "j' j* |j d' d* |d*"))
    return MeasuredForm::Compliance;
  return MeasuredForm::Modulus;
}

/// Returns which part a viscosity or a compliance is; none without a mark of an oscillation, as the
/// viscosity of a flow.
DmaQuantity partOf(std::string_view word, MeasuredForm form) {
  using enum DmaQuantity;
  const bool isViscosity = form == MeasuredForm::Viscosity;
  if (containsOneOf(word, "'' doubleprime imagin outofphase losscompl verlustnachg"))
    return isViscosity ? Storage : Loss;
  if (containsOneOf(word, "' prime realpart realteil inphase storagecompl speichernachg"))
    return isViscosity ? Loss : Storage;
  return containsOneOf(word, "* | complex komplex star") ? Magnitude : None;
}

/// Returns whether a name is that of a frequency times a shift factor.
bool isReducedFrequency(std::string_view word) {
  return containsOneOf(word, "reduc reduz redui ridott shift master *at at* \u63DB\u7B97") ||
         word.starts_with("atf") || word.starts_with("redf") ||
         endsWithOneOf(word, "yat qat qred yred zred");
}

/// Frequencies in Hz or as omega by their symbols alone.
constexpr WordList kReducedSymbols("at*f atf fat f*at fred");
constexpr WordList kReducedAngularSymbols(
    "omega*at omegaat atomega at*omega at*w w*at atw wat wred omegared");

/// What names of a quantity contain, and whole names.
struct QuantityNames {
  DmaQuantity quantity;
  WordList parts, whole;

  bool contain(std::string_view word) const {
    return containsOneOf(word, parts) || isOneOf(word, whole);
  }
};

constexpr QuantityNames kLossTangents{
    DmaQuantity::LossTangent,
    "tgdelta \u0442\u0430\u043D\u0433\u0435\u043D\u0441\u0443\u0433\u043B "
    "\u0442\u0430\u043D\u0433\u0435\u043D\u0441\u043F\u043E\u0442\u0435\u0440\u044C "
    "\u0442\u0430\u043D\u0433\u0435\u043D\u0441\u043C\u0435\u0445\u0430\u043D\u0438\u0447"
    "\u0435\u0441\u043A "
    "kay\u0131pfakt kay\u0131ptan ztratov\u00FD\u010Dinitel "
    "tandelta tand tan\u03B4 losstangent lossfactor losstan dampingfactor "
    "verlustfaktor daempfungsfaktor tangentdelta facteurdeperte fattorediperdita "
    "factordeperdida \u640D\u5931\u6B63\u63A5 \u640D\u5931\u4FC2\u6570 "
    "\u635F\u8017\u56E0\u5B50 \uC190\uC2E4\uACC4\uC218",
    "tan"};
constexpr QuantityNames kFrequencies{
    DmaQuantity::Frequency,
    "\u0447\u0430\u0441\u0442\u043E\u0442 frekans pulsation pulsazion "
    "freq frecuenc frekven stotliwo \u5468\u6CE2\u6570 \u9891\u7387 \uC8FC\uD30C\uC218",
    "f nu omega w angular"};
/// The parts of a modulus, a magnitude and its phase, and strains: the first row counts.
constexpr QuantityNames kModuli[] = {
    {DmaQuantity::Loss, "", "img* ime*"},
    {DmaQuantity::Storage, "", "reg* ree*"},
    {DmaQuantity::Loss,
     "\u043C\u043E\u0434\u0443\u043B\u044C\u043F\u043E\u0442\u0435\u0440\u044C "
     "\u043C\u043E\u0434\u0443\u043B\u044C\u043C\u0435\u0445\u0430\u043D\u0438\u0447\u0435"
     "\u0441\u043A\u0438\u0445\u043F\u043E\u0442\u0435\u0440\u044C "
     "kay\u0131pmod kayipmod ztratov\u00FDmod "
     "'' lossmod gloss eloss verlustmodul doubleprime viscousmod modulusloss dprime "
     "moduledeperte modulevisqueux modulodiperdita modulodissipativo moduloviscoso "
     "modulodeperdida modulodeperda verliesmod stratno \u640D\u5931\u5F3E\u6027\u7387 "
     "\u635F\u8017\u6A21\u91CF \uC190\uC2E4\uD0C4\uC131\uB960",
     "loss g2 e2 gpp epp lossg losse gimag eimag"},
    {DmaQuantity::Storage,
     "\u043C\u043E\u0434\u0443\u043B\u044C\u043D\u0430\u043A\u043E\u043F\u043B\u0435"
     "\u043D\u0438\u044F "
     "depolamamod saklamamod pam\u011B\u0165ov\u00FDmod "
     "g' e' m' storage stormod speicher gprime eprime elasticmod moduledeconservation "
     "moduleelastique moduloelastico moduloconservativo modulodealmacenamiento "
     "modulodearmazenamento opslagmod zachowawcz \u8CAF\u8535\u5F3E\u6027\u7387 "
     "\u50A8\u80FD\u6A21\u91CF \uC800\uC7A5\uD0C4\uC131\uB960",
     "g1 e1 gp ep greal ereal"},
    {DmaQuantity::Phase, "phase phasen lossangle verlustwinkel", "delta"},
    {DmaQuantity::Magnitude, "g* e* complexmod komplexermod dynamicmod absmod",
     "m* |m*| |m| gabs eabs |g| |e| gstar estar gmag emag"},
    {DmaQuantity::Strain,
     "strain gamma dehnung deformation "
     "\u0434\u0435\u0444\u043E\u0440\u043C\u0430\u0446\u0438 gerinim deformace",
     ""}};

DmaQuantity dmaQuantity(std::string_view word) {
  using enum DmaQuantity;
  if (word.empty()) return None;
  if (kLossTangents.contain(word)) return LossTangent;
  if (containsOneOf(word, "strainrate energy energie stiffness torque")) return None;
  if (const MeasuredForm form = formOfName(word); form != MeasuredForm::Modulus)
    return partOf(word, form);
  if (kFrequencies.contain(word)) return isReducedFrequency(word) ? ReducedFrequency : Frequency;
  if (isOneOf(word, kReducedSymbols) || isOneOf(word, kReducedAngularSymbols))
    return ReducedFrequency;
  if (namesTemperature(word) || isOneOf(word,
                                        "t ts tc tk tcelsius tkelvin tsample tprobe tset tsoll "
                                        "tist tactual tmeasured ttest tmess"))
    return Temperature;
  // A complex modulus has no such part by its symbol: "G* imaginary part".
  const bool isOfModulus =
      modulusKind(word) != ModulusKind::Unknown || word.find("modul") != word.npos;
  if (isOfModulus && containsOneOf(word, "imaginarypart imagpart imaginaerteil *imag")) return Loss;
  if (isOfModulus && containsOneOf(word, "realpart realteil *real")) return Storage;
  const auto* const found = std::ranges::find_if(
      kModuli, [word](const QuantityNames& names) { return names.contain(word); });
  return found == std::end(kModuli) ? None : found->quantity;
}

/// Letters, and the word that stands for each of them.
using Replacement = std::pair<WordList, std::string_view>;

std::string replaced(std::string text, std::span<const Replacement> replacements) {
  for (const auto& [letters, word] : replacements)
    for (const std::string_view letter : letters) replaceAll(text, letter, word);
  return text;
}

/// Returns the words of a name in lower case: "G'_err" has g and err, "tanDelta" tan and delta.
/// Greek letters are words of their own.
std::vector<std::string> wordsOf(std::string_view name) {
  constexpr Replacement kReplacements[] = {
      {"\u03B4 \u0394", " delta "},
      {"\u03C3", " sigma "},
      {"\u2032 \u2033 \u2019 \u2018 \u201C \u201D \u00B4 \u00A0 \u2217 _", " "}};
  const std::string text = replaced(std::string(name), kReplacements);
  std::string separated;
  for (const char letter : text) {
    const bool isCapital = std::isupper(static_cast<unsigned char>(letter)) != 0;
    if (isCapital && !separated.empty() &&
        std::islower(static_cast<unsigned char>(separated.back())) != 0)
      separated += ' ';
    separated += letter;
  }
  return wordsIn(separated);
}

/// Returns whether a name is that of a deviation or a bound of another column: "std G'", "u(G')",
/// "\u0394G'", "G' \u00B1", "G' 95% CI", "G' min".
bool isOfDeviation(std::string_view name, const std::vector<std::string>& words) {
  if (words.empty()) return false;
  if (containsOneOf(name, kErrorSigns) || containsOneOf(name, "\u0394G \u0394E \u0394|"))
    return true;
  // "dE'", but not "Module de perte".
  if (words.size() > 1 && isOneOf(words.front(), "s u d de")) return true;
  if (words.size() > 1 && words[0] == "delta" && isOneOf(words[1], "g e storage loss modulus"))
    return true;
  return std::ranges::any_of(words, [](const std::string& word) {
    return isOneOf(word,
                   "std sd dev err se sem sigma unc ci var rsd cv cov min max minimum maximum "
                   "lower upper range limit bound iqr mad tolerance toleranz noise dg residual "
                   "spread scatter streuung") ||
           containsOneOf(word,
                         "stdev stddev stderr error deviation uncertain abweichung unsicherheit "
                         "fehler variance varianz confidence konfidenz quantil percentil");
  });
}

/// Returns whether a word is made of those that name moduli and how they were measured.
bool isMadeOfKnownWords(std::string_view word) {
  constexpr WordList kParts(
      "\u043C\u043E\u0434\u0443\u043B\u044C "
      "\u043D\u0430\u043A\u043E\u043F\u043B\u0435\u043D\u0438\u044F "
      "\u043F\u043E\u0442\u0435\u0440\u044C "
      "\u043C\u0435\u0445\u0430\u043D\u0438\u0447\u0435\u0441\u043A\u0438\u0445 "
      "\u0443\u043F\u0440\u0443\u0433\u043E\u0441\u0442\u0438 "
      "\u0441\u0434\u0432\u0438\u0433\u0430 "
      "\u0434\u0438\u043D\u0430\u043C\u0438\u0447\u0435\u0441\u043A\u0438\u0439 "
      "elastik viskoz dinamik depolama saklama kay\u0131p kayip mod\u00FCl\u00FC mod\u00FCl "
      "pam\u011B\u0165ov\u00FD ztr\u00E1tov\u00FD "
      "storage stor loss modulus moduli module modul mod dyn shear youngs young tensile tension "
      "torsional "
      "torsion compression compressive bending bend flexural complex dynamic elastic viscous real "
      "imaginary imag part phase absolute abs magnitude mag star prime double tangent tan delta "
      "factor damping angle lag shifted shift speicher verlust schub zug biege komplexer komplex "
      "dynamischer betrag winkel faktor daempfungs d\u00E4mpfungs teil values value wert mean "
      "average avg mittel measured raw corrected smoothed reduced linear reference ref temperature "
      "temperatur temp of at in out the ratio von bei conservation perte m\u00F3dulo modulo "
      "conservativo dissipativo elastico el\u00E1stico viscoso \u00E9lastique elastique visqueux "
      "perdita p\u00E9rdida perdida almacenamiento viscosity viskosit\u00E4t "
      "compliance nachgiebigkeit eta \u03B7 "
      "armazenamento perda opslag verlies modu\u0142 zachowawczy stratno\u015Bci "
      "\u8CAF\u8535\u5F3E\u6027\u7387 \u640D\u5931\u5F3E\u6027\u7387 \u50A8\u80FD\u6A21\u91CF "
      "\u635F\u8017\u6A21\u91CF \uC800\uC7A5\uD0C4\uC131\uB960 \uC190\uC2E4\uD0C4\uC131\uB960");
  return word.empty() || std::ranges::any_of(kParts, [word](std::string_view part) {
           return word.starts_with(part) && isMadeOfKnownWords(word.substr(part.size()));
         });
}

/// Returns a word without the symbol E or G at its end, which needs no blank after a name in
/// Japanese.
std::string_view withoutGluedSymbol(std::string_view word) {
  const bool hasSymbol = word.size() > 1 && (word.back() == 'e' || word.back() == 'g') &&
                         static_cast<unsigned char>(word[word.size() - 2]) > 0x7F;
  return word.substr(0, word.size() - (hasSymbol ? 1 : 0));
}

/// Returns where the unit at the end of a name (unitText) begins; npos where there is none.
std::size_t unitPart(std::string_view name) {
  const std::size_t bracket = name.find_last_of("([");
  const std::size_t end = name.find_last_not_of(' ');
  if (bracket != name.npos && bracket > 0 && name.find_last_of(")]") == end) return bracket;
  const std::size_t stroke = name.rfind('/');
  return stroke == 0 ? name.npos : stroke;
}

/// Returns the words of a modulus' name that are not understood.
std::string unknownWords(std::string_view name) {
  std::string unknown;
  // M is a modulus of which the name does not say whether it is of shear or of tension.
  const bool mayBeM = modulusKind(compactName(name)) == ModulusKind::Unknown;
  for (const std::string& word : wordsOf(name.substr(0, unitPart(name)))) {
    if ((mayBeM && word == "m") ||
        isOneOf(word,
                "g e d t s p pp g1 g2 e1 e2 gp gpp ep epp gabs eabs gmag emag tand gprime eprime "
                "dprime gdoubleprime edoubleprime gstar estar greal ereal gimag eimag gstorage "
                "estorage gloss eloss lossg re im "
                "losse log lg ln log10 de di j") ||
        isMadeOfKnownWords(withoutGluedSymbol(word)))
      continue;
    appendItem(unknown, word, " ");
  }
  return unknown;
}

/// Returns whether columns of a quantity belong to one frequency where their names state it.
bool mayStateFrequency(DmaQuantity quantity) {
  return isMeasured(quantity) || quantity == DmaQuantity::Temperature ||
         quantity == DmaQuantity::Strain;
}

}  // namespace

bool isModulus(DmaQuantity quantity) {
  using enum DmaQuantity;
  return quantity == Storage || quantity == Loss || quantity == Magnitude;
}

bool isMeasured(DmaQuantity quantity) {
  return isModulus(quantity) || quantity == DmaQuantity::LossTangent ||
         quantity == DmaQuantity::Phase;
}

std::string unitText(std::string_view name) {
  const std::size_t begin = unitPart(name);
  if (begin == name.npos) return {};
  const std::string_view text = withoutBrackets(name.substr(begin));
  return std::string(text.starts_with('/') ? trimmedBlanks(text.substr(1)) : text);
}

std::string compactName(std::string_view name) {
  constexpr Replacement kReplacements[] = {{"\u2033 \u201D \u201C \"", "''"},
                                           {"\u2032 \u2019 \u2018 \u00B4 `", "'"},
                                           {"\u03B4 \u0394", "delta"},
                                           {"\u03C9 \u03A9", "omega"},
                                           {"\u03B3", "gamma"},
                                           {"\u03B5", "strain"},
                                           {"\u03D1 \u03B8", "temp"},
                                           {"\u00E4", "ae"},
                                           {"\u00F6", "oe"},
                                           {"\u00FC", "ue"},
                                           {"\u00E9 \u00E8 \u00C9 \u00C8", "e"},
                                           {"\u00E1 \u00E0", "a"},
                                           {"\u00F3", "o"},
                                           {"\u2217", "*"},
                                           {"\u00B7 \u22C5 \u00D7 \u00A0 \u00B0", ""}};
  std::string text = replaced(lowerCase(name), kReplacements);
  std::erase_if(text, [](char letter) {
    return std::string_view(" _-.\t()[]{},:@").find(letter) != std::string_view::npos;
  });
  return text;
}

double shearFromYoungs(double youngs, double poisson) {
  return youngs / (2 * (1 + poisson));
}

Message dividedForShear(double poisson) {
  return message("moduli of tension, divided by {} for shear (Poisson's ratio {})",
                 printed(2 * (1 + poisson)), printed(poisson));
}

std::optional<Message> otherPoissonNote(const TextPart& in, double poisson) {
  for (const TextEntry* entry : in.entriesAbove()) {
    const std::string line = joinEntry(*entry);
    for (const std::string_view clause : splitClauses(line)) {
      const auto stated = parseStatement(clause);
      if (!stated || stated->quantity.number == poisson) continue;
      const std::string name = lowerCase(stated->name.name);
      if (containsOneOf(name, "poisson querkontraktion querdehn") || isOneOf(name, "nu \u03BD"))
        return message(
            "line {} states a Poisson's ratio of {}, and {} is used; --poisson-ratio replaces it",
            entry->line, printed(stated->quantity.number), printed(poisson));
    }
  }
  return {};
}

namespace {

/// Takes the temperature and the frequency in a name or its unit. Returns the name without them.
std::string takeStates(std::string_view name, std::string_view unit, DmaColumn& column) {
  std::string word(name);
  for (const std::string_view part : {name, unit})
    if (const auto found = firstTemperature(part)) {
      column.temperature = found->kelvin;
      column.isUnitOfState = part.data() != name.data();
      if (!column.isUnitOfState)
        word = std::string(name.substr(0, found->begin)) + std::string(name.substr(found->end));
      break;
    }
  // The unit may have been separated from the number in front of it: "E' 3" and "Hz", "tan delta
  // 20" and "\u00B0C".
  const std::string whole = word + " " + std::string(unit);
  if (const auto found = firstTemperature(whole);
      found && !column.temperature && found->begin < word.size() && found->end > word.size()) {
    const std::string rest = word.substr(0, found->begin);
    if (isMeasured(dmaQuantity(compactName(rest)))) {
      column.temperature = found->kelvin;
      column.isUnitOfState = true;
      return takeStates(rest, "", column);
    }
  }
  if (const auto found = firstFrequency(whole)) {
    const std::string rest = word.substr(0, std::min(found->begin, word.size())) +
                             word.substr(std::min(found->end, word.size()));
    if (mayStateFrequency(dmaQuantity(compactName(rest)))) {
      column.frequency = found->hertz;
      column.isUnitOfState = column.isUnitOfState || found->end > word.size();
      word = rest;
    }
  }
  return word;
}

}  // namespace

DmaColumn dmaColumn(std::string_view name, std::string_view unit) {
  DmaColumn column;
  const std::string word = takeStates(name, unit, column);
  const std::string plain = compactName(word);
  column.quantity = dmaQuantity(plain);
  column.kind = modulusKind(plain);
  column.form = formOfName(plain);
  std::vector<std::string> words = wordsOf(word);
  // "Storage_Modulus_G", but not "Storage modulus (sample G)"
  std::span<const std::string> ofModulus = words;
  if (words.size() > 1 && isOneOf(words[words.size() - 2], kWordsBeforeLabels))
    ofModulus = ofModulus.first(words.size() - 2);
  if (isModulus(column.quantity) && column.kind == ModulusKind::Unknown && !ofModulus.empty())
    column.kind = ofModulus.back() == "g"   ? ModulusKind::Shear
                  : ofModulus.back() == "e" ? ModulusKind::Tension
                                            : ModulusKind::Unknown;
  // "D'" is a compliance, and "dE'" the deviation of a modulus.
  if (column.form == MeasuredForm::Compliance && !words.empty() && words.front() == "d")
    words.front() = "j";
  // "Sample T" and "T furnace"
  if (column.quantity == DmaQuantity::None && words.size() == 2 && isOneOf("t", words) &&
      (hasOneOf(words, kWordsOfSample) || hasOneOf(words, kWordsOfSetPoint) ||
       hasOneOf(words, kWordsOfDevice)))
    column.quantity = DmaQuantity::Temperature;
  for (const std::string& one : words) column.words += " " + one;
  for (const char mark : word)
    if (mark == '*' || mark == '|') column.words += mark;
  // The largest strain of a period is its amplitude.
  const bool isAmplitude = column.quantity == DmaQuantity::Strain && hasOneOf(words, "max maximum");
  column.isLeftOut =
      column.quantity != DmaQuantity::None && !isAmplitude && isOfDeviation(word, words);
  if (column.quantity == DmaQuantity::Strain && !strainUnit(unit)) column.isLeftOut = true;
  if (column.isLeftOut) column.quantity = DmaQuantity::None;
  // "t (s)" is a time.
  if (column.quantity == DmaQuantity::Temperature && unitSize(unit, "s"))
    column.quantity = DmaQuantity::None;
  if (isMeasured(column.quantity)) column.unknown = unknownWords(word);
  column.isAngular =
      containsOneOf(
          plain,
          "omega angular angulaire angolare pulsa kreisfreq "
          "\u0443\u0433\u043B\u043E\u0432\u0430\u044F\u0447\u0430\u0441\u0442\u043E\u0442 "
          "\u043A\u0440\u0443\u0433\u043E\u0432\u0430\u044F\u0447\u0430\u0441\u0442\u043E\u0442 "
          "\u0446\u0438\u043A\u043B\u0438\u0447\u0435\u0441\u043A\u0430\u044F\u0447\u0430\u0441"
          "\u0442\u043E\u0442 a\u00E7\u0131sal \u00FAhlov") ||
      plain == "w" || isOneOf(plain, kReducedAngularSymbols);
  return column;
}

std::optional<Message> unusualModulus(double least, double most) {
  if (most < kSoftest)
    return message(
        "the moduli are at most {:.3g} Pa, which is softer than any rubber: where the file states "
        "a wrong unit, --modulus-unit replaces it",
        most);
  if (least > kStiffest)
    return message(
        "the moduli are at least {:.3g} Pa, which is stiffer than any rubber: where the file "
        "states a wrong unit, --modulus-unit replaces it",
        least);
  return {};
}

void refuseSoftModulus(const std::string& name, const std::string& key, double largest) {
  if (largest < kSoftest)
    throw InputError(name, key,
                     message("has no unit, and {:.3g} Pa would be no rubber; say --modulus-unit "
                             "MPa or another one",
                             largest));
}

}  // namespace asperity
