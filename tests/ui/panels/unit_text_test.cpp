#include "ui/panels/unit_text.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(UnitText, EngineeringUnitsBecomePlainOnes) {
  EXPECT_EQ(inPlainUnit("10 MPa", "Pa"), "1e7");
  EXPECT_EQ(inPlainUnit("3.4 mN", "N").toDouble(), 0.0034);
  EXPECT_EQ(inPlainUnit("20 mm", "m").toDouble(), 0.02);
  EXPECT_EQ(inPlainUnit("0.5ms", "s").toDouble(), 0.0005);
  EXPECT_EQ(inPlainUnit("1e1 kPa", "Pa").toDouble(), 1e4);
  EXPECT_EQ(inPlainUnit("-2.5 mm/s", "m/s").toDouble(), -0.0025);
  EXPECT_EQ(inPlainUnit("3 kPa s", "Pa s").toDouble(), 3000);
  EXPECT_EQ(inPlainUnit(QStringLiteral("3 Pa·s"), "Pa s").toDouble(), 3);
}

TEST(UnitText, MicroIsWrittenInThreeWays) {
  for (const QString& text : {QStringLiteral("7 um"), "7 " + QString(QChar(0xb5)) + "m",
                              "7 " + QString(QChar(0x3bc)) + "m"})
    EXPECT_EQ(inPlainUnit(text, "m").toDouble(), 7e-6) << text.toStdString();
}

TEST(UnitText, AUnitWithoutPrefixIsNotTakenForOne) {
  EXPECT_EQ(inPlainUnit("2 m", "m").toDouble(), 2);
  EXPECT_EQ(inPlainUnit("2 mm", "m").toDouble(), 0.002);
  EXPECT_EQ(inPlainUnit("2 m/s", "m/s").toDouble(), 2);
}

TEST(UnitText, WhatHasNoUnitOrAnotherOneIsLeftAsItIs) {
  for (const char* text : {"0.125", "1e7", "10 MN", "ten", "", "5 e", "1.2.3 m", "2 PA"})
    EXPECT_EQ(inPlainUnit(text, "Pa"), text);
  EXPECT_EQ(inPlainUnit("3 m", ""), "3 m");
  EXPECT_EQ(inPlainUnit(QStringLiteral("25 °C"), "K"), QStringLiteral("25 °C"));
}

}  // namespace
}  // namespace asperity
