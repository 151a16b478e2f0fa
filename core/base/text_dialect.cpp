#include "core/base/text_dialect.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <system_error>

#include "core/base/text_cell.h"
#include "core/base/text_number.h"

namespace asperity {
namespace {

bool isBlankOrTab(char letter) {
  return letter == ' ' || letter == '\t';
}

using Separator = TextDialect::Separator;
using Lines = std::vector<std::string_view>;

/// Returns the character between two fields; a blank where any run of blanks separates them.
char separatorCharacter(Separator separator) {
  switch (separator) {
    case Separator::Blanks:
      return ' ';
    case Separator::Tab:
      return '\t';
    case Separator::Semicolon:
      return ';';
    case Separator::Bar:
      return '|';
    default:
      return ',';
  }
}

/// Texts up to this length are examined as a whole; of longer ones this many lines from each of
/// several parts.
constexpr std::size_t kStretch = std::size_t{1} << 15, kMaxLines = 200;

/// Lines from the beginning, the end and three parts in between.
struct Sample {
  Lines lines;
  bool readsCells = false;      // numbers may have errors and units
  std::size_t ofBeginning = 0;  // number of consecutive lines from the first one on
};

Sample sampleOf(std::string_view text, bool readsCells) {
  Sample sample;
  sample.readsCells = readsCells;
  const auto take = [&sample, text](std::string_view rest) {
    const std::size_t whole = rest.size();
    const std::size_t most = text.size() <= kStretch ? text.size() : kMaxLines;
    for (std::size_t i = 0; i < most && !rest.empty() && whole - rest.size() < kStretch; ++i)
      sample.lines.push_back(takeLine(rest));
  };
  take(text);
  sample.ofBeginning = sample.lines.size();
  if (text.size() <= kStretch) return sample;
  for (const std::size_t offset : {text.size() / 4, text.size() / 2, text.size() / 4 * 3,
                                   text.size() - std::min(text.size(), kStretch / 8)}) {
    std::string_view rest = text.substr(offset);
    takeLine(rest);  // is cut off
    take(rest);
  }
  return sample;
}

/// Splits a line into fields; those with errors or units are left with their numbers alone.
void splitNumbers(std::string_view line, const TextDialect& dialect, bool readsCells,
                  std::vector<std::string_view>& fields) {
  splitRow(line, dialect, fields);
  if (!readsCells) return;
  if (!dialect.isExact()) joinCells(fields);
  for (std::string_view& field : fields)
    if (const auto cell = readCell(field, dialect.decimal)) field = cell->digits;
}

/// The quality of a dialect for the lines of a sample.
struct Fit {
  double score = 0;           // lines that are rows of numbers; those of another width count less
  std::size_t columns = 0;    // of most rows
  std::size_t firstRow = 0;   // the first line that is a row
  std::size_t rows = 0;       // from that one on
  std::size_t withTexts = 0;  // of these, with a field that is no number
};

Fit fitOf(const Sample& sample, const TextDialect& dialect) {
  const Lines& lines = sample.lines;
  std::vector<std::string_view> fields;
  std::map<std::size_t, double> ofColumns;  // sum of the scores for each number of fields
  Fit fit;
  fit.firstRow = lines.size();
  double sum = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (trimmedBlanks(lines[i]).empty() || isComment(lines[i])) continue;
    splitNumbers(lines[i], dialect, sample.readsCells, fields);
    while (fields.size() > 1 && trimmedBlanks(fields.back()).empty()) fields.pop_back();
    std::size_t numbers = 0, texts = 0;
    bool isGrouped = false;
    for (const std::string_view field : fields) {
      const Field read = readField(field, dialect.decimal);
      numbers += read.kind == FieldKind::Number ? 1 : 0;
      texts += read.kind == FieldKind::Text ? 1 : 0;
      isGrouped = isGrouped || read.isGrouped;
    }
    if (numbers == 0 || 2 * texts > fields.size()) continue;
    // Where both are possible, "1,234" is more likely a decimal number than a number of thousands.
    constexpr double kGrouped = 0.9, kWithTexts = 0.5;
    const double score = texts > 0 ? kWithTexts : isGrouped ? kGrouped : 1;
    // Lines such as "Step 1" above the first row of numbers belong to a header.
    if (texts == 0 && fit.firstRow == lines.size()) {
      fit.firstRow = i;
      ofColumns.clear();
      sum = 0;
      fit.rows = fit.withTexts = 0;
    }
    ++fit.rows;
    fit.withTexts += texts > 0 ? 1 : 0;
    ofColumns[fields.size()] += score;
    sum += score;
  }
  double best = 0;
  for (const auto& [columns, score] : ofColumns)
    if (score > best) {
      best = score;
      fit.columns = columns;
    }
  constexpr double kOfOtherWidth = 0.3;
  fit.score = best + kOfOtherWidth * (sum - best);
  // A list of single numbers above a table has no separators; a comma may be its decimal mark.
  constexpr double kTable = 2;
  const bool isTold = dialect.isExact() && separatorCharacter(dialect.separator) != ',';
  if (isTold && fit.columns == 1 && sum - best >= kTable) {
    ofColumns.erase(1);
    fit.columns =
        std::ranges::max_element(ofColumns, {}, [](const auto& one) { return one.second; })->first;
    fit.score = sum;
  }
  return fit;
}

/// Returns whether the numbers strictly rise or strictly fall.
bool isMonotone(const std::vector<double>& numbers) {
  const auto none = numbers.end();
  return std::ranges::adjacent_find(numbers, std::greater_equal<>()) == none ||
         std::ranges::adjacent_find(numbers, std::less_equal<>()) == none;
}

/// Returns whether commas between whole numbers are decimal marks: in "0,05", "-0,5", "1,5E-3",
/// where the number of digits after them is always the same; or where the first one of two columns
/// goes up and down, which positions and velocities do not.
bool looksLikeDecimals(const Lines& lines, std::size_t columns) {
  std::vector<std::string_view> fields;
  std::size_t rows = 0, digits = 0;
  bool sameDigits = true, varies = false;
  std::string_view firstTail;
  std::vector<double> heads;
  for (const std::string_view line : lines) {
    splitFields(line, Separator::Comma, fields);
    if (fields.size() != columns || isComment(line)) continue;
    const auto isWhole = [](std::string_view field) {
      return readField(field, '.').kind == FieldKind::Number &&
             field.find('.') == std::string_view::npos;
    };
    if (!std::ranges::all_of(fields, isWhole)) continue;
    heads.push_back(readField(fields.front(), '.').value);
    for (std::size_t i = 1; i < fields.size(); i += 2) {
      const std::string_view tail = trimmedBlanks(fields[i]);
      if (!isDigit(tail.front())) return false;  // a sign begins a number of its own
      if ((tail.size() > 1 && tail[0] == '0' && isDigit(tail[1])) ||
          trimmedBlanks(fields[i - 1]) == "-0")
        return true;
      if (tail.find_first_of("eE") != std::string_view::npos) return true;
      if (rows == 0) {
        digits = tail.size();
        firstTail = tail;
      }
      sameDigits = sameDigits && tail.size() == digits;
      varies = varies || tail != firstTail;
      ++rows;
    }
  }
  constexpr std::size_t kEnoughRows = 3;
  if (rows < kEnoughRows) return false;
  return (digits > 1 && sameDigits && varies) || (columns == 2 && !isMonotone(heads));
}

/// Returns the line before the first row; empty where there is none.
std::string_view lineBefore(const Sample& sample, std::size_t firstRow) {
  for (std::size_t i = std::min(firstRow, sample.ofBeginning); i-- > 0;)
    if (!trimmedBlanks(sample.lines[i]).empty()) return sample.lines[i];
  return {};
}

/// Returns the dialect of whole numbers with commas between them: each comma, every second one or
/// none is a decimal mark.
TextDialect ofWholeNumbers(const Sample& sample, const Fit& fit) {
  const TextDialect comma{Separator::Comma, '.'};
  if (fit.columns % 2 != 0) return comma;
  const std::string_view names = lineBefore(sample, fit.firstRow);
  const std::vector<std::string_view> fields = splitFields(names, Separator::Comma);
  if (fields.size() == fit.columns) return comma;
  // There may be as many names as pairs; a single name counts only with a unit, as it may be a
  // title.
  const bool isNamed = fields.size() == fit.columns / 2 &&
                       (fields.size() > 1 || (names.find_first_of("([") != std::string_view::npos &&
                                              names.find_first_of(":=") == std::string_view::npos));
  if (!isNamed && !looksLikeDecimals(sample.lines, fit.columns)) return comma;
  if (fit.columns == 2) return {Separator::Blanks, ','};
  return {Separator::CommaPair, ','};
}

/// The evidence of the numbers of one column about the mark in them, which is assumed to be a
/// decimal mark.
struct MarkedNumbers {
  std::size_t marked = 0;              // "13.318": what may be thousands as well
  std::set<std::string_view> whole{};  // "929"
  bool hasLong = false;                // "1318": thousands without a mark
};

/// Adds a field; returns whether its mark cannot separate thousands: "0.318", "1.5", "1318.250",
/// "1.318e3".
bool isDecimal(std::string_view field, char mark, MarkedNumbers& numbers) {
  constexpr std::size_t kGroup = 3;
  field = trimmedField(field);
  while (field.starts_with('-') || field.starts_with('+')) field.remove_prefix(1);
  const std::size_t head = std::min(field.find_first_not_of("0123456789"), field.size());
  if (head == field.size()) {
    numbers.hasLong = numbers.hasLong || head > kGroup;
    if (field != "0") numbers.whole.insert(field);
    return false;
  }
  if (field[head] != mark) return field.find(mark) != std::string_view::npos;
  const std::string_view tail = field.substr(head + 1);
  if (head == 0 || head > kGroup || field.front() == '0' || tail.size() != kGroup ||
      !areDigits(tail))
    return true;
  ++numbers.marked;
  return false;
}

enum class Mark { Decimal, Unclear, Thousands };

/// Returns the meaning of the marks in the numbers. Where each mark has exactly three digits after
/// it, it may separate thousands. It does where numbers below a thousand have no mark: some of so
/// many decimals would end with a zero, which programs omit where whole numbers have no mark.
Mark meaningOf(const Sample& sample, const TextDialect& dialect, const Fit& fit,
               std::size_t someMarked = 3) {
  const Lines& lines = sample.lines;
  constexpr std::size_t kManyMarked = 50, kManyWhole = 3;
  std::vector<MarkedNumbers> columns(fit.columns);
  std::vector<std::string_view> fields;
  for (std::size_t i = fit.firstRow; i < lines.size(); ++i) {
    if (isComment(lines[i])) continue;
    splitNumbers(lines[i], dialect, sample.readsCells, fields);
    if (fields.size() != columns.size()) continue;
    for (std::size_t j = 0; j < columns.size(); ++j)
      if (readField(fields[j], dialect.decimal).kind == FieldKind::Number &&
          isDecimal(fields[j], dialect.decimal, columns[j]))
        return Mark::Decimal;
  }
  const auto areThousands = [](const MarkedNumbers& column) {
    return column.marked >= kManyMarked && column.whole.size() >= kManyWhole && !column.hasLong;
  };
  if (std::ranges::any_of(columns, areThousands)) return Mark::Thousands;
  const auto isMarked = [someMarked](const MarkedNumbers& column) {
    return column.marked >= someMarked;
  };
  return std::ranges::any_of(columns, isMarked) ? Mark::Unclear : Mark::Decimal;
}

/// Returns whether all numbers of a column are such as "1.000", where another mark is the decimal
/// one: they are thousands, or the column has another decimal mark than the others.
bool hasThousandsAlone(const Sample& sample, const TextDialect& dialect, const Fit& fit) {
  const char other = dialect.decimal == '.' ? ',' : '.';
  std::vector<MarkedNumbers> columns(fit.columns);
  std::vector<bool> areAlone(fit.columns, true);
  std::vector<std::string_view> fields;
  for (std::size_t i = fit.firstRow; i < sample.lines.size(); ++i) {
    if (isComment(sample.lines[i])) continue;
    splitNumbers(sample.lines[i], dialect, sample.readsCells, fields);
    if (fields.size() != columns.size()) continue;
    for (std::size_t j = 0; j < columns.size(); ++j) {
      if (readField(fields[j], dialect.decimal).kind != FieldKind::Number) continue;
      const std::size_t before = columns[j].marked;
      isDecimal(fields[j], other, columns[j]);
      if (columns[j].marked == before) areAlone[j] = false;
    }
  }
  for (std::size_t j = 0; j < columns.size(); ++j)
    if (areAlone[j] && columns[j].marked > 0) return true;
  return false;
}

/// Returns the dialect with the other decimal mark where that leaves fewer texts among the rows
/// ("1,000,000" is then a number), or where all marks separate thousands.
TextDialect withRightMark(const Sample& sample, const TextDialect& dialect, const Fit& fit) {
  const bool isQuoted = dialect == TextDialect{Separator::Comma, ','};
  if (separatorCharacter(dialect.separator) == ',' && !isQuoted) return dialect;
  TextDialect other = dialect;
  other.decimal = dialect.decimal == '.' ? ',' : '.';
  const Fit otherFit = fitOf(sample, other);
  if (otherFit.rows >= fit.rows && otherFit.withTexts < fit.withTexts) return other;
  // A quoted comma amid commas is a mark of thousands, unless some number shows that it is not.
  if (isQuoted && meaningOf(sample, dialect, fit, 1) != Mark::Decimal) return other;
  const Mark mark = meaningOf(sample, dialect, fit);
  TextDialect right = mark == Mark::Thousands ? other : dialect;
  right.isUnclear = mark != Mark::Decimal;
  right.hasThousandsAlone = !right.isUnclear && hasThousandsAlone(sample, right, fit);
  return right;
}

}  // namespace

std::string_view takeLine(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
  return line;
}

bool isComment(std::string_view line) {
  line = trimmedBlanks(line);
  if (beginsWithSpreadsheetError(line)) return false;
  return line.starts_with('#') || line.starts_with('%') || line.starts_with("//") ||
         line.starts_with('!');
}

void splitFields(std::string_view line, Separator separator,
                 std::vector<std::string_view>& fields) {
  fields.clear();
  const char mark = separatorCharacter(separator);
  const bool atBlanks = separator == Separator::Blanks;
  bool second = false;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= line.size(); ++i) {
    const bool atEnd = i == line.size();
    // A quotation begins only where a field does, because E" is a modulus; without an end it is
    // none.
    if (!atEnd && line[i] == '"' && trimmedBlanks(line.substr(begin, i - begin)).empty())
      if (const std::size_t end = line.find('"', i + 1); end != std::string_view::npos) {
        i = end;
        continue;
      }
    const bool isBlank = !atEnd && isBlankOrTab(line[i]);
    if (atBlanks) {
      if (!atEnd && !isBlank) continue;
      if (i > begin) fields.push_back(line.substr(begin, i - begin));
      begin = i + 1;
      continue;
    }
    if (!atEnd && line[i] != mark) continue;
    const bool blankFollows = i + 1 < line.size() && isBlankOrTab(line[i + 1]);
    if (!atEnd && separator == Separator::CommaBlank && !blankFollows) continue;
    second = !second;
    if (!atEnd && separator == Separator::CommaPair && second) continue;
    fields.push_back(line.substr(begin, i - begin));
    begin = i + 1;
  }
}

namespace {

/// Joins the words of a missing value that blanks have separated into one field.
void joinMissing(std::vector<std::string_view>& fields) {
  constexpr std::size_t kMostWords = 3;
  const auto isWord = [](std::string_view field) {
    const auto first = static_cast<unsigned char>(field.front());
    return std::isalpha(first) != 0 || first > 0x7F;
  };
  std::size_t count = 0;  // of the fields that are left
  for (std::size_t i = 0; i < fields.size(); ++i) {
    std::string_view field = fields[i];
    for (std::size_t last = i + 1; last < std::min(i + kMostWords, fields.size()) &&
                                   isWord(fields[i]) && isWord(fields[last]);
         ++last) {
      const char* const begin = fields[i].data();
      const char* const end = fields[last].data() + fields[last].size();
      const std::string_view words(begin, static_cast<std::size_t>(end - begin));
      if (readField(words, '.').kind != FieldKind::Missing) continue;
      field = words;
      i = last;
      break;
    }
    fields[count++] = field;
  }
  fields.resize(count);
}

}  // namespace

void splitTextRow(std::string_view line, const TextDialect& dialect,
                  std::vector<std::string_view>& fields) {
  splitFields(line, dialect.separator, fields);
  if (!dialect.isExact()) joinMissing(fields);
}

void splitRow(std::string_view line, const TextDialect& dialect,
              std::vector<std::string_view>& fields) {
  splitTextRow(line, dialect, fields);
  const auto hasTexts = [&] {
    return std::ranges::any_of(fields, [&](std::string_view field) {
      return readField(field, dialect.decimal).kind == FieldKind::Text;
    });
  };
  std::size_t mark = line.size();
  for (const std::string_view one : {" #", "\t#", " //", "\t//"})
    mark = std::min(mark, line.find(one));
  if (mark >= line.size() || !hasTexts()) return;
  splitTextRow(line.substr(0, mark), dialect, fields);
  if (hasTexts()) splitTextRow(line, dialect, fields);  // a label such as "tread #2"
}

TextDialect detectDialect(std::string_view text, bool readsCells) {
  const Sample sample = sampleOf(text, readsCells);
  // The first one of equal fits is taken.
  constexpr std::array<TextDialect, 11> kCandidates{{{Separator::Semicolon, '.'},
                                                     {Separator::Semicolon, ','},
                                                     {Separator::Tab, '.'},
                                                     {Separator::Tab, ','},
                                                     {Separator::Bar, '.'},
                                                     {Separator::Bar, ','},
                                                     {Separator::Comma, '.'},
                                                     {Separator::Comma, ','},
                                                     {Separator::CommaBlank, ','},
                                                     {Separator::Blanks, '.'},
                                                     {Separator::Blanks, ','}}};
  TextDialect best;
  Fit bestFit;
  for (const TextDialect& candidate : kCandidates) {
    const Fit fit = fitOf(sample, candidate);
    if (candidate.isExact() && fit.columns < 2) continue;
    // In "1,5, 2,5" each column has two of the fields that every comma makes.
    const bool halves = candidate.separator == Separator::CommaBlank &&
                        best.separator == Separator::Comma && fit.score >= bestFit.score &&
                        2 * fit.columns == bestFit.columns;
    // Lines such as "Ra 0.5" below the rows do not make the blank a separator where another one
    // separates.
    constexpr double kBetter = 1.1;
    const bool isLoose = !candidate.isExact() && bestFit.columns > 1;
    // The blank in "1 000" is none where tabs separate numbers.
    const bool hasTabs = isLoose && best.separator == Separator::Tab && bestFit.withTexts == 0 &&
                         bestFit.rows >= fit.rows;
    if ((fit.score > bestFit.score * (isLoose ? kBetter : 1) && !hasTabs) || halves) {
      best = candidate;
      bestFit = fit;
    }
  }
  if (best == TextDialect{Separator::Comma, '.'}) {
    const auto hasPoint = [](std::string_view line) {
      return !isComment(line) && line.find('.') != std::string_view::npos &&
             line.find_first_of("0123456789") != std::string_view::npos;
    };
    const std::size_t points =
        static_cast<std::size_t>(std::ranges::count_if(sample.lines, hasPoint));
    if (2 * points < sample.lines.size()) {
      best = ofWholeNumbers(sample, bestFit);
      bestFit = fitOf(sample, best);
    }
  }
  return withRightMark(sample, best, bestFit);
}

bool readPlainRow(std::string_view line, const TextDialect& dialect, std::span<double> numbers) {
  if (dialect.separator == Separator::CommaBlank || dialect.separator == Separator::CommaPair)
    return false;
  const char mark = separatorCharacter(dialect.separator);
  const bool atBlanks = dialect.separator == Separator::Blanks;
  const char* next = line.data();
  const char* const end = next + line.size();
  const auto skipBlanks = [&] {
    while (next != end && (*next == ' ' || (*next == '\t' && mark != '\t'))) ++next;
  };
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    skipBlanks();
    if (i > 0 && !atBlanks) {
      if (next == end || *next != mark) return false;
      ++next;
      skipBlanks();
    }
    if (next != end && *next == '+') ++next;
    // Neither "inf" nor "nan", which std::from_chars takes for numbers.
    const char* first = next != end && *next == '-' ? next + 1 : next;
    if (first == end || !(isDigit(*first) || *first == '.')) return false;
    if (dialect.decimal == '.') {
      const auto [stop, error] = std::from_chars(next, end, numbers[i]);
      if (error != std::errc{}) return false;
      next = stop;
    } else {
      const char* stop = next;
      while (stop != end && !isBlankOrTab(*stop) && *stop != mark) ++stop;
      const auto size = static_cast<std::size_t>(stop - next);
      if (!readTextNumber(std::string_view(next, size), ',', numbers[i])) return false;
      next = stop;
    }
    if (next != end && !isBlankOrTab(*next) && *next != mark) return false;
  }
  skipBlanks();
  return next == end;
}

}  // namespace asperity
