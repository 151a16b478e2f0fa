// asperity open: the scene that made a file, back from it.
#include <gmock/gmock.h>

#include "tests/app/program.h"

namespace asperity {
namespace {

using OpenTest = ProgramTest;

/// Every kind of file that the program writes gives back its canonical scene.
TEST_F(OpenTest, FindsTheSceneInEveryFile) {
  const std::string set = " --set load.normal_force=0.07 --set surface.seed=9 ";
  ASSERT_EQ(program.run("curve s.json -o c.csv -o c.json" + set).status, 0);
  ASSERT_EQ(program.run("surface s.json -o l.csv -o l.json -o l.png" + set).status, 0);
  ASSERT_EQ(program.run("render s.json -o r.png --size 320x200" + set).status, 0);
  const std::string scene = program.run("open c.json --json").out;
  EXPECT_THAT(scene, testing::HasSubstr("\"normal_force\": 0.07"));
  for (const char* file : {"c.csv", "l.csv", "l.json", "l.png", "r.png"})
    EXPECT_EQ(program.run(std::string("open --json ") + file).out, scene) << file;
  EXPECT_EQ(program.run("open s.json --json" + set).out, scene);
  EXPECT_EQ(program.run("open c.csv --json --set surface.seed=1").out,
            program.run("open s.json --json --set load.normal_force=0.07").out);
}

/// The scene that comes back makes the same picture again, byte for byte.
TEST_F(OpenTest, TheSceneMakesTheSamePicture) {
  ASSERT_EQ(program.run("render s.json -o a.png --size 320x200").status, 0);
  program.folder.write("again.json", program.run("open a.png --json").out);
  ASSERT_EQ(program.run("render again.json -o b.png --size 320x200").status, 0);
  EXPECT_EQ(TemporaryFolder::read(program.folder / "a.png"),
            TemporaryFolder::read(program.folder / "b.png"));
}

TEST_F(OpenTest, RefusesWhatHoldsNoScene) {
  program.folder.write("other.png", "\x89PNG\r\n\x1A\n and so on");
  program.folder.write("empty.svg", "");
  expectRefused("open other.png --json", 2, "other.png: holds no scene");
  expectRefused("open empty.svg", 2, "empty.svg: holds no scene");
  expectRefused("open gone.pdf", 2, "gone.pdf: cannot be opened");
  expectRefused("open .", 2, "is a folder");
  expectRefused("open s.json --json --set load.normal_force=x", 2, "load.normal_force");
  expectRefused("open s.json", 1, "no display",
                "env -u DISPLAY -u WAYLAND_DISPLAY -u QT_QPA_PLATFORM");
}

}  // namespace
}  // namespace asperity
