#include "core/base/header_clauses.h"

#include <fmt/format.h>

#include <cctype>

#include "core/base/text_number.h"

namespace asperity {

WordList wordsIn(std::string_view text) {
  WordList words;
  bool isOpen = false;
  for (const char letter : lowerCase(text)) {
    if (letter == '_') continue;
    const auto byte = static_cast<unsigned char>(letter);
    const bool isPart = byte >= 0x80 || std::isalnum(byte) != 0;
    if (isPart && !isOpen) words.emplace_back();
    if (isPart) words.back() += letter;
    isOpen = isPart;
  }
  return words;
}

std::string lineOf(const TextEntry& entry, std::string_view between) {
  return entry.key.empty() ? entry.value : fmt::format("{}{}{}", entry.key, between, entry.value);
}

std::vector<std::string_view> clausesOf(std::string_view line) {
  std::vector<std::string_view> clauses;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= line.size(); ++i) {
    const bool isEnd = i == line.size() || line[i] == ';' || line[i] == '\t' || line[i] == '|' ||
                       line.substr(i).starts_with(", ");
    if (!isEnd) continue;
    if (const auto clause = trimmedBlanks(line.substr(begin, i - begin)); !clause.empty())
      clauses.push_back(clause);
    begin = i + 1;
  }
  return clauses;
}

std::string_view withoutEnd(std::string_view text, std::string_view signs) {
  const std::size_t last = text.find_last_not_of(signs);
  return text.substr(0, last == text.npos ? 0 : last + 1);
}

std::string_view keyBefore(std::string_view text) {
  text = withoutEnd(text, " :=@(\t");
  const std::size_t before = text.find_last_of(":=");
  return trimmedBlanks(before == text.npos ? text : text.substr(before + 1));
}

}  // namespace asperity
