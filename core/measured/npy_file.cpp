// Arrays of NumPy (NEP 1, "A simple file format for NumPy arrays"): a magic word, the version, the
// length of the header, a Python dictionary of the type, the order and the shape, and the numbers.
// The first index counts the rows. The file states neither units nor how far its points are apart.
#include <algorithm>
#include <array>
#include <string>

#include "core/base/number_text.h"
#include "core/base/text.h"
#include "core/base/text_number.h"
#include "core/measured/byte_reader.h"
#include "core/measured/surface_draft.h"

namespace asperity {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view kNpyMagic = "\x93NUMPY";

/// A type of numbers by its word without the order of bytes.
struct NumberType {
  std::string_view word;
  StoredType stored;
};

constexpr std::array kTypes{
    NumberType{"f4", kStored<float>},        NumberType{"f8", kStored<double>},
    NumberType{"i1", kStored<std::int8_t>},  NumberType{"u1", kStored<std::uint8_t>},
    NumberType{"i2", kStored<std::int16_t>}, NumberType{"u2", kStored<std::uint16_t>},
    NumberType{"i4", kStored<std::int32_t>}, NumberType{"u4", kStored<std::uint32_t>},
    NumberType{"i8", kStored<std::int64_t>}, NumberType{"u8", kStored<std::uint64_t>}};

/// The dictionary of the header.
class NpyHeader {
 public:
  NpyHeader(const SurfaceSource& source, std::string_view text) : source_(source), text_(text) {}

  /// Returns the text after a key and its colon, up to the end of the header.
  std::string_view value(const std::string& key) const {
    for (const std::string& quoted : {"'" + key + "'", "\"" + key + "\""})
      if (const std::size_t at = text_.find(quoted); at != text_.npos) {
        const std::string_view rest = trimmedBlanks(text_.substr(at + quoted.size()));
        if (rest.starts_with(':')) return trimmedBlanks(rest.substr(1));
      }
    source_.failWithout(key);
  }

  /// Returns the type of the numbers, "<f8"; what is no word in quotes as it stands.
  std::string_view type() const {
    const std::string_view text = value("descr");
    if (text.empty()) source_.failWithout("descr");
    const std::size_t end = text.find(text.front(), 1);
    const bool isQuoted = (text.front() == '\'' || text.front() == '"') && end != text.npos;
    return isQuoted ? text.substr(1, end - 1) : text.substr(0, text.find(", 'fortran_order'"));
  }

  bool isFortran() const { return value("fortran_order").starts_with("True"); }

  std::vector<std::int64_t> shape() const {
    std::string_view text = value("shape");
    const std::size_t end = text.find(')');
    if (!text.starts_with('(') || end == text.npos) source_.failWithout("shape");
    std::vector<std::int64_t> counts;
    for (std::string_view part : splitText(text.substr(1, end - 1), ",")) {
      part = trimmedBlanks(part);
      if (part.empty()) continue;  // after the comma of "(3,)"
      if (!readNumber(part, counts.emplace_back()) || counts.back() < 1)
        source_.failNotAboveZero("shape");
    }
    return counts;
  }

 private:
  const SurfaceSource& source_;
  std::string_view text_;
};

}  // namespace

bool isNpy(const SurfaceSource& source) {
  return source.bytes.starts_with(kNpyMagic);
}

SurfaceDraft readNpy(const SurfaceSource& source) {
  if (!isNpy(source)) source.fail(message("is not a {} file", "NPY"));
  ByteReader reader(source, source.bytes);
  reader.skip(kNpyMagic.size());
  const auto version = reader.read<std::uint8_t>();
  reader.skip(1);
  if (version < 1 || version > 3)
    source.fail(message("is of version {}; 1 to 3 are read", version));
  const std::size_t length =
      version == 1 ? reader.read<std::uint16_t>() : reader.read<std::uint32_t>();
  const NpyHeader header(source, reader.take(length));

  const std::string_view word = header.type();
  const auto* const type = std::ranges::find_if(kTypes, [&](const NumberType& one) {
    return word.size() == 3 && "<>|="sv.find(word.front()) != word.npos && word.ends_with(one.word);
  });
  if (type == kTypes.end())
    source.fail(
        message("holds an array of the type {}; floating-point numbers of 4 or 8 "
                "bytes and whole numbers of 1 to 8 bytes are read",
                Message::name(shortened(word))));
  const std::vector<std::int64_t> shape = header.shape();
  if (shape.empty() || shape.size() > 2)
    source.fail(message("holds an array of {} dimensions; heights have two, or one of a profile",
                        shape.size()));
  // Of two rows or columns one would be positions.
  if (shape.size() == 2 && std::ranges::min(shape) == 2)
    source.fail(
        message("holds an array of {} x {} numbers; it should have heights alone, whose "
                "distance is surface.point_spacing",
                shape.front(), shape.back()));

  SurfaceDraft draft;
  draft.hasPositions = false;
  const bool isColumnByColumn = shape.size() == 2 && header.isFortran();
  Topography stored;
  stored.columns = isColumnByColumn ? shape.front() : shape.back();
  stored.rows = shape.size() == 1 ? 1 : isColumnByColumn ? shape.back() : shape.front();
  takeHeights(source,
              {.bytes = reader.rest(),
               .type = type->stored,
               .order = word.front() == '>' ? std::endian::big : std::endian::little},
              stored);
  reader.skip(stored.height.size() * type->stored.size);
  if (reader.left() > 0) source.fail(message("has {} bytes after its array", reader.left()));
  draft.grid = isColumnByColumn ? transposed(stored) : std::move(stored);
  if (draft.grid.columns == 1) draft.grid = transposed(draft.grid);  // a profile as a column
  draft.grid.columnSpacing = draft.grid.rowSpacing = 1;
  return draft;
}

}  // namespace asperity
