#include "ui/panels/scene_files.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

Scene sceneWithFiles(const std::string& surface, const std::string& table) {
  Scene scene;
  scene.folder = "/measured/scenes";
  scene.surface.kind = SurfaceKind::Measured;
  scene.surface.file = surface;
  scene.comparison.data = {{table, {}}};
  return scene;
}

// A folder with a scene and its files can be moved or sent as a whole.
TEST(FilesRelativeToTheScene, FilesBesideItOrBelowHaveRelativeNames) {
  const Scene scene =
      sceneWithFiles("/measured/tyre/asphalt.sdf", "/measured/tyre/friction/mu.csv");
  const Scene saved = withFilesRelativeTo("/measured/tyre", scene);
  EXPECT_EQ(saved.surface.file, "asphalt.sdf");
  EXPECT_EQ(saved.comparison.data.front().file, "friction/mu.csv");
}

TEST(FilesRelativeToTheScene, AbsoluteNamesOfFilesElsewhereStay) {
  const Scene scene = sceneWithFiles("/instrument/asphalt.sdf", "/measured/tyre2/mu.csv");
  const Scene saved = withFilesRelativeTo("/measured/tyre", scene);
  EXPECT_EQ(saved.surface.file, "/instrument/asphalt.sdf");
  EXPECT_EQ(saved.comparison.data.front().file, "/measured/tyre2/mu.csv");
}

TEST(FilesRelativeToTheScene, RelativeNamesFollowTheScene) {
  const Scene scene = sceneWithFiles("../asphalt.sdf", "mu.csv");
  const Scene saved = withFilesRelativeTo("/measured/scenes/a", scene);
  EXPECT_EQ(saved.surface.file, "../../asphalt.sdf");
  EXPECT_EQ(saved.comparison.data.front().file, "../mu.csv");
}

}  // namespace
}  // namespace asperity
