// asperity map, sensitivity and cutoff: tables, pictures that bring their scene back, refusals.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/scene/provenance.h"
#include "tests/app/program.h"

namespace asperity {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
using Json = nlohmann::json;

class MapCommandTest : public ProgramTest {
 protected:
  static constexpr const char* kMap =
      "map s.json --x sliding.velocity=1e-4:10:12 --y load.normal_force=1mN:1N:7";
};

TEST_F(MapCommandTest, PrintsATableWithXFastest) {
  const Said said = program.run(kMap);
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_THAT(withoutComment(said.out), StartsWith("velocity,normal_force,mu,"));
  EXPECT_EQ(std::count(said.out.begin(), said.out.end(), '\n'), 2 + 12 * 7);
  EXPECT_THAT(said.out, HasSubstr("\n10,1,"));
}

/// A cell is the row that `curve` writes for the scene with both keys set, to 1e-12.
TEST_F(MapCommandTest, ACellIsThePointOfACurve) {
  const Said map = program.run(std::string(kMap) + " --json");
  ASSERT_EQ(map.status, 0) << map.err;
  const Json points = Json::parse(map.out)["points"];
  for (const std::size_t k : {0U, 17U, 83U}) {
    const Json& cell = points.at(k);
    std::ostringstream call;
    call.precision(17);
    const double velocity = cell["velocity"], force = cell["normal_force"];
    call << "curve s.json --json --set sweep.points=1 --set sweep.velocity_from=" << velocity
         << " --set sweep.velocity_to=" << velocity << " --set load.normal_force=" << force;
    const Said curve = program.run(call.str());
    ASSERT_EQ(curve.status, 0) << curve.err;
    const Json own = Json::parse(curve.out)["points"].at(0);
    for (const char* column : {"mu", "contact_fraction", "indentation", "mu_law", "normalized_mu"})
      EXPECT_NEAR(double(cell[column]) / double(own[column]), 1, 1e-12) << column << " " << k;
  }
}

TEST_F(MapCommandTest, TheMarkOfTheSceneMayBeLeftOut) {
  const auto picture = [&](const std::string& options) {
    const Said said = program.run(std::string(kMap) + " -o a.svg" + options);
    EXPECT_EQ(said.status, 0) << said.err;
    return read("a.svg");
  };
  const std::string with = picture(""), without = picture(" --marker off");
  EXPECT_THAT(with, HasSubstr("Cross: the scene"));
  EXPECT_THAT(without, Not(HasSubstr("Cross: the scene")));
  EXPECT_LT(without.size(), with.size());
}

TEST_F(MapCommandTest, WritesPicturesThatBringTheirSceneBack) {
  const Said said = program.run(std::string(kMap) +
                                " -o a.png -o a.svg -o a.pdf -o a.csv -o a.json --show "
                                "contact_fraction --set load.normal_force=0.05 --size 800x600");
  ASSERT_EQ(said.status, 0) << said.err;
  for (const char* name : {"a.png", "a.svg", "a.pdf", "a.csv", "a.json"})
    EXPECT_EQ(findScene(program.folder / name).scene.load.normalForce, 0.05) << name;
  EXPECT_THAT(read("a.csv"), HasSubstr("\"show\":\"contact_fraction\"}"));
  EXPECT_THAT(read("a.csv"), HasSubstr("\"key\":\"load.normal_force\""));
  const std::string svg = read("a.svg");
  // One image for the colours and one for the bar, not a rectangle for each cell.
  EXPECT_LT(svg.size(), 400000U);
  std::size_t images = 0;
  for (std::size_t at = 0; (at = svg.find("<image", at)) != std::string::npos; ++at) ++images;
  EXPECT_EQ(images, 2U);
  EXPECT_THAT(svg, HasSubstr("contact fraction"));
}

TEST_F(MapCommandTest, ShowsTheExponent) {
  const Said said = program.run(std::string(kMap) + " --show exponent --json");
  ASSERT_EQ(said.status, 0) << said.err;
  const Json first = Json::parse(said.out)["points"].at(0);
  EXPECT_NEAR(double(first["exponent"]), 1, 0.05);  // region I: mu is proportional to v
}

TEST_F(MapCommandTest, AnyThreadsGiveTheSameBytes) {
  const std::string one = program.run(std::string(kMap) + " --threads 1").out;
  EXPECT_FALSE(one.empty());
  EXPECT_EQ(program.run(std::string(kMap) + " --threads 3").out, one);
}

TEST_F(MapCommandTest, RefusesInOneLine) {
  const std::string x = " --x sliding.velocity=1e-4:10:4", y = " --y load.normal_force=1e-3:1:3";
  expectRefused("map s.json" + x, 2, "--y");
  expectRefused("map s.json" + x + " --y load.force=1:2:3", 2, "load.");
  expectRefused("map s.json" + x + " --y sliding.velocity=1:2:3", 2, "both sides");
  expectRefused("map s.json" + x + " --y surface.slope=0.1:0.2:3", 2, "surface.slope");
  expectRefused("map s.json" + x + " --y load.normal_force=1:2", 2, "FROM:TO:N");
  expectRefused("map s.json" + x + " --y load.normal_force=1:2:1", 2, "2 to 1000");
  expectRefused("map s.json" + x + " --y load.normal_force=0:2:5:log", 2,
                "load.normal_force: 0 is outside");
  expectRefused("map s.json" + x + " --y surface.hurst=0:2:5", 2, "0 to 1");
  expectRefused("map s.json" + x + " --y load.normal_force=1mm:2mm:5", 2, "load.normal_force");
  expectRefused("map s.json" + x + y + " --show friction", 2, "--show");
  expectRefused("map s.json" + x + y + " -o a.txt", 2, "a.txt");
  expectRefused("map s.json" + x + y + " -o a.csv --theme dark", 2, "--theme");
  expectRefused("map s.json --set sliding.kind=start" + x + y, 2, "sliding.kind");
  expectRefused("map s.json --set accuracy.target_relative_error=0.01" + x + y, 2,
                "accuracy.target_relative_error");
}

/// mu of a Kelvin body depends on F_N/(G h), v tau and h times that: the exponents of F_N, G and h
/// are tied by mu ~ h f(F_N / (G h), v tau).
TEST_F(MapCommandTest, SensitivitiesObeyTheScaling) {
  const Said said = program.run("sensitivity s.json --json");
  ASSERT_EQ(said.status, 0) << said.err;
  std::map<std::string, double> of;
  const Json answer = Json::parse(said.out);
  double before = HUGE_VAL;
  for (const Json& row : answer["parameters"]) {
    of[row["key"]] = row["mu_exponent"];
    EXPECT_LE(std::abs(double(row["mu_exponent"])), before);
    before = std::abs(double(row["mu_exponent"]));
  }
  EXPECT_NEAR(of.at("load.normal_force"), -of.at("elastomer.shear_modulus"), 1e-5);
  EXPECT_NEAR(of.at("surface.rms_height"), 1 - of.at("load.normal_force"), 1e-5);
  EXPECT_NEAR(of.at("sliding.velocity"), of.at("elastomer.relaxation_time"), 1e-5);
  const Said people = program.run("sensitivity s.json");
  EXPECT_THAT(people.out, StartsWith("parameter"));
  EXPECT_THAT(program.run("sensitivity s.json --language de").out, StartsWith("Parameter"));
  const Said files = program.run("sensitivity s.json -o b.csv -o b.png -o b.pdf");
  ASSERT_EQ(files.status, 0) << files.err;
  EXPECT_THAT(read("b.csv"), HasSubstr("\nkey,value,mu_exponent,mu_exponent_standard_error\n"));
}

TEST_F(MapCommandTest, TheCutoffEndsWithTheWholeLine) {
  const Said said = program.run("cutoff s.json --json");
  ASSERT_EQ(said.status, 0) << said.err;
  const Json points = Json::parse(said.out)["points"];
  ASSERT_GE(points.size(), 5U);
  const Said curve = program.run(
      "curve s.json --json --set sweep.points=1 --set sweep.velocity_from=1 --set "
      "sweep.velocity_to=1");
  EXPECT_NEAR(double(points.back()["mu"]) / double(Json::parse(curve.out)["points"][0]["mu"]), 1,
              1e-12);
  ASSERT_EQ(program.run("cutoff s.json -o c.png -o c.csv").status, 0);
  EXPECT_THAT(read("c.csv"), HasSubstr("\ncutoff_wavelength,share_of_decade,"));
  expectRefused("cutoff s.json --set surface.kind=wedge", 2, "surface.kind");
}

}  // namespace
}  // namespace asperity
