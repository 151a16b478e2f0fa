// Tables of numbers whose lines or marks can be taken for something else: units across comments,
// damaged rows, empty lines, marks between thousands.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/base/input_error.h"
#include "core/base/text_table.h"

namespace asperity {
namespace {

using testing::ElementsAre;

TextTable tableOf(const std::string& text, const TextTableOptions& options = {}) {
  return readTextTable(text, "table.txt", options);
}

/// A comment, a word or a damaged row below the names does not part them from their numbers.
TEST(TextTableMarks, KeepsUnitsAcrossOtherLines) {
  for (const std::string header : {"x [mm];z [um]\n", "x;z\nmm;um\n", "# x/mm;z/um\n"})
    for (const std::string between :
         {"# scan 1\n", "// scan 1\n", "#DATA\n", "BEGIN\n", "start of data\n", "Date: today\n",
          "-0.5;broken\n", "-0.5;1e400\n", "***;***\n", "# scan 1\n# pass 2\n", "# first; second\n",
          "Step 1\n\n# it begins\n"}) {
      const TextTable made = tableOf(header + between + "0.5;1.5\n1.0;2.5\n1.5;3.5\n");
      const TextBlock& block = made.largest();
      ASSERT_EQ(block.rows, 3u) << header << between;
      EXPECT_EQ(block.columns[0].name, "x") << header << between;
      EXPECT_EQ(block.columns[1].name, "z") << header << between;
      EXPECT_EQ(block.columns[0].unit, "mm") << header << between;
      EXPECT_EQ(block.columns[1].unit, "um") << header << between;
    }
  for (const std::string between : {"", "# scan 1\n", "BEGIN\n", "Date: today\n"})
    EXPECT_EQ(tableOf("Height [um]\n" + between + "1.5\n2.5\n3.5\n").largest().columns[0].unit,
              "um")
        << between;
}

/// Without such names what stands further up belongs to something else.
TEST(TextTableMarks, TakesNoUnitsOfAnotherTable) {
  const std::string rows = "0.5;1.5\n1.0;2.5\n1.5;3.5\n";
  for (const std::string header : {"Speed [mm];Range [um]\nfast;0.5\nPosition;Height\n",
                                   "Unit;um\n[Data]\n", "Range [mm];0.5\n[Data]\n"}) {
    const TextTable made = tableOf(header + rows);
    EXPECT_EQ(made.largest().columns[0].unit, "") << header;
    EXPECT_EQ(made.largest().columns[1].unit, "") << header;
  }
  EXPECT_EQ(tableOf("Plate [2024]\n# scan 1\n1.5\n2.5\n3.5\n").largest().columns[0].unit, "");
  EXPECT_EQ(tableOf("tip of 2 um\nHeight\n1.5\n2.5\n3.5\n").largest().columns[0].unit, "");
}

/// A line that is damaged at the end or at the beginning of the rows is no result of a program.
TEST(TextTableMarks, NamesLinesThatLookLikeRows) {
  EXPECT_THAT(tableOf("x;z\n1;2\n2;3\n3;4.5.6\n").leftOut, ElementsAre(4u));
  EXPECT_THAT(tableOf("x;z\n0;broken\n1;2\n2;3\n").leftOut, ElementsAre(2u));
  EXPECT_THAT(tableOf("x;z\n0;1;stick\n1;2;slip\n1;2\n2;3\n").leftOut, ElementsAre(2u, 3u));
  EXPECT_TRUE(tableOf("2024-05-01\nx;z\n1;2\n2;3\nRa;0.5\n# 3 um\n").leftOut.empty());
}

/// A logger writes when it took each value.
TEST(TextTableMarks, LeavesDatesOutWhereACallerWants) {
  TextTableOptions options;
  options.datesAreMissing = true;
  for (const std::string date : {"2024-03-12", "2024-03-12 10:22:33.5", "12.03.2024", "3/12/2024",
                                 "10:22:33", "2024-03-12T10:22:33Z"}) {
    const TextTable made = tableOf(date + ";1;2\n" + date + ";3;4\n", options);
    ASSERT_EQ(made.largest().rows, 2u) << date;
    EXPECT_TRUE(std::isnan(made.largest().at(1, 0))) << date;
    EXPECT_EQ(made.largest().at(1, 2), 4) << date;
  }
  for (const std::string other : {"1.2.3", "a 10:22", "12-14", "5.1x"})
    EXPECT_THROW(tableOf(other + ";1;2\n" + other + ";3;4\n", options), InputError) << other;
}

/// Spreadsheets write an empty line for an empty cell of a single column.
TEST(TextTableMarks, TakesBlankLinesInAColumnForGapsWhereACallerWants) {
  TextTableOptions options;
  options.blankLinesAreGaps = true;
  const auto gapsIn = [&options](const std::string& text) {
    const TextTable made = tableOf(text, options);
    std::vector<std::size_t> gaps;
    for (std::size_t i = 0; i < made.largest().rows; ++i)
      if (std::isnan(made.largest().at(i, 0))) gaps.push_back(i);
    EXPECT_EQ(made.largest().lines.size(), made.largest().rows);
    return gaps;
  };
  EXPECT_THAT(gapsIn("z\n\n1\n2\n\n4\n\n\n7\n8\n\n\n"), ElementsAre(2u, 4u, 5u));
  // Between all rows, beside comments and between two columns they space the lines.
  EXPECT_THAT(gapsIn("z\n1\n\n2\n\n3\n\n4\n"), ElementsAre());
  EXPECT_THAT(gapsIn("z\n1\n2\n\n# second part\n\n3\n4\n"), ElementsAre());
  EXPECT_EQ(tableOf("1 2\n\n3 4\n5 6\n", options).largest().rows, 3u);
  EXPECT_EQ(tableOf("1\n\n3\n5\n").largest().rows, 3u);
}

/// Rows of 2000 i and of 13000 + 7 (i mod 40) with marks between groups of three digits.
std::string grouped(int rows, char mark, char separator) {
  const auto text = [mark](int number) {
    std::string digits = std::to_string(number);
    for (int at = static_cast<int>(digits.size()) - 3; at > 0; at -= 3)
      digits.insert(static_cast<std::size_t>(at), 1, mark);
    return digits;
  };
  std::string made;
  for (int i = 0; i < rows; ++i)
    made += text(2000 * i) + separator + text(13000 + 7 * (i % 40)) + "\n";
  return made;
}

/// Two marks in one of many numbers say what they separate, wherever it stands.
TEST(TextTableMarks, TakesMarksForThousandsWhereOneNumberHasTwo) {
  for (const char mark : {'.', ','})
    for (const char separator : {';', '\t', ' '}) {
      const TextTable made = tableOf(grouped(600, mark, separator));
      const TextBlock& block = made.largest();
      ASSERT_EQ(block.rows, 600u) << mark << separator;
      EXPECT_EQ(block.at(1, 0), 2000) << mark << separator;
      EXPECT_EQ(block.at(599, 0), 1198000) << mark << separator;
      EXPECT_EQ(block.at(1, 1), 13007) << mark << separator;
      EXPECT_FALSE(made.dialect.isUnclear);
    }
}

/// Heights about 1000, of which those below have no mark: decimals would be 0.929.
TEST(TextTableMarks, TakesMarksForThousandsWhereSmallerNumbersHaveNone) {
  const auto rows = [](const auto& height) {
    std::string text;
    for (int i = 0; i < 200; ++i) text += fmt::format("{};{}\n", 2000 * i, height(i));
    return text;
  };
  const auto height = [](int i) { return 1100 + 150 * std::sin(0.1 * i); };
  const TextTable made = tableOf(rows([&](int i) {
    const int number = static_cast<int>(height(i));
    return number < 1000 ? std::to_string(number)
                         : fmt::format("{}.{:03}", number / 1000, number % 1000);
  }));
  ASSERT_EQ(made.largest().rows, 200u);
  EXPECT_TRUE(made.dialect.isUnclear);
  for (std::size_t i = 0; i < 200; ++i)
    EXPECT_EQ(made.largest().at(i, 1), static_cast<int>(height(static_cast<int>(i)))) << i;
  // The same numbers as decimals: all have three digits, a part of them has fewer, or whole ones
  // are codes.
  const auto read1 = [&](const auto& write) {
    const TextTable table = tableOf(rows(write));
    for (std::size_t i = 0; i < 200; ++i)
      EXPECT_NEAR(table.largest().at(i, 1), height(static_cast<int>(i)) / 1000, 0.006) << i;
    return table.dialect.isUnclear;
  };
  EXPECT_FALSE(read1([&](int i) { return fmt::format("{:.3f}", height(i) / 1000); }));
  EXPECT_FALSE(read1([&](int i) { return fmt::format("{:.3g}", height(i) / 1000); }));
  const auto above = [&](int i) { return std::max(height(i) / 1000, 1.0); };
  EXPECT_TRUE(
      tableOf(rows([&](int i) { return fmt::format("{:.3f}", 1 + above(i)); })).dialect.isUnclear);
  const TextTable codes = tableOf(rows([&](int i) {
    return i % 20 == 3 ? std::string("999") : fmt::format("{:.3f}", 1 + above(i));
  }));
  EXPECT_EQ(codes.dialect.decimal, '.');
}

TEST(TextTableMarks, QuotedCommasAmidCommasSeparateThousands) {
  const TextTable made = tableOf("v,mu\n\"1,000\",2e-4\n\"12,500\",5e-4\n");
  EXPECT_EQ(made.largest().at(0, 0), 1000);
  EXPECT_EQ(made.largest().at(1, 0), 12500);
  const TextTable decimals = tableOf("v,mu\n\"1,000\",\"0,25\"\n\"12,500\",\"0,5\"\n");
  EXPECT_EQ(decimals.largest().at(1, 0), 12.5);
}

TEST(TextTableMarks, BlanksBesideTabsSeparateThousands) {
  const TextTable made = tableOf("v\tmu\n1 000\t0.2\n12 500\t0.5\n");
  ASSERT_EQ(made.largest().columns.size(), 2u);
  EXPECT_EQ(made.largest().at(1, 0), 12500);
}

/// One of the columns may come from a program with another decimal mark.
TEST(TextTableMarks, ThousandsAloneInAColumnAreSaid) {
  const auto doubts = [](const std::string& text) { return doubtsAbout(tableOf(text)).size(); };
  const TextTable made = tableOf("F;mu\n1.000;0,25\n2.000;0,31\n2.500;0,4\n");
  EXPECT_THAT(made.largest().column(0), ElementsAre(1000, 2000, 2500));
  ASSERT_EQ(doubtsAbout(made).size(), 1u);
  EXPECT_EQ(doubtsAbout(made)[0].english(),
            "All numbers of a column have a '.' before their last three digits and are read as "
            "thousands: ',' is the decimal mark of the others.");
  EXPECT_EQ(doubts("F;mu\n1,000;0.25\n2,000;0.31\n2,500;0.4\n"), 1u);
  // Other numbers of the column show that they are thousands.
  EXPECT_EQ(doubts("F;mu\n500;0,25\n1.000;0,31\n1.500;0,4\n"), 0u);
  EXPECT_EQ(doubts("F;mu\n1.000,5;0,25\n2.000;0,31\n2.500;0,4\n"), 0u);
  EXPECT_EQ(doubts("F;mu\n1.000.000;0,25\n2.000.000;0,31\n"), 0u);
  EXPECT_EQ(doubts("F;mu\n1,5;0,25\n2,5;0,31\n"), 0u);
}

}  // namespace
}  // namespace asperity
