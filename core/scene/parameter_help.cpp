#include "core/scene/parameter_help.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/number_text.h"
#include "core/scene/parameters.h"

namespace asperity {
namespace {

std::string valueText(const ParameterValue& value) {
  if (const auto* real = std::get_if<double>(&value)) return plainNumber(*real);
  return std::visit([](const auto& held) { return fmt::format("{}", held); }, value);
}

}  // namespace

std::string parameterTableText() {
  std::string text;
  for (const Parameter& row : parameters()) {
    const std::string usual = valueText(defaultValue(row));
    text += fmt::format("  {:<28} {} ({}{})\n", row.key, row.sentence, allowedText(row),
                        usual.empty() ? "" : "; default " + usual);
  }
  return text;
}

std::string escapedMarkdown(std::string_view text) {
  std::string plain;
  for (const char letter : text) {
    if (std::string_view("\\`*_{}[]<>#+-!|~^$\"'").find(letter) != std::string_view::npos)
      plain += '\\';
    plain += letter;
  }
  return plain;
}

std::string parameterListMarkdown() {
  std::string text;
  for (const Parameter& row : parameters()) {
    std::string anchor(row.key);
    std::ranges::replace(anchor, '.', '-');
    const std::string usual = valueText(defaultValue(row));
    text += fmt::format("[`{}`]{{#key-{}}} {}{}\n\n:   {}\n\n", row.key, anchor,
                        escapedMarkdown(allowedText(row).english()),
                        usual.empty() ? "" : "; default " + escapedMarkdown(usual),
                        escapedMarkdown(row.sentence));
  }
  return text;
}

}  // namespace asperity
