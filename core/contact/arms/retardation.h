// The compliance form of an element with arms (retardation modes). Without contact the element
// creeps back as a sum of independent exponentials. Driven by p = 4 pi, each amplitude obeys a' =
// -rate a + fluidity pi, and y = glassyCompliance pi + sum a. Poles and zeros of the complex
// modulus are interlaced: Gross, Mathematical Structure of the Theories of Viscoelasticity (1953).
// The modes are computed once per law, whatever the velocity; plain values, read by any thread.
#pragma once

#include <vector>

#include "core/material/element_law.h"

namespace asperity {

struct RetardationModes {
  double glassyCompliance = 0;   // 1/Pa; 0 with a dashpot of its own
  std::vector<double> rate;      // 1/s, rising; 0 only without an equilibrium modulus
  std::vector<double> fluidity;  // 1/(Pa s)

  // From and to the arms: q_i = y - e_i is the creep of arm i, the strain of its dashpot. Row after
  // row, one row a mode; `arms` entries in each.
  std::size_t arms = 0;
  std::vector<double> ofDepth;  // a_j = ofDepth_j y + sum_i ofCreep_ji q_i
  std::vector<double> ofCreep;
  std::vector<double> toCreep;   // q_i = sum_j toCreep_ji a_j, free
  std::vector<double> toStrain;  // e_i = sum_j toStrain_ji a_j, free

  std::size_t modes() const { return rate.size(); }
};

/// Computes the modes to about 1e-14 for any spread of times and moduli.
RetardationModes retardationModes(const ElementLaw& law);

}  // namespace asperity
