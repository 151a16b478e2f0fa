// Surfaces and profiles of Digital Surf (SUR, PRO): a header of 512 bytes, a comment, a private
// zone, then whole numbers of 16 or 32 bits row by row, which may be packed streams of zlib.
// Heights are numbers times the spacing of z, in its step unit.
#include <zlib.h>

#include <algorithm>
#include <array>
#include <string>

#include "core/base/text_encoding.h"
#include "core/base/text_number.h"
#include "core/measured/byte_reader.h"
#include "core/measured/surface_draft.h"

namespace asperity {
namespace {

constexpr std::string_view kPlain = "DIGITAL SURF", kPacked = "DSCOMPRESSED";
constexpr std::size_t kHeaderSize = 512;

struct SurAxis {
  double spacing = 0;
  std::string stepUnit{}, lengthUnit{};
  double unitRatio = 1;  // step units in one length unit
};

struct SurHeader {
  bool isPacked = false;
  int objects = 1, type = 0, specialPoints = 0, bits = 0;
  std::int32_t lowest = 0;
  std::int64_t columns = 0, rows = 0;
  std::array<SurAxis, 3> axes{};
  std::size_t comment = 0, privateZone = 0;
};

/// Reads a text of a fixed size in Latin-1, padded with blanks or zeros.
std::string fixedText(std::string_view bytes) {
  bytes = trimmedBlanks(bytes.substr(0, bytes.find('\0')));
  std::string text;
  for (const char letter : bytes) {
    const auto code = static_cast<unsigned char>(letter);
    if (code >= 0x80 && !isUtf8(bytes)) {
      text += static_cast<char>(0xC0 | code >> 6);
      text += static_cast<char>(0x80 | (code & 0x3F));
    } else {
      text += letter;
    }
  }
  return text;
}

SurHeader readSurHeader(const SurfaceSource& source) {
  SurHeader header;
  header.isPacked = source.bytes.starts_with(kPacked);
  if (!header.isPacked && !source.bytes.starts_with(kPlain))
    source.fail(message("is not a {} file", "SUR"));
  ByteReader reader(source, source.bytes);
  reader.skip(kPlain.size());
  reader.read<std::int16_t>();  // byte order of the program that wrote it; files are little-endian
  header.objects = reader.read<std::int16_t>();
  reader.read<std::int16_t>();  // version
  header.type = reader.read<std::int16_t>();
  reader.skip(30 + 30 + 2 + 2 + 2);  // names of object and operator, material, acquisition, range
  header.specialPoints = reader.read<std::int16_t>();
  reader.skip(2 + 8);  // absolute heights; gauge resolution
  header.bits = reader.read<std::int16_t>();
  header.lowest = reader.read<std::int32_t>();
  reader.read<std::int32_t>();  // highest
  header.columns = reader.read<std::int32_t>();
  header.rows = reader.read<std::int32_t>();
  reader.read<std::int32_t>();  // their product
  for (SurAxis& axis : header.axes) axis.spacing = static_cast<double>(reader.read<float>());
  reader.skip(3 * 16);  // names of the axes
  for (SurAxis& axis : header.axes) axis.stepUnit = fixedText(reader.take(16));
  for (SurAxis& axis : header.axes) axis.lengthUnit = fixedText(reader.take(16));
  for (SurAxis& axis : header.axes) axis.unitRatio = static_cast<double>(reader.read<float>());
  reader.skip(3 * 2 + 12 + 7 * 2 + 4 + 10);  // replica, inverted, levelled; date; duration
  header.comment = reader.read<std::uint16_t>();
  header.privateZone = reader.read<std::uint16_t>();
  reader.skip(kHeaderSize - reader.position());
  return header;
}

/// Returns the unit of the spacing.
std::optional<StatedUnit> spacingUnit(const SurfaceSource& source, std::string_view name,
                                      SurAxis& axis) {
  if (!axis.stepUnit.empty() || axis.lengthUnit.empty())
    return statedUnit(source, name, axis.stepUnit);
  if (std::isfinite(axis.unitRatio) && axis.unitRatio > 0) axis.spacing /= axis.unitRatio;
  return statedUnit(source, name, axis.lengthUnit);
}

[[noreturn]] void failUnpacking(const SurfaceSource& source) {
  source.fail(message("the packed heights of the {} file cannot be unpacked", "SUR"));
}

/// Unpacks the streams of a packed file into one. The file states their number and the plain and
/// packed size of each.
std::string unpacked(const SurfaceSource& source, ByteReader& reader, std::size_t expected) {
  const auto count = reader.read<std::uint32_t>();
  std::vector<std::pair<std::uint32_t, std::uint32_t>> sizes;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto plain = reader.read<std::uint32_t>();
    sizes.emplace_back(plain, reader.read<std::uint32_t>());
  }
  std::string bytes;
  for (const auto& [plain, packed] : sizes) {
    const std::string_view stream = reader.take(packed);
    if (plain > expected - std::min(expected, bytes.size())) failUnpacking(source);
    const std::size_t before = bytes.size();
    bytes.resize(before + plain);
    uLongf size = plain;
    const int status = ::uncompress(reinterpret_cast<Bytef*>(bytes.data() + before), &size,
                                    reinterpret_cast<const Bytef*>(stream.data()), packed);
    if (status != Z_OK || size != plain) failUnpacking(source);
    source.report(static_cast<double>(bytes.size()) / static_cast<double>(expected));
  }
  return bytes;
}

/// Makes a draft with the grid of the header, without heights.
SurfaceDraft makeDraft(const SurfaceSource& source, SurHeader& header) {
  SurfaceDraft draft;
  Topography& grid = draft.grid;
  grid.columns = header.columns;
  grid.rows = header.rows;
  draft.positionUnit = spacingUnit(source, "X", header.axes[0]);
  const auto rowUnit =
      header.rows > 1 ? spacingUnit(source, "Y", header.axes[1]) : draft.positionUnit;
  draft.heightUnit = spacingUnit(source, "Z", header.axes[2]);
  for (std::size_t i = 0; i < 3; ++i) {
    constexpr std::array kNames{"X spacing", "Y spacing", "Z spacing"};
    const double spacing = header.axes[i].spacing;
    if ((i != 1 || header.rows > 1) && (!std::isfinite(spacing) || spacing == 0))
      source.failNotAboveZero(kNames[i]);
  }
  grid.columnSpacing = std::abs(header.axes[0].spacing);
  if (header.rows > 1)
    grid.rowSpacing = std::abs(header.axes[1].spacing) * (rowUnit ? rowUnit->metres : 1) /
                      (draft.positionUnit ? draft.positionUnit->metres : 1);
  if (header.objects > 1)
    draft.facts.notes.push_back(
        message("The first of {} objects in the file is read.", header.objects));
  return draft;
}

}  // namespace

bool isSur(const SurfaceSource& source) {
  return source.bytes.starts_with(kPlain) || source.bytes.starts_with(kPacked);
}

SurfaceDraft readSur(const SurfaceSource& source) {
  SurHeader header = readSurHeader(source);
  // 1 profile, 2 surface, 4 and 5 series of them, 7 and 8 in layers, 11 surface with intensities.
  constexpr std::array kWithHeights{1, 2, 4, 5, 7, 8, 11};
  if (std::ranges::find(kWithHeights, header.type) == kWithHeights.end())
    source.fail(message("{} {} is not known", "Studiable type", header.type));
  if (header.bits != 16 && header.bits != 32)
    source.fail(message("has {} bits a point; 16 or 32 are read", header.bits));
  if (header.columns < 1 || header.rows < 1) source.failNotAboveZero("Points");

  const std::size_t bytesOfPoint = static_cast<std::size_t>(header.bits) / 8;
  ByteReader reader(source, source.bytes);
  reader.skip(kHeaderSize);
  reader.skip(header.comment + header.privateZone);
  // Packed points may take any number of bytes; zlib cannot reach a thousandth of their size.
  constexpr std::size_t kMaxPacked = 1100;
  requireSize(source, header.columns, header.rows,
              header.isPacked ? reader.left() * kMaxPacked : reader.left(), bytesOfPoint);
  const std::size_t bytes = static_cast<std::size_t>(header.columns * header.rows) * bytesOfPoint;

  SurfaceDraft draft = makeDraft(source, header);
  const std::string plain = header.isPacked ? unpacked(source, reader, bytes) : std::string();
  const std::string_view data = header.isPacked ? std::string_view(plain) : reader.take(bytes);
  if (data.size() < bytes) failUnpacking(source);
  // The lowest height minus two marks a point that was not measured.
  takeHeights(source,
              {.bytes = data,
               .type = header.bits == 16 ? kStored<std::int16_t> : kStored<std::int32_t>,
               .scale = header.axes[2].spacing,
               .gaps = header.specialPoints != 0
                           ? HeightGaps{.equal = static_cast<double>(header.lowest) - 2}
                           : HeightGaps{}},
              draft.grid);
  return draft;
}

}  // namespace asperity
