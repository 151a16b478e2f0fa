#include "core/scene/sweep.h"

#include <gmock/gmock.h>

#include <cmath>

#include "core/base/input_error.h"
#include "core/scene/scene_assignments.h"
#include "core/scene/scene_file.h"
#include "tests/core/error_from.h"

namespace asperity {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// A scene whose curve goes over a key.
Scene sceneOver(const std::string& key, const std::string& from, const std::string& to,
                std::vector<std::string> more = {}) {
  more.insert(more.end(), {"sweep.key=" + key, "sweep.from=" + from, "sweep.to=" + to});
  return readScene("{}", "s.json", {}, more);
}

std::string errorOver(const std::string& key, const std::string& from, const std::string& to,
                      const std::vector<std::string>& more = {}) {
  return errorFrom([&] { sceneOver(key, from, to, more); });
}

/// Which column of a file has the heights is no property of a surface.
TEST(AnotherAxis, IsNotHowAFileIsRead) {
  Scene scene;
  scene.surface.kind = SurfaceKind::Measured;
  for (const char* key : {"surface.position_column", "surface.height_column"})
    EXPECT_THAT(whyNotSwept(*findParameter(key), scene).english(),
                HasSubstr("how the file is read"));
}

TEST(AnotherAxis, EndsAreTypedInTheUnitOfTheirKey) {
  const Scene forces = sceneOver("load.normal_force", "1mN", "20 N");
  EXPECT_EQ(forces.sweep.from, 1e-3);
  EXPECT_EQ(forces.sweep.to, 20);
  // The key counts wherever it stands among the assignments.
  const Scene later = readScene("{}", "s.json", {},
                                {"sweep.from=1mN", "sweep.to=2", "sweep.key=load.normal_force"});
  EXPECT_EQ(later.sweep.from, 1e-3);
  EXPECT_EQ(sceneOver("elastomer.temperature", "0\u00B0C", "60\u00B0C").sweep.to, 333.15);
  EXPECT_THAT(errorOver("load.normal_force", "1mm", "1"), HasSubstr("sweep.from"));
  EXPECT_THAT(errorOver("load.normal_force", "1mm", "1"), HasSubstr("a length"));
}

TEST(AnotherAxis, AnEndHasTheSliderOfItsKey) {
  const Scene scene = sceneOver("load.normal_force", "1", "2");
  const Parameter shown = parameterIn(*findParameter("sweep.from"), scene);
  EXPECT_EQ(shown.unit, "N");
  EXPECT_EQ(allowedRange(shown)->maximum,
            allowedRange(*findParameter("load.normal_force"))->maximum);
  EXPECT_EQ(parameterIn(*findParameter("sweep.points"), scene).unit, "");
  EXPECT_EQ(parameterIn(*findParameter("sweep.velocity_from"), Scene{}).unit, "m/s");
}

TEST(Sweep, ASceneOfBeforeIsWrittenAsBefore) {
  const std::string text = writeScene(readScene("{}", "s.json"));
  for (const char* key : {"\"key\"", "\"from\"", "\"to\"", "\"scale\""})
    EXPECT_THAT(text, Not(HasSubstr(key)));
  EXPECT_EQ(sweepValues(Scene{}), logSpaced(1e-5, 1e3, 41));
}

/// Tables of curves are joined by their velocities: 1 m/s is 1, and not 0.9999999999999999.
TEST(Sweep, MeetsDecadesAndStepsInPlainDigits) {
  const std::vector<double> decades = logSpaced(1e-5, 1e3, 41);
  for (int k = 0; k <= 8; ++k) {
    const double decade = std::stod("1e" + std::to_string(k - 5));
    EXPECT_EQ(decades[static_cast<std::size_t>(5 * k)], decade);
  }
  EXPECT_EQ(logSpaced(0.3, 3000, 5)[2], 30);
  EXPECT_EQ(logSpaced(1e-6, 1e4, 11)[6], 1);
  EXPECT_EQ(logSpaced(1e-6, 1e3, 46)[30], 1);
  EXPECT_EQ(logSpaced(1e-20, 1e20, 41)[20], 1);
  EXPECT_EQ(linearSpaced(-1, 1, 201)[94], -0.06);
  EXPECT_EQ(linearSpaced(1, 0, 1001)[932], 0.068);
  EXPECT_THAT(logSpaced(2, 8, 1), testing::ElementsAre(2));
  EXPECT_THAT(linearSpaced(2, 8, 2), testing::ElementsAre(2, 8));
  EXPECT_EQ(linearSpaced(0, 0.3, 4)[1], 0.1);
  for (const double to : {0.6, 0.9, 2.1})
    EXPECT_EQ(linearSpaced(-0.3, to, std::lround(to / 0.1) + 4)[3], 0) << to;
  const double between = logSpaced(1e-5, 1e3, 41)[7];
  EXPECT_NEAR(between / std::pow(10, -3.6), 1, 1e-15);
}

TEST(Sweep, AnyNumberWithAMeaningReadsBackFromItsOwnText) {
  for (const auto& [key, from, to] : {std::tuple{"load.normal_force", "1e-3", "10"},
                                      {"load.normal_force", "10", "1e-3"},
                                      {"surface.elements", "100", "5000"},
                                      {"surface.seed", "1", "7"},
                                      {"surface.hurst", "0.2", "1"},
                                      {"elastomer.shear_modulus", "1e6", "1e8"},
                                      {"accuracy.oversampling", "1", "16"}}) {
    const Scene scene = sceneOver(key, from, to);
    const std::string text = writeScene(scene);
    EXPECT_EQ(readScene(text, "t.json"), scene) << text;
    EXPECT_EQ(writeScene(readScene(text, "t.json")), text);
    EXPECT_THAT(text, HasSubstr(std::string("\"key\": \"") + key));
    EXPECT_THAT(text, Not(HasSubstr("velocity_from")));
    // What tells it from a plain scene tells everything.
    EXPECT_EQ(readScene("{}", "s.json", {}, differingAssignments(Scene{}, scene)), scene);
  }
  // An end of 0 is the default of the key, and is written nonetheless.
  const Scene scene =
      sceneOver("interface.friction_coefficient", "0", "0.5", {"sweep.scale=linear"});
  EXPECT_EQ(readScene(writeScene(scene), "t.json"), scene);
  EXPECT_EQ(readScene("{}", "s.json", {}, differingAssignments(Scene{}, scene)), scene);
}

TEST(Sweep, ValuesAreSpacedAsTheScaleSaysAndRunDownwardsToo) {
  EXPECT_THAT(sweepValues(sceneOver("load.normal_force", "1", "100", {"sweep.points=3"})),
              ElementsAre(1, testing::DoubleEq(10), 100));
  EXPECT_THAT(sweepValues(sceneOver("load.normal_force", "100", "1", {"sweep.points=3"})),
              ElementsAre(100, testing::DoubleEq(10), 1));
  EXPECT_THAT(sweepValues(sceneOver("load.normal_force", "1", "5",
                                    {"sweep.points=3", "sweep.scale=linear"})),
              ElementsAre(1, 3, 5));
  EXPECT_THAT(sweepValues(sceneOver("load.normal_force", "7", "100", {"sweep.points=1"})),
              ElementsAre(7));
  const Scene velocities = readScene(
      "{}", "s.json", {},
      {"sweep.velocity_from=1", "sweep.velocity_to=3", "sweep.points=3", "sweep.scale=linear"});
  EXPECT_THAT(sweepValues(velocities), ElementsAre(1, 2, 3));
}

TEST(Sweep, WholeNumbersAreRoundedAndRepeatsAreLeftOut) {
  EXPECT_THAT(
      sweepValues(sceneOver("surface.seed", "1", "4", {"sweep.points=9", "sweep.scale=linear"})),
      ElementsAre(1, 2, 3, 4));
  EXPECT_THAT(
      sweepValues(sceneOver("surface.seed", "4", "1", {"sweep.points=9", "sweep.scale=linear"})),
      ElementsAre(4, 3, 2, 1));
  const Scene scene = sceneOver("surface.elements", "100.4", "100.6");
  EXPECT_THAT(sweepValues(scene), ElementsAre(100, 101));
  EXPECT_EQ(sceneAt(scene, 101).surface.elements, 101);
}

TEST(Sweep, AStateHasTheValueAndNoSweepOfItsOwn) {
  const Scene scene = sceneOver("elastomer.shear_modulus", "1e6", "1e8");
  const Scene state = sceneAt(scene, 2e7);
  EXPECT_EQ(state.elastomer.shearModulus, 2e7);
  EXPECT_EQ(state.sweep, Sweep{});
  EXPECT_EQ(state.sliding, scene.sliding);
  EXPECT_EQ(ownSweptValue(scene), scene.elastomer.shearModulus);
  EXPECT_EQ(sceneAt(Scene{}, 3).sliding.velocity, 3);
}

TEST(Sweep, EachMisuseHasOneClearLine) {
  EXPECT_THAT(
      errorOver("load.normal_forc", "1", "2"),
      HasSubstr("s.json: sweep.key: load.normal_forc: unknown key; the nearest known one is "
                "load.normal_force"));
  EXPECT_THAT(errorOver("surface.kind", "1", "2"),
              HasSubstr("sweep.key: surface.kind is not a number"));
  EXPECT_THAT(errorOver("title", "1", "2"), HasSubstr("sweep.key: title is not a number"));
  EXPECT_THAT(errorOver("sweep.points", "1", "2"), HasSubstr("says how the curve is made"));
  EXPECT_THAT(errorOver("ensemble.realizations", "1", "2"),
              HasSubstr("says how the curve is made"));
  EXPECT_THAT(errorOver("load.depth", "1e-6", "2e-6"),
              HasSubstr("sweep.key: load.depth has no meaning for load.kind force"));
  EXPECT_THAT(errorOver("elastomer.shift.activation_energy", "1e4", "2e5"),
              HasSubstr("has no meaning for elastomer.shift.kind wlf"));
  EXPECT_THAT(errorOver("load.normal_force", "0", "2"),
              HasSubstr("sweep.from: 0 is outside 1e-30 to 1e30 N of load.normal_force"));
  EXPECT_THAT(errorOver("surface.hurst", "0.2", "1.4"),
              HasSubstr("sweep.to: 1.4 is outside 0 to 1 of surface.hurst"));
  EXPECT_THAT(errorOver("surface.hurst", "0", "1"),
              HasSubstr("sweep.from: 0 has no place on a logarithmic axis"));
  EXPECT_THAT(errorOver("surface.summit_correlation", "-1", "1"),
              HasSubstr("sweep.from: -1 has no place on a logarithmic axis"));
  EXPECT_EQ(errorOver("surface.summit_correlation", "-1", "1", {"sweep.scale=linear"}), "no error");
}

TEST(Sweep, AKeyThatChangesNothingIsRefused) {
  const auto nothing = [](const std::string& key) {
    return HasSubstr("sweep.key: " + key + " changes nothing in this scene");
  };
  // Without a shift, temperature has no influence; with one it has.
  EXPECT_THAT(errorOver("elastomer.temperature", "290", "320", {"elastomer.shift.c1=0"}),
              nothing("elastomer.temperature"));
  EXPECT_EQ(errorOver("elastomer.temperature", "290", "320"), "no error");
  // At the reference temperature there is no shift, whatever its constants.
  EXPECT_THAT(errorOver("elastomer.shift.c1", "1", "20"), nothing("elastomer.shift.c1"));
  EXPECT_EQ(errorOver("elastomer.shift.c1", "1", "20", {"elastomer.temperature=320"}), "no error");
  EXPECT_THAT(errorOver("interface.shear_width", "0.1", "1"), nothing("interface.shear_width"));
  EXPECT_THAT(errorOver("interface.shear_width", "0.1", "1", {"interface.shear_stress=3"}),
              nothing("interface.shear_width"));
  EXPECT_EQ(errorOver("interface.shear_width", "0.1", "1",
                      {"interface.shear_stress=3", "interface.shear_velocity=1"}),
            "no error");
  // A curve is of steady sliding, whatever the motion.
  EXPECT_THAT(errorOver("sliding.duration", "0.1", "1", {"sliding.kind=start"}),
              nothing("sliding.duration"));
  EXPECT_THAT(errorOver("elastomer.measured.frequency_to", "1", "10",
                        {"elastomer.rheology=prony", "elastomer.equilibrium_modulus=1e6"}),
              nothing("elastomer.measured.frequency_to"));
}

TEST(Sweep, AnEndThatCannotBeIsNamedWithItsReason) {
  EXPECT_THAT(errorOver("elastomer.temperature", "100", "320", {"elastomer.shift.c1=10"}),
              HasSubstr("sweep.from: elastomer.temperature: "));
  EXPECT_THAT(
      errorOver("interface.friction_coefficient", "0.1", "0.5", {"interface.shear_stress=3"}),
      HasSubstr("sweep.from: interface.shear_stress: cannot be combined"));
}

TEST(Sweep, EndsBelongToTheirKey) {
  EXPECT_THAT(errorOfScene(R"({"sweep":{"key":"load.normal_force","from":1}})"),
              HasSubstr("sweep.to: is missing; sweep.key load.normal_force needs it"));
  EXPECT_THAT(errorOfScene(R"({"sweep":{"key":"load.normal_force","velocity_from":1}})"),
              HasSubstr("sweep.velocity_from: has no meaning for sweep.key load.normal_force; it "
                        "belongs to sliding.velocity"));
  for (const char* json : {R"({"sweep":{"from":1,"to":2}})",
                           R"({"sweep":{"key":"sliding.velocity","from":1,"to":2}})"})
    EXPECT_THAT(errorOfScene(json), HasSubstr("sweep.from: has no meaning for sweep.key "
                                              "sliding.velocity; it belongs to all others"));
  EXPECT_THAT(errorOfScene(R"({"sweep":{"key":3}})"), HasSubstr("sweep.key"));
  // Another key by --set needs ends of its own: those of the file are of other numbers.
  const std::string forces = R"({"sweep":{"key":"load.normal_force","from":1,"to":2}})";
  EXPECT_THAT(errorOfScene(forces, {"sweep.key=surface.rms_height"}),
              HasSubstr("sweep.from: is missing; sweep.key surface.rms_height needs it"));
  EXPECT_EQ(errorOfScene(forces, {"sweep.key=load.normal_force", "sweep.to=3"}), "no error");
  EXPECT_EQ(readScene(forces, "s.json", {}, {"sweep.key=sliding.velocity"}), Scene{});
  // Velocities of the file have no meaning any more.
  EXPECT_EQ(errorOfScene(R"({"sweep":{"velocity_from":1,"velocity_to":2}})",
                         {"sweep.key=load.normal_force", "sweep.from=1", "sweep.to=2"}),
            "no error");
  EXPECT_THAT(errorOfScene(forces, {"load.kind=indentation"}),
              HasSubstr("sweep.key: load.normal_force has no meaning for load.kind indentation"));
}

}  // namespace
}  // namespace asperity
