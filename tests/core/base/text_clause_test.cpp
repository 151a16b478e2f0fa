// Clauses, statements and words of a line of text.
#include "core/base/text_clause.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace asperity {
namespace {

using testing::ElementsAre;

TEST(TextClause, HasAKeyAndAQuantity) {
  const auto statement = parseStatement("Test 3: E0 (MPa) = 600");
  ASSERT_TRUE(statement);
  EXPECT_EQ(statement->key, "E0 (MPa)");
  EXPECT_EQ(statement->name.name, "E0");
  EXPECT_EQ(statement->quantity.number, 600);
  EXPECT_EQ(statement->unit(), "MPa");
  EXPECT_EQ(parseStatement("T_ref (K): 20 \u00B0C")->unit(), "\u00B0C");
  for (const char* none : {"", "load 30 N", "operator: me", "="})
    EXPECT_FALSE(parseStatement(none)) << none;
  EXPECT_THAT(splitClauses("Master curve, Tref = 20 \u00B0C; 1,5 mm"),
              ElementsAre("Master curve", "Tref = 20 \u00B0C", "1,5 mm"));
  EXPECT_THAT(wordsIn("T_ref of G'(w)"), ElementsAre("tref", "of", "g", "w"));
  EXPECT_EQ(plainWord("u(\u00B5) mean"), "u\u00B5mean");
}

}  // namespace
}  // namespace asperity
