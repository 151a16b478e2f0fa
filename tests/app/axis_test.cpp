// Curves over any key as a user asks for them on the command line.
#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/app/program.h"

namespace asperity {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// The cells of one row of a table, counted from 0 after the header.
std::vector<std::string> cellsOf(const std::string& table, std::size_t row) {
  std::istringstream lines(withoutComment(table));
  std::string line;
  for (std::size_t i = 0; i < row + 2; ++i) std::getline(lines, line);
  std::istringstream cells(line);
  std::vector<std::string> found;
  for (std::string cell; std::getline(cells, cell, ',');) found.push_back(cell);
  return found;
}

class AxisTest : public testing::Test {
 protected:
  AxisTest() {
    std::ofstream(program.folder / "s.json")
        << R"({"surface": {"elements": 200}, "ensemble": {"realizations": 3},)"
           R"( "sliding": {"velocity": 0.05}})";
  }
  void expectRefused(const std::string& arguments, const std::string& message) {
    const Said said = program.run("curve s.json " + arguments);
    EXPECT_EQ(said.status, 2) << arguments;
    EXPECT_THAT(said.err, HasSubstr(message)) << arguments;
    EXPECT_EQ(std::count(said.err.begin(), said.err.end(), '\n'), 1) << said.err;
    EXPECT_EQ(said.out, "") << arguments;
  }

  Program program;
};

TEST_F(AxisTest, OverAKeyTheFirstColumnIsItsLastWord) {
  const Said said = program.run("curve s.json --over load.normal_force=1mN:1N:4");
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_THAT(withoutComment(said.out), StartsWith("normal_force,velocity,mu,mu_standard_error,"));
  EXPECT_EQ(cellsOf(said.out, 0)[0], "0.001");
  EXPECT_EQ(cellsOf(said.out, 3)[0], "1");
  EXPECT_EQ(cellsOf(said.out, 3)[1], "0.05");
  // The scene file says the same.
  std::ofstream(program.folder / "axis.json")
      << R"({"surface": {"elements": 200}, "ensemble": {"realizations": 3},)"
         R"( "sliding": {"velocity": 0.05},)"
         R"( "sweep": {"key": "load.normal_force", "from": 1e-3, "to": 1, "points": 4}})";
  EXPECT_EQ(withoutComment(program.run("curve axis.json").out), withoutComment(said.out));
  EXPECT_EQ(withoutComment(program.run("curve axis.json --threads 1").out),
            withoutComment(said.out));
}

TEST_F(AxisTest, EachValueIsThatOfItsOwnScene) {
  const Said over = program.run("curve s.json --over surface.hurst=0.9:0.3:3");
  ASSERT_EQ(over.status, 0) << over.err;
  const Said own =
      program.run("curve s.json --set surface.hurst=0.3 --over sliding.velocity=0.05:0.05:1");
  ASSERT_EQ(own.status, 0) << own.err;
  EXPECT_NEAR(std::stod(cellsOf(over.out, 2)[2]), std::stod(cellsOf(own.out, 0)[1]),
              1e-12 * std::stod(cellsOf(own.out, 0)[1]));
}

TEST_F(AxisTest, JsonAndPicturesTellTheAxis) {
  const Said said =
      program.run("curve s.json --over load.normal_force=1:1e-3:3 -o c.json -o c.svg");
  ASSERT_EQ(said.status, 0) << said.err;
  const auto json = nlohmann::json::parse(TemporaryFolder::read(program.folder / "c.json"));
  EXPECT_EQ(json["points"][0]["normal_force"], 1);
  EXPECT_EQ(json["points"][2]["normal_force"], 1e-3);
  EXPECT_EQ(json["scene"]["sweep"]["key"], "load.normal_force");
  EXPECT_TRUE(json["points"][0].contains("tangential_force"));
  EXPECT_THAT(TemporaryFolder::read(program.folder / "c.svg"), HasSubstr("normal force"));
}

TEST_F(AxisTest, PointsOfTheoriesHaveTheirValueOfTheAxis) {
  const Said said = program.run(
      "curve s.json --over load.normal_force=1mN:1N:4 --theory gaussian_foundation --json");
  ASSERT_EQ(said.status, 0) << said.err;
  const auto points = nlohmann::json::parse(said.out)["theories"][0]["points"];
  EXPECT_EQ(points.front()["normal_force"], 0.001);
  EXPECT_EQ(points.back()["normal_force"], 1);
  EXPECT_EQ(points.back()["velocity"], 0.05);
}

TEST_F(AxisTest, AFamilyHasAColumnOfItsKey) {
  const Said said =
      program.run("curve s.json --set sweep.points=3 --family load.normal_force=1mN:100mN:3");
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_THAT(withoutComment(said.out), StartsWith("series,normal_force,velocity,"));
  EXPECT_THAT(said.out, HasSubstr(",0.01,"));
  const Said json = program.run(
      "curve s.json --json --set sweep.points=3 --family load.normal_force=1mN:100mN:3");
  EXPECT_EQ(nlohmann::json::parse(json.out)["family"][2]["load.normal_force"], 0.1);
}

TEST_F(AxisTest, AFamilyHasEquation11WhereItIsNamed) {
  const std::string family = "--set sweep.points=3 --family load.normal_force=1mN:100mN:3 ";
  const auto picture = [&](const std::string& options) {
    const Said said = program.run("curve s.json " + family + options + " -o a.svg");
    EXPECT_EQ(said.status, 0) << said.err;
    return TemporaryFolder::read(program.folder / "a.svg");
  };
  EXPECT_THAT(picture(""), Not(HasSubstr("Eq. (11)")));
  EXPECT_THAT(picture("--theory eq_11"), HasSubstr("Eq. (11)"));
  const Said json = program.run("curve s.json --json --theory eq_11 " + family);
  EXPECT_EQ(nlohmann::json::parse(json.out)["theories"][0]["theory"], "eq_11");
}

TEST_F(AxisTest, ThePresentTableStaysAsItWas) {
  const Said said = program.run("curve s.json --set sweep.points=2");
  EXPECT_THAT(withoutComment(said.out),
              StartsWith("velocity,mu,mu_standard_error,mu_law,contact_fraction,"
                         "rms_slope_contact,indentation,normalized_mu,"
                         "dimensionless_velocity,dimensionless_force,realizations\n"));
  EXPECT_THAT(program.run("curve s.json --set sweep.points=2 --y power").out,
              HasSubstr("tangential_force,power"));
}

/// Theories, the number of lines in the name of a mean, and measured friction over another key than
/// velocity are known only after the work, so labels and styles of curves are looked up then.
TEST_F(AxisTest, LabelsAndStylesAreThoseOfTheComputedChart) {
  std::ofstream(program.folder / "v.csv") << "velocity (m/s),normal_force (N),mu\n"
                                             "0.05,1,0.4\n0.05,2,0.5\n";
  const auto picture = [&](const std::string& command) {
    const Said said = program.run(command + " --set sweep.points=3 -o a.svg");
    EXPECT_EQ(said.status, 0) << command << said.err;
    return TemporaryFolder::read(program.folder / "a.svg");
  };
  EXPECT_THAT(picture("curve s.json --theory eq_11,persson_half_space --curve-style 3=#123456"),
              HasSubstr("123456"));
  const std::string over = "s.json --over load.normal_force=1:2:3 --data v.csv --labels y2=ratio";
  for (const std::string command : {"curve ", "render --layout curve "}) {
    EXPECT_THAT(picture(command + "s.json --labels 'mean of 3 lines \u00B1 standard error=model'"),
                HasSubstr(">model<"));
    EXPECT_THAT(picture(command + over), HasSubstr(">ratio<"));
  }
  expectRefused("--labels y3=ratio -o b.svg", "--labels: 'y3' is neither an axis");
  EXPECT_FALSE(std::filesystem::exists(program.folder / "b.svg"));
}

TEST_F(AxisTest, EachMisuseIsOneLine) {
  expectRefused("--over load.normal_forc=1:2:3", "nearest known one is load.normal_force");
  expectRefused("--over load.depth=1e-6:1e-5:3", "load.depth has no meaning for load.kind force");
  expectRefused("--over surface.kind=1:2:3", "surface.kind");
  expectRefused("--over load.normal_force=0:2:3:log", "load.normal_force");
  expectRefused("--over surface.hurst=0:1:3:log", "logarithmic axis");
  expectRefused("--over surface.hurst=0:2:3", "surface.hurst: 2 is outside 0 to 1");
  expectRefused("--over elastomer.shift.c1=1:10:3", "changes nothing in this scene");
  expectRefused("--over ensemble.realizations=1:10:3", "cannot be its axis");
  expectRefused("--over load.normal_force=1:2:3 --family load.normal_force=1:2:3",
                "is the axis of the curves already");
  expectRefused("--over load.normal_force=1:2:3 --axes dimensionless -o a.png",
                "goes over velocities");
  expectRefused("--over load.normal_force=1:2:3 --compare nodal", "goes over velocities");
  expectRefused("--y friction", "mu, mu_total, normalized_mu, contact_fraction");
  expectRefused("--family surface.hurst=0:1:1000", "1000 curves are more than 100");
  expectRefused("--x-scale log", "belongs to pictures");
  expectRefused("--over load.normal_force=1:2:3 --set sliding.velocity=0", "sliding.velocity");
}

TEST_F(AxisTest, WhatGoesOverVelocitiesRefusesAnotherAxis) {
  const std::string over =
      " s.json --set sweep.key=load.normal_force --set sweep.from=1 --set sweep.to=2";
  const Said accuracy = program.run("accuracy" + over + " -o out");
  EXPECT_EQ(accuracy.status, 2);
  EXPECT_THAT(accuracy.err, HasSubstr("sweep.key: asperity accuracy goes over velocities"));
  const Said explained = program.run("explain" + over);
  EXPECT_EQ(explained.status, 0) << explained.err;
  EXPECT_THAT(explained.out, HasSubstr("41 values of load.normal_force"));
}

}  // namespace
}  // namespace asperity
