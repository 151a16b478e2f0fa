// Fits of known scenes: parameters that made the data come back, with errors that cover them.
#include "core/fit/fit.h"
#include "core/base/stop.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "core/base/input_error.h"
#include "core/friction/ensemble.h"
#include "tests/core/small_scene.h"

namespace asperity {
namespace {

constexpr double kNoise = 0.03;

constexpr std::int64_t kElements = 250, kVelocities = 12;

/// Its mean over 1000 lines adds 1.6 % to the variance of one over 16.
Scene truth() {
  return sceneOfSize(kElements, kVelocities, 1000);
}

/// Friction of the scene's sweep on lines of other seeds than those that fits use.
std::vector<CurvePoint> exactFriction(Scene scene, double from, double to) {
  scene.surface.seed = 777;
  scene.sweep.velocityFrom = from;
  scene.sweep.velocityTo = to;
  return frictionCurve(scene, {}).points;
}

FrictionData noisy(const std::vector<CurvePoint>& points, std::uint32_t seed,
                   bool hasErrors = true) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal(0, kNoise);
  FrictionData data;
  for (const CurvePoint& point : points) {
    MeasuredPoint measured;
    measured.velocity = point.velocity;
    measured.mu = point.mu * (1 + normal(generator));
    if (hasErrors) measured.muError = kNoise * point.mu;
    measured.row = static_cast<int>(data.points.size()) + 2;
    data.points.push_back(measured);
  }
  return data;
}

Scene start(std::int64_t lines, std::int64_t seed) {
  Scene scene = sceneOfSize(kElements, kVelocities, lines);
  scene.surface.seed = seed;
  scene.surface.rmsHeight = 8e-7;
  scene.elastomer.shearModulus = 3e7;
  scene.elastomer.relaxationTime = 4e-4;
  return scene;
}

std::vector<VariedParameter> threeParameters(const Scene& scene) {
  return {{"surface.rms_height", scene},
          {"elastomer.shear_modulus", scene},
          {"elastomer.relaxation_time", scene}};
}

FitOptions withoutProfiles() {
  FitOptions options;
  options.hasProfiles = false;
  return options;
}

/// Fits of one kind of data many times over, with other noise and other lines each time.
struct Coverage {
  int repetitions = 0, height = 0, modulus = 0, time = 0, product = 0;
};

constexpr double kExponent = 0.45;  // of G beside tau, which regions I to III determine

Coverage coverage(double from, double to, int repetitions, double* errorOfModulus) {
  const std::vector<CurvePoint> exact = exactFriction(truth(), from, to);
  const Scene real = truth();
  Coverage within;
  for (int i = 0; i < repetitions; ++i) {
    const Scene scene = start(16, 1000 + i);
    const FrictionData data = noisy(exact, static_cast<std::uint32_t>(i));
    const Fit fit = fitFriction(scene, {&data, 1}, threeParameters(scene), withoutProfiles());
    const auto isWithin = [&](std::size_t k, double value) {
      const FittedParameter& parameter = fit.parameters[k];
      return std::abs(std::log(parameter.value / value)) <= 2 * parameter.standardError;
    };
    ++within.repetitions;
    within.height += isWithin(0, real.surface.rmsHeight);
    within.modulus += isWithin(1, real.elastomer.shearModulus);
    within.time += isWithin(2, real.elastomer.relaxationTime);
    const double error1 = fit.parameters[1].standardError, error2 = fit.parameters[2].standardError;
    const double variance = kExponent * kExponent * error1 * error1 + error2 * error2 +
                            2 * kExponent * error1 * error2 * fit.correlation(1, 2);
    const double off = kExponent * std::log(fit.parameters[1].value / real.elastomer.shearModulus) +
                       std::log(fit.parameters[2].value / real.elastomer.relaxationTime);
    within.product += std::abs(off) <= 2 * std::sqrt(variance);
    if (errorOfModulus) *errorOfModulus += error1 / repetitions;
  }
  return within;
}

/// Regions I to III: height and tau G^0.45 come back, G is left open.
TEST(Fit, RegionsOneToThreeDetermineTheHeightAndAProduct) {
  double errorOfModulus = 0;
  const Coverage within = coverage(1e-4, 0.3, 100, &errorOfModulus);
  EXPECT_GE(within.height, 88);
  EXPECT_LE(within.height, 99);
  EXPECT_GE(within.product, 88);
  EXPECT_LE(within.product, 99);
  EXPECT_GT(errorOfModulus, std::log(2.0));
}

/// Regions I to IV: all three come back.
TEST(Fit, RegionsOneToFourDetermineAllThree) {
  double errorOfModulus = 0;
  const Coverage within = coverage(1e-4, 1e3, 100, &errorOfModulus);
  for (const int count : {within.height, within.modulus, within.time}) {
    EXPECT_GE(count, 88);
    EXPECT_LE(count, 99);
  }
  EXPECT_LT(errorOfModulus, std::log(2.0));
}

/// Four lines know their scatter badly: of 200 fits, two standard errors hold 191 (95.4 %) where
/// they count that, by Student's distribution with three degrees of freedom, and 172 where they do
/// not. The standard deviation of these numbers is 3 and 5.
TEST(Fit, ErrorsOfFewLinesCountThatTheirScatterIsBadlyKnown) {
  constexpr int kFits = 200;
  constexpr std::int64_t kLines = 4;
  FrictionData data;
  for (const CurvePoint& point : exactFriction(truth(), 1e-4, 0.3)) {
    MeasuredPoint exact;
    exact.velocity = point.velocity;
    exact.mu = point.mu;
    exact.muError = 1e-3 * point.mu;
    data.points.push_back(exact);
  }
  int within = 0;
  for (int i = 0; i < kFits; ++i) {
    Scene scene = start(kLines, 5000 + i);
    scene.elastomer = truth().elastomer;
    const std::vector<VariedParameter> height{{"surface.rms_height", scene}};
    const Fit fit = fitFriction(scene, {&data, 1}, height, withoutProfiles());
    const FittedParameter& found = fit.parameters.front();
    within += std::abs(std::log(found.value / truth().surface.rmsHeight)) < 2 * found.standardError;
  }
  EXPECT_GE(within, 184);
  EXPECT_LE(within, 198);
}

TEST(Fit, NamesAPointThatMovesAllValues) {
  const Scene scene = start(16, 3);
  const std::vector<VariedParameter> height{{"surface.rms_height", scene}};
  const auto isNamed = [&](const FrictionData& data) {
    const Fit fit = fitFriction(scene, {&data, 1}, height, withoutProfiles());
    return std::ranges::any_of(fit.warnings, [](const Message& note) {
      return note.english().starts_with("one point makes");
    });
  };
  FrictionData data = noisy(exactFriction(truth(), 1e-4, 0.3), 5);
  EXPECT_FALSE(isNamed(data));
  data.points[data.points.size() / 2].mu *= 3;
  EXPECT_TRUE(isNamed(data));
  for (MeasuredPoint& point : data.points) point.muError = kNotApplicable;
  EXPECT_TRUE(isNamed(data));
}

TEST(Fit, SaysThatAParameterIsNotDetermined) {
  const FrictionData data = noisy(exactFriction(truth(), 1e-4, 0.3), 5);
  const Scene scene = start(50, 3);
  const Fit fit = fitFriction(scene, {&data, 1}, threeParameters(scene));
  EXPECT_TRUE(fit.parameters[0].isDetermined);
  EXPECT_FALSE(fit.parameters[1].isDetermined);
  EXPECT_FALSE(fit.missesPoints);
  bool isSaid = false;
  for (const Message& note : fit.warnings)
    isSaid |= note.english().starts_with(
        "elastomer.shear_modulus is not determined by these data: the standard error of its "
        "logarithm (ln) is ");
  EXPECT_TRUE(isSaid);
  // Its profile is flat where that of the height is steep.
  ASSERT_EQ(fit.profiles.size(), 3U);
  const auto rise = [](const ObjectiveProfile& profile) {
    const auto [low, high] = std::ranges::minmax(profile.chiSquared);
    return high - low;
  };
  EXPECT_GT(rise(fit.profiles[0]), 3);
  // The best determined combination is known to a few per cent.
  EXPECT_LT(fit.combinations.front().standardError, 0.05);
}

/// Errors of the points that do not hold, by a factor of 20, are scaled to what the fit leaves, as
/// if they had been given so: cov = (J'WJ)^-1 J'W (S_data + S_lines) WJ (J'WJ)^-1 with the S_data
/// of chi squared = degrees of freedom. Nothing is said before that.
TEST(Fit, ScalesErrorsThatDoNotHoldAndSaysSoFirst) {
  FrictionData data = noisy(exactFriction(truth(), 1e-4, 1e3), 5);
  data.notes.emplace_back("a note of the table");
  for (MeasuredPoint& point : data.points) point.muError /= 20;
  const Scene scene = start(100, 3);
  const Fit fit = fitFriction(scene, {&data, 1}, threeParameters(scene), withoutProfiles());
  EXPECT_TRUE(fit.missesPoints);
  EXPECT_TRUE(fit.hasFoundPoints);
  ASSERT_FALSE(fit.warnings.empty());
  ASSERT_FALSE(fit.notes.empty());
  EXPECT_TRUE(fit.notes.front().english().ends_with("a note of the table"));
  EXPECT_TRUE(fit.warnings.front().english().starts_with("the points lie further from the curve"));
  EXPECT_GT(fit.errorScale, 10);
  for (MeasuredPoint& point : data.points) point.muError *= fit.errorScale;
  const Fit given = fitFriction(scene, {&data, 1}, threeParameters(scene), withoutProfiles());
  EXPECT_FALSE(given.missesPoints);
  EXPECT_EQ(given.errorScale, 1);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(fit.parameters[k].standardError / given.parameters[k].standardError, 1, 1e-3);
}

/// No height makes friction fall over decades where it grows: values of such a fit say nothing.
TEST(Fit, SaysFirstThatItHasNotFoundThePoints) {
  FrictionData data = noisy(exactFriction(truth(), 1e-4, 0.3), 5);
  for (std::size_t i = 0; i < data.points.size() / 2; ++i)
    std::swap(data.points[i].mu, data.points[data.points.size() - 1 - i].mu);
  const Scene scene = start(20, 3);
  const Fit fit =
      fitFriction(scene, {&data, 1}, {{{"surface.rms_height", scene}}}, withoutProfiles());
  EXPECT_FALSE(fit.hasFoundPoints);
  EXPECT_TRUE(fit.warnings.front().english().starts_with("the fit has not found the points"));
}

/// ln mu is close to a sum of the parameters' logarithms: steps of logarithms lead to the one
/// minimum from values that are decades away.
TEST(Fit, FindsThePointsFromFarAway) {
  const FrictionData data = noisy(exactFriction(truth(), 1e-4, 1e3), 5);
  Scene scene = start(5, 3);
  const auto fitFrom = [&](double height, double time) {
    scene.surface.rmsHeight = height;
    scene.elastomer.relaxationTime = time;
    return fitFriction(scene, {&data, 1},
                       {{{"surface.rms_height", scene}, {"elastomer.relaxation_time", scene}}},
                       withoutProfiles());
  };
  const Fit near = fitFrom(5e-7, 1e-3);
  for (const auto& [height, time] :
       {std::pair{1e-8, 1e-4}, {1e-4, 1e-8}, {1e-9, 10.0}, {1e-6, 1e4}, {1e-9, 1e-7}}) {
    const Fit far = fitFrom(height, time);
    EXPECT_NEAR(far.chiSquared / near.chiSquared, 1, 1e-3) << height << " " << time;
    for (std::size_t k = 0; k < 2; ++k)
      EXPECT_NEAR(std::log(far.parameters[k].value / near.parameters[k].value), 0,
                  0.05 * near.parameters[k].standardError);
  }
}

/// The forces of the data are no parameter of the scene.
TEST(Fit, RefusesAParameterThatEachPointStates) {
  FrictionData data = noisy(exactFriction(truth(), 1e-4, 1e3), 5);
  for (MeasuredPoint& point : data.points) {
    point.normalForce = 0.0034;
    point.temperature = 298.15;
  }
  const Scene scene = start(5, 3);
  for (const char* key : {"load.normal_force", "elastomer.temperature", "sliding.velocity"}) try {
      fitFriction(scene, {&data, 1}, {{{"surface.rms_height", scene}, {key, scene}}});
      ADD_FAILURE() << key;
    } catch (const InputError& error) {
      EXPECT_EQ(error.key(), key);
    }
  // A pressure is stated in place of the force, which then means nothing.
  for (MeasuredPoint& point : data.points) {
    point.normalForce = kNotApplicable;
    point.nominalPressure = 8.5;
  }
  EXPECT_THROW(fitFriction(scene, {&data, 1}, {{{"load.normal_force", scene}}}), InputError);
}

/// d mu / d p = 0 where the point states p: value and error are those of the other points alone,
/// also where the stated value lies outside of the limits.
TEST(Fit, PointsThatStateAParameterSayNothingOfIt) {
  const FrictionData open = noisy(exactFriction(truth(), 1e-4, 1e3), 5);
  FrictionData stated = noisy(exactFriction(truth(), 1e-4, 1e3), 6);
  for (MeasuredPoint& point : stated.points) point.normalForce = 0.5;
  Scene scene = start(10, 3);
  scene.load.normalForce = 0.01;
  const std::vector<VariedParameter> force{{"load.normal_force", scene, 1e-4, 0.1}};
  const std::vector both{stated, open};
  const Fit alone = fitFriction(scene, {&open, 1}, force, withoutProfiles());
  const Fit fit = fitFriction(scene, both, force, withoutProfiles());
  EXPECT_TRUE(std::isfinite(fit.chiSquared));
  EXPECT_NEAR(std::log(fit.parameters[0].value / alone.parameters[0].value), 0,
              0.05 * alone.parameters[0].standardError);
  EXPECT_GT(fit.parameters[0].standardError, 0);
}

/// Beside points with errors others would have no weight, whatever they say.
TEST(Fit, RefusesTablesWithoutErrorsBesideSomeWith) {
  const std::vector<CurvePoint> exact = exactFriction(truth(), 1e-4, 1e3);
  const std::vector both{noisy(exact, 1), noisy(exact, 2, false)};
  const Scene scene = start(5, 3);
  EXPECT_THROW(fitFriction(scene, both, {{{"surface.rms_height", scene}}}), InputError);
}

/// The shift of a scene that states none is that of no rubber in particular.
TEST(Fit, SaysWhereTimesAreShiftedByGeneralConstants) {
  FrictionData data = noisy(exactFriction(truth(), 1e-4, 1e3), 5);
  Scene scene = start(5, 3);
  const auto isSaid = [&] {
    const Fit fit =
        fitFriction(scene, {&data, 1}, {{{"surface.rms_height", scene}}}, withoutProfiles());
    return std::ranges::any_of(fit.warnings, [](const Message& note) {
      return note.english().find("general WLF constants") != std::string::npos;
    });
  };
  EXPECT_FALSE(isSaid());
  for (MeasuredPoint& point : data.points) point.temperature = 278.15;
  EXPECT_TRUE(isSaid());
  scene.elastomer.shift.c1 = 4.41;
  EXPECT_FALSE(isSaid());
}

/// Friction depends on F_N / G alone: without loads in the data both are open, and their ratio is
/// what they determine.
/// A temperature that is fitted stays within the table of shifts, also where it begins at its end.
TEST(Fit, FindsATemperatureWithinItsTable) {
  Scene scene = sceneOfSize(kElements, kVelocities, 12);
  scene.sweep.velocityFrom = 1e-4;
  scene.sweep.velocityTo = 0.01;
  scene.elastomer.shift.kind = ShiftKind::Table;
  scene.elastomer.shift.table = {{280, 1.0}, {290, 0.5}, {300, 0.0}};
  scene.elastomer.temperature = 286;
  const FrictionData data = noisy(frictionCurve(scene, {}).points, 5);
  for (const double begin : {280.0, 290.0, 300.0}) {
    scene.elastomer.temperature = begin;
    const std::vector<VariedParameter> varied{{"elastomer.temperature", scene}};
    const Fit fit = fitFriction(scene, {&data, 1}, varied, withoutProfiles());
    EXPECT_NEAR(fit.parameters.front().value, 286, 1) << begin;
  }
}

TEST(Fit, SaysThatForceAndModulusAreDeterminedByTheirRatioAlone) {
  FrictionData data = noisy(exactFriction(truth(), 1e-4, 1e3), 5);
  for (MeasuredPoint& point : data.points) point.velocityError = kNotApplicable;
  const Scene scene = start(50, 3);
  const std::vector<VariedParameter> both{{"elastomer.shear_modulus", scene},
                                          {"load.normal_force", scene}};
  const Fit fit = fitFriction(scene, {&data, 1}, both, withoutProfiles());
  EXPECT_FALSE(fit.parameters[0].isDetermined);
  EXPECT_FALSE(fit.parameters[1].isDetermined);
  EXPECT_NEAR(fit.correlation(0, 1), 1, 1e-6);
  ASSERT_EQ(fit.combinations.size(), 2U);
  const std::vector<double>& exponents = fit.combinations.front().exponents;
  EXPECT_NEAR(exponents[1] / exponents[0], -1, 1e-3);
  EXPECT_LT(fit.combinations.front().standardError, 0.2);
  EXPECT_GT(fit.combinations.back().standardError, std::log(2.0));
}

/// Without errors in the table they are read from what the fit leaves.
TEST(Fit, ReadsTheScatterWhereNoErrorsAreGiven) {
  const FrictionData data = noisy(exactFriction(truth(), 1e-4, 1e3), 11, false);
  const Scene scene = start(100, 4);
  const Fit fit = fitFriction(scene, {&data, 1}, threeParameters(scene), withoutProfiles());
  EXPECT_NEAR(fit.relativeScatter / kNoise, 1, 0.6);
  EXPECT_NEAR(std::log(fit.parameters[0].value / 5e-7), 0, 3 * fit.parameters[0].standardError);
}

/// The scatter of few points about a fit is itself uncertain: two standard errors hold as often as
/// two of known errors only with Student's factor, here of three degrees of freedom.
TEST(Fit, EnlargesErrorsThatFewResidualsTell) {
  FrictionData data = noisy(exactFriction(truth(), 1e-4, 1e3), 11, false);
  data.points.resize(5);
  const Scene scene = start(1, 4);
  const std::vector<VariedParameter> varied{{"surface.rms_height", scene},
                                            {"elastomer.relaxation_time", scene}};
  const Fit fit = fitFriction(scene, {&data, 1}, varied, withoutProfiles());
  for (MeasuredPoint& point : data.points) point.muError = fit.relativeScatter * point.mu;
  const Fit known = fitFriction(scene, {&data, 1}, varied, withoutProfiles());
  constexpr double kFactor = 3.307 / 2;  // 95.45 % of Student's distribution, for 3
  for (std::size_t k = 0; k < varied.size(); ++k)
    EXPECT_NEAR(fit.parameters[k].standardError / known.parameters[k].standardError, kFactor, 1e-3);
}

/// Series over the force are fitted like series over the velocity.
TEST(Fit, ForceSeriesAreFittedToo) {
  FrictionData data;
  Scene real = truth();
  real.surface.seed = 777;
  std::vector<Scene> states;
  for (int i = 0; i < 12; ++i) {
    MeasuredPoint point;
    point.velocity = 0.01;
    point.normalForce = 1e-3 * std::pow(10, i / 3.0);
    data.points.push_back(point);
    states.push_back(sceneAtPoint(point, real));
  }
  const SteadyStates exact = slideStates(states);
  for (std::size_t i = 0; i < states.size(); ++i) {
    data.points[i].mu = exact.points[i].mu;
    data.points[i].muError = 0.01 * exact.points[i].mu;
  }
  Scene scene = start(100, 5);
  scene.elastomer.relaxationTime = 1e-3;
  const std::vector<VariedParameter> varied{{"surface.rms_height", scene},
                                            {"elastomer.shear_modulus", scene}};
  const Fit fit = fitFriction(scene, {&data, 1}, varied);
  EXPECT_NEAR(std::log(fit.parameters[0].value / 5e-7), 0, 3 * fit.parameters[0].standardError);
  EXPECT_NEAR(std::log(fit.parameters[1].value / 1e7), 0, 3 * fit.parameters[1].standardError);
  EXPECT_LT(fit.parameters[1].standardError, 0.2);
}

/// A nominal pressure is a force by a width; where the scene has none, the values depend on one
/// that nobody chose.
TEST(Fit, WarnsWhereANominalPressureHasNoWidth) {
  Scene scene = sceneOfSize(kElements, kVelocities, 2);
  scene.surface.length = 0.02;
  FrictionData data;
  for (const double velocity : {1e-3, 1e-2, 1e-1}) {
    MeasuredPoint point;
    point.velocity = velocity;
    point.mu = 0.05;
    point.nominalPressure = 25;
    data.points.push_back(point);
  }
  const auto have = [](const std::vector<Message>& messages, const char* text) {
    return std::ranges::any_of(messages, [text](const Message& one) {
      return one.english().find(text) != std::string::npos;
    });
  };
  const std::vector<VariedParameter> varied{{"surface.rms_height", scene}};
  const Fit fit = fitFriction(scene, {&data, 1}, varied, withoutProfiles());
  EXPECT_TRUE(have(fit.warnings, "of 25 Pa is a normal force of 10 mN"));
  scene.load.kind = LoadKind::Pressure;
  scene.load.width = 0.04;
  const Fit wide = fitFriction(scene, {&data, 1}, varied, withoutProfiles());
  EXPECT_FALSE(have(wide.warnings, "is a normal force of"));
  EXPECT_TRUE(have(wide.notes, "of 25 Pa is a normal force of 20 mN"));
}

TEST(Fit, AnyNumberOfThreadsGivesTheSameBits) {
  const FrictionData data = noisy(exactFriction(truth(), 1e-4, 1e3), 2);
  const Scene scene = start(20, 6);
  FitOptions one, three;
  one.threads = 1;
  three.threads = 3;
  const Fit a = fitFriction(scene, {&data, 1}, threeParameters(scene), one);
  const Fit b = fitFriction(scene, {&data, 1}, threeParameters(scene), three);
  EXPECT_EQ(a.chiSquared, b.chiSquared);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(a.parameters[k].value, b.parameters[k].value);
}

TEST(Fit, NeedsMorePointsThanParameters) {
  FrictionData data = noisy(exactFriction(truth(), 1e-4, 1e3), 2);
  data.points.resize(3);
  const Scene scene = start(5, 6);
  EXPECT_THROW(fitFriction(scene, {&data, 1}, threeParameters(scene)), InputError);
}

TEST(Fit, StopsWhereItIsAskedTo) {
  const FrictionData data = noisy(exactFriction(truth(), 1e-4, 1e3), 2);
  const Scene scene = start(50, 6);
  std::stop_source source;
  FitOptions options;
  options.stop = source.get_token();
  int calls = 0;
  options.progress = [&](int, double) {
    if (++calls == 2) source.request_stop();
  };
  EXPECT_THROW(fitFriction(scene, {&data, 1}, threeParameters(scene), options), StopRequested);
}

/// A local coefficient of friction that is too large at the start takes the height to where
/// friction no longer answers to it.
TEST(Fit, LeavesAMinimumInWhichAParameterHasNoEffect) {
  Scene scene = sceneOfSize(256, 9, 2);
  scene.surface.length = 0.02;
  scene.surface.seed = 3;
  scene.sweep.velocityFrom = 1e-3;
  scene.sweep.velocityTo = 10;
  scene.interface.frictionCoefficient = 0.02;
  scene.surface.rmsHeight = 5e-6;
  FrictionData data;
  for (const CurvePoint& point : frictionCurve(scene, {}).points) {
    MeasuredPoint measured;
    measured.velocity = point.velocity;
    measured.mu = point.mu + (std::isnan(point.muInterface) ? 0 : point.muInterface);
    measured.muError = 0.01 * measured.mu;
    measured.row = static_cast<int>(data.points.size()) + 2;
    data.points.push_back(measured);
  }
  scene.interface.frictionCoefficient = 0.1;
  scene.surface.rmsHeight = 5e-7;
  const Fit fit =
      fitFriction(scene, {&data, 1},
                  {{{"interface.friction_coefficient", scene}, {"surface.rms_height", scene}}},
                  withoutProfiles());
  EXPECT_LT(fit.chiSquared, 1e-3);
  EXPECT_FALSE(fit.missesPoints);
  EXPECT_NEAR(fit.parameters[0].value, 0.02, 1e-5);
  EXPECT_NEAR(fit.parameters[1].value, 5e-6, 1e-8);
}

/// Few lines spread more than the points' errors, and the fit says that its errors are uncertain;
/// many lines leave the points as the larger part.
TEST(Fit, SaysWhereFewLinesAreTheLargerPartOfTheErrors) {
  const FrictionData data = noisy(exactFriction(truth(), 1e-4, 1e3), 6);
  for (const std::int64_t lines : {6, 400}) {
    const Scene scene = start(lines, 8);
    const Fit fit = fitFriction(scene, {&data, 1}, threeParameters(scene), withoutProfiles());
    EXPECT_EQ(std::ranges::any_of(fit.warnings,
                                  [](const Message& note) {
                                    return note.english().starts_with("the spread of the");
                                  }),
              lines == 6);
  }
}

/// Hurst exponent, height and relaxation time can replace one another, and few lines make the sum
/// of squares uneven along their valley. A fit with profiles leaves the hollow in which one without
/// profiles ends; none of its profiles lies lower, and its ranges hold all points of the profiles
/// whose sum of squares is less than one standard error above the least.
TEST(Fit, FollowsAValleyFromItsHollows) {
  Scene scene = sceneOfSize(250, 10, 100);
  scene.load.normalForce = 0.02;
  const FrictionData data = noisy(exactFriction(scene, 1e-3, 3), 5);
  scene.ensemble.realizations = 6;
  scene.surface.hurst = 0.3;
  scene.elastomer.relaxationTime = 4e-4;
  scene.surface.rmsHeight = 1e-7;
  int hollows = 0, widened = 0, notes = 0;
  for (const std::int64_t seed : {21, 22, 23, 24, 25, 26}) {
    scene.surface.seed = seed;
    const std::vector<VariedParameter> varied{{"surface.hurst", scene},
                                              {"elastomer.relaxation_time", scene},
                                              {"surface.rms_height", scene}};
    const Fit without = fitFriction(scene, {&data, 1}, varied, withoutProfiles());
    const Fit fit = fitFriction(scene, {&data, 1}, varied);
    EXPECT_LE(fit.chiSquared, without.chiSquared);
    hollows += fit.chiSquared < without.chiSquared - 0.5;
    for (std::size_t k = 0; k < varied.size(); ++k) {
      const FittedParameter& parameter = fit.parameters[k];
      const ObjectiveProfile& profile = fit.profiles[k];
      for (std::size_t i = 0; i < profile.values.size(); ++i) {
        EXPECT_GE(profile.chiSquared[i], fit.chiSquared - 0.1) << profile.key;
        if (profile.chiSquared[i] > fit.chiSquared + fit.errorScale * fit.errorScale) continue;
        EXPECT_GE(profile.values[i], parameter.low * (1 - 1e-12)) << profile.key;
        EXPECT_LE(profile.values[i], parameter.high * (1 + 1e-12)) << profile.key;
      }
      widened += parameter.isWidened;
    }
    for (const Message& note : fit.notes)
      notes += note.english().find("is not a parabola") != std::string::npos;
  }
  EXPECT_GT(hollows, 0);
  EXPECT_GT(widened, 0);
  EXPECT_EQ(notes, widened);
}

}  // namespace
}  // namespace asperity
