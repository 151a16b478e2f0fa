#include "core/base/text_number.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <utility>

#include "core/base/number_text.h"
#include "core/base/statistics.h"
#include "core/base/text.h"

namespace asperity {
namespace {

using namespace std::string_view_literals;

/// Words that programs write for a missing value, in lower case.
constexpr WordList kMissing(
    "nan, -nan, +nan, nan(ind), -nan(ind), qnan, 1.#qnan, -1.#qnan, 1.#ind, -1.#ind, 1.#inf, "
    "-1.#inf, 1.#j, -1.#j, inf, +inf, -inf, infinity, -infinity, +infinity, \u221E, -\u221E, na, "
    "n/a, null, none, nil, missing, bad, void, undef, undefined, n.d., n.a., nd, ?, ., \u2013, "
    "\u2014, ol, overflow, over, +over, -over, overrange, over range, out of range, overload, "
    "underflow, underrange, ovfl, ovld, \u00DCberlauf, "
    "masked, <na>, no data, nodata, no_data, no-data, no value, fehlt, not measured, "
    "not available, not valid, not a number, no signal, no reading, no measurement, "
    "no reflection, no return, no result, missing value, missing data, missing point, "
    "invalid data, invalid value, invalid point, bad data, bad value, bad point, bad pixel, "
    "data missing, value missing, kein wert, keine daten, kein messwert, kein signal, "
    "nicht gemessen, nicht messbar, fehlender wert, pas de donn\u00E9es, pas de valeur, "
    "sin datos, sin valor, nessun dato, sem dados, "
    "error, err, #error, empty, out, saturated, clipped, outlier",
    ',');

/// Marks that spreadsheets write into a cell without a value.
constexpr WordList kSpreadsheetErrors(
    "#N/A #NV #NUM! #DIV/0! #VALUE! #WERT! #REF! #BEZUG! #NAME? #ZAHL!");

constexpr WordList kTrue("true ok good valid yes pass wahr");
constexpr WordList kFalse("false invalid no fail nok falsch");

bool isMissing(std::string_view text) {
  // A missing value is also a text of only one of these characters: "-", "--", "***", "####".
  if (text.find_first_not_of("-") == std::string_view::npos ||
      text.find_first_not_of("*") == std::string_view::npos ||
      text.find_first_not_of("#") == std::string_view::npos)
    return true;
  constexpr std::size_t kLongest = 16;
  if (text.size() > kLongest) return false;
  std::string word = lowerCase(text);
  std::ranges::replace(word, '\t', ' ');
  while (word.find("  ") != word.npos) replaceAll(word, "  ", " ");
  const auto isWord = [&word](std::string_view error) { return lowerCase(error) == word; };
  return isOneOf(word, kMissing) ||
         (word.starts_with('#') && std::ranges::any_of(kSpreadsheetErrors, isWord));
}

/// The bytes of blanks beyond ASCII at the beginning or at the end.
constexpr std::array kWideBlanks{"\u00A0"sv, "\u2009"sv, "\u202F"sv, "\u2007"sv, "\uFEFF"sv};

constexpr std::string_view kBlanks = " \t\r\n\v\f";

constexpr std::size_t kLongestNumber = 64;

/// Reads the whole text by std::from_chars.
bool readPlain(const char* begin, const char* end, double& number) {
  const auto [stop, error] = std::from_chars(begin, end, number);
  if (stop != end) return false;
  if (error == std::errc{}) return std::isfinite(number);
  if (error != std::errc::result_out_of_range) return false;
  // A number that is too small becomes 0; one that is too large is no number.
  const char* exponent = std::find_if(begin, end, [](char c) { return c == 'e' || c == 'E'; });
  number = 0;
  return exponent + 1 < end && exponent[1] == '-';
}

/// Separators of thousands, in addition to the mark that is not the decimal mark.
constexpr std::array kThousands{"'"sv, "\u2019"sv, " "sv, "\u00A0"sv, "\u202F"sv, "\u2009"sv};

/// Reads a number with separated thousands, "1.234,5", "-12 345", "1'234'567.8": one to three
/// digits that do not begin with 0, then groups of three after equal separators, then optional
/// decimals.
bool readGroupedNumber(std::string_view text, char decimal, double& number) {
  if (text.empty() || text.size() > kLongestNumber) return false;
  std::string plain;
  if (text.front() == '-' || text.front() == '+' || text.starts_with(kMinusSign)) {
    if (text.front() != '+') plain = "-";
    text.remove_prefix(text.starts_with(kMinusSign) ? kMinusSign.size() : 1);
  }
  const auto takeDigits = [&] {
    const std::size_t count = std::min(text.find_first_not_of("0123456789"), text.size());
    plain += text.substr(0, count);
    text.remove_prefix(count);
    return count;
  };
  constexpr std::size_t kGroup = 3;
  const bool beginsWithZero = text.starts_with('0');
  const std::size_t first = takeDigits();
  if (first == 0 || first > kGroup || beginsWithZero) return false;
  std::string_view mark = decimal == '.' ? ","sv : "."sv;
  for (const std::string_view one : kThousands)
    if (text.starts_with(one)) mark = one;
  if (!text.starts_with(mark)) return false;
  while (text.starts_with(mark)) {
    text.remove_prefix(mark.size());
    if (takeDigits() != kGroup) return false;
  }
  if (text.starts_with(decimal)) {
    text.remove_prefix(1);
    plain += '.';
    takeDigits();
  }
  return text.empty() && readPlain(plain.data(), plain.data() + plain.size(), number);
}

}  // namespace

std::string lowerCase(std::string_view text) {
  std::string lower(text);
  for (std::size_t i = 0; i < lower.size(); ++i) {
    const auto letter = static_cast<unsigned char>(lower[i]);
    lower[i] = static_cast<char>(std::tolower(letter));
    if (letter != 0xD0 || i + 1 == lower.size()) continue;
    // U+0410 to U+042F in UTF-8; the small letters are 32 places behind.
    const auto second = static_cast<unsigned char>(lower[i + 1]);
    if (second < 0x90 || second > 0xAF) continue;
    lower[i] = second < 0xA0 ? '\xD0' : '\xD1';
    lower[++i] = static_cast<char>(second < 0xA0 ? second + 0x20 : second - 0x20);
  }
  return lower;
}

void replaceAll(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
}

std::string_view trimmedBlanks(std::string_view text) {
  while (true) {
    const std::size_t before = text.size();
    text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
    text.remove_suffix(text.size() - (text.find_last_not_of(kBlanks) + 1));
    for (const std::string_view blank : kWideBlanks) {
      if (text.starts_with(blank)) text.remove_prefix(blank.size());
      if (text.ends_with(blank)) text.remove_suffix(blank.size());
    }
    if (text.size() == before) return text;
  }
}

std::string_view trimmedField(std::string_view text) {
  text = trimmedBlanks(text);
  if (text.size() >= 2 && (text.front() == '"' || text.front() == '\'') &&
      text.back() == text.front())
    text = trimmedBlanks(text.substr(1, text.size() - 2));
  return text;
}

std::string_view withoutBrackets(std::string_view text) {
  text = trimmedField(text);
  constexpr std::string_view opening = "([{<", closing = ")]}>";
  if (text.size() < 2) return text;
  const std::size_t kind = opening.find(text.front());
  if (kind == std::string_view::npos || text.back() != closing[kind]) return text;
  return trimmedBlanks(text.substr(1, text.size() - 2));
}

bool readTextNumber(std::string_view text, char decimal, double& number) {
  if (text.empty() || text.size() > kLongestNumber) return false;
  std::array<char, kLongestNumber + 1> plain{};
  char* end = plain.data();
  if (text.starts_with(kMinusSign)) {
    *end++ = '-';
    text.remove_prefix(kMinusSign.size());
  } else if (text.front() == '+') {
    text.remove_prefix(1);
    if (!text.empty() && text.front() == '-') return false;
  }
  bool hasDigit = false, hasExponent = false, afterExponent = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    char letter = text[i];
    if (letter >= '0' && letter <= '9') {
      hasDigit = true;
    } else if (letter == '.' || letter == ',') {
      if (letter != decimal || hasExponent) return false;
      letter = '.';
    } else if ((letter == 'e' || letter == 'E' || letter == 'd' || letter == 'D') && hasDigit &&
               !hasExponent) {
      hasExponent = true;
      letter = 'e';
    } else if (afterExponent && text.substr(i).starts_with(kMinusSign)) {
      letter = '-';
      i += kMinusSign.size() - 1;
    } else if (letter != '-' && !(letter == '+' && afterExponent)) {
      return false;  // letters of "inf" and "nan", too
    }
    afterExponent = letter == 'e';
    *end++ = letter;
  }
  return hasDigit && readPlain(plain.data(), end, number);
}

Field readField(std::string_view text, char decimal) {
  text = trimmedField(text);
  if (text.empty()) return {FieldKind::Missing, kNaN};
  double number = 0;
  if (readTextNumber(text, decimal, number)) return {FieldKind::Number, number};
  if (readGroupedNumber(text, decimal, number)) return {FieldKind::Number, number, true};
  if (isMissing(text)) return {FieldKind::Missing, kNaN};
  constexpr std::size_t kLongestFlag = 8;
  if (text.size() <= kLongestFlag) {
    const std::string word = lowerCase(text);
    if (isOneOf(word, kTrue)) return {FieldKind::Flag, 1};
    if (isOneOf(word, kFalse)) return {FieldKind::Flag, 0};
  }
  return {FieldKind::Text, 0};
}

bool isDateOrTime(std::string_view field) {
  field = trimmedField(field);
  if (field.empty() || !isDigit(field.front()) ||
      field.find_first_not_of("0123456789-/.,:+TZAPM ") != field.npos)
    return false;
  constexpr std::size_t kDigitsOfYear = 4, kPartsOfDate = 3;
  std::size_t parts = 0, digits = 0;
  bool hasYear = false;
  const std::string_view date = field.substr(0, field.find_first_of(" T"));
  for (std::size_t i = 0; i <= date.size(); ++i) {
    if (i < date.size() && isDigit(date[i])) {
      ++digits;
      continue;
    }
    parts += digits > 0 ? 1 : 0;
    hasYear = hasYear || digits == kDigitsOfYear;
    digits = 0;
  }
  return field.find(':') != field.npos || (parts == kPartsOfDate && hasYear);
}

bool beginsAsNumber(std::string_view field) {
  field = trimmedField(field);
  for (const std::string_view mark : {"+-", ".,"})
    if (!field.empty() && mark.find(field.front()) != std::string_view::npos)
      field.remove_prefix(1);
  return !field.empty() && isDigit(field.front());
}

bool beginsWithSpreadsheetError(std::string_view text) {
  return beginsWithOneOf(text, kSpreadsheetErrors);
}

namespace {

/// Removes the minus sign in front of a number, as people and word processors write it; returns
/// whether there is one.
bool takeMinus(std::string_view& text) {
  constexpr std::array kSigns{"-"sv, kMinusSign, "\u2013"sv, "\u2010"sv, "\u2011"sv, "minus"sv};
  constexpr std::size_t kLongest = 5;
  const std::string lower = lowerCase(text.substr(0, kLongest));
  for (const std::string_view sign : kSigns) {
    if (!lower.starts_with(sign)) continue;
    const std::string_view rest = trimmedBlanks(text.substr(sign.size()));
    if (rest.empty() || !(isDigit(rest.front()) || rest.front() == '.' || rest.front() == ','))
      return false;
    text = rest;
    return true;
  }
  return false;
}

}  // namespace

std::optional<TextQuantity> parseQuantity(std::string_view text, std::optional<char> decimal) {
  text = trimmedField(text);
  const double sign = takeMinus(text) ? -1 : 1;
  std::string letters(kBytesOfNumbers);
  if (decimal)
    for (const std::string_view mark : kThousands) letters += mark;
  const char first = decimal.value_or('.');
  // The number is the longest beginning that is one, with either decimal mark.
  const std::size_t most = std::min(text.find_first_not_of(letters), text.size());
  for (std::size_t size = most; size > 0; --size) {
    const std::string_view beginning = text.substr(0, size);
    double number = 0;
    const bool isPlain = readTextNumber(beginning, first, number);
    const bool isGrouped = !isPlain && decimal && readGroupedNumber(beginning, first, number);
    if (isPlain || isGrouped || readTextNumber(beginning, first == '.' ? ',' : '.', number))
      return TextQuantity{sign * number, std::string(trimmedField(text.substr(size))), isGrouped};
  }
  return {};
}

std::optional<PowerOfTen> powerOfTenIn(std::string_view text) {
  text = trimmedBlanks(text);
  const std::size_t whole = text.size();
  for (const std::string_view times : {"\u00D7"sv, "\u00B7"sv, "\u22C5"sv, "x"sv, "*"sv})
    if (text.starts_with(times)) text.remove_prefix(times.size());
  const bool hasTimes = text.size() < whole;
  text = trimmedBlanks(text);
  if (text.starts_with("1/")) {
    const auto divisor = powerOfTenIn(text.substr(2));
    if (!divisor) return {};
    return PowerOfTen{1 / divisor->value, -divisor->exponent};
  }
  double number = 0;
  if (readTextNumber(text, '.', number)) {
    if (!(number > 0)) return {};
    // Any other number is a length: "59.00 um" is no unit.
    const double exponent = std::log10(number);
    if (std::abs(exponent - std::round(exponent)) >= 1e-9) return {};
    return PowerOfTen{number, static_cast<int>(std::round(exponent)),
                      text.find_first_of("eE") != std::string_view::npos};
  }
  if (!text.starts_with("10")) return {};
  std::string exponent(text.substr(2));
  replaceAll(exponent, kMinusSign, "-");
  const std::string flat = exponent;
  for (const auto& [raised, plain] : {std::pair{"\u207B"sv, "-"sv}, {"^"sv, ""sv}})
    replaceAll(exponent, raised, plain);
  for (std::size_t digit = 0; digit < kRaisedDigits.size(); ++digit)
    replaceAll(exponent, kRaisedDigits[digit], std::to_string(digit));
  constexpr double kLargest = 30;
  if (!readTextNumber(exponent, '.', number) || std::abs(number) > kLargest) return {};
  // "10-3" without a sign of multiplication may be a range.
  return PowerOfTen{std::pow(10.0, number), static_cast<int>(number),
                    (hasTimes || exponent != flat) && number == std::round(number)};
}

bool isWrittenPower(std::string_view text) {
  const auto power = powerOfTenIn(text);
  return power && power->isWritten;
}

std::optional<ScaledUnit> scaledUnit(std::string_view text) {
  constexpr std::string_view kMarks = " *";
  for (std::size_t at = 0; (at = text.find_first_of(kMarks, at)) != std::string_view::npos; ++at)
    if (const auto power = powerOfTenIn(text.substr(0, at))) {
      const std::size_t unit = std::min(text.find_first_not_of(kMarks, at), text.size());
      return ScaledUnit{*power, text.substr(unit)};
    }
  return {};
}

}  // namespace asperity
