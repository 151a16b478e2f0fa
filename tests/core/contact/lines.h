// Lines that several contact tests use.
#pragma once

#include <string>

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

inline constexpr double kModulus = 1e7, kTau = 1e-3;  // Pa, s

/// The conditions whose relaxation length v tau is c (m).
inline SlidingConditions withRelaxationLength(double c) {
  return {kModulus, kTau, c / kTau};
}

}  // namespace asperity
