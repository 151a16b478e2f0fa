#include "core/base/text_clause.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <numeric>

#include "core/base/column_units.h"
#include "core/base/text_header.h"

namespace asperity {

std::string joinEntry(const TextEntry& entry, std::string_view between) {
  return entry.key.empty() ? entry.value : fmt::format("{}{}{}", entry.key, between, entry.value);
}

std::vector<std::string_view> splitClauses(std::string_view line) {
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

std::vector<std::string_view> splitStatements(std::string_view clause) {
  std::vector<std::string_view> statements;
  std::size_t begin = 0;
  const auto beginAt = [&](std::size_t next) {
    if (next <= begin || next == clause.npos) return;
    if (const auto text = trimmedBlanks(clause.substr(begin, next - begin)); !text.empty())
      statements.push_back(text);
    begin = next;
  };
  for (std::size_t i = 0; i < clause.size(); ++i) {
    if (lowerCase(clause.substr(i, 5)) == " tref" || lowerCase(clause.substr(i, 6)) == " t_ref")
      beginAt(i + 1);
    const std::string_view front = withoutEnd(clause.substr(begin, i - begin), " ");
    if (clause[i] != '=' || front.find('=') == front.npos) continue;
    // The unit of "C2 (K) = 120" belongs to the name.
    const std::size_t bracket = front.ends_with(')') ? front.rfind('(') : front.npos;
    const std::size_t blank = withoutEnd(front.substr(0, bracket), " ").find_last_of(' ');
    if (blank != front.npos) beginAt(begin + blank + 1);
  }
  beginAt(clause.size());
  return statements;
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

std::optional<TextStatement> parseStatement(std::string_view clause) {
  const std::size_t end = clause.find_last_of(":=");
  if (end == clause.npos) return {};
  const auto quantity = parseQuantity(clause.substr(end + 1));
  if (!quantity) return {};
  const std::string_view key = keyBefore(clause.substr(0, end));
  return TextStatement{std::string(key), parseColumnName(key), *quantity};
}

std::vector<std::string> wordsIn(std::string_view text) {
  std::vector<std::string> words;
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

std::optional<WordOfLine> unitOfNoNumber(const TextPart& in,
                                         const std::function<bool(const std::string&)>& isUnit) {
  std::vector<const TextEntry*> lines = in.entriesAbove();
  // The names, which may have units of their own, are the last line above that has them all.
  const auto hasNames = [&block = in.block](const TextEntry* entry) {
    return block.hasNames() &&
           std::ranges::all_of(block.columns, [entry](const TextColumn& column) {
             return entry->written.find(column.name) != std::string::npos;
           });
  };
  const auto names = std::ranges::find_if(lines.rbegin(), lines.rend(), hasNames);
  const std::string lineOfNames = names != lines.rend() ? (*names)->written : std::string();
  for (const TextEntry& entry : in.table.trailer) lines.push_back(&entry);
  for (const TextEntry* entry : lines) {
    if (entry->written == lineOfNames) continue;
    bool isAfterNumber = false;
    for (std::string_view word : WordList(entry->written)) {
      while (!word.empty() && std::string_view("([{=:,;").find(word.front()) != word.npos)
        word.remove_prefix(1);
      word = withoutEnd(word, ")]},;:.");
      if (!isAfterNumber && isUnit(std::string(word)))
        return WordOfLine{std::string(word), entry->line};
      isAfterNumber = !word.empty() && isDigit(word.back());
    }
  }
  for (std::size_t i = 0; i < in.block.columns.size(); ++i)
    if (in.block.columns[i].isText && isNameOfUnits(in.block.columns[i]))
      for (std::size_t row = 0; row < in.block.rows; ++row)
        if (isUnit(in.block.texts[i][row]))
          return WordOfLine{in.block.texts[i][row], in.block.lines[row]};
  return {};
}

Message unitStandsElsewhere(const std::string& name, const WordOfLine& unit) {
  return message(
      "has no unit, and line {} names '{}'; write the unit into the name, as in \"{} ({})\"",
      unit.line, shortened(unit.word), shortened(name), shortened(unit.word));
}

bool isNextProfile(std::string_view heading, std::string_view next) {
  constexpr WordList kProfiles("profile profil profilo perfil trace track spur");
  if (heading == next) return false;
  std::string one(heading), other(next);
  std::erase_if(one, isDigit);
  std::erase_if(other, isDigit);
  return one == other && hasOneOf(wordsIn(one), kProfiles);
}

std::string plainWord(std::string_view text) {
  const std::vector<std::string> words = wordsIn(text);
  return std::accumulate(words.begin(), words.end(), std::string());
}

}  // namespace asperity
