// Files out of folders of outputs that are made again from themselves: fit, material, study, batch,
// accuracy; what they were made from, when it is elsewhere, changed or gone.
#include <gmock/gmock.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "core/base/embedded_provenance.h"
#include "tests/app/program.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
using Json = nlohmann::json;
namespace fs = std::filesystem;

constexpr const char* kFriction =
    "velocity,mu,mu_error\n0.001,4.6e-5,4e-6\n0.01,4.4e-4,2e-5\n"
    "0.1,1.9e-3,1e-4\n1,2.4e-3,1e-4\n";

/// Two arms at 20 °C, and a decade slower at 10 °C.
std::string moduli() {
  std::string text = "f (Hz),T (C),G' (MPa),G'' (MPa)\n";
  for (const double shift : {0.0, 1.0})
    for (int i = 0; i <= 20; ++i) {
      const double frequency = std::pow(10, -1.5 + 0.15 * i);
      double storage = 1, loss = 0;
      for (const auto& [modulus, time] : {std::pair(2.0, 0.3), std::pair(3.0, 0.002)}) {
        const double turn = 2 * M_PI * frequency * std::pow(10, shift) * time;
        storage += modulus * turn * turn / (1 + turn * turn);
        loss += modulus * turn / (1 + turn * turn);
      }
      text += std::to_string(frequency) + (shift > 0 ? ",10," : ",20,") + std::to_string(storage) +
              "," + std::to_string(loss) + "\n";
    }
  return text;
}

constexpr const char* kStudyOfScene =
    R"({"schema":"asperity-study/1","title":"Small","scene":"s.json","chunk":8,)"
    R"("set":{"ensemble.realizations":1},"space":{"load.normal_force":{"from":0.001,"to":1},)"
    R"("surface.hurst":{"from":0.3,"to":0.9}},"sampling":"saltelli","samples":8,"seed":1,)"
    R"("outputs":["mu","contact_fraction"]})";

class RemakeFolderTest : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    program.folder.write("data.csv", kFriction);
    program.folder.write("dma.csv", moduli());
    program.folder.write("study.json", kStudyOfScene);
    // Temporary folders are made here, so that what is left is seen.
    fs::create_directory(program.folder / "tmp");
  }
  Said remake(const std::string& arguments) const {
    const std::string place = (program.folder / "tmp").string();
    const Said said = program.run("open --remake " + arguments, "TMPDIR='" + place + "'");
    for (const std::string& name : program.folder.names("tmp"))
      EXPECT_THAT(name, Not(HasSubstr("asperity"))) << arguments;
    return said;
  }
  void run(const std::string& arguments, int status = 0) const {
    const Said said = program.run(arguments);
    EXPECT_EQ(said.status, status) << arguments << "\n" << said.err;
  }
  void expectSame(const std::string& file) const {
    SCOPED_TRACE(file);
    const std::string again = "again" + file.substr(file.rfind('.'));
    const Said said = remake(file + " -o " + again + " --quiet");
    EXPECT_EQ(said.status, 0) << said.err;
    EXPECT_EQ(said.out + said.err, "");
    EXPECT_FALSE(read(again).empty());
    EXPECT_TRUE(read(again) == read(file));
    fs::remove(program.folder / again);
  }
  /// Every file of the folder but these.
  void expectAllSame(const std::string& folder, const std::set<std::string>& others = {}) const {
    int count = 0;
    for (const std::string& name : program.folder.names(folder))
      if (!others.contains(name)) {
        expectSame(folder + "/" + name);
        ++count;
      }
    EXPECT_GT(count, 0);
  }
  std::string fitCommand() const {
    return "fit s.json --data data.csv --vary surface.rms_height=10nm:1mm ";
  }
};

TEST_F(RemakeFolderTest, EveryFileOfAFitIsTheSameAgain) {
  run(fitCommand() + "--size 700x500 --columns mu,velocity --language de -o fit");
  expectAllSame("fit", {"fitted.scene.json"});
  // It opens as the fitted scene, and says the one that was fitted.
  const Json fit = Json::parse(read("fit/fit.json"));
  EXPECT_EQ(fit["start"]["surface"]["rms_height"],
            Json::parse(program.run("open s.json --json").out)["surface"]["rms_height"]);
  EXPECT_EQ(fit["scene"]["surface"]["rms_height"], fit["fit"]["parameters"][0]["value"]);
  EXPECT_NE(fit["scene"]["surface"]["rms_height"], fit["start"]["surface"]["rms_height"]);
  EXPECT_EQ(fit["options"]["vary"], "surface.rms_height=10nm:1mm");
  expectRefused("open fit/fitted.scene.json --remake", 2, "is a scene, not a result");
}

TEST_F(RemakeFolderTest, OptionsOfAFitAreReplaced) {
  run(fitCommand() + "--no-profiles -o fit");
  run("fit s.json --data data.csv --vary elastomer.relaxation_time --no-profiles --set "
      "surface.hurst=0.7 --size 800x600 -o other");
  const std::string anew = " --vary elastomer.relaxation_time --set surface.hurst=0.7 ";
  EXPECT_EQ(remake("fit/fit.json -o a.json" + anew).status, 0);
  EXPECT_EQ(read("a.json"), read("other/fit.json"));
  EXPECT_EQ(remake("fit/curve.png -o a.svg --size 800x600" + anew).status, 0);
  EXPECT_EQ(read("a.svg"), read("other/curve.svg"));
  EXPECT_EQ(remake("fit/fit.json -o a.csv").status, 0);
  EXPECT_EQ(read("a.csv"), read("fit/fit.csv"));
  const Said table = remake("fit/fit.csv -o - --columns velocity,mu");
  EXPECT_THAT(table.out, AllOf(StartsWith("# asperity: "), HasSubstr("\nvelocity,mu\n")));
  // In its own place it is replaced.
  EXPECT_THAT(remake("fit/fit.csv" + anew).out, HasSubstr("wrote fit/fit.csv"));
  EXPECT_EQ(read("fit/fit.csv"), read("other/fit.csv"));
}

TEST_F(RemakeFolderTest, WhatTheNewFileCannotBeIsOneLine) {
  run(fitCommand() + "--no-profiles -o fit");
  program.folder.write("kept.csv", "mine");
  expectRefused("open fit/curve.png --remake -o kept.csv", 2, "'.csv' is not one of .png, .svg");
  expectRefused("open fit/fit.csv --remake -o fit.png", 2, "'.png' is not one of .csv, .json");
  expectRefused("open fit/fit.csv --remake -o data.csv", 2, "is also an input file");
  expectRefused("open fit/curve.png --remake -o none/c.png", 2, "none");
  expectRefused("open fit/fit.csv --remake --size 500x400", 2, "--size: belongs to pictures");
  expectRefused("open fit/curve.png --remake --columns mu", 2, "--columns: belongs to tables");
  expectRefused("open fit/curve.png --remake --tables", 2, "unknown option of 'asperity fit'");
  expectRefused("open fit/curve.png --remake --from none", 2, "--from: none is not a folder");
  expectRefused("open s.json --from .", 2, "--from: applies only with --remake");
  EXPECT_EQ(read("kept.csv"), "mine");
  EXPECT_EQ(read("data.csv"), kFriction);
}

TEST_F(RemakeFolderTest, InputsAreFoundOrNamed) {
  run(fitCommand() + "--no-profiles -o deep/er/fit");
  expectSame("deep/er/fit/fit.json");
  // A file of the same name is not it, as long as the right one can be found.
  program.folder.write("deep/er/data.csv", "velocity,mu\n1,0.2\n2,0.3\n3,0.3\n");
  expectSame("deep/er/fit/curve.pdf");
  fs::create_directory(program.folder / "away");
  fs::rename(program.folder / "data.csv", program.folder / "away/data.csv");
  expectRefused("open deep/er/fit/fit.csv --remake", 2,
                "comparison.data: data.csv: it is another file now");
  fs::remove(program.folder / "deep/er/data.csv");
  expectRefused("open deep/er/fit/fit.csv --remake", 2,
                "comparison.data: data.csv, from which it was made, is not there");
  EXPECT_EQ(remake("deep/er/fit/fit.csv -o a.csv --from away").status, 0);
  EXPECT_EQ(read("a.csv"), read("deep/er/fit/fit.csv"));
  program.folder.write("data.csv", std::string(kFriction) + "2,2.3e-3,1e-4\n");
  expectRefused("open deep/er/fit/curve.png --remake", 2, "it is another file now");
}

/// The same for commands that write one file.
TEST_F(RemakeFolderTest, SurfaceFilesAreFoundOrNamed) {
  std::string profile = "position,height\n";
  for (int i = 0; i < 200; ++i)
    profile += std::to_string(1e-6 * i) + "," + std::to_string(1e-6 * std::sin(0.2 * i)) + "\n";
  program.folder.write("line.csv", profile);
  fs::create_directory(program.folder / "out");
  run("surface line.csv -o out/s.csv -o out/s.png --size 400x400");
  expectAllSame("out");
  program.folder.write("line.csv", profile + "0.0002,0\n");
  expectRefused("open out/s.csv --remake", 2, "surface.file: line.csv: it is another file now");
  fs::remove(program.folder / "line.csv");
  expectRefused("open out/s.png --remake", 2, "surface.file: line.csv, from which it was made");
}

TEST_F(RemakeFolderTest, EveryFileOfAMaterialIsTheSameAgain) {
  run("material dma.csv --name 'My rubber' --source 'a book, p. 7' --terms 5 --vertical-shifts "
      "--columns frequency,storage_modulus --style journal -o rubber");
  expectAllSame("rubber");
  run("material dma.csv --terms 4 --name 'My rubber' -o other --size 400x300");
  EXPECT_EQ(remake("rubber/material.json -o a.json --terms 4 --source x").status, 0);
  EXPECT_THAT(read("a.json"),
              AllOf(HasSubstr("\"source\": \"x\""), HasSubstr("\"--terms\": \"4\"")));
  expectRefused("open rubber/prony.csv --remake --set load.normal_force=1", 2, "--set: sets keys");
  program.folder.write("dma.csv", moduli() + "1000,20,6,0.1\n");
  expectRefused("open rubber/master_curve.png --remake", 2,
                "FILE: dma.csv: it is another file now");
  expectRefused("open rubber/material.json --remake", 2, "FILE: dma.csv: it is another file now");
  fs::remove(program.folder / "dma.csv");
  expectRefused("open rubber/prony.csv --remake", 2, "FILE: dma.csv, from which it was made");
}

TEST_F(RemakeFolderTest, AMaterialInASceneIsTheSameAgain) {
  run("material dma.csv -o rubber");
  program.folder.write("m.json", R"({"surface":{"elements":200},"elastomer":{"material":)"
                                 R"("rubber/material.json","temperature":293.15}})");
  run("material m.json -o used --size 600x400");
  expectAllSame("used");
  run("material m.json -o faster --size 600x400 --set sliding.velocity=3");
  EXPECT_EQ(remake("used/excitation.csv -o a.csv --set sliding.velocity=3").status, 0);
  EXPECT_EQ(read("a.csv"), read("faster/excitation.csv"));
}

TEST_F(RemakeFolderTest, EveryFileOfAStudyIsTheSameAgain) {
  run("study run study.json -o runs --quiet");
  run("study table runs -o t.csv -o t.json --shape long --quiet");
  run("study table runs -o w.csv --quiet");
  run("study analyse runs -o analysis --size 700x500 --quiet");
  for (const char* file : {"t.csv", "t.json", "w.csv"}) expectSame(file);
  expectAllSame("analysis");
  EXPECT_EQ(remake("w.csv -o again.csv --shape long").status, 0);
  EXPECT_EQ(read("again.csv"), read("t.csv"));
  // The store may have another name, and does not stand in the file.
  fs::create_directory(program.folder / "away");
  fs::rename(program.folder / "runs", program.folder / "away/renamed");
  expectRefused("open analysis/percentiles.csv --remake", 2, "--from: the store of its study is");
  EXPECT_EQ(remake("w.csv -o b.csv --from away").status, 0);
  EXPECT_EQ(remake("w.csv -o c.csv --from away/renamed").status, 0);
  EXPECT_EQ(read("b.csv"), read("w.csv"));
  EXPECT_EQ(read("c.csv"), read("w.csv"));
  expectRefused("open w.csv --remake --from s.json", 2, "s.json: is not the store of a study");
  expectRefused("open w.csv --remake --from away/renamed -o away/renamed", 2,
                "is also an input file");
  expectRefused("open w.csv --remake --from away --set surface.hurst=0.5", 2, "--set: sets keys");
  std::string other = kStudyOfScene;
  program.folder.write("study.json",
                       other.replace(other.find("\"samples\":8"), 11, "\"samples\":4"));
  run("study run study.json -o other --quiet");
  expectRefused("open w.csv --remake --from other", 2, "is not the store of the study of w.csv");
}

TEST_F(RemakeFolderTest, AStoreThatWentOnIsNamed) {
  run("study run study.json -o half --shard 1/2 --quiet");
  run("study table half -o t.csv --quiet");
  // A shard with as many other simulations is not it.
  run("study run study.json -o rest --shard 2/2 --quiet");
  run("study merge half rest -o all --quiet");
  EXPECT_EQ(remake("t.csv -o again.csv").status, 0);
  EXPECT_EQ(read("again.csv"), read("t.csv"));
  fs::remove(program.folder / "again.csv");
  expectRefused("open t.csv --remake --from rest", 2,
                "rest: has other simulations than t.csv was made from");
  fs::remove(program.folder / "half");
  fs::remove(program.folder / "rest");
  expectRefused("open t.csv --remake", 2,
                "all: has 32 simulations now, and t.csv was made from 16");
}

TEST_F(RemakeFolderTest, EveryFileOfABatchIsTheSameAgain) {
  program.folder.write("b.json",
                       R"({"schema": "asperity-batch/1", "title": "Two & more", "size": "500x450",
      "entries": [{"name": "grid", "scene": "s.json", "set": {"sweep.points": 3},
                   "sweep": {"load.normal_force": {"from": 0.01, "to": 1, "points": 2},
                             "surface.hurst": [0.4, 0.8]}},
                  {"name": "still", "scene": {"surface": {"kind": "sine"}}, "show": "contact"},
                  {"name": "moving", "scene": "s.json", "set": {"sliding.kind": "start",
                   "sliding.duration": 1e-3}}]})");
  run("batch b.json -o out --language de --theme dark --columns mu,name --quiet");
  std::set<std::string> scenes{"index.html", "moving.json", "still.json"};
  for (const char* name : {"1", "2", "3", "4"})
    scenes.insert(std::string("grid_0") + name + ".json");
  expectAllSame("out", scenes);
  expectRefused("open out/index.html --remake", 2, "holds no scene");
  expectRefused("open out/still.json --remake", 2, "is a scene, not a result");
  expectRefused("open out/results.csv --remake --set surface.hurst=0.5", 2, "--set: sets keys");
  // With another force, and the title that says it.
  EXPECT_EQ(remake("out/grid_03.png -o a.png --set load.normal_force=20mN --language en").status,
            0);
  EXPECT_THAT(embeddedProvenance(read("a.png")), HasSubstr("20 mN"));
  expectRefused("open out/grid_03.png --remake -o a.svg", 2, "'.svg' is not one of .png");
}

TEST_F(RemakeFolderTest, ScenesThatFailedStayInTheTable) {
  program.folder.write("b.json", R"({"schema": "asperity-batch/1", "size": "400x400", "entries": [
      {"name": "good", "scene": "s.json", "show": "contact"},
      {"name": "gone", "scene": "gone.json"}]})");
  run("batch b.json -o out --quiet", 1);
  for (const std::string file : {"out/results.csv", "out/contact_sheet.png"}) {
    const Said said = remake(file + " -o again" + file.substr(file.rfind('.')) + " --quiet");
    EXPECT_EQ(said.status, 1) << file;
    EXPECT_THAT(said.err, HasSubstr("gone.json"));
    EXPECT_TRUE(read("again" + file.substr(file.rfind('.'))) == read(file)) << file;
  }
  expectSame("out/good.png");
}

/// The columns that hold no times are the same.
std::vector<std::string> withoutTimes(const std::string& table) {
  const std::set<std::size_t> times{8, 9, 10, 11, 12, 14};
  std::vector<std::string> cells;
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) {
      cells.push_back(line);
      continue;
    }
    std::istringstream row(line);
    std::size_t column = 0;
    for (std::string cell; std::getline(row, cell, ','); ++column)
      if (!times.contains(column)) cells.push_back(cell);
  }
  return cells;
}

TEST_F(RemakeFolderTest, AccuracyIsTheSameButForItsTimes) {
  run("accuracy s.json -o acc --set sweep.points=2 --set ensemble.realizations=2 --quiet");

  for (const char* name : {"accuracy.csv", "accuracy.json", "standard_error.png"}) {
    const Said said = remake("acc/" + std::string(name) + " -o again_" + name);
    EXPECT_EQ(said.status, 0) << said.err;
    EXPECT_THAT(said.err, HasSubstr("run times, and what follows from them, are measured again"));
    EXPECT_THAT(said.out, AllOf(HasSubstr("wrote again_"), Not(HasSubstr("tmp"))));
  }
  EXPECT_EQ(withoutTimes(read("again_accuracy.csv")), withoutTimes(read("acc/accuracy.csv")));
  EXPECT_EQ(embeddedProvenance(read("again_standard_error.png")),
            embeddedProvenance(read("acc/standard_error.png")));
  const auto numbers = [](Json answer) {
    for (Json& region : answer["regions"])
      for (Json& method : region["methods"])
        for (const char* time :
             {"seconds", "seconds_quartiles", "line_seconds", "seconds_with_line", "is_on_front"})
          method.erase(time);
    return answer;
  };
  EXPECT_EQ(numbers(Json::parse(read("again_accuracy.json"))),
            numbers(Json::parse(read("acc/accuracy.json"))));
  EXPECT_EQ(remake("acc/accuracy.csv -o again_accuracy.csv --quiet").err, "");
}

TEST_F(RemakeFolderTest, SensitivityAndCutOffAreTheSameAgain) {
  fs::create_directory(program.folder / "out");
  run("sensitivity s.json -o out/s.csv -o out/s.json -o out/s.png --size 600x500 --legend none");
  run("cutoff s.json -o out/c.csv -o out/c.json -o out/c.svg --theme dark");
  expectAllSame("out");
}

TEST_F(RemakeFolderTest, FilesWithoutARecordAreOneLine) {
  run(fitCommand() + "--no-profiles -o fit");
  const Json fit = Json::parse(read("fit/fit.json"));
  // As an earlier version wrote it.
  program.folder.write("old.json",
                       R"({"verb": "fit", "scene": )" + fit["scene"].dump() + R"(, "fit": {}})");
  expectRefused("open old.json --remake", 2, "does not say the options that made it");
  program.folder.write("odd.json", R"({"verb": "explain", "scene": {}})");
  expectRefused("open odd.json --remake", 2, "which cannot be remade");
  for (
      const char* odd :
      {R"({"verb":"material","origin":{}})", R"({"verb":"material","origin":{"options":3}})",
       R"({"verb":"material","origin":{"file":"../dma.csv","options":{"x":1}}})",
       R"({"verb":"batch","options":{"file":"a","entry":{"name":"../a","show":"both"}},"scene":{}})",
       R"({"verb":"batch","options":{"file":"a","entry":7},"scene":{}})",
       R"({"verb":"batch","options":{"file":"results"},"scenes":[7]})",
       R"({"verb":"fit","options":{"file":"../../x","vary":"surface.hurst"},"scene":{}})",
       R"({"verb":"study","options":{"file":7},"study_sha256":7,"scene":{}})",
       R"({"verb":"fit","options":{"file":"fit"},"start":7,"scene":{}})"}) {
    program.folder.write("odd.json", odd);
    expectRefused("open odd.json --remake -o new.json", 2, "");
  }
}

}  // namespace
}  // namespace asperity
