// Gwyddion Simple Field: a header of "Name = value" lines, zero bytes up to a multiple of four, and
// 32-bit numbers row by row (Gwyddion user guide, "Gwyddion Simple Field (.gsf)").
#include <map>
#include <string>

#include "core/base/number_text.h"
#include "core/base/text_number.h"
#include "core/measured/byte_reader.h"
#include "core/measured/surface_draft.h"

namespace asperity {
namespace {

constexpr std::string_view kGsfMagic = "Gwyddion Simple Field 1.0\n";

class GsfHeader {
 public:
  GsfHeader(const SurfaceSource& source, std::string_view text) : source_(source) {
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      const std::string_view line = text.substr(0, end);
      text.remove_prefix(std::min(end + 1, text.size()));
      if (const std::size_t at = line.find('='); at != std::string_view::npos)
        values_[lowerCase(trimmedBlanks(line.substr(0, at)))] = trimmedBlanks(line.substr(at + 1));
    }
  }

  std::string_view text(const std::string& key) const {
    const auto found = values_.find(lowerCase(key));
    return found == values_.end() ? std::string_view{} : found->second;
  }
  std::int64_t count(const std::string& key) const {
    std::int64_t value = 0;
    if (text(key).empty()) source_.failWithout(key);
    if (!readNumber(text(key), value) || value < 1) source_.failNotAboveZero(key);
    return value;
  }
  double size(const std::string& key) const {
    double value = 1;
    if (!text(key).empty() && (!readTextNumber(text(key), '.', value) || !(value > 0)))
      source_.failNotAboveZero(key);
    return value;
  }

 private:
  const SurfaceSource& source_;
  std::map<std::string, std::string_view> values_;
};

}  // namespace

bool isGsf(const SurfaceSource& source) {
  return source.bytes.starts_with("Gwyddion Simple Field");
}

SurfaceDraft readGsf(const SurfaceSource& source) {
  if (!source.bytes.starts_with(kGsfMagic)) source.fail(message("is not a {} file", "GSF"));
  const std::size_t end = source.bytes.find('\0');
  if (end == std::string_view::npos)
    source.fail(message("the header of the {} file has no end", "GSF"));
  const GsfHeader header(source, source.bytes.substr(kGsfMagic.size(), end - kGsfMagic.size()));

  SurfaceDraft draft;
  Topography& grid = draft.grid;
  grid.columns = header.count("XRes");
  grid.rows = header.count("YRes");
  // One to four zero bytes, up to a multiple of four.
  const std::size_t begin = std::min(end / 4 * 4 + 4, source.bytes.size());
  takeHeights(source, {.bytes = source.bytes.substr(begin), .type = kStored<float>}, grid);
  grid.columnSpacing = header.size("XReal") / static_cast<double>(grid.columns);
  grid.rowSpacing = header.size("YReal") / static_cast<double>(grid.rows);
  draft.hasPositions = !header.text("XReal").empty();
  if (!draft.hasPositions) grid.columnSpacing = grid.rowSpacing = 1;
  draft.positionUnit = statedUnit(source, "XYUnits", header.text("XYUnits"));
  draft.heightUnit = statedUnit(source, "ZUnits", header.text("ZUnits"));
  draft.facts.heightColumn = shortened(header.text("Title"));
  return draft;
}

}  // namespace asperity
