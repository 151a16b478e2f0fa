// Surface Data File (ISO 25178-71; BCR before it): aISO-1.0 and aISO-2.0 are text, bISO-1.0 and
// bISO-2.0 are binary with counts of points of 16 and 32 bits. Some institutes write their own name
// after the a or b ("aNPL-V1.0"); the header below it is the same. Heights are numbers times
// Zscale, in metres. BAD, the lowest integer or the lowest float marks a point that was not
// measured.
#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>
#include <string>

#include "core/base/number_text.h"
#include "core/base/text_encoding.h"
#include "core/base/text_number.h"
#include "core/measured/byte_reader.h"
#include "core/measured/surface_draft.h"
#include "core/measured/word_reader.h"

namespace asperity {
namespace {

constexpr std::size_t kMagicSize = 8, kIdentity = 10, kDates = 24;
constexpr std::size_t kNumbersSize = 43;  // of 32-bit counts, which are the longer ones
constexpr std::size_t kSdfHeaderSize = kMagicSize + kIdentity + kDates + kNumbersSize;

/// The types by their code in the header; only BCR has the unsigned ones.
constexpr std::array kDataTypes{
    kStored<std::uint8_t>, kStored<std::uint16_t>, kStored<std::uint32_t>, kStored<float>,
    kStored<std::int8_t>,  kStored<std::int16_t>,  kStored<std::int32_t>,  kStored<double>};

struct SdfHeader {
  std::int64_t columns = 0, rows = 0;
  double xScale = 0, yScale = 0, zScale = 0;
  int compression = 0, dataType = 0, checkType = 0;
};

bool isKnownType(int code) {
  return code >= 0 && code < static_cast<int>(kDataTypes.size());
}

/// Makes a draft with the grid of the header, without heights.
SurfaceDraft makeDraft(const SurfaceSource& source, const SdfHeader& header) {
  const auto requirePositive = [&source](std::string_view key, double value) {
    if (!(value > 0) || !std::isfinite(value)) source.failNotAboveZero(key);
  };
  requirePositive("NumPoints", static_cast<double>(header.columns));
  requirePositive("NumProfiles", static_cast<double>(header.rows));
  requirePositive("Xscale", header.xScale);
  if (header.rows > 1) requirePositive("Yscale", header.yScale);
  if (header.zScale == 0 || !std::isfinite(header.zScale)) source.failNotAboveZero("Zscale");
  if (header.compression != 0)
    source.fail(message("is compressed, which {} files are not read with", "SDF"));
  if (!isKnownType(header.dataType))
    source.fail(message("{} {} is not known", "DataType", header.dataType));
  SurfaceDraft draft;
  draft.grid = {header.columns, header.rows, header.xScale, header.yScale, {}};
  draft.positionUnit = draft.heightUnit = StatedUnit{"m", 1};
  return draft;
}

enum class Counts { Of16Bits, Of32Bits };

SdfHeader readNumbers(ByteReader& reader, Counts counts) {
  const bool areLong = counts == Counts::Of32Bits;
  reader.skip(kMagicSize + kIdentity + kDates);
  SdfHeader header;
  header.columns = areLong ? reader.read<std::uint32_t>() : reader.read<std::uint16_t>();
  header.rows = areLong ? reader.read<std::uint32_t>() : reader.read<std::uint16_t>();
  header.xScale = reader.read<double>();
  header.yScale = reader.read<double>();
  header.zScale = reader.read<double>();
  reader.read<double>();  // Zresolution
  header.compression = reader.read<std::uint8_t>();
  header.dataType = reader.read<std::uint8_t>();
  header.checkType = reader.read<std::uint8_t>();
  return header;
}

/// Returns whether the numbers of a header are possible.
bool isPossible(const SdfHeader& header) {
  const auto isBetween = [](double size, double least, double most) {
    return std::isfinite(size) && std::abs(size) >= least && std::abs(size) <= most;
  };
  return header.columns > 0 && header.rows > 0 && isBetween(header.xScale, 1e-15, 1e3) &&
         isBetween(header.zScale, 1e-20, 1e6) && isKnownType(header.dataType);
}

/// Returns the size of the counts as the name of the version states it.
Counts namedCounts(std::string_view bytes) {
  return bytes.substr(0, kMagicSize).ends_with("2.0") ? Counts::Of32Bits : Counts::Of16Bits;
}

/// How the numbers of a binary file are stored.
struct Layout {
  Counts counts = Counts::Of16Bits;
  std::endian order = std::endian::little;  // as the standard says
};

/// Returns the layout with which the header is possible. Counts have 32 bits in the second version,
/// but some programs write the name of the second version above a header of the first one. Empty
/// where the header has no layout.
std::optional<Layout> possibleLayout(const SurfaceSource& source) {
  const std::string_view bytes = source.bytes.substr(0, kSdfHeaderSize);
  if (bytes.size() < kSdfHeaderSize) return {};
  const Counts named = namedCounts(bytes);
  const Counts other = named == Counts::Of16Bits ? Counts::Of32Bits : Counts::Of16Bits;
  for (const std::endian order : {std::endian::little, std::endian::big})
    for (const Counts counts : {named, other}) {
      ByteReader reader(source, bytes, order);
      if (isPossible(readNumbers(reader, counts))) return Layout{counts, order};
    }
  return {};
}

SurfaceDraft readBinarySdf(const SurfaceSource& source) {
  const Layout layout = possibleLayout(source).value_or(Layout{namedCounts(source.bytes)});
  ByteReader reader(source, source.bytes, layout.order);
  const SdfHeader header = readNumbers(reader, layout.counts);
  SurfaceDraft draft = makeDraft(source, header);
  if (layout.order == std::endian::big)
    draft.facts.notes.emplace_back(
        "The numbers begin with their highest byte (big-endian), against the standard, and are "
        "read so.");
  const StoredType& type = kDataTypes[static_cast<std::size_t>(header.dataType)];
  takeHeights(source,
              {.bytes = reader.rest(),
               .type = type,
               .order = layout.order,
               .scale = header.zScale,
               .gaps = {.equal = type.lowest}},
              draft.grid);
  return draft;
}

// ---- As text -----------------------------------------------------------------------------------

/// Returns the decimal mark of numbers between blanks, which some programs write in the style of
/// the country. Numbers with both marks have a point, so that those with a comma are refused.
char decimalMark(std::string_view numbers) {
  return numbers.find(',') != numbers.npos && numbers.find('.') == numbers.npos ? ',' : '.';
}

class SdfTextReader {
 public:
  SdfTextReader(const SurfaceSource& source, std::string_view text)
      : source_(source), reader_(text) {}

  SurfaceDraft read() {
    readHeader();
    SdfHeader header;
    header.columns = whole("NumPoints");
    header.rows = whole("NumProfiles");
    header.xScale = real("Xscale");
    header.yScale = header.rows > 1 ? real("Yscale") : 0;
    header.zScale = real("Zscale");
    header.compression = static_cast<int>(whole("Compression", "0"));
    header.dataType = static_cast<int>(whole("DataType", "7"));
    header.checkType = static_cast<int>(whole("CheckType", "0"));
    SurfaceDraft draft = makeDraft(source_, header);
    HeightWords words;
    words.scale = header.zScale;
    words.end = '*';
    words.decimal = decimalMark(reader_.rest().substr(0, reader_.rest().find(words.end)));
    takeHeights(source_, reader_, words, draft.grid);
    return draft;
  }

 private:
  /// Reads up to the line with a star.
  void readHeader() {
    reader_.nextLine();  // version
    while (true) {
      if (reader_.atEnd()) source_.fail(message("the header of the {} file has no end", "SDF"));
      const std::string_view line = reader_.nextLine();
      if (line.starts_with('*')) return;
      const std::size_t at = line.find_first_of("= \t");
      if (line.empty() || line.front() == ';' || at == std::string_view::npos) continue;
      std::string_view value = trimmedBlanks(line.substr(at));
      if (value.starts_with('=')) value = trimmedBlanks(value.substr(1));
      values_[lowerCase(line.substr(0, at))] = value;
    }
  }

  std::string_view value(const std::string& key, std::string_view fallback) const {
    const auto found = values_.find(lowerCase(key));
    if (found != values_.end()) return found->second;
    if (fallback.empty()) source_.failWithout(key);
    return fallback;
  }
  double real(const std::string& key, std::string_view fallback = {}) const {
    const std::string_view text = value(key, fallback);
    const auto number = parseFiniteNumber(text, decimalMark(text));
    if (!number) source_.fail(message("{} in the header is not a number", key));
    return *number;
  }
  std::int64_t whole(const std::string& key, std::string_view fallback = {}) const {
    std::int64_t number = 0;
    if (!readNumber(value(key, fallback), number) || number < 0 || number > INT32_MAX)
      source_.fail(message("{} in the header is not a number", key));
    return number;
  }

  const SurfaceSource& source_;
  WordReader reader_;
  std::map<std::string, std::string_view> values_;
};

// ---- Recognition -------------------------------------------------------------------------------

/// Returns whether the first line is a version such as "aISO-1.0" or "aNPL-V1.0" and the
/// manufacturer follows.
bool isTextSdf(std::string_view bytes) {
  constexpr std::size_t kLongestVersion = 32, kLinesLookedAt = 4;
  WordReader reader(bytes.substr(0, 1024));
  const std::string_view version = reader.nextLine();
  if (version.size() < 4 || version.size() > kLongestVersion || lowerCase(version).front() != 'a')
    return false;
  for (std::size_t i = 0; i < kLinesLookedAt; ++i)
    if (lowerCase(reader.nextLine()).starts_with("manufacid")) return true;
  return false;
}

/// Returns whether the texts of the header are printable and its numbers possible.
bool isBinarySdf(const SurfaceSource& source) {
  const std::string_view bytes = source.bytes;
  if (!bytes.starts_with('b') || bytes.size() < kSdfHeaderSize) return false;
  const std::string_view texts = bytes.substr(0, kMagicSize + kIdentity + kDates);
  const bool arePrintable = std::ranges::all_of(
      texts, [](char letter) { return letter == 0 || (letter >= ' ' && letter <= '~'); });
  const std::string_view dates = texts.substr(kMagicSize + kIdentity);
  return arePrintable && std::ranges::any_of(dates, isDigit) && possibleLayout(source);
}

bool hasStandardName(std::string_view bytes, char kind) {
  return bytes.starts_with(kind) &&
         (bytes.substr(1).starts_with("ISO-") || bytes.substr(1).starts_with("BCR-"));
}

}  // namespace

bool isSdf(const SurfaceSource& source) {
  const std::string_view bytes = withoutByteOrderMark(source.bytes);
  return hasStandardName(bytes, 'a') || hasStandardName(source.bytes, 'b') || isTextSdf(bytes) ||
         isBinarySdf(source);
}

SurfaceDraft readSdf(const SurfaceSource& source) {
  if (source.bytes.starts_with('b')) return readBinarySdf(source);
  const DecodedText decoded(source.bytes, source.name);
  return SdfTextReader(source, decoded.text).read();
}

}  // namespace asperity
