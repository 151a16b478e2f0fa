// Text files of Zygo interferometers (MetroPro Reference Guide, appendix "Data File Format"): 13 or
// 14 lines of numbers and quoted texts up to a line "#". In line 4 are origin and size of the
// field in pixels, in line 8 the interferometric scale factor, the wavelength (m), the obliquity
// factor and the size of a pixel (m; 0: not known), at the beginning of line 11 the phase
// resolution.
//  - "Zygo XYZ Data File": lines "x y z" with pixels and micrometres, or "x y No Data".
//  - "Zygo ASCII Data File": intensities up to "#", then whole numbers row by row, which are
//    heights over scale factor, obliquity and wavelength times the phase resolution.
#include <array>
#include <cmath>
#include <string>

#include "core/base/number_text.h"
#include "core/base/text_encoding.h"
#include "core/base/text_number.h"
#include "core/measured/surface_draft.h"
#include "core/measured/word_reader.h"

namespace asperity {
namespace {

constexpr std::string_view kXyz = "Zygo XYZ Data File", kPhases = "Zygo ASCII Data File";
constexpr std::size_t kHeaderLines = 13, kMostHeaderLines = 16;
constexpr double kNoPhase = 2147483640;  // this number and those above it

class Reader {
 public:
  Reader(const SurfaceSource& source, std::string_view text) : source_(source), reader_(text) {}

  SurfaceDraft read() {
    const bool hasPoints = readHeader().starts_with(kXyz);
    SurfaceDraft draft;
    draft.facts.format = "zygo";
    Topography& grid = draft.grid;
    grid.columns = whole(4, 2);
    grid.rows = whole(4, 3);
    const double pixel = number(8, 6);
    draft.hasPositions = pixel > 0;
    grid.columnSpacing = grid.rowSpacing = draft.hasPositions ? pixel : 1;
    if (draft.hasPositions) draft.positionUnit = StatedUnit{"m", 1};
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
  /// Up to the line "#"; returns the first line.
  std::string_view readHeader() {
    while (lines_.size() <= kMostHeaderLines && !reader_.atEnd()) {
      const std::string_view line = reader_.nextLine();
      if (line == "#" && lines_.size() >= kHeaderLines) return lines_.front();
      lines_.push_back(line);
    }
    source_.fail(message("the header of the {} file has no end", "Zygo"));
  }

  /// Lines are counted from 1, their numbers from 0.
  double number(std::size_t line, std::size_t at) const {
    const std::vector<std::string_view> words = wordsOf(lines_[line - 1]);
    const auto value = at < words.size() ? numberIn(words[at]) : std::nullopt;
    if (!value) source_.fail(message("line {}: number {} is missing", line, at + 1));
    return *value;
  }
  std::int64_t whole(std::size_t line, std::size_t at) const {
    const auto value = wholeNumber(number(line, at));
    if (!value)
      source_.fail(message("line {}: number {} is not a whole number from 0 to {}", line, at + 1,
                           kMostPoints));
    return *value;
  }

  void readPoints(Topography& grid) {
    const auto points = static_cast<std::size_t>(grid.columns * grid.rows);
    grid.height.assign(points, std::nan(""));
    std::vector<bool> isTaken(points);
    const std::int64_t left = whole(4, 0), top = whole(4, 1);
    std::size_t taken = 0;
    bool hasEnd = false;
    while (!hasEnd && !reader_.atEnd()) {
      source_.reportPoint(taken, points);
      const std::string_view line = reader_.nextLine();
      hasEnd = line.starts_with('#');
      if (hasEnd || line.empty()) continue;
      const std::vector<std::string_view> words = wordsOf(line);
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
      if (const auto height = numberIn(words[2]); words.size() == 3 && height)
        grid.height[at] = *height;
      else if (lowerCase(words[2]) != "no" && readField(words[2], '.').kind != FieldKind::Missing)
        source_.fail(message("line {}: the height is not a number", reader_.line()));
    }
    // Points that were not measured may be left out.
    if (taken < points && !hasEnd)
      source_.fail(message("line {}: ends after {} of {} heights", reader_.line(), taken, points));
  }

  void readPhases(Topography& grid) {
    while (!reader_.atEnd() && !reader_.nextLine().starts_with('#')) {
    }
    constexpr std::array kResolutions{4096, 32768, 131072};
    const std::int64_t code = whole(11, 0);
    if (code < 0 || code >= static_cast<std::int64_t>(kResolutions.size()))
      source_.fail(message("{} {} is not known", "PhaseRes", code));
    const double scale =
        number(8, 1) * number(8, 2) * number(8, 4) / kResolutions[static_cast<std::size_t>(code)];
    if (!(std::abs(scale) > 0))
      source_.fail(message("{} in the header is not a number above 0", "WavelengthIn"));
    const auto count = static_cast<std::size_t>(grid.columns * grid.rows);
    requireSize(source_, grid.columns, grid.rows, reader_.left() + 1, 2);
    readHeights(source_, reader_, count, {scale, kNoPhase, '#'}, grid.height);
    requireNoMoreHeights(source_, reader_, count);
  }

  const SurfaceSource& source_;
  WordReader reader_;
  std::vector<std::string_view> lines_;
};

}  // namespace

bool isZygo(const SurfaceSource& source) {
  const std::string_view bytes = withoutByteOrderMark(source.bytes);
  return bytes.starts_with(kXyz) || bytes.starts_with(kPhases);
}

SurfaceDraft readZygo(const SurfaceSource& source) {
  if (!isZygo(source)) source.fail(message("is not a {} file", "Zygo"));
  const DecodedText decoded(source.bytes, source.name);
  return Reader(source, decoded.text).read();
}

}  // namespace asperity
