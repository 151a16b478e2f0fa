// Elements with arms against their closed forms (standard solid, Prony series), and against the
// integral over the spectrum in complete contact.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/contact/steady_solver.h"
#include "core/material/element_law.h"
#include "core/material/temperature_shift.h"
#include "core/surface/line.h"
#include "tests/core/contact/instruction_sets.h"
#include "tests/core/contact/lines.h"
#include "tests/core/elastomers.h"

namespace asperity {
namespace {

class Arms : public EachInstructionSet {};

SteadyState slide(const Elastomer& elastomer, const PreparedProfile& line, double velocity,
                  const Load& load) {
  Scene scene;
  scene.elastomer = elastomer;
  scene.load = load;
  scene.accuracy.scheme = line.scheme;
  return SteadySolver(scene).at(line, velocity);
}

Load force(double newton) {
  return {LoadKind::Force, newton, 0};
}
Load indentation(double metre) {
  return {LoadKind::Indentation, 0, metre};
}

/// Wedge z = t |x| on a standard solid; b, where contact ends, from p(-b) = 0.
TEST_P(Arms, ZenerWedgeIsExactWhateverTheGrid) {
  const double t = 1e-3, d = 2e-6, a = d / t, g = 1e6, g1 = 4e6, tau = 1e-3;
  for (const double ratio : {0.01, 0.1, 0.5, 1.0, 5.0})
    for (const std::size_t nodes : {64UL, 1000UL}) {
      const double c = ratio * a, rise = 2 - std::exp(-a / c);
      double low = 0, high = a;
      for (int i = 0; i < 200; ++i) {
        const double b = 0.5 * (low + high);
        (g * (a - b) + g1 * c * (-1 + rise * std::exp(-b / c)) > 0 ? low : high) = b;
      }
      const double b = 0.5 * (low + high);
      const double lead = g * a * a / 2 + g1 * c * (a - c * (1 - std::exp(-a / c)));
      const double trail =
          g * (a * b - b * b / 2) + g1 * c * (-b + rise * c * (1 - std::exp(-b / c)));
      const PreparedProfile line =
          prepareProfile(wedgeLine(3 * a + 300 * c, nodes, t), Scheme::Linear);
      const SteadyResult result =
          slide(standardSolid(g, {g1, tau}), line, c / tau, indentation(d)).result;
      EXPECT_LT(relativeError(result.normalForce, 4 * t * (lead + trail)), 1e-10) << ratio;
      EXPECT_LT(relativeError(result.tangentialForce, 4 * t * t * (lead - trail)), 1e-9) << ratio;
      EXPECT_LT(relativeError(result.forceFromPressure, result.normalForce), 1e-10);
    }
}

/// A load that one summit carries, with a depth down to that of an atom, is met, too, at any
/// velocity and without an answer nearby.
TEST_P(Arms, BalancesAtVanishingLoads) {
  Scene scene;
  scene.surface.elements = 2000;
  const PreparedProfile line = prepareProfile(LineSource(scene, 8).make(0), Scheme::Cubic);
  for (const auto& [name, elastomer] : allElastomers()) {
    if (elementLaw(elastomer).equilibriumModulus == 0) continue;
    for (const double velocity : {1e-6, 1e-3, 1.0, 1e3})
      for (const double newton : {1e-6, 1e-8, 1e-9, 1e-10}) {
        const SteadyResult result = slide(elastomer, line, velocity, force(newton)).result;
        EXPECT_LT(result.residual, 1e-9) << name << " " << velocity << " " << newton;
        EXPECT_LT(relativeError(result.normalForce, newton), 1e-9) << name << " " << velocity;
        EXPECT_GT(result.contactFraction, 0) << name << " " << velocity << " " << newton;
      }
  }
}

/// F_x = 8 L integral C(q) q G''(q v) dq; of the modes: 2 L sum a_k^2 q_k G''.
TEST_P(Arms, FullContactOfEveryRheologyIsTheIntegralOverTheSpectrum) {
  Scene scene;
  scene.surface.elements = 500;
  const LineSource source(scene, 8);
  const FourierLine modes = source.spectrum(0);
  const PreparedProfile line = prepareProfile(source.make(0), Scheme::Cubic);
  for (const auto& [name, elastomer] : allElastomers())
    for (const double velocity : {1e-3, 0.03, 1.0}) {
      const ElementLaw law = elementLaw(elastomer);
      const double normal = 4 * law.equilibriumModulus * line.length * 1e-3;
      const SteadyResult result = slide(elastomer, line, velocity, force(normal)).result;
      double exact = 0;
      for (std::size_t k = 0; k < modes.coefficients.size(); ++k) {
        const double q = 2 * std::numbers::pi * static_cast<double>(k + 1) / line.length;
        exact += 8 * line.length * std::norm(modes.coefficients[k]) * q *
                 complexModulus(law, q * velocity).loss;
      }
      EXPECT_EQ(result.status, SteadyStatus::Balanced) << name;
      EXPECT_NEAR(result.contactFraction, 1, 1e-12);
      if (exact > 0) {
        EXPECT_LT(relativeError(result.tangentialForce, exact), 1e-3) << name << " " << velocity;
      } else {
        EXPECT_LT(result.mu, 1e-14) << name;
      }
      EXPECT_LT(relativeError(result.indentation - line.meanHeight, 1e-3), 1e-9) << name;
    }
}

/// One sine in complete contact: F_x / L has its maximum A^2 q G_1 at q v tau = 1.
TEST_P(Arms, ZenerSinePeaksWhereOneRadianTakesTheRelaxationTime) {
  const double amplitude = 5e-7, length = 0.01, q = 2 * std::numbers::pi * 4 / length, tau = 1e-3;
  const PreparedProfile line = prepareProfile(sineLine(length, 2000, amplitude, 4), Scheme::Cubic);
  const Elastomer solid = standardSolid(1e6, {3e6, tau});
  const auto friction = [&](double turn) {
    return slide(solid, line, turn / (q * tau), indentation(1e-5)).result.tangentialForce / length;
  };
  EXPECT_LT(relativeError(friction(1), amplitude * amplitude * q * 3e6), 1e-6);
  EXPECT_GT(friction(1), friction(0.99));
  EXPECT_GT(friction(1), friction(1.01));
}

/// Arms so fast that they are a dashpot, and so slow that they are a spring.
TEST_P(Arms, TendToKelvinAndToElastic) {
  const PreparedProfile line = prepareProfile(roughLine(300, 2), Scheme::Cubic);
  const double v = 0.5;
  const SteadyResult kelvin = slideAtForce(line, {1e7, 1e-3, v}, 0.02);
  const SteadyResult fast =
      slide(prony(1e7, {{1e7 * 1e-3 / 1e-9, 1e-9}}), line, v, force(0.02)).result;
  EXPECT_LT(relativeError(fast.mu, kelvin.mu), 1e-3);
  EXPECT_LT(relativeError(fast.indentation, kelvin.indentation), 1e-3);
  const SteadyResult soft = slide(prony(1e7, {{1e-3, 1}}), line, v, force(0.02)).result;
  const SteadyResult elastic = slideAtForce(line, {1e7, 0, v}, 0.02);
  EXPECT_LT(relativeError(soft.indentation, elastic.indentation), 1e-9);
}

/// Arms a million times stiffer than the equilibrium, loads from light to heavy: strains far below
/// depths keep their digits, and what is not balanced says so.
TEST_P(Arms, AMillionTimesStifferThanTheEquilibriumStillBalance) {
  const PreparedProfile line = prepareProfile(roughLine(47, 1), Scheme::Linear);
  for (const auto& elastomer :
       {standardSolid(1e3, {1e9, 1e-3}), prony(1e3, {{1e9, 1e-2}, {1e6, 1e-4}, {3e8, 1e-6}})})
    for (const double normal : {1e-9, 1e-7, 1e-5, 1e-3, 0.1})
      for (const double velocity : {1e-6, 1e-3, 0.1, 10.0, 1e3}) {
        SCOPED_TRACE(testing::Message() << normal << " N, " << velocity << " m/s");
        const SteadyResult result = slide(elastomer, line, velocity, force(normal)).result;
        EXPECT_EQ(result.status, SteadyStatus::Balanced) << result.residual;
        EXPECT_LT(relativeError(result.forceFromPressure, result.forceFromDepth), 2e-7);
        EXPECT_LT(relativeError(result.powerIn, result.powerDissipated), 2e-7);
        EXPECT_GT(result.mu, 0);
      }
}

/// Friction so small that it would be lost in what springs store and give back.
TEST_P(Arms, SlowAndFastArmsKeepTheirDigits) {
  const PreparedProfile line = prepareProfile(roughLine(100, 2), Scheme::Cubic);
  // All in contact, G'' of an arm falls as 1 / (q v tau) and as q v tau.
  const auto friction = [&](double tau) {
    return slide(standardSolid(1e7, {1e7, tau}), line, 1, force(1e4)).result.tangentialForce;
  };
  EXPECT_LT(relativeError(friction(1e6) * 1e6, friction(1e3) * 1e3), 1e-6);
  EXPECT_LT(relativeError(friction(1e9) * 1e9, friction(1e6) * 1e6), 1e-9);
  EXPECT_LT(relativeError(friction(1e-9) / 1e-9, friction(1e-12) / 1e-12), 1e-6);
}

/// Why steady sliding needs an equilibrium: F_N = 4G integral of y, whatever arms and dashpot are.
TEST_P(Arms, WithoutAnEquilibriumNothingIsCarried) {
  const PreparedProfile line = prepareProfile(roughLine(200, 2), Scheme::Cubic);
  double last = 0;
  for (const double g : {1e6, 1e4, 1e2, 1.0}) {
    const Elastomer elastomer = prony(g, {{1e7, 1e-2}, {1e7, 1e-4}}, 10);
    const SteadyResult pressed = slide(elastomer, line, 1, force(0.02)).result;
    EXPECT_EQ(pressed.status, SteadyStatus::Balanced);
    EXPECT_GE(pressed.indentation, 0.02 / (4 * g * line.length));  // without bound as G falls
    const SteadyResult held = slide(elastomer, line, 1, indentation(1e-6)).result;
    EXPECT_EQ(held.status, SteadyStatus::Balanced);
    EXPECT_LE(held.normalForce, 4 * g * line.length * 1e-6);  // nothing as G falls
    if (last > 0) {
      EXPECT_LT(held.normalForce, 0.05 * last);
    }
    last = held.normalForce;
  }
}

/// Many arms that together are one, and arms without strength.
TEST_P(Arms, OfNoStrengthChangeNothing) {
  const PreparedProfile line = prepareProfile(roughLine(300, 2), Scheme::Cubic);
  const SteadyResult one = slide(prony(1e6, {{5e6, 1e-3}}), line, 0.3, force(0.02)).result;
  const SteadyResult split =
      slide(prony(1e6, {{2e6, 1e-3}, {0, 7}, {3e6, 1e-3}, {1e6, 0}}), line, 0.3, force(0.02))
          .result;
  EXPECT_EQ(one.mu, split.mu);
  EXPECT_EQ(one.indentation, split.indentation);
  const SteadyResult none = slide(prony(1e7, {{0, 1e-3}}), line, 0.3, force(0.02)).result;
  EXPECT_EQ(none.indentation, slideAtForce(line, {1e7, 0, 0.3}, 0.02).indentation);
  const SteadyResult dashpot =
      slide(prony(1e7, {{0, 1e-3}}, 1e7 * 1e-3), line, 0.3, force(0.02)).result;
  EXPECT_LT(relativeError(dashpot.mu, slideAtForce(line, {1e7, 1e-3, 0.3}, 0.02).mu), 1e-12);
}

/// mu(v, T) = mu(v a_T, T_r).
TEST_P(Arms, TemperatureIsVelocity) {
  const PreparedProfile line = prepareProfile(roughLine(300, 2), Scheme::Cubic);
  for (const auto& [name, reference] : allElastomers()) {
    if (reference.rheology == Rheology::Elastic) continue;
    Elastomer shifted = reference;
    shifted.temperature = 310;
    const double a = shiftFactor(shifted.shift, 310), v = 0.2;
    const SteadyResult one = slide(shifted, line, v, force(0.02)).result;
    const SteadyResult other = slide(reference, line, v * a, force(0.02)).result;
    EXPECT_LT(relativeError(one.mu, other.mu), 1e-12) << name;
  }
}

/// What is repeated by hand needs L / (v tau) times as long to close.
TEST_P(Arms, AnArmOfAHundredSecondsTakesAFewPasses) {
  const PreparedProfile line = prepareProfile(roughLine(1000, 2), Scheme::Cubic);
  for (const double newton : {0.0034, 0.1, 10.0}) {
    const SteadyState state = slide(treadCompound(), line, 1, force(newton));
    EXPECT_EQ(state.result.status, SteadyStatus::Balanced);
    EXPECT_LE(state.result.passes, 16) << newton;
    EXPECT_LT(state.result.periodicityError, 1e-10);
    EXPECT_LT(relativeError(state.result.forceFromPressure, state.result.normalForce), 1e-9);
    EXPECT_LT(relativeError(state.result.powerIn, state.result.powerDissipated), 1e-9);
  }
}

/// u <= z - d and p >= 0, and never both strict, at every node; friction is what is dissipated.
TEST_P(Arms, PressureAndGapExcludeEachOther) {
  const Line rough = roughLine(400, 2);
  const PreparedProfile line = prepareProfile(rough, Scheme::Cubic);
  for (const auto& [name, elastomer] : allElastomers())
    for (const double velocity : {1e-3, 0.1, 10.0}) {
      Scene scene;
      scene.elastomer = elastomer;
      scene.load = force(0.02);
      const SteadySolver sliding(scene);
      const SteadyState state = sliding.at(line, velocity);
      const SteadyShape shape = sliding.shape(line, velocity, state);
      const double d = state.result.indentation;
      EXPECT_EQ(state.result.status, SteadyStatus::Balanced);
      const double lost = state.result.powerDissipated;
      EXPECT_NEAR(state.result.powerIn, lost, 1e-8 * lost + 1e-15 * 0.02 * velocity) << name;
      for (std::size_t i = 0; i < line.segments(); ++i) {
        const double gap = shape.nodes.depth[i] - (d - line.heightAboveMinimum[i]);
        EXPECT_GE(gap, -1e-12 * d);
        EXPECT_GE(shape.nodes.pressure[i], 0);
        if (gap > 1e-9 * d) {
          EXPECT_EQ(shape.nodes.pressure[i], 0);
        }
      }
    }
}

/// Rougher summits: the rms slope in contact falls with growing depth; rougher valleys: it rises.
TEST_P(Arms, SummitCorrelationReversesTheTrendOfTheSlopeInContact) {
  for (const double kappa : {-0.9, 0.9}) {
    double light = 0, heavy = 0;
    for (int realization = 0; realization < 8; ++realization) {
      Scene scene;
      scene.surface.elements = 1000;
      scene.surface.summitCorrelation = kappa;
      const PreparedProfile line =
          prepareProfile(LineSource(scene, 2).make(realization), Scheme::Cubic);
      light += slideAtForce(line, {kModulus, kTau, 0.01}, 0.005).rmsSlopeContact;
      heavy += slideAtForce(line, {kModulus, kTau, 0.01}, 1).rmsSlopeContact;
    }
    if (kappa > 0) {
      EXPECT_GT(light / heavy, 1.05);
    } else {
      EXPECT_LT(light / heavy, 0.95);
    }
  }
}

/// Arms of any times and moduli, any velocity and load.
TEST_P(Arms, AnyElastomerBalances) {
  std::uint64_t state = 7;
  const auto uniform = [&state](double low, double high) {
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    return low + (high - low) * static_cast<double>(state >> 11) * 0x1p-53;
  };
  double passes = 0;
  for (int i = 0; i < 300; ++i) {
    const Line rough =
        roughLine(static_cast<std::int64_t>(uniform(20, 500)), 1 + i % 3, uniform(0.2, 1), i);
    const PreparedProfile line = prepareProfile(rough, i % 2 == 0 ? Scheme::Cubic : Scheme::Linear);
    std::vector<Arm> arms;
    for (int k = static_cast<int>(uniform(1, 14)); k > 0; --k)
      arms.push_back({std::pow(10, uniform(3, 9)), std::pow(10, uniform(-10, 3))});
    const double equilibrium = std::pow(10, uniform(5, 8));
    const Elastomer elastomer =
        prony(equilibrium, arms, i % 3 == 0 ? std::pow(10, uniform(-3, 5)) : 0);
    const double newton =
        equilibrium * line.length * line.rmsHeight * 4 * std::pow(10, uniform(-4, 1.5));
    const SteadyResult result =
        slide(elastomer, line, std::pow(10, uniform(-6, 3)), force(newton)).result;
    EXPECT_EQ(result.status, SteadyStatus::Balanced) << i;
    EXPECT_LT(result.residual, 1e-10) << i;
    passes += result.passes;
  }
  EXPECT_LT(passes / 300, 20);
}

/// Second order for straight, fourth for cubic segments, as with one relaxation time.
TEST_P(Arms, ConvergeAtTheOrderOfTheScheme) {
  const auto friction = [](std::int64_t oversampling, Scheme scheme) {
    return slide(prony(1e6, {{3e6, 1e-2}, {2e7, 1e-4}}),
                 prepareProfile(roughLine(128, oversampling), scheme), 0.3, force(0.1))
        .result.mu;
  };
  const double exact = friction(64, Scheme::Cubic);
  const auto order = [&](Scheme scheme) {
    return std::log2(relativeError(friction(2, scheme), exact) /
                     relativeError(friction(16, scheme), exact)) /
           3;
  };
  EXPECT_GT(order(Scheme::Linear), 1.7);
  EXPECT_GT(order(Scheme::Cubic), 3.4);
}

/// At light loads the contact of a single state is much smaller than an element and the distance in
/// which the arms relax: a neighbour's answer is not needed to find it.
TEST_P(Arms, ASingleStateUnderALightLoadIsFoundWithoutANeighbour) {
  for (const Scheme scheme : {Scheme::Linear, Scheme::Cubic})
    for (const SurfaceKind kind : {SurfaceKind::Parabola, SurfaceKind::SelfAffine})
      for (const double length : {0.1, 1.0})
        for (const double force : {1e-8, 1e-7, 1e-6})
          for (const double time : {1e-6, 1e-3, 0.4}) {
            Scene scene;
            scene.surface.kind = kind;
            scene.surface.length = length;
            scene.surface.elements = 64;
            scene.elastomer.rheology = Rheology::StandardSolid;
            scene.elastomer.equilibriumModulus = 1e7;
            scene.elastomer.arms = {{1e7, time}};
            scene.load.kind = LoadKind::Force;
            scene.load.normalForce = force;
            const SteadySolver solver(scene);
            const PreparedProfile line = prepareProfile(LineSource(scene, 4).make(0), scheme);
            for (const double velocity : {1e-4, 1e-2, 1.0, 10.0}) {
              const SteadyState state = solver.at(line, velocity);
              EXPECT_TRUE(state.arms.isMet())
                  << static_cast<int>(scheme) << " " << length << " m, " << force << " N, " << time
                  << " s, " << velocity << " m/s: " << state.result.residual;
            }
          }
}

}  // namespace

ASPERITY_ON_EACH_INSTRUCTION_SET(Arms);

}  // namespace asperity
