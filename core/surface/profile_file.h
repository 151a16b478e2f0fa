// Reads measured profiles: CSV of position and height with a header, or heights alone, in metres.
// Pure; any thread. Failure: InputError that names the file and the row.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

struct Profile {
  double length = 0;           // m, rows times spacing; 0 where the file has heights alone
  std::vector<double> height;  // m, equally spaced
};

/// Reads a profile of at least 3 rows with finite numbers and a spacing that is uniform to 1e-6 of
/// itself. name: of the file, in errors.
Profile parseProfile(std::string_view text, const std::string& name);

Profile readProfile(const std::filesystem::path& file);

/// The size of a profile, estimated from some parts of its file.
struct ProfileExtent {
  std::int64_t rows = 0;  // exact where the file has uniform positions, else to a few per cent
  double length = 0;      // m; 0 where the file has heights alone
  double rmsHeight = 0;   // m, to some per cent
};

/// Estimates the size from the beginning, the end and a few parts in between of a large file, and
/// from all of a file that is small or whose parts do not fit together. Only readProfile finds
/// errors in the middle of a large file.
ProfileExtent profileExtent(const std::filesystem::path& file);

/// Returns the first `rows` rows (at least 3) of a file as a profile.
Profile readProfileStart(const std::filesystem::path& file, std::int64_t rows);

}  // namespace asperity
