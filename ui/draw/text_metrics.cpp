#include "ui/draw/text_metrics.h"

#include <algorithm>
#include <cstdint>

#include "ui/draw/font_advances.h"

namespace asperity {
namespace {

/// The next character; advances `at` past it. Damaged UTF-8 counts one character a byte.
std::uint32_t nextCharacter(std::string_view utf8, std::size_t& at) {
  const auto byte = static_cast<unsigned char>(utf8[at++]);
  const int more = byte >= 0xF0 ? 3 : byte >= 0xE0 ? 2 : byte >= 0xC0 ? 1 : 0;
  std::uint32_t character = more == 0 ? byte : byte & (0x3FU >> more);
  for (int i = 0; i < more && at < utf8.size() && (utf8[at] & 0xC0) == 0x80; ++i)
    character = (character << 6) | (static_cast<unsigned char>(utf8[at++]) & 0x3FU);
  return character;
}

}  // namespace

float textWidth(std::string_view utf8, float size, bool bold) {
  float units = 0;
  for (std::size_t at = 0; at < utf8.size();) units += fontAdvance(nextCharacter(utf8, at), bold);
  return units * size / kAdvancesPerSize;
}

float fittingSize(const std::string& utf8, float size, float least, bool bold, float width) {
  while (size - 1 >= least && textWidth(utf8, size, bold) > width) size -= 1;
  return size;
}

std::vector<std::string> wrapped(const std::string& utf8, float size, bool bold, float width) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < utf8.size();) {
    const std::size_t space = utf8.find_first_of(" \n", at);
    const std::size_t end = std::min(space, utf8.size());
    const std::string word = utf8.substr(at, end - at);
    const bool freshLine = lines.empty() || (at > 0 && utf8[at - 1] == '\n');
    if (freshLine)
      lines.push_back(word);
    else if (textWidth(lines.back() + " " + word, size, bold) <= width)
      lines.back() += " " + word;
    else
      lines.push_back(word);
    at = end + 1;
  }
  for (std::string& line : lines) line = elided(line, size, bold, width);
  return lines;
}

std::string elided(const std::string& utf8, float size, bool bold, float width) {
  if (textWidth(utf8, size, bold) <= width) return utf8;
  const std::string ellipsis = "\u2026";
  const float room = width - textWidth(ellipsis, size, bold);
  std::size_t kept = 0;
  for (std::size_t at = 0; at < utf8.size();) {
    nextCharacter(utf8, at);
    if (textWidth(std::string_view(utf8).substr(0, at), size, bold) > room) break;
    kept = at;
  }
  while (kept > 0 && utf8[kept - 1] == ' ') --kept;
  return kept == 0 ? std::string() : utf8.substr(0, kept) + ellipsis;
}

}  // namespace asperity
