// The influence of each parameter on friction at a scene's own state (core/fit/derivatives.h), as a
// picture and as tables, sorted by size. Pure; any thread.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/chart/diagram.h"
#include "core/fit/derivatives.h"

namespace asperity {

/// d ln mu / d ln p of one parameter: the change of friction in per cent if the parameter changes
/// by one per cent.
struct Exponent {
  std::string_view key;
  double value = 0;  // of the parameter, SI
  Estimate exponent;
};

/// Returns the exponents of a scene, the largest first. For a parameter with a linear axis the
/// exponent is p d ln mu / d p.
std::vector<Exponent> sensitivityExponents(const Scene& scene, const std::vector<Sensitivity>& all);

/// Returns a row for each parameter with its exponent and the standard error; those that may be 0
/// come last.
DiagramSheet sensitivitySheet(const Scene& scene, const std::vector<Exponent>& all);

/// Returns a table for people: aligned columns below these names of parameter, value, exponent and
/// error.
std::string sensitivityText(const std::vector<Exponent>& all,
                            const std::array<std::string, 4>& head);
std::string sensitivityCsv(const std::vector<Exponent>& all);
std::string sensitivityJson(const Scene& scene, const std::vector<Exponent>& all);

}  // namespace asperity
