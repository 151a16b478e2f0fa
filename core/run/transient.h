// A motion marched through its duration, friction, indentation and contact at each time, and the
// same as it is played in the window, with jumps in time. The same calls give the same samples; no
// threads and no clock.
// Ownership: owns line and march; samples are immutable values.
// Failure: the constructor of Transient throws InputError for a scene that cannot run and
// std::runtime_error where its first steady state has no balance.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/contact/march/time_march.h"
#include "core/run/frame.h"
#include "core/run/rigid_line.h"
#include "core/scene/motion.h"
#include "core/scene/scene.h"

namespace asperity {

class Transient {
 public:
  /// rigid: the scene's. The march takes at least `leastSteps` for the duration; they are at most
  /// one node long and end at the jump of a velocity. division: number of parts into which each of
  /// those steps is cut.
  Transient(const Scene& scene, std::shared_ptr<const RigidLine> rigid,
            std::int64_t leastSteps = kMinSteps, int division = 1);

  static constexpr std::int64_t kMinSteps = Motion::kMinSteps;

  /// Returns the shortest step, where the motion is fastest, s.
  double shortestStep() const;

  /// Returns the next step, s: times before its end belong to the present state. 0 at the motion's
  /// end.
  double nextStep() const;

  /// Returns whether the next step ends by that time (s).
  bool canReach(double time) const;

  /// Returns the number of steps from here to the motion's end, counted one by one without
  /// marching; where they are very many, estimated from the length of steps at several times of the
  /// motion.
  double countSteps() const;

  /// Marches the same motion also on coarser lines (of every second and every fourth node, or every
  /// third and ninth ...; each begins at another node), and estimates from the differences the
  /// error of friction relative to infinitely fine lines: samples then have their muError, which
  /// the error does not exceed in 95 of 100 random scenes. One difference alone would not do: where
  /// a contact ends between two nodes is chance, and it is another chance on each of these lines.
  /// Not for separate elements, which have no finer line, and where no small number divides the
  /// nodes. Call it before the first step.
  void estimateErrors(const Scene& scene);

  /// Starts records of the elements in its march.
  void record(MarchRecords wanted);

  const Motion& motion() const { return motion_; }
  const TimeMarch& march() const { return march_; }
  double time() const { return time_; }
  std::uint64_t steps() const { return steps_; }
  bool isOver() const { return time_ >= motion_.duration(); }

  /// Marches at least one step, and on while whole steps end by that time (s), or exactly to the
  /// motion's jump and end; returns the means on the way.
  TransientSample marchTo(double time);

  /// Marches one step.
  TransientSample singleStep();

 private:
  class Means;
  struct Coarser;

  double stepAt(double time) const;
  double markAfter(double time) const;
  double estimateSteps() const;
  bool endsAtMark(double dt) const;
  double timeAfter(double dt);
  void stepOnce(double dt, Means& means);
  void addCoarser(const Scene& scene, std::size_t every, std::size_t offsets);
  void follow(Coarser& coarser, double before) const;
  void addError(TransientSample& sample);

  Load load_;
  Interface interface_;
  double temperatureShift_;  // a_T
  bool hasInterface_, startsAtRest_;
  Motion motion_;
  double longestStep_;  // s
  int division_;
  std::shared_ptr<const RigidLine> rigid_;
  TimeMarch march_;
  MarchStep last_;
  double relaxation_;  // s, for Kelvin elements; NaN for others
  double time_ = 0;
  /// Consecutive equal steps: their number, their length (s) and their beginning (s).
  double run_ = 0, runStep_ = 0, runBegin_ = 0;
  std::uint64_t steps_ = 0;
  std::vector<Coarser> coarser_;  // empty where errors are not estimated
  double errorFactor_ = 1;        // from the differences to the error that holds
};

/// A march on a coarser line, and how its friction differs from that of the finer one.
struct Transient::Coarser {
  Transient march;
  double weight = 1;                       // of the difference in the sum of squares
  double tangential = 0, normal = 0;       // N s, of the finer march since this one's last step
  double difference = 0, time = 0;         // of mu times s, and s, since the last sample
  double lastDifference = kNotApplicable;  // mean between the last two samples
};

/// Returns the root mean square of the errors of the newest of these samples; NaN where none is
/// known.
double recentError(const std::vector<TransientSample>& samples);

/// A motion as it is played: its march, the samples of its diagram, and states from which it goes
/// on after a jump in time.
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
