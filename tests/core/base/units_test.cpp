#include "core/base/units.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>

namespace asperity {
namespace {

double typed(std::string_view text, std::string_view unit, bool isTemperature = false) {
  const TypedQuantity quantity = typedQuantity(text, {unit, isTemperature, false});
  return quantity.value.value_or(std::nan(""));
}

std::string refusal(std::string_view text, std::string_view unit) {
  const TypedQuantity quantity = typedQuantity(text, {unit, false, false});
  EXPECT_FALSE(quantity.value) << text;
  return quantity.refusal.english();
}

/// A prefix is a power of ten of the decimal text, so the number is the nearest one to what was
/// typed and not a rounded product.
TEST(Units, APrefixShiftsTheDecimalPointExactly) {
  EXPECT_EQ(typed("20mN", "N"), 0.02);
  EXPECT_EQ(typed("20 mm", "m"), 0.02);
  EXPECT_EQ(typed("3.4 mN", "N"), 0.0034);
  EXPECT_EQ(typed("0.7e1 \u00B5m", "m"), 7e-6);
  EXPECT_EQ(typed("7 \u03BCm", "m"), 7e-6);
  EXPECT_EQ(typed("7um", "m"), 7e-6);
  EXPECT_EQ(typed("10MPa", "Pa"), 1e7);
  EXPECT_EQ(typed("10 mPa", "Pa"), 0.01);
  EXPECT_EQ(typed("-2.5 mm/s", "m/s"), -0.0025);
  EXPECT_EQ(typed("80 kJ/mol", "J/mol"), 8e4);
  EXPECT_EQ(typed("5 kPa\u00B7s", "Pa s"), 5e3);
  EXPECT_EQ(typed("5 dm", "m"), 0.5);
  EXPECT_EQ(typed("3 hPa", "Pa"), 300);
}

TEST(Units, ANumberWithoutAUnitIsInTheSiUnit) {
  EXPECT_EQ(typed("1e-3", "N"), 1e-3);
  EXPECT_EQ(typed("+.5", ""), 0.5);
  EXPECT_EQ(typed(" 2. ", "m"), 2);
  EXPECT_TRUE(typedQuantity("1e999", {"N"}).isTooLarge);
  for (const char* text : {"", "much", "e5", "--1", "1..2", "1,5", "0x10", "nan", "inf"})
    EXPECT_FALSE(typedQuantity(text, {""}).value) << text;
}

TEST(Units, OtherUnitsHaveTheirSize) {
  EXPECT_DOUBLE_EQ(typed("36 km/h", "m/s"), 10);
  EXPECT_DOUBLE_EQ(typed("1 bar", "Pa"), 1e5);
  EXPECT_DOUBLE_EQ(typed("1 psi", "Pa"), 6894.757293168361);
  EXPECT_DOUBLE_EQ(typed("2 N/mm\u00B2", "Pa"), 2e6);
  EXPECT_DOUBLE_EQ(typed("3 daN/cm\u00B2", "Pa"), 3e5);
  EXPECT_DOUBLE_EQ(typed("3 daN/mm2", "Pa"), 3e7);
  EXPECT_DOUBLE_EQ(typed("2 kp/cm^2", "Pa"), 196133);
  EXPECT_DOUBLE_EQ(typed("2 kgf/mm2", "Pa"), 19613300);
  EXPECT_DOUBLE_EQ(typed("1 lbf/in\u00B2", "Pa"), 6894.757293168361);
  EXPECT_DOUBLE_EQ(typed("4 daN", "N"), 40);
  EXPECT_DOUBLE_EQ(typed("2 min", "s"), 120);
  EXPECT_DOUBLE_EQ(typed("1 kgf", "N"), 9.80665);
  EXPECT_DOUBLE_EQ(typed("3 %", ""), 0.03);
  EXPECT_DOUBLE_EQ(typed("40 \u00B0C", "K", true), 313.15);
  EXPECT_DOUBLE_EQ(typed("32\u00B0F", "K", true), 273.15);
  EXPECT_DOUBLE_EQ(typed("1 in", "m"), 0.0254);
  EXPECT_DOUBLE_EQ(typed("10 mm s^-1", "m/s"), 0.01);
  EXPECT_DOUBLE_EQ(typed("1 N/mm", "N/m"), 1000);
}

TEST(Units, AUnitOfAnotherDimensionIsRefusedByName) {
  EXPECT_EQ(refusal("20mm", "N"), "20mm is a length; expected a force, such as 3.4 mN");
  EXPECT_EQ(refusal("5 kg", "m"), "5 kg is a mass; expected a length, such as 20 mm");
  EXPECT_EQ(refusal("3 N", ""), "3 N is a force; expected a pure number, such as 0.5");
  EXPECT_EQ(refusal("5 stone", "N"),
            "'stone' is not a known unit; expected a force, such as 3.4 mN");
  EXPECT_EQ(refusal("40 \u00B0C", "K"),
            "40 \u00B0C is a temperature; expected a difference of temperatures, such as 300 K");
  EXPECT_EQ(refusal("5 %", "N"), "5 % is a share; expected a force, such as 3.4 mN");
  EXPECT_EQ(refusal("0.5x", ""), "");
}

/// Each unit reads back: one of it, typed, is what it says of itself.
TEST(Units, EveryDimensionTakesItsPrefixes) {
  for (const char* si : {"m", "Pa", "N", "m/s", "s", "Hz", "N/m", "Pa s", "J", "W", "V"})
    for (const auto& [prefix, exponent] : {std::pair{"", 0},
                                           {"f", -15},
                                           {"p", -12},
                                           {"n", -9},
                                           {"u", -6},
                                           {"m", -3},
                                           {"k", 3},
                                           {"M", 6},
                                           {"G", 9}}) {
      const auto unit = findUnit(std::string(prefix) + si, si);
      ASSERT_TRUE(unit) << prefix << si;
      EXPECT_EQ(unit->exponent, exponent) << prefix << si;
      EXPECT_EQ(unit->si, si);
    }
}

/// Instruments write KHZ and MPA; where a small letter may be two prefixes, only those are taken
/// that measure anything.
TEST(Units, AreReadInAnyCaseWhereThatLeavesNoDoubt) {
  const auto size = [](const char* name, const char* si) { return unitSize(name, si).value_or(0); };
  EXPECT_EQ(size("mPa", "Pa"), 1e-3);
  for (const char* mega : {"MPa", "MPA", "mpa", "Mpa", "N/MM2", "n/mm\u00B2"})
    EXPECT_EQ(size(mega, "Pa"), 1e6) << mega;
  EXPECT_EQ(size("KPA", "Pa"), 1e3);
  EXPECT_EQ(size("KHZ", "Hz"), 1e3);
  EXPECT_EQ(size("MS", "s"), 1e-3);
  EXPECT_EQ(size("mn", "N"), 0) << "millinewtons or meganewtons";
  EXPECT_EQ(size("\u00B0C", "K"), 0) << "has another zero, so no size says it all";
  EXPECT_EQ(unitInAnyCase("c", "K")->toSi(25), 298.15);
  for (const char* symbol : {"FN", "Fn", "fN"}) EXPECT_EQ(size(symbol, "N"), 0) << symbol;
  EXPECT_EQ(size("fPa", "Pa"), 0);
  EXPECT_EQ(size("fm/s", "m/s"), 0);
}

/// A factor that is written as a power of ten belongs to the unit; "100 N" and "10-20 N" may be a
/// load or a range.
TEST(Units, MayHaveAPowerOfTenInFront) {
  const auto toSi = [](const char* name, const char* si) {
    const auto unit = unitInAnyCase(name, si);
    return unit ? unit->toSi(5) : 0;
  };
  for (const char* name : {"10^-3 m/s", "1e-3 m/s", "10\u207B\u00B3 m/s",
                           "\u00D710\u207B\u00B3 m/s", "x 10^-3 m/s", "x10-3 m/s", "10^-3*m/s"})
    EXPECT_EQ(toSi(name, "m/s"), 5e-3) << name;
  EXPECT_EQ(toSi("10^3 N", "N"), 5e3);
  EXPECT_EQ(toSi("10^-3 kN", "N"), 5);
  EXPECT_EQ(toSi("10^-2", ""), 5e-2);
  for (const char* name : {"100 N", "10-3 N", "10-20 N", "0.1 N", "1/100 N", "10^-3", "10^3 m"})
    EXPECT_EQ(toSi(name, "N"), 0) << name;
  EXPECT_EQ(toSi("10^3 \u00B0C", "K"), 0);
}

/// Messages name what is read.
TEST(Units, AreListedFromTheirTable) {
  EXPECT_EQ(unitNames("Pa"),
            "Pa, kPa, MPa, GPa, N/m2, N/mm2, N/cm2, kN/m2, daN/cm2, daN/mm2, kgf/cm2, kgf/mm2, "
            "dyn/cm2, Torr, bar, mbar, atm, psi, ksi");
  EXPECT_EQ(unitNames("m/s"),
            "m/s, cm/s, mm/s, \u00B5m/s, km/h, mph, in/s, ft/s, knots, m/min, cm/min, mm/min, "
            "in/min, ft/min");
}

/// Frequencies in cycles and angular frequencies in radians or degrees, per any unit of time.
TEST(Units, FrequenciesHaveManyUnits) {
  constexpr double kTurn = 2 * std::numbers::pi;
  for (const auto& [unit, hertz] : {std::pair("Hz", 1.0),
                                    {"kHz", 1e3},
                                    {"cycles/s", 1},
                                    {"1/min", 1.0 / 60},
                                    {"min-1", 1.0 / 60},
                                    {"rpm", 1.0 / 60},
                                    {"U/min", 1.0 / 60},
                                    {"rad/s", 1 / kTurn},
                                    {"krad/s", 1e3 / kTurn},
                                    {"mrad/s", 1e-3 / kTurn},
                                    {"Mrad/s", 1e6 / kTurn},
                                    {"rad/min", 1 / kTurn / 60},
                                    {"rad/ms", 1e3 / kTurn},
                                    {"radians/sec", 1 / kTurn},
                                    {"rad s^-1", 1 / kTurn},
                                    {"rad\u00B7s\u207B\u00B9", 1 / kTurn},
                                    {"10^3 rad/s", 1e3 / kTurn},
                                    {"rad.s-1", 1 / kTurn},
                                    {"rad\u00B7s\u22121", 1 / kTurn},
                                    {"rads-1", 1 / kTurn},
                                    {"rad min-1", 1 / kTurn / 60},
                                    {"rad/Sek.", 1 / kTurn},
                                    {"radians/sec.", 1 / kTurn},
                                    {"radians per second", 1 / kTurn},
                                    {"\u0440\u0430\u0434/\u0441\u0435\u043A", 1 / kTurn},
                                    {"deg/s", 1.0 / 360},
                                    {"\u0440\u0430\u0434/\u0441", 1 / kTurn},
                                    {"\u0413\u0446", 1}})
    EXPECT_NEAR(frequencySize(unit, false).value_or(0), hertz, 1e-12 * hertz) << unit;
  EXPECT_NEAR(frequencySize("1/s", true).value_or(0), 1 / kTurn, 1e-12);
  EXPECT_NEAR(frequencySize("1/s", false).value_or(0), 1, 1e-12);
  for (const char* none :
       {"", "1", "m/s", "N/s", "rad/mm", "rad/Hz", "1/mm", "-1", "Pa-1", "furlong"})
    EXPECT_FALSE(frequencySize(none, true)) << none;
}

TEST(Units, RussianLettersAreThoseOfTheSameUnits) {
  for (const auto& [written, si, size] : {std::tuple("\u041C\u041F\u0430", "Pa", 1e6),
                                          {"\u043C\u043C/\u0441", "m/s", 1e-3},
                                          {"\u043A\u041D", "N", 1e3},
                                          {"\u043C\u041D", "N", 1e-3},
                                          {"\u043C\u043A\u043C", "m", 1e-6},
                                          {"\u0441\u043C", "m", 1e-2},
                                          {"\u043A\u0433\u0441/\u0441\u043C\u00B2", "Pa", 98066.5}})
    EXPECT_NEAR(unitSize(written, si).value_or(0), size, 1e-9 * size) << written;
}

TEST(Units, AVelocityIsAnyLengthOverAnyTime) {
  EXPECT_NEAR(unitSize("mm/h", "m/s").value_or(0), 1e-3 / 3600, 1e-18);
  EXPECT_NEAR(unitSize("\u00B5m/min", "m/s").value_or(0), 1e-6 / 60, 1e-20);
  EXPECT_NEAR(unitSize("m/ms", "m/s").value_or(0), 1e3, 1e-9);
  EXPECT_FALSE(unitSize("m/m", "m/s"));
  EXPECT_FALSE(unitSize("N/s", "m/s"));
  EXPECT_EQ(findUnit("km/h")->toSi(3.6), 1);
}

}  // namespace
}  // namespace asperity
