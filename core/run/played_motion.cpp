#include "core/run/played_motion.h"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

// Samples of a motion, at least: as many as its march has steps.
constexpr double kSamplesOfMotion = Transient::kLeastSteps;

// States of a motion that are kept to go back to: how many, and their size in bytes together.
constexpr double kMostKept = 32, kKeptBytes = 64e6;

}  // namespace

void PlayedMotion::marchTo(double time) {
  if (samples_.empty()) {
    const TransientSample first = transient_.singleStep();
    samples_.push_back(first);
    samples_.front().time = samples_.front().distance = 0;
    samples_.push_back(first);
  } else {
    samples_.push_back(sampleUpTo(time));
  }
  while (transient_.canReach(time)) samples_.push_back(sampleUpTo(time));
}

/// Marches to this time, or to the next multiple of the longest distance of samples. The present
/// time is near its own multiple, because steps are whole.
TransientSample PlayedMotion::sampleUpTo(double time) {
  const double longest = motion().duration() / kSamplesOfMotion;
  return transient_.marchTo(
      std::min(time, (std::round(transient_.time() / longest) + 1) * longest));
}

void PlayedMotion::keepState() {
  const TimeMarch& march = transient_.march();
  const double numbers = 4 + static_cast<double>(march.modes().modes());  // of an element
  // The coarser lines that estimate the error have one and a half times as many elements together.
  const double bytes = 2.5 * sizeof(double) * numbers * static_cast<double>(march.depth().size());
  const double most = std::clamp(std::floor(kKeptBytes / bytes), 1.0, kMostKept);
  const double between = motion().duration() / (most + 1);
  const double last = kept_.empty() ? 0 : kept_.back().transient.time();
  if (transient_.time() >= last + between) kept_.push_back({transient_, samples_.size()});
}

bool PlayedMotion::goBackTo(double time) {
  while (!kept_.empty() && kept_.back().transient.time() > time) kept_.pop_back();
  if (kept_.empty()) return false;
  transient_ = kept_.back().transient;
  samples_.resize(kept_.back().samples);
  return true;
}

}  // namespace asperity
