#include "core/study/study_database.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "tests/core/error_from.h"
#include "tests/core/temporary_folder.h"

namespace asperity {
namespace {

using testing::HasSubstr;
using Access = StudyDatabase::Access;

TEST(StudyDatabase, ValuesComeBackToTheLastBit) {
  const TemporaryFolder folder;
  const std::vector<double> numbers{0.1, -0.0, 5e-324, std::numeric_limits<double>::infinity()};
  const std::string text("a\0b \u03BC", 6);
  {
    const StudyDatabase database(folder / "s.study", Access::Write);
    database.execute("CREATE TABLE t (whole, number, text, bytes)");
    StudyDatabase::Statement insert(database, "INSERT INTO t VALUES (?, ?, ?, ?)");
    insert.bind(1, std::numeric_limits<std::int64_t>::min());
    insert.bind(2, 0.1);
    insert.bindText(3, text);
    insert.bindBytes(
        4, {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double)});
    EXPECT_FALSE(insert.step());
    database.endSharing();
  }
  const StudyDatabase database(folder / "s.study", Access::Read);
  StudyDatabase::Statement row(database, "SELECT whole, number, text, bytes FROM t");
  ASSERT_TRUE(row.step());
  EXPECT_EQ(row.whole(0), std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(row.real(1), 0.1);
  EXPECT_EQ(row.text(2), text);
  EXPECT_EQ(row.numbers(3), numbers);
  EXPECT_FALSE(row.step());
  EXPECT_EQ(folder.names(), std::vector<std::string>{"s.study"}) << "it can be read everywhere";
}

/// A store that several processes share is read while one of them writes.
TEST(StudyDatabase, AFailedTransactionLeavesNothing) {
  const TemporaryFolder folder;
  const StudyDatabase writer(folder / "s.study", Access::Write);
  writer.execute("CREATE TABLE t (number PRIMARY KEY)");
  const StudyDatabase reader(folder / "s.study", Access::Read);
  writer.execute("BEGIN IMMEDIATE");
  writer.execute("INSERT INTO t VALUES (1)");
  EXPECT_EQ(reader.number("SELECT count(*) FROM t"), 0);
  EXPECT_THROW(writer.execute("INSERT INTO t VALUES (1)"), std::runtime_error);
  EXPECT_EQ(writer.number("SELECT count(*) FROM t"), 0);
  writer.execute("INSERT INTO t VALUES (2)");
  EXPECT_EQ(reader.number("SELECT count(*) FROM t"), 1);
}

TEST(StudyDatabase, OtherFilesAreNamed) {
  const TemporaryFolder folder;
  const auto errorOf = [&](const std::string& bytes) {
    const auto file = folder.write("other", bytes);
    return errorFrom([&] { StudyDatabase(file, Access::Read); });
  };
  EXPECT_THAT(errorOf("velocity,mu\n1,0.5\n"), HasSubstr("is not the store of a study"));
  EXPECT_THAT(errorOf(std::string("PK\3\4") + std::string(60, '\0')),
              HasSubstr("is not the store of a study, but "));
}

}  // namespace
}  // namespace asperity
