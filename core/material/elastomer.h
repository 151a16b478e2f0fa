// An elastomer as plain values: springs and dashpots of its elements, and how temperature shifts
// their relaxation times. The member initialisers are the only source of defaults. All values are
// SI.
#pragma once

#include <string>
#include <vector>

namespace asperity {

enum class Rheology { Elastic, Kelvin, StandardSolid, Prony };

/// Returns whether an elastomer of this kind states arms.
constexpr bool hasArms(Rheology rheology) {
  return rheology == Rheology::StandardSolid || rheology == Rheology::Prony;
}

/// A Maxwell arm: a spring and a dashpot in series.
struct Arm {
  double modulus = 1e7;          // Pa, G_i
  double relaxationTime = 1e-3;  // s, tau_i

  bool operator==(const Arm&) const = default;
};

enum class ShiftKind { Wlf, Arrhenius, Table };

/// One row of a table of shifts.
struct ShiftPoint {
  double temperature = 298.15;  // K
  double log10Shift = 0;        // decades, log10 a_T

  bool operator==(const ShiftPoint&) const = default;
};

/// How temperature multiplies the relaxation times: a_T > 1 where they are longer.
/// Wlf (Williams, Landel and Ferry): log10 a_T = -c1 (T - T_r) / (c2 + T - T_r). The defaults hold
/// for many polymers where T_r lies about 50 K above the glass transition (Williams et al. 1955).
/// Arrhenius: ln a_T = E/R (1/T - 1/T_r). Table: linear in T between the rows.
struct TemperatureShift {
  double c1 = 8.86;
  double c2 = 101.6;                     // K
  double referenceTemperature = 298.15;  // K, T_r: where the relaxation times are as given
  ShiftKind kind = ShiftKind::Wlf;
  double activationEnergy = 1e5;                               // J/mol, E of Arrhenius
  std::vector<ShiftPoint> table = std::vector<ShiftPoint>(1);  // strictly rising temperatures

  bool operator==(const TemperatureShift&) const = default;
};

/// The range in which an elastomer was measured; results outside of it are extrapolated. 0: not
/// known.
struct MeasuredRange {
  double frequencyFrom = 0, frequencyTo = 0;      // Hz, at the temperature where a_T = 1
  double temperatureFrom = 0, temperatureTo = 0;  // K
  double strainAmplitude = 0;                     // of shear or elongation

  bool operator==(const MeasuredRange&) const = default;
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
  std::string material;    // a shipped name or a file, from which the values above come; or none
  MeasuredRange measured;  // of the Prony series

  bool operator==(const Elastomer&) const = default;
};

}  // namespace asperity
