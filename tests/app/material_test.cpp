// asperity material: from a table to a material that a scene can name; refusals in one line that
// leave nothing behind.
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/app/program.h"

namespace asperity {
namespace {

using testing::Each;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;

/// Two arms at 20 °C, and a decade slower at 10 °C.
std::string table(const std::string& header = "f (Hz),T (C),G' (MPa),G'' (MPa)\n") {
  std::string text = header;
  for (const double shift : {0.0, 1.0})
    for (int i = 0; i <= 20; ++i) {
      const double frequency = std::pow(10, -1 + 0.15 * i);
      double storage = 1, loss = 0;
      for (const auto& [modulus, time] : {std::pair(2.0, 0.3), std::pair(3.0, 0.002)}) {
        const double turn = 2 * M_PI * frequency * std::pow(10, shift) * time;
        storage += modulus * turn * turn / (1 + turn * turn);
        loss += modulus * turn / (1 + turn * turn);
      }
      text += std::to_string(frequency) + "," + (shift > 0 ? "10," : "20,") +
              std::to_string(storage) + "," + std::to_string(loss) + "\n";
    }
  return text;
}

class MaterialCommandTest : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    program.folder.write("dma.csv", table());
  }
};

TEST_F(MaterialCommandTest, ATableBecomesAMaterialForScenes) {
  const auto result = program.run("material dma.csv -o rubber --name Rubber --json");
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(program.folder.names("rubber"),
              IsSupersetOf({"material.json", "prony.csv", "isotherms.csv", "shifts.csv",
                            "master_curve.png", "master_curve.svg", "master_curve.pdf",
                            "isotherms.png", "loss_tangent.png", "shifts.png"}));
  EXPECT_THAT(program.folder.names("rubber"), Each(Not(HasSubstr("~"))));
  const auto material = nlohmann::json::parse(result.out);
  EXPECT_EQ(material["name"], "Rubber");
  EXPECT_NEAR(material["equilibrium_modulus"].get<double>(), 1e6, 3e4);
  EXPECT_EQ(TemporaryFolder::read(program.folder / "rubber/material.json"), result.out);
  program.folder.write("scene.json", R"({"surface": {"elements": 100}, "sweep": {"points": 3},
      "ensemble": {"realizations": 1}, "elastomer": {"material": "rubber/material.json"}})");
  const auto curve = program.run("curve scene.json --set elastomer.temperature=285");
  EXPECT_EQ(curve.status, 0) << curve.err;
  EXPECT_THAT(curve.out, HasSubstr(",extrapolated"));
  EXPECT_EQ(program.run("material scene.json -o used --set elastomer.temperature=285").status, 0);
  EXPECT_THAT(program.folder.names("used"), IsSupersetOf({"excitation.csv", "excitation.png"}));
  expectRefused("curve scene.json --set elastomer.temperature=320", 2,
                "asperity: scene.json: elastomer.temperature: 320 K is outside the shift table");
}

TEST_F(MaterialCommandTest, TheSameFileGivesTheSameBytes) {
  ASSERT_EQ(program.run("material dma.csv -o a --quiet").status, 0);
  ASSERT_EQ(program.run("material dma.csv -o b --quiet").status, 0);
  for (const char* name : {"material.json", "shifts.csv", "master_curve.png", "master_curve.pdf"})
    EXPECT_EQ(TemporaryFolder::read(program.folder / (std::string("a/") + name)),
              TemporaryFolder::read(program.folder / (std::string("b/") + name)))
        << name;
}

TEST_F(MaterialCommandTest, WhatCannotBeUsedIsRefusedAndLeavesNothing) {
  program.folder.write("liquid.csv", "tau (s),G (MPa)\n0.1,2\n");
  program.folder.write("negative.csv", "f (Hz),T (C),G' (Pa),G'' (Pa)\n1,20,1e6,-1\n2,20,1e6,1\n");
  program.folder.write("unknown.csv", table("a,b,c,d\n"));
  const std::pair<const char*, const char*> refusals[] = {
      {"material none.csv -o out", "asperity: none.csv: "},
      {"material negative.csv -o out", "asperity: negative.csv: line 2: G'' is \u22121 Pa"},
      {"material unknown.csv -o out", "asperity: unknown.csv: has no columns that are known"},
      {"material liquid.csv -o out --temperature 20C",
       "asperity: liquid.csv: equilibrium modulus: is not above 0"},
      {"material dma.csv -o out --reference-temperature 100C",
       "asperity: --reference-temperature: 373.15 K is outside of the measured temperatures"},
      {"material dma.csv -o out --reference-temperature warm",
       "asperity: --reference-temperature: 'warm' is not a temperature"},
      {"material dma.csv -o out --temperature 20",
       "asperity: --temperature: '20' is not a temperature such as 20C"},
      {"material dma.csv -o out --poisson-ratio 0.6", "asperity: --poisson-ratio: "},
      {"material dma.csv -o out --shift none", "asperity: --shift: none is not one of"},
      {"material dma.csv -o out --set load.normal_force=1",
       "asperity: --set: sets keys of a scene"},
      {"material dma.csv -o out --leave-out 50C", "asperity: --leave-out: no isotherm is within"},
  };
  for (const auto& [words, error] : refusals) {
    expectRefused(words, 2, error);
    EXPECT_FALSE(std::filesystem::exists(program.folder / "out")) << words;
  }
}

}  // namespace
}  // namespace asperity
