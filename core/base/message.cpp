#include "core/base/message.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "core/base/text.h"

namespace asperity {
namespace {

Message joined(const std::vector<Message>& parts, const char* form) {
  Message whole;
  for (const Message& part : parts) {
    if (part.empty()) continue;
    if (whole.empty()) {
      whole = part;
      continue;
    }
    Message pair(form);
    pair.values = {std::move(whole), part};
    whole = std::move(pair);
  }
  return whole;
}

}  // namespace

Message Message::name(std::string text) {
  Message made(std::move(text));
  made.kind = Kind::Name;
  return made;
}

bool Message::operator<(const Message& other) const {
  if (text != other.text) return text < other.text;
  if (kind != other.kind) return kind < other.kind;
  return std::lexicographical_compare(values.begin(), values.end(), other.values.begin(),
                                      other.values.end());
}

std::string Message::english() const {
  return values.empty() ? text : filled(text, englishOf(values));
}

Message Message::quoted() const {
  Message made = *this;
  made.text = printable(text);
  for (Message& value : made.values) value = value.quoted();
  return made;
}

std::vector<std::string> englishOf(std::span<const Message> messages) {
  std::vector<std::string> texts;
  for (const Message& message : messages) texts.push_back(message.english());
  return texts;
}

std::string filled(std::string_view form, const std::vector<std::string>& values) {
  std::string whole;
  for (std::size_t i = 0; i < form.size(); ++i) {
    const bool isPlace = form[i] == '%' && i + 1 < form.size() && form[i + 1] >= '1' &&
                         form[i + 1] <= '9' &&
                         static_cast<std::size_t>(form[i + 1] - '1') < values.size();
    if (isPlace) {
      whole += values[static_cast<std::size_t>(form[i + 1] - '1')];
      ++i;
    } else {
      whole += form[i];
    }
  }
  return whole;
}

Message listed(const std::vector<Message>& parts) {
  return joined(parts, "%1, %2");
}

Message sentences(const std::vector<Message>& parts) {
  return joined(parts, "%1 %2");
}

Message namesWithCommas(std::span<const std::string_view> names) {
  return Message::name(fmt::format("{}", fmt::join(names, ", ")));
}

Message notOneOf(std::string_view given, std::span<const std::string_view> known) {
  return message("{} is not one of {}", shortened(given), namesWithCommas(known));
}

namespace detail {

Placeholders::Placeholders(std::string_view format) {
  for (std::size_t i = 0; i < format.size(); ++i) {
    const char letter = format[i];
    if ((letter == '{' || letter == '}') && i + 1 < format.size() && format[i + 1] == letter) {
      form += letter;
      ++i;
    } else if (letter == '{') {
      const std::size_t end = format.find('}', i);
      formats.emplace_back(format.substr(i, end + 1 - i));
      form += '%' + std::to_string(formats.size());
      i = end;
    } else {
      form += letter;
    }
  }
}

}  // namespace detail
}  // namespace asperity
