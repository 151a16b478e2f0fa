#include "core/scene/scene_files.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/core/temporary_folder.h"

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

TEST(AbsoluteFiles, AreThoseOfTheScenesFolder) {
  const Scene absolute = withAbsoluteFiles(sceneWithFiles("../asphalt.sdf", "/elsewhere/mu.csv"));
  EXPECT_EQ(absolute.surface.file, "/measured/asphalt.sdf");
  EXPECT_EQ(absolute.comparison.data.front().file, "/elsewhere/mu.csv");
}

// A scene of the present folder has no name of a folder.
TEST(FilesRelativeToTheScene, ThePresentFolderIsOneToo) {
  Scene scene;
  scene.comparison.data = {{"mu.csv", {}}};
  const auto saved = [&scene](const std::filesystem::path& folder) {
    return withFilesRelativeTo(folder, scene).comparison.data.front().file;
  };
  EXPECT_EQ(saved(""), "mu.csv");
  EXPECT_EQ(saved("out"), "../mu.csv");
  EXPECT_EQ(saved("out/"), "../mu.csv");
}

TEST(FilesRelativeToTheScene, ShippedMaterialsKeepTheirName) {
  Scene scene = sceneWithFiles("asphalt.sdf", "mu.csv");
  scene.elastomer.material = "epdm_70";
  EXPECT_EQ(withFilesRelativeTo("/elsewhere", scene).elastomer.material, "epdm_70");
  EXPECT_EQ(withAbsoluteFiles(scene).elastomer.material, "epdm_70");
}

// The system follows the link before "..", so a name that ignores it leads to another place.
TEST(FilesRelativeToTheScene, NamesLeadToTheFilesFromALinkedFolder) {
  const TemporaryFolder root;
  std::filesystem::create_directories(root / "disk/results/today");
  std::filesystem::create_directory_symlink("disk/results/today", root / "out");
  root.write("mu.csv", "velocity,mu\n");
  Scene scene;
  scene.folder = root.path();
  scene.comparison.data = {{"mu.csv", {}}};
  const Scene saved = withFilesRelativeTo(root / "out", scene);
  const std::filesystem::path name = saved.comparison.data.front().file;
  EXPECT_TRUE(name.is_relative());
  EXPECT_TRUE(std::filesystem::equivalent((root / "out") / name, root / "mu.csv"));
}

// The folder of a project may link to the disk with its data.
TEST(FilesRelativeToTheScene, NamesBelowTheSceneKeepTheirLinks) {
  const TemporaryFolder root;
  std::filesystem::create_directories(root / "disk");
  std::filesystem::create_directory(root / "project");
  std::filesystem::create_directory_symlink("../disk", root / "project/data");
  root.write("disk/mu.csv", "velocity,mu\n");
  Scene scene;
  scene.folder = root / "project";
  scene.comparison.data = {{"data/mu.csv", {}}};
  EXPECT_EQ(withFilesRelativeTo(root / "project", scene).comparison.data.front().file,
            "data/mu.csv");
  EXPECT_EQ(nameInScene(scene, root / "project/data/mu.csv"), "data/mu.csv");
}

// A link beside the scene is the file's name there; what it leads to may change.
TEST(FilesRelativeToTheScene, FilesThatAreLinksKeepTheirName) {
  const TemporaryFolder root;
  root.write("mu_2.csv", "velocity,mu\n");
  std::filesystem::create_symlink("mu_2.csv", root / "mu.csv");
  Scene scene;
  scene.folder = root.path();
  scene.comparison.data = {{"mu.csv", {}}};
  EXPECT_EQ(withFilesRelativeTo(root / "out", scene).comparison.data.front().file, "../mu.csv");
}

}  // namespace
}  // namespace asperity
