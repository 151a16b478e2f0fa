#include "core/scene/scene_file.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <filesystem>

#include "core/base/input_error.h"
#include "core/scene/parameters.h"
#include "tests/core/error_from.h"
#include "tests/core/temporary_folder.h"

namespace asperity {
namespace {

using testing::HasSubstr;

TEST(SceneFile, WhatIsLeftOutHasItsDefault) {
  EXPECT_EQ(readScene("{}", "s.json"), Scene{});
}

TEST(SceneFile, EveryKindOfSceneReadsBackFromItsOwnText) {
  for (const char* kind : {"self_affine", "sine", "wedge", "parabola", "profile"})
    for (const char* load : {"force", "indentation"})
      for (const char* rheology : {"elastic", "kelvin", "standard_solid", "prony"}) {
        std::vector<std::string> assignments{
            std::string("surface.kind=") + kind, std::string("load.kind=") + load,
            std::string("elastomer.rheology=") + rheology, "title=Grüße, \"line\""};
        const bool arms = std::string(rheology) == "standard_solid" || rheology[0] == 'p';
        assignments.push_back(arms ? "elastomer.equilibrium_modulus=1.2345678901234567e7"
                                   : "elastomer.shear_modulus=1.2345678901234567e7");
        if (std::string(kind) == "profile") assignments.push_back("surface.file=a.csv");
        const Scene scene = readScene("{}", "s.json", {}, assignments);
        const std::string text = writeScene(scene);
        EXPECT_EQ(readScene(text, "t.json"), scene) << text;
        EXPECT_EQ(writeScene(readScene(text, "t.json")), text);
      }
}

TEST(SceneFile, EveryMotionReadsBackFromItsOwnText) {
  for (const char* kind : {"steady", "start", "step", "oscillation", "reversal"}) {
    const Scene scene =
        readScene("{}", "s.json", {}, {std::string("sliding.kind=") + kind, "sliding.velocity=0"});
    EXPECT_EQ(readScene(writeScene(scene), "t.json"), scene) << kind;
  }
  const Scene back =
      readScene("{}", "s.json", {}, {"sliding.kind=step", "sliding.velocity_after=-3"});
  EXPECT_EQ(readScene(writeScene(back), "t.json").sliding.velocityAfter, -3);
  EXPECT_THAT(errorOfScene(R"({"sliding":{"duration":1}})"),
              HasSubstr("sliding.duration: has no meaning for sliding.kind steady; it belongs to "
                        "start, step, oscillation, reversal"));
  EXPECT_THAT(errorOfScene(R"({"sliding":{"kind":"start","velocity_after":1}})"),
              HasSubstr("it belongs to step"));
}

TEST(SceneFile, ArmsStandInTheFileAndInAssignments) {
  const std::string file =
      R"({"elastomer":{"rheology":"prony","equilibrium_modulus":1e6,"viscosity":3,
          "arms":[{"modulus":1e7,"relaxation_time":0.1},{"relaxation_time":1e-4,"modulus":2e7}]}})";
  const Scene scene = readScene(file, "s.json");
  EXPECT_EQ(scene.elastomer.arms, (std::vector<Arm>{{1e7, 0.1}, {2e7, 1e-4}}));
  EXPECT_EQ(readScene(writeScene(scene), "t.json"), scene);
  const Scene other =
      readScene(file, "s.json", {}, {R"(elastomer.arms=[{"modulus":5,"relaxation_time":6}])"});
  EXPECT_EQ(other.elastomer.arms, (std::vector<Arm>{{5, 6}}));
  EXPECT_TRUE(readScene(file, "s.json", {}, {"elastomer.arms=[]"}).elastomer.arms.empty());
}

TEST(SceneFile, ErrorsOfArmsNameTheArm) {
  const auto errorOfArms = [](const std::string& arms) {
    return errorOfScene(R"({"elastomer":{"rheology":"prony","arms":)" + arms + "}}");
  };
  EXPECT_EQ(
      errorOfArms(R"([{"modulus":1,"relaxation_time":1},{"modulus":-5,"relaxation_time":1}])"),
      "s.json: elastomer.arms[1].modulus: -5 is outside 0 to 1e15 Pa");
  EXPECT_THAT(errorOfArms(R"([{"modulus":1}])"),
              HasSubstr("elastomer.arms[0].relaxation_time: is missing"));
  EXPECT_THAT(errorOfArms(R"([{"modulus":"x","relaxation_time":1}])"),
              HasSubstr("elastomer.arms[0].modulus: is not a number"));
  EXPECT_THAT(errorOfArms(R"([{"modulus":1,"relaxation_time":1,"tau":1}])"),
              HasSubstr("elastomer.arms[0].tau: unknown key"));
  EXPECT_THAT(errorOfArms("[1]"), HasSubstr("elastomer.arms[0]: needs an object"));
  EXPECT_THAT(errorOfArms("3"), HasSubstr("elastomer.arms: a number is not a list"));
  EXPECT_THAT(errorOfArms(R"("x")"), HasSubstr("elastomer.arms: is not a list in JSON"));
  EXPECT_THAT(errorOfArms(R"([{"modulus":1e-9,"relaxation_time":1}])"),
              HasSubstr("elastomer.arms[0].modulus: 1e-9 Pa is neither 0 nor at least"));
  std::string many;
  for (int i = 0; i < 65; ++i) many += R"(,{"modulus":1,"relaxation_time":1})";
  EXPECT_THAT(errorOfArms("[" + many.substr(1) + "]"), HasSubstr("elastomer.arms: has 65 arms"));
  EXPECT_THAT(errorOfScene(R"({"elastomer":{"arms":[]}})"),
              HasSubstr("elastomer.arms: has no meaning for elastomer.rheology kelvin"));
  EXPECT_THAT(errorOfScene(R"({"elastomer":{"rheology":"standard_solid","arms":[]}})"),
              HasSubstr("elastomer.arms: a standard solid has one arm, not 0"));
  EXPECT_THAT(errorOfScene(R"({"elastomer":{"rheology":"prony","shear_modulus":1}})"),
              HasSubstr("elastomer.shear_modulus: has no meaning"));
  EXPECT_THAT(
      errorOfScene(R"({"elastomer":{"rheology":"prony","equilibrium_modulus":0,"arms":[]}})"),
      HasSubstr("the elastomer would have no force"));
}

TEST(SceneFile, SectionsMayStandInsideSections) {
  const Scene scene = readScene(
      R"({"elastomer":{"temperature":320,"shift":{"c1":5,"c2":120,"reference_temperature":300}}})",
      "s.json", {}, {"elastomer.shift.c1=6"});
  EXPECT_EQ(scene.elastomer.shift, (TemperatureShift{6, 120, 300}));
  EXPECT_EQ(readScene(writeScene(scene), "t.json"), scene);
  EXPECT_THAT(errorOfScene(R"({"elastomer":{"shift":{"c3":5}}})"),
              HasSubstr("elastomer.shift.c3: unknown key"));
  EXPECT_THAT(errorOfScene(R"({"elastomer":{"shift":5}})"),
              HasSubstr("elastomer.shift: needs an object"));
  EXPECT_THAT(errorOfScene(R"({"elastomer":{"rheology":"elastic","temperature":300}})"),
              HasSubstr("elastomer.temperature: has no meaning"));
  EXPECT_THAT(errorOfScene(R"({"elastomer":{"temperature":100}})"),
              HasSubstr("elastomer.temperature: 100 K is not above 196.55 K"));
}

TEST(SceneFile, EffectsThatExcludeEachOtherAreRefused) {
  EXPECT_THAT(errorOfScene(R"({"interface":{"friction_coefficient":0.1,"shear_stress":1}})"),
              HasSubstr("interface.shear_stress: cannot be combined"));
  EXPECT_THAT(errorOfScene(R"({"elastomer":{"rheology":"prony"},"accuracy":{"scheme":"nodal"}})"),
              HasSubstr("accuracy.scheme: nodal is the paper's rule"));
}

TEST(SceneFile, ErrorsNameFileKeyAndWhatIsAllowed) {
  EXPECT_EQ(errorOfScene(R"({"surface":{"hurst":1.4}})"),
            "s.json: surface.hurst: 1.4 is outside 0 to 1");
  EXPECT_EQ(errorOfScene(R"({"surface":{"hurts":0.4}})"),
            "s.json: surface.hurts: unknown key; the nearest known one is surface.hurst");
  EXPECT_THAT(errorOfScene(R"({"elastomer":{"shear_modulus":-1e7}})"),
              HasSubstr("s.json: elastomer.shear_modulus: -10000000 is outside 1e-6 to 1e15 Pa"));
  EXPECT_THAT(errorOfScene(R"({"load":{"normal_force":"much"}})"),
              HasSubstr("s.json: load.normal_force: 'much' is not a number"));
  EXPECT_THAT(errorOfScene(R"({"surface":{"hurst":NaN}})"), HasSubstr("s.json: is not valid JSON"));
  EXPECT_THAT(errorOfScene(R"({"surface":{"hurst":1e999}})"),
              HasSubstr("s.json: is not valid JSON"));
  EXPECT_THAT(errorOfScene(R"({"surface":{"radius":1}})"),
              HasSubstr("has no meaning for surface.kind self_affine; it belongs to parabola"));
  EXPECT_THAT(errorOfScene(R"({"surface":{"hurst":[1]}})"),
              HasSubstr("a list is not allowed here"));
  EXPECT_THAT(errorOfScene(R"({"surface":3})"), HasSubstr("s.json: surface: needs an object"));
  EXPECT_THAT(errorOfScene(R"({"surfce":{}})"), HasSubstr("s.json: surfce: unknown key"));
  EXPECT_EQ(errorOfScene(R"({"surfce":{"hurst":0.5}})"),
            "s.json: surfce: unknown key; the nearest known one is surface");
  EXPECT_EQ(errorOfScene(R"({"elastomer":{"shft":{"c1":1}}})"),
            "s.json: elastomer.shft: unknown key; the nearest known one is elastomer.shift");
  EXPECT_THAT(errorOfScene(R"({"hurst":0.5})"), HasSubstr("nearest known one is surface.hurst"));
  EXPECT_THAT(errorOfScene(R"({"surface.hurst":0.5})"), HasSubstr("inside its section's object"));
  EXPECT_THAT(errorOfScene(R"({"schema":"asperity-scene/2"})"),
              HasSubstr("is not asperity-scene/1"));
  EXPECT_THAT(errorOfScene(R"({"schema":5})"), HasSubstr("schema: 5 is not asperity-scene/1"));
  EXPECT_THAT(errorOfScene(R"({"surface":{"hurst":0.1,"hurst":0.2}})"),
              HasSubstr("s.json: surface.hurst: occurs twice"));
  EXPECT_THAT(
      errorOfScene("{\"schema\":" + std::string(400000, '[') + std::string(400000, ']') + "}"),
      HasSubstr("nested too deeply"));
  EXPECT_LT(errorOfScene("{\"" + std::string(500000, 'x') + "\":1}").size(), 200U);
  EXPECT_LT(errorOfScene("{\"surface\":{\"hurst\":\"" + std::string(500000, 'x') + "\"}}").size(),
            200U);
  EXPECT_THAT(errorOfScene(R"({"surface":{"kind":"profile"}})"),
              HasSubstr("surface.file: is missing"));
  EXPECT_THAT(errorOfScene(R"({"sweep":{"velocity_from":2,"velocity_to":1}})"),
              HasSubstr("is above sweep.velocity_to"));
  EXPECT_THAT(errorOfScene("[]"), HasSubstr("a scene is one JSON object"));
  EXPECT_THAT(errorOfScene("{"), HasSubstr("is not valid JSON"));
}

/// What is no attempt at JSON is not quoted: its kind is said, and what is needed instead.
TEST(SceneFile, FilesOfAnotherKindAreNamed) {
  const std::string needed =
      "; a scene is JSON in UTF-8; a measured surface is a file that a scene names as "
      "surface.file, with surface.kind measured";
  EXPECT_EQ(errorOfScene(""), "s.json: is an empty file" + needed);
  EXPECT_EQ(errorOfScene(" \n"), "s.json: is an empty file" + needed);
  EXPECT_EQ(errorOfScene("0,1e-6\n1,2e-6\n"), "s.json: is text that is not JSON" + needed);
  EXPECT_EQ(errorOfScene("\xFF\xFEx\r\n"), "s.json: is text in UTF-16" + needed);
  EXPECT_EQ(errorOfScene(std::string("{\0}\0", 4)), "s.json: is text in UTF-16" + needed);
  EXPECT_EQ(errorOfScene("\x89PNG\r\n"), "s.json: is a PNG picture" + needed);
  EXPECT_EQ(errorOfScene("\xEF\xBB\xBF{}"), "no error");
  EXPECT_THAT(errorOfScene("3"), HasSubstr("a scene is one JSON object"));
}

/// As deep as a scene's own keys and lists go, and not a level further: the parser of what follows
/// may call itself for each level.
/// With nobody at the other end, reading a pipe would wait for ever.
TEST(SceneFile, APipeIsRefusedAtOnce) {
  const TemporaryFolder folder;
  const std::filesystem::path pipe = folder / "pipe.json";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  try {
    readSceneFile(pipe);
    FAIL() << "was read";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("pipe.json"));
    EXPECT_THAT(error.what(), HasSubstr("only regular files"));
  }
}

TEST(SceneFile, NestingHasALimit) {
  const auto nested = [](int levels) {
    std::string text = "1";
    for (int i = 0; i < levels; ++i) text = "{\"a\":" + text + "}";
    return errorOfScene(text);
  };
  constexpr int kDeepest = 8;
  EXPECT_THAT(nested(kDeepest), HasSubstr("unknown key"));
  EXPECT_THAT(nested(kDeepest + 1), HasSubstr("is nested too deeply"));
  EXPECT_THAT(nested(100), HasSubstr("is nested too deeply"));
}

TEST(SceneFile, ErrorsAreOneLine) {
  for (const char* bad : {"{", "{\n\n\"a\"", "{\"a\\n\":1}", "\xff\xfe", "{\"title\":\"\x01\"}"})
    EXPECT_EQ(errorOfScene(bad).find('\n'), std::string::npos) << errorOfScene(bad);
}

TEST(SceneFile, AssignmentsAreAppliedOverTheFileInOrder) {
  const Scene scene = readScene(R"({"load":{"normal_force":1}})", "s.json", {},
                                {"load.normal_force=2", "load.normal_force=3", "title=a=b"});
  EXPECT_EQ(scene.load.normalForce, 3);
  EXPECT_EQ(scene.title, "a=b");
  EXPECT_THAT(errorOfScene("{}", {"load.normal_force"}), HasSubstr("is not KEY=VALUE"));
  EXPECT_THAT(errorOfScene("{}", {"load.force=1"}), HasSubstr("unknown key"));
  EXPECT_THAT(errorOfScene("{}", {"load.normal_force=nan"}), HasSubstr("not a finite number"));
  EXPECT_THAT(errorOfScene("{}", {"surface.radius=1"}), HasSubstr("has no meaning"));
}

TEST(SceneFile, AssignmentsTakeUnits) {
  const Scene scene = readScene("{}", "s.json", {},
                                {"load.normal_force=20mN", "elastomer.temperature=25 \u00B0C",
                                 "accuracy.target_relative_error=1%"});
  EXPECT_EQ(scene.load.normalForce, 0.02);
  EXPECT_DOUBLE_EQ(scene.elastomer.temperature, 298.15);
  EXPECT_EQ(scene.accuracy.targetRelativeError, 0.01);
  EXPECT_EQ(errorOfScene("{}", {"load.normal_force=20mm"}),
            "s.json: load.normal_force: 20mm is a length; expected a force, such as 3.4 mN");
}

TEST(SceneFile, AnAssignedKindDropsTheKeysItMakesMeaningless) {
  const std::string file = R"({"surface":{"kind":"self_affine","hurst":0.3,"length":0.1}})";
  const Scene scene = readScene(file, "s.json", {}, {"surface.kind=sine", "surface.waves=3"});
  EXPECT_EQ(scene.surface.kind, SurfaceKind::Sine);
  EXPECT_EQ(scene.surface.waves, 3);
  EXPECT_EQ(scene.surface.length, 0.1);
}

TEST(SceneFile, ThePapersElementsHaveOnePointEach) {
  const std::string file = R"({"accuracy":{"scheme":"cubic","oversampling":4}})";
  const Scene nodal = readScene(file, "s.json", {}, {"accuracy.scheme=nodal"});
  EXPECT_EQ(pointsPerElement(nodal), 1);
  EXPECT_EQ(readScene(writeScene(nodal), "t.json"), nodal);
  EXPECT_EQ(errorOfScene(R"({"accuracy":{"scheme":"nodal","oversampling":1}})"), "no error");
  EXPECT_THAT(errorOfScene(R"({"accuracy":{"scheme":"nodal","oversampling":2}})"),
              HasSubstr("has no meaning for accuracy.scheme nodal"));
}

TEST(SceneFile, AProfileIsAsLongAsItsFileSaysUnlessTheSceneSaysSo) {
  const Scene left = readScene(R"({"surface":{"kind":"profile","file":"a.csv"}})", "s.json");
  EXPECT_EQ(left.surface.length, 0);
  EXPECT_EQ(left.surface.elements, 0);
  EXPECT_EQ(writeScene(left).find("length"), std::string::npos);
  const Scene given =
      readScene(R"({"surface":{"kind":"profile","file":"a.csv","length":0.5}})", "s.json");
  EXPECT_EQ(given.surface.length, 0.5);
}

TEST(SceneFile, FilesThatCannotBeReadAreNamed) {
  const TemporaryFolder folder;
  EXPECT_THROW(readSceneFile(folder / "none.json"), InputError);
  EXPECT_THROW(readSceneFile(folder.path()), InputError);
  const Scene scene = readSceneFile(folder.write("s.json", "{}"));
  EXPECT_EQ(scene.folder, folder.path());
}

TEST(SceneFile, ShippedScenesAreValid) {
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(ASPERITY_RESOURCES_DIR) + "/scenes"))
    if (entry.path().extension() == ".json") {
      Scene scene;
      EXPECT_NO_THROW(scene = readSceneFile(entry.path())) << entry.path();
      EXPECT_FALSE(scene.title.empty()) << entry.path();
      EXPECT_FALSE(scene.chapter.empty()) << entry.path();
      // Two sentences say what to look for.
      const auto& words = scene.description;
      std::size_t sentences = 0;
      for (std::size_t i = 0; i < words.size(); ++i)
        sentences += words[i] == '.' && (i + 1 == words.size() || words[i + 1] == ' ') &&
                             (i < 2 || words.substr(i - 2, 3) != "Eq.")
                         ? 1
                         : 0;
      EXPECT_EQ(sentences, 2U) << entry.path();
      // Who starts from it gets the chosen resolution. Simple shapes need no points between.
      const SurfaceKind kind = scene.surface.kind;
      const bool isSimple = kind == SurfaceKind::Parabola || kind == SurfaceKind::Wedge;
      EXPECT_EQ(scene.accuracy.oversampling, isSimple ? 1 : 0) << entry.path();
    }
}

}  // namespace
}  // namespace asperity
