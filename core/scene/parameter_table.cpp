#include "core/scene/parameter_table.h"

#include <fmt/format.h>

#include "core/scene/parameters.h"

namespace asperity {
namespace {

std::string valueText(const ParameterValue& value) {
  return std::visit([](const auto& held) { return fmt::format("{}", held); }, value);
}

std::string allowedWithUnit(const Parameter& row) {
  return row.unit.empty() ? allowedText(row) : fmt::format("{} {}", allowedText(row), row.unit);
}

}  // namespace

std::string parameterTableText() {
  std::string text;
  for (const Parameter& row : parameters()) {
    const std::string usual = valueText(defaultOf(row));
    text += fmt::format("  {:<28} {} ({}{})\n", row.key, row.sentence, allowedWithUnit(row),
                        usual.empty() ? "" : "; default " + usual);
  }
  return text;
}

std::string parameterTableMarkdown() {
  std::string text = "| key | allowed | default | meaning |\n|---|---|---|---|\n";
  for (const Parameter& row : parameters())
    text += fmt::format("| `{}` | {} | {} | {} |\n", row.key, allowedWithUnit(row),
                        valueText(defaultOf(row)), row.sentence);
  return text;
}

}  // namespace asperity
