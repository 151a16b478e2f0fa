// Surface Data File (ISO 25178-71; BCR before it): aISO-1.0 and aISO-2.0 as text, bISO-1.0 and
// bISO-2.0 as bytes, whose counts of points have 16 and 32 bits. Heights are numbers times Zscale,
// in metres; BAD, the lowest integer or the lowest float marks a point that was not measured.
#include <limits>
#include <map>
#include <string>

#include "core/base/number_text.h"
#include "core/base/text_encoding.h"
#include "core/base/text_number.h"
#include "core/measured/byte_reader.h"
#include "core/measured/surface_draft.h"

namespace asperity {
namespace {

constexpr std::size_t kMagicSize = 8;

/// Codes of DataType. The unsigned ones are of BCR alone.
enum class DataType { Uint8, Uint16, Uint32, Float, Int8, Int16, Int32, Double };

constexpr std::size_t kSizes[] = {1, 2, 4, 4, 1, 2, 4, 8};

struct Header {
  std::int64_t columns = 0, rows = 0;
  double xScale = 0, yScale = 0, zScale = 0;
  int compression = 0, dataType = 0, checkType = 0;
};

/// The grid of the header, without heights.
SurfaceDraft draftOf(const SurfaceSource& source, const Header& header) {
  const auto requirePositive = [&source](std::string_view key, double value) {
    if (!(value > 0) || !std::isfinite(value))
      source.fail(message("{} in the header is not a number above 0", key));
  };
  requirePositive("NumPoints", static_cast<double>(header.columns));
  requirePositive("NumProfiles", static_cast<double>(header.rows));
  requirePositive("Xscale", header.xScale);
  if (header.rows > 1) requirePositive("Yscale", header.yScale);
  if (header.zScale == 0 || !std::isfinite(header.zScale))
    source.fail(message("{} in the header is not a number above 0", "Zscale"));
  if (header.compression != 0)
    source.fail(message("is compressed, which {} files are not read with", "SDF"));
  if (header.dataType < 0 || header.dataType > static_cast<int>(DataType::Double))
    source.fail(message("{} {} is not known", "DataType", header.dataType));
  SurfaceDraft draft;
  draft.facts.format = "sdf";
  draft.grid.columns = header.columns;
  draft.grid.rows = header.rows;
  draft.grid.columnSpacing = header.xScale;
  draft.grid.rowSpacing = header.yScale;
  draft.positionUnit = draft.heightUnit = StatedUnit{"m", 1};
  return draft;
}

template <class Number>
void takeHeights(const SurfaceSource& source, std::string_view data, double scale,
                 SurfaceDraft& draft) {
  constexpr bool isSigned = std::numeric_limits<Number>::is_signed;
  const auto bytes =
      static_cast<std::size_t>(draft.grid.columns * draft.grid.rows) * sizeof(Number);
  appendHeights<Number>(
      source, data.substr(0, bytes), false, scale, draft.grid.height,
      [](Number number) { return isSigned && number == std::numeric_limits<Number>::lowest(); });
}

SurfaceDraft readBinary(const SurfaceSource& source) {
  const bool isSecond = source.bytes.substr(0, kMagicSize).ends_with("2.0");
  ByteReader reader(source, source.bytes);
  constexpr std::size_t kIdentity = 10, kDates = 24;
  reader.skip(kMagicSize + kIdentity + kDates);
  Header header;
  header.columns = isSecond ? reader.read<std::uint32_t>() : reader.read<std::uint16_t>();
  header.rows = isSecond ? reader.read<std::uint32_t>() : reader.read<std::uint16_t>();
  header.xScale = reader.read<double>();
  header.yScale = reader.read<double>();
  header.zScale = reader.read<double>();
  reader.read<double>();  // Zresolution
  header.compression = reader.read<std::uint8_t>();
  header.dataType = reader.read<std::uint8_t>();
  header.checkType = reader.read<std::uint8_t>();
  SurfaceDraft draft = draftOf(source, header);
  const std::string_view data = source.bytes.substr(reader.place());
  requireSize(source, header.columns, header.rows, data.size(),
              kSizes[static_cast<std::size_t>(header.dataType)]);
  switch (static_cast<DataType>(header.dataType)) {
    case DataType::Uint8:
      takeHeights<std::uint8_t>(source, data, header.zScale, draft);
      break;
    case DataType::Uint16:
      takeHeights<std::uint16_t>(source, data, header.zScale, draft);
      break;
    case DataType::Uint32:
      takeHeights<std::uint32_t>(source, data, header.zScale, draft);
      break;
    case DataType::Float:
      takeHeights<float>(source, data, header.zScale, draft);
      break;
    case DataType::Int8:
      takeHeights<std::int8_t>(source, data, header.zScale, draft);
      break;
    case DataType::Int16:
      takeHeights<std::int16_t>(source, data, header.zScale, draft);
      break;
    case DataType::Int32:
      takeHeights<std::int32_t>(source, data, header.zScale, draft);
      break;
    case DataType::Double:
      takeHeights<double>(source, data, header.zScale, draft);
      break;
  }
  return draft;
}

// ---- As text -----------------------------------------------------------------------------------

class TextReader {
 public:
  explicit TextReader(const SurfaceSource& source) : source_(source) {
    decodeText(source.bytes, source.name, decoded_);
    rest_ = decoded_.text;
  }

  SurfaceDraft read() {
    readHeader();
    Header header;
    header.columns = whole("NumPoints");
    header.rows = whole("NumProfiles");
    header.xScale = real("Xscale");
    header.yScale = header.rows > 1 ? real("Yscale") : 0;
    header.zScale = real("Zscale");
    header.compression = static_cast<int>(whole("Compression", "0"));
    header.dataType = static_cast<int>(whole("DataType", "7"));
    header.checkType = static_cast<int>(whole("CheckType", "0"));
    SurfaceDraft draft = draftOf(source_, header);
    // A digit and a blank are the least that a height takes.
    requireSize(source_, header.columns, header.rows, rest_.size() + 1, 2);
    readHeights(header.zScale, draft.grid);
    return draft;
  }

 private:
  static constexpr std::string_view kBlanks = " \t\r\n";

  /// Up to the line of a star.
  void readHeader() {
    nextLine();  // version
    while (true) {
      if (rest_.empty()) source_.fail(message("the header of the {} file has no end", "SDF"));
      const std::string_view line = nextLine();
      if (line.starts_with('*')) return;
      const std::size_t at = line.find_first_of("= \t");
      if (line.empty() || line.front() == ';' || at == std::string_view::npos) continue;
      std::string_view value = trimmedBlanks(line.substr(at));
      if (value.starts_with('=')) value = trimmedBlanks(value.substr(1));
      values_[lowerCase(line.substr(0, at))] = value;
    }
  }

  std::string_view nextLine() {
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    const std::string_view line = trimmedBlanks(rest_.substr(0, end));
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++line_;
    return line;
  }

  std::string_view value(const std::string& key, std::string_view fallback) const {
    const auto found = values_.find(lowerCase(key));
    if (found != values_.end()) return found->second;
    if (fallback.empty()) source_.fail(message("the header has no {}", key));
    return fallback;
  }
  double real(const std::string& key, std::string_view fallback = {}) const {
    double number = 0;
    if (!readTextNumber(value(key, fallback), '.', number))
      source_.fail(message("{} in the header is not a number", key));
    return number;
  }
  std::int64_t whole(const std::string& key, std::string_view fallback = {}) const {
    std::int64_t number = 0;
    if (!readNumber(value(key, fallback), number) || number < 0 || number > INT32_MAX)
      source_.fail(message("{} in the header is not a number", key));
    return number;
  }

  void readHeights(double scale, Topography& grid) {
    const auto count = static_cast<std::size_t>(grid.columns * grid.rows);
    grid.height.reserve(count);
    constexpr std::size_t kStep = std::size_t{1} << 18;
    while (grid.height.size() < count) {
      if (grid.height.size() % kStep == 0)
        source_.report(static_cast<double>(grid.height.size()) / static_cast<double>(count));
      const std::string_view word = nextWord();
      if (word.empty() || word.front() == '*')
        source_.fail(
            message("line {}: ends after {} of {} heights", line_ + 1, grid.height.size(), count));
      const Field field = readField(word, '.');
      if (field.kind == FieldKind::Text || field.kind == FieldKind::Flag)
        source_.fail(
            message("line {}: height {} is not a number", line_ + 1, grid.height.size() + 1));
      const bool isGap = field.kind == FieldKind::Missing || !std::isfinite(field.value * scale);
      grid.height.push_back(isGap ? std::numeric_limits<double>::quiet_NaN() : field.value * scale);
    }
    const std::string_view after = nextWord();
    if (!after.empty() && after.front() != '*' && readField(after, '.').kind == FieldKind::Number)
      source_.fail(
          message("line {}: has more than the {} heights that the header says", line_ + 1, count));
  }

  std::string_view nextWord() {
    while (!rest_.empty() && kBlanks.find(rest_.front()) != std::string_view::npos) {
      line_ += rest_.front() == '\n' ? 1 : 0;
      rest_.remove_prefix(1);
    }
    std::size_t end = 0;
    while (end < rest_.size() && kBlanks.find(rest_[end]) == std::string_view::npos) ++end;
    const std::string_view word = rest_.substr(0, end);
    rest_.remove_prefix(end);
    return word;
  }

  const SurfaceSource& source_;
  DecodedText decoded_;
  std::string_view rest_;
  std::size_t line_ = 0;
  std::map<std::string, std::string_view> values_;
};

}  // namespace

SurfaceDraft readSdf(const SurfaceSource& source) {
  const std::string_view magic = source.bytes.substr(0, kMagicSize);
  const bool isBinary = magic.starts_with("bISO-") || magic.starts_with("bBCR-");
  return isBinary ? readBinary(source) : TextReader(source).read();
}

}  // namespace asperity
