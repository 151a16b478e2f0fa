#include "core/study/study_merge.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <set>

#include "core/base/atomic_file.h"
#include "core/base/input_error.h"

namespace asperity {

namespace fs = std::filesystem;

MergedStores mergeStores(const std::vector<fs::path>& inputs, const fs::path& output) {
  checkWritable(output);
  std::vector<StudyStore> stores;
  std::error_code ignored;
  for (const fs::path& input : inputs) {
    if (fs::equivalent(input, output, ignored)) continue;  // the output is read in any case
    stores.emplace_back(input);
  }
  if (fs::exists(output, ignored)) stores.emplace_back(output);
  if (stores.empty()) throw InputError("", "", "there is no store to merge");
  const StudyStore& first = stores.front();
  for (const StudyStore& store : stores)
    if (store.study().digest != first.study().digest)
      throw InputError(
          store.file().string(), "",
          message("is of another study than {}: {}", first.file().string(),
                  describeDifference(first.study().canonical, store.study().canonical)));

  fs::path part = output;
  part += fmt::format(".{}.part", ::getpid());
  const auto removePart = [&] {
    for (const char* end : {"", "-wal", "-shm", "-journal"}) {
      fs::path file = part;
      file += end;
      fs::remove(file, ignored);
    }
  };
  removePart();
  MergedStores merged;
  try {
    StudyStore joined(part, first.study(), {});
    constexpr std::size_t kTogether = 64;
    for (const StudyStore& store : stores) {
      std::vector<StudyChunk> chunks;
      store.eachChunk([&](const StudyChunk& chunk) {
        chunks.push_back(chunk);
        if (chunks.size() == kTogether) {
          joined.addEqual(chunks, store.file());
          chunks.clear();
        }
        return true;
      });
      joined.addEqual(chunks, store.file());
    }
    merged.chunks = joined.chunksDone();
    merged.chunksWanted = joined.chunksWanted();
    merged.missingChunks = joined.missing(8);
    joined.finish();
  } catch (...) {
    removePart();
    throw;
  }
  std::int64_t count = 1;
  std::set<std::int64_t> known;
  for (const StudyStore& store : stores) count = std::max(count, store.shard().count);
  for (const StudyStore& store : stores)
    if (store.shard().count == count) known.insert(store.shard().number);
  if (!merged.isWhole() && count > 1)
    for (std::int64_t i = 1; i <= count && merged.missingShards.size() < 16; ++i)
      if (!known.contains(i)) merged.missingShards.push_back({i, count});
  stores.clear();
  fs::rename(part, output);
  return merged;
}

}  // namespace asperity
