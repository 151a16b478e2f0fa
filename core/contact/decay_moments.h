// Integrals of exponentials with powers over [0, 1], as internal variables need them: exact for
// any decay, from none to a jump. Pure functions.
#pragma once

#include <array>
#include <cmath>

namespace asperity {

/// For e' = D' - z e on u in [0, 1] with D'(u) = D_0 + D_1 u + D_2 u^2:
/// e(1) = kept e(0) + sum D_k driven_k.
struct DrivenDecay {
  double kept;                   // exp(-z)
  std::array<double, 3> driven;  // integral of exp(-(1 - u) z) u^k
};

inline constexpr double kSeriesBelow = 1.5;

/// sum over r of (-z)^r factor_0 ... factor_r.
template <class Ratio>
double decaySeries(double z, double first, const Ratio& ratio) {
  double term = first, sum = first;
  for (int r = 1; r < 60; ++r) {
    term *= -z * ratio(r);
    sum += term;
    if (std::abs(term) <= 1e-17 * std::abs(sum)) break;
  }
  return sum;
}

inline DrivenDecay drivenDecay(double z) {
  DrivenDecay decay{std::exp(-z), {}};
  if (z < kSeriesBelow) {
    // k! (-z)^r / (k + r + 1)!; downwards from k = 2, where the recurrence is stable.
    decay.driven[2] = decaySeries(z, 1.0 / 3, [](int r) { return 1.0 / (r + 3); });
    decay.driven[1] = 0.5 * (1 - z * decay.driven[2]);
    decay.driven[0] = 1 - z * decay.driven[1];
  } else {
    decay.driven[0] = (1 - decay.kept) / z;
    decay.driven[1] = (1 - decay.driven[0]) / z;
    decay.driven[2] = (1 - 2 * decay.driven[1]) / z;
  }
  return decay;
}

/// integral of exp(-z u) u^k, k = 0, 1, 2.
inline std::array<double, 3> decayMoments(double z) {
  if (z < kSeriesBelow) {
    std::array<double, 3> moments{};
    for (int k = 0; k < 3; ++k)
      moments[static_cast<std::size_t>(k)] = decaySeries(
          z, 1.0 / (k + 1), [k](int r) { return double(k + r) / (double(r) * (k + r + 1)); });
    return moments;
  }
  const double kept = std::exp(-z), zeroth = (1 - kept) / z, first = (zeroth - kept) / z;
  return {zeroth, first, (2 * first - kept) / z};
}

/// integral over u of u^k times what u^l has driven up to u: [k][l].
inline std::array<std::array<double, 3>, 3> drivenMoments(double z) {
  std::array<std::array<double, 3>, 3> moments{};
  const DrivenDecay decay = drivenDecay(z);
  for (std::size_t l = 0; l < 3; ++l)
    for (std::size_t k = 0; k < 3; ++k) {
      const double sum = static_cast<double>(k + l + 1);
      if (z < kSeriesBelow) {
        const double n = static_cast<double>(l);
        moments[k][l] = decaySeries(z, 1 / ((n + 1) * (sum + 1)), [n, sum](int r) {
          return (sum + r) / ((n + r + 1) * (sum + r + 1));
        });
      } else {
        const double below = k > 0 ? static_cast<double>(k) * moments[k - 1][l] : 0;
        moments[k][l] = (1 / sum - decay.driven[l] + below) / z;
      }
    }
  return moments;
}

}  // namespace asperity
