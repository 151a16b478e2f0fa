// Whole curves of Fig. 2 as a slider asks for them, on two threads, lines included: 41 velocities,
// one realization (the first answer) and 200 of them. Wall-clock time.
#include "core/friction/ensemble.h"
#include "tests/bench/fields.h"
#include "tests/bench/line_store.h"
#include "tests/bench/workload.h"

namespace asperity::bench {
namespace {

void addCurve(const Resolution& resolution, std::int64_t realizations, int repetitions) {
  const auto prepare = [=]() -> Body {
    Scene scene = sceneOf({5000, resolution.scheme, resolution.oversampling});
    scene.ensemble.realizations = realizations;
    return [scene] {
      CurveOptions options;
      options.threads = 2;
      const Curve curve = frictionCurve(scene, options);
      return Tally{1, curve.meanPasses, 0};
    };
  };
  addCase(curveName(resolution.name, realizations), prepare, Clock::Wall, repetitions, 1e-3);
}

}  // namespace

void addCurveCases(bool quick) {
  for (const Resolution& resolution : kResolutions) {
    addCurve(resolution, 1, quick ? 5 : 15);
    addCurve(resolution, kRealizations, quick ? 1 : 5);
  }
}

}  // namespace asperity::bench
