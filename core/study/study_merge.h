// Merges the stores of shards into one store of the whole study, in any order.
// Failure: as StudyStore; InputError where the stores do not belong together.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/study/study_store.h"

namespace asperity {

/// The result of a merge.
struct MergedStores {
  std::int64_t chunks = 0, chunksWanted = 0;
  std::vector<Shard> missingShards;         // those without a store, where the stores are shards
  std::vector<std::int64_t> missingChunks;  // the first ones

  bool isWhole() const { return chunks == chunksWanted; }
};

/// Merges stores of one study in any order, together with a store that exists at `output`. Throws
/// InputError where one of them belongs to another study, or two have different results of a chunk.
MergedStores mergeStores(const std::vector<std::filesystem::path>& inputs,
                         const std::filesystem::path& output);

}  // namespace asperity
