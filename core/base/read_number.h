// Numbers as programs write them, whatever the language in use. Pure; any thread.
#pragma once

#include <charconv>
#include <string_view>
#include <system_error>

namespace asperity {

/// All of the text as a number that its type can hold; false where there is more or less.
template <class Number>
bool readNumber(std::string_view text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size();
}

}  // namespace asperity
