// What is said of a material: what was measured, what was concluded, what is in doubt; and the text
// of material.json: what is written of it, and that a shipped one is made again.
#include "core/material/material_summary.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/material/material_library.h"
#include "core/scene/scene_file.h"
#include "tests/core/material/shipped_measurements.h"
#include "tests/core/material/synthetic_rubber.h"
#include "tests/core/temporary_folder.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::Each;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

std::vector<std::string> linesOf(const Material& material) {
  std::vector<std::string> lines;
  for (const Message& line : materialSummary(material)) lines.push_back(line.english());
  return lines;
}

TEST(MaterialSummary, SaysWhatWasMeasured) {
  const std::vector<std::string> lines = linesOf(epdm());
  EXPECT_THAT(lines, Contains(HasSubstr("10 isotherms from \u221210.0 \u00B0C to 53.0 \u00B0C")));
  EXPECT_THAT(lines, Contains(HasSubstr("relaxation times, G\u221E = ")));
  EXPECT_THAT(lines, Contains(HasSubstr("not thermorheologically simple")));
  EXPECT_THAT(lines, Contains(HasSubstr("the shift used is the table of measured shifts")));
}

/// A rubber that still relaxes at the lowest frequency has an equilibrium modulus by extrapolation.
TEST(MaterialSummary, AnEquilibriumThatWasNotMeasuredIsNamed) {
  MaterialChoices choices;
  choices.columns.temperature = 293.15;
  const auto lines = [&](const char* rows) {
    return linesOf(
        makeMaterial(std::string("f (Hz),G' (MPa),G'' (MPa)\n") + rows, "dma.csv", choices));
  };
  EXPECT_THAT(lines("1,2.5,0.5\n10,3.0,0.7\n"),
              Contains(HasSubstr("equilibrium was not measured: at the lowest frequency, 1 Hz, the "
                                 "storage modulus is 2.1 times G\u221E")));
  EXPECT_THAT(lines("1,2.00,0.01\n10,2.01,0.02\n100,2.05,0.1\n"),
              Each(Not(HasSubstr("equilibrium was not measured"))));
}

/// A storage modulus that doubles in each decade has a loss factor of about tan(pi/2 log10(2)) =
/// 0.51 by the relation of Kramers and Kronig, not 0.1.
TEST(MaterialSummary, ModuliThatContradictEachOtherAreNamed) {
  const auto linesAt = [](double lossFactor) {
    std::string text = "f (Hz),T (C),G' (MPa),G'' (MPa)\n";
    for (int i = 0; i < 9; ++i) {
      const double storage = std::pow(2, i / 2.0);
      text += fmt::format("{},20,{},{}\n", std::pow(10, i / 2.0), storage, lossFactor * storage);
    }
    return linesOf(makeMaterial(text, "dma.csv", {}));
  };
  const std::string said = "the series does not follow the moduli: no relaxation has such";
  EXPECT_THAT(linesAt(0.1), Contains(HasSubstr(said)));
  EXPECT_THAT(linesAt(0.51), Not(Contains(HasSubstr(said))));
}

/// A slip of the decimal mark is named, and nothing is concluded from it.
TEST(MaterialSummary, ASlipIsNamedAndNothingIsConcludedFromIt) {
  std::vector<Isotherm> isotherms = SyntheticRubber().sweeps(12, 0.01);
  EXPECT_THAT(linesOf(fitMaterial(isotherms, {})), Each(Not(HasSubstr("beside it"))));
  isotherms[4].points[6].storage *= 10;
  const Material material = fitMaterial(isotherms, {});
  EXPECT_THAT(linesOf(material), Contains(HasSubstr("G\u2032 at 35.0 \u00B0C and 1.23 Hz is")));
  EXPECT_TRUE(material.curve.isThermorheologicallySimple);
}

TEST(MaterialSummary, MissingVerticalShiftsAreNamed) {
  SyntheticRubber rubber;
  rubber.equilibrium = 5e6;
  std::vector<Isotherm> isotherms = rubber.sweeps(15, 0.01);
  makeEntropic(isotherms);
  const auto last = [&](const MaterialChoices& choices) {
    return linesOf(fitMaterial(isotherms, choices)).back();
  };
  MaterialChoices vertical;
  vertical.isVertical = true;
  EXPECT_THAT(last({}), EndsWith("--vertical-shifts"));
  EXPECT_THAT(last(vertical), Not(HasSubstr("--vertical-shifts")));
}

/// A scene at its default temperature cannot use such a material.
TEST(MaterialSummary, AMaterialOfOneTemperatureSaysWhichScenesNeed) {
  MaterialChoices choices;
  const std::string series = "tau (s),G (MPa)\ninf,1\n0.1,2\n";
  const auto linesAt = [&](double kelvin) {
    choices.columns.temperature = kelvin;
    return linesOf(makeMaterial(series, "series.csv", choices));
  };
  EXPECT_THAT(linesAt(293.15), Contains(HasSubstr("elastomer.temperature=293.15")));
  EXPECT_THAT(linesAt(293.15), Contains(HasSubstr("one arm, G")));
  // Degrees that were converted to kelvins are said without their rounding error.
  EXPECT_THAT(linesAt(-20 + 273.15), Contains(EndsWith("elastomer.temperature=253.15")));
  EXPECT_THAT(linesAt(298.15), Contains("one temperature alone: there is no shift"));
  EXPECT_THAT(linesAt(298.15), Contains(testing::HasSubstr("would be read as the shift")));
}

/// Entropy elasticity, b_T = T / T_0, and repeated rows are said in the summary.
TEST(MaterialSummary, SaysWhatVerticalShiftsExplain) {
  SyntheticRubber rubber;
  rubber.equilibrium = 5e6;
  std::vector<Isotherm> isotherms = rubber.sweeps(21);
  makeEntropic(isotherms);
  isotherms.front().repeats = 2;
  isotherms.front().repeatRatio = 2.8;
  MaterialChoices choices;
  const std::vector<std::string> plain = linesOf(fitMaterial(isotherms, choices));
  EXPECT_THAT(plain, Contains(HasSubstr("--vertical-shifts")));
  EXPECT_THAT(plain, Contains(HasSubstr("2 rows, averaged; moduli that became one differ by a "
                                        "factor of up to 2.8")));
  choices.isVertical = true;
  EXPECT_THAT(linesOf(fitMaterial(isotherms, choices)),
              Each(Not(HasSubstr("shifts from G\u2032 alone"))));
}

/// Moduli that are power laws of one exponent: whoever reads the shifts must know what decided.
TEST(MaterialSummary, SaysWhereAVerticalShiftCannotBeTold) {
  std::vector<Isotherm> isotherms;
  for (const double kelvin : {273.15, 283.15, 293.15}) {
    Isotherm& isotherm = isotherms.emplace_back();
    isotherm.temperature = kelvin;
    for (int i = 0; i < 13; ++i) {
      const double frequency = std::pow(10, -1 + i / 6.0);
      const double modulus = 1e6 * std::sqrt(frequency * std::pow(10, -0.07 * (kelvin - 273.15)));
      isotherm.points.push_back({frequency, modulus, 0.8 * modulus});
    }
  }
  MaterialChoices choices;
  const char* const open = "in 2 of 2 overlaps the moduli do not tell a vertical shift from a ";
  EXPECT_THAT(linesOf(fitMaterial(isotherms, choices)),
              Contains(AllOf(HasSubstr(open), HasSubstr("hold for b_T = 1"))));
  choices.isVertical = true;
  EXPECT_THAT(linesOf(fitMaterial(isotherms, choices)),
              Contains(AllOf(HasSubstr(open), HasSubstr("b_T ~ T, decides"))));
  EXPECT_THAT(linesOf(fitMaterial(SyntheticRubber().sweeps(15, 0.003), choices)),
              Each(Not(HasSubstr("do not tell a vertical"))));
}

/// The shipped materials are what the command makes from the shipped measurements.
TEST(MaterialJson, ShippedMaterialsAreWhatTheirMeasurementsGive) {
  ASSERT_GE(shippedMaterials().size(), 2U);
  for (const ShippedFile& shipped : shippedMaterials()) {
    const auto there = nlohmann::json::parse(shipped.json);
    EXPECT_FALSE(there["source"].get<std::string>().empty());
    const std::string file = there["origin"]["file"];
    const auto here =
        nlohmann::json::parse(materialJson(makeMaterial(measurements(file), file, {})));
    EXPECT_EQ(here["origin"]["sha256"], there["origin"]["sha256"]);
    for (const char* key : {"equilibrium_modulus", "arms", "shift", "measured"})
      EXPECT_EQ(here[key], there[key]) << shipped.name << " " << key;
  }
}

/// A scene that names the file has every number of the material, to the last bit.
TEST(MaterialJson, ScenesReadWhatIsWritten) {
  const TemporaryFolder folder;
  for (const ShiftKind kind : {ShiftKind::Wlf, ShiftKind::Arrhenius, ShiftKind::Table}) {
    MaterialChoices choices;
    choices.shift = kind;
    Material material = fitMaterial(SyntheticRubber().sweeps(12, 0.01), choices);
    material.viscosity = 3;
    folder.write("rubber.json", materialJson(material));
    const Elastomer elastomer =
        readScene(R"({"elastomer": {"material": "rubber.json"}})", "s.json", folder.path(), {})
            .elastomer;
    EXPECT_EQ(elastomer.arms, material.series.arms);
    EXPECT_EQ(elastomer.equilibriumModulus, material.series.equilibriumModulus);
    EXPECT_EQ(elastomer.viscosity, material.viscosity);
    EXPECT_EQ(elastomer.shift, material.shift);
    EXPECT_EQ(elastomer.measured, material.measured);
  }
}

/// What was found in the file stands beside what was made of it; a ready series has no measurement.
TEST(MaterialJson, TellsMeasurementsFromReadySeries) {
  const auto measured = nlohmann::json::parse(materialJson(epdm()));
  EXPECT_EQ(measured["measurement"]["temperatures"].size(), epdm().isotherms.size());
  EXPECT_EQ(measured["measurement"]["shifts"].size(), epdm().isotherms.size());
  EXPECT_THAT(measured["measurement"]["facts"].get<std::vector<std::string>>(),
              testing::Contains(testing::HasSubstr("moduli of ")));
  EXPECT_EQ(measured["fit"]["terms"], epdm().series.terms);
  MaterialChoices choices;
  choices.columns.temperature = 296.15;
  const auto ready = nlohmann::json::parse(
      materialJson(makeMaterial("tau (s),G (MPa)\ninf,1\n0.1,2\n", "series.csv", choices)));
  EXPECT_FALSE(ready.contains("measurement"));
  EXPECT_TRUE(ready["fit"].contains("format"));
}

TEST(MaterialJson, TheOriginHasEachOptionAsItWasGiven) {
  Material material;
  material.options = {{"--leave-out", "20"}, {"--terms", "9"}, {"--leave-out", "30"}};
  const auto options = materialOrigin(material)["origin"]["options"];
  EXPECT_EQ(options["--leave-out"], (nlohmann::ordered_json{"20", "30"}));
  EXPECT_EQ(options["--terms"], "9");
}

}  // namespace
}  // namespace asperity
