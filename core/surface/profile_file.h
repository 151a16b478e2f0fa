// Measured profiles: CSV of position and height with a header, or heights alone, in metres. Pure;
// any thread. Bad files throw InputError naming the file and the row.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

namespace asperity {

struct Profile {
  double length = 0;           // m, rows times spacing; 0 where the file has heights alone
  std::vector<double> height;  // m, equally spaced
};

/// At least 3 rows, numbers finite, spacing uniform to 1e-6 of itself. `name` stands in errors.
Profile parseProfile(std::string_view text, const std::string& name);

Profile readProfile(const std::filesystem::path& file);

/// How many rows a file of its size may have, without reading it; 0 where there is none.
std::int64_t expectedRows(const std::filesystem::path& file);

}  // namespace asperity
