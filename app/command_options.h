// Reading of option values: one of several named choices, a range FROM:TO, a number within limits.
// An invalid value gives one sentence that names the option, the fault and the allowed values. Main
// thread.
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

/// Returns the choice of this name. Throws InputError that names the key or option, and all
/// choices.
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

/// Reads two finite numbers, the first below the second. Throws InputError naming the option. unit:
/// of both numbers, shown in the error; may be empty.
NumberRange rangeFrom(const std::string& option, const std::string& text, const std::string& unit);

/// Restricts the option to finite numbers, or integers, within limits. The help shows the limits
/// with their unit.
void limit(CLI::Option* option, double least, double most, std::string_view unit = {});
void limitWhole(CLI::Option* option, std::int64_t least, std::int64_t most);

/// Forbids empty text for options and files, and values for flags; CLI11 would accept both
/// silently. Call it once, after all options have been added.
void refuseEmptyWords(CLI::App& app);

/// Returns the parser's error in the words of this program. app: the app that parsed.
InputError errorOf(const CLI::App& app, const CLI::ParseError& error);

/// Throws InputError where options of the program are given before a command, which would ignore
/// them.
void refuseWordsBeforeCommand(const CLI::App& app);

}  // namespace asperity
