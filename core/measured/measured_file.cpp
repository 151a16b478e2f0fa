#include "core/measured/measured_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/input_error.h"
#include "core/base/json_text.h"
#include "core/base/regular_file.h"
#include "core/base/stop.h"
#include "core/base/text.h"
#include "core/base/text_encoding.h"
#include "core/base/text_units.h"
#include "core/measured/processing.h"
#include "core/measured/reading_notes.h"
#include "core/measured/surface_draft.h"

namespace asperity {
namespace {

constexpr std::size_t kLargestFile = std::size_t{1} << 31;  // bytes
constexpr double kFarthest = 1e6;                           // m, limit of lengths and heights
// Numbers without a unit that exceed these limits are hardly metres.
constexpr double kLongestAssumed = 1;    // m
constexpr double kSteepestAssumed = 10;  // rms slope

constexpr std::string_view kKnownUnits = "m, cm, mm, \u00B5m, nm, pm, \u00C5, in, mil, \u00B5in";

// ---- Formats -----------------------------------------------------------------------------------

/// A format of surface files. A new one needs a source NAME_file.cpp, its functions in
/// surface_draft.h, and a row here.
struct SurfaceFormat {
  std::string_view word;                    // of `surface.format`
  std::string_view names;                   // for people
  std::array<std::string_view, 2> endings;  // of file names; may be empty
  bool (*detect)(const SurfaceSource& source);
  SurfaceDraft (*read)(const SurfaceSource& source);
};

/// All formats but text, in the order in which they are tried.
constexpr std::array kFormats{SurfaceFormat{"x3p", "X3P", {"x3p"}, isX3p, readX3p},
                              SurfaceFormat{"sur", "SUR, PRO", {"sur", "pro"}, isSur, readSur},
                              SurfaceFormat{"gsf", "GSF", {"gsf"}, isGsf, readGsf},
                              SurfaceFormat{"gwy", "GWY", {"gwy"}, isGwy, readGwy},
                              SurfaceFormat{"npy", "NPY", {"npy"}, isNpy, readNpy},
                              SurfaceFormat{"zygo", "Zygo", {}, isZygo, readZygo},
                              SurfaceFormat{"wyko", "Wyko (text)", {"asc"}, isWyko, readWyko},
                              SurfaceFormat{"surfer", "Surfer", {"grd"}, isSurfer, readSurfer},
                              SurfaceFormat{"sdf", "SDF", {"sdf"}, isSdf, readSdf},
                              SurfaceFormat{"smd", "SMD, PRF", {"smd", "prf"}, isSmd, readSmd}};

constexpr std::array<std::string_view, 5> kTextWords{"auto", "text", "profile", "matrix", "points"};
constexpr std::array<std::string_view, 4> kTextEndings{"csv", "txt", "dat", "xyz"};

/// The words of `surface.format`: those of text, of each format, and of Gwyddion.
constexpr auto kWords = [] {
  std::array<std::string_view, kTextWords.size() + kFormats.size() + 1> words;
  auto* const rest = std::ranges::copy(kTextWords, words.begin()).out;
  *std::ranges::transform(kFormats, rest, &SurfaceFormat::word).out = "gwyddion";
  return words;
}();

/// Returns the format of the file by its beginning; null where it is none of them.
const SurfaceFormat* detectFormat(const SurfaceSource& source) {
  const auto* const format =
      std::ranges::find_if(kFormats, [&](const SurfaceFormat& row) { return row.detect(source); });
  return format != kFormats.end() ? format : nullptr;
}

/// Returns whether the file can be text. The reader of text refuses files of roads by name.
bool canBeText(const SurfaceSource& source) {
  if (!detectRoadFormat(source.bytes).empty()) return true;
  const std::string_view foreign = detectNonText(source.bytes);
  return foreign.empty() || foreign == "text in UTF-16";
}

/// Returns whether numbers as bytes follow a header of text, as in files of NanoScope. Zeros and
/// ends of file alone only fill up a text.
bool holdsBinary(const SurfaceSource& source) {
  constexpr std::size_t kLookedAt = std::size_t{1} << 20, kOneIn = 100;
  const std::size_t zero = source.bytes.find('\0');
  if (zero == std::string_view::npos || detectNonText(source.bytes) == "text in UTF-16")
    return false;
  const std::string_view rest = source.bytes.substr(zero, kLookedAt);
  const auto controls = std::ranges::count_if(
      rest, [](char letter) { return (letter > 0 && letter < '\t') || letter == '\x7F'; });
  return static_cast<std::size_t>(controls) > rest.size() / kOneIn;
}

/// Returns whether one of the readers reads the file; Gwyddion may read the others.
bool isReadable(const SurfaceSource& source) {
  return source.choices.format != "auto" || detectFormat(source) != nullptr ||
         (canBeText(source) && !holdsBinary(source));
}

SurfaceDraft readDraft(const SurfaceSource& source) {
  const std::string& word = source.choices.format;
  const SurfaceFormat* format = nullptr;
  if (word != "auto") {
    const auto* const chosen = std::ranges::find(kFormats, word, &SurfaceFormat::word);
    if (chosen != kFormats.end()) format = chosen;
  } else {
    format = detectFormat(source);
  }
  if (format == nullptr) return readTextSurface(source);
  SurfaceDraft draft = format->read(source);
  draft.facts.format = format->word;
  return draft;
}

// ---- Units -------------------------------------------------------------------------------------

UnitFact unitFact(const std::string& choice, const std::optional<StatedUnit>& stated) {
  if (choice != "auto") return {choice, *metresPer(choice), UnitSource::Choice};
  if (stated) return {stated->text, stated->metres, UnitSource::File};
  return {"m", 1, UnitSource::Assumed};
}

void requireChoices(const SurfaceSource& source) {
  const auto require = [&source](const char* key, const std::string& value, const auto& known) {
    if (std::ranges::find(known, value) == known.end())
      throw InputError(source.name, key, notOneOf(value, known));
  };
  require("surface.format", source.choices.format, surfaceFormats());
  require("surface.position_unit", source.choices.positionUnit, kSurfaceUnits);
  require("surface.height_unit", source.choices.heightUnit, kSurfaceUnits);
}

/// Returns the root mean square of the steps between neighbours along x, over the spacing.
double rmsSlope(const Topography& grid) {
  double squares = 0, count = 0;
  for (std::int64_t row = 0; row < grid.rows; ++row) {
    const std::span<const double> heights = grid.row(row);
    for (std::size_t i = 1; i < heights.size(); ++i) {
      if (std::isnan(heights[i]) || std::isnan(heights[i - 1])) continue;
      const double slope = (heights[i] - heights[i - 1]) / grid.columnSpacing;
      squares += slope * slope;
      count += 1;
    }
  }
  return count > 0 ? std::sqrt(squares / count) : 0;
}

/// Returns what to say where a unit must be chosen, because that of the file is not known.
Message unknownUnitText(const std::string& unit) {
  return message("is needed ({}): the unit '{}' of the file is not known; known are {}",
                 kUnitsOfKeys, shortened(unit), kKnownUnits);
}

/// Throws InputError where a unit or the distance of the points is unknown, and where numbers
/// without a unit would be impossible lengths in metres.
void requirePlausible(const SurfaceSource& source, const SurfaceDraft& draft) {
  const Topography& grid = draft.grid;
  const ReadingFacts& facts = draft.facts;
  const bool assumesX = facts.positionUnit.source == UnitSource::Assumed;
  const bool assumesZ = facts.heightUnit.source == UnitSource::Assumed;
  const double length = std::max(grid.length(), grid.width());
  if (!draft.hasPositions && source.choices.positionUnit == "auto")
    throw InputError(source.name, "surface.point_spacing",
                     "is needed (in m): the file does not say how far its points are apart");
  if (assumesX && !draft.unknownPositionUnit.empty())
    throw InputError(source.name, "surface.position_unit",
                     unknownUnitText(draft.unknownPositionUnit));
  if (assumesX && length > kLongestAssumed)
    throw InputError(source.name, "surface.position_unit",
                     message("is needed ({}): the file states no unit of positions, and in metres "
                             "the line would be {:.3g} m long",
                             kUnitsOfKeys, length));
  if (assumesZ && !draft.unknownHeightUnit.empty())
    throw InputError(source.name, "surface.height_unit", unknownUnitText(draft.unknownHeightUnit));
  if (!assumesX && !assumesZ) return;
  const double slope = rmsSlope(grid);
  if (slope > kSteepestAssumed)
    throw InputError(source.name, assumesZ ? "surface.height_unit" : "surface.position_unit",
                     assumesZ
                         ? message("is needed ({}): the file states no unit of heights, and in "
                                   "metres the rms slope would be {:.3g}",
                                   kUnitsOfKeys, slope)
                         : message("is needed ({}): the file states no unit of positions, and "
                                   "in metres the rms slope would be {:.3g}",
                                   kUnitsOfKeys, slope));
}

void applyUnits(const SurfaceSource& source, SurfaceDraft& draft) {
  ReadingFacts& facts = draft.facts;
  Topography& grid = draft.grid;
  facts.positionUnit = unitFact(source.choices.positionUnit, draft.positionUnit);
  facts.heightUnit = unitFact(source.choices.heightUnit, draft.heightUnit);
  const double spacing = source.choices.spacing;
  const bool isStated = draft.hasPositions && spacing > 0;
  if (!draft.hasPositions && spacing > 0) {
    grid.columnSpacing = spacing;
    if (grid.rowSpacing != 0) grid.rowSpacing = spacing;  // known to be that of the points
    facts.positionUnit = {"m", 1, UnitSource::Choice};
    draft.hasPositions = draft.isSpacingChosen = true;
  }
  grid.columnSpacing *= facts.positionUnit.metres;
  grid.rowSpacing *= facts.positionUnit.metres;
  constexpr double kEqual = 1e-6;
  if (isStated && !(std::abs(grid.columnSpacing - spacing) <= kEqual * spacing))
    facts.notes.emplace_back(
        "surface.point_spacing is not used: the file says how far its points are apart.");
  if (facts.heightUnit.metres != 1)
    for (double& height : grid.height)
      if (!std::isnan(height)) height *= facts.heightUnit.metres;
}

void requireSound(const SurfaceSource& source, const Topography& grid, ReadingFacts& facts) {
  constexpr std::int64_t kMin = 3;
  if (grid.columns == 1)
    source.fail(message("has one point along x; at least {} are needed", kMin));
  if (grid.columns < kMin)
    source.fail(message("has {} points along x; at least {} are needed", grid.columns, kMin));
  const auto isLength = [](double length) { return std::isfinite(length) && length > 0; };
  if (!isLength(grid.columnSpacing) || (grid.rowSpacing != 0 && !isLength(grid.rowSpacing)))
    source.fail("its points are no length above 0 apart");
  facts.points = grid.columns * grid.rows;
  facts.gaps = gapCount(grid.height);
  if (facts.gaps == facts.points) source.fail("has no heights, only gaps");
}

void requireNear(const SurfaceSource& source, const Topography& grid) {
  const bool isFar = std::max(grid.length(), grid.width()) > kFarthest ||
                     std::ranges::any_of(grid.height, [](double height) {
                       return !std::isnan(height) && std::abs(height) > kFarthest;
                     });
  if (isFar) source.fail(message("has lengths or heights beyond {} m", kFarthest));
}

MeasuredFile finished(const SurfaceSource& source, SurfaceDraft draft) {
  applyUnits(source, draft);
  if (draft.grid.rows == 1) draft.grid.rowSpacing = 0;
  requireSound(source, draft.grid, draft.facts);
  requirePlausible(source, draft);
  requireNear(source, draft.grid);
  addReadingNotes(draft);
  source.report(1);
  return {std::move(draft.grid), std::move(draft.facts)};
}

/// Reads a file of which isReadable is known.
MeasuredFile readReadable(const SurfaceSource& source) {
  requireChoices(source);
  source.report(0);
  if (source.bytes.empty()) source.fail("is empty");
  return finished(source, readDraft(source));
}

/// Reads the file in parts, so that reading can be stopped.
std::string readInParts(const RegularFile& regular, const std::stop_token& stop) {
  constexpr std::size_t kPart = std::size_t{1} << 24;
  if (regular.size() <= kPart) return regular.read(0, kPart);
  std::string bytes;
  bytes.reserve(regular.size());
  while (bytes.size() < regular.size()) {
    throwIfStopped(stop);
    const std::string part =
        regular.read(bytes.size(), std::min<std::size_t>(kPart, regular.size() - bytes.size()));
    if (part.empty()) break;  // the file has become shorter
    bytes += part;
  }
  return bytes;
}

}  // namespace

std::span<const std::string_view> surfaceFormats() {
  return kWords;
}

std::vector<std::string_view> surfaceFileEndings() {
  std::vector<std::string_view> endings(kTextEndings.begin(), kTextEndings.end());
  for (const SurfaceFormat& format : kFormats)
    for (const std::string_view ending : format.endings)
      if (!ending.empty()) endings.push_back(ending);
  return endings;
}

void refuseKind(const SurfaceSource& source) {
  const std::string_view kind = detectNonText(source.bytes);
  source.fail(
      message("is {}; text (profiles, matrices, points) and files of these kinds are read: "
              "{}",
              Message(kind.empty() ? "a binary file" : kind), readableFormats()));
}

std::string readableFormats() {
  std::string names;
  for (const SurfaceFormat& format : kFormats) appendItem(names, format.names);
  return names;
}

std::optional<std::int64_t> wholeNumber(double number) {
  if (!(std::abs(number) <= static_cast<double>(kMaxPoints)) || number != std::floor(number))
    return {};
  return static_cast<std::int64_t>(number);
}

void requireSize(const SurfaceSource& source, std::int64_t columns, std::int64_t rows,
                 std::size_t bytesThere, std::size_t bytesPerPoint) {
  if (columns < 1 || rows < 1 || columns > kMaxPoints / rows)
    source.fail(message("has {} x {} points; at most {} are read", columns, rows, kMaxPoints));
  const auto points = static_cast<std::size_t>(columns * rows);
  if (bytesThere / std::max<std::size_t>(bytesPerPoint, 1) < points && bytesPerPoint > 0)
    source.fail(message("ends too early: {} x {} points need {} bytes, and {} are there", columns,
                        rows, points * bytesPerPoint, bytesThere));
}

std::optional<StatedUnit> statedUnit(const SurfaceSource& source, std::string_view axis,
                                     std::string_view unit) {
  if (unit.empty()) return {};
  if (const auto metres = metresPer(unit)) return StatedUnit{shortened(unit), *metres};
  const bool ofHeights = axis.starts_with('z') || axis.starts_with('Z');
  if ((ofHeights ? source.choices.heightUnit : source.choices.positionUnit) != "auto") return {};
  const char* key = ofHeights ? "surface.height_unit" : "surface.position_unit";
  throw InputError(source.name, key,
                   message("the axis {} is in '{}', which is not a unit of length; {} can name "
                           "another one",
                           axis, shortened(unit), key));
}

MeasuredFile readMeasuredBytes(std::string_view bytes, const std::string& name,
                               const ReadingChoices& choices, const std::stop_token& stop,
                               const ReadingProgress& progress) {
  const SurfaceSource source{bytes, name, choices, stop, progress};
  if (!bytes.empty() && !isReadable(source)) refuseKind(source);
  return readReadable(source);
}

MeasuredFile readMeasuredFile(const std::filesystem::path& file, const ReadingChoices& choices,
                              const std::stop_token& stop, const ReadingProgress& progress) {
  const std::string name = file.string();
  {
    const RegularFile regular(file);
    if (regular.size() > kLargestFile)
      throw InputError(name, "", message("is larger than the {} bytes allowed", kLargestFile));
    // The beginning shows the kind, so that a large file of an unknown kind is not read in vain.
    const std::string beginning = regular.read(0, kBeginning);
    const SurfaceSource source{beginning, name, choices, stop, progress};
    const bool isOther =
        choices.format == "auto" && detectFormat(source) == nullptr && !canBeText(source);
    if (choices.format != "gwyddion" && !isOther) {
      const std::string bytes = readInParts(regular, stop);
      const SurfaceSource whole{bytes, name, choices, stop, progress};
      if (isReadable(whole)) return readReadable(whole);
    }
  }
  const std::string converted = convertWithGwyddion(file, stop);
  const SurfaceSource source{converted, name, choices, stop, progress};
  requireChoices(source);
  SurfaceDraft draft = readConvertedGwy(source);
  draft.facts.format = "gwyddion";
  return finished(source, std::move(draft));
}

bool isSurfaceFile(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return false;
  return !beginsAsObject(RegularFile(file).read(0, kBeginning));
}

}  // namespace asperity
