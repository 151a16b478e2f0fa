// What is said of a word that is not known.
#include "core/base/message.h"
#include "core/base/text.h"

#include <gtest/gtest.h>

#include <array>

namespace asperity {
namespace {

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

}  // namespace
}  // namespace asperity
