// Tables of numbers in text files. The writer below makes the same table in every dialect; the
// reader must give the same values, names and units back.
#include "core/base/text_table.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <vector>

#include "core/base/input_error.h"
#include "core/base/text_header.h"
#include "core/base/text_number.h"
#include "tests/core/error_from.h"

namespace asperity {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

TextTable read(const std::string& text, const TextTableOptions& options = {}) {
  return readTextTable(text, "table.txt", options);
}

std::vector<double> firstColumn(const std::string& text) {
  return read(text).largest().column(0);
}

std::string errorOf(const std::string& text, const TextTableOptions& options = {}) {
  return errorFrom([&] { read(text, options); });
}

// ---- One table in many dialects ----------------------------------------------------------------

constexpr double kPosition[] = {0, 0.25, 0.5, 0.75, 1, 1.25, 1.5};
constexpr double kHeight[] = {-1.5, 0.05, 12.75, -0.5, 1e-6, 0, 300.125};

std::string number(double value, char decimal, bool exponent) {
  std::string text = exponent ? fmt::format("{:.6E}", value) : fmt::format("{:.9f}", value);
  std::ranges::replace(text, '.', decimal);
  return text;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
  return text;
}

std::string table(const std::string& separator, char decimal, bool exponent,
                  const std::string& header) {
  std::string text = header;
  for (int i = 0; i < 7; ++i)
    text += number(kPosition[i], decimal, exponent) + separator +
            number(kHeight[i], decimal, exponent) + "\n";
  return text;
}

void expectTable(const std::string& text) {
  const TextTable made = read(text);
  const TextBlock& block = made.largest();
  ASSERT_EQ(block.columns.size(), 2u) << text;
  ASSERT_EQ(block.rows, 7u) << text;
  for (int i = 0; i < 7; ++i) {
    EXPECT_NEAR(block.at(i, 0), kPosition[i], 1e-9) << text;
    EXPECT_NEAR(block.at(i, 1), kHeight[i], 1e-9) << text;
  }
}

TEST(TextTable, ReadsEverySeparatorAndDecimalMark) {
  for (const bool exponent : {false, true})
    for (const std::string header : {"", "x;z\n", "# x z\n", "x\tz\n", "x,z\n", "A profile\n\n"}) {
      for (const std::string separator :
           {" ", "   ", "\t", ";", " ; ", ",", ", ", "|", " , ", ";\t"})
        expectTable(table(separator, '.', exponent, header));
      for (const std::string separator : {" ", "   ", "\t", ";", " ; ", ", ", "|", ";\t"})
        expectTable(table(separator, ',', exponent, header));
    }
}

TEST(TextTable, ReadsEveryLineEndAndEncoding) {
  const std::string header = "L\u00E4nge (\u00B5m);H\u00F6he (\u00B5m)\n";
  const std::string text = table(";", ',', false, header);
  std::string little = "\xFF\xFE", big = "\xFE\xFF", latin;
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned code = static_cast<unsigned char>(text[i]);
    if (code >= 0x80) code = (code & 0x1F) << 6 | (static_cast<unsigned char>(text[++i]) & 0x3F);
    const char low = static_cast<char>(code);
    little += low;
    little += '\0';
    big += '\0';
    big += low;
    latin += low;
  }
  for (const std::string& encoded :
       {text, "\xEF\xBB\xBF" + text, little, big, latin, little.substr(2), big.substr(2),
        replaced(text, "\n", "\r\n"), replaced(text, "\n", "\r"), text + std::string("\x1A"),
        text.substr(0, text.size() - 1), replaced(latin, "\n", "\r")}) {
    expectTable(encoded);
    const TextTable made = read(encoded);
    EXPECT_EQ(made.largest().columns[0].name, "L\u00E4nge");
    EXPECT_EQ(made.largest().columns[1].name, "H\u00F6he");
    EXPECT_EQ(made.largest().columns[1].unit, "\u00B5m");
  }
  EXPECT_EQ(read(latin).encoding, "Latin-1");
  EXPECT_EQ(read(little).encoding, "UTF-16");
  EXPECT_EQ(read(text).encoding, "UTF-8");
}

// ---- Decimal commas that could be separators ---------------------------------------------------

TEST(TextTable, TellsDecimalCommasFromSeparators) {
  EXPECT_THAT(firstColumn("1,5, 2,5\n1,6, 2,7\n1,7, 2,9\n"), ElementsAre(1.5, 1.6, 1.7));
  EXPECT_THAT(firstColumn("0, 2,5\n0,5, 2,7\n1, 2\n"), ElementsAre(0, 0.5, 1));
  EXPECT_THAT(firstColumn("1, 5\n2, 6\n3, -7\n"), ElementsAre(1, 2, 3));
  EXPECT_THAT(firstColumn("1,-5\n2, 6\n3, 7\n"), ElementsAre(1, 2, 3));
  EXPECT_EQ(read("1, 5\n2, 6\n3, -7\n").largest().columns.size(), 2u);
  EXPECT_THAT(firstColumn("0,05\n0,10\n-0,15\n"), ElementsAre(0.05, 0.1, -0.15));
  EXPECT_THAT(firstColumn("12,345\n12,350\n12,361\n"), ElementsAre(12.345, 12.35, 12.361));
  EXPECT_THAT(firstColumn("1,5\n-0,7\n2,3\n"), ElementsAre(1.5, -0.7, 2.3));
  EXPECT_THAT(firstColumn("z (mm)\n1,5\n2,7\n3,9\n"), ElementsAre(1.5, 2.7, 3.9));
  EXPECT_THAT(firstColumn("x,z\n1,5\n2,7\n3,9\n"), ElementsAre(1, 2, 3));
  EXPECT_THAT(firstColumn("0,5\n1,7\n2,9\n"), ElementsAre(0, 1, 2));
  EXPECT_THAT(firstColumn("x,z\n1,5,2,5\n1,6,2,6\n1,7,2,1\n"), ElementsAre(1.5, 1.6, 1.7));
  EXPECT_THAT(firstColumn("0,05,0,07\n0,06,0,08\n0,07,0,01\n"), ElementsAre(0.05, 0.06, 0.07));
  EXPECT_THAT(firstColumn("\"1,5\",\"2,5\"\n\"1,6\",\"2,6\"\n"), ElementsAre(1.5, 1.6));
  EXPECT_THAT(firstColumn("1,5E-3\n1,6E-3\n2,7E-4\n"), ElementsAre(1.5e-3, 1.6e-3, 2.7e-4));
}

// ---- Numbers and missing values ----------------------------------------------------------------

TEST(TextTable, ReadsNumbersAsInstrumentsWriteThem) {
  EXPECT_THAT(firstColumn("1.5D-3 1\n+1.5e-06 2\n\u22121.5 3\n.5 4\n5. 5\n-.25 6\n1E+02 7\n"),
              ElementsAre(1.5e-3, 1.5e-6, -1.5, 0.5, 5, -0.25, 100));
  EXPECT_THAT(firstColumn("1.5e\u22123;1\n2;2\n3;3\n"), ElementsAre(1.5e-3, 2, 3));
  EXPECT_THAT(firstColumn("1e-400 1\n1 2\n"), ElementsAre(0, 1));
  double value = 0;
  for (const std::string wrong :
       {"1.2.3", "1-2", "--1", "+-1", "1e", "e5", "0x10", "1,234.5", "1e999", "1 2", "inf", "nan",
        "1e5.5", "", ".", "-", "1'000", "12mm"})
    EXPECT_FALSE(readTextNumber(wrong, '.', value)) << wrong;
  EXPECT_FALSE(readTextNumber("1.5", ',', value));
}

TEST(TextTable, TakesWordsForMissingValues) {
  for (const std::string missing :
       {"",       "NaN", "nan",   "-nan",     "BAD",          "-",       "--",
        "***",    "inf", "-INF",  "n/a",      "#N/A",         "1.#QNAN", "null",
        "\u221E", "?",   "+OVER", "overload", "Out of range", "OVFL"}) {
    const TextTable made = read("x;z\n1;2\n2;" + missing + "\n3;4\n");
    ASSERT_EQ(made.largest().rows, 3u) << missing;
    EXPECT_TRUE(std::isnan(made.largest().at(1, 1))) << missing;
    EXPECT_EQ(made.largest().at(1, 0), 2) << missing;
    EXPECT_EQ(made.largest().at(2, 1), 4) << missing;
  }
  // A row of gaps amid the rows; separators at the end of a file are no row.
  const TextTable gaps = read("1,2\n,\n3,4\n,\n,\n");
  EXPECT_EQ(gaps.largest().rows, 3u);
  EXPECT_TRUE(std::isnan(gaps.largest().at(1, 0)));
  // The first row may begin with a gap; columns of validity are numbers.
  const TextTable flags = read("z;valid\nBAD;FALSE\n2;TRUE\n3;OK\n");
  EXPECT_TRUE(std::isnan(flags.largest().at(0, 0)) || flags.largest().rows == 2u);
  EXPECT_THAT(read("z;valid\n1;FALSE\n2;TRUE\n3;OK\n").largest().column(1), ElementsAre(0, 1, 1));
}

// ---- Names, units, header ----------------------------------------------------------------------

TEST(TextTable, FindsNamesAndUnitsAboveTheNumbers) {
  for (const std::string header :
       {"x (mm);z (um)\n", "x;z\nmm;um\n", "x;z\n(mm);(um)\n", "# x [mm]   z [um]\n",
        "x [mm] z [um]\n", "Title of it\n\nx/mm;z/um\n", "\"x (mm)\";\"z (um)\"\n",
        "x\tz\nmm\tum\n", "mm;um\nx;z\n", "x;z\n[mm];[um]\nSample A;Sample A\n",
        "key: value\nx, mm; z, um\n", "x / mm   z / um\n", "% x_mm z_um\n"}) {
    const TextTable made = read(header + "0.5;1.5\n1.0;2.5\n1.5;3.5\n");
    const TextBlock& block = made.largest();
    ASSERT_EQ(block.rows, 3u) << header;
    EXPECT_EQ(block.columns[0].name, "x") << header;
    EXPECT_EQ(block.columns[1].name, "z") << header;
    EXPECT_EQ(block.columns[0].unit, "mm") << header;
    EXPECT_EQ(block.columns[1].unit, "um") << header;
    EXPECT_EQ(block.lines[0], static_cast<unsigned>(std::ranges::count(header, '\n') + 1))
        << header;
  }
}

/// Columns that count or say what is valid have no unit.
TEST(TextTable, ARowOfUnitsMayLeaveColumnsWithoutOne) {
  for (const std::string units :
       {",mm,um,", "-,mm,um,", ",mm,um,-", ",mm,um,bool", ",[mm],[um],"}) {
    const TextTable made =
        read("No,X,Z,valid\n" + units + "\n0,0.5,1.5,1\n1,1.0,2.5,1\n2,1.5,3.5,0\n");
    const TextBlock& block = made.largest();
    ASSERT_EQ(block.columns.size(), 4u) << units;
    EXPECT_EQ(block.columns[1].name, "X") << units;
    EXPECT_EQ(block.columns[1].unit, "mm") << units;
    EXPECT_EQ(block.columns[2].unit, "um") << units;
    EXPECT_EQ(block.columns[3].name, "valid") << units;
    EXPECT_EQ(block.columns[3].unit == "bool", false) << units;
  }
}

/// As rheometers export intervals: row names in front of the names, a tab in front of all the rest.
TEST(TextTable, ATabInFrontIsAColumnWithoutAName) {
  const TextTable table = read(
      "Result:\tFS -40 \u00B0C\nInterval data:\tPoint No.\tStorage Modulus\tLoss Modulus\n"
      "\t\t[MPa]\t[kPa]\n\t1\t29.4\t1.3\n\t2\t29.7\t1.2\n");
  const TextBlock& block = table.largest();
  ASSERT_EQ(block.columns.size(), 4u);
  EXPECT_EQ(block.columns[2].name, "Storage Modulus");
  EXPECT_EQ(block.columns[2].unit, "MPa");
  EXPECT_EQ(block.columns[3].unit, "kPa");
  EXPECT_EQ(block.at(1, 2), 29.7);
}

TEST(TextTable, FindsKeysAndValues) {
  const TextTable made = read(
      "# Channel: Raw\n# Width: 10 \u00B5m\nDate = 2020-01-01\nPoints;512;\nLong remark without a "
      "key\n"
      "Spacing X\t0,5 mm\n1,0;2,0\n1,5;2,5\n");
  const TextBlock& block = made.largest();
  ASSERT_EQ(block.header.size(), 6u);
  EXPECT_EQ(made.entry("width", block), "10 \u00B5m");
  EXPECT_EQ(made.entry("Channel", block), "Raw");
  EXPECT_EQ(made.entry("Date", block), "2020-01-01");
  EXPECT_EQ(made.entry("points", block), "512");
  EXPECT_EQ(made.entry("Spacing X", block), "0,5 mm");
  EXPECT_EQ(block.header[4].key, "");
  EXPECT_EQ(block.header[4].line, 5u);
  EXPECT_EQ(parseQuantity(made.entry("spacing x", block))->number, 0.5);
  EXPECT_EQ(parseQuantity(made.entry("spacing x", block))->unit, "mm");
  EXPECT_EQ(parseQuantity("10 \u00B5m")->unit, "\u00B5m");
  EXPECT_EQ(parseQuantity("1.5e-3m")->number, 1.5e-3);
  EXPECT_FALSE(parseQuantity("mm").has_value());
  for (const char* text :
       {"-5 C", "- 5 C", "\u20135 C", "\u2212 5 C", "minus 5 C", "Minus 5,0 C"}) {
    ASSERT_TRUE(parseQuantity(text).has_value()) << text;
    EXPECT_EQ(parseQuantity(text)->number, -5) << text;
    EXPECT_EQ(parseQuantity(text)->unit, "C") << text;
  }
  for (const char* text : {"- -5", "minus", "\u2013"})
    EXPECT_FALSE(parseQuantity(text).has_value()) << text;
  const TextTable grid = read("ncols 4\nnrows 2\ncellsize 0.5\n1 2 3 4\n5 6 7 8\n");
  EXPECT_EQ(grid.entry("ncols", grid.largest()), "4");
  EXPECT_EQ(grid.largest().rows, 2u);
  const TextTable commas = read("ncols 4\ncellsize 2,5\n1,5 2 3 4\n5,5 6 7 8\n");
  EXPECT_EQ(commas.entry("cellsize", commas.largest()), "2,5");
}

TEST(TextTable, ACommaBetweenQuotesEndsNoKey) {
  const TextTable made = read("\"Ra,Rq\"\n1\n2\n3\n");
  ASSERT_EQ(made.largest().header.size() + made.largest().columns.size(), 2u);
  EXPECT_EQ(made.largest().rows, 3u);
}

/// "Load 30 N" is a statement, not the key of what stands after it, and not the name of a column.
TEST(TextTable, AStatementIsNoKey) {
  for (const char* line : {"Load 30 N, T 23 C", "Load 30 N; T 23 C", "# Load 30 N, T 23 C"}) {
    const TextTable made = read(std::string(line) + "\nv m/s,mu\n1,0.5\n2,0.6\n");
    const TextBlock& block = made.largest();
    ASSERT_EQ(block.columns.size(), 2u) << line;
    EXPECT_EQ(block.columns[1].name, "mu") << line;
    ASSERT_GE(block.header.size(), 1u) << line;
    EXPECT_EQ(block.header[0].key, "") << line;
  }
}

// ---- Several blocks ----------------------------------------------------------------------------

TEST(TextTable, SeparatesBlocksWithTheirHeaders) {
  const TextTable made = read(
      "Operator: A\n\nTemperature: 20 C\nf;E\nHz;MPa\n1;2\n2;3\n\nTemperature: 30 C\nf;E\nHz;MPa\n"
      "1;1.5\n2;2.5\n3;3.5\nend of data\n");
  ASSERT_EQ(made.blocks.size(), 2u);
  EXPECT_EQ(made.blocks[0].rows, 2u);
  EXPECT_EQ(made.blocks[1].rows, 3u);
  EXPECT_EQ(made.entry("temperature", made.blocks[0]), "20 C");
  EXPECT_EQ(made.entry("temperature", made.blocks[1]), "30 C");
  EXPECT_EQ(made.entry("operator", made.blocks[1]), "A");
  EXPECT_EQ(made.blocks[1].columns[1].unit, "MPa");
  ASSERT_EQ(made.trailer.size(), 1u);
  EXPECT_EQ(made.trailer[0].value, "end of data");
}

TEST(TextTable, KeepsRowsTogetherAcrossBlankLinesAndComments) {
  const TextTable made = read("1 2\n\n3 4\n# a comment\n5 6\n\n\n7 8\n");
  ASSERT_EQ(made.blocks.size(), 1u);
  EXPECT_THAT(made.blocks[0].column(1), ElementsAre(2, 4, 6, 8));
  EXPECT_THAT(made.blocks[0].lines, ElementsAre(1u, 3u, 5u, 8u));
  // Where they stand a caller can find, as between several tables.
  EXPECT_THAT(read("1 2\n\n3 4\n# a comment\n5 6\n\n\n7 8\n\n# next\n9 9\n").blocks[0].blanks,
              ElementsAre(Pair(1u, 1u), Pair(3u, 2u), Pair(4u, 0u)));
}

/// Such a comment cut the table, and the rows after it lost their names.
TEST(TextTable, KeepsRowsTogetherAcrossAnyMarkOfComments) {
  for (const std::string mark : {"; ", ";", "-- ", "REM ", "rem ", "' "}) {
    SCOPED_TRACE(mark);
    const TextTable made = read(mark + "Operator: A\n" + mark + "x (um)  z (nm)\n1 2\n3 4\n" +
                                mark + "pause\n" + mark + "of 5 s\n5 6\n7 8\n" + mark + "end\n");
    ASSERT_EQ(made.blocks.size(), 1u);
    EXPECT_THAT(made.blocks[0].column(1), ElementsAre(2, 4, 6, 8));
    EXPECT_EQ(made.blocks[0].columns[0].name, "x");
    EXPECT_EQ(made.blocks[0].columns[1].unit, "nm");
    EXPECT_EQ(made.entry("operator", made.blocks[0]), "A");
    ASSERT_EQ(made.trailer.size(), 1u);
    EXPECT_EQ(made.trailer[0].value, "end");
  }
  const TextTable fields = read("x;z\n1;2\n3;4\n; pause; 5 s; A\n5;6\n");
  EXPECT_THAT(fields.largest().column(1), ElementsAre(2, 4, 6));
  // Names and units are no comments.
  EXPECT_EQ(read("x;z\n1;2\n3;4\n;z2\n5;6\n").blocks.size(), 2u);
  EXPECT_EQ(read("'x' 'z'\n1 2\n3 4\n'x' 'z'\n5 6\n").blocks.size(), 2u);
  EXPECT_EQ(read("n  x  z\n-- um nm\n1 2 3\n3 4 5\n").largest().columns[1].unit, "um");
}

TEST(TextTable, TakesAnotherWidthForAnotherBlock) {
  const TextTable made = read("4 3\n1 2 3\n4 5 6\n7 8 9\nMean 5\n");
  ASSERT_EQ(made.blocks.size(), 2u);
  EXPECT_EQ(made.largest().rows, 3u);
  EXPECT_EQ(made.largest().columns.size(), 3u);
}

TEST(TextTable, NamesTheLineOfWhatIsWrong) {
  EXPECT_THAT(errorOf("x;z\n1;2\n2;abc\n3;4\n"),
              "table.txt: line 3: 'abc' in column 2 is not a number");
  EXPECT_THAT(errorOf("1 2\n2 3\n3\n4 5\n"),
              "table.txt: line 3: has one field where the lines before have 2");
  EXPECT_THAT(errorOf("1;2\n2;3\n3;1.2.3\n4;5\n"), HasSubstr("line 3: '1.2.3' in column 2"));
  EXPECT_THAT(errorOf("only\nwords\n"), "table.txt: has no rows of numbers");
  EXPECT_THAT(
      errorOf("x (mm);0;1;2\nz (um);3;4;5\n"),
      "table.txt: has no rows of numbers; line 1 has 'x (mm)' in front of its numbers: write "
      "each quantity in a column, with its name above it");
  EXPECT_THAT(errorOf(""), "table.txt: is empty");
  EXPECT_THAT(errorOf(std::string("\x89PNG\r\n", 6)), HasSubstr("is a PNG picture"));
  EXPECT_THAT(errorOf(std::string("\x00\x01\x02\x03\x05\x07", 6)), HasSubstr("binary file"));
}

/// Damaged rows in a row, to the end of the file or before good ones, are no second table.
TEST(TextTable, RefusesSeveralDamagedRowsInARow) {
  std::string good;
  for (int i = 0; i < 12; ++i) good += fmt::format("{};{}.5\n", i, i);
  EXPECT_THAT(errorOf(good + "12;lost\n13;lost\n14;lost\n"),
              "table.txt: line 13: 'lost' in column 2 is not a number");
  EXPECT_THAT(errorOf(good + "12;a.b.c\n13;a.b.c\n" + good),
              HasSubstr("line 13: 'a.b.c' in column 2"));
  EXPECT_THAT(errorOf(good + "12;1;5\n13;1;5\n14;1;5\n"),
              "table.txt: line 13: has 3 fields where the lines before have 2");
  EXPECT_THAT(errorOf(good + "0.1.2;3\n0.1.2;3\n"), HasSubstr("in column 1 is not"));
  EXPECT_THAT(errorOf("1.5\n2.5\n1.2.3\n1.2.3\n"), HasSubstr("in column 1 is not"));
  EXPECT_THAT(errorOf("1.5\n2.5\n1.2.3\n3.5\n"), HasSubstr("in column 1 is not"));
  // Results below the rows, a table below a blank line, and a header of counts are none.
  EXPECT_EQ(read(good + "Ra;0.5\nRq;0.7\n").largest().rows, 12u);
  EXPECT_EQ(read(good + "1. Ra;0.5\n2. Rq;0.7\n").largest().rows, 12u);
  EXPECT_EQ(read(good + "\n1;2;3\n4;5;6\n").blocks.size(), 2u);
  EXPECT_EQ(read("4 3\n0 1\n1 2 3\n4 5 6\n").largest().rows, 2u);
}

TEST(TextTable, ReadsSeparatedThousands) {
  const auto values = [](const std::string& text) { return read(text).largest().values; };
  EXPECT_THAT(values("999,5;0,25\n1.000,0;0,5\n12.345.678,25;-1.234\n"),
              ElementsAre(999.5, 0.25, 1000, 0.5, 12345678.25, -1234));
  EXPECT_THAT(values("\"999.5\",0.25\n\"1,000.0\",0.5\n"), ElementsAre(999.5, 0.25, 1000, 0.5));
  for (const char* mark : {"'", " ", "\u00A0", "\u202F", "\u2019"})
    EXPECT_THAT(values(fmt::format("999.5\t0.25\n1{}000.0\t0.5\n-1{}000.5\t1\n", mark, mark)),
                ElementsAre(999.5, 0.25, 1000, 0.5, -1000.5, 1))
        << mark;
  // From the first row on, too.
  EXPECT_THAT(values("1.000,5;2.000,5\n1.001,5;2.000,5\n1.002,5;2.001,5\n"),
              ElementsAre(1000.5, 2000.5, 1001.5, 2000.5, 1002.5, 2001.5));
  // Where a comma can be a decimal mark throughout, it is one.
  EXPECT_THAT(values("1,234\t5,678\n2,345\t6,789\n"), ElementsAre(1.234, 5.678, 2.345, 6.789));
  EXPECT_THAT(values("1.234;5.678\n2.345;6.789\n"), ElementsAre(1.234, 5.678, 2.345, 6.789));
  // Groups of another size, or after a 0, are none.
  EXPECT_THAT(errorOf("1.5;2.5\n2.5;1,23\n3.5;2.5\n"), HasSubstr("line 2: '1,23' in column 2"));
  EXPECT_THAT(errorOf("1.5;2.5\n2.5;0,234\n3.5;2.5\n"), HasSubstr("line 2: '0,234' in column 2"));
}

/// "invalid" among heights is a gap; a column of such words alone says what is valid.
TEST(TextTable, TakesFlagsAmongNumbersForGaps) {
  const TextTable made = read("x;z;valid\n1;0.5;true\n2;invalid;false\n3;ok;true\n4;0.25;true\n");
  const TextBlock& block = made.largest();
  EXPECT_TRUE(std::isnan(block.at(1, 1)));
  EXPECT_TRUE(std::isnan(block.at(2, 1)));
  EXPECT_EQ(block.at(3, 1), 0.25);
  EXPECT_THAT(block.column(2), ElementsAre(1, 0, 1, 1));
  const TextTable words = read("1;0.5\n2;No Data\n3;fehlt\n4;1\n");
  EXPECT_TRUE(std::isnan(words.largest().at(1, 1)));
  EXPECT_TRUE(std::isnan(words.largest().at(2, 1)));
}

TEST(TextTable, ErrorsOfSpreadsheetsAreGapsAndNoComments) {
  const TextTable made = read("0;1.5\n#N/A;2.5\n2;#WERT!\n3;#NV\n4;5.5\n");
  ASSERT_EQ(made.blocks.size(), 1u);
  EXPECT_EQ(made.largest().rows, 5u);
  EXPECT_TRUE(std::isnan(made.largest().at(1, 0)));
  EXPECT_TRUE(std::isnan(made.largest().at(2, 1)));
}

TEST(TextTable, ReadsRowsWithACommentAtTheEnd) {
  EXPECT_THAT(read("x,z\n0.5,1.5 # first\n1.5,2.5\t// second\n").largest().values,
              ElementsAre(0.5, 1.5, 1.5, 2.5));
}

/// Names keep their columns: separators at the ends of lines, quotation marks within names, and a
/// first column without a name, which is one of row numbers or none.
TEST(TextTable, KeepsNamesAtTheirColumns) {
  const TextTable ends = read("x (mm),z (um),\n0.0,0.5,\n0.1,0.7,\n");
  ASSERT_GE(ends.largest().columns.size(), 2u);
  EXPECT_EQ(ends.largest().columns[0].unit, "mm");
  EXPECT_EQ(ends.largest().columns[1].unit, "um");
  const TextTable primes =
      read("T/\u00B0C;f/Hz;E'/MPa;E\"/MPa;tan d\n20;1;5;1;0.2\n20;2;6;1;0.3\n");
  ASSERT_EQ(primes.largest().columns.size(), 5u);
  EXPECT_EQ(primes.largest().columns[0].name, "T");
  EXPECT_EQ(primes.largest().columns[3].name, "E\"");
  EXPECT_EQ(primes.largest().columns[3].unit, "MPa");
  const TextTable numbered = read("a;b\n1;5;6\n2;7;8\n3;9;9\n");
  EXPECT_EQ(numbered.largest().columns[1].name, "a");
  const TextTable other = read("a;b\n20;5;6\n20;7;8\n21;9;9\n");
  EXPECT_EQ(other.largest().columns[1].name, "");
}

/// Words with a number above a table, such as "Step 1", do not decide how its rows are separated.
TEST(TextTable, LooksAtRowsForTheSeparator) {
  const TextTable made =
      read("Step 1\nFrequency - 1\nRun 5\nx axis\theight of z\n1.5\t2.5\n2.5\t3.5\n");
  EXPECT_EQ(made.dialect.separator, TextDialect::Separator::Tab);
  EXPECT_EQ(made.largest().columns[1].name, "height of z");
}

TEST(TextTable, NamesTheFieldThatIsNoNumberWhereThereAreNoRows) {
  EXPECT_THAT(errorOf("x;z\n1.2.3;5\n1.2.4;6\n1.2.5;x7\n"),
              HasSubstr("has no rows of numbers; line"));
}

/// "#" after a space begins a comment only after a row of numbers alone.
TEST(TextTable, TellsCommentsFromLabelsAndErrors) {
  const TextTable excel = read("1.5\t2.5\t3\n2.5\t#NV\t4\n3.5\t####\t5\n");
  ASSERT_EQ(excel.largest().rows, 3u);
  EXPECT_EQ(excel.largest().at(1, 2), 4);
  TextTableOptions options;
  options.keepsTexts = true;
  const TextTable labels = read("label,v,mu\nTread #1,0.1,0.5\nTread #2,1,0.6\n", options);
  EXPECT_THAT(labels.largest().texts[0], ElementsAre("Tread #1", "Tread #2"));
  EXPECT_THAT(labels.largest().column(2), ElementsAre(0.5, 0.6));
}

/// A column of remarks may begin empty; rows with a remark are rows.
TEST(TextTable, KeepsRowsWithRemarks) {
  const std::string text = "v;mu;remark\n0.1;0.5;\n1;0.6;\n10;0.7;stick-slip\n100;0.8;\n";
  for (const bool keepsTexts : {false, true}) {
    TextTableOptions options;
    options.keepsTexts = keepsTexts;
    const TextTable made = read(text, options);
    ASSERT_EQ(made.blocks.size(), 1u);
    EXPECT_THAT(made.largest().column(1), ElementsAre(0.5, 0.6, 0.7, 0.8));
    EXPECT_EQ(made.largest().columns[2].isText, keepsTexts);
    if (keepsTexts) {
      EXPECT_THAT(made.largest().texts[2], ElementsAre("", "", "stick-slip", ""));
    }
  }
}

/// Spreadsheets write an empty row as separators.
TEST(TextTable, PassesOverRowsOfSeparatorsAboveTheNumbers) {
  for (const char* text :
       {"a;b;c\n;;\n[s];[Pa];[1]\n1;2;3\n4;5;6\n", "a;b;c\n[s];[Pa];[1]\n;;\n1;2;3\n4;5;6\n",
        "a,b,c\n,,\n[s],[Pa],[1]\n,,\n1,2,3\n4,5,6\n"}) {
    const TextTable made = read(text);
    ASSERT_EQ(made.largest().columns.size(), 3u) << text;
    EXPECT_EQ(made.largest().columns[1].name, "b") << text;
    EXPECT_EQ(made.largest().columns[1].unit, "Pa") << text;
  }
}

/// A line that is drawn below names leaves them their columns, whatever it is drawn with.
TEST(TextTable, PassesOverDrawnLinesAboveTheNumbers) {
  for (const char* line : {"-----", "=====", "*****", "*** *** ***", "+---+---+"}) {
    const TextTable made = read(std::string("a;b;c\n") + line + "\n1;2;3\n4;5;6\n");
    EXPECT_EQ(made.largest().columns[1].name, "b") << line;
  }
}

TEST(TextTable, ReadsARowOfUnitsWithIn) {
  const TextTable made = read("Weg;H\u00F6he\nin mm;in um\n0;1.5\n1;2.5\n");
  EXPECT_EQ(made.largest().columns[0].name, "Weg");
  EXPECT_EQ(made.largest().columns[0].unit, "mm");
  EXPECT_EQ(made.largest().columns[1].unit, "um");
}

/// The unit of a pure number is 1 (ISO 80000).
TEST(TextTable, ReadsARowOfUnitsWithAOne) {
  for (const bool keepsTexts : {false, true}) {
    TextTableOptions options;
    options.keepsTexts = options.readsCells = keepsTexts;
    const TextTable made = read("v;mu\nmm/s;1\n1;0.5\n10;0.6\n", options);
    ASSERT_EQ(made.blocks.size(), 1u);
    EXPECT_THAT(made.largest().column(0), ElementsAre(1, 10));
    EXPECT_EQ(made.largest().columns[0].name, "v");
    EXPECT_EQ(made.largest().columns[0].unit, "mm/s");
    EXPECT_EQ(made.largest().columns[1].unit, "1");
  }
  TextTableOptions options;
  options.keepsTexts = true;
  EXPECT_EQ(read("sample;mu\nA;1\nB;0.6\n", options).largest().rows, 2u);
}

// ---- Texts and further columns -----------------------------------------------------------------

TEST(TextTable, KeepsLabelsWhereACallerWantsThem) {
  TextTableOptions options;
  options.keepsTexts = true;
  options.textColumns = {"label"};
  const TextTable made = read(
      "date: today\nvelocity (mm/s),mu,label\n0.1,0.5,dry\n1,0.6,\"wet, cold\"\n10,0.7\n", options);
  const TextBlock& block = made.largest();
  ASSERT_EQ(block.rows, 3u);
  EXPECT_TRUE(block.columns[2].isText);
  EXPECT_THAT(block.texts[2], ElementsAre("dry", "wet, cold", ""));
  EXPECT_THAT(block.column(0), ElementsAre(0.1, 1, 10));
  EXPECT_TRUE(read("v,label\n1,1\n2,2\n", options).largest().columns[1].isText);
  EXPECT_FALSE(read("v,mu\n1,1\n2,2\n", options).largest().columns[1].isText);
}

/// Programs list the columns one below the other, as Universal Analysis of TA Instruments does.
TEST(TextTable, ReadsAListOfTheColumns) {
  for (const char* list :
       {"Nsig\t2\nSig1\tx (mm)\nSig2\tz (\u00B5m)\nOrgFile\ta.001\nStartOfData\n",
        "# Column 1: x [mm]\n# Column 2: z [\u00B5m]\n",
        "# col 0 = x (mm)\n# col 1 = z (\u00B5m)\n\n",
        "Channel 1\tSpeed (m/s)\nChannel 1\tx (mm)\nChannel 2\tz (\u00B5m)\n"}) {
    const TextTable table = read(std::string(list) + "1\t2.5\n2\t3.5\n");
    ASSERT_EQ(table.blocks.size(), 1U) << list;
    EXPECT_EQ(table.blocks[0].columns[0].name, "x") << list;
    EXPECT_EQ(table.blocks[0].columns[1].unit, "\u00B5m") << list;
  }
  const TextTable three =
      read("Channel 1;x [mm]\nChannel 2;z [um]\nChannel 3;v [mm/s]\n\n0;1,5;5\n1;2,5;5\n");
  EXPECT_EQ(three.blocks[0].columns[1].unit, "um");
  for (const char* list : {"Column 1: x (mm)\n", "Column 1: x\nColumn 2: z\nColumn 3: y\n",
                           "Column 1: 20 C\nColumn 2: 30 C\n", "Sample 1: NR\nSample 2: BR\n"})
    EXPECT_FALSE(read(std::string(list) + "1\t2.5\n2\t3.5\n").blocks[0].hasNames()) << list;
}

TEST(TextTable, MovesARowOfConditionsAboveTheTableBelow) {
  TextTableOptions options;
  options.keepsTexts = options.readsCells = true;
  TextTable table = read("Sample;Load [N];T [C]\nNR;50,5;23\n\nv;mu\n1;0,3\n10;0,4\n", options);
  moveListsAbove(table);
  ASSERT_EQ(table.blocks.size(), 1U);
  EXPECT_EQ(table.entry("Load", table.blocks[0]), "50,5 N");
  EXPECT_EQ(table.entry("T", table.blocks[0]), "23 C");
  // Neither numbers without names, nor a row of the same columns, nor the larger table.
  for (const char* text :
       {"50;23\n\nv;mu\n1;0.3\n10;0.4\n", "v;mu\n0.1;0.2\n\nv;mu\n1;0.3\n10;0.4\n",
        "a;b;c;d;e\n1;2;3;4;5\n\nv;mu\n1;0.3\n10;0.4\n"}) {
    TextTable other = read(text, options);
    moveListsAbove(other);
    EXPECT_EQ(other.blocks.size(), 2U) << text;
  }
}

/// A line with one number is a row with any separator, so that a list above a table does not tell
/// which one the table has.
TEST(TextTable, KnowsTheSeparatorBelowAListOfNumbers) {
  for (const char* separator : {";", "\t"})
    for (const char decimal : {'.', ','}) {
      std::string rows = "1|2.5|3\n2|3.5|4\n";
      replaceAll(rows, "|", separator);
      std::string text = "20.5\n30.5\n40.5\n50.5\n\n" + rows;
      std::ranges::replace(text, '.', decimal);
      const TextTable table = read(text);
      ASSERT_EQ(table.blocks.size(), 2U) << text;
      EXPECT_EQ(table.blocks[0].at(3, 0), 50.5);
      EXPECT_EQ(table.blocks[1].columns.size(), 3U);
      EXPECT_EQ(table.blocks[1].at(1, 1), 3.5);
    }
}

TEST(TextTable, LeavesOutSeparatorsAtTheEnds) {
  EXPECT_EQ(read("x;z;\n1;2;\n2;3;\n").largest().columns.size(), 2u);
  EXPECT_EQ(read("1,2,\n2,3,\n").largest().columns.size(), 2u);
  EXPECT_EQ(read("1\t2\t\n2\t3\t\n").largest().columns.size(), 2u);
  const TextTable named = read("x;z;valid\n1;2;\n2;3;1\n");
  EXPECT_EQ(named.largest().columns.size(), 3u);
  EXPECT_EQ(named.largest().rows, 2u);
}

TEST(TextTable, TellsAnIndex) {
  EXPECT_TRUE(countsRows(read("0 5\n1 6\n2 6\n").largest(), 0));
  EXPECT_TRUE(countsRows(read(",x\n1,5\n2,6\n3,6\n").largest(), 0));
  EXPECT_FALSE(countsRows(read("0 5\n2 6\n4 6\n").largest(), 0));
  EXPECT_EQ(read(",x,z\n0,5,1\n1,6,2\n").largest().columns[1].name, "x");
}

// ---- Size --------------------------------------------------------------------------------------

TEST(TextTable, ReadsAMillionRowsWithoutLosingAny) {
  for (const char decimal : {'.', ','}) {
    std::string text = "x (mm);z (um)\n";
    constexpr int kRows = 1'000'000;
    for (int i = 0; i < kRows; ++i) {
      std::string row = fmt::format("{:.4f};{:.6e}\n", 1e-4 * i, 1e-3 * (i % 1000));
      if (decimal == ',') std::ranges::replace(row, '.', ',');
      text += row;
    }
    const auto before = std::chrono::steady_clock::now();
    double last = 0;
    TextTableOptions options;
    options.progress = [&last](double part) {
      EXPECT_GE(part, last);
      last = part;
    };
    const TextTable made = read(text, options);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - before;
    RecordProperty(decimal == '.' ? "point_seconds" : "comma_seconds",
                   fmt::format("{}", seconds.count()));
    ASSERT_EQ(made.largest().rows, static_cast<std::size_t>(kRows));
    EXPECT_NEAR(made.largest().at(123456, 0), 12.3456, 1e-9);
    EXPECT_NEAR(made.largest().at(kRows - 1, 1), 0.999, 1e-9);
    EXPECT_GT(last, 0.9);
  }
}

// ---- As people write them ----------------------------------------------------------------------

TextTableOptions withTexts() {
  TextTableOptions options;
  options.keepsTexts = options.readsCells = true;
  return options;
}

TEST(TextTable, QuotedNamesMayHaveLineBreaks) {
  for (const char* end : {"\n", "\r\n"}) {
    const std::string text = replaced(
        "\"Position\nx\n[mm]\";\"Loss modulus G\"\"\n[MPa]\";z\n1;2;3\n\n4;5;6\n", "\n", end);
    const TextBlock block = read(text).largest();
    EXPECT_EQ(block.columns[0].name, "Position x");
    EXPECT_EQ(block.columns[0].unit, "mm");
    EXPECT_EQ(block.columns[1].unit, "MPa");
    EXPECT_EQ(block.columns[2].name, "z");
    EXPECT_THAT(block.lines, ElementsAre(5, 7));
  }
  EXPECT_THAT(errorOf("\"a\nb\",c\n1,2\n3,x\n5,6\n"), HasSubstr("line 4: 'x'"));
  // Marks of repetition and of a loss modulus open no text.
  const TextBlock ditto = read("f;G\"\n1;2\n3;4\n\"\n5;6\n\";\n").blocks.front();
  EXPECT_EQ(ditto.rows, 2U);
}

TEST(TextTable, RowsWithWordsBehindThemAreRefused) {
  for (const char* words : {"invalid", "bad", "ok", "outlier", "first slip", "T = 60 \u00B0C",
                            "at 60 \u00B0C", "cm/s", "\u00B1 0.05", "mean", "ok 3"})
    for (const char* separator : {";", " "}) {
      const std::string text = replaced(
          std::string("v mu\n1 0.2\n5 0.9 ") + words + "\n10 0.3\n20 0.4\n", " ", separator);
      EXPECT_THAT(errorOf(text), HasSubstr("line 3: has ")) << text;
      // "0.9 cm/s" may be one cell.
      if (separator == std::string_view(";"))
        EXPECT_THAT(errorOf(text, withTexts()), HasSubstr("line 3: has ")) << text;
    }
  // No row is lost where all have a word behind.
  for (const char* text : {"v mu load (N)\n1 0.2 50 N\n5 0.9 50 N\n10 0.3 50 N\n",
                           "v mu\n1 0.2 first\n5 0.9 here\n10 0.3 last\n"})
    EXPECT_THAT(errorOf(text), HasSubstr("has no rows of numbers")) << text;
}

TEST(TextTable, QuotedLinesWithNumbersStandAlone) {
  const TextTable column = read("\"1\n2\n3\n4\n5\"\n");
  EXPECT_THAT(column.blocks[0].column(0), ElementsAre(2, 3, 4));
  EXPECT_THAT(column.leftOut, ElementsAre(1, 5));
  EXPECT_THAT(read("x;z\n\"0;1.3\n1;1.4\n2;1.2\n").leftOut, ElementsAre(2));
  const TextTable width = read("\"Width: 10 mm\nHeight: 5 mm\"\n1;2;3\n4;5;6\n");
  EXPECT_EQ(width.blocks[0].header.size(), 2U);
  EXPECT_EQ(width.blocks[0].header[0].key, "\"Width");
}

TEST(TextTable, QuotedNamesMayHaveLinesWithNumbers) {
  for (const char* first : {"1", "0", "7"}) {
    const TextBlock block = read(std::string("\"v\n(mm/s)\";\"mu\n5 \u00B0C\";\"mu\n1. run\"\n") +
                                 first + ";0.5;0.6\n10;0.7;0.8\n")
                                .largest();
    ASSERT_EQ(block.columns.size(), 3U);
    EXPECT_EQ(block.columns[0].name, "v") << first;
    EXPECT_EQ(block.columns[1].name + " " + block.columns[1].unit, "mu 5 \u00B0C") << first;
    EXPECT_EQ(block.columns[2].name, "mu 1. run") << first;
  }
  // Names of which one cannot be joined are not joined at all.
  const TextTable other = read("\"v\n(mm/s)\";\"mu\n5\"\n2;0.5\n10;0.7\n");
  for (const TextColumn& column : other.largest().columns) EXPECT_NE(column.name, "v");
}

TEST(TextTable, UnitsMayHaveAColumnOfTheirOwn) {
  const TextBlock block = read("v;unit;mu\n1;mm/s;0.5\n10;mm/s;0.6\n", withTexts()).largest();
  EXPECT_EQ(block.columns[0].unit, "mm/s");
  EXPECT_EQ(block.columns[2].unit, "");
  EXPECT_THAT(errorOf("v;unit;mu\n1;mm/s;0.5\n1;m/s;0.6\n", withTexts()),
              HasSubstr("row 3: column v has the unit m/s here, and mm/s elsewhere"));
  EXPECT_THAT(errorOf("v;unit;mu\n1;mm/s;0.5\n10;;0.6\n", withTexts()),
              HasSubstr("row 3: column v has no unit here, and mm/s elsewhere"));
  EXPECT_THAT(errorOf("v;unit;mu\n1;;0.5\n10;mm/s;0.6\n", withTexts()), HasSubstr("row 2: "));
  // Behind several columns, units may be those of each.
  for (const char* text :
       {"f;G';G'';unit\n1;3;1;Pa\n10;4;2;Pa\n", "v (mm/s);mu;Unit\n1;0.5;A\n10;0.6;A\n",
        "v (mm/s);mu;Unit\n1;0.5;N\n10;0.6;N\n", "Unit;v;mu\n1;2;3\n4;5;6\n"}) {
    const TextTable table = read(text, withTexts());
    for (const TextColumn& column : table.largest().columns)
      EXPECT_TRUE(column.unit.empty() || column.name == "v") << text;
  }
  // A first row of ones is none of units there.
  const TextBlock ones = read("v;unit;mu\n1;mm/s;1\n10;mm/s;0.6\n", withTexts()).largest();
  EXPECT_THAT(ones.column(0), ElementsAre(1, 10));
  EXPECT_EQ(ones.columns[0].unit, "mm/s");
  // A sample may be called K.
  EXPECT_EQ(read("v;sample;mu\n1;K;0.5\n10;K;0.6\n", withTexts()).largest().columns[0].unit, "");
}

std::string temperatureIn(const std::string& name, const std::string& unit) {
  const bool isNamed = name.empty() || name == "t" || name == "temperature";
  return isNamed && unit == "\u00B0C" ? "temperature" : "";
}

/// Reads two rows of x and z below a line, other lines, and two rows without names.
TextTable readTwice(const std::string& above, const std::string& between,
                    std::vector<Message>& notes, const std::string& names = "x (mm);z") {
  TextTable table = read(above + "\n" + names + "\n1;2\n3;4\n" + between + "\n5;6\n7;8\n");
  notes = repeatNames(
      table, [](const TextBlock& block) { return block.hasNames(); }, temperatureIn);
  return table;
}

TEST(TextTable, NamesHoldForRowsBelowAnotherValueOfAQuantity) {
  for (const char* line : {"T = 20 \u00B0C", "T = 20 \u00B0C;", "\nTemperature: 20 \u00B0C",
                           "T [\u00B0C] = 20", "---\nT = 20,5 \u00B0C"}) {
    std::vector<Message> notes;
    const TextTable table = readTwice("T = 5 \u00B0C", line, notes);
    ASSERT_EQ(table.blocks.size(), 2U) << line;
    EXPECT_EQ(table.blocks[1].columns[0].name, "x") << line;
    EXPECT_EQ(table.blocks[1].columns[1].name, "z") << line;
    EXPECT_EQ(notes.size(), 1U) << line;
  }
}

TEST(TextTable, NamesDoNotHoldBelowOtherLines) {
  std::vector<Message> notes;
  for (const char* line :
       {"Run 2", "----", "T = 20 \u00B0C, z in mm", "z in mm; T = 20 \u00B0C",
        "WLF: Tref = 20 \u00B0C", "Tref = 20 \u00B0C", "Tg = -60 \u00B0C",
        "Mean values, T = 5 \u00B0C", "Mittelwert T = 5 \u00B0C", "Fit at 20 \u00B0C",
        "shift factors, T = 20 \u00B0C", "[1] T = 20 \u00B0C", "T = 20 \u00B0C (mean)",
        "duration: 5 min", "T = 20", "T = 20 \u00B0C\nMean", "Sum: T = 20 \u00B0C", "T = 5 \u00B0C",
        "v = 1 mm/s"}) {
    const TextTable table = readTwice("T = 5 \u00B0C", line, notes);
    ASSERT_EQ(table.blocks.size(), 2U) << line;
    EXPECT_NE(table.blocks[1].columns[1].name, "z") << line;
    EXPECT_TRUE(notes.empty()) << line;
  }
  // The first rows have no temperature, or a column of it.
  EXPECT_EQ(readTwice("", "T = 20 \u00B0C", notes).blocks[1].columns[1].name, "");
  const TextTable ofColumn =
      readTwice("T = 5 \u00B0C", "T = 20 \u00B0C", notes, "z;temperature (\u00B0C)");
  EXPECT_EQ(ofColumn.blocks[1].columns[1].name, "");
}

TEST(TextTable, LinesBelowATableThatStateAQuantityAlone) {
  const auto below = [](const std::string& lines) {
    return statedBelow(read("x (mm);z\n1;2\n3;4\n\n" + lines), temperatureIn).size();
  };
  EXPECT_EQ(below("T = 20 \u00B0C\n---\nTemperature;20;\u00B0C\nOperator: A\n"), 2U);
  EXPECT_EQ(below("Cured: 20 min\nT = 160 \u00B0C\n"), 0U);
  EXPECT_EQ(below("T = 20\nTest 2: T = 20 \u00B0C\nT: 60 \u00B0C for ageing\n"), 0U);
  EXPECT_EQ(below("Next test\nT = 20 \u00B0C\n"), 0U);
  EXPECT_EQ(below("Ageing:\nT = 20 \u00B0C\n"), 0U);
}

}  // namespace
}  // namespace asperity
