// Grids of Golden Software's Surfer: DSAA (text), DSBB (binary, 32-bit numbers) and DSRB (Surfer 7,
// sections with a name and a size, 64-bit numbers). Rows run along x, from the lowest y to the
// highest one. Units of length are not stated. Blanked points have the number 1.70141e38. DSRB may
// state another number, which in its first version stands for all numbers above it as well.
#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/text_encoding.h"
#include "core/measured/byte_reader.h"
#include "core/measured/surface_draft.h"
#include "core/measured/word_reader.h"

namespace asperity {
namespace {

constexpr HeightGaps kBlanked{.from = 1.70141e38};

/// The numbers of columns and rows, and the positions of the first and last ones.
struct SurferHeader {
  std::int64_t columns = 0, rows = 0;
  double firstX = 0, lastX = 0, firstY = 0, lastY = 0;
};

SurfaceDraft makeDraft(const SurferHeader& header) {
  const auto step = [](double first, double last, std::int64_t count) {
    return std::abs(last - first) / static_cast<double>(std::max<std::int64_t>(count - 1, 1));
  };
  return {.grid = {header.columns,
                   header.rows,
                   step(header.firstX, header.lastX, header.columns),
                   step(header.firstY, header.lastY, header.rows),
                   {}}};
}

SurfaceDraft readText(const SurfaceSource& source) {
  const DecodedText decoded(source.bytes, source.name);
  WordReader reader(decoded.text);
  reader.nextWord();  // DSAA
  const auto number = [&](std::string_view key) {
    const auto value = parseFiniteNumber(reader.nextWord());
    if (!value)
      source.fail(message("line {}: {} in the header is not a number", reader.line(), key));
    return *value;
  };
  const auto count = [&](std::string_view key) {
    const auto value = wholeNumber(number(key));
    if (!value || *value < 1) source.failNotAboveZero(key);
    return *value;
  };
  SurferHeader header;
  header.columns = count("nx");
  header.rows = count("ny");
  header.firstX = number("xlo");
  header.lastX = number("xhi");
  header.firstY = number("ylo");
  header.lastY = number("yhi");
  number("zlo");
  number("zhi");
  SurfaceDraft draft = makeDraft(header);
  takeHeights(source, reader, {.gaps = kBlanked}, draft.grid);
  return draft;
}

SurfaceDraft readBytes(const SurfaceSource& source) {
  ByteReader reader(source, source.bytes);
  reader.skip(4);  // DSBB
  SurferHeader header;
  header.columns = reader.read<std::int16_t>();
  header.rows = reader.read<std::int16_t>();
  header.firstX = reader.read<double>();
  header.lastX = reader.read<double>();
  header.firstY = reader.read<double>();
  header.lastY = reader.read<double>();
  reader.skip(2 * sizeof(double));  // lowest and highest z
  SurfaceDraft draft = makeDraft(header);
  takeHeights(source,
              {.bytes = reader.rest(),
               .type = kStored<float>,
               .gaps = {.from = static_cast<double>(static_cast<float>(kBlanked.from))}},
              draft.grid);
  return draft;
}

SurfaceDraft readSections(const SurfaceSource& source) {
  ByteReader reader(source, source.bytes);
  SurfaceDraft draft;
  bool hasGrid = false;
  std::uint32_t version = 1;
  double blank = kBlanked.from;
  while (!reader.atEnd()) {
    const std::string_view name = reader.take(4);
    const std::size_t size = reader.read<std::uint32_t>();
    if (name == "DATA" && hasGrid) {
      takeHeights(source,
                  {.bytes = reader.rest().substr(0, size),
                   .type = kStored<double>,
                   .gaps = {blank, version == 1 ? std::min(kBlanked.from, blank) : kBlanked.from}},
                  draft.grid);
      return draft;
    }
    const std::string_view section = reader.take(size);
    ByteReader header(source, section);
    if (name == "DSRB") version = header.read<std::uint32_t>();
    if (name != "GRID") continue;
    const auto rows = header.read<std::int32_t>(), columns = header.read<std::int32_t>();
    header.skip(2 * sizeof(double));  // position of the first point
    const auto xStep = header.read<double>(), yStep = header.read<double>();
    header.skip(3 * sizeof(double));  // lowest and highest z, rotation
    blank = header.read<double>();
    draft.grid = {columns, rows, xStep, yStep, {}};
    hasGrid = true;
  }
  source.fail(message("has no block of heights; known are {}", "DATA"));
}

}  // namespace

bool isSurfer(const SurfaceSource& source) {
  const std::string_view name = source.bytes.substr(0, 4);
  if (name == "DSAA") return source.bytes.substr(4).find_first_of(" \t\r\n") == 0;
  return name == "DSBB" || name == "DSRB";
}

SurfaceDraft readSurfer(const SurfaceSource& source) {
  const std::string_view name = source.bytes.substr(0, 4);
  if (!isSurfer(source)) source.fail(message("is not a {} file", "Surfer"));
  return name == "DSAA"   ? readText(source)
         : name == "DSBB" ? readBytes(source)
                          : readSections(source);
}

}  // namespace asperity
