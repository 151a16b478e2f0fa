// Reads the axes of a study's space from its file: lists, ranges, distributions and tables of rows.
// Pure except for reading a table. Failure: InputError with the path, or with the file and line of
// a table.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/study/study_space.h"

namespace asperity {

/// Reads the values over which a key is varied.
StudyAxis readAxis(const std::string& key, const nlohmann::ordered_json& spec, bool isGrid);

/// Reads the rows of a table whose columns have the names of keys. In a canonical text the rows
/// themselves are part of the text.
StudyAxis readRows(const nlohmann::ordered_json& spec, const std::string& where,
                   const std::filesystem::path& folder);

/// Return the canonical form of an axis and of rows.
nlohmann::ordered_json axisJson(const StudyAxis& axis);
nlohmann::ordered_json rowsJson(const StudyAxis& axis);

}  // namespace asperity
