// The result of the reader of one format before its units are applied. Only the readers of this
// folder use it.
#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

#include "core/base/input_error.h"
#include "core/base/statistics.h"
#include "core/base/stop.h"
#include "core/base/text_table.h"
#include "core/measured/measured_file.h"
#include "core/measured/topography.h"

namespace asperity {

/// The bytes of a file, the user's choices for it, and the callbacks of the caller.
struct SurfaceSource {
  std::string_view bytes;
  const std::string& name;  // in errors
  const ReadingChoices& choices;
  const std::stop_token& stop;
  const ReadingProgress& progress;

  [[noreturn]] void fail(const Message& message) const { throw InputError(name, "", message); }
  [[noreturn]] void failWithout(std::string_view key) const {
    fail(message("the header has no {}", key));
  }
  [[noreturn]] void failNotAboveZero(std::string_view key) const {
    fail(message("{} in the header is not a number above 0", key));
  }
  /// Reports the part of the work that is done, 0 to 1. Throws StopRequested.
  void report(double part) const {
    throwIfStopped(stop);
    if (progress) progress(part);
  }
  /// Reports now and then, where `done` counts all points one by one.
  void reportPoint(std::size_t done, std::size_t all) const {
    constexpr std::size_t kStep = std::size_t{1} << 18;
    if (done % kStep == 0) report(static_cast<double>(done) / static_cast<double>(all));
  }
};

/// A block of the table of a text file, with the user's choices for the file.
struct SurfaceText : TextPart {
  const SurfaceSource& source;
};

struct StatedUnit {
  std::string text{};  // as the file writes it
  double metres = 1;
};

struct SurfaceDraft {
  Topography grid{};  // both spacings in the position unit, heights in the height unit
  std::optional<StatedUnit> positionUnit{}, heightUnit{};  // empty: the file states none
  bool hasPositions = true;      // false: the file does not state how far its points are apart
  bool isSpacingChosen = false;  // the choices state it instead
  // A unit in the file that is not known; empty where the file states none or a known one.
  std::string unknownPositionUnit{}, unknownHeightUnit{};
  ReadingFacts facts{};  // format, columns and notes; the rest is filled in later
};

/// The numbers by which a file marks points that were not measured; one that is not finite is a gap
/// in any case.
struct HeightGaps {
  double equal = kNaN;                                    // this number
  double from = std::numeric_limits<double>::infinity();  // this number and those above it

  bool contain(double number) const {
    return !std::isfinite(number) || number == equal || number >= from;
  }
};

/// The units that the keys of units may name, for people.
inline constexpr std::string_view kUnitsOfKeys = "m, mm, \u00B5m, nm, in, mil";

/// The maximum number of points that are read: 512 MiB of heights.
inline constexpr std::int64_t kMaxPoints = std::int64_t{1} << 26;

/// Returns the number where it is whole and not larger than a possible number of points; else
/// nothing.
std::optional<std::int64_t> wholeNumber(double number);

/// Throws InputError for a size that no file of this many bytes can hold, or that is too large to
/// read. bytesPerPoint: 0 where it is not known.
void requireSize(const SurfaceSource& source, std::int64_t columns, std::int64_t rows,
                 std::size_t bytesThere, std::size_t bytesPerPoint);

/// Returns the unit that a file states by name; throws InputError where it is no unit of length.
/// Empty for an empty name.
std::optional<StatedUnit> statedUnit(const SurfaceSource& source, std::string_view axis,
                                     std::string_view unit);

/// Returns "OpenCRG" or "ERD" where the bytes begin as a file of a road does, a kind that is not
/// read; else empty.
std::string_view detectRoadFormat(std::string_view bytes);

inline constexpr std::size_t kBeginning = 4096;  // bytes, in which the format shows itself

/// Throws InputError that says what the file is, where it is none of the formats.
[[noreturn]] void refuseKind(const SurfaceSource& source);

/// Returns the names of the formats that are read besides text: "X3P, SUR, PRO, ...".
std::string readableFormats();

SurfaceDraft readTextSurface(const SurfaceSource& source);
SurfaceDraft readGsf(const SurfaceSource& source);
SurfaceDraft readGwy(const SurfaceSource& source);
SurfaceDraft readNpy(const SurfaceSource& source);
SurfaceDraft readSdf(const SurfaceSource& source);
SurfaceDraft readSmd(const SurfaceSource& source);
SurfaceDraft readSur(const SurfaceSource& source);
SurfaceDraft readSurfer(const SurfaceSource& source);
SurfaceDraft readWyko(const SurfaceSource& source);
SurfaceDraft readX3p(const SurfaceSource& source);
SurfaceDraft readZygo(const SurfaceSource& source);

// Return whether a file has this format, by its beginning.
bool isGsf(const SurfaceSource& source);
bool isGwy(const SurfaceSource& source);
bool isNpy(const SurfaceSource& source);
bool isSdf(const SurfaceSource& source);
bool isSmd(const SurfaceSource& source);
bool isSur(const SurfaceSource& source);
bool isSurfer(const SurfaceSource& source);
bool isWyko(const SurfaceSource& source);
bool isX3p(const SurfaceSource& source);
bool isZygo(const SurfaceSource& source);

/// Reads the GWY file that Gwyddion makes of another format: masked points were not measured.
SurfaceDraft readConvertedGwy(const SurfaceSource& source);

/// Returns the content of a GWY file that Gwyddion makes of the file. Throws InputError where
/// Gwyddion is not installed or does not know the file either.
std::string convertWithGwyddion(const std::filesystem::path& file, const std::stop_token& stop);

}  // namespace asperity
