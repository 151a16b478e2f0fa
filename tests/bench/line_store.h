// The rough lines of the benchmarks, each made once and kept: L = 0.02 m, h = 5e-7 m, H = 0.7.
// Threading: the main thread only. References stay valid until clear().
#pragma once

#include <cstdint>

#include "core/contact/line/prepared_profile.h"
#include "core/scene/scene.h"

namespace asperity::bench {

struct LineKey {
  std::int64_t elements = 5000;
  Scheme scheme = Scheme::Cubic;
  std::int64_t oversampling = 2;
  std::int64_t realization = 0;
  auto operator<=>(const LineKey&) const = default;
};

/// The scene of resources/scenes/figure_2.json with this line's keys.
Scene sceneOf(const LineKey& key);

const PreparedProfile& preparedProfile(const LineKey& key);

/// The line itself, at its own N nodes, for the literal algorithm.
const Line& nodeLine(std::int64_t elements, std::int64_t realization = 0);

void clearLines();

}  // namespace asperity::bench
