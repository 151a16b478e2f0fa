// Reads the heights of a text grid of ESRI as its header says: "ncols" and "nrows" count them, and
// the lines may be wrapped anywhere.
#include <algorithm>
#include <vector>

#include "core/base/text_encoding.h"
#include "core/base/text_header.h"
#include "core/base/text_number.h"
#include "core/measured/text_surface.h"
#include "core/measured/word_reader.h"

namespace asperity {
namespace {

/// Returns the text without the lines above the first one that begins with a number.
std::string_view fromFirstNumber(std::string_view text) {
  for (std::string_view rest = text; !rest.empty(); text = rest)
    if (beginsAsNumber(takeLine(rest))) break;
  return text;
}

class EsriReader {
 public:
  EsriReader(const DecodedText& decoded, const SurfaceSource& source)
      : source_(source), rest_(decoded.text), whole_(decoded.text.size()) {
    table_.encoding = decoded.encoding;
    table_.dialect = detectDialect(fromFirstNumber(decoded.text));
  }

  TextTable read() {
    table_.blocks.emplace_back();
    while (readLine()) {
    }
    requireStart();
    if (block().values.size() < points_)
      source_.fail(
          message("line {}: ends after {} of {} heights", number_, block().values.size(), points_));
    requireRows();
    return std::move(table_);
  }

 private:
  TextBlock& block() { return table_.blocks.front(); }

  /// Returns false at the end of the text and after the last height.
  bool readLine() {
    if (rest_.empty()) return false;
    const TextLine line{takeLine(rest_), ++number_};
    if (trimmedBlanks(line.text).empty()) return true;
    splitFields(line.text, table_.dialect.separator, fields_);
    while (fields_.size() > 1 && trimmedBlanks(fields_.back()).empty()) fields_.pop_back();
    const bool isText = isComment(line.text) ||
                        readField(fields_.front(), table_.dialect.decimal).kind == FieldKind::Text;
    if (points_ == 0 && isText) {
      block().header.push_back(parseEntry(line, table_.dialect));
      return true;
    }
    if (isComment(line.text)) return true;
    requireStart();
    if (isText && block().values.size() == points_) return false;
    widths_.push_back(fields_.size());
    for (const std::string_view text : fields_) {
      std::vector<double>& heights = block().values;
      const double height =
          parseHeight(source_, line.number, text, heights.size(), table_.dialect.decimal);
      if (heights.size() == points_)
        source_.fail(message("line {}: has more than the {} heights that the header says",
                             line.number, points_));
      if (heights.size() % block().columns.size() == 0)
        block().lines.push_back(static_cast<std::uint32_t>(line.number));
      source_.reportPoint(heights.size(), points_);
      heights.push_back(height);
    }
    return true;
  }

  /// Takes the numbers of columns and rows from the header, before the first height.
  void requireStart() {
    if (points_ > 0) return;
    const auto count = [this](std::string_view key) {
      const auto number = parseQuantity(table_.entry(key, block()));
      const auto whole = number ? wholeNumber(number->number) : std::nullopt;
      if (!whole || *whole < 1) source_.failNotAboveZero(key);
      return *whole;
    };
    const std::int64_t columns = count("ncols"), rows = count("nrows");
    // A height takes at least a digit and a blank.
    requireSize(source_, columns, rows, whole_ + 1, 2);
    block().columns.resize(static_cast<std::size_t>(columns));
    block().rows = static_cast<std::size_t>(rows);
    points_ = block().columns.size() * block().rows;
    block().values.reserve(points_);
  }

  /// Throws InputError where the lines are rows of the grid with columns and rows exchanged.
  void requireRows() {
    const std::size_t columns = block().columns.size(), rows = block().rows;
    const bool isExchanged =
        columns != rows && widths_.size() == columns &&
        std::ranges::all_of(widths_, [rows](std::size_t width) { return width == rows; });
    if (isExchanged)
      source_.fail(message("the header says {} x {} pixels; the file has {} x {} numbers", columns,
                           rows, rows, columns));
  }

  const SurfaceSource& source_;
  std::string_view rest_;
  std::size_t whole_;  // bytes
  TextTable table_;
  std::size_t points_ = 0;  // 0: the header goes on
  std::size_t number_ = 0;  // of the line
  std::vector<std::string_view> fields_;
  std::vector<std::size_t> widths_;  // of the lines of heights
};

}  // namespace

bool isEsriGrid(std::string_view bytes) {
  constexpr std::size_t kHeader = 4096, kMaxLines = 40;
  std::string_view rest = bytes.substr(0, kHeader);
  bool hasColumns = false, hasRows = false;
  for (std::size_t i = 0; i < kMaxLines && !rest.empty(); ++i) {
    const std::string line = lowerCase(withoutCommentMark(takeLine(rest), {}));
    if (beginsAsNumber(line)) break;
    hasColumns = hasColumns || line.starts_with("ncols");
    hasRows = hasRows || line.starts_with("nrows");
  }
  return hasColumns && hasRows;
}

TextTable readEsriGrid(const SurfaceSource& source) {
  const DecodedText decoded(source.bytes, source.name);
  return EsriReader(decoded, source).read();
}

}  // namespace asperity
