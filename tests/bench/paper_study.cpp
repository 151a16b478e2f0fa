#include "tests/bench/paper_study.h"

#include <cmath>
#include <memory>
#include <vector>

#include "core/contact/sweep.h"
#include "core/surface/line_source.h"
#include "tests/bench/machine.h"
#include "tests/bench/workload.h"

namespace asperity::bench {
namespace {

constexpr int kValues = 20, kHursts = 11, kRealizationsOfStudy = 200;

class Study {
 public:
  Study(Scheme scheme, std::int64_t oversampling, int hursts)
      : velocities_(logarithmic(1e-5, 1e3, kValues)),
        results_(velocities_.size()),
        weight_(static_cast<double>(kHursts) / hursts * kRealizationsOfStudy) {
    for (const char* varied : {"force", "modulus", "rms height", "spacing"})
      estimate_.series.push_back({varied});
    base_.accuracy.scheme = scheme;
    base_.accuracy.oversampling = oversampling;
    for (int i = 0; i < hursts; ++i) seriesOf(static_cast<double>(i) / (hursts - 1));
  }

  StudyEstimate estimate() {
    estimate_.elements /= estimate_.sampled;
    estimate_.contactFraction /= estimate_.sampled;
    estimate_.passes /= estimate_.sampled;
    return estimate_;
  }

 private:
  void seriesOf(double hurst) {
    base_.surface.hurst = hurst;
    current_ = 0;
    makeLine(base_);
    for (const double force : logarithmic(1e-3, 1e2, kValues)) {
      Scene scene = base_;
      scene.load.normalForce = force;
      simulate(scene);
    }
    current_ = 1;
    for (const double modulus : logarithmic(1e3, 1e9, kValues)) {
      Scene scene = base_;
      scene.elastomer.shearModulus = modulus;
      simulate(scene);
    }
    current_ = 2;
    for (const double height : logarithmic(1e-9, 1e-5, kValues)) {
      Scene scene = base_;
      scene.surface.rmsHeight = height;
      makeLine(scene);
      simulate(scene);
    }
    current_ = 3;
    for (const double spacing : logarithmic(1e-7, 1e-5, kValues)) {
      Scene scene = base_;
      scene.surface.elements = std::llround(scene.surface.length / spacing);
      makeLine(scene);
      simulate(scene);
    }
  }

  /// Amplitudes and transform plans serve all 200 lines of a set, so they are not timed.
  void makeLine(const Scene& scene) {
    const LineSource source(scene, scene.accuracy.oversampling);
    const double start = threadSeconds();
    const Scheme scheme = scene.accuracy.scheme;
    source.makeInto(points_, 0, scheme == Scheme::Linear ? Slopes::NotWanted : Slopes::Wanted);
    prepareTravelInto(line_, points_, scheme);
    now().lineSeconds += weight_ * (threadSeconds() - start);
    now().lines += weight_;
  }

  void simulate(const Scene& scene) {
    const double start = threadSeconds();
    slideSweep(line_, conditionsOf(scene, 0), scene.load, velocities_, results_);
    now().simulationSeconds += weight_ * (threadSeconds() - start);
    now().simulations += weight_ * static_cast<double>(results_.size());
    for (const SteadyResult& result : results_) {
      estimate_.sampled += 1;
      estimate_.elements += static_cast<double>(scene.surface.elements);
      estimate_.contactFraction += result.contactFraction;
      estimate_.passes += result.passes;
    }
  }

  StudySeries& now() { return estimate_.series[current_]; }

  Scene base_;
  std::vector<double> velocities_;
  std::vector<SteadyResult> results_;
  double weight_;
  Line points_;
  TravelLine line_;
  std::size_t current_ = 0;  // series
  StudyEstimate estimate_;
};

}  // namespace

StudySeries StudyEstimate::total() const {
  StudySeries sum{"all"};
  for (const StudySeries& part : series) {
    sum.lines += part.lines;
    sum.lineSeconds += part.lineSeconds;
    sum.simulations += part.simulations;
    sum.simulationSeconds += part.simulationSeconds;
  }
  return sum;
}

double StudyEstimate::secondsOn(int cores) const {
  const StudySeries all = total();
  return (all.lineSeconds + all.simulationSeconds) / cores;
}

StudyEstimate estimateStudy(Scheme scheme, std::int64_t oversampling, bool quick) {
  return Study(scheme, oversampling, quick ? 3 : kHursts).estimate();
}

}  // namespace asperity::bench
