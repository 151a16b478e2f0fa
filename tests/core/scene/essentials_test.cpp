// The few parameters that matter first, and the row that a note is about.
#include "core/scene/essentials.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/scene/parameters.h"

namespace asperity {
namespace {

/// One scene for every word of every choice, and for all pairs of the four kinds.
std::vector<Scene> scenesOfAllKinds() {
  std::vector<Scene> scenes;
  for (const char* surface :
       {"self_affine", "sine", "wedge", "parabola", "profile", "measured", "spectrum"})
    for (const char* rheology : {"elastic", "kelvin", "standard_solid", "prony"})
      for (const char* load : {"force", "indentation", "pressure"})
        for (const char* sliding : {"steady", "start", "step", "oscillation", "reversal"}) {
          Scene scene;
          setValue(*findParameter("surface.kind"), scene, std::string(surface));
          setValue(*findParameter("elastomer.rheology"), scene, std::string(rheology));
          setValue(*findParameter("load.kind"), scene, std::string(load));
          setValue(*findParameter("sliding.kind"), scene, std::string(sliding));
          scenes.push_back(scene);
        }
  return scenes;
}

bool has(const std::vector<std::string_view>& keys, std::string_view section) {
  return std::ranges::any_of(keys, [&](std::string_view key) { return key.starts_with(section); });
}

TEST(Essentials, AreFewAndHaveAMeaningInEveryKindOfScene) {
  for (Scene scene : scenesOfAllKinds())
    for (const char* material : {"", "sylgard_184"}) {
      scene.elastomer.material = material;
      const std::vector<std::string_view> keys = essentialKeys(scene);
      EXPECT_LE(keys.size(), kMaxEssentials);
      for (const std::string_view key : keys) {
        ASSERT_NE(findParameter(key), nullptr) << key;
        EXPECT_TRUE(isApplicable(*findParameter(key), scene)) << key;
        EXPECT_EQ(std::ranges::count(keys, key), 1) << key;
      }
      for (const char* section : {"sliding.velocity", "load.", "elastomer.", "surface."})
        EXPECT_TRUE(has(keys, section)) << section;
    }
}

TEST(Essentials, AreWithoutConstantsSeedAndElements) {
  for (const Scene& scene : scenesOfAllKinds())
    for (const char* rest : {"elastomer.shift.", "surface.seed", "surface.elements", "accuracy."})
      EXPECT_FALSE(has(essentialKeys(scene), rest)) << rest;
}

TEST(Essentials, ANoteIsAboutARowThatHasAMeaning) {
  for (const Scene& scene : scenesOfAllKinds())
    for (std::size_t i = 0; i < kNotes; ++i) {
      const std::string_view key = noteKey(static_cast<Note>(i), scene);
      ASSERT_NE(findParameter(key), nullptr) << key;
      EXPECT_TRUE(isApplicable(*findParameter(key), scene)) << key;
    }
  EXPECT_EQ(noteKey(Note::SlopeAbove, {}), "surface.rms_height");
  EXPECT_EQ(noteKey(Note::FewContacts, {}), "load.normal_force");
}

}  // namespace
}  // namespace asperity
