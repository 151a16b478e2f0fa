// The words for the enumerators of an enumeration, in files and in options of the command line.
// Constant; any thread.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/input_error.h"

namespace asperity {

/// The words of an enumeration with their enumerators.
template <class Choice, std::size_t N>
using NamedChoices = std::array<std::pair<std::string_view, Choice>, N>;

/// Returns the enumerator of a word; nothing for any other one.
template <class Choice, std::size_t N>
std::optional<Choice> findChoice(const NamedChoices<Choice, N>& choices, std::string_view word) {
  for (const auto& [known, choice] : choices)
    if (known == word) return choice;
  return {};
}

/// Returns the words.
template <class Choice, std::size_t N>
constexpr std::array<std::string_view, N> choiceWords(const NamedChoices<Choice, N>& choices) {
  std::array<std::string_view, N> words;
  std::ranges::transform(choices, words.begin(), [](const auto& choice) { return choice.first; });
  return words;
}

/// Says that a word is none of those of the enumeration, and which there are.
template <class Choice, std::size_t N>
Message notOneOf(std::string_view word, const NamedChoices<Choice, N>& choices) {
  return notOneOf(word, choiceWords(choices));
}

/// Returns the enumerator of a word. Throws InputError with the key or option `where` and the known
/// words for any other one.
template <class Choice, std::size_t N>
Choice chosen(const NamedChoices<Choice, N>& choices, const std::string& word,
              const std::string& where) {
  if (const auto choice = findChoice(choices, word)) return *choice;
  throw InputError("", where, notOneOf(word, choices));
}

/// Returns the word of an enumerator.
template <class Choice, std::size_t N>
std::string_view choiceWord(const NamedChoices<Choice, N>& choices, Choice choice) {
  for (const auto& [word, one] : choices)
    if (one == choice) return word;
  return {};
}

}  // namespace asperity
