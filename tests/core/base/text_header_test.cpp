// The lines above a table: names of columns, units, keys and quantities.
#include "core/base/text_header.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>

namespace asperity {
namespace {

TEST(TextHeader, FindsUnitsInNames) {
  const auto expect = [](const std::string& text, const std::string& name,
                         const std::string& unit) {
    const TextColumn found = parseColumnName(text);
    EXPECT_EQ(found.name, name) << text;
    EXPECT_EQ(found.unit, unit) << text;
  };
  expect("x (mm)", "x", "mm");
  expect("x[mm]", "x", "mm");
  expect("z/um", "z", "um");
  expect("z / \u00B5m", "z", "\u00B5m");
  expect("Height [\u03BCm]", "Height", "\u03BCm");
  expect("freq_Hz", "freq", "Hz");
  expect("x in mm", "x", "mm");
  expect("hauteur en \u00B5m", "hauteur", "\u00B5m");
  expect("altura em mm", "altura", "mm");
  expect("x, mm", "x", "mm");
  expect("x mm", "x", "mm");
  expect("X_(microns)", "X", "microns");
  expect("z_m", "z", "m");
  expect("v / m/s", "v", "m/s");
  expect("v_m/s", "v", "m/s");
  expect("T [\u00B0C]", "T", "\u00B0C");
  expect("omega (rad/s)", "omega", "rad/s");
  // Names without special letters spell quotients and products.
  expect("velocity_m_s", "velocity", "m/s");
  expect("sliding_speed_mm_s", "sliding_speed", "mm/s");
  expect("v_mm_per_s", "v", "mm/s");
  expect("v km per h", "v", "km/h");
  expect("v_mm_s-1", "v", "mm s-1");
  expect("v_in_mm_min", "v", "mm/min");
  expect("v_mps", "v", "mps");
  expect("omega_rad_s", "omega", "rad/s");
  expect("p_N_mm2", "p", "N/mm2");
  expect("eta_MPa_s", "eta", "MPa s");
  expect("storage_modulus_MPa_mean", "storage_modulus_MPa_mean", "");
  expect("Height (1e-6 m)", "Height", "1e-6 m");
  for (const char* between : {" / ", "/", " in ", ", ", " "}) {
    expect(std::string("v") + between + "10^-3 m/s", "v", "10^-3 m/s");
    expect(std::string("h") + between + "10\u207B\u00B3 mm", "h", "10\u207B\u00B3 mm");
  }
  // Such a factor may have multiplied the values, and a number is none.
  expect("h \u00D7 10^-3 (mm)", "h \u00D7 10^-3", "mm");
  expect("sample 10 mm", "sample 10", "mm");
  expect("E' (MPa)", "E'", "MPa");
  expect("E_s", "E_s", "");
  expect("Storage modulus (E')", "Storage modulus (E')", "");
  expect("Storage modulus E' [MPa]", "Storage modulus E'", "MPa");
  expect("z [furlong]", "z", "furlong");
  expect("tan(delta)", "tan(delta)", "");
  expect("w/o filter", "w/o filter", "");
  expect("height_raw", "height_raw", "");
  expect("\"x (mm)\"", "x", "mm");
}

/// The decimal mark of a file says which mark of a header separates thousands.
TEST(TextHeader, ReadsThousandsOfQuantities) {
  const auto number = [](const char* text, std::optional<char> decimal) {
    return parseQuantity(text, decimal).value_or(TextQuantity{}).number;
  };
  EXPECT_EQ(number("4.000 N", {}), 4);
  EXPECT_EQ(number("4.000 N", '.'), 4);
  EXPECT_EQ(number("4.000 N", ','), 4000);
  EXPECT_EQ(number("1,000 N", '.'), 1000);
  EXPECT_EQ(number("1,000 N", ','), 1);
  EXPECT_EQ(number("\u20131.234,5 N", ','), -1234.5);
  EXPECT_EQ(number("12 345 N", ','), 12345);
  EXPECT_EQ(number("1'000 N", '.'), 1000);
  EXPECT_EQ(number("0.200 N", ','), 0.2);
  EXPECT_EQ(number("0,3 N", '.'), 0.3);
  EXPECT_TRUE(parseQuantity("4.000 N", ',')->isGrouped);
  EXPECT_FALSE(parseQuantity("30 N", ',')->isGrouped);
  EXPECT_EQ(parseQuantity("12 345 N", ',')->unit, "N");
}

TEST(TextHeader, AUnitMayStandInFrontOfItsNumber) {
  const TextDialect semicolon{TextDialect::Separator::Semicolon, '.'},
      comma{TextDialect::Separator::Comma, '.'};
  EXPECT_EQ(parseEntry({"Temperature;\u00B0C;23", 1}, semicolon).value, "23 \u00B0C");
  EXPECT_EQ(parseEntry({"Load,[N],50", 1}, comma).value, "50 N");
  EXPECT_EQ(parseEntry({"Load;50;N", 1}, semicolon).value, "50 N");
  EXPECT_EQ(parseEntry({"Normal force;N;50", 1}, semicolon).value, "50 N");
  // A letter may be a name.
  EXPECT_EQ(parseEntry({"Compound;C;23", 1}, semicolon).value, "C 23");
  EXPECT_EQ(parseEntry({"Batch,C,12", 1}, comma).value, "C 12");
  EXPECT_EQ(parseEntry({"Sample;N;50", 1}, semicolon).value, "N 50");
  EXPECT_EQ(parseEntry({"Material;PA;6", 1}, semicolon).value, "PA 6");
  EXPECT_EQ(parseEntry({"Test;K;3", 1}, semicolon).value, "K 3");
  // A spreadsheet quotes a line with commas, and writes the empty cells behind it.
  const TextEntry quoted = parseEntry({"\"Temperature: 5 \u00B0C\",,", 1}, comma);
  EXPECT_EQ(quoted.key, "Temperature");
  EXPECT_EQ(quoted.value, "5 \u00B0C");
  EXPECT_EQ(parseEntry({"'Load: 5 N',,", 1}, comma).value, "5 N");
}

TEST(TextHeader, AWordSuchAsAtBelongsToTheNameBeforeIt) {
  const TextDialect semicolon{TextDialect::Separator::Semicolon, '.'};
  for (const char* line : {"COF at load (N)", "Coefficient of friction at load (N)"})
    for (const std::size_t columns : {2, 3, 4})
      EXPECT_TRUE(splitNames(line, semicolon, columns).empty()) << line << columns;
  EXPECT_EQ(splitNames("speed COF load (N)", semicolon, 3).size(), 3U);
  const TextDialect blanks{TextDialect::Separator::Blanks, '.'};
  EXPECT_EQ(splitNames("speed COF at load (N)", blanks, 2).back(), "COF at load (N)");
  // Shift factors
  EXPECT_EQ(splitNames("T (\u00B0C) at", blanks, 2).back(), "at");
  for (const char* line : {"T (\u00B0C) at bt", "T at bt", "f aT at"})
    EXPECT_EQ(splitNames(line, blanks, 3).size(), 3U) << line;
  EXPECT_EQ(splitNames("T (\u00B0C) at bt", semicolon, 3).back(), "bt");
}

}  // namespace
}  // namespace asperity
