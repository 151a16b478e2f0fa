// Fits a Prony series to a master curve: G(t) = G_inf + sum G_i exp(-t / tau_i), so that G'(w) =
// G_inf + sum G_i (w tau_i)^2 / (1 + (w tau_i)^2) and G''(w) = sum G_i w tau_i / (1 + (w tau_i)^2)
// with w = 2 pi f (Ferry, ch. 3). Pure functions; any thread.
#pragma once

#include <span>
#include <stop_token>
#include <vector>

#include "core/base/statistics.h"
#include "core/material/elastomer.h"
#include "core/material/isotherms.h"

namespace asperity {

struct PronyOptions {
  int terms = 0;          // relaxation times; 0: as few as reach the residual floor
  bool isLiquid = false;  // whether there may be no equilibrium modulus
  /// Pa, where it is known from elsewhere; NaN: fitted.
  double equilibriumModulus = kNaN;
  std::stop_token stop{};  // checked between two numbers of terms
};

struct PronySeries {
  double equilibriumModulus = 0;  // Pa, G_inf
  std::vector<Arm> arms;          // falling relaxation times, moduli above 0
  int terms = 0;                  // relaxation times that the arms were chosen from
  double decadesBelow = 0;        // from 1 / w_max down to the shortest of these times
  double rmsStorage = 0;          // rms of G'/G'_measured - 1
  double rmsLoss = 0;             // rms of G''/G''_measured - 1
};

/// Fits the series by non-negative least squares (Lawson and Hanson 1974) of G'/G'_measured - 1 and
/// G''/G''_measured - 1, all with equal weight. The relaxation times are evenly spaced in their
/// logarithm, from half a decade below 1 / w_max to half a decade above 1 / w_min; where their
/// number is chosen and the residual is above 3 %, from two decades below 1 / w_max if that halves
/// it. Terms with modulus 0 are left out. Throws InputError where there are too few points, and
/// where the equilibrium modulus would be 0, or so small that the moduli do not tell it from 0,
/// unless the options allow it. Throws StopRequested where `stop` was requested.
PronySeries fitPronySeries(std::span<const DynamicModulus> points, const PronyOptions& options);

/// Returns G' and G'' of the series at a frequency (Hz).
DynamicModulus modulusAt(const PronySeries& series, double frequency);

/// The largest number of relaxation times of a series, fitted or read.
inline constexpr int kMaxTerms = 64;

}  // namespace asperity
