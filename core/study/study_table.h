// The table of a study: one row for each simulation, or (long) one for each number. Rows are made
// and passed on chunk by chunk, so memory does not grow with the study. Equal results give equal
// bytes, whatever processes and shards computed them.
// Pure except for reading the store. Failure: as StudyStore::eachChunk.
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string_view>

#include "core/study/study_store.h"

namespace asperity {

enum class TableShape { Wide, Long };
enum class TableFormat { Csv, Json };

/// Calls `write` with the bytes of the table in order. Returns the number of its simulations.
std::int64_t writeStudyTable(const StudyStore& store, TableShape shape, TableFormat format,
                             const std::function<void(std::string_view bytes)>& write);

/// Returns the provenance of tables and other results of a study: that of the base scene with the
/// keys, the sampling, the outputs and the SHA-256 of the study, and the number of stored
/// simulations (and which ones, where some are missing).
nlohmann::ordered_json studyProvenance(const StudyStore& store);

}  // namespace asperity
