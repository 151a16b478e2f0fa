#include "tests/bench/cancel.h"

#include <algorithm>
#include <chrono>
#include <stop_token>
#include <thread>

#include "core/friction/ensemble.h"
#include "tests/bench/line_store.h"

namespace asperity::bench {
namespace {

using Clock = std::chrono::steady_clock;

/// Asks at its moment after the first curve; seconds until the work is back.
double cancelAfter(const Scene& scene, std::chrono::microseconds moment) {
  std::stop_source source;
  std::jthread asking;
  Clock::time_point asked;
  CurveOptions options;
  options.threads = 2;
  options.stop = source.get_token();
  options.progress = [&](const CurveProgress& progress) {
    if (progress.realizationsDone > 1) return;
    asking = std::jthread([&] {
      std::this_thread::sleep_for(moment);
      asked = Clock::now();
      source.request_stop();
    });
  };
  frictionCurve(scene, options);
  const auto back = Clock::now();
  asking.join();
  return std::chrono::duration<double>(back - asked).count();
}

}  // namespace

double slowestCancel(std::int64_t elements, int tries) {
  Scene scene = sceneOf({elements, Scheme::Cubic, 2});
  scene.ensemble.realizations = 1000000;
  double slowest = 0;
  for (int i = 0; i < tries; ++i)
    slowest = std::max(slowest, cancelAfter(scene, std::chrono::microseconds(1000 + 1237 * i)));
  return slowest;
}

}  // namespace asperity::bench
