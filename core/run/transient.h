// A motion marched through its duration: what friction, indentation and contact did at each time.
// The same calls give the same samples; no threads and no clock of its own.
// Ownership: holds line and march; samples are values, handed out as immutable.
// Failure: the constructor throws InputError for a scene that cannot run and std::runtime_error
// where its first steady state has no balance.
#pragma once

#include <cstdint>
#include <memory>
#include <stop_token>
#include <vector>

#include "core/contact/march/time_march.h"
#include "core/run/rigid_line.h"
#include "core/run/transient_sample.h"
#include "core/scene/motion.h"
#include "core/scene/scene.h"

namespace asperity {

class Transient {
 public:
  /// rigid: the scene's. The march takes `leastSteps` at least for the duration; they are at most
  /// one node long and meet the jump of a velocity. division: how many parts each of those steps is
  /// cut into.
  Transient(const Scene& scene, std::shared_ptr<const RigidLine> rigid,
            std::int64_t leastSteps = kLeastSteps, int division = 1);

  static constexpr std::int64_t kLeastSteps = 500;

  /// s, where the motion is fastest.
  double shortestStep() const;

  /// s, of the next step: no moment before its end can be told from this one. 0 once it is over.
  double nextStep() const;

  /// Whether the next step ends by that time (s).
  bool canReach(double time) const;

  /// Steps from here to the motion's end, counted one by one without marching; where they are more
  /// than `most`, from the length of steps at moments all over the motion.
  double countSteps(double most = 2e5) const;

  /// Marches the same motion on a coarser line (every second node, or every third ...) beside this
  /// one, at a quarter of its cost, and tells from the difference how far friction is from that of
  /// ever finer lines: samples then have their muError. Not for separate elements, which have no
  /// finer line, and where no small number divides the nodes. To be called before the first step.
  void estimateErrors(const Scene& scene);

  /// What its march notes of the elements from now on.
  void record(MarchRecords wanted);

  const Motion& motion() const { return motion_; }
  const TimeMarch& march() const { return march_; }
  double time() const { return time_; }
  std::uint64_t steps() const { return steps_; }
  bool isOver() const { return time_ >= motion_.duration(); }

  /// Marches one step at least, and on as long as whole steps end by that time (s), or exactly to
  /// the motion's jump and end; gives the means on the way.
  TransientSample marchTo(double time);

  /// One step.
  TransientSample singleStep();

 private:
  class Means;
  double stepAt(double time) const;
  double markAfter(double time) const;
  double estimateSteps() const;
  bool endsAtMark(double dt) const;
  double timeAfter(double dt);
  void stepOnce(double dt, Means& means);
  void addError(TransientSample& sample);

  Load load_;
  Interface interface_;
  bool hasInterface_, startsAtRest_;
  Motion motion_;
  double longestStep_;  // s
  int division_;
  std::shared_ptr<const RigidLine> rigid_;
  TimeMarch march_;
  MarchStep last_;
  double relaxation_;  // s, of Kelvin elements; NaN of others
  double time_ = 0;
  /// Equal steps in a row: their number, their length (s) and when they began (s).
  double run_ = 0, runStep_ = 0, runBegin_ = 0;
  std::uint64_t steps_ = 0;
  std::vector<Transient> coarse_;  // none or one
  double coarseness_ = 1;          // its spacing over that of this one
};

/// Of the newest of these samples: the root mean square of their errors; NaN where none is known.
double recentError(const std::vector<TransientSample>& samples);

/// `count` samples evenly over the scene's duration, after one at time 0 from its first step. Ends
/// early, with those it has, where `stop` is requested.
std::shared_ptr<const std::vector<TransientSample>> transientOf(const Scene& scene,
                                                                std::int64_t count,
                                                                const std::stop_token& stop = {});

}  // namespace asperity
