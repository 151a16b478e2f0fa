// Cells with a number and its error or unit.
#include "core/base/text_cell.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/column_units.h"
#include "core/base/text_table.h"
#include "tests/core/error_from.h"

namespace asperity {
namespace {

struct ExpectedCell {
  const char* text;
  double number, error;
  const char* unit;
};

constexpr double kNoError = -1;  // no error

void expectCell(const ExpectedCell& expected, char decimal) {
  const auto cell = readCell(expected.text, decimal);
  ASSERT_TRUE(cell) << expected.text;
  EXPECT_DOUBLE_EQ(cell->number, expected.number) << expected.text;
  EXPECT_EQ(cell->rest.unit, expected.unit) << expected.text;
  EXPECT_EQ(cell->rest.text, expected.text);
  if (expected.error == kNoError)
    EXPECT_TRUE(std::isnan(cell->rest.error)) << expected.text;
  else
    EXPECT_DOUBLE_EQ(cell->rest.error, expected.error) << expected.text;
}

TEST(TextCell, ReadsErrorsAndUnits) {
  for (const ExpectedCell& expected :
       {ExpectedCell{"0.31 \u00B1 0.02", 0.31, 0.02, ""},
        {"0.31+/-0.02", 0.31, 0.02, ""},
        {"0.31 \u00B1 .02", 0.31, 0.02, ""},
        {"5\u00B710\u207B\u00B3 m/s", 5, kNoError, "\u00B710\u207B\u00B3 m/s"},
        {"-3.1e-2 +- 1e-3", -0.031, 0.001, ""},
        {"10 mm/s", 10, kNoError, "mm/s"},
        {"23\u00B0C", 23, kNoError, "\u00B0C"},
        {"31 %", 31, kNoError, "%"},
        {"10 \u00B1 1 mm/s", 10, 1, "mm/s"},
        {"10 mm/s \u00B1 1 mm/s", 10, 1, "mm/s"},
        {"10 mm/s \u00B1 5 %", 10, 0.5, "mm/s"},
        {"(31 \u00B1 2) %", 31, 2, "%"},
        {"5 \u00D7 10^-3 m/s", 5, kNoError, "\u00D7 10^-3 m/s"}})
    expectCell(expected, '.');
  expectCell({"0,31 \u00B1 0,02", 0.31, 0.02, ""}, ',');
  expectCell({"2,5 bar", 2.5, kNoError, "bar"}, ',');
}

/// The digits in brackets are those of the last place; the examples of JCGM 100:2008, 7.2.2, in
/// newtons.
TEST(TextCell, ReadsConciseErrors) {
  expectCell({"100.02147(35) N", 100.02147, 0.00035, "N"}, '.');
  expectCell({"100.02147(0.00035) N", 100.02147, 0.00035, "N"}, '.');
  expectCell({"(100.02147 \u00B1 0.00035) N", 100.02147, 0.00035, "N"}, '.');
  expectCell({"0,312(12)", 0.312, 0.012, ""}, ',');
  expectCell({"31(2) %", 31, 2, "%"}, '.');
}

TEST(TextCell, ReadsComplexNumbers) {
  struct Complex {
    const char* text;
    double real, imaginary;
    const char* unit;
  };
  for (const auto& [text, real, imaginary, unit] : {Complex{"4.2e+06+2.5e+05i", 4.2e6, 2.5e5, ""},
                                                    {"4.2 + 2.5j", 4.2, 2.5, ""},
                                                    {"-4.2 - 2.5*i", -4.2, -2.5, ""},
                                                    {"4.2 \u2212 i*2.5", 4.2, -2.5, ""},
                                                    {"(4.2+2.5j) MPa", 4.2, 2.5, "MPa"},
                                                    {"4.2+2.5i kPa", 4.2, 2.5, "kPa"},
                                                    {"(4.2, -2.5)", 4.2, -2.5, ""},
                                                    {"(4.2;2.5)", 4.2, 2.5, ""}}) {
    const auto cell = readCell(text, '.');
    ASSERT_TRUE(cell) << text;
    EXPECT_EQ(cell->number, real) << text;
    EXPECT_EQ(cell->rest.imaginary, imaginary) << text;
    EXPECT_EQ(cell->rest.unit, unit) << text;
    EXPECT_TRUE(std::isnan(cell->rest.error)) << text;
  }
  EXPECT_EQ(readCell("(4,2;2,5)", ',')->rest.imaginary, 2.5);
  for (const char* other : {"4.2+2.5", "4.2+2.5k", "4.2i", "4.2,2.5", "(4.2,2.5,1)", "4.2+-2.5i",
                            "4.2+2.5i furlong", "(4.2,)"})
    EXPECT_FALSE(readCell(other, '.')) << other;
  EXPECT_TRUE(std::isnan(readCell("0.31 \u00B1 0.02", '.')->rest.imaginary));
  std::vector<std::string_view> fields;
  const std::string line = "1 4.2 + 2.5j 3 - 4";
  splitFields(line, TextDialect::Separator::Blanks, fields);
  joinCells(fields);
  EXPECT_EQ(fields, (std::vector<std::string_view>{"1", "4.2 + 2.5j", "3", "-", "4"}));
}

TEST(TextCell, IsNothingWhereItIsInDoubt) {
  for (const char* text : {"",
                           "0.31",
                           "mm/s",
                           "A 5 N",
                           "31 \u00B1 2 %",
                           "0.31 \u00B1 0.02 (n=3)",
                           "0.31 (2)",
                           "0.3(5)",
                           "3e-1(2)",
                           "0.31(2",
                           "0.31(-2)",
                           "0.31()",
                           "0.31 \u00B1",
                           "0.31 \u00B1 -0.02",
                           "\u00B1 0.02",
                           "0,31 \u00B1 0,02",
                           "0.31 \u00B1 0,02",
                           "0.31..0.35",
                           "0.31-0.35",
                           "1 000 mm/s",
                           "1 100 mm/s",
                           "10 mm/s \u00B1 1 m/s",
                           "10 mm/s \u00B1 1",
                           "(0.31 \u00B1 0.02) A12",
                           "(10 mm/s) N",
                           "0.31 +0.02 -0.01",
                           "5 furlongs",
                           "0.31 -",
                           "0.31 (1)"})
    EXPECT_FALSE(readCell(text, '.')) << text;
}

TEST(TextCell, JoinsWhatBlanksSeparate) {
  const auto joined = [](const std::string& line) {
    std::vector<std::string_view> fields;
    splitFields(line, TextDialect::Separator::Blanks, fields);
    joinCells(fields);
    return std::vector<std::string>(fields.begin(), fields.end());
  };
  using Fields = std::vector<std::string>;
  EXPECT_EQ(joined("10 mm/s 0.31 \u00B1 0.02 A"), (Fields{"10 mm/s", "0.31 \u00B1 0.02", "A"}));
  EXPECT_EQ(joined("0.31 C 5 N mm/s"), (Fields{"0.31", "C", "5", "N", "mm/s"}));
  EXPECT_EQ(joined("\u00B1 0.02"), (Fields{"\u00B1", "0.02"}));
  EXPECT_EQ(joined("0.31 \u00B1"), (Fields{"0.31", "\u00B1"}));
  EXPECT_TRUE(joined("").empty());
}

TextBlock blockOf(const std::string& text) {
  TextTableOptions options;
  options.keepsTexts = options.readsCells = true;
  return readTextTable(text, "mine.csv", options).largest();
}

/// Without the option, such cells are texts as before.
TEST(TextCell, AreTextsWithoutTheOption) {
  TextTableOptions options;
  options.keepsTexts = true;
  const TextTable table = readTextTable("a;b\n1;2 N\n2;3 N\n", "mine.csv", options);
  EXPECT_TRUE(table.largest().columns[1].isText);
  EXPECT_EQ(table.largest().texts[1][1], "3 N");
}

TEST(TextCell, AreReadInRowsWithoutPlainNumbers) {
  const TextBlock block = blockOf("v;F\n10 mm/s;3,5 N\n20 mm/s;4,5 N\n");
  ASSERT_EQ(block.rows, 2U);
  EXPECT_EQ(block.at(1, 1), 4.5);
  EXPECT_EQ(block.cells[1][1].unit, "N");
  EXPECT_EQ(blockOf("name;v;F\nA;10 mm/s;3.5 N\nB;20 mm/s;4.5 N\n").texts[0][1], "B");
  const TextBlock blanks = blockOf("v F\n10 mm/s 3.5 kN\n20 mm/s 4.5 kN\n");
  ASSERT_EQ(blanks.rows, 2U);
  EXPECT_EQ(blanks.cells[1][0].unit, "kN");
  // Other separators separate.
  EXPECT_EQ(blockOf("v;F;note\n1;2;mm\n3;4;mm\n").texts[2][1], "mm");
  EXPECT_EQ(blockOf("v;a;b;F\n1;0.3;\u00B1;2\n3;0.4;\u00B1;4\n").columns.size(), 4U);
  // A line of values that is no row of a table belongs to the header.
  const TextBlock below = blockOf("Mischung;A12\n20 \u00B0C;30 N\nv;F\n1;2\n3;4\n");
  EXPECT_EQ(below.header.size(), 3U);
  EXPECT_EQ(below.rows, 2U);
}

/// The marks in such cells tell decimals from thousands, as those of plain numbers do.
TEST(TextCell, ShowsTheDecimalMark) {
  TextTableOptions options;
  options.keepsTexts = options.readsCells = true;
  const auto dialect = [&](const std::string& text) {
    return readTextTable(text, "mine.csv", options).dialect;
  };
  EXPECT_EQ(dialect("v;F\n1;3,5 N\n2;4,5 N\n").decimal, ',');
  EXPECT_TRUE(dialect("v;F\n1;3.500 N\n2;4.500 N\n3;5.500 N\n").isUnclear);
  EXPECT_FALSE(dialect("v;F\n1;3.500 N\n2;4.50 N\n3;5.500 N\n").isUnclear);
}

TEST(TextCell, AColumnHasOneUnitAfterwards) {
  TextBlock block = blockOf("v;F\n10 mm/s;3 N\n1 m/s;4 N\n");
  unifyUnits(block, "mine.csv");
  EXPECT_EQ(block.columns[0].unit, "m/s");
  EXPECT_DOUBLE_EQ(block.at(0, 0), 0.01);
  EXPECT_DOUBLE_EQ(block.at(1, 0), 1);
  EXPECT_EQ(block.columns[1].unit, "N");
  EXPECT_EQ(block.at(1, 1), 4);
  for (const char* text : {"v;F\n10 mm/s;3 N\n1;4 N\n", "v;F\n10 mm/s;3 N\n1 mm;4 N\n",
                           "v (m/s);F\n1 m/s;3 N\n1 mm/s;4 N\n"}) {
    TextBlock mixed = blockOf(text);
    EXPECT_NE(errorFrom([&] { unifyUnits(mixed, "mine.csv"); }), "no error") << text;
  }
  // A column without a name is told by its number.
  TextBlock mixed = blockOf("v;F\n10 mm/s;3 N\n1 mm;4 N\n");
  mixed.columns[0].name.clear();
  EXPECT_EQ(errorFrom([&] { unifyUnits(mixed, "mine.csv"); }),
            "mine.csv: row 3: column 1 has the unit mm here, and mm/s elsewhere");
  // A missing value needs no unit.
  TextBlock missing = blockOf("v;F\n10 mm/s;3 N\n;4 N\n1 m/s;5 N\n");
  unifyUnits(missing, "mine.csv");
  EXPECT_TRUE(std::isnan(missing.at(1, 0)));
  EXPECT_DOUBLE_EQ(missing.at(2, 0), 1);
}

/// A text after cells with units makes all of them texts.
TEST(TextCell, ATextMakesAColumnOfTexts) {
  const TextBlock block = blockOf("v;note\n1;5 mm\n2;\n3;smooth\n");
  EXPECT_TRUE(block.columns[1].isText);
  EXPECT_EQ(block.texts[1], (std::vector<std::string>{"5 mm", "", "smooth"}));
}

}  // namespace
}  // namespace asperity
