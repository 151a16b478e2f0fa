#include "ui/panels/number_text.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

QString plainText(const QString& text, const char* unit) {
  return toPlainNumber(text, NumberRule{unit});
}

TEST(UnitText, EngineeringUnitsBecomePlainOnes) {
  EXPECT_EQ(plainText("10 MPa", "Pa"), "1e7");
  EXPECT_EQ(plainText("3.4 mN", "N").toDouble(), 0.0034);
  EXPECT_EQ(plainText("20 mm", "m").toDouble(), 0.02);
  EXPECT_EQ(plainText("0.5ms", "s").toDouble(), 0.0005);
  EXPECT_EQ(plainText("1e1 kPa", "Pa").toDouble(), 1e4);
  EXPECT_EQ(plainText("-2.5 mm/s", "m/s").toDouble(), -0.0025);
  EXPECT_EQ(plainText("3 kPa s", "Pa s").toDouble(), 3000);
  EXPECT_EQ(plainText(QStringLiteral("3 Pa·s"), "Pa s").toDouble(), 3);
}

TEST(UnitText, MicroIsWrittenInThreeWays) {
  for (const QString& text : {QStringLiteral("7 um"), "7 " + QString(QChar(0xb5)) + "m",
                              "7 " + QString(QChar(0x3bc)) + "m"})
    EXPECT_EQ(plainText(text, "m").toDouble(), 7e-6) << text.toStdString();
}

TEST(UnitText, AUnitWithoutPrefixIsNotTakenForOne) {
  EXPECT_EQ(plainText("2 m", "m").toDouble(), 2);
  EXPECT_EQ(plainText("2 mm", "m").toDouble(), 0.002);
  EXPECT_EQ(plainText("2 m/s", "m/s").toDouble(), 2);
}

TEST(UnitText, ACommaIsAPoint) {
  EXPECT_EQ(withPoint("2,5"), "2.5");
  EXPECT_EQ(plainText(withPoint("2,5 mm"), "m").toDouble(), 0.0025);
  EXPECT_EQ(withPoint("-1,5e-3 Pa s"), "-1.5e-3 Pa s");
  EXPECT_EQ(withPoint(",5"), ".5");
  EXPECT_EQ(withPoint("2.5 mm"), "2.5 mm");
  for (const char* text : {"1,2,3", "1.000,5", "1,000.5", "a,b", "profile,1.csv", ""})
    EXPECT_EQ(withPoint(text), text);
}

TEST(UnitText, MarksBetweenThousandsAreThoseOfTheLanguage) {
  EXPECT_EQ(withoutGroups("2,560"), "2560");
  EXPECT_EQ(withoutGroups("-1,250,000.5 mm"), "-1250000.5 mm");
  EXPECT_EQ(withoutGroups("2.560"), "2.560");
  for (const char* text : {"2,5", "0,125", "2,5600", "2,560e-3"})
    EXPECT_EQ(withoutGroups(text), withPoint(text));
  useLanguage("de");
  EXPECT_EQ(withoutGroups("2.560"), "2560");
  EXPECT_EQ(withoutGroups("1.250.000,5 mm"), "1250000.5 mm");
  EXPECT_EQ(withoutGroups("2,560"), "2.560");
  for (const char* text : {"2.5", "0.125", "2.5600", "2.560e-3", "1.2.3 m"})
    EXPECT_EQ(withoutGroups(text), text);
  useLanguage("en");
}

TEST(UnitText, WhatHasNoUnitOrAnotherOneIsLeftAsItIs) {
  for (const char* text : {"0.125", "1e7", "10 MN", "ten", "", "5 e", "1.2.3 m", "2 PA"})
    EXPECT_EQ(plainText(text, "Pa"), text);
  EXPECT_EQ(plainText("3 m", ""), "3 m");
  EXPECT_EQ(plainText(QStringLiteral("25 °C"), "K"), QStringLiteral("25 °C"));
}

TEST(UnitText, ValuesAreShownWithThePrefixThatSuitsThem) {
  const auto shown = [](double value, const char* unit) {
    const UnitText text = inReadableUnit(value, unit);
    return (text.number + ' ' + text.unit).toStdString();
  };
  EXPECT_EQ(shown(1e7, "Pa"), "10 MPa");
  EXPECT_EQ(shown(0.0034, "N"), "3.4 mN");
  EXPECT_EQ(shown(0.02, "m"), "20 mm");
  EXPECT_EQ(shown(5e-7, "m"), "500 nm");
  EXPECT_EQ(shown(1e-6, "m"), "1 \u00b5m");
  EXPECT_EQ(shown(999.5, "N"), "999.5 N");
  EXPECT_EQ(shown(1000, "N"), "1 kN");
  EXPECT_EQ(shown(1000, "m/s"), "1000 m/s");
  EXPECT_EQ(shown(-0.25, "m/s"), "-250 mm/s");
  EXPECT_EQ(shown(3e12, "Pa"), "3000 GPa");
  EXPECT_EQ(shown(1e12, "s"), "1e12 s");
  EXPECT_EQ(shown(2.5e-14, "m"), "0.025 pm");
  EXPECT_EQ(shown(1e-30, "N"), "1e-18 pN");
  EXPECT_EQ(shown(298.15, "K"), "298.15 K");
  EXPECT_EQ(shown(0, "m"), "0 m");
  EXPECT_EQ(shown(0.7, ""), "0.7 ");
}

TEST(UnitText, AValueThatIsShownReadsBackToTheVeryNumber) {
  for (double value = 1.2345678901234567e-31; value < 1e31; value *= -3.3333333333333335) {
    const UnitText text = inReadableUnit(value, "N");
    EXPECT_EQ(plainText(inShownUnit(text.number, text.unit), "N").toDouble(), value)
        << text.number.toStdString() << text.unit.toStdString();
  }
}

TEST(UnitText, ANumberAloneIsInTheUnitShown) {
  EXPECT_EQ(inShownUnit("20", "MPa"), "20 MPa");
  EXPECT_EQ(inShownUnit(" .5 ", "mm"), ".5 mm");
  EXPECT_EQ(inShownUnit("2e1", "MPa"), "2e1 MPa");
  for (const char* text : {"20 kPa", "abc", ""}) EXPECT_EQ(inShownUnit(text, "MPa"), text);
  EXPECT_EQ(inShownUnit("5", ""), "5");
}

}  // namespace
}  // namespace asperity
