#include "core/scene/scene_assignments.h"

#include <fmt/format.h>

#include "core/scene/parameters.h"
#include "core/scene/scene_file.h"

namespace asperity {
namespace {

constexpr char kBetween = ';', kEscape = '\\';  // of several assignments in one word

std::string assignedValue(const ParameterValue& value) {
  return std::visit([](const auto& held) { return fmt::format("{}", held); }, value);
}

/// Returns whether the base's own text would leave another value here. A key without a meaning in
/// the base is not part of its text, so its default counts.
bool differs(const Parameter& row, const Scene& base, const Scene& scene) {
  const ParameterValue value = parameterValue(row, scene);
  if (isSetByTarget(row) && choosesAccuracy(base)) return true;
  if (row.rule.isOfMaterial && base.elastomer.material != scene.elastomer.material) return true;
  if (row.rule.isRequired && differs(*findParameter(row.applies.choiceKey), base, scene))
    return true;
  return value != parameterValue(row, base) ||
         (!isApplicable(row, base) && value != defaultValue(row));
}

}  // namespace

std::vector<std::string> differingAssignments(const Scene& base, const Scene& scene) {
  std::vector<std::string> assignments;
  for (const Parameter& row : parameters())
    if (isStated(row, scene) && differs(row, base, scene))
      assignments.push_back(
          fmt::format("{}={}", row.key, assignedValue(parameterValue(row, scene))));
  return assignments;
}

std::string joinedAssignments(const std::vector<std::string>& assignments) {
  std::string text;
  for (const std::string& assignment : assignments) {
    if (!text.empty()) text += kBetween;
    for (const char c : assignment) {
      if (c == kBetween || c == kEscape) text += kEscape;
      text += c;
    }
  }
  return text;
}

std::vector<std::string> separatedAssignments(std::string_view text) {
  std::vector<std::string> parts(1);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool escapes = text[i] == kEscape && i + 1 < text.size() &&
                         (text[i + 1] == kBetween || text[i + 1] == kEscape);
    if (escapes)
      parts.back() += text[++i];
    else if (text[i] == kBetween)
      parts.emplace_back();
    else
      parts.back() += text[i];
  }
  return parts;
}

}  // namespace asperity
