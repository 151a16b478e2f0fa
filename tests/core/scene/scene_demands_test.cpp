// What a scene in another person's picture asks for.
#include "core/scene/scene_demands.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/core/temporary_folder.h"

namespace asperity {
namespace {

class ForeignSceneTest : public testing::Test {
 protected:
  ForeignSceneTest() {
    std::filesystem::create_directories(folder / "pictures/data");
    folder.write("secret.csv", "1\n2\n3\n");
    folder.write("pictures/line.csv", "1\n2\n3\n");
    folder.write("pictures/data/line.csv", "1\n2\n3\n");
    std::filesystem::create_symlink(folder / "secret.csv", folder / "pictures/link.csv");
  }

  /// Whether the scene in a picture of the folder "pictures" is asked about.
  bool asksFor(const std::string& profile) {
    Scene scene;
    scene.folder = folder / "pictures";
    scene.surface.kind = SurfaceKind::Profile;
    scene.surface.file = profile;
    scene.surface.elements = 0;
    return !sceneDemands(scene).file.empty();
  }

  TemporaryFolder folder;
};

TEST_F(ForeignSceneTest, FilesBesideThePictureAreReadUnasked) {
  for (const char* file : {"line.csv", "./line.csv", "data/line.csv", "data/../line.csv",
                           "gone.csv", "../pictures/line.csv"})
    EXPECT_FALSE(asksFor(file)) << file;
  EXPECT_FALSE(asksFor((folder / "pictures/line.csv").string()));
  EXPECT_FALSE(sceneDemands(Scene{}).any());
}

TEST_F(ForeignSceneTest, AllOtherFilesAreAskedAbout) {
  using std::literals::operator""s;
  for (const std::string& file :
       {"../secret.csv"s, "/etc/shadow"s, "data/../../secret.csv"s, "link.csv"s, "/dev/zero"s,
        "gone/../../secret.csv"s, "../pictures2/line.csv"s, "../secret.csv\0/../pictures/line.csv"s,
        "line.csv\0"s})
    EXPECT_TRUE(asksFor(file)) << file;
  EXPECT_TRUE(asksFor((folder / "secret.csv").string()));
}

TEST_F(ForeignSceneTest, MuchMemoryAndTimeAreAskedAbout) {
  Scene scene;
  scene.surface.elements = 16777216;
  scene.accuracy.oversampling = 4;
  scene.ensemble.realizations = 1;
  EXPECT_GT(sceneDemands(scene).memory, 3e9);
  scene.surface.elements = 100000;
  EXPECT_FALSE(sceneDemands(scene).any());
  scene.ensemble.realizations = 1000000;
  EXPECT_EQ(sceneDemands(scene).memory, 0);
  EXPECT_GT(sceneDemands(scene).seconds, kSecondsUnasked);
  // A profile has as many elements as its file has rows.
  scene = Scene{};
  scene.folder = folder.path();
  scene.surface.kind = SurfaceKind::Profile;
  scene.surface.file = "large.csv";
  scene.surface.elements = 0;
  std::filesystem::resize_file(folder.write("large.csv", ""), 250000000);
  EXPECT_GT(sceneDemands(scene).memory, 1e9);
}

}  // namespace
}  // namespace asperity
