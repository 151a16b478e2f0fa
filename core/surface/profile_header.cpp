#include "core/surface/profile_header.h"

#include <algorithm>
#include <cctype>
#include <vector>

#include "core/base/text.h"
#include "core/base/text_number.h"

namespace asperity {
namespace {

bool isLetter(char letter) {
  const auto byte = static_cast<unsigned char>(letter);
  return byte >= 0x80 || std::isalpha(byte) != 0;
}

/// Words that programs write for a missing value.
constexpr WordList kMissing("na n/a nan null none missing bad");

/// Returns whether a field begins like a number: 1, -1, .5, -.5, or what the reader takes for
/// infinity.
bool beginsAsValue(std::string_view field) {
  if (!field.empty() && (field.front() == '+' || field.front() == '-')) field.remove_prefix(1);
  if (!field.empty() && field.front() == '.') field.remove_prefix(1);
  const std::string word = lowerCase(field);
  return (!field.empty() && isDigit(field.front())) || word == "inf" || word == "infinity";
}

constexpr WordList kMetres("m metre metres meter meters");

/// Units of length that are not words of a language, also in Latin-1.
constexpr WordList kLengths(
    "mm cm dm km um nm pm fm \u00B5m \u03BCm mum \xB5m micron microns micrometer "
    "micrometers micrometre micrometres millimeter millimeters millimetre millimetres "
    "centimeter centimeters centimetre centimetres nanometer nanometers nanometre "
    "nanometres kilometer kilometers kilometre kilometres angstrom angstroms \u00C5 "
    "\u212B \u00E5 inch inches pixel pixels px \xC5 \u339A \u339B \u339C \u339D");

/// Units that are also words or letters; they count only in brackets and after a slash.
constexpr WordList kShortUnits(
    "in ft yd mil mils thou pt a s ms us min v mv uv n deg rad \u00B0 % arb a.u. au "
    "counts count feet foot \" index samples");

/// "(", "[" and "{" end at their counterparts; a stroke reaches to the end.
constexpr std::string_view kOpening = "([{/";

/// Returns each text in brackets or after a slash in the name.
std::vector<std::string_view> bracketed(std::string_view name) {
  std::vector<std::string_view> found;
  for (std::size_t at = 0; (at = name.find_first_of(kOpening, at)) != std::string_view::npos;) {
    const std::string_view closing = name[at] == '/' ? "" : ")]}";
    const std::size_t end = closing.empty() ? name.size() : name.find_first_of(closing, at);
    found.push_back(
        name.substr(at + 1, (end == std::string_view::npos ? name.size() : end) - at - 1));
    ++at;
  }
  return found;
}

/// Returns the words of a name, split at characters that no unit contains.
std::vector<std::string> lowerCaseWords(std::string_view text) {
  std::vector<std::string> words;
  constexpr std::string_view between = " \t_()[]{}/,;:=*";
  while (true) {
    const std::size_t first = text.find_first_not_of(between);
    if (first == std::string_view::npos) return words;
    const std::size_t end = std::min(text.find_first_of(between, first), text.size());
    words.push_back(lowerCase(text.substr(first, end - first)));
    text.remove_prefix(end);
  }
}

/// Returns whether metres have a factor in front: "1e-6 m", "10^-9 m", "\u00D710\u207B\u2076 m".
bool scalesMetres(const std::vector<std::string>& words) {
  const auto isMetres = [](const std::string& word) { return isOneOf(word, kMetres); };
  return words.size() > 1 && std::ranges::any_of(words, isMetres) &&
         std::ranges::any_of(
             words, [](const std::string& word) { return std::ranges::any_of(word, isDigit); });
}

}  // namespace

bool namesColumns(std::span<const std::string_view> fields) {
  const auto isName = [](std::string_view field) { return std::ranges::any_of(field, isLetter); };
  const auto isValue = [](std::string_view field) {
    return beginsAsValue(field) || isOneOf(lowerCase(field), kMissing);
  };
  return std::ranges::any_of(fields, isName) && std::ranges::none_of(fields, isValue);
}

std::string foreignUnitIn(std::string_view name) {
  for (const std::string_view part : bracketed(name)) {
    const std::vector<std::string> words = lowerCaseWords(part);
    if (scalesMetres(words)) return std::string(part);
    if (words.size() == 1 && isOneOf(words.front(), kShortUnits)) return words.front();
  }
  for (const std::string& word : lowerCaseWords(name))
    if (isOneOf(word, kLengths)) return word;
  return {};
}

bool isWordWithUnit(std::string_view field) {
  const std::size_t opening = field.find_first_of(kOpening);
  if (opening == std::string_view::npos || opening == 0) return false;
  std::string_view name = field.substr(0, opening);
  while (!name.empty() && name.back() == ' ') name.remove_suffix(1);
  return !name.empty() && name.find(' ') == std::string_view::npos;
}

}  // namespace asperity
