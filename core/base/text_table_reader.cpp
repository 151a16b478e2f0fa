// Reads the lines of a text table, block by block.
#include "core/base/text_table.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "core/base/column_units.h"
#include "core/base/input_error.h"
#include "core/base/statistics.h"
#include "core/base/text.h"
#include "core/base/text_clause.h"
#include "core/base/text_encoding.h"
#include "core/base/text_header.h"
#include "core/base/text_number.h"
#include "core/base/text_row.h"

namespace asperity {
namespace {

constexpr std::size_t kMaxNumbers = std::size_t{1} << 27;
constexpr std::size_t kMaxHeaderLines = 10000;               // that are kept for one block
constexpr std::size_t kProgressStep = std::size_t{1} << 20;  // bytes

class TableReader {
 public:
  TableReader(const JoinedText& text, const std::string& name, const TextTableOptions& options,
              TextTable& table)
      : whole_(text.text),
        rest_(text.text),
        breaks_(text.breaks),
        name_(name),
        options_(options),
        table_(table),
        rows_(table.dialect, options) {}

  void read() {
    while (!rest_.empty()) {
      const TextLine line{takeLine(rest_), ++number_};
      const std::size_t done = whole_.size() - rest_.size();
      if (done >= nextReport_) report();
      take(line);
      for (; !breaks_.empty() && breaks_.front() < done; breaks_ = breaks_.subspan(1)) ++number_;
    }
    for (const TextLine& line : above_) addEntry(line, table_.trailer);
    if (table_.blocks.empty()) refuseWithoutRows();
    for (const TextLine& line : above_)
      if (!isComment(line.text) && beginsAsNumber(line.text)) leaveOut(line);
    endBlock();
  }

 private:
  [[noreturn]] void fail(const Message& message) const { throw InputError(name_, "", message); }

  /// Throws InputError that names the line most similar to a row.
  [[noreturn]] void refuseWithoutRows() const {
    std::vector<std::pair<std::size_t, TextRow>> rows;
    for (const TextLine& line : above_)
      if (!isComment(line.text)) rows.emplace_back(line.number, rows_.read(line.text));
    std::erase_if(rows, [](const auto& numbered) { return numbered.second.size() < 2; });
    for (const auto& [number, row] : rows)
      for (std::size_t i = 0; i < row.size(); ++i)
        if (row.is(i, FieldKind::Text) &&
            row.fields[i].find_first_of("0123456789") != std::string_view::npos)
          fail(message("has no rows of numbers; line {}: '{}' is not a number", number,
                       shortened(trimmedField(row.fields[i]))));
    // A row that would be one with a number in its empty field.
    for (const auto& [number, row] : rows)
      for (std::size_t i = 0; i < row.size(); ++i)
        if (row.is(i, FieldKind::Missing))
          fail(message("has no rows of numbers; line {}: the value in column {} is missing", number,
                       i + 1));
    // A name and numbers behind it, as where each row is a quantity.
    for (const auto& [number, row] : rows)
      if (row.size() > 2 && row.is(0, FieldKind::Text) && row.areNumbers(1, row.size()))
        fail(
            message("has no rows of numbers; line {} has '{}' in front of its numbers: write each "
                    "quantity in a column, with its name above it",
                    number, shortened(trimmedField(row.fields[0]))));
    fail("has no rows of numbers");
  }

  void report() {
    nextReport_ += kProgressStep;
    if (options_.progress)
      options_.progress(1 - static_cast<double>(rest_.size()) / static_cast<double>(whole_.size()));
  }

  void take(const TextLine& line) {
    if (isOpen_ && appendPlain(line)) return;
    if (trimmedBlanks(line.text).empty()) {
      isDirect_ = false;
      ++blankLines_;
      return;
    }
    if (isComment(line.text)) return keep(line);
    row_ = rows_.read(line.text);
    if (isOpen_ && fits()) return append(line);
    if (isOpen_ && isRemark(line)) return keep(line);
    if (isOpen_) refuseAmidRows(line);
    if (startsBlock(line)) return start(line);
    keep(line);
  }

  /// Keeps a line that is no row; it may belong to a header.
  void keep(const TextLine& line) {
    if (above_.size() < kMaxHeaderLines) above_.push_back(line);
  }

  /// Returns whether rows continue after kept lines: comments may stand between rows, but a header
  /// begins a new block.
  bool goesOn() const {
    return std::ranges::all_of(above_, [this](const TextLine& line) {
      return (isComment(line.text) || isRemark(line)) &&
             parseEntry(line, table_.dialect).key.empty() && !isNextHeading(line);
    });
  }

  /// Returns whether a line is the heading of the next profile, as one stands above the open block.
  bool isNextHeading(const TextLine& line) const {
    return !block().header.empty() &&
           isNextProfile(block().header.back().written, parseEntry(line, table_.dialect).written);
  }

  /// Returns whether a line begins with a mark of comments that are known as such only between
  /// rows. An empty first field is none.
  bool isRemark(const TextLine& line) const {
    const std::string_view text = trimmedBlanks(line.text);
    if (!text.starts_with(';')) return withoutRemarkMark(text).size() != text.size();
    const std::vector<std::string_view> fields = splitFields(text, table_.dialect.separator);
    return table_.dialect.separator != TextDialect::Separator::Semicolon ||
           fields.size() != block().columns.size();
  }

  TextBlock& block() const { return table_.blocks.back(); }

  bool appendPlain(const TextLine& line) {
    if (hasTexts_) return false;
    numbers_.resize(block().columns.size());
    if (!readPlainRow(line.text, table_.dialect, numbers_)) return false;
    if (!above_.empty() && !goesOn()) return false;  // begins a block, the slow way
    hasNumbers_.assign(numbers_.size(), true);
    row_.cells.clear();
    addRow(line);
    return true;
  }

  void leaveOut(const TextLine& line) {
    table_.leftOut.push_back(static_cast<std::uint32_t>(line.number));
  }

  void addRow(const TextLine& line) {
    if (blankLines_ > 0 && block().rows > 0)
      block().blanks.emplace_back(block().rows, above_.empty() ? blankLines_ : 0);
    blankLines_ = 0;
    above_.clear();
    isDirect_ = true;
    if (count_ + numbers_.size() > kMaxNumbers)
      fail(message("has more than {} numbers", kMaxNumbers));
    count_ += numbers_.size();
    for (std::size_t i = 0; i < block().cells.size(); ++i) {
      std::vector<TextCell>& cells = block().cells[i];
      const bool isThere = row_.isCell(i) && !block().columns[i].isText;
      if (!isThere && cells.empty()) continue;
      cells.resize(block().rows);
      cells.push_back(isThere ? row_.cells[i] : TextCell{});
    }
    block().values.insert(block().values.end(), numbers_.begin(), numbers_.end());
    block().lines.push_back(static_cast<std::uint32_t>(line.number));
    ++block().rows;
  }

  /// Returns the line after this one as a row.
  TextRow nextRow() const {
    std::string_view rest = rest_;
    return rows_.read(takeLine(rest));
  }

  /// Returns whether the fields are a row of the open block.
  bool fits() const {
    const std::vector<TextColumn>& columns = block().columns;
    std::size_t size = row_.size();
    while (size > columns.size() && trimmedBlanks(row_.fields[size - 1]).empty()) --size;
    if (size > columns.size()) return false;
    for (std::size_t i = size; i < columns.size(); ++i)
      if (!columns[i].isText) return false;
    bool anyValue = false;
    for (std::size_t i = 0; i < size; ++i) {
      if (columns[i].isText) continue;
      if (row_.is(i, FieldKind::Text)) {
        if (hasNumbers_[i]) return false;
        continue;  // a column of remarks, empty so far
      }
      anyValue = anyValue || !trimmedBlanks(row_.fields[i]).empty();
    }
    // A line of separators alone is a row of gaps if it stands among rows.
    return anyValue || (size == columns.size() && nextLineFits());
  }

  /// Returns whether the next line that is not blank is a row of the open block.
  bool nextLineFits() const {
    std::string_view rest = rest_;
    while (!rest.empty()) {
      const std::string_view line = takeLine(rest);
      if (trimmedBlanks(line).empty()) continue;
      TextRow row = rows_.read(line);
      const std::vector<TextColumn>& columns = block().columns;
      while (row.size() > columns.size() && trimmedBlanks(row.fields.back()).empty())
        row.removeLast();
      if (row.size() != columns.size()) return false;
      for (std::size_t i = 0; i < row.size(); ++i)
        if (row.is(i, FieldKind::Text) && !columns[i].isText && hasNumbers_[i]) return false;
      return row.count(FieldKind::Number) > 0;
    }
    return false;
  }

  /// Returns whether the next line has numbers and texts where this one has them; values may be
  /// missing.
  bool nextLineIsAlike() const {
    const TextRow next = nextRow();
    if (next.size() != row_.size()) return false;
    for (std::size_t i = 0; i < next.size(); ++i)
      if (next.values[i].kind != row_.values[i].kind && !next.is(i, FieldKind::Missing))
        return false;
    return next.count(FieldKind::Number) > 0;
  }

  /// Returns whether a field is a number or looks like one; "1. Ra" in a list does not.
  bool isLikeNumber(std::string_view field) const {
    return readField(field, table_.dialect.decimal).kind == FieldKind::Number ||
           (beginsAsNumber(field) &&
            trimmedField(field).find_first_of(" \t") == std::string_view::npos);
  }

  /// Returns whether the next line has this number of fields and begins like a number, as damaged
  /// rows do.
  bool nextLineResembles(std::size_t size) const {
    const TextRow next = nextRow();
    return next.size() == size && isLikeNumber(next.fields.front());
  }

  /// Returns whether words stand behind a row of numbers with names, right above the next one.
  bool isRowWithWords() const {
    const std::size_t columns = block().columns.size();
    const std::string_view below = rest_.substr(0, rest_.find('\n'));
    return block().hasNames() && row_.size() > columns && row_.areNumbers(0, columns) &&
           !trimmedBlanks(below.substr(0, below.find('\r'))).empty() && nextLineFits();
  }

  /// Throws InputError for a row with a wrong field or another width where rows continue. Several
  /// such rows are an error, too: results that a program writes below its rows begin with a word.
  void refuseAmidRows(const TextLine& line) const {
    constexpr std::size_t kManyRows = 10;  // of no header such as "60 40"
    const std::vector<TextColumn>& columns = block().columns;
    const bool isEntry = keyEnd(line.text) != std::string_view::npos;
    const bool isRow = std::ranges::any_of(row_.fields, beginsAsNumber);
    if (!isRow || !above_.empty() || isNextHeading(line)) return;
    const bool hasWords = isRowWithWords();
    if (isEntry && !hasWords) return;
    const bool isWide = row_.size() != columns.size();
    const bool goOnBroken = isDirect_ && isLikeNumber(row_.fields.front()) &&
                            (!isWide || block().rows >= kManyRows) &&
                            nextLineResembles(row_.size());
    if (!goOnBroken && !nextLineFits()) return;
    if (isWide && (row_.count(FieldKind::Text) == 0 || hasWords))
      fail(row_.size() == 1 ? message("line {}: has one field where the lines before have {}",
                                      line.number, columns.size())
                            : message("line {}: has {} fields where the lines before have {}",
                                      line.number, row_.size(), columns.size()));
    for (std::size_t i = 0; i < std::min(columns.size(), row_.size()); ++i)
      if (row_.is(i, FieldKind::Text) && !columns[i].isText)
        fail(message("line {}: '{}' in column {} is not a number", line.number,
                     shortened(trimmedField(row_.fields[i])), i + 1));
    if (isWide && !options_.keepsTexts) refuseWords(row_, line.number);
  }

  /// Throws InputError for a row that has words in the place of a number, and so more fields than
  /// the others: "0.5 no echo". Words behind all numbers of a row are none of these.
  void refuseWords(const TextRow& row, std::size_t number) const {
    std::size_t first = 0;
    while (row.is(first, FieldKind::Number)) ++first;
    std::size_t last = first;
    while (!table_.dialect.isExact() && last + 1 < row.size() &&
           !row.is(last + 1, FieldKind::Number))
      ++last;
    if (first >= block().columns.size()) return;
    const char* const begin = row.fields[first].data();
    const char* const end = row.fields[last].data() + row.fields[last].size();
    fail(message("line {}: '{}' in column {} is not a number", number,
                 shortened(std::string_view(begin, static_cast<std::size_t>(end - begin))),
                 first + 1));
  }

  /// Throws InputError where damaged rows alone separate the open block from a row with as many
  /// columns: the numbers are of one table, of which neither part may be left out.
  void refuseBrokenTable(const TextLine& next) const {
    if (options_.keepsTexts || above_.empty() || row_.size() != block().columns.size() ||
        row_.size() < 2)
      return;
    std::size_t number = block().lines.back();
    for (const TextLine& line : above_) {
      const TextRow row = rows_.read(line.text);
      const bool isNumbered = row.count(FieldKind::Number) > 0 && row.size() >= row_.size() &&
                              keyEnd(line.text) == std::string_view::npos;
      if (line.number != ++number || !isNumbered || isComment(line.text) || isNextHeading(line) ||
          !(isLikeNumber(row.fields.front()) || row.count(FieldKind::Number) + 1 >= row_.size()))
        return;
    }
    if (next.number != number + 1) return;
    const TextLine& line = above_.front();
    const TextRow row = rows_.read(line.text);
    if (row.count(FieldKind::Text) > 0) refuseWords(row, line.number);
    fail(message("line {}: has {} fields where the lines before have {}", line.number, row.size(),
                 row_.size()));
  }

  /// Turns a column without plain numbers so far into one of texts.
  void keepAsTexts(std::size_t column) {
    block().columns[column].isText = true;
    std::vector<std::string>& texts = block().texts[column];
    for (const TextCell& cell : block().cells[column]) texts.push_back(cell.text);
    texts.resize(block().rows);
    block().cells[column].clear();
  }

  void append(const TextLine& line) {
    if (!above_.empty() && !goesOn()) return start(line);
    const std::size_t columns = block().columns.size();
    numbers_.assign(columns, kNaN);
    for (std::size_t i = 0; i < columns; ++i) {
      const bool isThere = i < row_.size();
      if (isThere && row_.is(i, FieldKind::Text) && options_.keepsTexts &&
          !block().columns[i].isText) {
        keepAsTexts(i);
        hasTexts_ = true;
      }
      if (isThere && row_.is(i, FieldKind::Number) && !row_.isCell(i)) hasNumbers_[i] = true;
      if (block().columns[i].isText)
        block().texts[i].emplace_back(isThere ? trimmedField(row_.fields[i]) : std::string_view{});
      else if (isThere && !row_.is(i, FieldKind::Text))
        numbers_[i] = row_.values[i].value;
      if (isThere && row_.is(i, FieldKind::Flag)) flags_.push_back(block().rows * columns + i);
    }
    addRow(line);
  }

  /// Words such as "invalid" become 0 or 1 in a column of such words; among other numbers, and in
  /// tables with labels, where they say nothing about a quantity, they mark missing values.
  void clearFlags() {
    if (flags_.empty()) return;
    TextBlock& last = block();
    const std::size_t columns = last.columns.size();
    std::vector<bool> hasNumbers(columns);
    for (std::size_t i = 0; i < last.values.size(); ++i) {
      const double value = last.values[i];
      if (!std::isnan(value) && value != 0 && value != 1) hasNumbers[i % columns] = true;
    }
    for (const std::size_t index : flags_)
      if (hasNumbers[index % columns] || options_.keepsTexts) last.values[index] = kNaN;
    flags_.clear();
  }

  /// Turns blank lines within a single column into rows without a value, unless such a line follows
  /// every row.
  void fillBlankLines() {
    TextBlock& last = block();
    const bool isSpaced = last.blanks.size() + 1 >= last.rows;
    if (!options_.blankLinesAreGaps || last.columns.size() != 1 || isSpaced) return;
    const auto blanks = std::exchange(last.blanks, {});
    for (const auto& [row, count] : blanks) count_ += count;
    if (count_ > kMaxNumbers) fail(message("has more than {} numbers", kMaxNumbers));
    std::vector<double> values;
    std::vector<std::uint32_t> lines;
    auto blank = blanks.begin();
    for (std::size_t row = 0; row < last.rows; ++row) {
      if (blank != blanks.end() && blank->first == row) {
        values.insert(values.end(), blank->second, kNaN);
        lines.insert(lines.end(), blank->second, last.lines[row]);
        ++blank;
      }
      values.push_back(last.values[row]);
      lines.push_back(last.lines[row]);
    }
    last.rows = values.size();
    last.values = std::move(values);
    last.lines = std::move(lines);
  }

  void endBlock() {
    clearFlags();
    fillBlankLines();
    blankLines_ = 0;
  }

  /// Returns whether the fields can be the first row of a block.
  bool startsBlock(const TextLine& line) {
    if (row_.count(FieldKind::Number) == 0) return false;
    // "Missing data 12" states a number.
    const bool isOfWords = row_.is(0, FieldKind::Missing) && !table_.dialect.isExact() &&
                           row_.fields[0].find_first_of(" \t") != std::string_view::npos;
    if (isOfWords && row_.count(FieldKind::Number) == 1) return false;
    if (row_.count(FieldKind::Text) == 0 && row_.cells.empty()) return true;
    // "Load; 30 N" states something of the rows below.
    const std::size_t fewestCells = options_.keepsTexts ? 2 : 1;
    const auto cells = static_cast<std::size_t>(
        std::ranges::count_if(row_.cells, [](const TextCell& cell) { return !cell.text.empty(); }));
    if (row_.count(FieldKind::Number) == cells && (cells < fewestCells || !nextLineIsAlike()))
      return false;
    if (!options_.keepsTexts) return row_.count(FieldKind::Text) == 0;
    const auto named = namedColumns(above_, table_.dialect, row_.values);
    // "mm/s; 1" are the units of a velocity and of a pure number, except below "v;unit;mu".
    const auto ones = static_cast<std::size_t>(std::ranges::count(row_.fields, "1"));
    if (std::ranges::none_of(named, isNameOfUnits) && ones == row_.count(FieldKind::Number) &&
        areUnits({row_.fields.begin(), row_.fields.end()}))
      return false;
    // The colon of a time of day ends no key.
    const auto hasKey = [](std::string_view field) {
      return keyEnd(field) != std::string_view::npos && !isDateOrTime(field);
    };
    const bool hasTime = std::ranges::any_of(row_.fields, isDateOrTime);
    if (hasTime ? std::ranges::any_of(row_.fields, hasKey)
                : keyEnd(line.text) != std::string_view::npos)
      return false;
    // ";1 mm/s;10 mm/s" above "20 \u00B0C;0.5;0.7", where the unit of the first column names it
    return std::none_of(named.begin() + (row_.isCell(0) && named.size() > 1 ? 1 : 0), named.end(),
                        [](const TextColumn& column) { return column.name.empty(); });
  }

  /// Returns a field without a quotation mark that does not end: the number of "\"0;1.3".
  static std::string_view withoutOpenQuote(std::string_view field) {
    field = trimmedBlanks(field);
    return field.starts_with('"') && field.find('"', 1) == field.npos ? field.substr(1) : field;
  }

  /// Returns whether a line above a first row has equally many fields and begins with a number, or
  /// equally many numbers and words behind them.
  bool isDamagedRow(const TextLine& above) const {
    const std::vector<std::string_view> fields = rows_.split(above.text);
    const auto isNumber = [this](std::string_view field) {
      return readField(field, table_.dialect.decimal).kind == FieldKind::Number;
    };
    if (isComment(above.text) || fields.size() < row_.size() ||
        !isNumber(withoutOpenQuote(fields.front())))
      return false;
    return fields.size() == row_.size() ||
           std::all_of(fields.begin(), fields.begin() + std::ssize(row_.fields), isNumber);
  }

  /// Leaves out damaged rows right above a first row.
  void leaveOutAbove(const TextLine& first) {
    auto begin = above_.end();
    std::size_t number = first.number;
    while (begin != above_.begin() && std::prev(begin)->number + 1 == number &&
           isDamagedRow(*std::prev(begin)))
      number = (--begin)->number;
    for (; begin != above_.end(); ++begin) leaveOut(*begin);
  }

  /// Leaves out damaged rows right below the open block.
  void leaveOutBelow() {
    std::size_t next = block().lines.back() + 1;
    for (const TextLine& line : above_) {
      if (line.number != next++ || isComment(line.text) || !beginsAsNumber(line.text) ||
          rows_.split(line.text).size() != block().columns.size())
        return;
      leaveOut(line);
    }
  }

  /// Returns whether the last of so many columns has a name above the first row.
  bool isNamed(std::size_t columns) const {
    for (auto above = above_.rbegin(); above != above_.rend(); ++above) {
      const std::string_view names = withoutCommentMark(above->text, table_.dialect);
      if (!splitNames(names, table_.dialect, columns).empty()) return true;
      // Names stand above their units, and the last column may have none.
      const std::vector<std::string_view> fields = splitFields(names, table_.dialect.separator);
      const bool isEmpty = std::ranges::all_of(
          fields, [](std::string_view field) { return trimmedField(field).empty(); });
      if (!isEmpty && !areUnits({fields.begin(), fields.end()})) return false;
    }
    return false;
  }

  void start(const TextLine& line) {
    // Separators at the ends of all lines make no column, unless it has a name.
    while (row_.size() > 1 && trimmedBlanks(row_.fields.back()).empty() && !isNamed(row_.size())) {
      row_.removeLast();
    }
    if (isOpen_) {
      refuseBrokenTable(line);
      leaveOutBelow();
      endBlock();
    }
    leaveOutAbove(line);
    addBlock(line);
    isOpen_ = true;
    append(line);
  }

  /// Adds a block whose columns are those of the fields, without rows. line: its first row.
  void addBlock(const TextLine& line) {
    hasNumbers_.assign(row_.size(), false);
    TextBlock fresh;
    fresh.columns = namedColumns(above_, table_.dialect, row_.values);
    fresh.texts.resize(row_.size());
    fresh.cells.resize(row_.size());
    hasTexts_ = false;
    for (std::size_t i = 0; i < row_.size(); ++i) {
      TextColumn& column = fresh.columns[i];
      column.isText =
          options_.keepsTexts &&
          (row_.is(i, FieldKind::Text) || isOneOf(lowerCase(column.name), options_.textColumns));
      hasTexts_ = hasTexts_ || column.isText;
    }
    for (const TextLine& kept : above_) addEntry(kept, fresh.header);
    above_.clear();
    if (!table_.blocks.empty()) block().values.shrink_to_fit();
    // Memory for all possible rows is reserved, so that large tables are not copied.
    const std::size_t rows = rest_.size() / (line.text.size() + 1) + 1;
    fresh.values.reserve(std::min(rows * row_.size(), kMaxNumbers - count_));
    table_.blocks.push_back(std::move(fresh));
  }

  void addEntry(const TextLine& line, std::vector<TextEntry>& entries) const {
    entries.push_back(parseEntry(line, table_.dialect));
  }

  std::string_view whole_, rest_;
  std::span<const std::size_t> breaks_;  // of lines, in the rest
  const std::string& name_;
  const TextTableOptions& options_;
  TextTable& table_;
  RowReader rows_;
  std::size_t number_ = 0, count_ = 0;
  std::size_t nextReport_ = kProgressStep;
  bool isOpen_ = false;             // the last block may go on
  bool hasTexts_ = false;           // of the last block
  bool isDirect_ = false;           // no blank line since the last row
  std::vector<bool> hasNumbers_;    // each column of the last block, in its first rows at least
  std::vector<TextLine> above_;     // lines since the last row
  TextRow row_;                     // the present line
  std::vector<double> numbers_;     // of each column in this line
  std::vector<std::size_t> flags_;  // indices in the last block's values of words such as "valid"
  std::size_t blankLines_ = 0;      // since the last row
};

}  // namespace

TextTable readTextTable(std::string_view bytes, const std::string& name,
                        const TextTableOptions& options) {
  if (bytes.empty()) throw InputError(name, "", "is empty");
  TextTable table;
  const DecodedText decoded(bytes, name);
  table.encoding = decoded.encoding;
  const JoinedText joined(decoded.text);
  table.dialect = detectDialect(joined.text, options.readsCells);
  TableReader(joined, name, options, table).read();
  for (TextBlock& block : table.blocks) takeColumnsOfUnits(block, name);
  return table;
}

}  // namespace asperity
