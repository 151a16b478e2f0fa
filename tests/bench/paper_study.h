// What the paper's whole study would take: a stratified sample of it, scaled up.
//
// The paper varied one parameter at a time (20 forces 1e-3 to 1e2 N, 20 moduli 1e3 to 1e9 Pa, 20
// rms heights 1e-9 to 1e-5 m, 20 spacings 1e-5 to 1e-7 m), with 11 Hurst exponents 0 to 1 and 200
// lines each. With 20 velocities (1e-5 to 1e3 m/s) that makes 3.52 million simulations. The sample
// is one line of the 200 for every one of those 880 combinations, with all its velocities. As all
// but the first of 200, it comes after another one, whose depths it begins from. Lines are made
// where they differ: once for all forces, moduli and rms heights, which are forces in other units,
// and once for each spacing, of which the nearest is taken (within 1 %) that makes the number of
// elements a product of small primes. Threading: the main thread; one thread computes.
#pragma once

#include <vector>

#include "core/scene/scene.h"

namespace asperity::bench {

/// A part of the study, scaled up; seconds on one core.
struct StudySeries {
  const char* varied = "";
  double lines = 0, lineSeconds = 0;
  double simulations = 0, simulationSeconds = 0;
};

struct StudyEstimate {
  std::vector<StudySeries> series;
  double sampled = 0;          // simulations computed
  double elements = 0;         // mean per simulation
  double contactFraction = 0;  // mean over the simulations
  double passes = 0;           // mean per simulation
  /// All series together.
  StudySeries total() const;
  double secondsOn(int cores) const;
};

/// quick: three Hurst exponents stand for the eleven.
StudyEstimate estimateStudy(Scheme scheme, std::int64_t oversampling, bool quick);

}  // namespace asperity::bench
