#include "core/base/text.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(FileName, HasNoSignThatAFolderOrAShellCouldTake) {
  EXPECT_EQ(makeFileName("paper_2-a"), "paper_2-a");
  EXPECT_EQ(makeFileName("../a b/$c"), "___a_b__c");
  EXPECT_EQ(makeFileName(""), "");
  EXPECT_EQ(makeFileName(std::string(1000, 'x')).size(), 60U);
}

}  // namespace
}  // namespace asperity
