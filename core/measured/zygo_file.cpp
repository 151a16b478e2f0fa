// Files of Zygo interferometers (MetroPro Reference Guide, appendix "Data File Format").
//
// Binary ones begin with a header of big-endian numbers, then intensities of two bytes, then phases
// of four. The header has its size at byte 6, width, height and number of the intensities at 52,
// size of the field in pixels at 68, scale factor, wavelength (m), obliquity factor and size of a
// pixel (m; 0: not known) at 164, 168, 176 and 184, the phase resolution at 218.
//
// Texts have 13 or 14 lines of numbers and quoted texts up to a line "#". In line 4 are origin and
// size of the field in pixels, in line 8 the interferometric scale factor, the wavelength (m), the
// obliquity factor and the size of a pixel (m; 0: not known), at the beginning of line 11 the phase
// resolution.
//  - "Zygo XYZ Data File": lines "x y z" with pixels and micrometres, or "x y No Data".
//  - "Zygo ASCII Data File": intensities up to "#", then whole numbers row by row, which are
//    heights over scale factor, obliquity and wavelength times the phase resolution.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/base/number_text.h"
#include "core/base/text_encoding.h"
#include "core/base/text_number.h"
#include "core/measured/byte_reader.h"
#include "core/measured/surface_draft.h"
#include "core/measured/word_reader.h"

namespace asperity {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view kXyz = "Zygo XYZ Data File", kPhases = "Zygo ASCII Data File";
constexpr std::size_t kHeaderLines = 13, kMaxHeaderLines = 16;
constexpr HeightGaps kNoPhase{.from = 2147483640};
constexpr std::array kMagics{"\x88\x1B\x03\x6F"sv, "\x88\x1B\x03\x70"sv, "\x88\x1B\x03\x71"sv};

/// Makes a draft with square pixels.
SurfaceDraft makeDraft(std::int64_t columns, std::int64_t rows, double pixel) {
  SurfaceDraft draft;
  draft.hasPositions = pixel > 0;
  const double spacing = draft.hasPositions ? pixel : 1;
  draft.grid = {columns, rows, spacing, spacing, {}};
  if (draft.hasPositions) draft.positionUnit = StatedUnit{"m", 1};
  return draft;
}

/// Returns the height of one step of the phases in metres.
double phaseStep(const SurfaceSource& source, double scaleFactor, double wavelength,
                 double obliquity, std::int64_t resolution) {
  constexpr std::array kResolutions{4096, 32768, 131072};
  if (resolution < 0 || resolution >= static_cast<std::int64_t>(kResolutions.size()))
    source.fail(message("{} {} is not known", "PhaseRes", resolution));
  const double step =
      scaleFactor * wavelength * obliquity / kResolutions[static_cast<std::size_t>(resolution)];
  if (!(std::abs(step) > 0)) source.failNotAboveZero("WavelengthIn");
  return step;
}

SurfaceDraft readBinaryZygo(const SurfaceSource& source) {
  constexpr std::size_t kHeader = 570;  // bytes, at least
  ByteReader reader(source, source.bytes);
  const std::string_view header = reader.take(kHeader);
  const auto whole = [header](std::size_t offset) -> std::int64_t {
    return storedNumber<std::uint16_t>(header.substr(offset), std::endian::big);
  };
  const auto number = [header](std::size_t offset) {
    return static_cast<double>(storedNumber<float>(header.substr(offset), std::endian::big));
  };
  const std::size_t size = storedNumber<std::uint32_t>(header.substr(6), std::endian::big);
  reader.skip(std::max(size, kHeader) - kHeader);
  reader.skip(static_cast<std::size_t>(2 * whole(52) * whole(54) * whole(56)));
  SurfaceDraft draft = makeDraft(whole(68), whole(70), number(184));
  draft.heightUnit = StatedUnit{"m", 1};
  Topography& grid = draft.grid;
  requireSize(source, grid.columns, grid.rows, reader.left(), sizeof(std::int32_t));
  takeHeights(source,
              {.bytes = reader.rest(),
               .type = kStored<std::int32_t>,
               .order = std::endian::big,
               .scale = phaseStep(source, number(164), number(168), number(176), whole(218)),
               .gaps = kNoPhase},
              grid);
  return draft;
}

class ZygoTextReader {
 public:
  ZygoTextReader(const SurfaceSource& source, std::string_view text)
      : source_(source), reader_(text) {}

  SurfaceDraft read() {
    const bool hasPoints = readHeader().starts_with(kXyz);
    const std::int64_t columns = whole(4, 2), rows = whole(4, 3);
    SurfaceDraft draft = makeDraft(columns, rows, number(8, 6));
    Topography& grid = draft.grid;
    requireSize(source_, grid.columns, grid.rows, reader_.left(), 1);
    if (hasPoints) {
      draft.heightUnit = StatedUnit{"\u00B5m", 1e-6};
      readPoints(grid);
    } else {
      draft.heightUnit = StatedUnit{"m", 1};
      readPhases(grid);
    }
    return draft;
  }

 private:
  /// Reads up to the line "#" and returns the first line.
  std::string_view readHeader() {
    while (lines_.size() <= kMaxHeaderLines && !reader_.atEnd()) {
      const std::string_view line = reader_.nextLine();
      if (line == "#" && lines_.size() >= kHeaderLines) return lines_.front();
      lines_.push_back(line);
    }
    source_.fail(message("the header of the {} file has no end", "Zygo"));
  }

  /// Returns a number of the header. Lines are counted from 1, the numbers of a line from 0.
  double number(std::size_t line, std::size_t at) const {
    const std::vector<std::string_view> words = splitWords(lines_[line - 1]);
    const auto value = at < words.size() ? parseFiniteNumber(words[at]) : std::nullopt;
    if (!value) source_.fail(message("line {}: number {} is missing", line, at + 1));
    return *value;
  }
  std::int64_t whole(std::size_t line, std::size_t at) const {
    const auto value = wholeNumber(number(line, at));
    if (!value)
      source_.fail(message("line {}: number {} is not a whole number from 0 to {}", line, at + 1,
                           kMaxPoints));
    return *value;
  }

  void readPoints(Topography& grid) {
    const auto points = static_cast<std::size_t>(grid.columns * grid.rows);
    grid.height.assign(points, kMissingHeight);
    std::vector<bool> isTaken(points);
    const std::int64_t left = whole(4, 0), top = whole(4, 1);
    std::size_t taken = 0;
    bool hasEnd = false;
    while (!hasEnd && !reader_.atEnd()) {
      source_.reportPoint(taken, points);
      const std::string_view line = reader_.nextLine();
      hasEnd = line.starts_with('#');
      if (hasEnd || line.empty()) continue;
      const std::vector<std::string_view> words = splitWords(line);
      std::int64_t x = 0, y = 0;
      if (words.size() < 3 || !readNumber(words[0], x) || !readNumber(words[1], y))
        source_.fail(message("line {}: is not a point 'x y z'", reader_.line()));
      if (x < left || y < top || x - left >= grid.columns || y - top >= grid.rows)
        source_.fail(message("line {}: the pixel {} {} is not in the field that line 4 says",
                             reader_.line(), x, y));
      const auto at = static_cast<std::size_t>((y - top) * grid.columns + x - left);
      if (isTaken[at])
        source_.fail(message("line {}: there is a point at this position already", reader_.line()));
      isTaken[at] = true;
      ++taken;
      if (const auto height = parseFiniteNumber(words[2]); words.size() == 3 && height)
        grid.height[at] = *height;
      else if (lowerCase(words[2]) != "no" && readField(words[2], '.').kind != FieldKind::Missing)
        source_.fail(message("line {}: the height is not a number", reader_.line()));
    }
    // Points that were not measured may be missing.
    if (taken < points && !hasEnd)
      source_.fail(message("line {}: ends after {} of {} heights", reader_.line(), taken, points));
  }

  void readPhases(Topography& grid) {
    while (!reader_.atEnd() && !reader_.nextLine().starts_with('#')) {
    }
    const double scale = phaseStep(source_, number(8, 1), number(8, 2), number(8, 4), whole(11, 0));
    takeHeights(source_, reader_, {.scale = scale, .gaps = kNoPhase, .end = '#'}, grid);
  }

  const SurfaceSource& source_;
  WordReader reader_;
  std::vector<std::string_view> lines_;
};

bool isBinaryZygo(const SurfaceSource& source) {
  return std::ranges::any_of(
      kMagics, [&source](std::string_view magic) { return source.bytes.starts_with(magic); });
}

}  // namespace

bool isZygo(const SurfaceSource& source) {
  const std::string_view bytes = withoutByteOrderMark(source.bytes);
  if (isBinaryZygo(source)) return true;
  return bytes.starts_with(kXyz) || bytes.starts_with(kPhases);
}

SurfaceDraft readZygo(const SurfaceSource& source) {
  if (!isZygo(source)) source.fail(message("is not a {} file", "Zygo"));
  if (isBinaryZygo(source)) return readBinaryZygo(source);
  const DecodedText decoded(source.bytes, source.name);
  return ZygoTextReader(source, decoded.text).read();
}

}  // namespace asperity
