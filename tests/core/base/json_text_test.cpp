#include "core/base/json_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "core/base/input_error.h"
#include "tests/core/error_from.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

TEST(JsonText, WhatIsWrittenIsReadBack) {
  const Json value = {{"b", {1, 2.5, nullptr}}, {"a", "\u00B5 \"x\"\n"}};
  EXPECT_EQ(jsonLine(value), "{\"b\":[1,2.5,null],\"a\":\"\u00B5 \\\"x\\\"\\n\"}");
  EXPECT_EQ(jsonValue(jsonLine(value)), value);
  EXPECT_EQ(jsonValue(jsonFile(value)), value);
  EXPECT_TRUE(jsonFile(value).ends_with("\n}\n"));
  // Numbers come back bit for bit.
  for (const double number : {0.1, 1.0 / 3, 5e-324, std::numeric_limits<double>::max()})
    EXPECT_EQ(jsonValue(jsonLine(number)).get<double>(), number);
}

/// A file name may hold any bytes; an answer that names it is UTF-8 all the same.
TEST(JsonText, BytesThatAreNoTextAreReplaced) {
  EXPECT_EQ(jsonLine("a\xff"), "\"a\uFFFD\"");
  EXPECT_EQ(jsonFile("a\xff"), "\"a\uFFFD\"\n");
}

TEST(JsonText, TextThatIsNoJsonIsDiscarded) {
  for (const char* text : {"", "{", "{\"a\":1,}", "scene"})
    EXPECT_TRUE(jsonOrDiscarded(text).is_discarded()) << text;
  EXPECT_EQ(jsonOrDiscarded("[1]"), Json::array({1}));
}

TEST(JsonText, KeysThatOccurTwiceAndDeepNestingAreRefused) {
  constexpr int kDeepest = 3;
  const auto error = [](const std::string& text) {
    return errorFrom([&] { parseJson(text, kDeepest); });
  };
  EXPECT_EQ(error(R"({"a":{"b":[1]}})"), "no error");
  EXPECT_THAT(error(R"({"a":1,"a":2})"), HasSubstr("a"));
  EXPECT_NE(error(R"({"a":1,"a":2})"), "no error");
  EXPECT_NE(error(R"({"a":{"b":[[1]]}})"), "no error");
  EXPECT_NE(error("scene"), "no error");
}

/// As values, which other languages name as well.
TEST(JsonText, AnErrorNamesItsLineAndColumn) {
  try {
    parseJson("{\"a\": 1,\n \"b\": }", 8);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.message().text, "is not valid JSON: line %1, column %2: %3");
    ASSERT_EQ(error.message().values.size(), 3U);
    EXPECT_EQ(error.message().values[0].text, "2");
    EXPECT_EQ(error.message().values[1].text, "7");
  }
}

/// The library states no place of a number that is too large.
TEST(JsonText, ANumberThatIsTooLargeHasALine) {
  try {
    parseJson("{\"a\": 1,\n \"b\": 1e999}", 8);
    FAIL();
  } catch (const InputError& error) {
    ASSERT_EQ(error.message().values.size(), 3U);
    EXPECT_EQ(error.message().values[0].text, "2");
    EXPECT_EQ(error.message().values[1].text, "11");
  }
}

TEST(JsonText, ANumberThatIsTooSmallIsNotZero) {
  const auto error = [](const std::string& text) { return errorFrom([&] { parseJson(text, 8); }); };
  EXPECT_THAT(error(R"({"a":{"b":-1.5e-400}})"),
              testing::AllOf(HasSubstr("a.b"), HasSubstr("-1.5e-400 is too close to 0")));
  for (const char* const zero : {"0.0", "-0e5", "0.00e-999", "5e-324"})
    EXPECT_EQ(error("{\"a\":" + std::string(zero) + "}"), "no error") << zero;
}

TEST(JsonText, MembersUpToOneAreReadWithoutWhatFollows) {
  const std::string text = R"({"a":1,"b":{"c":2},"d": no JSON)";
  EXPECT_EQ(membersUpTo(text, "b", 4), (Json{{"a", 1}, {"b", {{"c", 2}}}}));
}

TEST(JsonText, NumbersThatAreNotFiniteAreNull) {
  EXPECT_TRUE(numberOrNull(std::numeric_limits<double>::quiet_NaN()).is_null());
  EXPECT_EQ(numberOrNull(0.5), 0.5);
}

}  // namespace
}  // namespace asperity
