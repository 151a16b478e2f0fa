#include "core/fit/friction_header.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <string_view>
#include <utility>

#include "core/base/input_error.h"
#include "core/base/text.h"
#include "core/base/text_cell.h"
#include "core/base/text_clause.h"
#include "core/base/text_dialect.h"
#include "core/base/text_header.h"
#include "core/base/text_number.h"
#include "core/base/text_units.h"
#include "core/material/dma_columns.h"

namespace asperity {
namespace {

using namespace std::string_view_literals;

bool isLoad(std::optional<FrictionQuantity> quantity) {
  return std::ranges::find(kLoadsAndTemperature, quantity) != kLoadsAndTemperature.end();
}

bool saysLoad(FrictionQuantity quantity) {
  return quantity == FrictionQuantity::Force || quantity == FrictionQuantity::Pressure;
}

/// Returns whether two statements exclude each other: a force and a pressure both say the load.
bool sayTheSame(FrictionQuantity one, FrictionQuantity other) {
  return one == other || (saysLoad(one) && saysLoad(other));
}

/// Words that do not change what a name or a value means.
bool isFiller(const std::string& word) {
  return isOneOf(word,
                 "at bei with mit constant const konst konstant konstante konstanter approx "
                 "approximately about ca circa etwa ungef\u00E4hr");
}

/// Returns whether a statement with these words is about the hardness of the rubber.
bool isOfHardness(const std::vector<std::string>& words) {
  return !words.empty() && beginsWithOneOf(words.front(), "hardness h\u00E4rte haerte shore irhd");
}

/// Returns whether a text states the stress of the rubber at a strain: "Stress at 100 %: 3 MPa",
/// "Spannung bei 100 % Dehnung: 3 MPa". "50 % of the load" is none.
bool isStressAtStrain(std::string_view text) {
  const std::size_t percent = text.find('%');
  if (percent == text.npos) return false;
  std::vector<std::string> front = wordsIn(text.substr(0, percent));
  if (front.size() < 2 || !isDigit(front.back().front())) return false;
  front.pop_back();
  const std::string_view rest = text.substr(percent + 1);
  const auto behind = wordsIn(rest.substr(0, rest.find_first_of(":=0123456789")));
  return hasOneOf(front, "stress spannung spannungswert zugspannung") &&
         std::ranges::all_of(
             front,
             [](const std::string& word) {
               return isOneOf(word, "stress tensile spannung spannungswert zugspannung at bei");
             }) &&
         std::ranges::all_of(behind, [](const std::string& word) {
           return isOneOf(word, "strain elongation extension dehnung");
         });
}

/// Returns whether a text names a thing whose load or temperature is not that of the contact.
bool namesOther(std::string_view text) {
  std::vector<std::string> words = wordsIn(text);
  std::erase(words, "g");  // the unit of a mass
  constexpr WordList kOtherThings(
      "track road air water oil storage store aged ageing aging vulc cure curing mould mold tg "
      "glass cell "
      "sensor supply pneum tire tyre inflat preload vorlast tensile tear strength young hardness "
      "rebound resil r\u00FCckprall elongation bruchdehn m50 m100 m200 m300 s100 s200 s300 "
      "\u03C3100 \u03C3200 \u03C3300 h\u00E4rte haerte ref tref "
      "strecke fahrbahn luft wasser \u00F6l lager gealtert alter vulk glas zugfest reifen "
      "f\u00FCll umgebung");
  return isOtherLoad(words) || isOfHardness(words) || isStressAtStrain(text) ||
         std::ranges::any_of(words, [&](const std::string& word) {
           return beginsWithOneOf(word, kOtherThings) || containsOneOf(word, "aufnehmer modul");
         });
}

/// Returns whether a word belongs to a heading in front of a statement, as in "Test 3: T = 23 °C".
bool isHeading(const std::string& word) {
  constexpr WordList kHeadings(
      "test tests condition conditions parameter parameters measurement experiment setup bedingung "
      "bedingungen versuch versuche messung messbedingungen pr\u00FCfbedingungen pruefbedingungen "
      "versuchsbedingungen randbedingungen");
  return isOneOf(word, kHeadings) || areDigits(word);
}

/// A value with its unit, and the words after it: "30 N (constant)".
struct Value {
  double number = 0;
  std::string unit{};
  std::string remark{};
  bool isUnclear = false;  // the mark in the number may separate thousands
  std::string groupedNumber{};
};

/// Splits a text after a number into a unit of a load or temperature and a remark. Units may have
/// blanks, as in "deg C".
void splitUnit(std::string_view text, Value& value) {
  constexpr std::size_t kLongest = 24;  // bytes of a unit and the space after it
  const std::size_t most = text.size() > kLongest ? text.find_last_of(" (", kLongest) : text.size();
  for (std::size_t end = most; end != std::string_view::npos && end > 0;
       end = text.find_last_of(" (", end - 1)) {
    const std::string unit(withoutBrackets(withoutEnd(trimmedBlanks(text.substr(0, end)), ".,;")));
    if (!quantityOfUnit(unit) && !measures(unit, FrictionQuantity::Velocity)) continue;
    value.unit = unit;
    value.remark = trimmedBlanks(text.substr(end));
    return;
  }
  value.remark = text;
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
  const auto sides = splitAtErrorSign(read->unit);
  if (!sides) {
    splitUnit(read->unit, value);
    return value;
  }
  const auto tolerance = parseQuantity(sides->error, mark.decimal);
  if (!tolerance) return {};
  splitUnit(trimmedBlanks(sides->number), value);
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

/// Returns the load or temperature that has the unit of some number at the beginning of the text,
/// which may be very long.
std::optional<FrictionQuantity> findLoadUnit(std::string_view text) {
  constexpr std::size_t kMaxBytes = 2000;
  text = text.substr(0, kMaxBytes);
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!isDigit(text[i]) || (i > 0 && std::isalnum(static_cast<unsigned char>(text[i - 1])) != 0))
      continue;
    constexpr std::size_t kLongest = 80;  // bytes of a number and its unit
    const auto quantity = parseQuantity(text.substr(i, kLongest));
    Value value;
    if (quantity) splitUnit(quantity->unit, value);
    if (const auto found = quantityOfUnit(value.unit)) return found;
  }
  return {};
}

/// Returns a text without its fillers.
std::string withoutFillers(std::string_view text) {
  std::string kept;
  for (const std::string_view word : splitWords(text)) {
    const std::vector<std::string> plain = nameWords(std::string(word));
    if (plain.size() != 1 || !isFiller(plain.front())) appendItem(kept, word, " ");
  }
  return kept;
}

/// Returns the load or temperature that a statement may be about, by its unit, its name or the last
/// word of its name: "Line load: 30 N/m". A weight in kilograms may be the one that presses the
/// rubber.
std::optional<FrictionQuantity> possibleQuantity(const std::string& name, const std::string& unit,
                                                 const Value& value) {
  if (const auto ofUnit = quantityOfUnit(unit)) return ofUnit;
  if (const auto named = findMeaning(name, unit); isLoad(named)) return named;
  if (plainWord(value.remark.empty() ? unit : value.remark) == "kg" &&
      isOneOf(plainWord(name), "weight deadweight mass gewicht auflagegewicht masse"))
    return FrictionQuantity::Force;
  const std::vector<std::string> words = nameWords(name);
  const auto ofLastWord = words.size() > 1 ? quantityInText(words.back()) : std::nullopt;
  const bool hasUnit = !(value.unit + value.remark).empty();
  return hasUnit && isLoad(ofLastWord) ? ofLastWord : std::nullopt;
}

/// Reads one statement, such as "Load = 30 N", "T 23 °C" and "Conditions: p [MPa] = 0.2". Nothing
/// where it has no name, no number, or names another quantity; without a quantity where it has a
/// unit of a load or temperature and is not understood. A velocity counts where it is understood.
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
  HeaderStatement statement;
  statement.candidate = possibleQuantity(name.name, unit, *value);
  // "Temperature: 23 °C (rubber)"
  const std::string remark = withoutFillers(value->remark);
  if (!remark.empty()) name.name += " " + remark;
  const auto quantity = findMeaning(name.name, unit);
  const bool isVelocity = quantity == FrictionQuantity::Velocity;
  if (quantity ? !isLoad(quantity) && !isVelocity : !statement.candidate) return {};
  const std::vector<std::string> headings = nameWords(std::string(front));
  const bool isOfTable =
      std::ranges::all_of(headings, isHeading) || findMeaning(std::string(front), unit) == quantity;
  const auto known = quantity ? unitOfQuantity(unit, *quantity) : std::nullopt;
  if (!known || !isOfTable || value->isUnclear)
    return isVelocity ? std::nullopt : std::optional(statement);
  statement.quantity = quantity;
  statement.value = known->toSi(value->number);
  statement.isNegative = saysLoad(*quantity) && statement.value < 0;
  if (statement.isNegative) statement.value = -statement.value;
  statement.number = value->number;
  statement.groupedNumber = value->groupedNumber;
  return statement;
}

/// Reads "Tested at 23 \u00B0C", a sentence that says nothing but the temperature of the test.
std::optional<HeaderStatement> readSentence(std::string_view clause, HeaderMark mark) {
  constexpr WordList kOfTest(
      "test tests tested testing measured measurement measurements experiment friction versuch "
      "versuche messung messungen gemessen pr\u00FCfung pruefung gepr\u00FCft geprueft reibung "
      "reibversuch reibungsmessung");
  const std::size_t begin = std::min(findNumber(clause), clause.size());
  std::vector<std::string> words = wordsIn(clause.substr(0, begin));
  if (words.size() < 2 || !isOneOf(words.back(), "at bei")) return {};
  words.pop_back();
  const auto isOfTest = [&](const std::string& word) { return isOneOf(word, kOfTest); };
  const auto value = readValue(clause.substr(begin), mark);
  if (!std::ranges::all_of(words, isOfTest) || !value || value->isUnclear || !value->remark.empty())
    return {};
  const auto unit = unitOfQuantity(value->unit, FrictionQuantity::Temperature);
  if (!unit) return {};
  HeaderStatement statement;
  statement.quantity = statement.candidate = FrictionQuantity::Temperature;
  statement.value = unit->toSi(value->number);
  statement.number = value->number;
  statement.isSentence = true;
  return statement;
}

/// Returns whether a clause is a temperature alone.
bool isBareTemperature(std::string_view clause, HeaderMark mark) {
  const auto value = readValue(clause, mark);
  return value && value->remark.empty() && measures(value->unit, FrictionQuantity::Temperature);
}

/// Splits a clause where a second statement begins without a comma: "p = 0.2 MPa T = 23 C",
/// "Load 30 N / T 23 C".
std::vector<std::string_view> splitAtKeys(std::string_view clause) {
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

/// Returns whether a text says "room temperature" without a number.
bool isRoomTemperature(std::string_view text) {
  const std::vector<std::string> words = wordsIn(text);
  return hasOneOf(words, "rt ambient") ||
         containsOneOf(plainWord(text), "roomtemperature raumtemperatur zimmertemperatur");
}

/// Returns the loads and temperatures that a line states, also those that are not understood but
/// have a unit of such a quantity.
std::vector<HeaderStatement> readStatements(const TextEntry& entry, HeaderMark mark) {
  const std::string line = joinEntry(entry);
  const auto complete = [&](HeaderStatement statement, const std::string& text) {
    if (namesOther(text)) statement.candidate.reset();
    statement.text = text == line ? entry.written : text;
    statement.line = entry.line;
    return statement;
  };
  const auto whole = readStatement(line, mark);
  if (whole && whole->quantity) return {complete(*whole, line)};
  // "Aged 168 h, T = 20 \u00B0C" in a table with commas has a statement in front of its key.
  const std::size_t number = findNumber(entry.key);
  const auto first =
      parseQuantity(std::string_view(entry.key).substr(std::min(number, entry.key.size())));
  const bool hasFront = entry.value.find_first_of(":=") != entry.value.npos && first &&
                        !first->unit.empty() && isKnownUnit(first->unit);
  const std::string separated = hasFront ? joinEntry(entry, "; ") : line;
  std::vector<std::string_view> clauses;
  for (const std::string_view clause : splitClauses(separated))
    std::ranges::copy(splitAtKeys(clause), std::back_inserter(clauses));
  std::vector<HeaderStatement> statements;
  // "Hardness: 60 Shore A, 23 \u00B0C"
  const bool isHardness = clauses.size() == 2 && isOfHardness(wordsIn(clauses.front())) &&
                          isBareTemperature(clauses.back(), mark);
  for (const std::string_view clause : clauses) {
    // "Load: 30 N; 60 N" states two loads.
    if (const auto value = readValue(clause, mark); value && !statements.empty()) {
      HeaderStatement& before = statements.back();
      if (before.quantity && measures(value->unit, *before.quantity)) before.quantity.reset();
    }
    const std::string text = clauses.size() == 1 ? line : std::string(clause);
    const std::size_t before = statements.size();
    if (const auto sentence = readSentence(clause, mark))
      statements.push_back(complete(*sentence, text));
    else if (const auto statement = readStatement(clause, mark))
      statements.push_back(complete(*statement, text));
    else if (const auto quantity = findLoadUnit(clause))
      statements.push_back(complete({.candidate = quantity}, text));
    else if (isRoomTemperature(clause))
      statements.push_back(complete({.candidate = FrictionQuantity::Temperature}, text));
    if (isHardness && statements.size() > before) statements.back().candidate.reset();
  }
  if (statements.empty() && whole) statements.push_back(complete(*whole, line));
  return statements;
}

/// Throws InputError for a load or temperature above the table that is not understood and may be
/// the one meant, unless another line or column gives it.
void refuseUnclear(const HeaderStatement& one, const std::vector<HeaderStatement>& common,
                   const std::function<bool(FrictionQuantity)>& isGiven, const std::string& name) {
  if (one.quantity || !one.candidate || isGiven(*one.candidate)) return;
  for (const HeaderStatement& other : common)
    if (sayTheSame(*other.quantity, *one.candidate)) return;
  struct WayOut {
    FrictionQuantity quantity;
    const char *example, *key;
  };
  constexpr WayOut kWaysOut[] = {
      {FrictionQuantity::Temperature, "Temperature: 23 \u00B0C", "elastomer.temperature"},
      {FrictionQuantity::Pressure, "Nominal pressure: 0.2 MPa", "load.nominal_pressure"},
      {FrictionQuantity::Force, "Normal force: 30 N", "load.normal_force"}};
  const auto& [quantity, example, key] =
      *std::ranges::find(kWaysOut, *one.candidate, &WayOut::quantity);
  throw InputError(
      name, "",
      message("line {}: '{}' may state the {}, but is not understood; write it as in \"{}\", or "
              "take the line out and set {}",
              one.line, shortened(one.text), Message(meaningOf(quantity)), example, key));
}

}  // namespace

HeaderStatements readHeader(const std::vector<TextEntry>& header, HeaderMark mark,
                            const std::function<bool(FrictionQuantity)>& isGiven,
                            const std::string& name) {
  HeaderStatements read;
  std::vector<HeaderStatement> possible;
  for (const TextEntry& entry : header)
    for (HeaderStatement& statement : readStatements(entry, mark)) {
      const bool isCommon = statement.quantity && !isGiven(*statement.quantity);
      // A column of velocities leaves no doubt.
      if (!isCommon && statement.quantity == FrictionQuantity::Velocity) continue;
      (isCommon ? possible : read.unused).push_back(std::move(statement));
    }
  // Two values of one quantity, or a force and a pressure, leave open which one is meant.
  const auto isDoubtful = [&](const HeaderStatement& one) {
    return !(one.value > 0) || std::ranges::any_of(possible, [&](const HeaderStatement& other) {
      return one.quantity == other.quantity ? one.value != other.value
                                            : sayTheSame(*one.quantity, *other.quantity);
    });
  };
  for (const HeaderStatement& one : possible) {
    (isDoubtful(one) ? read.unused : read.common).push_back(one);
    // A sentence that is contradicted is not understood.
    if (isDoubtful(one) && one.isSentence) read.unused.back().quantity.reset();
  }
  read.hasTwoLoads = std::ranges::count_if(possible, [&](const HeaderStatement& one) {
                       return saysLoad(*one.quantity) && isDoubtful(one);
                     }) > 1;
  std::ranges::stable_sort(read.unused, {}, &HeaderStatement::line);
  for (const HeaderStatement& one : read.unused) refuseUnclear(one, read.common, isGiven, name);
  return read;
}

void addBelow(HeaderStatements& above, HeaderStatements below) {
  const auto isSaidAbove = [&above](const HeaderStatement& one) {
    const auto isSame = [&one](const HeaderStatement& other) {
      const auto quantity = other.quantity ? other.quantity : other.candidate;
      return quantity && sayTheSame(*quantity, *one.quantity);
    };
    return std::ranges::any_of(above.common, isSame) || std::ranges::any_of(above.unused, isSame);
  };
  std::vector<HeaderStatement> common;
  for (HeaderStatement& one : below.common)
    (isSaidAbove(one) ? below.unused : common).push_back(std::move(one));
  std::ranges::move(common, std::back_inserter(above.common));
  std::ranges::move(below.unused, std::back_inserter(above.unused));
  above.hasTwoLoads |= below.hasTwoLoads;
}

}  // namespace asperity
