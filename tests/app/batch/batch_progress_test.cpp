// What a batch keeps of a finished scene, for the same command after an interruption.
#include "app/batch/batch_progress.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <new>

#include "tests/core/temporary_folder.h"

namespace asperity {
namespace {

/// A point in memory of which each byte was this one before, also those between the members.
CurvePoint pointOver(unsigned char byte) {
  alignas(CurvePoint) unsigned char memory[sizeof(CurvePoint)];
  std::memset(memory, byte, sizeof memory);
  auto* point = new (memory) CurvePoint{.velocity = 0.1, .mu = 1 / 3.0, .realizations = 7};
  point->listsContacts = true;
  point->contactPressure = 1e-300;
  point->notes.add(Note::FewContacts);
  CurvePoint copy;
  std::memcpy(static_cast<void*>(&copy), memory, sizeof memory);
  return copy;
}

BatchProgressEntry entryOf(const CurvePoint& point) {
  BatchProgressEntry entry;
  entry.result.mean = point;
  entry.result.lineMu = 0.1;
  entry.result.files = {"a.png"};
  entry.curve = {point, point};
  return entry;
}

TEST(BatchProgress, EveryNumberComesBackExactly) {
  const TemporaryFolder folder;
  folder.write("a.png", "");
  const CurvePoint kept = pointOver(0);
  BatchProgress(folder.path()).add("key", entryOf(kept));
  const BatchProgress read(folder.path());
  const BatchProgressEntry* entry = read.find("key");
  ASSERT_TRUE(entry);
  ASSERT_EQ(entry->curve.size(), 2U);
  for (const CurvePoint& point : {entry->curve[1], *entry->result.mean}) {
    EXPECT_EQ(point.velocity, kept.velocity);
    EXPECT_EQ(point.mu, kept.mu);
    EXPECT_EQ(point.contactPressure, kept.contactPressure);
    EXPECT_TRUE(std::isnan(point.muLaw));
    EXPECT_EQ(point.realizations, 7);
    EXPECT_TRUE(point.listsContacts);
    EXPECT_TRUE(point.notes == kept.notes);
  }
  EXPECT_EQ(entry->result.lineMu, 0.1);
  EXPECT_TRUE(std::isnan(entry->result.lineIndentation));
}

/// The memory between the members of a point is not a part of it.
TEST(BatchProgress, TheSameResultHasTheSameBytes) {
  const TemporaryFolder one, other;
  BatchProgress(one.path()).add("key", entryOf(pointOver(0)));
  BatchProgress(other.path()).add("key", entryOf(pointOver(0xff)));
  EXPECT_EQ(TemporaryFolder::read(one.path() / ".asperity_batch_progress"),
            TemporaryFolder::read(other.path() / ".asperity_batch_progress"));
}

}  // namespace
}  // namespace asperity
