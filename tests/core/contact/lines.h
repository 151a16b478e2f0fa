// Lines that several contact tests use.
#pragma once

#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/contact/steady_sliding.h"
#include "core/surface/line_source.h"

namespace asperity {

/// The public reference profile: one rough period, L = 0.02 m.
inline Line referenceProfile(std::int64_t oversampling) {
  Scene scene;
  scene.surface.kind = SurfaceKind::Profile;
  scene.surface.length = 0;
  scene.surface.elements = 0;
  scene.surface.file = "profile_public.csv";
  scene.folder = std::string(ASPERITY_TESTS_DIR) + "/reference";
  return LineSource(scene, oversampling).make(0);
}

/// A self-affine line; h = 5e-7 m, L = 0.02 m.
inline Line roughLine(std::int64_t elements, std::int64_t oversampling = 1, double hurst = 0.7,
                      std::int64_t realization = 0) {
  Scene scene;
  scene.surface.elements = elements;
  scene.surface.hurst = hurst;
  return LineSource(scene, oversampling).make(realization);
}

/// Returns the line in the mirror x -> -x: sliding under it is sliding back under the line itself.
inline Line mirrored(const Line& line) {
  Line mirror = line;
  const std::size_t n = line.nodes();
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t from = (n - i) % n;
    mirror.height[i] = line.height[from];
    mirror.slopeAfter[i] = -line.slopeLeftOf(from);
    if (!line.slopeBefore.empty()) mirror.slopeBefore[i] = -line.slopeAfter[from];
  }
  return mirror;
}

inline double relativeError(double value, double exact) {
  return std::abs(value / exact - 1);
}

inline constexpr double kModulus = 1e7, kTau = 1e-3;  // Pa, s

/// The conditions whose relaxation length v tau is c (m).
inline SlidingConditions withRelaxationLength(double c) {
  return {kModulus, kTau, c / kTau};
}

struct ConvergedRow {
  double normalForce, velocity, mu, contactFraction, rmsSlopeContact, indentation;
};

inline std::vector<ConvergedRow> convergedRows() {
  std::ifstream stream(std::string(ASPERITY_TESTS_DIR) + "/reference/converged_public.csv");
  if (!stream) throw std::runtime_error("converged_public.csv is missing");
  std::vector<ConvergedRow> rows;
  double force = 0;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("# normal_force=")) force = std::stod(line.substr(15));
    if (line.empty() || line.find_first_not_of("0123456789") == 0) continue;
    for (char& letter : line)
      if (letter == ',') letter = ' ';
    ConvergedRow row{force, 0, 0, 0, 0, 0};
    std::istringstream(line) >> row.velocity >> row.mu >> row.contactFraction >>
        row.rmsSlopeContact >> row.indentation;
    rows.push_back(row);
  }
  return rows;
}

}  // namespace asperity
