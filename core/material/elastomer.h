// An elastomer as plain values: springs and dashpots of its elements, and how temperature shifts
// their relaxation times. The member initialisers are the only source of defaults. All values are
// SI.
#pragma once

#include <vector>

namespace asperity {

enum class Rheology { Elastic, Kelvin, StandardSolid, Prony };

/// A Maxwell arm: a spring and a dashpot in series.
struct Arm {
  double modulus = 1e7;          // Pa, G_i
  double relaxationTime = 1e-3;  // s, tau_i

  bool operator==(const Arm&) const = default;
};

/// Williams, Landel and Ferry: log10 a_T = -c1 (T - T_r) / (c2 + T - T_r). The defaults hold for
/// many polymers where T_r lies about 50 K above the glass transition (Williams et al. 1955).
struct TemperatureShift {
  double c1 = 8.86;
  double c2 = 101.6;                     // K
  double referenceTemperature = 298.15;  // K, T_r: where the relaxation times are as given

  bool operator==(const TemperatureShift&) const = default;
};

struct Elastomer {
  Rheology rheology = Rheology::Kelvin;
  double shearModulus = 1e7;        // Pa, G, of elastic and Kelvin
  double relaxationTime = 1e-3;     // s, tau = eta / G, of Kelvin
  double equilibriumModulus = 1e7;  // Pa, G_inf, of standard solid and Prony series
  double viscosity = 0;             // Pa s, eta, of a dashpot beside the arms of a Prony series
  std::vector<Arm> arms = std::vector<Arm>(1);  // of standard solid (one) and Prony series
  double temperature = 298.15;                  // K
  TemperatureShift shift;

  bool operator==(const Elastomer&) const = default;
};

}  // namespace asperity
