// What has to be set over one scene to make another: every pair of shipped scenes, there and back.
#include "core/scene/scene_assignments.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "core/scene/scene_file.h"

namespace asperity {
namespace {

struct Text {
  std::string name, json;
  Scene scene;
};

std::vector<Text> shippedScenes() {
  std::vector<Text> scenes;
  for (const auto& entry : std::filesystem::directory_iterator(ASPERITY_RESOURCES_DIR "/scenes")) {
    std::ifstream in(entry.path());
    const std::string json(std::istreambuf_iterator<char>(in), {});
    scenes.push_back({entry.path().filename().string(), json, readScene(json, "scene")});
  }
  return scenes;
}

Scene changed(const std::string& json, const std::vector<std::string>& assignments) {
  return readScene(json, "scene", {}, assignments);
}

TEST(SceneAssignments, NothingIsSetOverTheSceneItself) {
  for (const Text& text : shippedScenes())
    EXPECT_TRUE(differingAssignments(text.scene, text.scene).empty()) << text.name;
}

TEST(SceneAssignments, MakeEverySceneOfEveryOther) {
  const std::vector<Text> scenes = shippedScenes();
  ASSERT_GE(scenes.size(), 25U);
  for (const Text& base : scenes)
    for (const Text& wanted : scenes)
      EXPECT_EQ(writeScene(changed(base.json, differingAssignments(base.scene, wanted.scene))),
                writeScene(wanted.scene))
          << base.name << " to " << wanted.name;
}

TEST(SceneAssignments, NameOnlyWhatDiffers) {
  Scene scene;
  scene.load.normalForce = 0.1;
  scene.surface.hurst = 0.25;
  EXPECT_EQ(differingAssignments(Scene{}, scene),
            (std::vector<std::string>{"surface.hurst=0.25", "load.normal_force=0.1"}));
}

/// One of the two is said, whichever the base has.
TEST(SceneAssignments, ATargetAndAResolutionTakeEachOthersPlace) {
  Scene target;
  target.accuracy.targetRelativeError = 0.01;
  Scene nodal;
  nodal.accuracy.scheme = Scheme::Nodal;
  nodal.accuracy.oversampling = 1;
  Scene fine;
  fine.accuracy.oversampling = 8;
  const std::vector<Scene> all{Scene{}, target, nodal, fine};
  for (const Scene& base : all)
    for (const Scene& wanted : all)
      EXPECT_EQ(writeScene(changed(writeScene(base), differingAssignments(base, wanted))),
                writeScene(wanted))
          << writeScene(base) << writeScene(wanted);
}

TEST(SceneAssignments, AProfileKeepsTheSizeOfItsFileAndIsLeftAgain) {
  Scene profile;
  profile.surface.kind = SurfaceKind::Profile;
  profile.surface.file = "a line, with = and \"quotes\".csv";
  profile.surface.length = 0;
  profile.surface.elements = 0;
  const std::vector<Scene> all{Scene{}, profile};
  for (const Scene& base : all)
    for (const Scene& wanted : all)
      EXPECT_EQ(writeScene(changed(writeScene(base), differingAssignments(base, wanted))),
                writeScene(wanted));
}

TEST(SceneAssignments, SeveralAreOneWordWhateverIsInThem) {
  for (const std::vector<std::string>& all : {std::vector<std::string>{"title=a"},
                                              {"title=a;b", "load.normal_force=1"},
                                              {"title=;;", "surface.file=C:\\x;y\\", "a=\\;"}})
    EXPECT_EQ(separatedAssignments(joinedAssignments(all)), all);
  EXPECT_EQ(separatedAssignments("title=a\\b;seed=1"),
            (std::vector<std::string>{"title=a\\b", "seed=1"}));
}

TEST(SceneAssignments, NumbersKeepEveryDigit) {
  Scene scene;
  scene.load.normalForce = 0.1 + 0.2;
  scene.surface.seed = (std::int64_t{1} << 53) - 1;
  const Scene back = changed("{}", differingAssignments(Scene{}, scene));
  EXPECT_EQ(back.load.normalForce, scene.load.normalForce);
  EXPECT_EQ(back.surface.seed, scene.surface.seed);
}

}  // namespace
}  // namespace asperity
