#include "core/base/text.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <cstdint>

#include "core/base/text_encoding.h"

namespace asperity {
namespace {

struct Range {
  std::uint32_t first, last;
};

/// Control characters, marks of direction and of zero width, line separators, tags, and characters
/// that Unicode reserves for programs.
constexpr std::array<Range, 13> kUnprintable{{{0, 0x1F},
                                              {0x7F, 0x9F},
                                              {0xAD, 0xAD},
                                              {0x61C, 0x61C},
                                              {0x180E, 0x180E},
                                              {0x200B, 0x200F},
                                              {0x2028, 0x202E},
                                              {0x2060, 0x206F},
                                              {0xFDD0, 0xFDEF},
                                              {0xFEFF, 0xFEFF},
                                              {0xFFF9, 0xFFFB},
                                              {0xFFFE, 0xFFFF},
                                              {0xE0000, 0xE007F}}};

bool isPrintable(std::uint32_t code) {
  return std::ranges::none_of(kUnprintable, [code](const Range& range) {
    return code >= range.first && code <= range.last;
  });
}

std::string escaped(std::uint32_t code) {
  switch (code) {
    case '\n':
      return "\\n";
    case '\r':
      return "\\r";
    case '\t':
      return "\\t";
    default:
      return code < 0x80      ? fmt::format("\\x{:02x}", code)
             : code < 0x10000 ? fmt::format("\\u{:04x}", code)
                              : fmt::format("\\U{:08x}", code);
  }
}

}  // namespace

std::string printable(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const Utf8Character next = firstCharacter(text);
    const std::size_t bytes = std::max<std::size_t>(next.bytes, 1);
    if (next.bytes == 0)
      shown += fmt::format("\\x{:02x}", static_cast<unsigned char>(text.front()));
    else if (isPrintable(next.code))
      shown += text.substr(0, bytes);
    else
      shown += escaped(next.code);
    text.remove_prefix(bytes);
  }
  return shown;
}

namespace {

std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row[b.size()];
}

}  // namespace

std::string shortened(std::string_view text) {
  constexpr std::size_t kMax = 60;
  if (text.size() <= kMax) return std::string(text);
  std::size_t end = kMax;
  while (end > 0 && !beginsCharacter(text[end])) --end;
  return std::string(text.substr(0, end)) + "...";
}

std::vector<std::string_view> splitText(std::string_view text, std::string_view separator) {
  std::vector<std::string_view> parts;
  for (std::size_t end; (end = text.find(separator)) != std::string_view::npos;
       text.remove_prefix(end + separator.size()))
    parts.push_back(text.substr(0, end));
  parts.push_back(text);
  return parts;
}

void appendItem(std::string& list, std::string_view item, std::string_view separator) {
  if (!list.empty()) list += separator;
  list += item;
}

std::string_view nearestWord(std::string_view word, std::span<const std::string_view> known) {
  const std::string_view start = word.substr(0, 100);
  const auto nearest = std::ranges::min_element(
      known, {}, [start](std::string_view one) { return editDistance(start, one); });
  if (nearest == known.end() || 2 * editDistance(start, *nearest) > start.size()) return {};
  return *nearest;
}

std::string makeFileName(std::string_view name) {
  constexpr std::size_t kMax = 60;
  std::string clean;
  for (const unsigned char letter : name.substr(0, kMax))
    clean +=
        std::isalnum(letter) || letter == '-' || letter == '_' ? static_cast<char>(letter) : '_';
  return clean;
}

}  // namespace asperity
