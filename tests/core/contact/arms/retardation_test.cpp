// An element from its compliance, and the integrals of exponentials that passes are made of.
#include "core/contact/arms/retardation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "core/contact/kernels/decay_moments.h"
#include "tests/core/elastomers.h"

namespace asperity {
namespace {

/// J + sum fluidity / (rate + i w) is 1 / (G' + i G'') at every frequency.
TEST(Retardation, ComplianceIsTheInverseOfTheModulus) {
  std::vector<std::pair<std::string, Elastomer>> elastomers = allElastomers();
  elastomers.emplace_back("fluid", prony(0, {{1e6, 1}, {3e7, 1e-4}}));
  elastomers.emplace_back("weak beside strong", prony(1, {{1e-6, 1}, {1e12, 0.999999}, {5, 1e-9}}));
  elastomers.emplace_back("fluid with dashpot", prony(0, {{1e6, 1}}, 3));
  for (const auto& [name, elastomer] : elastomers) {
    const ElementLaw law = elementLaw(elastomer);
    const RetardationModes modes = retardationModes(law);
    EXPECT_EQ(modes.modes(), law.arms.size() + (law.viscosity > 0 ? 1 : 0)) << name;
    for (double frequency = 1e-6; frequency < 1e13; frequency *= 7) {
      const ComplexModulus modulus = complexModulus(law, frequency);
      std::complex<double> compliance = modes.glassyCompliance;
      for (std::size_t j = 0; j < modes.modes(); ++j)
        compliance += modes.fluidity[j] / std::complex<double>(modes.rate[j], frequency);
      const auto product = compliance * std::complex<double>(modulus.storage, modulus.loss);
      EXPECT_LT(std::abs(product - 1.0), 1e-11) << name << " " << frequency;
    }
  }
}

/// Rates lie between those of the arms: one below each, one above all with a dashpot.
TEST(Retardation, RatesAndArmsAlternate) {
  for (const auto& [name, elastomer] : allElastomers()) {
    const ElementLaw law = elementLaw(elastomer);
    if (law.arms.empty()) continue;
    const RetardationModes modes = retardationModes(law);
    for (std::size_t i = 0; i < law.arms.size(); ++i) {
      EXPECT_LT(modes.rate[i] * law.arms[i].relaxationTime, 1) << name;
      if (i + 1 < modes.modes()) {
        EXPECT_GT(modes.rate[i + 1] * law.arms[i].relaxationTime, 1) << name;
      }
    }
  }
}

/// The creep of arms, as amplitudes and back, wherever no pressure acts.
TEST(Retardation, AmplitudesAndCreepAreTheSameState) {
  for (const auto& [name, elastomer] : allElastomers()) {
    const ElementLaw law = elementLaw(elastomer);
    const std::size_t arms = law.arms.size();
    if (arms == 0) continue;
    const RetardationModes modes = retardationModes(law);
    std::vector<double> creep, back(arms), strain(arms);
    double weighted = 0;
    for (std::size_t i = 0; i < arms; ++i) {
      creep.push_back(1 + 0.3 * std::sin(1.0 + static_cast<double>(i)));
      weighted += law.arms[i].modulus * creep[i];
    }
    // Without a dashpot the depth follows from no pressure; with one it is free.
    const double depth = law.viscosity > 0 ? 0.7 : weighted / law.glassyModulus();
    double sum = 0;
    for (std::size_t j = 0; j < modes.modes(); ++j) {
      double amplitude = modes.ofDepth[j] * depth;
      for (std::size_t i = 0; i < arms; ++i) amplitude += modes.ofCreep[j * arms + i] * creep[i];
      sum += amplitude;
      for (std::size_t i = 0; i < arms; ++i) {
        back[i] += modes.toCreep[j * arms + i] * amplitude;
        strain[i] += modes.toStrain[j * arms + i] * amplitude;
      }
    }
    EXPECT_NEAR(sum, depth, 1e-11) << name;
    for (std::size_t i = 0; i < arms; ++i) {
      EXPECT_NEAR(back[i], creep[i], 1e-10) << name;
      EXPECT_NEAR(strain[i], depth - creep[i], 1e-10) << name;
    }
  }
}

/// Integral over [0, 1] by Gauss's five points on many pieces, which shrink towards both ends.
template <class Function>
double integral(const Function& function) {
  constexpr double place[] = {0, 0.5384693101056831, 0.906179845938664};
  constexpr double weight[] = {128.0 / 225, 0.4786286704993665, 0.2369268850561891};
  double sum = 0, from = 0;
  const auto piece = [&](double to) {
    const double half = 0.5 * (to - from), middle = 0.5 * (to + from);
    sum += half * weight[0] * function(middle);
    for (const int i : {1, 2})
      sum += half * weight[i] *
             (function(middle - half * place[i]) + function(middle + half * place[i]));
    from = to;
  };
  for (int k = 120; k > 0; --k) piece(0.5 * std::pow(0.85, k));
  for (int k = 0; k <= 120; ++k) piece(1 - 0.5 * std::pow(0.85, k));
  piece(1);
  return sum;
}

TEST(DecayMoments, AreTheIntegralsTheyStandFor) {
  for (const double z : {0.0, 1e-9, 0.01, 0.7, 1.4999, 1.5001, 4.0, 60.0, 1e5}) {
    const DrivenDecay decay = drivenDecay(z);
    const auto moments = decayMoments(z);
    const auto driven = drivenMoments(z);
    for (std::size_t k = 0; k < 3; ++k) {
      const double n = static_cast<double>(k);
      EXPECT_NEAR(decay.driven[k],
                  integral([&](double u) { return std::exp(-(1 - u) * z) * std::pow(u, n); }),
                  1e-10 * decay.driven[k] + 1e-15)
          << z;
      EXPECT_NEAR(moments[k], integral([&](double u) { return std::exp(-u * z) * std::pow(u, n); }),
                  1e-10 * moments[k] + 1e-15)
          << z;
      for (std::size_t l = 0; l < 3; ++l) {
        const double m = static_cast<double>(l);
        const double exact = integral(
            [&](double u) { return std::pow(u, n + m + 1) * drivenDecay(z * u).driven[l]; });
        EXPECT_NEAR(driven[k][l], exact, 1e-9 * exact + 1e-15) << z;
      }
    }
  }
}

}  // namespace
}  // namespace asperity
