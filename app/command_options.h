// What words of the command line say: one of a few named things, a range FROM:TO, a number within
// limits; and one sentence for words that it cannot take, which names the option, what is wrong
// with it and what is allowed. Main thread.
#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/input_error.h"
#include "core/base/text.h"

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

struct NumberRange {
  double from = 0, to = 0;
};

/// Two finite numbers, the first one below the second. Throws InputError naming the option; unit:
/// of both, for its sentence; may be empty.
NumberRange rangeFrom(const std::string& option, const std::string& text, const std::string& unit);

/// The option takes a finite number, or a whole one, within limits that its help shows, with the
/// unit.
void limit(CLI::Option* option, double least, double most, std::string_view unit = {});
void limitWhole(CLI::Option* option, std::int64_t least, std::int64_t most);

/// No option or file of the app and its verbs may be empty text, and a flag takes no value: both
/// would be taken in silence. Once, when all options are there.
void refuseEmptyWords(CLI::App& app);

/// What was wrong, in our words. app: the one that parsed.
InputError errorOf(const CLI::App& app, const CLI::ParseError& error);

/// Throws InputError where options of the app itself stand before a verb, which does not see them.
void refuseWordsBeforeVerb(const CLI::App& app);

}  // namespace asperity
