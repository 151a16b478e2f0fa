// The file of a study: what it means, and that every mistake is named with file, key and what is
// allowed.
#include "core/study/study_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/input_error.h"
#include "tests/core/error_from.h"
#include "tests/core/temporary_folder.h"

namespace asperity {
namespace {

ParameterStudy parse(const std::string& members, const std::filesystem::path& folder = {}) {
  return readStudy(R"({"schema":"asperity-study/1",)" + members + "}", "s.json", folder);
}

std::string refusal(const std::string& members) {
  return errorFrom([&] { parse(members); });
}

TEST(StudyFile, ReadsAGrid) {
  const ParameterStudy study = parse(
      R"("title":"T","set":{"surface.elements":100},"space":{"load.normal_force":{"from":0.001,"to":1,)"
      R"("points":4},"surface.hurst":[0.3,0.7]},"outputs":["mu","curve.contact_fraction"])");
  EXPECT_EQ(study.simulations(), 8);
  EXPECT_EQ(study.base.surface.elements, 100);
  EXPECT_EQ(study.numbers(), 1 + 41U);
  EXPECT_FALSE(study.isSlow);
  std::vector<double> point(2);
  study.space.pointInto(3, point);
  // The slider of a force is logarithmic, so its range is.
  EXPECT_NEAR(point[0], 0.01, 1e-15);
  EXPECT_EQ(point[1], 0.7);
  const Scene scene = study.sceneAt(point);
  EXPECT_EQ(scene.load.normalForce, point[0]);
  EXPECT_EQ(scene.surface.hurst, 0.7);
}

/// A text with a unit is the same study as its number.
TEST(StudyFile, NumbersMayHaveUnits) {
  const auto digestOf = [](const std::string& from, const std::string& height) {
    return parse(R"("space":{"load.normal_force":{"from":)" + from +
                 R"(,"to":1,"points":4},"surface.rms_height":[)" + height + "]}")
        .digest;
  };
  EXPECT_EQ(digestOf(R"("1 mN")", R"("0.5 um")"), digestOf("0.001", "5e-7"));
}

TEST(StudyFile, AFitNeedsTheCurveAndIsOneNumber) {
  const ParameterStudy study =
      parse(R"("space":{"surface.hurst":[0.3,0.7]},"outputs":["fit.maximum","fit.exponent"])");
  EXPECT_FALSE(study.wantsPoint());
  EXPECT_TRUE(study.wantsCurve());
  EXPECT_EQ(study.curveValues().size(), 41U);
  EXPECT_EQ(study.numbers(), 2U);
  EXPECT_EQ(study.outputs[1].fit, CurveFit::Exponent);
  // Where kinds are varied some simulations may have regions.
  EXPECT_TRUE(parse(R"("space":{"elastomer.rheology":["standard_solid","kelvin"]},)"
                    R"("outputs":["fit.plateau"])")
                  .isSlow);
}

TEST(StudyFile, AWordMakesScenesOfAnotherKind) {
  const ParameterStudy study =
      parse(R"("space":{"accuracy.scheme":["linear","cubic"],"surface.hurst":[0.5]})");
  EXPECT_TRUE(study.isSlow);
  EXPECT_EQ(study.sceneAt(std::vector<double>{0, 0.5}).accuracy.scheme, Scheme::Linear);
  EXPECT_EQ(study.sceneAt(std::vector<double>{1, 0.5}).accuracy.scheme, Scheme::Cubic);
}

TEST(StudyFile, TakesKeysAndValuesFromATable) {
  const TemporaryFolder folder;
  folder.write("rows.csv", "load.normal_force,surface.seed\n0.01,1\n0.02,5\n0.03,9\n");
  const ParameterStudy study =
      parse(R"("space":{"rows":"rows.csv","surface.hurst":[0.3,0.7]})", folder.path());
  EXPECT_EQ(study.simulations(), 6);
  std::vector<double> point(3);
  study.space.pointInto(3, point);
  EXPECT_EQ(point, (std::vector<double>{0.02, 5, 0.7}));
  // The store keeps the rows themselves, for the table may be gone.
  EXPECT_EQ(readStudy(study.canonical, "x", {}).digest, study.digest);
}

TEST(StudyFile, ItsCanonicalTextIsAStudyWithTheSameMeaning) {
  for (const char* members :
       {R"("space":{"surface.hurst":[0.3,0.7]})",
        R"("sampling":"sobol","samples":100,"seed":7,"space":{"surface.hurst":{"from":0.1,"to":1},)"
        R"("load.normal_force":{"distribution":"lognormal","mean":0.01,"deviation":0.003,"to":1},)"
        R"("surface.rms_height":{"distribution":"uniform","from":1e-7,"to":1e-6}})",
        R"("space":{"surface.hurst":[0.3,0.7]},"outputs":["fit.maximum","mu","fit.plateau"])",
        R"("space":{"accuracy.scheme":["linear","cubic"]},"outputs":["curve.mu"],"chunk":3)"}) {
    const ParameterStudy study = parse(members);
    const ParameterStudy again = readStudy(study.canonical, "x", {});
    EXPECT_EQ(again.canonical, study.canonical);
    EXPECT_EQ(again.digest, study.digest);
    EXPECT_EQ(again.simulations(), study.simulations());
    std::vector<double> a(study.space.columns()), b(a);
    study.space.pointInto(study.simulations() - 1, a);
    again.space.pointInto(study.simulations() - 1, b);
    EXPECT_EQ(a, b);
  }
}

/// A double holds whole numbers up to 2^53; 2^53 + 1 would become 2^53, and with it another sample.
TEST(StudyFile, ASeedKeepsEveryDigitOrIsRefused) {
  const auto withSeed = [](const std::string& seed) {
    return R"("sampling":"sobol","samples":100,"seed":)" + seed +
           R"(,"space":{"surface.hurst":{"from":0.1,"to":1}})";
  };
  EXPECT_EQ(parse(withSeed("9007199254740991")).space.seed(), 9007199254740991);
  for (const char* seed : {"9007199254740992", "9007199254740993", "18446744073709551615", "-1",
                           "1.5", "9007199254740993.0"})
    EXPECT_THAT(refusal(withSeed(seed)), testing::HasSubstr("seed")) << seed;
  EXPECT_THAT(
      refusal(withSeed("9007199254740993")),
      testing::HasSubstr("9007199254740993 is not a whole number from 0 to 9007199254740991"));
}

TEST(StudyFile, TheTitleIsNoPartOfTheStudy) {
  EXPECT_EQ(parse(R"("title":"a","space":{"surface.hurst":[0.3]})").digest,
            parse(R"("title":"b","space":{"surface.hurst":[0.3]})").digest);
}

TEST(StudyFile, DifferencesAreNamed) {
  const std::string a = parse(R"("space":{"surface.hurst":[0.3,0.7]})").canonical;
  const std::string b = parse(R"("space":{"surface.hurst":[0.3,0.8]})").canonical;
  EXPECT_THAT(describeDifference(a, b).english(),
              testing::HasSubstr("space.surface.hurst.1 is 0.8 instead of 0.7"));
  const std::string c =
      parse(R"("set":{"load.normal_force":1},"space":{"surface.hurst":[0.3,0.7]})").canonical;
  EXPECT_THAT(describeDifference(a, c).english(),
              testing::HasSubstr("scene.load.normal_force is 1.0 instead of 0.0034"));
}

TEST(StudyFile, MistakesAreNamed) {
  using testing::HasSubstr;
  const std::pair<const char*, const char*> cases[] = {
      {R"("spcae":{})", "s.json: spcae: unknown key; the nearest known one is space"},
      {R"("space":{})", "space: needs an object"},
      {R"("space":{"rows":"gone.csv"})", "s.json: space.rows: "},
      {R"("space":3)", "space: needs an object"},
      {R"("space":{"surface.hrust":[1]})", "the nearest known one is surface.hurst"},
      {R"("space":{"surface.hurst":[]})", "space.surface.hurst: has no value"},
      {R"("space":{"surface.hurst":[1.5]})", "1.5 is outside 0 to 1"},
      {R"("space":{"surface.hurst":["a"]})", "space.surface.hurst: 'a' is not a number"},
      {R"("space":{"surface.hurst":[true]})", "is not allowed here"},
      {R"("space":{"load.normal_force":["1 kg"]})", "1 kg is a mass"},
      {R"("space":{"load.normal_force":{"from":"1 m","to":1,"points":3}})",
       "space.load.normal_force.from: 1 m is a length"},
      {R"("space":{"surface.hurst":0.5})", "needs a list of values, a range"},
      {R"("space":{"accuracy.scheme":["quartic"]})", "is not one of nodal, linear, cubic"},
      {R"("space":{"accuracy.scheme":{"from":1,"to":2,"points":2}})", "is not a number"},
      {R"("space":{"surface.amplitude":[1e-6]})", "has no meaning in this scene"},
      {R"("space":{"sweep.points":[3]})", "cannot be varied"},
      {R"("space":{"title":["a"]})", "cannot be varied"},
      {R"("space":{"sliding.kind":["steady","start"]})", "cannot be varied"},
      {R"("space":{"surface.hurst":{"from":0.1,"to":1}})", "points: is missing"},
      {R"("space":{"surface.hurst":{"from":0.1,"to":1,"points":0}})", "from 1 to"},
      {R"("space":{"surface.hurst":{"from":0.1,"points":3}})", "to: is missing"},
      {R"("space":{"surface.hurst":{"from":0.1,"to":1,"points":3,"scale":"cubic"}})",
       "neither log nor linear"},
      {R"("space":{"surface.hurst":{"from":0,"to":1,"points":3,"scale":"log"}})",
       "ends above 0; 0 is not"},
      {R"("space":{"surface.hurst":{"distribution":"normal","mean":0.5,"deviation":0.1}})",
       "needs sampling latin_hypercube"},
      {R"("samples":5,"space":{"surface.hurst":[0.5]})",
       "samples: has no meaning for sampling grid"},
      {R"("sampling":"sobel","space":{"surface.hurst":[0.5]})", "is not one of grid"},
      {R"("sampling":"sobol","space":{"surface.hurst":[0.5]})", "samples: is missing"},
      {R"("sampling":"sobol","samples":0,"space":{"surface.hurst":[0.5]})", "from 1 to"},
      {R"("sampling":"sobol","samples":5,"space":{"surface.hurst":{"from":0.1,"to":1,"points":3}})",
       "points: has no meaning in a sample"},
      {R"("sampling":"sobol","samples":5,"space":{"surface.hurst":{"distribution":"normal","mean":0.5,)"
       R"("deviation":0}})",
       "deviation: is not above 0"},
      {R"("sampling":"sobol","samples":5,"space":{"surface.hurst":{"distribution":"normal","mean":0.5}})",
       "deviation: is missing"},
      {R"("sampling":"sobol","samples":5,"space":{"surface.hurst":{"distribution":"uniform","mean":0.9,)"
       R"("deviation":0.2}})",
       "outside 0 to 1"},
      {R"("sampling":"sobol","samples":5,"space":{"surface.hurst":{"distribution":"normal","mean":0.5,)"
       R"("deviation":0.001,"from":0.9}})",
       "almost nothing"},
      {R"("set":{"surface.hurst":0.5},"space":{"surface.hurst":[0.5]})", "one of them is enough"},
      {R"("set":{"surface.hrust":0.5},"space":{"surface.hurst":[0.5]})", "set.surface.hrust"},
      {R"("space":{"surface.hurst":[0.5]},"outputs":["mju"])", "the nearest known one is mu"},
      {R"("space":{"surface.hurst":[0.5]},"outputs":["mu","mu"])", "named twice"},
      {R"("space":{"surface.hurst":[0.5]},"outputs":[])", "needs a list of names"},
      {R"("space":{"sliding.velocity":[0.5]},"outputs":["curve.mu"])", "what the curve goes over"},
      {R"("space":{"surface.hurst":[0.5]},"outputs":["fit.exponnt"])", "known one is fit.exponent"},
      {R"("space":{"surface.hurst":[0.5]},"outputs":["fit.zzzzzzzzzzzzzzzzzzzz"])",
       "known are fit.maximum, "},
      {R"("space":{"sliding.velocity":[0.5]},"outputs":["fit.maximum"])",
       "what the curve goes over"},
      {R"("set":{"sweep.points":2},"space":{"surface.hurst":[0.5]},"outputs":["fit.exponent"])",
       "needs a curve of at least 3 points; sweep.points gives 2"},
      {R"("set":{"sweep.key":"load.normal_force","sweep.from":0.01,"sweep.to":1},)"
       R"("space":{"surface.hurst":[0.5]},"outputs":["fit.plateau"])",
       "needs a curve over velocity, not over load.normal_force"},
      {R"("set":{"elastomer.rheology":"standard_solid"},"space":{"surface.hurst":[0.5]},)"
       R"("outputs":["fit.exponent_region_1"])",
       "needs an elastomer of one relaxation time"},
      {R"("space":{"surface.hurst":[0.5]},"chunk":0)", "chunk: 0 is not a whole number"},
      {R"("scene":{"sliding":{"kind":"start"}},"space":{"surface.hurst":[0.5]})", "sliding.kind"},
      {R"("set":{"accuracy.target_relative_error":0.01},"space":{"surface.hurst":[0.5]})",
       "not a target"},
      {R"("scene":"none.json","space":{"surface.hurst":[0.5]})",
       "s.json: scene: none.json: cannot"},
      {R"("scene":7,"space":{"surface.hurst":[0.5]})", "s.json: scene: needs an object"},
      {R"("space":{"rows":"nowhere.csv"})", "nowhere.csv"},
      {R"("space":{"surface.hurst":[0.5],"surface.hurst":[0.6]})", "occurs twice"},
  };
  for (const auto& [members, says] : cases)
    EXPECT_THAT(refusal(members), HasSubstr(says)) << members;
  EXPECT_THROW(readStudy("{}", "s.json", {}), InputError);
  EXPECT_THROW(readStudy("", "s.json", {}), InputError);
  EXPECT_THROW(readStudy("[1]", "s.json", {}), InputError);
}

TEST(StudyFile, MistakesOfATableNameFileAndLine) {
  const TemporaryFolder folder;
  const auto says = [&](const std::string& table) -> std::string {
    folder.write("rows.csv", table);
    return errorFrom([&] { parse(R"("space":{"rows":"rows.csv"})", folder.path()); });
  };
  EXPECT_THAT(says("load.normal_forse,surface.seed\n0.01,1\n0.02,2\n"),
              testing::HasSubstr("the nearest known one is load.normal_force"));
  EXPECT_THAT(says("surface.hurst,surface.seed\n0.5,1\n1.5,2\n"),
              testing::AllOf(testing::HasSubstr("rows.csv: line 3"),
                             testing::HasSubstr("1.5 is outside 0 to 1")));
  EXPECT_THAT(says("surface.hurst,surface.seed\n0.5,1\nNaN,2\n"),
              testing::HasSubstr("line 3: surface.hurst is missing"));
}

TEST(StudyFile, AHugeGridIsRefusedInNoTime) {
  std::string space;
  for (const char* key :
       {"surface.hurst", "load.normal_force", "surface.rms_height", "elastomer.shear_modulus"})
    space += fmt::format(R"({}"{}":{{"from":0.1,"to":0.9,"points":100000}})",
                         space.empty() ? "" : ",", key);
  EXPECT_THAT(refusal(R"("set":{"surface.elements":100},"space":{)" + space + "}"),
              testing::AnyOf(testing::HasSubstr("simulations"), testing::HasSubstr("outside")));
}

TEST(StudyFile, CommasInQuotedNumbersOfATableSeparateThousands) {
  const TemporaryFolder folder;
  folder.write("rows.csv", "load.normal_force,surface.seed\n\"1,000\",1\n\"2,000\",5\n");
  const ParameterStudy study = parse(R"("space":{"rows":"rows.csv"})", folder.path());
  std::vector<double> point(2);
  study.space.pointInto(1, point);
  EXPECT_EQ(point, (std::vector<double>{2000, 5}));
}

TEST(StudyFile, AnEmptyCellOfATableNamesItsLine) {
  const TemporaryFolder folder;
  folder.write("rows.csv", "accuracy.scheme,surface.hurst\nlinear,\ncubic,0.5\n");
  EXPECT_THAT(errorFrom([&] { parse(R"("space":{"rows":"rows.csv"})", folder.path()); }),
              testing::HasSubstr("line 2: the value in column 2 is missing"));
}

}  // namespace
}  // namespace asperity
