// The store of a study: what is done stays done, whatever happens to processes and files.
#include "core/study/study_store.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <cmath>
#include <limits>

#include "core/base/input_error.h"
#include "core/study/study_run.h"
#include "tests/core/error_from.h"
#include "tests/core/temporary_folder.h"

namespace asperity {
namespace {

constexpr const char* kStudy =
    R"({"schema":"asperity-study/1","chunk":4,"space":{"load.normal_force":{"from":0.001,"to":1,)"
    R"("points":22}},"outputs":["mu","contact_fraction"]})";

ParameterStudy smallStudy() {
  return readStudy(kStudy, "s.json", {});
}

/// A chunk with numbers that tell where they belong.
StudyChunk chunkOf(const ParameterStudy& study, std::int64_t number) {
  StudyChunk chunk;
  chunk.number = number;
  chunk.first = number * study.chunk;
  chunk.count = study.sizeOfChunk(number);
  for (std::size_t n = 0; n < study.numbers(); ++n)
    for (std::int64_t i = 0; i < chunk.count; ++i)
      chunk.values.push_back(static_cast<double>(chunk.first + i) + 0.1 * static_cast<double>(n));
  return chunk;
}

std::vector<std::int64_t> chunksIn(const StudyStore& store) {
  std::vector<std::int64_t> numbers;
  store.eachChunk([&](const StudyChunk& chunk) {
    numbers.push_back(chunk.number);
    return true;
  });
  return numbers;
}

/// Changes a store behind the program's back.
void execute(const std::filesystem::path& file, const char* sql) {
  sqlite3* connection = nullptr;
  ASSERT_EQ(sqlite3_open(file.c_str(), &connection), SQLITE_OK);
  EXPECT_EQ(sqlite3_exec(connection, sql, nullptr, nullptr, nullptr), SQLITE_OK)
      << sqlite3_errmsg(connection);
  sqlite3_close(connection);
}

class StudyStoreTest : public testing::Test {
 protected:
  /// A store of all chunks but those left out.
  std::filesystem::path storeWithout(const std::string& name, std::vector<std::int64_t> leftOut,
                                     const Shard& shard = {}) const {
    StudyStore store(folder / name, study, shard);
    for (std::int64_t number = 0; number < study.chunks(); ++number)
      if (shard.has(number) && std::ranges::find(leftOut, number) == leftOut.end())
        store.add(chunkOf(study, number));
    if (store.isWhole()) store.finish();
    return folder / name;
  }

  TemporaryFolder folder;
  ParameterStudy study = smallStudy();
};

TEST_F(StudyStoreTest, KeepsChunksWithTheirNumbersToTheLastBit) {
  const auto file = folder / "s.study";
  {
    StudyStore store(file, study, {});
    StudyChunk chunk = chunkOf(study, 2);
    chunk.values[1] = std::numeric_limits<double>::quiet_NaN();
    chunk.values[3] = std::numeric_limits<double>::denorm_min();
    chunk.failures = {{9, "a \"message\", with \xC3\xBC"}};
    store.add(chunk);
    store.add(chunk);  // twice is once
  }
  const StudyStore store(file);
  EXPECT_EQ(store.study().digest, study.digest);
  EXPECT_EQ(store.chunksDone(), 1);
  EXPECT_EQ(store.simulationsDone(), 4);
  EXPECT_TRUE(store.hasFailures());
  EXPECT_FALSE(store.isWhole());
  EXPECT_THAT(store.missing(3), testing::ElementsAre(0, 1, 3));
  store.eachChunk([&](const StudyChunk& chunk) {
    EXPECT_EQ(chunk.at(0, 0), 8);
    EXPECT_TRUE(std::isnan(chunk.at(0, 1)));
    EXPECT_EQ(chunk.at(0, 3), std::numeric_limits<double>::denorm_min());
    EXPECT_EQ(chunk.at(1, 2), 10.1);
    EXPECT_EQ(chunk.failures.at(0).message, "a \"message\", with \xC3\xBC");
    return true;
  });
}

TEST_F(StudyStoreTest, TheLastChunkIsShorter) {
  const auto file = storeWithout("s", {});
  const StudyStore store(file);
  EXPECT_EQ(store.chunksDone(), 6);
  EXPECT_EQ(store.simulationsDone(), 22);
  EXPECT_TRUE(store.isWhole());
  EXPECT_THAT(folder.names(), testing::ElementsAre("s"));  // one file, nothing beside it
}

TEST_F(StudyStoreTest, AnotherStudyIsRefusedWithTheDifference) {
  storeWithout("s", {});
  std::string other = kStudy;
  other.replace(other.find("22"), 2, "23");
  const ParameterStudy changed = readStudy(other, "s.json", {});
  EXPECT_THAT(errorFrom([&] { StudyStore(folder / "s", changed, {}); }),
              testing::AllOf(testing::HasSubstr("/s: is the store of another study"),
                             testing::HasSubstr("space.load.normal_force")));
}

TEST_F(StudyStoreTest, AnotherShardIsRefused) {
  storeWithout("s", {}, {2, 3});
  EXPECT_THAT(errorFrom([&] {
                StudyStore(folder / "s", study, {1, 3});
              }),
              testing::HasSubstr("of shard 2/3, not of shard 1/3"));
  EXPECT_THAT(errorFrom([&] { StudyStore(folder / "s", study, {}); }),
              testing::HasSubstr("of shard 2/3, not of the whole study"));
}

TEST_F(StudyStoreTest, ForeignFilesAreNamed) {
  folder.write("text", "not a store at all, but long enough to be one");
  folder.write("empty", "");
  folder.write("picture", "\x89PNG\r\n\x1a\n and so on");
  EXPECT_THAT(errorFrom([&] { StudyStore(folder / "text"); }),
              testing::HasSubstr("is not the store of a study"));
  EXPECT_THAT(errorFrom([&] { StudyStore(folder / "picture"); }), testing::HasSubstr("PNG"));
  EXPECT_THAT(errorFrom([&] { StudyStore(folder / "empty"); }), testing::HasSubstr("is empty"));
  EXPECT_THAT(errorFrom([&] { StudyStore(folder / "nothing"); }),
              testing::HasSubstr("is not there"));
  EXPECT_THAT(errorFrom([&] { StudyStore{folder.path()}; }), testing::HasSubstr("is a folder"));
  EXPECT_THAT(errorFrom([&] { StudyStore(folder / "text", study, {}); }),
              testing::HasSubstr("is not the store of a study"));
  execute(folder / "other.db", "CREATE TABLE t (a)");
  EXPECT_THAT(errorFrom([&] { StudyStore(folder / "other.db"); }),
              testing::HasSubstr("is a database, but not the store of a study"));
  EXPECT_EQ(folder.read(folder / "text"), "not a store at all, but long enough to be one");
}

TEST_F(StudyStoreTest, ANewerSchemaIsRefused) {
  const auto file = storeWithout("s", {});
  execute(file, "PRAGMA user_version=2");
  EXPECT_THAT(errorFrom([&] { StudyStore{file}; }),
              testing::HasSubstr("has schema 2; this program knows 1: a newer one is needed"));
}

TEST_F(StudyStoreTest, AChangedNumberIsFound) {
  const auto file = storeWithout("s", {});
  execute(file, "UPDATE chunks SET numbers = zeroblob(length(numbers)) WHERE number = 3");
  const StudyStore store(file);
  EXPECT_THAT(errorFrom([&] { chunksIn(store); }),
              testing::HasSubstr("is damaged: chunk 3 is not what was written"));
}

TEST_F(StudyStoreTest, ChangedBytesNeverCrash) {
  const auto file = storeWithout("s", {});
  const std::string whole = folder.read(file);
  // Every region of the file: header, tables, texts, numbers.
  for (std::size_t at = 0; at < whole.size(); at += 97) {
    std::string changed = whole;
    changed[at] = static_cast<char>(changed[at] ^ 0x5A);
    std::filesystem::remove(folder / "c");
    folder.write("c", changed);
    try {
      const StudyStore store(folder / "c");
      store.check();
      // Where nothing is found to be wrong, all numbers are right.
      for (const std::int64_t number : chunksIn(store)) EXPECT_LT(number, study.chunks());
      store.eachChunk([&](const StudyChunk& chunk) {
        EXPECT_EQ(chunk.values, chunkOf(study, chunk.number).values);
        return true;
      });
    } catch (const TextError& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("/c: ")) << at;
    }
  }
}

TEST_F(StudyStoreTest, ACutFileIsNamed) {
  const auto file = storeWithout("s", {});
  const std::string whole = folder.read(file);
  for (const std::size_t length : {whole.size() / 2, whole.size() - 4096, std::size_t{100}}) {
    std::filesystem::remove(folder / "c");
    folder.write("c", whole.substr(0, length));
    EXPECT_THAT(errorFrom([&] {
                  const StudyStore store(folder / "c");
                  store.check();
                  chunksIn(store);
                }),
                testing::HasSubstr("damaged"))
        << length;
  }
}

TEST_F(StudyStoreTest, ProcessesTakeDifferentChunks) {
  // Locks belong to an open file, so two stores are as two processes.
  StudyStore one(folder / "s", study, {}), two(folder / "s", study, {});
  EXPECT_EQ(one.claim(0), 0);
  EXPECT_EQ(two.claim(0), 1);
  EXPECT_EQ(one.claim(1), 2);
  one.add(chunkOf(study, 0));
  EXPECT_EQ(two.claim(0), 1);  // its own again
  EXPECT_EQ(two.claim(2), 3);
  { const StudyStore ended = std::move(one); }
  EXPECT_EQ(two.claim(2), 2);  // what the other one had taken is free
}

TEST_F(StudyStoreTest, ShardsInAnyOrderAreTheWholeStudy) {
  std::vector<std::filesystem::path> parts;
  for (std::int64_t i = 1; i <= 4; ++i)
    parts.push_back(storeWithout("p" + std::to_string(i), {}, {i, 4}));
  std::ranges::sort(parts);
  do {
    const auto merged = folder / "merged";
    std::filesystem::remove(merged);
    const MergedStores found = mergeStores(parts, merged);
    EXPECT_TRUE(found.isWhole());
    EXPECT_THAT(chunksIn(StudyStore(merged)), testing::ElementsAre(0, 1, 2, 3, 4, 5));
  } while (std::ranges::next_permutation(parts).found);
  EXPECT_THAT(folder.names(), testing::UnorderedElementsAre("p1", "p2", "p3", "p4", "merged"));
}

TEST_F(StudyStoreTest, MergingNamesWhatIsMissing) {
  const auto one = storeWithout("p1", {}, {1, 3}), three = storeWithout("p3", {5}, {3, 3});
  const MergedStores found = mergeStores({three, one}, folder / "merged");
  EXPECT_FALSE(found.isWhole());
  EXPECT_EQ(found.missingShards, (std::vector<Shard>{{2, 3}}));
  EXPECT_THAT(found.missingChunks, testing::ElementsAre(1, 4, 5));
  // Joined again with the rest, what is there already counts.
  const auto two = storeWithout("p2", {}, {2, 3});
  const auto rest = storeWithout("p3b", {}, {3, 3});
  EXPECT_TRUE(mergeStores({two, rest}, folder / "merged").isWhole());
}

TEST_F(StudyStoreTest, AShardOfAnotherStudyIsRefused) {
  const auto one = storeWithout("p1", {}, {1, 2});
  std::string text = kStudy;
  text.replace(text.find("0.001"), 5, "0.002");
  const ParameterStudy other = readStudy(text, "s.json", {});
  StudyStore(folder / "p2", other, {2, 2}).add(chunkOf(other, 1));
  EXPECT_THAT(errorFrom([&] {
                mergeStores({one, folder / "p2"}, folder / "merged");
              }),
              testing::AllOf(testing::HasSubstr("/p2: is of another study than"),
                             testing::HasSubstr("space.load.normal_force.0")));
  EXPECT_THAT(folder.names(), testing::Not(testing::Contains("merged")));
}

TEST_F(StudyStoreTest, DifferentResultsOfOneChunkAreRefused) {
  const auto one = storeWithout("a", {});
  StudyStore two(folder / "b", study, {});
  StudyChunk chunk = chunkOf(study, 2);
  chunk.values[0] += 1;
  two.add(chunk);
  EXPECT_THAT(errorFrom([&] {
                mergeStores({one, folder / "b"}, folder / "merged");
              }),
              testing::HasSubstr("/b: has other results of chunk 2"));
}

TEST(Shard, IsReadAndRefused) {
  EXPECT_EQ(parseShard("3/8"), (Shard{3, 8}));
  for (const char* text : {"", "3", "0/8", "9/8", "3/0", "-1/8", "3/8/9", "a/b", "3/2000000"})
    EXPECT_THROW(parseShard(text), InputError) << text;
  // Every chunk belongs to one shard.
  for (std::int64_t chunk = 0; chunk < 20; ++chunk) {
    int owners = 0;
    for (std::int64_t i = 1; i <= 7; ++i) owners += (Shard{i, 7}.has(chunk)) ? 1 : 0;
    EXPECT_EQ(owners, 1);
  }
}

/// The last chunk is a short one.
TEST(Shard, CountsItsSimulations) {
  const ParameterStudy study = smallStudy();
  ASSERT_NE(study.simulations() % study.chunk, 0);
  EXPECT_EQ(Shard().simulations(study), study.simulations());
  for (const std::int64_t count : {2, 3, 5, 7}) {
    std::int64_t all = 0;
    for (std::int64_t number = 1; number <= count; ++number) {
      std::int64_t own = 0;
      for (std::int64_t chunk = 0; chunk < study.chunks(); ++chunk)
        if (Shard{number, count}.has(chunk)) own += study.sizeOfChunk(chunk);
      EXPECT_EQ((Shard{number, count}.simulations(study)), own) << number << '/' << count;
      all += own;
    }
    EXPECT_EQ(all, study.simulations());
  }
}

}  // namespace
}  // namespace asperity
