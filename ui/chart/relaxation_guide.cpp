#include "ui/chart/relaxation_guide.h"

#include <algorithm>
#include <cmath>

#include "core/scene/motion.h"

namespace asperity {

namespace {

/// s, when the velocity last jumped before `now`; a start from rest jumps at 0. NaN: never.
double newestJump(const Sliding& sliding, double now) {
  const Motion motion(sliding);
  if (sliding.kind == SlidingKind::Start) return 0;
  const bool jumped = motion.jump() < motion.duration() && now > motion.jump();
  return jumped && !motion.isSmooth() ? motion.jump() : kNotApplicable;
}

bool isKnown(const TransientSample& sample) {
  return std::isfinite(sample.mu) && std::isfinite(sample.predictedRate);
}

}  // namespace

std::vector<GuidePoint> relaxationGuide(const Sliding& sliding,
                                        const std::vector<TransientSample>& samples) {
  if (samples.empty() || !isKnown(samples.back())) return {};
  const double jump = newestJump(sliding, samples.back().time);
  const auto first = std::ranges::find_if(
      samples, [&](const TransientSample& s) { return s.time > jump && isKnown(s); });
  if (first == samples.end()) return {};
  const double end = samples.back().mu;
  double time = first->time, exponent = 0;
  std::vector<GuidePoint> guide;
  for (auto sample = first; sample != samples.end() && isKnown(*sample); ++sample) {
    exponent += sample->predictedRate * (sample->time - time);
    time = sample->time;
    guide.push_back({time, end + (first->mu - end) * std::exp(-exponent)});
  }
  return guide;
}

}  // namespace asperity
