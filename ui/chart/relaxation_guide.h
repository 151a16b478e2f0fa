// How friction is about to relax after a jump of the velocity, for the strips of a motion. Pure;
// any thread.
#pragma once

#include <vector>

#include "core/run/transient_sample.h"
#include "core/scene/scene.h"

namespace asperity {

struct GuidePoint {
  double time = 0;  // s
  double mu = 0;
};

/// mu_end + (mu_0 - mu_end) exp(-integral of (1/tau + |v|/l) dt) from the first sample after the
/// newest jump on, mu_end being that of the last sample. Empty where the velocity has not jumped,
/// changes all the time, or friction or rate is not known there.
std::vector<GuidePoint> relaxationGuide(const Sliding& sliding,
                                        const std::vector<TransientSample>& samples);

}  // namespace asperity
