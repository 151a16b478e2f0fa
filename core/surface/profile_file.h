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

/// The size of a profile, told from some places of its file.
struct ProfileExtent {
  std::int64_t rows = 0;  // exact where the file has uniform positions, else to a few per cent
  double length = 0;      // m; 0 where the file has heights alone
  double rmsHeight = 0;   // m, to some per cent
};

/// Reads the beginning, the end and a few places between of a large file, and the whole of a small
/// one or of one whose parts do not fit together. A fault in the middle of a large file is left to
/// readProfile.
ProfileExtent profileExtent(const std::filesystem::path& file);

/// The first `rows` rows (at least 3) of a file, as a profile.
Profile readProfileStart(const std::filesystem::path& file, std::int64_t rows);

}  // namespace asperity
