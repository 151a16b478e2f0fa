// What is explained under the pointer: everything that has a symbol, an axis or a number.
#include "core/chart/explanations.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "core/friction/curve_quantity.h"
#include "core/friction/theory_curve.h"
#include "core/scene/parameters.h"

namespace asperity {
namespace {

TEST(Explanations, EveryParameterHasASentenceAndAPlace) {
  for (const Parameter& row : parameters()) {
    const auto found = findExplanation(row.key);
    ASSERT_TRUE(found) << row.key;
    EXPECT_EQ(found->sentence, row.sentence);
    EXPECT_FALSE(found->guideAnchor.empty()) << row.key;
  }
}

TEST(Explanations, EveryQuantityOfAnAxisHasAFormula) {
  for (const QuantityEntry& entry : quantityEntries()) {
    const auto found = findExplanation(std::string_view(entry.word));
    ASSERT_TRUE(found) << entry.title;
    EXPECT_FALSE(found->formula.empty()) << entry.title;
    EXPECT_FALSE(found->sentence.empty()) << entry.title;
  }
}

TEST(Explanations, RegionsTheoriesAndEquationsAreThere) {
  for (const char* region : {"I", "II", "III", "IV"})
    EXPECT_TRUE(findExplanation(std::string_view("region " + std::string(region)))) << region;
  for (const TheoryEntry& entry : theoryEntries())
    EXPECT_TRUE(findExplanation(std::string_view(entry.name))) << entry.name;
  for (int number = 1; number <= 17; ++number)
    EXPECT_TRUE(findExplanation(std::string_view("Eq. (" + std::to_string(number) + ")")));
}

TEST(Explanations, ANameThatAUserGaveHasNone) {
  EXPECT_FALSE(findExplanation(Message::name("G = 20 MPa")));
  EXPECT_FALSE(findExplanation(Message()));
  EXPECT_FALSE(findExplanation(std::string_view("no.such.key")));
}

TEST(Explanations, IdsAreUniqueAndEachOneIsFoundWhole) {
  std::set<std::string_view> ids;
  for (const HoverExplanation& one : explanations()) {
    EXPECT_TRUE(ids.insert(one.id).second) << one.id;
    const auto found = findExplanation(one.id);
    ASSERT_TRUE(found) << one.id;
    EXPECT_FALSE(found->sentence.empty()) << one.id;
    EXPECT_EQ(found->guideAnchor, one.guideAnchor);
  }
}

/// A material of arms has no single viscosity.
TEST(Explanations, ElementsWithArmsHaveTheirOwnFormulas) {
  for (const char* id : {"load.normal_force", "sliding.velocity", "tangential_force", "elastomer",
                         "line load", "glow of the pressure", "dissipated power"}) {
    const HoverExplanation plain = *findExplanation(std::string_view(id));
    EXPECT_EQ(withFormulaFor(plain, Rheology::Kelvin).formula, plain.formula) << id;
    for (const Rheology rheology : {Rheology::StandardSolid, Rheology::Prony})
      EXPECT_NE(withFormulaFor(plain, rheology).formula.find("G_i s_i"), std::string_view::npos)
          << id;
  }
  const HoverExplanation same = *findExplanation(std::string_view("mu"));
  EXPECT_EQ(withFormulaFor(same, Rheology::Prony).formula, same.formula);
}

/// The places are headings ("{#law}") or equations ("#eq-11") of the guide's own text.
TEST(Explanations, TheGuideHasEveryPlace) {
  std::string guide;
  for (const auto& entry : std::filesystem::directory_iterator(ASPERITY_RESOURCES_DIR "/guide")) {
    if (entry.path().extension() != ".md") continue;
    std::ifstream in(entry.path());
    guide.append(std::istreambuf_iterator<char>(in), {});
  }
  std::set<std::string> anchors;
  for (const HoverExplanation& one : explanations()) anchors.emplace(one.guideAnchor);
  for (const Parameter& row : parameters()) anchors.emplace(findExplanation(row.key)->guideAnchor);
  for (const std::string& anchor : anchors)
    EXPECT_NE(guide.find("#" + anchor + "}"), std::string::npos) << anchor;
}

}  // namespace
}  // namespace asperity
