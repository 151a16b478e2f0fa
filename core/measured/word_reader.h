// Text files of fixed structure: their lines and words with the numbers of the lines, and heights
// as words. Pure; any thread.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "core/measured/surface_draft.h"

namespace asperity {

/// Without the mark of UTF-8 at the beginning.
std::string_view withoutByteOrderMark(std::string_view bytes);

/// Takes one line or word after another from a text, which must outlive it.
class WordReader {
 public:
  explicit WordReader(std::string_view text) : rest_(text) {}

  bool atEnd() const { return rest_.empty(); }
  std::size_t left() const { return rest_.size(); }  // bytes
  /// The line of what was taken last, counted from 1.
  std::size_t line() const { return line_; }

  /// The rest of the line, without the blanks around it.
  std::string_view nextLine();
  /// What stands before the next blank or line end; empty at the end of the text.
  std::string_view nextWord();

 private:
  std::string_view rest_;
  std::size_t ended_ = 0;  // lines
  std::size_t line_ = 0;
};

/// The words of a line.
std::vector<std::string_view> splitWords(std::string_view line);

/// The word as a number; nothing where it is none that is finite.
std::optional<double> parseFiniteNumber(std::string_view word);

/// The word as the height with this number, counted from 0; NaN for a word that stands for a
/// missing value. Throws InputError, with the line that the reader is at, where it is none of
/// these.
double parseHeight(const SurfaceSource& source, const WordReader& reader, std::string_view word,
                   std::size_t number);

/// How the heights of a file are written.
struct HeightWords {
  double scale = 1;                                          // of each number
  double gapFrom = std::numeric_limits<double>::infinity();  // this number and those above it
  char end = '\0';                                           // begins what follows the heights
};

/// Appends `count` words as heights. A word for a missing value is a gap. Throws InputError where a
/// word is anything else, or where the text ends before.
void readHeights(const SurfaceSource& source, WordReader& reader, std::size_t count,
                 const HeightWords& words, std::vector<double>& heights);

/// Refuses a further number behind `count` heights.
void requireNoMoreHeights(const SurfaceSource& source, WordReader& reader, std::size_t count);

}  // namespace asperity
