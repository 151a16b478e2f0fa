// Reads members of JSON objects, with errors that name their path: "space.load.normal_force.from".
// Pure; any thread. Failure: InputError with the path and what is allowed.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/message.h"

namespace asperity {

/// Throws InputError with the path.
[[noreturn]] void refuseMember(const std::string& path, const Message& why);

/// Throws InputError where the value is no object, or has a member that is not known.
void checkMembers(const nlohmann::ordered_json& object, const std::string& where,
                  std::initializer_list<std::string_view> known);

/// Returns a number. where: the path of the object, here and below. Throws InputError where the
/// member is missing or no number.
double numberMember(const nlohmann::ordered_json& object, const std::string& where,
                    const char* member);
/// Returns a number, or nothing where the member is missing.
std::optional<double> optionalNumberMember(const nlohmann::ordered_json& object,
                                           const std::string& where, const char* member);
/// Returns a whole number from `least` to `most`; the member must exist.
std::int64_t integerMember(const nlohmann::ordered_json& object, const char* member,
                           std::int64_t least, std::int64_t most, const std::string& where = "");
/// Returns a text, or `otherwise` where the member is missing.
std::string textMember(const nlohmann::ordered_json& object, const char* member,
                       const std::string& otherwise = "", const std::string& where = "");

/// The words of an enumeration with their enumerators.
template <class Choice, std::size_t N>
using NamedChoices = std::array<std::pair<std::string_view, Choice>, N>;

/// Returns the enumerator of a word. Throws InputError with the known words for any other one.
template <class Choice, std::size_t N>
Choice chosen(const NamedChoices<Choice, N>& choices, const std::string& word,
              const std::string& where) {
  std::array<std::string_view, N> known;
  for (std::size_t i = 0; i < N; ++i) {
    if (choices[i].first == word) return choices[i].second;
    known[i] = choices[i].first;
  }
  refuseMember(where, notOneOf(word, known));
}

/// Returns the word of an enumerator.
template <class Choice, std::size_t N>
std::string_view choiceWord(const NamedChoices<Choice, N>& choices, Choice choice) {
  for (const auto& [word, one] : choices)
    if (one == choice) return word;
  return {};
}

}  // namespace asperity
