// The axes of a study's space in its file: lists, ranges, distributions and tables of rows.
// Pure but for reading a table. Failure: InputError with the place, or the file and line of a
// table.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/study/study_space.h"

namespace asperity {

/// Reads what a key is varied over.
StudyAxis readAxis(const std::string& key, const nlohmann::ordered_json& spec, bool isGrid);

/// Reads the rows of a table, whose columns are named by keys; in a canonical text they stand in
/// it.
StudyAxis readRows(const nlohmann::ordered_json& spec, const std::string& where,
                   const std::filesystem::path& folder);

/// Return the canonical forms of both.
nlohmann::ordered_json axisJson(const StudyAxis& axis);
nlohmann::ordered_json rowsJson(const StudyAxis& axis);

}  // namespace asperity
