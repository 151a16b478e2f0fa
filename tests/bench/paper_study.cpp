#include "tests/bench/paper_study.h"

#include <cmath>
#include <stdexcept>
#include <vector>

#include "core/contact/line_sweep.h"
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
    const double force = base_.load.normalForce;
    current_ = 0;
    makeLine(base_);
    simulate(logarithmic(1e-3, 1e2, kValues));
    // mu depends on F_N / G, and in units of the rms slope on F_N / (G h): other moduli and rms
    // heights are other forces on the same line, ascending.
    current_ = 1;
    simulate(forcesLike(force * base_.elastomer.shearModulus, logarithmic(1e9, 1e3, kValues)));
    current_ = 2;
    simulate(forcesLike(force * base_.surface.rmsHeight, logarithmic(1e-5, 1e-9, kValues)));
    current_ = 3;
    for (const double spacing : logarithmic(1e-7, 1e-5, kValues)) {
      Scene scene = base_;
      scene.surface.elements = roundNumber(scene.surface.length / spacing);
      makeLine(scene);
      simulate({force});
    }
  }

  static std::vector<double> forcesLike(double product, std::vector<double> values) {
    for (double& value : values) value = product / value;
    return values;
  }

  /// The even number with no prime factor above 7 that is next to `wanted`, as anybody would choose
  /// who has the choice: transforms of other lengths take several times as long.
  static std::int64_t roundNumber(double wanted) {
    const auto isRound = [](std::int64_t n) {
      for (const int factor : {2, 3, 5, 7})
        while (n % factor == 0) n /= factor;
      return n == 1;
    };
    const std::int64_t middle = 2 * std::llround(wanted / 2);
    for (std::int64_t away = 0;; away += 2)
      for (const std::int64_t n : {middle - away, middle + away})
        if (isRound(n)) return n;
  }

  /// Amplitudes and transform plans serve all 200 lines of a set, so they are not timed; nor is the
  /// line before, which is there for its depths.
  void makeLine(const Scene& scene) {
    const LineSource source(scene, scene.accuracy.oversampling);
    makeLine(source, scene.accuracy.scheme, 1, another_);
    const double start = threadSeconds();
    makeLine(source, scene.accuracy.scheme, 0, line_);
    now().lineSeconds += weight_ * (threadSeconds() - start);
    now().lines += weight_;
  }

  void makeLine(const LineSource& source, Scheme scheme, std::int64_t realization,
                PreparedProfile& line) {
    source.makeInto(points_, realization,
                    scheme == Scheme::Linear ? Slopes::Omitted : Slopes::Computed);
    prepareProfileInto(line, points_, scheme);
  }

  void simulate(const std::vector<double>& forces) {
    results_.resize(forces.size() * velocities_.size());
    others_.resize(results_.size());
    const SlidingConditions conditions = slidingConditions(base_, 0);
    slideAtForces(another_, conditions, forces, velocities_, others_);
    const double start = threadSeconds();
    slideAtForces(line_, conditions, forces, velocities_, results_, {}, others_);
    now().simulationSeconds += weight_ * (threadSeconds() - start);
    now().simulations += weight_ * static_cast<double>(results_.size());
    for (const SteadyResult& result : results_) {
      if (result.status != SteadyStatus::Balanced)
        throw std::runtime_error("a force balance of the study is not met");
      estimate_.sampled += 1;
      estimate_.elements +=
          static_cast<double>(points_.nodes()) / static_cast<double>(base_.accuracy.oversampling);
      estimate_.contactFraction += result.contactFraction;
      estimate_.passes += result.passes;
    }
  }

  StudySeries& now() { return estimate_.series[current_]; }

  Scene base_;
  std::vector<double> velocities_;
  std::vector<SteadyResult> results_, others_;
  double weight_;
  Line points_;
  PreparedProfile line_, another_;
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
