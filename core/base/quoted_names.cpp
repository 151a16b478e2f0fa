#include "core/base/quoted_names.h"

#include <algorithm>

#include "core/base/text_dialect.h"
#include "core/base/text_header.h"
#include "core/base/text_number.h"

namespace asperity {
namespace {

/// Returns whether a line of a quoted field may be one of a name: "mu" and, below such a line,
/// "5 \u00B0C", but neither a number alone nor a statement such as "Width: 10 mm".
bool isLineOfName(std::string_view line, bool isFirst) {
  if (trimmedBlanks(line).empty()) return true;
  if (readField(line, '.').kind != FieldKind::Text || keyEnd(line) != std::string_view::npos)
    return false;
  return !isFirst || (!beginsAsNumber(line) && !statesQuantity(line));
}

/// Returns the length of a quoted field with line breaks at the beginning of a text; 0 where there
/// is none. It has no signs that separate fields, so that no rows are joined.
std::size_t lengthOfBrokenField(std::string_view text) {
  constexpr std::size_t kLongest = 200;
  bool isBroken = false;
  std::size_t begin = 1;  // of the line
  for (std::size_t i = 1; i < std::min(text.size(), kLongest); ++i) {
    const std::string_view rest = text.substr(i + 1);
    if (std::string_view(";,|\t").find(text[i]) != std::string_view::npos) return 0;
    const bool isEnd = text[i] == '\n' || (text[i] == '"' && !rest.starts_with('"'));
    if (isEnd && (isBroken || text[i] == '\n')) {
      if (!isLineOfName(trimmedField(text.substr(begin, i - begin)), !isBroken)) return 0;
      begin = i + 1;
    }
    isBroken = isBroken || text[i] == '\n';
    if (text[i] != '"') continue;
    if (!rest.starts_with('"'))
      return isBroken && (rest.empty() || rest.find_first_of(";,|\t\r\n ") == 0) ? i + 1 : 0;
    ++i;  // two of them are one of the text
  }
  return 0;
}

/// Returns whether a quoted field at the beginning of a text ends in its line.
bool endsInLine(std::string_view text) {
  return text.substr(1, text.find('\n') - 1).find('"') != std::string_view::npos;
}

}  // namespace

JoinedText::JoinedText(std::string_view written) : text(written) {
  std::size_t kept = 0;
  for (std::size_t at = written.find('"'); at != written.npos; at = written.find('"', at + 1)) {
    if (at > 0 && std::string_view(";,|\t\n").find(written[at - 1]) == std::string_view::npos)
      continue;
    const std::string_view field = written.substr(at);
    const std::size_t length = lengthOfBrokenField(field);
    const bool isInJoinedLine =
        kept > 0 && written.substr(kept, at - kept).find('\n') == written.npos;
    // Of a line of names all fields are joined, or none.
    if (length == 0 && isInJoinedLine && !endsInLine(field)) {
      breaks.clear();
      return;
    }
    if (length == 0) continue;
    joined += written.substr(kept, at - kept);
    kept = at + length;
    for (const char letter : field.substr(0, length)) {
      if (letter == '\r') continue;
      if (letter == '\n') breaks.push_back(joined.size());
      joined += letter == '\n' ? ' ' : letter;
    }
    at = kept - 1;
  }
  if (kept == 0) return;
  joined += written.substr(kept);
  text = joined;
}

}  // namespace asperity
