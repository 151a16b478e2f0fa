// Scenes that name a material, and the kinds of shift.
#include <gmock/gmock.h>

#include "core/base/file_digest.h"
#include "core/material/element_law.h"
#include "core/material/material_library.h"
#include "core/scene/provenance.h"
#include "core/scene/scene_assignments.h"
#include "core/scene/scene_file.h"
#include "tests/core/error_from.h"
#include "tests/core/temporary_folder.h"

namespace asperity {
namespace {

using testing::HasSubstr;
using testing::Not;
using Assignments = std::vector<std::string>;

const char* const kMaterial = R"({"schema": "asperity-material/1", "name": "Test",
  "source": "none", "equilibrium_modulus": 2e6, "viscosity": 5,
  "arms": [{"modulus": 3e6, "relaxation_time": 0.5}, {"modulus": 4e6, "relaxation_time": 1e-3}],
  "shift": {"kind": "table", "table": [{"temperature": 280, "log10_shift": 1.5},
                                        {"temperature": 300, "log10_shift": 0}]},
  "measured": {"frequency_from": 0.01, "frequency_to": 1e4, "temperature_from": 280,
               "temperature_to": 300, "strain_amplitude": 0.002}})";

class MaterialScene : public testing::Test {
 protected:
  MaterialScene() { folder_.write("rubber.json", kMaterial); }

  Scene read(const std::string& json, const Assignments& assignments = {}) const {
    return readScene(json, "s.json", folder_.path(), assignments);
  }
  std::string errorOf(const std::string& json, const Assignments& assignments = {}) const {
    return errorFrom([&] { read(json, assignments); });
  }

  TemporaryFolder folder_;
};

constexpr const char* kNamed = R"({"elastomer": {"material": "rubber.json"}})";

TEST_F(MaterialScene, ANameGivesAllTheValues) {
  const Elastomer elastomer = read(kNamed).elastomer;
  EXPECT_EQ(elastomer.rheology, Rheology::Prony);
  EXPECT_EQ(elastomer.equilibriumModulus, 2e6);
  EXPECT_EQ(elastomer.viscosity, 5);
  EXPECT_EQ(elastomer.arms, (std::vector<Arm>{{3e6, 0.5}, {4e6, 1e-3}}));
  EXPECT_EQ(elastomer.shift.kind, ShiftKind::Table);
  EXPECT_EQ(elastomer.shift.table, (std::vector<ShiftPoint>{{280, 1.5}, {300, 0}}));
  EXPECT_EQ(elastomer.measured, (MeasuredRange{0.01, 1e4, 280, 300, 0.002}));
  EXPECT_EQ(elastomer.temperature, 298.15);
}

TEST_F(MaterialScene, AKeyBesideItReplacesThatOne) {
  const Elastomer elastomer =
      read(R"({"elastomer": {"material": "rubber.json", "equilibrium_modulus": 7e6,
               "shift": {"kind": "wlf", "c1": 3}}})")
          .elastomer;
  EXPECT_EQ(elastomer.equilibriumModulus, 7e6);
  EXPECT_EQ(elastomer.viscosity, 5);
  EXPECT_EQ(elastomer.shift.kind, ShiftKind::Wlf);
  EXPECT_EQ(elastomer.shift.c1, 3);
  EXPECT_EQ(elastomer.arms.size(), 2U);
}

/// The canonical text computes the same when the library has changed or is gone.
TEST_F(MaterialScene, TheCanonicalTextHoldsNameAndValues) {
  const Scene scene = read(kNamed);
  const std::string text = writeScene(scene);
  EXPECT_THAT(text, HasSubstr(R"("material": "rubber.json")"));
  EXPECT_THAT(text, HasSubstr(R"("log10_shift": 1.5)"));
  EXPECT_EQ(readScene(text, "t.json", folder_.path()), scene);
  EXPECT_EQ(writeScene(readScene(text, "t.json", folder_.path())), text);
  folder_.write("rubber.json", "nonsense");
  EXPECT_EQ(read(text), scene);
  std::filesystem::remove(folder_ / "rubber.json");
  EXPECT_EQ(read(text), scene);
  EXPECT_THAT(errorOf(kNamed), HasSubstr("elastomer.material: there is no file of this name"));
}

TEST_F(MaterialScene, ScenesWithoutOneAreWrittenAsBefore) {
  for (const char* rheology : {"elastic", "kelvin", "standard_solid", "prony"}) {
    const std::string text =
        writeScene(read("{}", {std::string("elastomer.rheology=") + rheology}));
    EXPECT_THAT(text, Not(HasSubstr("material")));
    EXPECT_THAT(text, Not(HasSubstr("measured")));
    EXPECT_THAT(text, Not(HasSubstr(R"("shift": {
      "kind")")));
  }
}

TEST_F(MaterialScene, AnAssignedMaterialReplacesTheElastomerOfTheFile) {
  const Elastomer wanted = read(kNamed).elastomer;
  const Assignments assign{"elastomer.material=rubber.json"};
  EXPECT_EQ(
      read(R"({"elastomer": {"shear_modulus": 5e6, "relaxation_time": 1}})", assign).elastomer,
      wanted);
  EXPECT_EQ(read(R"({"elastomer": {"rheology": "prony", "viscosity": 9, "arms": [],
                     "shift": {"c1": 1}}})",
                 assign)
                .elastomer,
            wanted);
  EXPECT_EQ(
      read("{}", {"elastomer.material=rubber.json", "elastomer.viscosity=0"}).elastomer.viscosity,
      0);
}

TEST_F(MaterialScene, AnotherRheologyDropsIt) {
  const Scene scene = read(kNamed, {"elastomer.rheology=kelvin"});
  EXPECT_EQ(scene.elastomer.rheology, Rheology::Kelvin);
  EXPECT_TRUE(scene.elastomer.material.empty());
  EXPECT_THAT(errorOf(R"({"elastomer": {"rheology": "kelvin", "material": "rubber.json"}})"),
              HasSubstr("elastomer.material: has no meaning for elastomer.rheology kelvin"));
}

/// Every scene can be reached from every other one by assignments.
TEST_F(MaterialScene, AssignmentsLeadFromAnySceneToAnyOther) {
  std::vector<Scene> scenes{
      read("{}"),
      read(R"({"elastomer": {"rheology": "elastic"}})"),
      read(kNamed),
      read(kNamed, {"elastomer.viscosity=0", "elastomer.shift.kind=arrhenius"}),
      read(R"({"elastomer": {"material": "epdm_70"}})"),
      read(R"({"elastomer": {"rheology": "prony", "shift": {"kind": "arrhenius",
               "activation_energy": 8e4}}})"),
      read(R"({"elastomer": {"shift": {"kind": "table",
               "table": [{"temperature": 290, "log10_shift": 1}, {"temperature": 300, "log10_shift": 0}]}}})"),
  };
  for (const Scene& base : scenes)
    for (const Scene& scene : scenes)
      EXPECT_EQ(read(writeScene(base), differingAssignments(base, scene)), scene)
          << writeScene(base) << joinedAssignments(differingAssignments(base, scene));
  // A scene file has the name alone.
  for (const Scene& scene : scenes)
    EXPECT_EQ(read(kNamed, differingAssignments(read(kNamed), scene)), scene);
}

TEST_F(MaterialScene, EveryShippedMaterialMakesAScene) {
  ASSERT_FALSE(shippedMaterials().empty());
  for (const ShippedFile& shipped : shippedMaterials()) {
    const Scene scene = read("{}", {"elastomer.material=" + std::string(shipped.name)});
    EXPECT_GT(scene.elastomer.measured.frequencyTo, scene.elastomer.measured.frequencyFrom);
    EXPECT_EQ(read(writeScene(scene)), scene);
  }
}

TEST_F(MaterialScene, ProvenanceNamesTheContent) {
  const auto root = provenance("curve", read(kNamed));
  ASSERT_EQ(root["inputs"].size(), 1U);
  EXPECT_EQ(root["inputs"][0]["key"], "elastomer.material");
  EXPECT_EQ(root["inputs"][0]["sha256"], sha256(kMaterial));
  EXPECT_FALSE(provenance("curve", read("{}")).contains("inputs"));
}

TEST_F(MaterialScene, BadMaterialsAreNamedInOneLine) {
  const auto errorWith = [&](const std::string& json) {
    folder_.write("rubber.json", json);
    return errorOf(kNamed);
  };
  EXPECT_THAT(errorWith("tau,G\n1,2\n"), HasSubstr("a material is JSON in UTF-8"));
  EXPECT_THAT(errorWith("{}"), HasSubstr("schema: is not asperity-material/1"));
  EXPECT_THAT(errorWith(R"({"schema": "asperity-material/1", "arms": []})"),
              HasSubstr("rubber.json: equilibrium_modulus: is missing"));
  EXPECT_THAT(
      errorWith(R"({"schema": "asperity-material/1", "arms": [], "equilibrium_modulus": -1})"),
      HasSubstr("rubber.json: elastomer.equilibrium_modulus: -1 is outside"));
  EXPECT_THAT(errorWith(R"({"schema": "asperity-material/1", "armz": []})"),
              HasSubstr("armz: unknown key of a material"));
  EXPECT_THAT(
      errorOf(R"({"elastomer": {"material": "epdm"}})"),
      testing::ContainsRegex("there is no file of this name, and epdm is not one of .*epdm_70"));
}

// ---- Shifts
// --------------------------------------------------------------------------------------

TEST_F(MaterialScene, AShiftHasTheKeysOfItsKind) {
  EXPECT_THAT(errorOf(R"({"elastomer": {"shift": {"kind": "arrhenius", "c1": 3}}})"),
              HasSubstr("elastomer.shift.c1: has no meaning for elastomer.shift.kind arrhenius"));
  EXPECT_THAT(errorOf(R"({"elastomer": {"shift": {"activation_energy": 3}}})"),
              HasSubstr("it belongs to arrhenius"));
  EXPECT_THAT(errorOf(R"({"elastomer": {"rheology": "elastic", "shift": {"kind": "table"}}})"),
              HasSubstr("elastomer.shift.kind: has no meaning for elastomer.rheology elastic"));
  EXPECT_THAT(errorOf(R"({"elastomer": {"rheology": "elastic", "shift": {"c1": 3}}})"),
              HasSubstr("elastomer.shift.c1: has no meaning for elastomer.rheology elastic; it "
                        "belongs to kelvin, standard_solid, prony"));
}

TEST_F(MaterialScene, ATableRisesAndHasNoOutside) {
  const std::string head = R"({"elastomer": {"shift": {"kind": "table", "table": )";
  EXPECT_THAT(
      errorOf(
          head +
          R"([{"temperature": 300, "log10_shift": 0}, {"temperature": 290, "log10_shift": 1}]}}})"),
      HasSubstr("elastomer.shift.table[1].temperature: 290 K is not above the 300 K"));
  EXPECT_THAT(errorOf(head + "[]}}}"), HasSubstr("has 0 rows; allowed is a list of 1 to 1000"));
  EXPECT_THAT(errorOf(head + R"([{"temperature": 300}]}}})"),
              HasSubstr("[0].log10_shift: is missing"));
  EXPECT_THAT(errorOf(kNamed, {"elastomer.temperature=279"}),
              HasSubstr("elastomer.temperature: 279 K is outside the shift table, 280 to 300 K"));
  EXPECT_EQ(errorOf(kNamed, {"elastomer.temperature=280"}), "no error");
}

}  // namespace
}  // namespace asperity
