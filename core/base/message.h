// A text for users that core makes: an English template and the values in it. Tables, JSON and
// standard error have it in English; other languages look up the template and insert the values
// (ui/language/translated.h). Plain values; any thread.
#pragma once

#include <fmt/core.h>

#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace asperity {

/// A number, or a quantity with its unit, that has been formatted: "1.5", "10 mN".
struct PrintedNumber {
  std::string text;
};

struct Message {
  enum class Kind {
    Template,  // English, with %1, %2, ... for the values; it is looked up
    Number,    // in machine format ("1e-10") or formatted; only its style depends on the language
    Name,      // the same in every language: keys, files, a user's text
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
  /// Returns the message with all its texts in printable characters (core/base/text.h).
  Message quoted() const;

  bool operator==(const Message&) const = default;
  /// Orders messages for use in sets.
  bool operator<(const Message& other) const;
  friend std::ostream& operator<<(std::ostream& out, const Message& message) {
    return out << message.english();
  }
};

/// Returns the messages in English, as files have them.
std::vector<std::string> englishOf(std::span<const Message> messages);

/// Returns the template with its placeholders %1, %2, ... replaced by the values; other text is
/// unchanged.
std::string filled(std::string_view form, const std::vector<std::string>& values);

/// Returns all messages as one list: "a, b, c". Empty ones are left out.
Message listed(const std::vector<Message>& parts);

/// Returns all messages one after the other, with a space between two. Empty ones are left out.
Message sentences(const std::vector<Message>& parts);

/// Returns "light, dark, print": names as they are, in every language.
Message namesWithCommas(std::span<const std::string_view> names);

/// Returns "pink is not one of light, dark, print".
Message notOneOf(std::string_view given, std::span<const std::string_view> known);

namespace detail {

/// Splits "waves above {:.3g} m" into "waves above %1 m" and {"{:.3g}"}.
struct Placeholders {
  explicit Placeholders(std::string_view format);

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

/// Makes a message from a template in the syntax of fmt and its values in the order of their
/// placeholders: numbers, texts that are names, and messages. The German file has the template as
/// "waves above %1 m".
template <class... Values>
Message message(fmt::format_string<const Values&...> format, const Values&... values) {
  const fmt::string_view view = format;
  detail::Placeholders placeholders({view.data(), view.size()});
  Message made(std::move(placeholders.form));
  std::size_t i = 0;
  (made.values.push_back(detail::messageValue(placeholders.formats[i++], values)), ...);
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
