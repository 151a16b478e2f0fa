// Reads text files of a fixed structure line by line or word by word, with the numbers of their
// lines, and heights as words. Pure; any thread.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "core/base/text_dialect.h"
#include "core/base/text_encoding.h"
#include "core/measured/surface_draft.h"

namespace asperity {

/// Takes one line or word after another from a text, which must outlive the reader.
class WordReader {
 public:
  explicit WordReader(std::string_view text) : rest_(text) {}

  bool atEnd() const { return rest_.empty(); }
  std::size_t left() const { return rest_.size(); }  // bytes
  std::string_view rest() const { return rest_; }
  /// Returns the number of the line from which something was taken last, counted from 1.
  std::size_t line() const { return line_; }

  /// Takes the rest of the line and returns it without the blanks around it.
  std::string_view nextLine();
  /// Takes the text up to the next blank or line end; empty at the end of the text.
  std::string_view nextWord();

 private:
  std::string_view rest_;
  std::size_t ended_ = 0;  // lines
  std::size_t line_ = 0;
};

/// Returns the word as a number; nothing where it is no finite number.
std::optional<double> parseFiniteNumber(std::string_view word, char decimal = '.');

/// Returns the word as a height; NaN for a word that stands for a missing value. Throws InputError
/// where it is neither. line, number: of the height, which is counted from 0, for the error.
double parseHeight(const SurfaceSource& source, std::size_t line, std::string_view word,
                   std::size_t number, char decimal = '.');

/// How the heights of a file are written.
struct HeightWords {
  double scale = 1;  // of each number
  HeightGaps gaps{};
  char end = '\0';  // begins what follows the heights
  char decimal = '.';
};

/// Appends `count` words as heights. A word for a missing value becomes a gap. Throws InputError
/// where a word is anything else, or where the text ends too early.
void readHeights(const SurfaceSource& source, WordReader& reader, std::size_t count,
                 const HeightWords& words, std::vector<double>& heights);

/// Takes the heights of a grid whose numbers of columns and rows are known. Throws InputError where
/// the text has fewer words, or a further number behind them.
void takeHeights(const SurfaceSource& source, WordReader& reader, const HeightWords& words,
                 Topography& grid);

}  // namespace asperity
