// What friction depends on at a scene's own state, as pictures and as tables: the exponent of each
// parameter (core/fit/derivatives.h), sorted by size, and the waves of the line
// (core/friction/short_wave_cutoff.h). Pure; any thread.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/chart/diagram.h"
#include "core/fit/derivatives.h"
#include "core/friction/short_wave_cutoff.h"

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

/// Returns the friction of the lines without the waves below lambda_c, and below it the part of all
/// friction that each decade of wavelengths makes.
DiagramSheet cutoffSheet(const Scene& scene, const std::vector<CutoffPoint>& points);

/// Returns in sentences which waves make friction: without which it is half as large, and whether
/// shorter waves than those of the line would change it.
std::vector<Message> describeCutoff(const std::vector<CutoffPoint>& points);
std::string cutoffCsv(const std::vector<CutoffPoint>& points);
std::string cutoffJson(const Scene& scene, const std::vector<CutoffPoint>& points);

}  // namespace asperity
