// Elastomers that several tests use: one of every rheology.
#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/scene/scene.h"

namespace asperity {

inline Elastomer prony(double equilibrium, std::vector<Arm> arms, double viscosity = 0) {
  Elastomer elastomer;
  elastomer.rheology = Rheology::Prony;
  elastomer.equilibriumModulus = equilibrium;
  elastomer.viscosity = viscosity;
  elastomer.arms = std::move(arms);
  return elastomer;
}

inline Elastomer standardSolid(double equilibrium, Arm arm) {
  Elastomer elastomer = prony(equilibrium, {arm});
  elastomer.rheology = Rheology::StandardSolid;
  return elastomer;
}

/// A filled tread compound, one arm a decade from 100 s down to 1e-10 s, where its glassy side is
/// cut.
inline Elastomer treadCompound() {
  const double young[] = {1.17, 1.05, 1.30, 1.55, 2.35, 3.12, 4.68,
                          8.11, 14.8, 31.9, 76.4, 200,  500};
  std::vector<Arm> arms;
  for (int i = 0; i < 13; ++i) arms.push_back({young[i] * 1e6 / 3, std::pow(10.0, 2 - i)});
  return prony(4.57e6 / 3, std::move(arms));
}

inline std::vector<std::pair<std::string, Elastomer>> allElastomers() {
  Elastomer elastic;
  elastic.rheology = Rheology::Elastic;
  return {{"elastic", elastic},
          {"kelvin", Elastomer{}},
          {"standard solid", standardSolid(1e6, {4e6, 1e-3})},
          {"prony", prony(1e6, {{1e6, 1}, {4e6, 1e-2}, {2e7, 1e-5}})},
          {"prony with dashpot", prony(1e6, {{1e6, 1}, {4e6, 1e-2}}, 200)},
          {"tread compound", treadCompound()}};
}

}  // namespace asperity
