#include "core/base/text.h"

#include <gtest/gtest.h>

#include <array>
#include <ranges>
#include <string>
#include <vector>

#include "core/base/input_error.h"

namespace asperity {
namespace {

using namespace std::string_literals;

TEST(PrintableText, WhatIsPrintableStays) {
  for (const char* text : {"", "plain text", "Größe µm 10⁻⁶ 表面 é \U0001F600", "C:\\folder",
                           "'quoted' \"twice\"", "\u00A0 \uFFFD"})
    EXPECT_EQ(printable(text), text);
}

TEST(PrintableText, WhatATerminalObeysIsWrittenOut) {
  EXPECT_EQ(printable("\x1b[31mred\x1b[0m"), "\\x1b[31mred\\x1b[0m");
  EXPECT_EQ(printable("a\nb\r\tc"), "a\\nb\\r\\tc");
  EXPECT_EQ(printable("a\0b\x7f\a"s), "a\\x00b\\x7f\\x07");
  EXPECT_EQ(printable("\u009b31m"), "\\u009b31m");  // the same as ESC [ to some terminals
}

TEST(PrintableText, WhatShowsAsSomethingElseIsWrittenOut) {
  EXPECT_EQ(printable("\u202Efdp.exe"), "\\u202efdp.exe");
  EXPECT_EQ(printable("a\u200Bb\uFEFF\u2028\u2066"), "a\\u200bb\\ufeff\\u2028\\u2066");
  EXPECT_EQ(printable("\U000E0041"), "\\U000e0041");
}

TEST(PrintableText, BytesThatAreNoUtf8AreWrittenOut) {
  EXPECT_EQ(printable("\xff\xfeh\0"s), "\\xff\\xfeh\\x00");
  EXPECT_EQ(printable("half \xc3"), "half \\xc3");
  EXPECT_EQ(printable("\xe2\x82 and \xf0\x9f\x98"), "\\xe2\\x82 and \\xf0\\x9f\\x98");
  EXPECT_EQ(printable("\xc0\x9b"), "\\xc0\\x9b");           // longer than needed
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");  // half of a pair
  EXPECT_EQ(printable("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");
  EXPECT_EQ(printable("\x80"), "\\x80");
}

TEST(PrintableText, QuotedTwiceIsTheSame) {
  for (const std::string& text : {"\x1b[0m\n"s, "\xff"s, "\u202e"s, "\0"s})
    EXPECT_EQ(printable(printable(text)), printable(text));
}

/// Whatever part of an error a user wrote.
TEST(PrintableText, AnErrorHoldsNothingElse) {
  const InputError error("a\x1b[2J.json", "surface.\nhurst", "'\xff' is not a number");
  EXPECT_STREQ(error.what(), "a\\x1b[2J.json: surface.\\nhurst: '\\xff' is not a number");
  EXPECT_EQ(error.file(), "a\\x1b[2J.json");
  EXPECT_EQ(error.key(), "surface.\\nhurst");
  EXPECT_EQ(error.message(), "'\\xff' is not a number");
  EXPECT_STREQ(error.in("b\n").what(), "b\\n: surface.\\nhurst: '\\xff' is not a number");
}

constexpr std::array<std::string_view, 3> kThemes{"light", "dark", "print"};

TEST(KnownWords, NamesTheNearestAndListsAll) {
  EXPECT_EQ(nearestWord("drak", kThemes), "dark");
  EXPECT_EQ(nearestWord("", {}), "");
  EXPECT_EQ(nearestWord("", kThemes), "");
  EXPECT_EQ(nearestWord("foo", kThemes), "");
  EXPECT_EQ(notOneOf("pink", kThemes).english(), "pink is not one of light, dark, print");
}

TEST(KnownWords, ALongWordIsCutBetweenLetters) {
  EXPECT_EQ(shortened("short"), "short");
  EXPECT_EQ(shortened(std::string(100, 'x')), std::string(60, 'x') + "...");
  // A letter of two bytes that begins with the last byte that would be kept.
  EXPECT_EQ(shortened(std::string(59, 'x') + "\u00FC" + std::string(9, 'x')),
            std::string(59, 'x') + "...");
}

TEST(KnownWords, AListIsWrittenAsOneText) {
  const WordList units("mm \u00B5m in");
  EXPECT_TRUE(isOneOf("mm", units) && isOneOf("\u00B5m", units) && isOneOf("in", units));
  for (const char* other : {"", "m", "mm \u00B5m", "inch"}) EXPECT_FALSE(isOneOf(other, units));
  EXPECT_TRUE(beginsWithOneOf("inch", units));
  EXPECT_TRUE(endsWithOneOf("10mm", units));
  EXPECT_TRUE(containsOneOf("10mm wide", units));
  EXPECT_FALSE(containsOneOf("10 km", units));
  EXPECT_TRUE(hasOneOf(std::vector<std::string>{"step", "in"}, units));
  EXPECT_FALSE(hasOneOf(std::vector<std::string>{}, units));
  const WordList keys("step size, x step,  pitch", ',');
  EXPECT_EQ(std::vector<std::string>(keys.begin(), keys.end()),
            (std::vector<std::string>{"step size", "x step", "pitch"}));
  EXPECT_TRUE(std::ranges::empty(WordList("")));
}

TEST(FileName, HasNoSignThatAFolderOrAShellCouldTake) {
  EXPECT_EQ(makeFileName("paper_2-a"), "paper_2-a");
  EXPECT_EQ(makeFileName("../a b/$c"), "___a_b__c");
  EXPECT_EQ(makeFileName(""), "");
  EXPECT_EQ(makeFileName(std::string(1000, 'x')).size(), 60U);
}

}  // namespace
}  // namespace asperity
