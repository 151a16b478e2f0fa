// What the reader of one format makes of a file, before units are applied: shared by the readers of
// this folder and by nobody else.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

#include "core/base/input_error.h"
#include "core/base/stop.h"
#include "core/measured/measured_file.h"
#include "core/measured/topography.h"

namespace asperity {

/// The bytes of a file, what the user says about it, and who waits for it.
struct SurfaceSource {
  std::string_view bytes;
  const std::string& name;  // in errors
  const ReadingChoices& choices;
  const std::stop_token& stop;
  const ReadingProgress& progress;

  [[noreturn]] void fail(const Message& message) const { throw InputError(name, "", message); }
  /// Reports the part of the work that is done, 0 to 1. Throws StopRequested.
  void report(double part) const {
    throwIfStopped(stop);
    if (progress) progress(part);
  }
  /// The same, now and then, where `done` counts all points one by one.
  void reportPoint(std::size_t done, std::size_t all) const {
    constexpr std::size_t kStep = std::size_t{1} << 18;
    if (done % kStep == 0) report(static_cast<double>(done) / static_cast<double>(all));
  }
};

struct StatedUnit {
  std::string text{};  // as the file writes it
  double metres = 1;
};

struct SurfaceDraft {
  Topography grid{};  // both spacings in the position unit, heights in the height unit
  std::optional<StatedUnit> positionUnit{}, heightUnit{};  // empty: the file states none
  bool hasPositions = true;  // false: nothing in the file says how far its points are apart
  // A unit that the file writes and nobody knows; empty where it states none or a known one.
  std::string unknownPositionUnit{}, unknownHeightUnit{};
  ReadingFacts facts{};  // format, columns and notes; the rest is filled in later
};

/// Points that are read at most: 512 MiB of heights.
inline constexpr std::int64_t kMostPoints = std::int64_t{1} << 26;

/// Returns the number where it is whole and no count of points is larger; else nothing.
std::optional<std::int64_t> wholeNumber(double number);

/// Refuses sizes that no file of this many bytes can hold, or that are too large to read.
/// `bytesPerPoint` 0: not known.
void requireSize(const SurfaceSource& source, std::int64_t columns, std::int64_t rows,
                 std::size_t bytesThere, std::size_t bytesPerPoint);

/// A unit that a file states by name; throws where it is no length. Empty for an empty name.
std::optional<StatedUnit> statedUnit(const SurfaceSource& source, std::string_view axis,
                                     std::string_view unit);

/// "OpenCRG" or "ERD" where the bytes begin as files of roads do, which are not read; else empty.
std::string_view detectRoadFormat(std::string_view bytes);

SurfaceDraft readTextSurface(const SurfaceSource& source);
SurfaceDraft readX3p(const SurfaceSource& source);
SurfaceDraft readSdf(const SurfaceSource& source);
SurfaceDraft readSmd(const SurfaceSource& source);
SurfaceDraft readSur(const SurfaceSource& source);
SurfaceDraft readSurfer(const SurfaceSource& source);
SurfaceDraft readWyko(const SurfaceSource& source);
SurfaceDraft readZygo(const SurfaceSource& source);
SurfaceDraft readGsf(const SurfaceSource& source);
/// masksAreGaps: points that are masked were not measured, as where Gwyddion reads other formats.
SurfaceDraft readGwy(const SurfaceSource& source, bool masksAreGaps);

// Whether the beginning of a file says that it is of this kind, where that takes more than a word.
bool isSdf(const SurfaceSource& source);
bool isSmd(const SurfaceSource& source);
bool isSurfer(const SurfaceSource& source);
bool isWyko(const SurfaceSource& source);
bool isZygo(const SurfaceSource& source);

/// The file as a GWY file that Gwyddion makes of it. Throws InputError where it is not installed or
/// does not know the file either.
std::string convertWithGwyddion(const std::filesystem::path& file, const std::stop_token& stop);

}  // namespace asperity
