// Text files of Wyko and Veeco instruments (the "ASCII" export of OPD data by Vision): lines of
// name, type, length and value between tabs, then one line for each position along x with the
// heights along y. Pixel_size is in millimetres; Aspect is the step along y over that along x.
// Heights are in nanometres where the second flag of the first line is 1, else in wavelengths over
// Mult.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>

#include "core/base/number_text.h"
#include "core/base/text_dialect.h"
#include "core/base/text_encoding.h"
#include "core/base/text_number.h"
#include "core/measured/surface_draft.h"
#include "core/measured/word_reader.h"

namespace asperity {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view kWykoMagic = "Wyko ASCII Data File Format";
constexpr std::array kHeightBlocks{"RAW_DATA"sv, "RAW DATA"sv, "OPD"sv, "SAMPLE_DATA"sv};

std::vector<std::string_view> splitAtTabs(std::string_view line) {
  std::vector<std::string_view> fields = splitFields(line, TextDialect::Separator::Tab);
  for (std::string_view& field : fields) field = trimmedField(field);
  return fields;
}

class WykoReader {
 public:
  WykoReader(const SurfaceSource& source, std::string_view text) : source_(source), reader_(text) {}

  SurfaceDraft read() {
    const std::vector<std::string_view> first =
        splitWords(reader_.nextLine().substr(kWykoMagic.size()));
    const bool inNanometres = first.size() > 1 && first[1] == "1";
    readHeader();
    const std::int64_t columns = count("X Size"), rows = count("Y Size");
    // A height takes at least a digit and a tab.
    requireSize(source_, columns, rows, reader_.left() + 1, 2);
    const double scale = inNanometres ? 1 : number("Wavelength") / number("Mult", 1);
    SurfaceDraft draft;
    draft.facts.heightColumn = std::string(block_);
    Topography along;  // each row is a column of the surface
    along.columns = rows;
    along.rows = columns;
    readHeights(source_, reader_, static_cast<std::size_t>(columns * rows), {.scale = scale},
                along.height);
    draft.grid = transposed(along);
    draft.heightUnit = StatedUnit{"nm", 1e-9};
    const double pixel = values_.contains("Pixel_size") ? std::abs(number("Pixel_size", 0)) : 0;
    draft.hasPositions = pixel > 0;
    draft.grid.columnSpacing = draft.grid.rowSpacing = 1;
    if (!draft.hasPositions) return draft;
    draft.positionUnit = StatedUnit{"mm", 1e-3};
    draft.grid.columnSpacing = pixel;
    draft.grid.rowSpacing = pixel * std::abs(number("Aspect", 1));
    return draft;
  }

 private:
  /// Reads up to the line that announces the heights.
  void readHeader() {
    while (!reader_.atEnd()) {
      const std::vector<std::string_view> fields = splitAtTabs(reader_.nextLine());
      if (fields.empty()) continue;
      block_ = fields.front();
      if (std::ranges::find(kHeightBlocks, block_) != kHeightBlocks.end()) return;
      if (fields.size() > 1) values_.emplace(block_, fields.size() > 3 ? fields[3] : fields[1]);
    }
    source_.fail(message("has no block of heights; known are {}", "RAW_DATA, OPD, SAMPLE_DATA"));
  }

  std::int64_t count(const std::string& key) const {
    const auto found = values_.find(key);
    if (found == values_.end()) source_.failWithout(key);
    std::int64_t value = 0;
    if (!readNumber(found->second, value) || value < 1) source_.failNotAboveZero(key);
    return value;
  }

  /// fallback: 0 where the entry must be present.
  double number(const std::string& key, double fallback = 0) const {
    const auto found = values_.find(key);
    if (found == values_.end() && fallback == 0) source_.failWithout(key);
    if (found == values_.end()) return fallback;
    const double value = parseFiniteNumber(found->second).value_or(0);
    if (value == 0) source_.failNotAboveZero(key);
    return value;
  }

  const SurfaceSource& source_;
  WordReader reader_;
  std::string_view block_;
  std::map<std::string, std::string_view, std::less<>> values_;
};

}  // namespace

bool isWyko(const SurfaceSource& source) {
  return withoutByteOrderMark(source.bytes).starts_with(kWykoMagic);
}

SurfaceDraft readWyko(const SurfaceSource& source) {
  if (!isWyko(source)) source.fail(message("is not a {} file", "Wyko"));
  const DecodedText decoded(source.bytes, source.name);
  return WykoReader(source, decoded.text).read();
}

}  // namespace asperity
