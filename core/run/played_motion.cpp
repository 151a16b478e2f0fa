#include "core/run/played_motion.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace asperity {
namespace {

// Samples of a motion, at least: as many as its march has steps.
constexpr double kSamplesOfMotion = Transient::kMinSteps;

// States of a motion that are kept for jumps in time: how many, and their size in bytes together.
constexpr double kMaxKept = 32, kKeptBytes = 64e6;

}  // namespace

void PlayedMotion::marchTo(double time) {
  if (samples_.empty()) {
    const TransientSample first = transient_.singleStep();
    samples_.push_back(first);
    samples_.front().time = samples_.front().distance = 0;
    add(first);
  } else {
    add(sampleUpTo(time));
  }
  while (transient_.canReach(time)) add(sampleUpTo(time));
}

/// Adds a sample, which replaces those that were made of the same time before. A kept state has a
/// sample of its own time: those that now lie between two samples are forgotten.
void PlayedMotion::add(const TransientSample& sample) {
  const double last = samples_.empty() ? 0 : samples_.back().time;
  std::erase_if(kept_, [&](const Transient& state) {
    return state.time() > last && state.time() < sample.time;
  });
  samples_.push_back(sample);
  const auto isOver = [&](const TransientSample& other) { return other.time <= sample.time; };
  later_.erase(later_.begin(), std::ranges::partition_point(later_, isOver));
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
  const double most = std::clamp(std::floor(kKeptBytes / bytes), 1.0, kMaxKept);
  const double between = motion().duration() / (most + 1);
  const double last = kept_.empty() ? 0 : kept_.back().time();
  if (transient_.time() >= last + between) kept_.push_back(transient_);
}

bool PlayedMotion::goTo(double time, const Transient& beginning) {
  const auto isReached = [&](const Transient& state) { return state.time() <= time; };
  const auto after = std::ranges::partition_point(kept_, isReached);
  const Transient& nearest = after == kept_.begin() ? beginning : *std::prev(after);
  if (isReached(transient_) && nearest.time() <= transient_.time()) return false;
  transient_ = nearest;
  samples_.insert(samples_.end(), later_.begin(), later_.end());
  const bool isBeginning = transient_.steps() == 0;
  const auto next = std::ranges::find_if(samples_, [&](const TransientSample& sample) {
    return isBeginning || sample.time > transient_.time();
  });
  later_.assign(next, samples_.end());
  samples_.erase(next, samples_.end());
  return true;
}

}  // namespace asperity
