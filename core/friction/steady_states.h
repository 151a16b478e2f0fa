// Many steady states of one scene with other values, on common random lines: the work behind maps,
// sweeps of any parameter, sensitivities and fits. Each state is a whole scene, which slides at its
// `sliding.velocity`; they may differ in any key.
//
// The work is shared as far as the model allows. A line of random phases is h times a line of unit
// height, forces are G h, and time is counted in relaxation times: with z = h zeta(x), p = 4 G h
// pi(x) the state depends on F_N / (G h) and v tau alone, mu is in units of h. So modulus, rms
// height and force are one scaling of a line; temperature and relaxation time are velocities. With
// Maxwell arms the same holds for all moduli together and for all times together. States that
// differ only in these slide on the same lines, several in one kernel call, and equal ones once.
// Every result is that of the state's own friction curve at its velocity, to rounding.
//
// Threading: a function of its arguments, which uses several threads; the bytes are the same for
// any number of them. Failure: InputError for a state that cannot run; std::runtime_error where a
// balance is not met.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/friction/curve_point.h"
#include "core/scene/scene.h"

namespace asperity {

/// The options of everything that slides many states or lines. The last two are of slideStates.
struct StateOptions {
  int threads = 0;  // 0: as many as the machine has
  std::stop_token stop{};
  /// Called with the part of the work that is done, from one thread at a time; may be empty.
  std::function<void(double part)> progress{};
  bool keepsLines = false;  // whether `muOfLines` is wanted
  /// Called like `progress` with the lines slid of all and the states so far, averaged over the
  /// lines slid; a state without realizations is not yet known. May be empty.
  std::function<void(std::int64_t done, std::int64_t total, const std::vector<CurvePoint>& points)>
      partial{};
};

struct SteadyStates {
  std::vector<CurvePoint> points;  // one for each state, as rows of its own curve
  /// Friction of each line including that of the interface, [state][realization]; states whose
  /// lines do not differ have one.
  std::vector<std::vector<double>> muOfLines;
  std::vector<std::int64_t> orderedRows;  // LineSource::orderedRows() of each state's lines
  bool isComplete = true;                 // false: stopped, and the other members have no meaning
  std::size_t computed = 0;     // states that had to be slid; the others are equal to one of them
  double largestResidual = 0;   // of all force balances
  double marginalFraction = 0;  // nodal: part of the balances with a partly loaded element
};

/// Computes every state.
SteadyStates slideStates(std::span<const Scene> states, const StateOptions& options = {});

}  // namespace asperity
