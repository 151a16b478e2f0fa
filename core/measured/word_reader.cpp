#include "core/measured/word_reader.h"

#include <cmath>

#include "core/base/text_number.h"

namespace asperity {

std::string_view WordReader::nextLine() {
  line_ = ++ended_;
  return trimmedBlanks(takeLine(rest_));
}

std::string_view WordReader::nextWord() {
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

std::optional<double> parseFiniteNumber(std::string_view word, char decimal) {
  double number = 0;
  return readTextNumber(word, decimal, number) ? std::optional(number) : std::nullopt;
}

double parseHeight(const SurfaceSource& source, std::size_t line, std::string_view word,
                   std::size_t number, char decimal) {
  const Field field = readField(word, decimal);
  if (field.kind == FieldKind::Text || field.kind == FieldKind::Flag)
    source.fail(message("line {}: height {} is not a number", line, number + 1));
  return field.value;
}

void readHeights(const SurfaceSource& source, WordReader& reader, std::size_t count,
                 const HeightWords& words, std::vector<double>& heights) {
  heights.reserve(heights.size() + count);
  for (std::size_t i = 0; i < count; ++i) {
    source.reportPoint(i, count);
    const std::string_view word = reader.nextWord();
    if (word.empty() || word.front() == words.end)
      source.fail(message("line {}: ends after {} of {} heights", reader.line(), i, count));
    const double number = parseHeight(source, reader.line(), word, i, words.decimal);
    const double height = number * words.scale;
    heights.push_back(words.gaps.contain(number) || !std::isfinite(height) ? kMissingHeight
                                                                           : height);
  }
}

void takeHeights(const SurfaceSource& source, WordReader& reader, const HeightWords& words,
                 Topography& grid) {
  // A height takes at least a digit and a blank.
  requireSize(source, grid.columns, grid.rows, reader.left() + 1, 2);
  const auto count = static_cast<std::size_t>(grid.columns * grid.rows);
  readHeights(source, reader, count, words, grid.height);
  if (parseFiniteNumber(reader.nextWord(), words.decimal))
    source.fail(message("line {}: has more than the {} heights that the header says", reader.line(),
                        count));
}

}  // namespace asperity
