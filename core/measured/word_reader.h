// Text files of fixed structure: their lines and words with the numbers of the lines, and heights
// as words. Pure; any thread.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <string_view>
#include <vector>

#include "core/base/text_dialect.h"
#include "core/base/text_number.h"
#include "core/measured/surface_draft.h"

namespace asperity {

/// Without the mark of UTF-8 at the beginning.
inline std::string_view withoutByteOrderMark(std::string_view bytes) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  return bytes.starts_with(kMark) ? bytes.substr(kMark.size()) : bytes;
}

/// Takes one line or word after another from a text, which must outlive it.
class WordReader {
 public:
  explicit WordReader(std::string_view text) : rest_(text) {}

  bool atEnd() const { return rest_.empty(); }
  std::size_t left() const { return rest_.size(); }  // bytes
  /// The line of what was taken last, counted from 1.
  std::size_t line() const { return line_; }

  /// The rest of the line, without the blanks around it.
  std::string_view nextLine() {
    line_ = ++ended_;
    return trimmedBlanks(takeLine(rest_));
  }

  /// What stands before the next blank or line end; empty at the end of the text.
  std::string_view nextWord() {
    constexpr std::string_view kBlanks = " \t\r\n";
    while (!rest_.empty() && kBlanks.find(rest_.front()) != std::string_view::npos) {
      ended_ += rest_.front() == '\n' ? 1 : 0;
      rest_.remove_prefix(1);
    }
    const std::string_view word = rest_.substr(0, rest_.find_first_of(kBlanks));
    rest_.remove_prefix(word.size());
    line_ = ended_ + 1;
    return word;
  }

 private:
  std::string_view rest_;
  std::size_t ended_ = 0;  // lines
  std::size_t line_ = 0;
};

/// The words of a line.
inline std::vector<std::string_view> wordsOf(std::string_view line) {
  std::vector<std::string_view> words;
  splitFields(line, TextDialect::Separator::Blanks, words);
  return words;
}

/// Whether the word is a number that is finite.
inline bool isNumber(std::string_view word) {
  double number = 0;
  return readTextNumber(word, '.', number);
}

/// Appends `count` words as heights, times `scale`. A word for a missing value and a number of
/// which isGap says so are gaps. Throws InputError where a word is anything else, or where the text
/// ends before, as it does at a word that begins with `end`.
template <class IsGap>
void readHeights(const SurfaceSource& source, WordReader& reader, std::size_t count, double scale,
                 char end, std::vector<double>& heights, const IsGap& isGap) {
  constexpr std::size_t kStep = std::size_t{1} << 18;
  heights.reserve(heights.size() + count);
  for (std::size_t i = 0; i < count; ++i) {
    if (i % kStep == 0) source.report(static_cast<double>(i) / static_cast<double>(count));
    const std::string_view word = reader.nextWord();
    if (word.empty() || word.front() == end)
      source.fail(message("line {}: ends after {} of {} heights", reader.line(), i, count));
    const Field field = readField(word, '.');
    if (field.kind == FieldKind::Text || field.kind == FieldKind::Flag)
      source.fail(message("line {}: height {} is not a number", reader.line(), i + 1));
    const bool isNone = field.kind == FieldKind::Missing || isGap(field.value) ||
                        !std::isfinite(field.value * scale);
    heights.push_back(isNone ? std::numeric_limits<double>::quiet_NaN() : field.value * scale);
  }
}

/// Refuses a further number behind `count` heights.
inline void requireNoMoreHeights(const SurfaceSource& source, WordReader& reader,
                                 std::size_t count) {
  if (isNumber(reader.nextWord()))
    source.fail(message("line {}: has more than the {} heights that the header says", reader.line(),
                        count));
}

}  // namespace asperity
