// The text of material.json: what is written of a material, and that a shipped one is made again.
#include "core/material/material_json.h"

#include <gmock/gmock.h>

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

/// The shipped materials are what the command makes from the shipped measurements.
TEST(MaterialJson, ShippedMaterialsAreWhatTheirMeasurementsGive) {
  ASSERT_GE(shippedMaterials().size(), 2U);
  for (const ShippedMaterial& shipped : shippedMaterials()) {
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
