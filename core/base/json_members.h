// Members of JSON objects, read with errors that name their place: "space.load.normal_force.from".
// Pure; any thread. Failure: InputError with the place and what is allowed.
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

/// Throws InputError with the place.
[[noreturn]] void refuseMember(const std::string& place, const Message& why);

/// Throws where the value is no object, or has a member that is not known.
void checkMembers(const nlohmann::ordered_json& object, const std::string& where,
                  std::initializer_list<std::string_view> known);

double numberMember(const nlohmann::ordered_json& object, const std::string& where,
                    const char* member);
std::optional<double> optionalNumberMember(const nlohmann::ordered_json& object,
                                           const std::string& where, const char* member);
std::int64_t integerMember(const nlohmann::ordered_json& object, const char* member,
                           std::int64_t least, std::int64_t most, const std::string& where = "");
std::string textMember(const nlohmann::ordered_json& object, const char* member,
                       const std::string& otherwise = "", const std::string& where = "");

/// Names and what they stand for.
template <class Choice, std::size_t N>
using NamedChoices = std::array<std::pair<std::string_view, Choice>, N>;

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

template <class Choice, std::size_t N>
std::string_view choiceWord(const NamedChoices<Choice, N>& choices, Choice choice) {
  for (const auto& [word, one] : choices)
    if (one == choice) return word;
  return {};
}

}  // namespace asperity
