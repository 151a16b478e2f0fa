#include "core/material/text_frequency.h"

#include <cctype>
#include <numbers>
#include <string>

#include "core/base/text.h"
#include "core/base/text_clause.h"
#include "core/base/text_number.h"
#include "core/base/units.h"
#include "core/material/dma_columns.h"

namespace asperity {

std::optional<double> frequencyUnit(std::string_view unit, bool isAngular) {
  constexpr double kAngular = 0.5 / std::numbers::pi;
  if (unit.empty()) return isAngular ? kAngular : 1;
  const std::string word = lowerCase(unit);
  if (word.starts_with("rad")) return kAngular;
  if (isAngular && isOneOf(word, "1/s s-1 s^-1 s\u207B\u00B9")) return kAngular;
  return unitSize(unit, "Hz");
}

std::optional<TextFrequency> firstFrequency(std::string_view text) {
  constexpr WordList kUnits("rad/s mHz kHz MHz Hz HZ hz");
  for (std::size_t begin = 0; begin < text.size(); ++begin) {
    if (!isDigit(text[begin])) continue;
    const std::size_t digits = begin;
    std::string number;
    std::size_t end = begin;
    for (; end < text.size() && (isDigit(text[end]) || text[end] == '.' || text[end] == ','); ++end)
      number += text[end] == ',' ? '.' : text[end];
    begin = end;
    std::size_t unit = end;
    while (unit < text.size() && (text[unit] == ' ' || text[unit] == '_')) ++unit;
    double value = 0;
    // "G1 Hz" and "run3 Hz" are names.
    const bool isOfWord =
        digits > 0 && std::isalnum(static_cast<unsigned char>(text[digits - 1])) != 0;
    if (isOfWord || !readTextNumber(number, '.', value)) continue;
    for (const std::string_view name : kUnits) {
      const std::size_t after = unit + name.size();
      if (!text.substr(unit).starts_with(name) ||
          (after < text.size() && std::isalnum(static_cast<unsigned char>(text[after])) != 0))
        continue;
      if (const auto size = frequencyUnit(name, false); size && value > 0)
        return TextFrequency{value * *size, digits, after};
    }
  }
  return {};
}

std::optional<double> statedFrequency(const TextBlock& block) {
  std::optional<double> found;
  for (const TextEntry& entry : block.header) {
    const std::string line = joinEntry(entry);
    for (const std::string_view clause : splitClauses(line)) {
      std::optional<double> size;
      double number = 0;
      if (const auto statement = parseStatement(clause)) {
        const DmaColumn key = dmaColumn(statement->name.name, {});
        if (key.quantity != DmaQuantity::Frequency || statement->unit().empty() ||
            containsOneOf(lowerCase(statement->key), "sampl abtast natural eigen reson filter"))
          continue;
        size = frequencyUnit(statement->unit(), key.isAngular);
        number = statement->quantity.number;
      } else if (const auto alone = parseQuantity(clause); alone && !alone->unit.empty()) {
        size = frequencyUnit(alone->unit, false);
        number = alone->number;
      }
      if (!size || !(number > 0)) continue;
      if (found && *found != number * *size) return {};
      found = number * *size;
    }
  }
  return found;
}

}  // namespace asperity
