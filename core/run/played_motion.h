// A motion as it is played in the window: its march, the samples of its diagram, and states from
// which it goes on after a jump in time. The same calls give the same samples; no threads and no
// clock. Cannot fail.
#pragma once

#include <cstddef>
#include <vector>

#include "core/run/frame.h"
#include "core/run/transient.h"

namespace asperity {

class PlayedMotion {
 public:
  /// beginning: the motion at time 0.
  explicit PlayedMotion(const Transient& beginning) : transient_(beginning) {}

  const Transient& transient() const { return transient_; }
  const Motion& motion() const { return transient_.motion(); }
  const std::vector<TransientSample>& samples() const { return samples_; }  // since the beginning
  /// Returns the samples after the present time, which were made before the motion went back.
  const std::vector<TransientSample>& later() const { return later_; }

  void record(const MarchRecords& wanted) { transient_.record(wanted); }

  /// Marches at least one step, and on to this time (s), with samples on the way: their distance in
  /// time is limited, so that a fast pace leaves none out. The first one begins at time 0.
  void marchTo(double time);

  /// Keeps the present state where the last one is long ago.
  void keepState();

  /// Goes to the nearest state at or before a time (s), to march on from it: a kept one, earlier or
  /// later than the present one, or the beginning. All samples stay, before or after it. Returns
  /// whether it is another state than the present one.
  bool goTo(double time, const Transient& beginning);

 private:
  TransientSample sampleUpTo(double time);
  void add(const TransientSample& sample);

  Transient transient_;
  std::vector<TransientSample> samples_, later_;
  std::vector<Transient> kept_;  // at rising times
};

}  // namespace asperity
