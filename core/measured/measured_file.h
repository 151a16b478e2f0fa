// Reads measured profiles and topographies of every kind: text in many forms, X3P (ISO 25178-72),
// SDF (ISO 25178-71), SMD and PRF (ISO 5436-2), SUR and PRO (Digital Surf), GSF and GWY (Gwyddion),
// files of Zygo, text files of Wyko, grids of Surfer, and what else an installed Gwyddion can read.
// The kind is told from the content of a file, never from its name.
//
// Whatever the reader finds out by itself (kind, columns, units) stands in the facts, and each of
// these guesses can be overridden by a choice.
// Threading: pure functions; any thread.
// Failure: InputError that names the file and the line, byte, column or key (`surface.*`) that is
// wrong, what was expected, in one line; StopRequested where `stop` was requested.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"
#include "core/measured/topography.h"

namespace asperity {

/// The names of `surface.format`. `text` is any of the three text forms; `profile` is one or more
/// columns, a row for each point; `matrix` a row of heights for each profile; `points` x, y and z
/// of one point in each row, in any order. `gwyddion` is a file that only Gwyddion reads.
inline constexpr std::array<std::string_view, 15> kSurfaceFormats{
    "auto", "text", "profile", "matrix", "points", "x3p",    "sdf",     "smd",
    "sur",  "gsf",  "gwy",     "zygo",   "wyko",   "surfer", "gwyddion"};

/// The names of `surface.position_unit` and `surface.height_unit`.
inline constexpr std::array<std::string_view, 6> kSurfaceUnits{"auto", "m", "mm", "um", "nm", "in"};

/// What a user may say about a file. The defaults leave everything to the reader.
struct ReadingChoices {
  std::string format = "auto";        // one of kSurfaceFormats
  std::string positionUnit = "auto";  // one of kSurfaceUnits; replaces what the file states
  std::string heightUnit = "auto";    // likewise
  int positionColumn = 0;             // of a text profile or of points, counted from 1; 0: found
  int heightColumn = 0;  // likewise; in a GWY file the channel, in the order of the file; 0: found
  double spacing = 0;    // m, between points where the file does not say; 0: one position unit

  bool operator==(const ReadingChoices&) const = default;
};

/// Who says what a number means.
enum class UnitSource {
  File,     // the file states it
  Choice,   // the user does
  Assumed,  // nobody does: metres
};

struct UnitFact {
  std::string unit{};  // as the file or the user writes it: "\u00B5m"
  double metres = 1;   // so many metres are one unit
  UnitSource source = UnitSource::Assumed;

  bool operator==(const UnitFact&) const = default;
};

/// What the reader took a file for.
struct ReadingFacts {
  std::string format{};          // one of kSurfaceFormats, never "auto" or "text"
  std::string positionColumn{};  // the column's name or "column 1"; empty: no positions by column
  std::string heightColumn{};    // the column's or channel's name; empty where there is only one
  UnitFact positionUnit{}, heightUnit{};
  std::int64_t points = 0;      // columns times rows
  std::int64_t gaps = 0;        // of these, without a height
  double spacingVariation = 0;  // largest deviation of a step between positions, over the mean step
  bool resampled = false;       // positions were not uniform: heights are interpolated linearly
  std::vector<Message> notes{};        // plain sentences in the order in which a person wants them
  std::vector<Message> assumptions{};  // of these, what the numbers rest on and nobody states

  bool operator==(const ReadingFacts&) const = default;
};

struct MeasuredFile {
  Topography topography{};
  ReadingFacts facts{};
};

/// Told the part of the work that is done, 0 to 1, now and then, from the calling thread.
using ReadingProgress = std::function<void(double)>;

/// Reads a file of any kind. At least 3 points along x, of which one at least has a height; heights
/// are finite or NaN (a gap), spacings finite and above 0.
MeasuredFile readMeasuredFile(const std::filesystem::path& file, const ReadingChoices& choices = {},
                              const std::stop_token& stop = {},
                              const ReadingProgress& progress = {});

/// The same of the bytes of a file, for every kind that needs no other program; `name` stands in
/// errors.
MeasuredFile readMeasuredBytes(std::string_view bytes, const std::string& name,
                               const ReadingChoices& choices = {}, const std::stop_token& stop = {},
                               const ReadingProgress& progress = {});

/// Whether a regular file can be a measured surface: those that begin with a brace hold a scene.
bool isSurfaceFile(const std::filesystem::path& file);

}  // namespace asperity
