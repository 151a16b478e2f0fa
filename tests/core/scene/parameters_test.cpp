#include "core/scene/parameters.h"

#include <gmock/gmock.h>

#include <limits>
#include <set>

#include "core/base/input_error.h"

namespace asperity {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

TEST(Parameters, KeysAreUniqueAndEveryRowIsComplete) {
  std::set<std::string_view> keys;
  for (const Parameter& row : parameters()) {
    EXPECT_TRUE(keys.insert(row.key).second) << row.key;
    EXPECT_FALSE(row.label.empty()) << row.key;
    EXPECT_TRUE(row.sentence.ends_with('.')) << row.key;
    if (!row.applies.choiceKey.empty()) {
      EXPECT_NE(findParameter(row.applies.choiceKey), nullptr);
    }
  }
}

TEST(Parameters, DefaultsLieInsideTheirOwnRangesAndSliders) {
  for (const Parameter& row : parameters()) {
    Scene scene;
    EXPECT_NO_THROW(setValue(row, scene, defaultValue(row))) << row.key;
    if (const auto* real = std::get_if<RealField>(&row.field)) {
      const double usual = std::get<double>(defaultValue(row));
      const bool isNone = real->scale == Scale::LogarithmicFromNone && usual == 0;
      EXPECT_TRUE(usual >= real->sliderFrom || isNone) << row.key;
      EXPECT_LE(usual, real->sliderTo) << row.key;
      EXPECT_GE(real->sliderFrom, real->minimum) << row.key;
      EXPECT_LE(real->sliderTo, real->maximum) << row.key;
      if (real->scale != Scale::Linear) {
        EXPECT_GT(real->sliderFrom, 0) << row.key;
      }
    }
  }
}

TEST(Parameters, EachRowSetsItsOwnMember) {
  for (const Parameter& row : parameters()) {
    if (!std::holds_alternative<RealField>(row.field)) continue;
    Scene scene;
    const double usual = std::get<double>(defaultValue(row));
    const double other = usual != 0 ? 0.75 * usual : 0.5 * std::get<RealField>(row.field).sliderTo;
    setValue(row, scene, other);
    for (const Parameter& each : parameters()) {
      if (each.key == row.key) {
        EXPECT_EQ(std::get<double>(parameterValue(each, scene)), other) << row.key;
      } else {
        EXPECT_EQ(parameterValue(each, scene), defaultValue(each))
            << row.key << " changed " << each.key;
      }
    }
  }
}

TEST(Parameters, BadValuesAreRefusedAndLeaveTheSceneAsItWas) {
  const Parameter& hurst = *findParameter("surface.hurst");
  const Parameter& elements = *findParameter("surface.elements");
  const Parameter& scheme = *findParameter("accuracy.scheme");
  Scene scene;
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {1.4, -0.1, infinity, -infinity, std::nan("")})
    EXPECT_THROW(setValue(hurst, scene, bad), InputError);
  EXPECT_THROW(setFromText(hurst, scene, "smooth"), InputError);
  EXPECT_THROW(setFromText(hurst, scene, "0.5x"), InputError);
  EXPECT_THROW(setFromText(hurst, scene, ""), InputError);
  EXPECT_THROW(setFromText(hurst, scene, "1e999"), InputError);
  EXPECT_THROW(setValue(elements, scene, 3.5), InputError);
  EXPECT_THROW(setValue(elements, scene, std::int64_t{2}), InputError);
  EXPECT_THROW(setValue(scheme, scene, std::string("quartic")), InputError);
  EXPECT_THROW(setValue(scheme, scene, 1.0), InputError);
  EXPECT_EQ(scene, Scene{});
}

TEST(Parameters, MicrometresMayBeWrittenWithEitherMicroSign) {
  Scene scene;
  for (const char* unit : {"um", "\u00B5m", "\u03BCm"}) {
    setFromText(*findParameter("surface.height_unit"), scene, "mm");
    setFromText(*findParameter("surface.height_unit"), scene, unit);
    EXPECT_EQ(parameterValue(*findParameter("surface.height_unit"), scene), ParameterValue("um"))
        << unit;
  }
}

TEST(Parameters, MilsMayBeWrittenAsThou) {
  Scene scene;
  for (const char* unit : {"mil", "mils", "thou"}) {
    setFromText(*findParameter("surface.height_unit"), scene, "mm");
    setFromText(*findParameter("surface.height_unit"), scene, unit);
    EXPECT_EQ(parameterValue(*findParameter("surface.height_unit"), scene), ParameterValue("mil"))
        << unit;
  }
}

TEST(Parameters, MessagesSayWhatIsWrongAndWhatIsAllowed) {
  Scene scene;
  try {
    setValue(*findParameter("surface.hurst"), scene, 1.4);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "surface.hurst: 1.4 is outside 0 to 1");
  }
}

/// A double would show 2^53 + 1 as 2^53.
TEST(Parameters, ARefusedWholeNumberIsShownWithEveryDigit) {
  Scene scene;
  const auto refusal = [&](const ParameterValue& value, bool isText) -> std::string {
    try {
      if (isText)
        setFromText(*findParameter("surface.seed"), scene, std::get<std::string>(value));
      else
        setValue(*findParameter("surface.seed"), scene, value);
      return "none";
    } catch (const InputError& error) {
      return error.what();
    }
  };
  const std::string text = "surface.seed: 9007199254740993 is outside 0 to 9007199254740991";
  EXPECT_EQ(refusal(std::int64_t{9007199254740993}, false), text);
  EXPECT_EQ(refusal("9007199254740993", true), text);
  EXPECT_EQ(refusal("9007199254740991", true), "none");
  EXPECT_EQ(scene.surface.seed, 9007199254740991);
}

TEST(Parameters, NearestKeyForgivesTypingErrors) {
  EXPECT_EQ(nearestKey("surface.hurts"), "surface.hurst");
  EXPECT_EQ(nearestKey("load.normalforce"), "load.normal_force");
  EXPECT_EQ(nearestKey("interface.friction"), "interface.friction_coefficient");
  EXPECT_TRUE(findParameter(nearestKey("surfaces")));
  EXPECT_EQ(nearestKey("surfaces").substr(0, 8), "surface.");
  EXPECT_EQ(nearestKey("surface"), "");
  EXPECT_EQ(nearestKey("foo"), "");
  EXPECT_EQ(nearestKey(std::string(100000, 'x')), "");
}

TEST(Parameters, ApplicabilityFollowsTheKind) {
  Scene scene;
  EXPECT_TRUE(isApplicable(*findParameter("surface.hurst"), scene));
  EXPECT_FALSE(isApplicable(*findParameter("surface.radius"), scene));
  scene.surface.kind = SurfaceKind::Parabola;
  EXPECT_FALSE(isApplicable(*findParameter("surface.hurst"), scene));
  EXPECT_TRUE(isApplicable(*findParameter("surface.radius"), scene));
}

TEST(Parameters, TableTextsNameEveryKey) {
  for (const Parameter& row : parameters()) {
    EXPECT_THAT(parameterTableText(), HasSubstr(std::string(row.key)));
    EXPECT_THAT(parameterListMarkdown(), HasSubstr("`" + std::string(row.key) + "`"));
  }
}

TEST(Parameters, MarkdownKeepsTheTextAsItIs) {
  EXPECT_EQ(escapedMarkdown("<h^2> = 2 a*b | 'c_d'"), R"(\<h\^2\> = 2 a\*b \| \'c\_d\')");
  // What is not escaped is our own: the name as code, its anchor, the sign of a definition.
  EXPECT_THAT(parameterListMarkdown(),
              HasSubstr("[`surface.hurst`]{#key-surface-hurst} 0 to 1; default 0.7\n\n:   How "));
}

TEST(Parameters, EveryNumberOfTheTableIsRefusedWithItsRangeAndUnit) {
  for (const Parameter& row : parameters()) {
    const auto range = allowedRange(row);
    if (!range) continue;
    Scene scene;
    try {
      setValue(row, scene, 2 * range->maximum + 1);
      FAIL() << row.key;
    } catch (const InputError& error) {
      EXPECT_THAT(error.message().english(), EndsWith(" is outside " + allowedText(row).english()));
      if (!row.unit.empty()) {
        EXPECT_THAT(error.message().english(), EndsWith(" " + std::string(row.unit)));
      }
    }
  }
}

}  // namespace
}  // namespace asperity
