#include "core/scene/parameter_help.h"

#include <fmt/format.h>

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
    const std::string usual = valueText(defaultOf(row));
    text += fmt::format("  {:<28} {} ({}{})\n", row.key, row.sentence, allowedText(row),
                        usual.empty() ? "" : "; default " + usual);
  }
  return text;
}

std::string parameterTableMarkdown() {
  std::string text = "| key | allowed | default | meaning |\n|---|---|---|---|\n";
  for (const Parameter& row : parameters())
    text += fmt::format("| `{}` | {} | {} | {} |\n", row.key, allowedText(row),
                        valueText(defaultOf(row)), row.sentence);
  return text;
}

}  // namespace asperity
