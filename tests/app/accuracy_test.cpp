// asperity accuracy and explain: files, plans, refusals.
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/app/program.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
using testing::UnorderedElementsAre;
using Json = nlohmann::json;

using AccuracyCommandTest = ProgramTest;

TEST_F(AccuracyCommandTest, WritesTablesAndDiagrams) {
  const Said said = program.run("accuracy s.json -o out --json");
  EXPECT_EQ(said.status, 0) << said.err;
  EXPECT_THAT(program.folder.names("out"),
              UnorderedElementsAre("accuracy.csv", "accuracy.json", "work_precision.png",
                                   "work_precision.svg", "work_precision.pdf", "standard_error.png",
                                   "standard_error.svg", "standard_error.pdf"));
  EXPECT_EQ(said.out, read("out/accuracy.json"));
  const Json json = Json::parse(said.out);
  EXPECT_EQ(json["present_choice"], "cubic x2");
  ASSERT_FALSE(json["regions"].empty());
  for (const Json& region : json["regions"]) {
    ASSERT_EQ(region["methods"].size(), 12U);
    // Fourth order against second, and the reference beyond both.
    const Json& methods = region["methods"];
    EXPECT_LT(methods[11]["relative_error"], 0.01 * methods[7]["relative_error"].get<double>());
    EXPECT_LT(region["reference_error"], methods[11]["relative_error"]);
    EXPECT_GT(region["march"]["time_step"], 0);
    EXPECT_GE(region["march"]["settling"], 0);
  }
}

TEST_F(AccuracyCommandTest, ItsDiagramsAreDrawnByTheBackendThatIsGiven) {
  const Said said = program.run("accuracy s.json -o out --backend osmesa",
                                "ASPERITY_OSMESA_LIBRARY=libNowhere.so ");
  EXPECT_EQ(said.status, 1);
  EXPECT_THAT(said.err, HasSubstr("libNowhere"));
}

/// What the shipped default is for: at equal error or better, far faster than the literal march.
TEST_F(AccuracyCommandTest, TheDefaultBeatsTheLiteralMarchByFar) {
  const Said said = program.run("accuracy s.json -o out --json --set surface.elements=2000");
  ASSERT_EQ(said.status, 0) << said.err;
  const Json answer = Json::parse(said.out);
  for (const Json& region : answer["regions"]) {
    const Json& methods = region["methods"];
    ASSERT_EQ(methods[0]["method"], "literal march");
    ASSERT_EQ(methods[8]["method"], "cubic x2");
    EXPECT_LT(methods[8]["relative_error"], methods[0]["relative_error"]);
    EXPECT_GT(methods[0]["seconds"].get<double>() / methods[8]["seconds"].get<double>(), 100);
  }
}

TEST_F(AccuracyCommandTest, ExplainsThePlan) {
  const Said said = program.run("explain s.json");
  EXPECT_EQ(said.status, 0) << said.err;
  EXPECT_THAT(said.out,
              HasSubstr("no time march: steady sliding is stationary in the line's frame"));
  EXPECT_THAT(said.out, HasSubstr("predicted"));
  EXPECT_THAT(said.out, HasSubstr("resolution"));
}

TEST_F(AccuracyCommandTest, ExplainsWhereFewContactsCarryTheLoad) {
  const std::string paper =
      "explain s.json --set surface.rms_height=5e-7 --set load.normal_force=0.0034 "
      "--set elastomer.shear_modulus=1e7 --set elastomer.relaxation_time=";
  const std::string kelvin = paper + "1e-3";
  const Said said = program.run(kelvin);
  EXPECT_EQ(said.status, 0) << said.err;
  EXPECT_THAT(said.out, HasSubstr("above 1.7 m/s few contacts carry the load (region IV)"));
  EXPECT_THAT(said.out, HasSubstr("the finite period"));
  EXPECT_NEAR(Json::parse(program.run(kelvin + " --json").out)["few_summits_above"], 1.7, 1e-9);
  // Such a velocity is typed back, and 17,000 is no number to a command.
  EXPECT_THAT(program.run(paper + "1e-7").out, HasSubstr("above 17000 m/s few contacts"));
  const std::string solid = "explain s.json --set elastomer.rheology=standard_solid";
  EXPECT_EQ(program.run(solid).out.find("few contacts"), std::string::npos);
  EXPECT_TRUE(Json::parse(program.run(solid + " --json").out)["few_summits_above"].is_null());
}

TEST_F(AccuracyCommandTest, ExplainsWhatAMapCosts) {
  const std::string map =
      "explain s.json --set ensemble.realizations=3 --x sliding.velocity=1mm/s:1:8 "
      "--y load.normal_force=1mN:100mN:6";
  const Said said = program.run(map);
  EXPECT_EQ(said.status, 0) << said.err;
  EXPECT_THAT(said.out, HasSubstr("the map\n"));
  EXPECT_THAT(said.out, HasSubstr("8 times 6 states, 48 of them different, on 3 lines each"));
  const Json cost = Json::parse(program.run(map + " --json --threads 2").out)["map"];
  EXPECT_EQ(cost["columns"], 8);
  EXPECT_EQ(cost["rows"], 6);
  EXPECT_EQ(cost["different"], 48);
  EXPECT_EQ(cost["lines"], 3);
  EXPECT_EQ(cost["threads"], 2);
  EXPECT_GT(cost["seconds"].get<double>(), 0);
  EXPECT_FALSE(Json::parse(program.run("explain s.json --json").out).contains("map"));
  for (const auto& [options, says] :
       {std::pair{"--x sliding.velocity=1:2:3", "--y"},
        {"--y sliding.velocity=1:2:3", "--x"},
        {"--x sliding.velocity=1:2:3 --y sliding.velocity=1:2:3", "both sides of the map"},
        {"--x sliding.velocity=1:2 --y load.normal_force=1:2:3", "FROM:TO:N"},
        {"--x sliding.velocity=1:2:3 --y load.normal_force=1:2:3 --set sliding.kind=start "
         "--set sliding.duration=0.01",
         "sliding.kind"}}) {
    const Said refused = program.run(std::string("explain s.json ") + options);
    EXPECT_EQ(refused.status, 2) << options;
    EXPECT_THAT(refused.err, HasSubstr(says)) << options;
  }
}

TEST_F(AccuracyCommandTest, ExplainsForMachinesAndMeasures) {
  const Said said = program.run("explain s.json --analyze --json --set ensemble.realizations=40");
  EXPECT_EQ(said.status, 0) << said.err;
  const Json json = Json::parse(said.out);
  EXPECT_EQ(json["of_verb"], "curve");
  bool march = true, balance = false;
  for (const Json& stage : json["stages"]) {
    EXPECT_FALSE(stage["reason"].get<std::string>().empty());
    if (stage["name"] == "time march") march = stage["runs"];
    if (stage["name"] == "force balance") balance = stage["runs"];
  }
  EXPECT_FALSE(march);
  EXPECT_TRUE(balance);
  const Json &predicted = json["predicted"]["relative_error"],
             &measured = json["measured"]["relative_error"];
  for (const char* part : {"standard_error", "resolution", "total"})
    EXPECT_NEAR(std::log(predicted[part].get<double>() / measured[part].get<double>()), 0,
                std::log(1.6))
        << part;
}

TEST_F(AccuracyCommandTest, ExplainsAMotion) {
  const Said said =
      program.run("explain s.json --set sliding.kind=start --set sliding.duration=0.01");
  EXPECT_EQ(said.status, 0) << said.err;
  EXPECT_THAT(said.out, HasSubstr("asperity render runs"));
  EXPECT_THAT(said.out, HasSubstr("elements, without drawing"));
  EXPECT_THAT(said.out, HasSubstr("time step"));
}

TEST_F(AccuracyCommandTest, ACurveToATarget) {
  const Said said = program.run("curve s.json -o c.json --set accuracy.target_relative_error=0.05");
  EXPECT_EQ(said.status, 0) << said.err;
  const Json json = Json::parse(read("c.json"));
  EXPECT_EQ(json["scene"]["accuracy"]["target_relative_error"], 0.05);
  EXPECT_FALSE(json["scene"]["accuracy"].contains("scheme"));
  for (const Json& point : json["points"])
    EXPECT_LE(point["mu_standard_error"], 0.05 * point["mu"].get<double>());
  EXPECT_THAT(said.out, HasSubstr("target"));
}

/// The table is there, and the status says that it is not what was asked for.
TEST_F(AccuracyCommandTest, AMissedTargetIsAFailure) {
  const std::string call = "curve s.json -o c.csv --set surface.kind=sine --set ";
  const Said missed = program.run(call + "accuracy.target_relative_error=1e-17");
  EXPECT_EQ(missed.status, 1);
  EXPECT_THAT(missed.err, HasSubstr("accuracy.target_relative_error is not reached"));
  EXPECT_THAT(missed.out, HasSubstr("target not met"));
  EXPECT_THAT(read("c.csv"), HasSubstr("mu_high"));
  const Said met = program.run(call + "accuracy.target_relative_error=1e-4");
  EXPECT_EQ(met.status, 0) << met.err;
  EXPECT_THAT(met.out, HasSubstr("target met"));
}

/// Wherever a curve is computed for a picture.
TEST_F(AccuracyCommandTest, PicturesMissTheirTargetsAsTablesDo) {
  const std::string sine = " --set surface.kind=sine --set accuracy.target_relative_error=";
  EXPECT_EQ(program.run("render s.json -o missed.svg --layout both" + sine + "1e-17").status, 1);
  EXPECT_THAT(read("missed.svg"), HasSubstr("<svg")) << "as the window draws it";
  for (const char* call : {"render s.json -o p.svg --layout curve",
                           "curve s.json -o p.svg --with load.normal_force=1"}) {
    EXPECT_EQ(program.run(call + sine + "1e-4").status, 0) << call;
    const Said missed = program.run(call + sine + "1e-17");
    EXPECT_EQ(missed.status, 1) << call;
    EXPECT_THAT(missed.err, HasSubstr("accuracy.target_relative_error is not reached"));
  }
}

/// What a further curve misses is no reason to lose the others.
TEST_F(AccuracyCommandTest, AFurtherCurveThatMissesItsTargetIsWrittenAndNamed) {
  const std::string sine = " --set surface.kind=sine";
  for (const char* call :
       {"curve s.json -o", "render s.json --layout curve -o", "render s.json --layout both -o"}) {
    const Said missed =
        program.run(call + std::string(" further.svg") + sine +
                    " --with 'accuracy.target_relative_error=1e-17;load.normal_force=1'");
    EXPECT_EQ(missed.status, 1) << call;
    EXPECT_THAT(missed.err, AllOf(HasSubstr("F\u2099 = 1 N"),
                                  HasSubstr("accuracy.target_relative_error is not reached")));
    EXPECT_THAT(read("further.svg"), HasSubstr("<svg")) << call;
    std::filesystem::remove(program.folder / "further.svg");
  }
  const Said family = program.run("curve s.json -o family.csv --family load.normal_force=0.1:1:2" +
                                  sine + " --set accuracy.target_relative_error=1e-17");
  EXPECT_EQ(family.status, 1);
  EXPECT_THAT(read("family.csv"), HasSubstr("\nF\u2099 = 1 N,"));
  const Said both =
      program.run("curve s.json -o both.csv" + sine +
                  " --with 'accuracy.target_relative_error=1e-17;load.normal_force=1'"
                  " --with 'accuracy.target_relative_error=1e-17;load.normal_force=2'");
  EXPECT_EQ(both.status, 1);
  EXPECT_THAT(both.err, AllOf(HasSubstr("F\u2099 = 1 N"), HasSubstr("; F\u2099 = 2 N")));
}

TEST_F(AccuracyCommandTest, AnElasticSceneHasNothingToReach) {
  const std::string elastic =
      " s.json --json --set elastomer.rheology=elastic --set accuracy.target_relative_error=0.01";
  const Said curve = program.run("curve" + elastic);
  EXPECT_EQ(curve.status, 0) << curve.err;
  const Json answer = Json::parse(curve.out);
  for (const Json& point : answer["points"]) {
    EXPECT_LE(point["mu_low"], 0);
    EXPECT_GE(point["mu_high"], 0);
    EXPECT_LE(point["realizations"], 32);
  }
  const Said explained = program.run("explain" + elastic);
  EXPECT_EQ(explained.status, 0) << explained.err;
  EXPECT_LE(Json::parse(explained.out)["predicted"]["lines"], 32);
  EXPECT_LT(Json::parse(explained.out)["predicted"]["seconds"], 100);
}

/// A target that starts hundreds of thousands of lines is a valid one, but rarely meant.
TEST_F(AccuracyCommandTest, CheckWarnsOfATargetThatNeedsVeryManyLines) {
  const std::string check = "check s.json --set accuracy.target_relative_error=";
  EXPECT_THAT(run(check + "1e-5"),
              AllOf(HasSubstr("\n  accuracy.target_relative_error needs about "),
                    HasSubstr("may miss the target\n")));
  EXPECT_THAT(Json::parse(run(check + "1e-5 --json"))["warning"].get<std::string>(),
              HasSubstr("may miss the target"));
  EXPECT_THAT(run(check + "0.05"), Not(HasSubstr("target_relative_error")));
}

TEST_F(AccuracyCommandTest, TargetOrScheme) {
  program.folder.write("both.json",
                       R"({"accuracy":{"scheme":"cubic","target_relative_error":0.01}})");
  expectRefused("check both.json", 2, "chooses scheme and oversampling itself");
  expectRefused("check s.json --set accuracy.target_relative_error=2", 2, "outside 0 to 0.5");
  expectRefused("accuracy s.json", 2, "--output");
  expectRefused("accuracy s.json -o s.json", 2, "is not a folder");
  expectRefused("accuracy s.json -o out --set sliding.kind=start", 2, "steady");
}

}  // namespace
}  // namespace asperity
