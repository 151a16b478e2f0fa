// Stores of shards joined into one store of the whole study, in any order.
// Failure: as StudyStore; InputError where the stores do not belong together.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/study/study_store.h"

namespace asperity {

/// What a merge found.
struct MergedStores {
  std::int64_t chunks = 0, chunksWanted = 0;
  std::vector<Shard> missingShards;         // that none of the stores is of, where they are shards
  std::vector<std::int64_t> missingChunks;  // the first of them

  bool isWhole() const { return chunks == chunksWanted; }
};

/// Joins stores of one study in any order; a store that is at `output` already counts too. Throws
/// InputError where one of them is of another study, or two have different results of a chunk.
MergedStores mergeStores(const std::vector<std::filesystem::path>& inputs,
                         const std::filesystem::path& output);

}  // namespace asperity
