// A motion marched for tests of what is made of its samples.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/run/transient.h"

namespace asperity {

/// Returns `count` samples at equal distances over the scene's duration, after one at time 0 from
/// its first step.
inline std::vector<TransientSample> transientSamples(const Scene& scene, std::int64_t count) {
  Transient transient(scene, std::make_shared<RigidLine>(scene),
                      std::max(count, Transient::kMinSteps));
  std::vector<TransientSample> samples{transient.singleStep()};
  samples.front().time = 0;
  for (std::int64_t i = 1; i <= count && !transient.isOver(); ++i)
    samples.push_back(transient.marchTo(transient.motion().duration() * static_cast<double>(i) /
                                        static_cast<double>(count)));
  return samples;
}

}  // namespace asperity
