// What is typed in the entries, and why it is refused.
#include "ui/panels/number_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace asperity {
namespace {

using testing::HasSubstr;

NumberRule numberRule(const char* key) {
  return numberRule(*findParameter(key));
}

std::string refusal(const char* key, const char* text) {
  return validationError(QString::fromUtf8(text), numberRule(key)).toStdString();
}

double plain(const char* key, const char* text) {
  return toPlainNumber(QString::fromUtf8(text), numberRule(key)).toDouble();
}

TEST(TypedNumber, RangesAreInReadableUnits) {
  const auto allowed = [](const char* key) {
    return allowedInWords(numberRule(key)).toStdString();
  };
  EXPECT_EQ(allowed("elastomer.shear_modulus"), "1 \u00B5Pa to 1 PPa");
  EXPECT_EQ(allowed("surface.length"), "1 nm to 1000 m");
  EXPECT_EQ(allowed("surface.hurst"), "0 to 1");
  EXPECT_EQ(allowed("elastomer.temperature"), "1 to 2000 K");
  EXPECT_EQ(allowed("surface.elements"), "3 to 16777216");
  EXPECT_EQ(allowed("sliding.velocity"), "0 to 10\u00B9\u00B2 m/s");
}

/// A value at the end of a range is typed as it is printed, and one beyond it is refused.
TEST(TypedNumber, WhatIsRefusedIsWhatTheTableRefuses) {
  for (const Parameter& row : parameters()) {
    const auto range = allowedRange(row);
    if (!range) continue;
    const NumberRule rule = numberRule(row);
    for (const double value :
         {range->minimum, range->maximum, 2 * range->maximum + 1, range->minimum - 1}) {
      Scene scene;
      bool taken = true;
      try {
        setValue(row, scene, value);
      } catch (const std::exception&) {
        taken = false;
      }
      const QString text = QString::number(value, 'g', 17);
      EXPECT_EQ(validationError(text, rule).isEmpty(), taken) << row.key << " " << value;
      if (!taken) {
        EXPECT_THAT(validationError(text, rule).toStdString(),
                    HasSubstr(allowedInWords(rule).toStdString()));
      }
    }
  }
}

TEST(TypedNumber, AnotherDimensionIsExplained) {
  EXPECT_EQ(refusal("surface.length", "5 kg"), "5 kg is a mass; expected a length, such as 20 mm");
  EXPECT_EQ(refusal("surface.length", "40 °C"),
            "40 °C is a temperature; expected a length, such as 20 mm");
  EXPECT_EQ(refusal("elastomer.shear_modulus", "3 mm"),
            "3 mm is a length; expected a modulus or pressure, such as 10 MPa");
  EXPECT_EQ(refusal("surface.hurst", "3 N"), "3 N is a force; expected a pure number, such as 0.5");
  EXPECT_EQ(refusal("elastomer.shift.c2", "40 °C"),
            "40 °C is a temperature; expected a difference of temperatures, such as 300 K");
  EXPECT_EQ(refusal("load.normal_force", "5 stone"),
            "'stone' is not a known unit; expected a force, such as 3.4 mN");
  EXPECT_EQ(refusal("surface.hurst", "0.5x"), "“0.5x” is not a number; allowed is 0 to 1");
  EXPECT_EQ(refusal("load.normal_force", "much"),
            "“much” is not a number; allowed is 10\u207B\u00B3\u2070 to 10\u00B3\u2070 N");
}

TEST(TypedNumber, OtherUnitsOfTheSameDimensionAreTaken) {
  EXPECT_DOUBLE_EQ(plain("elastomer.temperature", "40 °C"), 313.15);
  EXPECT_DOUBLE_EQ(plain("elastomer.temperature", "32 °F"), 273.15);
  EXPECT_DOUBLE_EQ(plain("elastomer.shear_modulus", "3 bar"), 3e5);
  EXPECT_DOUBLE_EQ(plain("elastomer.relaxation_time", "2 min"), 120);
  EXPECT_DOUBLE_EQ(plain("sliding.velocity", "36 km/h"), 10);
  EXPECT_DOUBLE_EQ(plain("accuracy.target_relative_error", "1 %"), 0.01);
  for (const char* text : {"40 °C", "32 °F"}) EXPECT_EQ(refusal("elastomer.temperature", text), "");
  EXPECT_EQ(refusal("elastomer.temperature", "-300 °C"), "-300 °C is outside 1 to 2000 K");
  EXPECT_EQ(refusal("surface.elements", "2.5"),
            "2.5 is not a whole number; allowed is 3 to 16777216");
}

}  // namespace
}  // namespace asperity
