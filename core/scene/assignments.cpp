#include "core/scene/assignments.h"

#include <fmt/format.h>

#include "core/scene/effects.h"
#include "core/scene/parameters.h"

namespace asperity {

namespace {

constexpr char kBetween = ';', kEscape = '\\';  // of several assignments in one word

std::string textOf(const ParameterValue& value) {
  return std::visit([](const auto& held) { return fmt::format("{}", held); }, value);
}

bool isResolution(const Parameter& row) {
  return row.key == "accuracy.scheme" || row.key == "accuracy.oversampling";
}

/// A target chooses the resolution, and the other way round: only one of them may be said.
bool isSaid(const Parameter& row, const Scene& scene) {
  if (!isApplicable(row, scene)) return false;
  if (row.key == "accuracy.target_relative_error") return choosesAccuracy(scene);
  return !isResolution(row) || !choosesAccuracy(scene);
}

/// Whether the base's own text would leave another value here. What has no meaning in the base does
/// not stand there, and then the default counts.
bool differs(const Parameter& row, const Scene& base, const Scene& scene) {
  const ParameterValue value = valueOf(row, scene);
  if (isResolution(row) && choosesAccuracy(base)) return true;
  return value != valueOf(row, base) || (!isApplicable(row, base) && value != defaultOf(row));
}

}  // namespace

std::vector<std::string> assignmentsFrom(const Scene& base, const Scene& scene) {
  std::vector<std::string> assignments;
  for (const Parameter& row : parameters())
    if (isSaid(row, scene) && differs(row, base, scene))
      assignments.push_back(fmt::format("{}={}", row.key, textOf(valueOf(row, scene))));
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
