// Texts from a user or a file: quoting them in printable characters, shortening and splitting them,
// comparing them with lists of words, finding the nearest known word, making file names from them.
// Pure; any thread.
#pragma once

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace asperity {

/// Returns the text with every character escaped that a terminal would interpret, or that is
/// displayed as something else: line ends and tabs as \n, \r and \t, other control characters and
/// bytes that are not UTF-8 as \x1b, invisible marks (directions of writing, zero width) as \u202e.
/// Printable characters are unchanged, so quoting twice has the same result.
std::string printable(std::string_view text);

/// Returns a user's text, shortened so that it can be quoted in a message.
std::string shortened(std::string_view text);

/// Returns the parts of a text between separators; where there is none, the text itself.
std::vector<std::string_view> splitText(std::string_view text, std::string_view separator);

/// Appends an item to a list that is written as one text. The separator stands between two items.
void appendItem(std::string& list, std::string_view item, std::string_view separator = ", ");

/// A list of words, written as one text, as a range of its words: WordList("load force weight").
/// Words with blanks are separated by commas: WordList("step size, x step", ','). Ownership: the
/// list and its words are views of the text, which is a literal.
class WordList {
 public:
  constexpr WordList(const char* text, char separator = ' ') : text_(text), separator_(separator) {}
  constexpr explicit WordList(std::string_view text) : text_(text) {}

  class Iterator {
   public:
    using value_type = std::string_view;
    using difference_type = std::ptrdiff_t;

    Iterator() = default;
    constexpr Iterator(std::string_view rest, char separator)
        : rest_(rest), separator_(separator) {}

    constexpr std::string_view operator*() const { return rest_.substr(0, rest_.find(separator_)); }
    constexpr Iterator& operator++() {
      rest_.remove_prefix(std::min((**this).size() + 1, rest_.size()));
      while (rest_.starts_with(' ')) rest_.remove_prefix(1);
      return *this;
    }
    constexpr Iterator operator++(int) {
      const Iterator before = *this;
      ++*this;
      return before;
    }
    constexpr bool operator==(const Iterator& other) const {
      return rest_.size() == other.rest_.size();
    }

   private:
    std::string_view rest_{};
    char separator_ = ' ';
  };

  constexpr Iterator begin() const { return {text_, separator_}; }
  constexpr Iterator end() const { return {{}, separator_}; }

 private:
  std::string_view text_;
  char separator_ = ' ';
};

/// Returns whether the word is one of these.
template <class List = std::initializer_list<std::string_view>>
requires(!std::is_convertible_v<const List&, const char*>) bool isOneOf(std::string_view word,
                                                                        const List& words) {
  return std::ranges::find(words, word) != std::ranges::end(words);
}
inline bool isOneOf(std::string_view word, const WordList& words) {
  return std::ranges::find(words, word) != words.end();
}

/// Returns whether one of some words is in the list.
template <class List>
bool hasOneOf(const List& some, const WordList& list) {
  return std::ranges::any_of(some, [&list](std::string_view word) { return isOneOf(word, list); });
}

/// Returns whether the text begins with one of these.
inline bool beginsWithOneOf(std::string_view text, const WordList& words) {
  return std::ranges::any_of(words,
                             [text](std::string_view word) { return text.starts_with(word); });
}

/// Returns whether the text ends with one of these.
inline bool endsWithOneOf(std::string_view text, const WordList& words) {
  return std::ranges::any_of(words, [text](std::string_view word) { return text.ends_with(word); });
}

/// Returns whether the text contains one of these.
inline bool containsOneOf(std::string_view text, const WordList& words) {
  return std::ranges::any_of(
      words, [text](std::string_view word) { return text.find(word) != std::string_view::npos; });
}

/// Returns the known word nearest to `word` by edit distance; empty where the distance to all
/// exceeds half of the word's length.
std::string_view nearestWord(std::string_view word, std::span<const std::string_view> known);

/// Returns a file name: letters and digits of ASCII, '-' and '_' stay, every other byte becomes
/// '_'; 60 bytes at most. Empty for an empty name.
std::string makeFileName(std::string_view name);

}  // namespace asperity
