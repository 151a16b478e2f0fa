// One of a few things that have names, chosen by a word of the command line or of a file. Pure.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/input_error.h"
#include "core/base/suggestions.h"

namespace asperity {

template <class Choice, std::size_t N>
using NamedChoices = std::array<std::pair<std::string_view, Choice>, N>;

/// The one of this name. Throws InputError naming the key, or the option, and all names.
template <class Choice, std::size_t N>
Choice chosenFrom(const NamedChoices<Choice, N>& choices, const std::string& name,
                  const char* key) {
  std::array<std::string_view, N> known;
  for (std::size_t i = 0; i < N; ++i) {
    if (choices[i].first == name) return choices[i].second;
    known[i] = choices[i].first;
  }
  throw InputError("", key, notOneOf(name, known));
}

}  // namespace asperity
