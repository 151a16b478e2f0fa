#include "core/scene/assignments.h"

#include <fmt/format.h>

#include "core/scene/effects.h"
#include "core/scene/parameters.h"

namespace asperity {

namespace {

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

}  // namespace asperity
