// The words for the enumerators of an enumeration, in files and in options of the command line.
// Constant; any thread.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/input_error.h"

namespace asperity {

/// The words of an enumeration with their enumerators.
template <class Choice, std::size_t N>
using NamedChoices = std::array<std::pair<std::string_view, Choice>, N>;

/// Returns the enumerator of a word. Throws InputError with the key or option `where` and the known
/// words for any other one.
template <class Choice, std::size_t N>
Choice chosen(const NamedChoices<Choice, N>& choices, const std::string& word,
              const std::string& where) {
  std::array<std::string_view, N> known;
  for (std::size_t i = 0; i < N; ++i) {
    if (choices[i].first == word) return choices[i].second;
    known[i] = choices[i].first;
  }
  throw InputError("", where, notOneOf(word, known));
}

/// Returns the word of an enumerator.
template <class Choice, std::size_t N>
std::string_view choiceWord(const NamedChoices<Choice, N>& choices, Choice choice) {
  for (const auto& [word, one] : choices)
    if (one == choice) return word;
  return {};
}

}  // namespace asperity
