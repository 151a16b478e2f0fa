// The coefficients of elements with arms at one velocity, as a pass over a line needs them: the
// decay and the driving of strains over one segment, the creep of a free surface over blocks of
// segments, and the derivatives of the result of a pass with respect to its initial values. All
// quantities are lengths: moduli are relative to the equilibrium modulus, and times are the
// distances slid in them (m).
// ArmCoefficients are plain values, read by any thread; an ArmTangent belongs to one thread.
#pragma once

#include <array>
#include <vector>

#include "core/contact/arms/retardation.h"
#include "core/contact/kernels/decay_moments.h"
#include "core/material/element_law.h"

namespace asperity {

struct ArmCoefficients {
  /// law: with an equilibrium modulus and at least one arm; velocity > 0 (m/s); spacing of whole
  /// segments and period (m); levels of blocks of 4^k segments.
  ArmCoefficients(const ElementLaw& law, const RetardationModes& modes, double velocity,
                  double spacing, double period, std::size_t levels);

  std::size_t arms() const { return modulus.size(); }
  std::size_t modes() const { return rate.size(); }

  std::vector<double> modulus;  // g_i = G_i / G
  std::vector<double> inverse;  // 1/m, 1 / (v tau_i)
  double dashpot = 0;           // m, v eta / G
  double glassy = 1;            // 1 + sum g_i, of the springs alone

  // These belong to one whole segment with w' = (D_0 + D_1 u + D_2 u^2) / spacing.
  std::vector<double> kept;  // e_i(1) = kept_i e_i(0) + sum D_k driven_ki
  std::array<std::vector<double>, 3> driven;
  std::vector<double> lossRate;                // 1/m, g_i / (v tau_i)
  std::array<std::vector<double>, 3> moment;   // g_i integral of exp(-z u) u^k
  std::array<std::array<double, 3>, 3> own{};  // sum g_i integral of u^k (what u^l has driven)
  std::vector<LossForm> loss;                  // 1/c_i integral of e_i^2

  /// The number of slow arms, which come first and change little over a period. Their creep is
  /// summed separately, as q_i(1) - q_i(0) = creepKept_i e_i(0) + sum D_k creepDriven_ki.
  std::size_t slow = 0;
  std::vector<double> creepKept;
  std::array<std::vector<double>, 3> creepDriven;

  // These belong to the free surface, y = sum a_j exp(-rate_j s).
  std::vector<double> rate;                // 1/m
  std::vector<double> stiffness;           // of the springs that pull it back, per G
  std::vector<double> settled;             // a_j per depth where all arms have relaxed
  std::vector<std::vector<double>> decay;  // [level][mode], over a block
  std::vector<std::vector<double>> lost;   // 1 - decay
  const RetardationModes& conversion;
};

/// The derivatives of the result of a pass with respect to the indentation and to each arm's strain
/// at the lowest point. Strains decay in contact, amplitudes decay in free arcs, and the creep is
/// continuous through every event, so only the lengths between events are needed. The object refers
/// to the coefficients.
class ArmTangent {
 public:
  explicit ArmTangent(const ArmCoefficients& coefficients);

  /// Begins in contact at the lowest point.
  void begin();
  /// Ends a contact of this length (m).
  void leave(double length);
  /// Ends a free arc of this length (m) in contact.
  void enter(double length);
  /// Ends the period, in contact or free, with a last interval of this length (m).
  void finish(double length, bool touching);

  /// Returns the number of unknowns: 0 is the indentation, 1 + k the strain of arm k at the lowest
  /// point.
  std::size_t unknowns() const { return unknowns_; }
  /// Returns the derivative of the integral of y (m).
  double ofDepthIntegral(std::size_t unknown) const { return volume_[unknown]; }
  /// Returns the derivative of the creep of arm i over the period.
  double ofCreepChange(std::size_t i, std::size_t unknown) const {
    return change_[i * unknowns_ + unknown];
  }

 private:
  void contact(double length);
  void arc(double length);

  const ArmCoefficients& coefficients_;
  std::size_t unknowns_;
  std::vector<double> strain_;  // [arm][unknown], where contact began or begins
  std::vector<double> mode_;    // [mode][unknown], likewise of the arc
  std::vector<double> row_;
  std::vector<double> volume_, change_;
};

}  // namespace asperity
