// asperity fit and measured friction beside a curve: files, values, refusals.
#include <gmock/gmock.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/app/program.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class FitCommandTest : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    program.folder.write(
        "s.json",
        R"({"title":"Fitted","surface":{"elements":200},"ensemble":{"realizations":30},
            "sweep":{"velocity_from":1e-4,"velocity_to":1000,"points":9}})");
    // Made by the program itself, from the scene with another height and relaxation time.
    ASSERT_EQ(program
                  .run("curve s.json -o truth.csv --set surface.rms_height=7e-7 --set "
                       "elastomer.relaxation_time=2e-3 --set sweep.points=12")
                  .status,
              0);
    std::istringstream lines(read("truth.csv"));
    std::string line, data = "velocity (mm/s);mu;mu_error\n";
    std::getline(lines, line);  // how it was made
    std::getline(lines, line);  // names
    while (std::getline(lines, line)) {
      const double velocity = std::stod(line), mu = std::stod(line.substr(line.find(',') + 1));
      std::ostringstream row;
      row.precision(10);
      row << 1e3 * velocity << ";" << mu << ";" << 0.02 * mu << "\n";
      data += row.str();
    }
    program.folder.write("data.csv", data);
  }
};

TEST_F(FitCommandTest, FindsTheValuesThatMadeTheData) {
  const auto ran = program.run(
      "fit s.json --data data.csv --vary surface.rms_height=10nm:1mm --vary "
      "elastomer.relaxation_time=1e-5:1 -o out --size 900x800");
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_THAT(ran.out + ran.err, HasSubstr("ranges: one standard error to each side"));
  const auto fit = nlohmann::json::parse(read("out/fit.json"));
  EXPECT_EQ(fit["schema"], "asperity-fit/1");
  // The same lines made the data: nothing but rounding is left.
  EXPECT_NEAR(fit["fit"]["parameters"][0]["value"].get<double>() / 7e-7, 1, 1e-3);
  EXPECT_NEAR(fit["fit"]["parameters"][1]["value"].get<double>() / 2e-3, 1, 1e-3);
  EXPECT_LT(fit["fit"]["chi_squared"].get<double>(), 1e-2);
  EXPECT_EQ(fit["fit"]["profiles"].size(), 2U);
  EXPECT_EQ(fit["inputs"][0]["key"], "comparison.data");
  for (const char* name :
       {"out/fit.csv", "out/curve.png", "out/curve.svg", "out/curve.pdf", "out/profiles.png"})
    EXPECT_GT(read(name).size(), 200U) << name;
  // The fitted scene runs where it stands, with its data.
  EXPECT_EQ(program.run("curve out/fitted.scene.json -o again.csv").status, 0);
  EXPECT_THAT(read("again.csv"), HasSubstr("data"));
  // It names them from its folder, so that both can be moved together.
  EXPECT_EQ(nlohmann::json::parse(read("out/fitted.scene.json"))["comparison"]["data"][0]["file"],
            "../data.csv");
  // Another fit into the same folder names the picture that it leaves.
  const auto second = program.run(
      "fit s.json --data data.csv --vary surface.rms_height=10nm:1mm --no-profiles -o out");
  EXPECT_EQ(second.status, 0);
  EXPECT_THAT(second.out + second.err, HasSubstr("not of this run: out/profiles.png"));
}

/// A table without errors of mu, under two pressures.
TEST_F(FitCommandTest, SaysWhatItsNumbersMean) {
  program.folder.write("bare.csv",
                       "velocity,nominal_pressure (Pa),mu\n0.01,8.5,0.02\n0.1,8.5,0.1\n"
                       "0.01,20,0.01\n0.1,20,0.05\n1,20,0.1\n");
  const auto ran = program.run("fit s.json --data bare.csv --vary surface.rms_height -o out");
  ASSERT_EQ(ran.status, 0) << ran.err;
  // No height follows these points: a range of it says nothing.
  EXPECT_THAT(ran.out + ran.err, AllOf(HasSubstr("the ranges are not valid"),
                                       HasSubstr("the points have no errors; they scatter by"),
                                       Not(HasSubstr("\u03C7\u00B2"))));
  EXPECT_THAT(read("out/fit.csv"), AllOf(HasSubstr("\nvelocity,normal_force,nominal_pressure,"),
                                         HasSubstr("\n0.01,0.008,20,")));
  // Points of each load have a mark of their own.
  EXPECT_THAT(read("out/curve.svg"), AllOf(HasSubstr("bare, 8.5 Pa"), HasSubstr("bare, 20 Pa")));
}

/// Without a width a nominal pressure acts on the square of the period, which nobody chose.
TEST_F(FitCommandTest, SaysWhichForceANominalPressureIs) {
  const std::string pressure = " s.json --set load.kind=pressure --set load.nominal_pressure=8.5";
  for (const std::string& verb :
       {"check" + pressure, "curve" + pressure + " -o p.csv", "cutoff" + pressure + " -o p.csv",
        "sensitivity" + pressure + " -o p.csv",
        "map" + pressure + " --x surface.hurst=0.5:0.8:2 --y sliding.velocity=0.1:1:2 -o p.csv"}) {
    const auto ran = program.run(verb);
    ASSERT_EQ(ran.status, 0) << ran.err;
    EXPECT_THAT(ran.out + ran.err,
                AllOf(HasSubstr("the nominal pressure of 8.5 Pa is a normal force of 3.4 mN"),
                      HasSubstr("set load.width")))
        << verb;
    const auto wide = program.run(verb + " --set load.width=1mm");
    EXPECT_THAT(wide.out + wide.err, AllOf(HasSubstr("is a normal force of 170 \u00B5N"),
                                           HasSubstr("the width of 1 mm (load.width)")))
        << verb;
  }
}

TEST_F(FitCommandTest, RefusesWhatItCannotFit) {
  const std::string fit = "fit s.json -o out --data data.csv --vary ";
  expectRefused("fit s.json -o out --vary surface.hurst", 2, "--data");
  expectRefused("fit s.json -o out --data data.csv", 2, "--vary");
  expectRefused(fit + "surface.seed", 2, "surface.seed: is not a real number");
  expectRefused(fit + "surface.hurts", 2, "the nearest known one is surface.hurst");
  expectRefused(fit + "surface.hurst=0.9:0.2", 2, "0.9:0.2 is not a range");
  expectRefused(fit + "surface.hurst=0.5", 2, "is not KEY or KEY=LOW:HIGH");
  expectRefused(fit + "surface.hurst=a:b", 2, "surface.hurst: 'a' is not a number");
  expectRefused(fit + "surface.hurst --vary surface.hurst", 2, "more than once");
  expectRefused(fit + "surface.rms_height=0.1Pa:1mm", 2, "is a modulus or pressure");
  expectRefused(fit + "surface.slope", 2, "has no meaning in this scene; allowed: surface.");
  expectRefused(fit + "surface.seed", 2, "surface.rms_height");
  program.folder.write("bad.csv", "velocity,mu\n1,0.2\n2,-1\n");
  expectRefused("fit s.json -o out --data bad.csv --vary surface.hurst", 2,
                "bad.csv: row 3: the coefficient of friction is -1");
  expectRefused("fit s.json -o out --data none.csv --vary surface.hurst", 2, "none.csv");
  program.folder.write("few.csv", "velocity,mu\n1,0.2\n2,0.3\n");
  expectRefused("fit s.json -o out --data few.csv --vary surface.hurst --vary surface.rms_height",
                2, "2 points do not determine 2 parameters");
}

TEST_F(FitCommandTest, MeasuredFrictionAndTheoriesStandBesideACurve) {
  const auto ran = program.run(
      "curve s.json --set surface.roll_off_wavelength=1mm --set load.normal_force=30mN --data "
      "data.csv --theory eq_11,gaussian_foundation,complete_contact,persson_half_space -o c.csv -o "
      "c.svg");
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_THAT(read("c.csv"), AllOf(HasSubstr("\ndata,"), HasSubstr("Gaussian foundation"),
                                   HasSubstr("half-space"), HasSubstr("Eq. (11)")));
  EXPECT_THAT(read("c.svg"), AllOf(HasSubstr("measured / computed"), HasSubstr("comparison")));
  // The answer as JSON has the measured points, too, with the friction computed at each.
  const auto answer = nlohmann::json::parse(program.run("curve s.json --data data.csv --json").out);
  const nlohmann::json& measured = answer["measured"][0];
  EXPECT_EQ(measured["name"], "data");
  const nlohmann::json& point = measured["points"][2];
  EXPECT_GT(point["mu_error"], 0);
  EXPECT_TRUE(point["temperature"].is_null());
  EXPECT_DOUBLE_EQ(point["measured_over_computed"],
                   point["mu_measured"].get<double>() / point["mu"].get<double>());
  // A scene that names them shows the same.
  program.folder.write("t.json",
                       R"({"title":"Fitted","surface":{"elements":200,"roll_off_wavelength":1e-3},
          "ensemble":{"realizations":30},"load":{"normal_force":0.03},
          "sweep":{"velocity_from":1e-4,"velocity_to":1000,"points":9},
          "comparison":{"data":[{"file":"data.csv"}],"theory":["eq_11","gaussian_foundation",
          "complete_contact","persson_half_space"]}})");
  ASSERT_EQ(program.run("curve t.json -o t.csv").status, 0);
  EXPECT_EQ(read("t.csv").substr(read("t.csv").find("\nseries")),
            read("c.csv").substr(read("c.csv").find("\nseries")));
  expectRefused("curve s.json --theory newton", 2, "newton is not one of eq_11");
  expectRefused("curve s.json --data none.csv", 2, "none.csv");
}

/// The folder is checked before the measured friction is read, and so before any fit.
TEST_F(FitCommandTest, AFolderThatCannotBeWrittenIsRefusedBeforeTheWork) {
  const std::string call = "fit s.json --data data.csv --vary surface.hrust -o ";
  expectRefused(call + "s.json", 2, "s.json: is not a folder and cannot be created");
  expectRefused(call + "s.json/a/b", 2, "s.json/a/b: is not a folder and cannot be created");
  expectRefused(call + "new/folder", 2, "surface.hrust");  // which is not made, either
  std::filesystem::create_symlink("nowhere", program.folder / "link");
  expectRefused(call + "link", 2, "link: is not a folder and cannot be created");
  expectRefused("material data.csv -o s.json/d", 2, "s.json/d: is not a folder");
  expectRefused("render s.json --frames 2 -o s.json/d", 2, "s.json/d: is not a folder");
}

}  // namespace
}  // namespace asperity
