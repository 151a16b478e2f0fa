// The table of a study: one row for each simulation, or (long) one for each number. Rows are made
// and handed over one chunk after the other, so that memory does not grow with the study. The same
// results give the same bytes, whatever processes and shards made them.
// Pure but for reading the store. Failure: as StudyStore::eachChunk.
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string_view>

#include "core/study/study_store.h"

namespace asperity {

enum class TableShape { Wide, Long };
enum class TableFormat { Csv, Json };

/// Calls `write` with the bytes of the table in order. Returns the number of simulations in it.
std::int64_t writeStudyTable(const StudyStore& store, TableShape shape, TableFormat format,
                             const std::function<void(std::string_view bytes)>& write);

/// What a table and other results of a study say of their origin: the provenance of the base scene
/// with the keys, the sampling, the outputs and the SHA-256 of the study, and how many of its
/// simulations the store has (and which, where some are missing).
nlohmann::ordered_json studyProvenance(const StudyStore& store);

/// The names of the numbers of a simulation in a wide table: "mu", and for a curve "mu_1" and on.
std::vector<std::string> numberNames(const ParameterStudy& study);

}  // namespace asperity
