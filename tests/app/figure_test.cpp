// asperity figure: files, claims, refusals.
#include <gmock/gmock.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/app/program.h"

namespace asperity {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
using testing::UnorderedElementsAre;

using FigureCommandTest = ProgramTest;

constexpr const char* kQuick = " --realizations 3 --set surface.elements=300";

TEST_F(FigureCommandTest, WritesDataPicturesAndClaims) {
  const Said said = program.run(std::string("figure 1 5 -o out") + kQuick);
  EXPECT_EQ(said.status, 0) << said.err;
  EXPECT_THAT(program.folder.names("out"),
              UnorderedElementsAre("figure_1.csv", "figure_1.png", "figure_1.svg", "figure_1.pdf",
                                   "figure_5.csv", "figure_5.png", "figure_5.svg", "figure_5.pdf",
                                   "claims.json"));
  EXPECT_THAT(read("out/figure_5.csv"), HasSubstr("\nhurst,alpha,"));
  EXPECT_THAT(read("out/figure_5.png"), StartsWith("\x89PNG"));
  EXPECT_THAT(read("out/figure_5.svg"), HasSubstr("<svg"));
  EXPECT_THAT(read("out/figure_1.svg"), HasSubstr("<path"));
  EXPECT_THAT(said.out, HasSubstr("% of the run time"));
}

TEST_F(FigureCommandTest, AnswersWithTheClaimsAsJson) {
  const Said said = program.run(std::string("figure 5 -o out --json") + kQuick);
  EXPECT_EQ(said.status, 0) << said.err;
  EXPECT_EQ(said.out, read("out/claims.json"));
  const auto json = nlohmann::json::parse(said.out);
  EXPECT_EQ(json["claims"][0]["figure"], "5");
  EXPECT_EQ(json["figures"]["5"]["scene"]["surface"]["elements"], 300);
}

TEST_F(FigureCommandTest, IsDrawnByTheBackendThatIsGiven) {
  const Said said = program.run(std::string("figure 5 -o out --backend osmesa") + kQuick,
                                "ASPERITY_OSMESA_LIBRARY=libNowhere.so ");
  EXPECT_EQ(said.status, 1);
  EXPECT_THAT(said.err, HasSubstr("libNowhere"));
}

/// The same figure twice, byte for byte, whatever the threads.
TEST_F(FigureCommandTest, IsTheSameEveryTime) {
  for (const char* run : {"a --threads 1", "b --threads 2"})
    ASSERT_EQ(program.run(std::string("figure 2 6 -o ") + run + kQuick).status, 0);
  for (const std::string& name : program.folder.names("a"))
    EXPECT_EQ(read("a/" + name), read("b/" + name)) << name;
}

/// A file that cannot be written is refused before any work: a folder in its place says whether the
/// figure is meant.
TEST_F(FigureCommandTest, AllIsEveryFigure) {
  for (const char* word : {"1", "6", "master", "spacing"}) {
    const std::string folder = std::string("out_") + word;
    const std::string file = folder + "/figure_" + word + ".png";
    std::filesystem::create_directories(program.folder / file);
    expectRefused("figure all -o " + folder, 2, "figure_" + std::string(word) + ".png");
  }
}

TEST_F(FigureCommandTest, PaperIsFigures1To6) {
  std::filesystem::create_directories(program.folder / "out/figure_master.png");
  std::filesystem::create_directories(program.folder / "out/figure_spacing.png");
  const Said said =
      program.run("figure paper -o out --realizations 2 --set surface.elements=200 --json");
  ASSERT_EQ(said.status, 0) << said.err;
  const auto json = nlohmann::json::parse(said.out);
  EXPECT_EQ(json["figures"].size(), 6U);
  for (const auto& claim : json["claims"]) {
    EXPECT_TRUE(claim.contains("holds_from") && claim.contains("holds_to")) << claim["id"];
    EXPECT_LT(claim["figure"].get<std::string>().size(), 2U);
  }
}

TEST_F(FigureCommandTest, RefusesWhatItCannotDo) {
  expectRefused("figure 7 -o out", 2,
                "7 is not one of 1, 2, 3, 4, 5, 6, master, spacing, paper, all");
  expectRefused("figure 2", 2, "--output");
  expectRefused("figure -o out", 2, "NAME");
  expectRefused("figure 2 -o out --realizations 0", 2, "realizations");
  expectRefused("figure 4 -o out --set load.normal_force=1", 2,
                "load.normal_force: figure 4 sets it itself");
  expectRefused("figure 2 -o out --set surface.hurts=1", 2, "surface.hurst");
  expectRefused("figure 2 -o s.json", 2, "s.json: is not a folder");
}

}  // namespace
}  // namespace asperity
