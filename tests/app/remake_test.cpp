// Options of figures in the program, and files that are made again from themselves.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/app/program.h"

namespace asperity {
namespace {

using testing::HasSubstr;

using RemakeTest = ProgramTest;

TEST_F(RemakeTest, EveryKindOfFileIsTheSameAgain) {
  const std::vector<std::pair<std::string, std::string>> made{
      {"a.csv", "curve s.json -o a.csv -o a.png --columns mu,velocity --size 400x300"},
      {"a.png", ""},
      {"a.json", "curve s.json -o a.json --with load.normal_force=0.01"},
      {"b.svg", "curve s.json -o b.svg --style journal --legend below --labels 'x=the speed'"},
      {"c.pdf", "curve s.json -o c.pdf --size 86mmx60mm --title 'A: b, c' --regions off --law off"},
      {"d.png", "render s.json -o d.png --size 320x200 --probe 0.01 --theme paper --title none"},
      {"e.csv", "render s.json -o e.csv --table contacts"},
      {"f.json", "render s.json -o f.json --table gaps --columns start,length"},
      {"g.csv", "surface s.json -o g.csv --table spectrum"},
      {"h.png", "surface s.json -o h.png --size 480x360 --language de"},
      {"i.csv",
       "motion s.json --set sliding.kind=start --set sliding.duration=1e-3 -o i.csv "
       "--every 7"},
      {"l.csv",
       "map s.json --x load.normal_force=1mN:1N:3 --y surface.hurst=0.9:0.3:2:linear -o l.csv -o "
       "l.png --show contact_fraction --size 500x400"},
      {"l.png", ""},
      {"n.pdf",
       "map s.json --size 86mmx60mm --y load.normal_force=1mN:1N:3 --x surface.hurst=0.3:0.9:2 "
       "-o n.pdf"},
      {"j.csv", "curve s.json --realizations-table j.csv"},
      {"k.gif", "render s.json -o k.gif --frames 3 --size 160x160"},
      {"figure_2.csv", "figure 2 -o . --realizations 2 --set sweep.points=3 --font-size 9"},
      {"figure_2.svg", ""}};
  for (const auto& [file, arguments] : made) {
    if (file.ends_with(".gif") && std::system("command -v ffmpeg >/dev/null") != 0) continue;
    if (!arguments.empty()) run(arguments);
    const std::string again = "again" + file.substr(file.rfind('.'));
    run("open " + file + " --remake -o " + again + " --quiet");
    EXPECT_EQ(read(again), read(file)) << file;
    EXPECT_FALSE(read(again).empty());
  }
}

TEST_F(RemakeTest, OptionsAreReplaced) {
  run("curve s.json -o a.png --size 400x300 --theme dark");
  run("open a.png --remake -o b.png --size 500x400");
  run("curve s.json -o c.png --theme dark --size 500x400");
  EXPECT_EQ(read("b.png").substr(0, 40), read("c.png").substr(0, 40));
  run("open a.png --remake --set load.normal_force=0.01");  // in its own place
  const auto scene = nlohmann::json::parse(program.run("open a.png --json").out);
  EXPECT_EQ(scene["load"]["normal_force"], 0.01);
  run("open a.png --remake -o a.csv");
  EXPECT_THAT(read("a.csv"), HasSubstr("velocity,mu"));
}

TEST_F(RemakeTest, RefusesWhatCannotBeRemade) {
  program.folder.write(
      "old.csv", "# asperity: {\"schema\":\"asperity-curve/1\",\"verb\":\"curve\",\"scene\":" +
                     std::string(kScene) + "}\nvelocity,mu\n");
  expectRefused("open old.csv --remake", 2, "does not say the options that made it");
  program.folder.write(
      "window.csv", "# asperity: {\"schema\":\"asperity-motion/1\",\"verb\":\"motion\",\"scene\":" +
                        std::string(kScene) + "}\ntime,mu\n");
  expectRefused("open window.csv --remake", 2, "'asperity motion' makes a new one of its scene");
  expectRefused("open s.json --remake", 2, "is a scene");
  expectRefused("open s.json --size 5x5", 2, "unknown option");
  expectRefused("open s.json -o x.png", 2, "--output: applies only with --remake");
  program.folder.write("e.json", program.run("explain s.json --json").out);
  expectRefused("open e.json --remake", 2,
                "is a result of the kind 'explain', which cannot be remade");
}

TEST_F(RemakeTest, SizesOnPaper) {
  run("curve s.json -o a.svg --size 86mmx60mm");
  EXPECT_THAT(read("a.svg"), HasSubstr("width=\"86"));
  EXPECT_THAT(read("a.svg").substr(0, 200), HasSubstr("mm\""));
  run("curve s.json -o a.png --size 86mmx60mm --dpi 150");
  const auto side = [&](std::size_t at) {
    const std::string png = read("a.png");
    return (static_cast<unsigned char>(png[at]) << 8) + static_cast<unsigned char>(png[at + 1]);
  };
  EXPECT_EQ(side(18), 508);  // 86 mm at 150 dpi
  EXPECT_EQ(side(22), 354);
  expectRefused("curve s.json -o a.png --size 5mmx5mm", 2, "160 to 16384 each are allowed");
  expectRefused("curve s.json -o a.png --size 86mmx60mm --dpi 9600", 2, "--dpi: 9600 is outside");
  expectRefused("curve s.json -o a.png --dpi 300 --scale 2", 2, "cannot be combined with --dpi");
  expectRefused("curve s.json -o a.csv --legend none", 2, "--legend: belongs to pictures");
  expectRefused("curve s.json -o a.png --style nothing", 2, "--style: 'nothing' is neither");
  expectRefused("render s.json -o a.png --legend none", 2, "--legend: applies only to charts");
  expectRefused("surface s.json -o a.png --regions off", 2, "--regions: unknown option");
  expectRefused("curve s.json -o a.png --labels seven=x", 2, "--labels: 'seven' is neither");
}

TEST_F(RemakeTest, ManyScenesAreCheckedAndStandardInputIsRead) {
  program.folder.write("bad.json", R"({"surface": {"hurst": 2}})");
  const Said said = program.run("check s.json bad.json figure_1.json");
  EXPECT_EQ(said.status, 2);
  EXPECT_THAT(said.out, testing::AllOf(HasSubstr("s.json: "), HasSubstr("figure_1.json: ")));
  EXPECT_THAT(said.err, HasSubstr("bad.json: surface.hurst"));
  const auto json = nlohmann::json::parse(program.run("check s.json figure_1.json --json").out);
  EXPECT_EQ(json.size(), 2U);
  EXPECT_GT(json[0]["derived"]["dimensionless_force"], 0);
  EXPECT_EQ(program.run("curve - <s.json").status, 0);
}

TEST_F(RemakeTest, CompletionsNameCommandsOptionsAndKeys) {
  for (const std::string shell : {"bash", "zsh", "fish"}) {
    const std::string script = program.run("--completions " + shell).out;
    EXPECT_THAT(script, HasSubstr("curve"));
    EXPECT_THAT(script, HasSubstr("realizations-table"));
    EXPECT_THAT(script, HasSubstr("load.normal_force"));
    program.folder.write("script", script);
    if (shell == "bash") {
      const std::string check = "bash -n '" + (program.folder / "script").string() + "'";
      EXPECT_EQ(std::system(check.c_str()), 0);
    }
  }
  expectRefused("--completions csh", 2, "csh is not one of bash, zsh, fish");
}

TEST_F(RemakeTest, KeysHaveTheirOwnHelp) {
  const std::string all = program.run("curve --help keys").out;
  EXPECT_THAT(all, HasSubstr("load.normal_force"));
  EXPECT_EQ(program.run("--help keys").out, all);
  EXPECT_THAT(program.run("curve --help").out, HasSubstr("asperity curve --help keys"));
}

}  // namespace
}  // namespace asperity
