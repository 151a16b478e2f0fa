// Reads measured profiles and topographies of every kind: text in many forms, X3P (ISO 25178-72),
// SDF (ISO 25178-71), SMD and PRF (ISO 5436-2), SUR and PRO (Digital Surf), GSF and GWY (Gwyddion),
// files of Zygo, text files of Wyko, grids of Surfer, arrays of NumPy, and whatever else an
// installed Gwyddion can read. The kind is recognized from the content of a file, never from its
// name.
//
// The facts list what the reader found out by itself (kind, columns, units); a choice overrides
// each of these guesses.
// Threading: pure functions; any thread.
// Failure: InputError in one line that names the file and the line, byte, column or key
// (`surface.*`) that is wrong, and what was expected; StopRequested (core/base/stop.h) where `stop`
// was requested.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"
#include "core/measured/topography.h"

namespace asperity {

/// Returns the words of `surface.format`. `text` is any of the three text forms: `profile` is one
/// or more columns with one row for each point; `matrix` is one row of heights for each profile;
/// `points` is x, y and z of one point in each row, in any order. `gwyddion` is a file that only
/// Gwyddion reads.
std::span<const std::string_view> surfaceFormats();

/// Returns the usual endings of the names of surface files: "csv", "x3p".
std::vector<std::string_view> surfaceFileEndings();

/// The words of `surface.position_unit` and `surface.height_unit`.
inline constexpr std::array<std::string_view, 7> kSurfaceUnits{"auto", "m",  "mm", "um",
                                                               "nm",   "in", "mil"};

/// What a user states about a file. The defaults leave everything to the reader.
struct ReadingChoices {
  std::string format = "auto";        // one of surfaceFormats()
  std::string positionUnit = "auto";  // one of kSurfaceUnits; replaces what the file states
  std::string heightUnit = "auto";    // likewise
  int positionColumn = 0;             // of a text profile or of points, counted from 1; 0: found
  int heightColumn = 0;  // likewise; in a GWY file the channel, in the order of the file; 0: found
  double spacing = 0;    // m, between points where the file does not say; 0: one position unit

  bool operator==(const ReadingChoices&) const = default;
};

/// Where the unit of a number comes from.
enum class UnitSource {
  File,     // stated by the file
  Choice,   // chosen by the user
  Assumed,  // stated by neither: metres
};

struct UnitFact {
  std::string unit{};  // as the file or the user writes it: "\u00B5m"
  double metres = 1;   // length of one unit
  UnitSource source = UnitSource::Assumed;

  bool operator==(const UnitFact&) const = default;
};

/// How the reader understood a file.
struct ReadingFacts {
  std::string format{};          // one of surfaceFormats(), never "auto" or "text"
  std::string positionColumn{};  // the column's name or "column 1"; empty: no positions by column
  std::string heightColumn{};    // the column's or channel's name; empty where there is only one
  UnitFact positionUnit{}, heightUnit{};
  std::int64_t points = 0;      // columns times rows
  std::int64_t gaps = 0;        // of these, without a height
  double spacingVariation = 0;  // largest deviation of a step between positions, over the mean step
  bool resampled = false;       // positions were not uniform: heights are interpolated linearly
  std::vector<Message> notes{};  // plain sentences, the most important ones first

  bool operator==(const ReadingFacts&) const = default;
};

struct MeasuredFile {
  Topography topography{};
  ReadingFacts facts{};
};

/// Called now and then, from the calling thread, with the finished part of the work, 0 to 1.
using ReadingProgress = std::function<void(double)>;

/// Reads a file of any kind. The result has at least 3 points along x, and at least one of its
/// points has a height. Heights are finite or NaN (a gap); spacings are finite and above 0.
MeasuredFile readMeasuredFile(const std::filesystem::path& file, const ReadingChoices& choices = {},
                              const std::stop_token& stop = {},
                              const ReadingProgress& progress = {});

/// Reads the bytes of a file of any kind that needs no other program; `name` is the file's name in
/// errors.
MeasuredFile readMeasuredBytes(std::string_view bytes, const std::string& name,
                               const ReadingChoices& choices = {}, const std::stop_token& stop = {},
                               const ReadingProgress& progress = {});

/// Returns whether a regular file can be a measured surface; a file that begins with a brace holds
/// a scene.
bool isSurfaceFile(const std::filesystem::path& file);

}  // namespace asperity
