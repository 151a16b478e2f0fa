#include "core/base/text_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

#include "core/base/input_error.h"
#include "core/base/text.h"
#include "core/base/text_encoding.h"
#include "core/base/text_names.h"
#include "core/base/text_number.h"

namespace asperity {
namespace {

constexpr std::size_t kMostNumbers = std::size_t{1} << 27;
constexpr std::size_t kMostHeaderLines = 10000;              // that are kept for one block
constexpr std::size_t kProgressStep = std::size_t{1} << 20;  // bytes

bool isBlank(char letter) {
  return letter == ' ' || letter == '\t';
}

char markOf(TextDialect::Separator separator) {
  switch (separator) {
    case TextDialect::Separator::Tab:
      return '\t';
    case TextDialect::Separator::Semicolon:
      return ';';
    case TextDialect::Separator::Bar:
      return '|';
    case TextDialect::Separator::Comma:
      return ',';
    default:
      return ' ';
  }
}

/// Reads a row of exactly `numbers.size()` plain numbers; false where there is anything else, which
/// the slow way looks at.
bool readPlainRow(std::string_view line, const TextDialect& dialect, std::span<double> numbers) {
  using Separator = TextDialect::Separator;
  if (dialect.separator == Separator::CommaBlank || dialect.separator == Separator::CommaPair)
    return false;
  const char mark = markOf(dialect.separator);
  const bool atBlanks = dialect.separator == Separator::Blanks;
  const char* place = line.data();
  const char* const end = place + line.size();
  const auto skipBlanks = [&] {
    while (place != end && (*place == ' ' || (*place == '\t' && mark != '\t'))) ++place;
  };
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    skipBlanks();
    if (i > 0 && !atBlanks) {
      if (place == end || *place != mark) return false;
      ++place;
      skipBlanks();
    }
    if (place != end && *place == '+') ++place;
    // Neither "inf" nor "nan", which std::from_chars takes for numbers.
    const char* first = place != end && *place == '-' ? place + 1 : place;
    if (first == end || !(isDigit(*first) || *first == '.')) return false;
    if (dialect.decimal == '.') {
      const auto [stop, error] = std::from_chars(place, end, numbers[i]);
      if (error != std::errc{}) return false;
      place = stop;
    } else {
      const char* stop = place;
      while (stop != end && !isBlank(*stop) && *stop != mark) ++stop;
      const auto size = static_cast<std::size_t>(stop - place);
      if (!readTextNumber(std::string_view(place, size), ',', numbers[i])) return false;
      place = stop;
    }
    if (place != end && !isBlank(*place) && *place != mark) return false;
  }
  skipBlanks();
  return place == end;
}

/// Without the mark of a comment; a semicolon is one where it separates no fields.
std::string_view withoutMark(std::string_view line, const TextDialect& dialect) {
  line = trimmedBlanks(line);
  const bool orSemicolon = dialect.separator != TextDialect::Separator::Semicolon;
  while (line.starts_with('#') || line.starts_with('%') || line.starts_with('!') ||
         (orSemicolon && line.starts_with(';')))
    line = trimmedBlanks(line.substr(1));
  if (line.starts_with("//")) line = trimmedBlanks(line.substr(2));
  return line;
}

/// Where ":" or "=" ends a key; npos where there is none.
std::size_t keyEnd(std::string_view line) {
  constexpr std::string_view kWideColon = "\uFF1A";
  const std::size_t at = std::min(line.find_first_of(":="), line.find(kWideColon));
  return at == 0 ? std::string_view::npos : at;
}

TextEntry entryOf(std::string_view line, std::size_t number, const TextDialect& dialect) {
  line = withoutMark(line, dialect);
  TextEntry entry{{}, std::string(line), number};
  std::vector<std::string_view> fields;
  splitFields(line, dialect.separator, fields);
  const auto setKey = [&entry](std::string_view key, std::string_view value) {
    key = trimmedField(key);
    while (key.ends_with(':') || key.ends_with('='))
      key = trimmedBlanks(key.substr(0, key.size() - 1));
    if (key.empty()) return;
    while (!value.empty() && (value.back() == ';' || value.back() == ',' || isBlank(value.back())))
      value.remove_suffix(1);
    entry.key = key;
    entry.value = trimmedField(value);
  };
  const std::size_t end = keyEnd(line);
  const std::size_t tab = line.find('\t');
  const bool isExact = dialect.isExact() && fields.size() > 1;
  if (isExact && end >= fields.front().size()) {
    // "Width;10;\u00B5m"
    std::string value;
    for (std::size_t i = 1; i < fields.size(); ++i)
      if (const auto part = trimmedField(fields[i]); !part.empty())
        value += (value.empty() ? "" : " ") + std::string(part);
    setKey(fields.front(), value);
  } else if (end != std::string_view::npos) {
    constexpr std::size_t kWide = 3;  // bytes of a full-width colon
    setKey(line.substr(0, end),
           line.substr(end + (line[end] == ':' || line[end] == '=' ? 1 : kWide)));
  } else if (const std::size_t semicolon = line.find(';');
             semicolon != std::string_view::npos && semicolon > 0) {
    setKey(line.substr(0, semicolon), line.substr(semicolon + 1));
  } else if (tab != std::string_view::npos && tab > 0) {
    setKey(line.substr(0, tab), line.substr(tab + 1));
  } else if ((fields.size() == 2 || fields.size() == 3) &&
             readField(fields[0], dialect.decimal).kind == FieldKind::Text &&
             readField(fields[1], dialect.decimal).kind == FieldKind::Number) {
    setKey(fields[0], line.substr(static_cast<std::size_t>(fields[1].data() - line.data())));
  }
  return entry;
}

struct Line {
  std::string_view text;
  std::size_t number = 0;
};

/// The fields of the lines above a block that may be names, units and comments of its columns; the
/// nearest line is the first. mayCountRows: the first column may be one of row numbers.
std::vector<std::vector<std::string>> rowsAbove(const std::vector<Line>& above,
                                                const TextDialect& dialect, std::size_t columns,
                                                bool mayCountRows) {
  constexpr std::size_t kMostRows = 4;
  std::vector<std::vector<std::string>> rows;
  for (auto line = above.rbegin(); line != above.rend() && rows.size() < kMostRows; ++line) {
    const std::string_view text = withoutMark(line->text, dialect);
    if (text.empty()) continue;
    // A separator in front is an unnamed column, too, be it a tab, which a blank is otherwise. So
    // is one at the end.
    std::vector<std::string> fields = splitNames(text, dialect, columns);
    if (fields.empty() && dialect.isExact()) {
      std::vector<std::string_view> whole;
      splitFields(isComment(line->text) ? text : line->text, dialect.separator, whole);
      if (whole.size() == columns)
        for (const std::string_view field : whole) fields.emplace_back(trimmedField(field));
    }
    // Row numbers, which some programs write in front, have no name.
    if (fields.empty() && columns > 2 && mayCountRows &&
        (dialect.isExact() || text.starts_with('"'))) {
      fields = splitNames(text, dialect, columns - 1);
      if (!fields.empty()) fields.insert(fields.begin(), std::string());
    }
    if (fields.empty()) break;
    const bool isEntry = keyEnd(text) != std::string_view::npos;
    std::vector<std::string_view> exact;
    splitFields(text, dialect.separator, exact);
    if (isEntry && !(dialect.isExact() && columns > 1 && exact.size() >= columns)) break;
    std::size_t numbers = 0, texts = 0;
    for (const std::string& field : fields) {
      const FieldKind kind = readField(field, dialect.decimal).kind;
      numbers += kind == FieldKind::Number ? 1 : 0;
      texts += kind == FieldKind::Text ? 1 : 0;
    }
    // Numbers may be names of all columns but the first: temperatures, or positions along x.
    const bool areNames = numbers == 0 || (columns > 2 && numbers + 1 >= columns);
    if (!areNames || texts == 0) break;
    rows.push_back(std::move(fields));
  }
  return rows;
}

bool isUnitField(const std::string& field) {
  return isKnownUnit(field) || withoutBrackets(field).size() != trimmedField(field).size();
}

/// Whether each field is a unit or empty, and one at least could be nothing else. Among several
/// units one word may be none, such as "bool" of a column that says what is valid.
bool areUnits(const std::vector<std::string>& fields) {
  std::size_t sure = 0, others = 0;
  for (const std::string& field : fields) {
    if (trimmedField(field).empty()) continue;
    const std::string_view inner = withoutBrackets(field);
    const bool inBrackets = inner.size() != trimmedField(field).size();
    if (!isUnitField(field))
      ++others;
    else if (inBrackets || inner.size() > 1 || inner == "m")
      ++sure;
  }
  return others == 0 ? sure > 0 : others == 1 && sure >= 2;
}

/// first: the fields of the first row.
std::vector<TextColumn> namedColumns(const std::vector<Line>& above, const TextDialect& dialect,
                                     const std::vector<Field>& first) {
  const std::size_t columns = first.size();
  std::vector<TextColumn> named(columns);
  const bool mayCountRows =
      first[0].kind == FieldKind::Number && (first[0].value == 0 || first[0].value == 1);
  const auto rows = rowsAbove(above, dialect, columns, mayCountRows);
  const auto units = std::ranges::find_if(rows, areUnits);
  // Names stand above their units; without units, right above the numbers.
  const std::vector<std::string>* names = nullptr;
  if (units == rows.end()) {
    if (!rows.empty()) names = &rows.front();
  } else if (units + 1 != rows.end()) {
    names = &*(units + 1);
  } else if (units != rows.begin()) {
    names = &*(units - 1);
  }
  for (std::size_t i = 0; i < columns; ++i) {
    if (names != nullptr) {
      const ColumnName name = columnName((*names)[i]);
      named[i].name = name.name;
      named[i].unit = name.unit;
    }
    if (units != rows.end())
      if (const std::string_view unit = withoutBrackets((*units)[i]);
          !unit.empty() && isUnitField((*units)[i]))
        named[i].unit = unit;
  }
  return named;
}

class TableReader {
 public:
  TableReader(std::string_view text, const std::string& name, const TextTableOptions& options,
              TextTable& table)
      : whole_(text), rest_(text), name_(name), options_(options), table_(table) {}

  void read() {
    while (!rest_.empty()) {
      const Line line{takeLine(rest_), ++number_};
      if (whole_.size() - rest_.size() >= nextReport_) report();
      take(line);
    }
    for (const Line& line : above_) addEntry(line, table_.trailer);
    if (table_.blocks.empty()) refuseWithoutRows();
    clearFlags();
  }

 private:
  [[noreturn]] void fail(const Message& message) const { throw InputError(name_, "", message); }

  /// Names the first line that looks most like a row.
  [[noreturn]] void refuseWithoutRows() {
    for (const Line& line : above_) {
      if (isComment(line.text)) continue;
      readRow(line.text);
      for (std::size_t i = 0; i < fields_.size(); ++i)
        if (kinds_[i].kind == FieldKind::Text && fields_.size() > 1 &&
            fields_[i].find_first_of("0123456789") != std::string_view::npos)
          fail(message("has no rows of numbers; line {}: '{}' is no number", line.number,
                       shortened(trimmedField(fields_[i]))));
    }
    fail("has no rows of numbers");
  }

  void report() {
    nextReport_ += kProgressStep;
    if (options_.progress)
      options_.progress(1 - static_cast<double>(rest_.size()) / static_cast<double>(whole_.size()));
  }

  void take(const Line& line) {
    if (isOpen_ && appendPlain(line)) return;
    if (trimmedBlanks(line.text).empty()) {
      isDirect_ = false;
      return;
    }
    if (isComment(line.text)) return keep(line);
    readRow(line.text);
    if (isOpen_ && fits()) return append(line);
    if (isOpen_) refuseAmidRows(line);
    if (startsBlock(line)) return start(line);
    keep(line);
  }

  /// A line that is no row; it may be part of a header.
  void keep(const Line& line) {
    if (above_.size() < kMostHeaderLines) above_.push_back(line);
  }

  /// The rows go on behind lines that were kept: comments may stand between rows, a header begins a
  /// block of its own.
  bool goesOn() const {
    return std::ranges::all_of(above_, [this](const Line& line) {
      return isComment(line.text) && entryOf(line.text, line.number, table_.dialect).key.empty();
    });
  }

  TextBlock& block() { return table_.blocks.back(); }

  bool appendPlain(const Line& line) {
    if (hasTexts_) return false;
    row_.resize(block().columns.size());
    if (!readPlainRow(line.text, table_.dialect, row_)) return false;
    if (!above_.empty() && !goesOn()) return false;  // begins a block, the slow way
    hasNumbers_.assign(row_.size(), true);
    addRow(line);
    return true;
  }

  void addRow(const Line& line) {
    above_.clear();
    isDirect_ = true;
    if (count_ + row_.size() > kMostNumbers)
      fail(message("has more than {} numbers", kMostNumbers));
    count_ += row_.size();
    block().values.insert(block().values.end(), row_.begin(), row_.end());
    block().lines.push_back(static_cast<std::uint32_t>(line.number));
    ++block().rows;
  }

  /// Where labels are kept, "#" belongs to them.
  void split(std::string_view line, std::vector<std::string_view>& fields) const {
    if (options_.keepsTexts)
      splitFields(line, table_.dialect.separator, fields);
    else
      splitRow(line, table_.dialect, fields);
  }

  /// Fills fields_ and kinds_.
  void readRow(std::string_view line) {
    split(line, fields_);
    kinds_.clear();
    for (const std::string_view field : fields_)
      kinds_.push_back(readField(field, table_.dialect.decimal));
  }

  std::size_t countOf(FieldKind kind) const {
    return static_cast<std::size_t>(
        std::ranges::count_if(kinds_, [kind](const Field& field) { return field.kind == kind; }));
  }

  /// Whether the fields are a row of the open block.
  bool fits() const {
    const std::vector<TextColumn>& columns = table_.blocks.back().columns;
    std::size_t size = fields_.size();
    while (size > columns.size() && trimmedBlanks(fields_[size - 1]).empty()) --size;
    if (size > columns.size()) return false;
    for (std::size_t i = size; i < columns.size(); ++i)
      if (!columns[i].isText) return false;
    bool anyValue = false;
    for (std::size_t i = 0; i < size; ++i) {
      if (columns[i].isText) continue;
      if (kinds_[i].kind == FieldKind::Text) {
        if (hasNumbers_[i]) return false;
        continue;  // a column of remarks, empty so far
      }
      anyValue = anyValue || !trimmedBlanks(fields_[i]).empty();
    }
    // Nothing but separators is a row of gaps if it stands amid the rows.
    return anyValue || (size == columns.size() && nextLineFits());
  }

  /// Whether the next line that is not blank is a row of the open block.
  bool nextLineFits() const {
    std::string_view rest = rest_;
    while (!rest.empty()) {
      const std::string_view line = takeLine(rest);
      if (trimmedBlanks(line).empty()) continue;
      std::vector<std::string_view> fields;
      split(line, fields);
      const std::vector<TextColumn>& columns = table_.blocks.back().columns;
      while (fields.size() > columns.size() && trimmedBlanks(fields.back()).empty())
        fields.pop_back();
      if (fields.size() != columns.size()) return false;
      bool anyNumber = false;
      for (std::size_t i = 0; i < fields.size(); ++i) {
        const FieldKind kind = readField(fields[i], table_.dialect.decimal).kind;
        if (kind == FieldKind::Text && !columns[i].isText && hasNumbers_[i]) return false;
        anyNumber = anyNumber || kind == FieldKind::Number;
      }
      return anyNumber;
    }
    return false;
  }

  /// Whether the next line has so many fields and begins with a number, as damaged rows do.
  bool nextLineResembles(std::size_t size) const {
    std::string_view rest = rest_;
    const std::string_view line = takeLine(rest);
    std::vector<std::string_view> fields;
    split(line, fields);
    return fields.size() == size &&
           readField(fields.front(), table_.dialect.decimal).kind == FieldKind::Number;
  }

  /// A row that is wrong in one field, or has another width, is an error where the rows go on. So
  /// are several such rows: results of a program below its rows begin with a word.
  void refuseAmidRows(const Line& line) const {
    constexpr std::size_t kManyRows = 10;  // of no header such as "60 40"
    const std::vector<TextColumn>& columns = table_.blocks.back().columns;
    const std::size_t numbers = countOf(FieldKind::Number);
    const bool isEntry = keyEnd(line.text) != std::string_view::npos;
    if (numbers == 0 || isEntry || !above_.empty()) return;
    const bool isWide = fields_.size() != columns.size();
    const bool goOnBroken = isDirect_ && kinds_.front().kind == FieldKind::Number &&
                            (!isWide || table_.blocks.back().rows >= kManyRows) &&
                            nextLineResembles(fields_.size());
    if (!goOnBroken && !nextLineFits()) return;
    if (isWide && countOf(FieldKind::Text) == 0)
      fail(message("line {}: has {} fields where the lines before have {}", line.number,
                   fields_.size(), columns.size()));
    for (std::size_t i = 0; i < std::min(columns.size(), fields_.size()); ++i)
      if (kinds_[i].kind == FieldKind::Text && !columns[i].isText)
        fail(message("line {}: column {} is not a number", line.number, i + 1));
  }

  void append(const Line& line) {
    if (!above_.empty() && !goesOn()) return start(line);
    const std::size_t columns = block().columns.size();
    row_.assign(columns, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < columns; ++i) {
      const bool isThere = i < fields_.size();
      if (isThere && kinds_[i].kind == FieldKind::Text && options_.keepsTexts &&
          !block().columns[i].isText) {
        block().columns[i].isText = hasTexts_ = true;
        block().texts[i].assign(block().rows, {});
      }
      if (isThere && kinds_[i].kind == FieldKind::Number) hasNumbers_[i] = true;
      if (block().columns[i].isText)
        block().texts[i].emplace_back(isThere ? trimmedField(fields_[i]) : std::string_view{});
      else if (isThere && kinds_[i].kind != FieldKind::Text)
        row_[i] = kinds_[i].value;
      if (isThere && kinds_[i].kind == FieldKind::Flag)
        flags_.push_back(block().rows * columns + i);
    }
    addRow(line);
  }

  /// Words such as "invalid" are 0 or 1 in a column of nothing else; among other numbers nothing
  /// was measured there.
  void clearFlags() {
    if (flags_.empty()) return;
    TextBlock& last = block();
    const std::size_t columns = last.columns.size();
    std::vector<bool> hasNumbers(columns);
    for (std::size_t i = 0; i < last.values.size(); ++i) {
      const double value = last.values[i];
      if (!std::isnan(value) && value != 0 && value != 1) hasNumbers[i % columns] = true;
    }
    for (const std::size_t place : flags_)
      if (hasNumbers[place % columns])
        last.values[place] = std::numeric_limits<double>::quiet_NaN();
    flags_.clear();
  }

  /// Whether the fields can be the first row of a block.
  bool startsBlock(const Line& line) {
    if (countOf(FieldKind::Number) == 0) return false;
    if (countOf(FieldKind::Text) == 0) return true;
    if (!options_.keepsTexts || keyEnd(line.text) != std::string_view::npos) return false;
    const auto named = namedColumns(above_, table_.dialect, kinds_);
    return std::ranges::none_of(named,
                                [](const TextColumn& column) { return column.name.empty(); });
  }

  void start(const Line& line) {
    // Separators at the ends of all lines enclose nothing, unless the column has a name.
    const auto isNamed = [this](std::size_t columns) {
      return !above_.empty() &&
             !splitNames(withoutMark(above_.back().text, table_.dialect), table_.dialect, columns)
                  .empty();
    };
    while (fields_.size() > 1 && trimmedBlanks(fields_.back()).empty() &&
           !isNamed(fields_.size())) {
      fields_.pop_back();
      kinds_.pop_back();
    }
    clearFlags();
    hasNumbers_.assign(fields_.size(), false);
    TextBlock fresh;
    fresh.columns = namedColumns(above_, table_.dialect, kinds_);
    fresh.texts.resize(fields_.size());
    hasTexts_ = false;
    for (std::size_t i = 0; i < fields_.size(); ++i) {
      TextColumn& column = fresh.columns[i];
      column.isText =
          options_.keepsTexts && (kinds_[i].kind == FieldKind::Text ||
                                  std::ranges::find(options_.textColumns, lowerCase(column.name)) !=
                                      options_.textColumns.end());
      hasTexts_ = hasTexts_ || column.isText;
    }
    for (const Line& kept : above_) addEntry(kept, fresh.header);
    above_.clear();
    if (!table_.blocks.empty()) block().values.shrink_to_fit();
    // As many rows as there may be, so that large tables are not moved about.
    const std::size_t rows = rest_.size() / (line.text.size() + 1) + 1;
    fresh.values.reserve(std::min(rows * fields_.size(), kMostNumbers - count_));
    table_.blocks.push_back(std::move(fresh));
    isOpen_ = true;
    append(line);
  }

  void addEntry(const Line& line, std::vector<TextEntry>& entries) const {
    entries.push_back(entryOf(line.text, line.number, table_.dialect));
  }

  std::string_view whole_, rest_;
  const std::string& name_;
  const TextTableOptions& options_;
  TextTable& table_;
  std::size_t number_ = 0, count_ = 0;
  std::size_t nextReport_ = kProgressStep;
  bool isOpen_ = false;           // the last block may go on
  bool hasTexts_ = false;         // of the last block
  bool isDirect_ = false;         // no blank line since the last row
  std::vector<bool> hasNumbers_;  // each column of the last block, in its first rows at least
  std::vector<Line> above_;       // lines since the last row
  std::vector<std::string_view> fields_;
  std::vector<Field> kinds_;
  std::vector<double> row_;
  std::vector<std::size_t> flags_;  // places in the last block's values of words such as "valid"
};

}  // namespace

std::vector<double> TextBlock::column(std::size_t number) const {
  std::vector<double> found(rows);
  for (std::size_t i = 0; i < rows; ++i) found[i] = at(i, number);
  return found;
}

const TextBlock& TextTable::largest() const {
  return *std::ranges::max_element(blocks, {},
                                   [](const TextBlock& one) { return one.values.size(); });
}

std::string TextTable::entry(std::string_view key, const TextBlock& block) const {
  const std::string wanted = lowerCase(key);
  std::string found;
  for (const TextBlock& one : blocks) {
    for (const TextEntry& entry : one.header)
      if (lowerCase(entry.key) == wanted) found = entry.value;
    if (&one == &block) break;
  }
  return found;
}

TextTable readTextTable(std::string_view bytes, const std::string& name,
                        const TextTableOptions& options) {
  TextTable table;
  DecodedText decoded;
  decodeText(bytes, name, decoded);
  table.encoding = decoded.encoding;
  table.dialect = detectDialect(decoded.text);
  TableReader(decoded.text, name, options, table).read();
  return table;
}

void undoLogarithms(TextTable& table, const std::function<bool(const std::string&)>& isQuantity) {
  constexpr std::pair<std::string_view, double> kLogarithms[] = {
      {"log10", 10}, {"log", 10}, {"lg", 10}, {"ln", std::numbers::e}};
  for (TextBlock& block : table.blocks)
    for (std::size_t i = 0; i < block.columns.size(); ++i) {
      TextColumn& column = block.columns[i];
      const std::string name = lowerCase(column.name);
      const auto* const found = std::ranges::find_if(
          kLogarithms, [&](const auto& logarithm) { return name.starts_with(logarithm.first); });
      if (found == std::end(kLogarithms) || column.isText) continue;
      std::string_view rest = std::string_view(column.name).substr(found->first.size());
      rest = trimmedBlanks(rest.substr(std::min(rest.find_first_not_of("_ "), rest.size())));
      const ColumnName inner = columnName(withoutBrackets(rest));
      if (!isQuantity(inner.name)) continue;
      const std::string unit = inner.unit.empty() ? column.unit : inner.unit;
      column = {inner.name, unit, false};
      for (std::size_t row = 0; row < block.rows; ++row) {
        double& value = block.values[row * block.columns.size() + i];
        value = std::pow(found->second, value);
        if (std::isinf(value)) value = std::numeric_limits<double>::quiet_NaN();
      }
    }
}

bool countsRows(const TextBlock& block, std::size_t column) {
  if (block.columns[column].isText || block.rows < 2) return false;
  const double first = block.at(0, column);
  if (std::isnan(first) || (first != 0 && first != 1)) return false;
  for (std::size_t i = 1; i < block.rows; ++i) {
    const double value = block.at(i, column);
    if (std::isnan(value) || value != first + static_cast<double>(i)) return false;
  }
  return true;
}

}  // namespace asperity
