// A text for people that core makes: a template in English and the values that stand in it. Tables,
// JSON and standard error have it in English; whoever shows it in another language looks up the
// template and puts the values in (ui/language/translated.h). Plain values; any thread.
#pragma once

#include <fmt/core.h>

#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace asperity {

/// A number, or a quantity with its unit, that is printed already: "1.5", "10 mN".
struct PrintedNumber {
  std::string text;
};

struct Message {
  enum class Kind {
    Template,  // English, with %1, %2, ... where the values stand; it is looked up
    Number,    // as machines write it ("1e-10") or printed; only its style depends on the language
    Name,      // what is the same in every language: keys, files, what a user wrote
  };

  std::string text{};
  std::vector<Message> values{};
  Kind kind = Kind::Template;

  Message() = default;
  Message(const char* english) : text(english) {}
  Message(std::string english) : text(std::move(english)) {}
  Message(std::string_view english) : text(english) {}
  Message(PrintedNumber number) : text(std::move(number.text)), kind(Kind::Number) {}

  static Message name(std::string text);

  bool empty() const { return text.empty(); }
  std::string english() const;
  /// With everything in it in printable characters (core/base/text.h).
  Message quoted() const;

  bool operator==(const Message&) const = default;
  /// An order for sets.
  bool operator<(const Message& other) const;
  friend std::ostream& operator<<(std::ostream& out, const Message& message) {
    return out << message.english();
  }
};

/// The places %1, %2, ... of a template, filled with the values; any other text stays as it is.
std::string filled(std::string_view form, const std::vector<std::string>& values);

/// All of them as one list: "a, b, c". The empty ones are left out.
Message listed(const std::vector<Message>& parts);

/// All of them behind each other, a space between two. The empty ones are left out.
Message sentences(const std::vector<Message>& parts);

/// "pink is not one of light, dark, print".
Message notOneOf(std::string_view given, std::span<const std::string_view> known);

namespace detail {

/// "waves above {:.3g} m" as "waves above %1 m" and {"{:.3g}"}.
struct Places {
  explicit Places(std::string_view format);

  std::string form;
  std::vector<std::string> formats;
};

template <class Value>
Message messageValue(const std::string& format, const Value& value) {
  if constexpr (std::is_same_v<Value, Message>) {
    return value;
  } else if constexpr (std::is_same_v<Value, PrintedNumber>) {
    return Message(value);
  } else {
    Message made = Message::name(fmt::format(fmt::runtime(format), value));
    if constexpr (std::is_arithmetic_v<Value>) made.kind = Message::Kind::Number;
    return made;
  }
}

}  // namespace detail

/// A template in the syntax of fmt, and its values in the order of their places: numbers, texts
/// that are names, and messages. The German file has it as "waves above %1 m".
template <class... Values>
Message message(fmt::format_string<const Values&...> format, const Values&... values) {
  const fmt::string_view view = format;
  detail::Places places({view.data(), view.size()});
  Message made(std::move(places.form));
  std::size_t i = 0;
  (made.values.push_back(detail::messageValue(places.formats[i++], values)), ...);
  return made;
}

}  // namespace asperity

template <>
struct fmt::formatter<asperity::Message> : fmt::formatter<std::string> {
  auto format(const asperity::Message& message, fmt::format_context& context) const {
    return fmt::formatter<std::string>::format(message.english(), context);
  }
};

template <>
struct fmt::formatter<asperity::PrintedNumber> : fmt::formatter<std::string> {
  auto format(const asperity::PrintedNumber& number, fmt::format_context& context) const {
    return fmt::formatter<std::string>::format(number.text, context);
  }
};
