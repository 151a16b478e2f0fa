// Integrals of exponentials times powers over [0, 1], as internal variables need them: exact for
// any decay, from none to a jump. Pure functions.
#pragma once

#include <array>
#include <cmath>

namespace asperity {

/// The solution of e' = D' - z e on u in [0, 1] with D'(u) = D_0 + D_1 u + D_2 u^2: e(1) = kept
/// e(0) + sum D_k driven_k.
struct DrivenDecay {
  double kept;                   // exp(-z)
  std::array<double, 3> driven;  // integral of exp(-(1 - u) z) u^k
};

inline constexpr double kSeriesBelow = 1.5;

/// Returns the sum over r of (-z)^r factor_0 ... factor_r.
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
    // The series is k! (-z)^r / (k + r + 1)!; from k = 2 downwards the recurrence is stable.
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

/// Returns the integral of exp(-z u) u^k, k = 0, 1, 2.
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

/// Returns the integral over u of u^k times the part of the solution driven by u^l: [k][l].
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

/// z times the integral of e^2 over [0, 1], which is the loss of a dashpot, as a quadratic form in
/// e(0) and the D_k: ee e^2 + sum ed_k e D_k + sum over k <= l of dd_kl D_k D_l. Never less than 0.
struct LossForm {
  double ee = 0;
  std::array<double, 3> ed{};
  std::array<double, 6> dd{};  // 00 01 02 11 12 22

  double operator()(double e, double d0, double d1, double d2) const {
    return e * (ee * e + ed[0] * d0 + ed[1] * d1 + ed[2] * d2) +
           d0 * (dd[0] * d0 + dd[1] * d1 + dd[2] * d2) + d1 * (dd[3] * d1 + dd[4] * d2) +
           dd[5] * d2 * d2;
  }
};

/// Returns the form by Gauss's points where e hardly decays: input and stored energy nearly cancel
/// there.
inline LossForm lossOfSlow(double z) {
  constexpr std::array<double, 4> kNode{0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                        0.9602898564975363};
  constexpr std::array<double, 4> kWeight{0.3626837833783620, 0.3137066458778873,
                                          0.2223810344533745, 0.1012285362903763};
  LossForm form;
  for (std::size_t point = 0; point < 8; ++point) {
    const double node = point < 4 ? kNode[point] : -kNode[point - 4];
    const double u = 0.5 * (1 + node), weight = 0.5 * z * kWeight[point % 4];
    const DrivenDecay decay = drivenDecay(z * u);
    const std::array<double, 3> e{u * decay.driven[0], u * u * decay.driven[1],
                                  u * u * u * decay.driven[2]};
    form.ee += weight * decay.kept * decay.kept;
    for (std::size_t k = 0, n = 0; k < 3; ++k) {
      form.ed[k] += 2 * weight * decay.kept * e[k];
      for (std::size_t l = k; l < 3; ++l, ++n)
        form.dd[n] += (k == l ? 1 : 2) * weight * e[k] * e[l];
    }
  }
  return form;
}

inline LossForm lossForm(double z) {
  if (z < kSeriesBelow) return lossOfSlow(z);
  // The loss is the input minus the stored energy.
  const DrivenDecay decay = drivenDecay(z);
  const auto moments = decayMoments(z);
  const auto drivenBy = drivenMoments(z);
  LossForm form;
  form.ee = 0.5 * (1 - decay.kept * decay.kept);
  for (std::size_t k = 0, n = 0; k < 3; ++k) {
    form.ed[k] = moments[k] - decay.kept * decay.driven[k];
    for (std::size_t l = k; l < 3; ++l, ++n) {
      const double both = drivenBy[k][l] + drivenBy[l][k] - decay.driven[k] * decay.driven[l];
      form.dd[n] = k == l ? 0.5 * both : both;
    }
  }
  return form;
}

}  // namespace asperity
