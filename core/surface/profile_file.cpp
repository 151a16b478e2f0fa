#include "core/surface/profile_file.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/regular_file.h"
#include "core/base/text.h"
#include "core/base/text_encoding.h"
#include "core/base/text_number.h"

namespace asperity {
namespace {

// ---- The names of columns in the first row ------------------------------------------------------

bool isLetter(char letter) {
  const auto byte = static_cast<unsigned char>(letter);
  return byte >= 0x80 || std::isalpha(byte) != 0;
}

/// Words that programs write for a missing value.
constexpr WordList kMissing("na n/a nan null none missing bad");

/// Returns whether a field begins like a number: 1, -1, .5, -.5, or what the reader takes for
/// infinity.
bool beginsAsValue(std::string_view field) {
  if (!field.empty() && (field.front() == '+' || field.front() == '-')) field.remove_prefix(1);
  if (!field.empty() && field.front() == '.') field.remove_prefix(1);
  const std::string word = lowerCase(field);
  return (!field.empty() && isDigit(field.front())) || word == "inf" || word == "infinity";
}

constexpr WordList kMetres("m metre metres meter meters");

/// Units of length that are not words of a language, also in Latin-1.
constexpr WordList kLengths(
    "mm cm dm km um nm pm fm \u00B5m \u03BCm mum \xB5m micron microns micrometer "
    "micrometers micrometre micrometres millimeter millimeters millimetre millimetres "
    "centimeter centimeters centimetre centimetres nanometer nanometers nanometre "
    "nanometres kilometer kilometers kilometre kilometres angstrom angstroms \u00C5 "
    "\u212B \u00E5 inch inches pixel pixels px \xC5 \u339A \u339B \u339C \u339D");

/// Units that are also words or letters; they count only in brackets and after a slash.
constexpr WordList kShortUnits(
    "in ft yd mil mils thou pt a s ms us min v mv uv n deg rad \u00B0 % arb a.u. au "
    "counts count feet foot \" index samples");

/// "(", "[" and "{" end at their counterparts; a stroke reaches to the end.
constexpr std::string_view kOpening = "([{/";

/// Returns each text in brackets or after a slash in the name.
std::vector<std::string_view> bracketed(std::string_view name) {
  std::vector<std::string_view> found;
  for (std::size_t at = 0; (at = name.find_first_of(kOpening, at)) != std::string_view::npos;) {
    const std::string_view closing = name[at] == '/' ? "" : ")]}";
    const std::size_t end = closing.empty() ? name.size() : name.find_first_of(closing, at);
    found.push_back(
        name.substr(at + 1, (end == std::string_view::npos ? name.size() : end) - at - 1));
    ++at;
  }
  return found;
}

/// Returns the words of a name, split at characters that no unit contains.
std::vector<std::string> lowerCaseWords(std::string_view text) {
  std::vector<std::string> words;
  constexpr std::string_view between = " \t_()[]{}/,;:=*";
  while (true) {
    const std::size_t first = text.find_first_not_of(between);
    if (first == std::string_view::npos) return words;
    const std::size_t end = std::min(text.find_first_of(between, first), text.size());
    words.push_back(lowerCase(text.substr(first, end - first)));
    text.remove_prefix(end);
  }
}

/// Returns whether metres have a factor in front: "1e-6 m", "10^-9 m", "\u00D710\u207B\u2076 m".
bool scalesMetres(const std::vector<std::string>& words) {
  const auto isMetres = [](const std::string& word) { return isOneOf(word, kMetres); };
  return words.size() > 1 && std::ranges::any_of(words, isMetres) &&
         std::ranges::any_of(
             words, [](const std::string& word) { return std::ranges::any_of(word, isDigit); });
}

/// Returns whether the fields of a first row are names of columns: at least one has a letter, and
/// none begins like a number or stands for a missing value.
bool namesColumns(std::span<const std::string_view> fields) {
  const auto isName = [](std::string_view field) { return std::ranges::any_of(field, isLetter); };
  const auto isValue = [](std::string_view field) {
    return beginsAsValue(field) || isOneOf(lowerCase(field), kMissing);
  };
  return std::ranges::any_of(fields, isName) && std::ranges::none_of(fields, isValue);
}

/// Returns the unit other than metres in the name of a column: "mm" of "x (mm)", "height [mm]",
/// "z/mm", "z_mm" and "z mm". Empty where there is none.
std::string foreignUnitIn(std::string_view name) {
  for (const std::string_view part : bracketed(name)) {
    const std::vector<std::string> words = lowerCaseWords(part);
    if (scalesMetres(words)) return std::string(part);
    if (words.size() == 1 && isOneOf(words.front(), kShortUnits)) return words.front();
  }
  for (const std::string& word : lowerCaseWords(name))
    if (isOneOf(word, kLengths)) return word;
  return {};
}

/// Returns whether the field is one word with a unit in brackets or after a slash, as in the
/// names of columns in comments: "x (mm)", "z/um".
bool isWordWithUnit(std::string_view field) {
  const std::size_t opening = field.find_first_of(kOpening);
  if (opening == std::string_view::npos || opening == 0) return false;
  std::string_view name = field.substr(0, opening);
  while (!name.empty() && name.back() == ' ') name.remove_suffix(1);
  return !name.empty() && name.find(' ') == std::string_view::npos;
}

// ---- The rows -----------------------------------------------------------------------------------

constexpr std::size_t kLargestProfile = std::size_t{1} << 28;  // bytes
constexpr double kFarthest = 1e6;                              // m, of positions and heights
constexpr double kUniform = 1e-6;  // relative deviation of a spacing that is accepted
constexpr std::size_t kMaxRows = std::size_t{1} << 24;

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n\"";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

constexpr std::size_t kMaxFields = 3;  // of a row that are looked at; more than two are refused

/// Returns the line's first fields, split at commas, semicolons or tabs.
std::vector<std::string_view> fieldsOf(std::string_view line) {
  std::vector<std::string_view> fields;
  while (true) {
    const std::size_t end = line.find_first_of(",;\t");
    fields.push_back(trimmed(line.substr(0, end)));
    if (end == std::string_view::npos || fields.size() == kMaxFields) return fields;
    line.remove_prefix(end + 1);
  }
}

/// Reads a number, also with a plus sign as instruments write it: +1.5.
bool readField(std::string_view text, double& number) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  return readNumber(text, number);
}

/// Returns whether the comma between two fields may be a decimal or thousands mark within one
/// number: in "0,05", whose second half no program writes as a whole number; and where no header
/// states two columns, in "1,250", or in any two whole numbers under the name of one column.
bool mayBeOneNumber(std::string_view line, std::size_t namedColumns) {
  const std::size_t comma = line.find(',');
  if (comma == std::string_view::npos) return false;
  if (line.find_first_of(";\t") != std::string_view::npos) return true;
  std::string_view before = line.substr(0, comma), after = line.substr(comma + 1);
  if (!before.empty() && (before.front() == '-' || before.front() == '+')) before.remove_prefix(1);
  if (!areDigits(before)) return false;
  if (after.size() > 1 && after.front() == '0' && isDigit(after[1])) return true;
  if (!areDigits(after) || namedColumns == 2) return false;
  const bool isGrouped = before.size() <= 3 && before.front() != '0' && after.size() == 3;
  return isGrouped || namedColumns == 1;
}

class Reader {
 public:
  explicit Reader(const std::string& name) : name_(name) {}

  /// Reads the beginning of a file.
  void begin(std::string_view text) {
    if (const std::string_view kind = detectNonText(text); !kind.empty())
      fail(message("is {}; a profile is CSV in UTF-8", Message(kind)));
    take(withoutByteOrderMark(text));
  }

  /// Reads further whole lines, directly after the earlier ones or further on in the file.
  void take(std::string_view text) {
    rest_ = text;
    while (!rest_.empty()) takeLine();
  }

  /// Returns the profile of all rows read, or of the first `most` of them.
  Profile profile(std::size_t most = kMaxRows) {
    if (height_.size() < 3)
      fail(message("has {} rows of numbers; at least 3 are needed", height_.size()));
    if (height_.size() > most) height_.resize(most);
    if (position_.size() > most) position_.resize(most);
    return {position_.empty() ? 0 : lengthOfPositions(), std::move(height_)};
  }

  const std::vector<double>& positions() const { return position_; }  // empty: heights alone
  const std::vector<double>& heights() const { return height_; }

 private:
  /// Messages name the row but do not quote it: a scene may name any file.
  [[noreturn]] void fail(const Message& message) const { throw InputError(name_, "", message); }

  void takeLine() {
    ++row_;
    const std::size_t end = rest_.find('\n');
    const std::string_view line = trimmed(rest_.substr(0, end));
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    if (line.empty()) return;
    if (line.front() == '#') return takeComment(fieldsOf(line.substr(1)));
    const std::vector<std::string_view> fields = fieldsOf(line);
    if (height_.empty() && headerColumns_ == 0 && namesColumns(fields)) return takeHeader(fields);
    if (mayBeOneNumber(line, headerColumns_))
      fail(message(
          "row {}: the comma may divide columns, thousands or decimals; numbers are written with a "
          "point and without thousands separators",
          row_));
    takeNumbers(fields);
  }

  void takeNumbers(const std::vector<std::string_view>& fields) {
    std::vector<double> numbers;
    for (const std::string_view field : fields) {
      double number = 0;
      const std::size_t column = numbers.size() + 1;
      if (!readField(field, number))
        fail(message("row {}: column {} is not a number", row_, column));
      if (!std::isfinite(number))
        fail(message("row {}: column {} is not a finite number", row_, column));
      if (std::abs(number) > kFarthest)
        fail(message("row {}: column {} is beyond {} m", row_, column, kFarthest));
      numbers.push_back(number);
    }
    if (height_.empty()) columns_ = numbers.size();
    if (numbers.size() != columns_ || columns_ > 2)
      fail(
          numbers.size() < kMaxFields
              ? message("row {}: has {} columns; position and height, or height alone, are needed",
                        row_, numbers.size())
              : message("row {}: has {} columns or more; position and height, or height alone, are "
                        "needed",
                        row_, numbers.size()));
    if (height_.size() == kMaxRows) fail(message("has more than {} rows", kMaxRows));
    if (columns_ == 2) position_.push_back(numbers.front());
    height_.push_back(numbers.back());
  }

  void takeHeader(const std::vector<std::string_view>& names) {
    headerColumns_ = names.size();
    refuseForeignUnits(names);
  }

  /// Some programs write the names of the columns as a comment.
  void takeComment(const std::vector<std::string_view>& fields) const {
    if (height_.empty() && fields.size() <= 2 && std::ranges::all_of(fields, isWordWithUnit))
      refuseForeignUnits(fields);
  }

  void refuseForeignUnits(const std::vector<std::string_view>& names) const {
    for (std::size_t i = 0; i < names.size(); ++i)
      if (const std::string unit = foreignUnitIn(names[i]); !unit.empty())
        fail(message("row {}: column {} is in '{}'; positions and heights are in metres", row_,
                     i + 1, shortened(unit)));
  }

  double lengthOfPositions() const {
    const double rows = static_cast<double>(position_.size());
    const double spacing = (position_.back() - position_.front()) / (rows - 1);
    if (!(spacing > 0)) fail("positions must increase");
    for (std::size_t i = 1; i < position_.size(); ++i) {
      const double step = position_[i] - position_[i - 1];
      if (std::abs(step - spacing) > kUniform * spacing + 4e-16 * std::abs(position_[i]))
        fail(
            message("spacing {} after data row {} differs from {}; positions must be uniform to {}",
                    step, i, spacing, plain(kUniform)));
    }
    return spacing * rows;
  }

  std::string_view rest_;
  std::string name_;
  std::size_t row_ = 0, columns_ = 0;
  std::size_t headerColumns_ = 0;  // 0: no header
  std::vector<double> position_, height_;
};

// ---- A large file, estimated from parts of it --------------------------------------------------

constexpr std::size_t kSmallFile = std::size_t{1} << 15;  // bytes, that are read whole
constexpr std::size_t kOfBeginning = std::size_t{1} << 14, kOfEnd = std::size_t{1} << 12;
constexpr std::size_t kOfSample = std::size_t{1} << 9;
constexpr std::size_t kSamples = 64;  // evenly spread over the file

/// Returns the text without an incomplete last line.
std::string_view wholeLines(std::string_view text) {
  const std::size_t end = text.rfind('\n');
  return end == std::string_view::npos ? std::string_view{} : text.substr(0, end + 1);
}

/// Returns the text without an incomplete first line.
std::string_view fromNextLine(std::string_view text) {
  const std::size_t end = text.find('\n');
  return end == std::string_view::npos ? std::string_view{} : text.substr(end + 1);
}

/// Returns the first complete line after a position inside the file, with its end.
std::string_view nextLine(std::string_view text) {
  const std::string_view lines = fromNextLine(text);
  return lines.substr(0, lines.find('\n') + 1);
}

double rmsOf(std::span<const double> heights) {
  double sum = 0, squares = 0;
  const auto count = static_cast<double>(heights.size());
  for (const double height : heights) sum += height;
  for (const double height : heights) squares += std::pow(height - sum / count, 2);
  return std::sqrt(squares / count);
}

ProfileExtent extentOf(const Profile& profile) {
  return {static_cast<std::int64_t>(profile.height.size()), profile.length, rmsOf(profile.height)};
}

/// Estimates rows and length of a file from its first rows and its last one, and the height from
/// parts in between. Empty where they do not fit together; throws InputError where they are no rows
/// of a profile.
std::optional<ProfileExtent> extentOfParts(const RegularFile& file, const std::string& name) {
  const std::string start = file.read(0, kOfBeginning);
  const std::string_view lines = wholeLines(start);
  Reader beginning(name);
  beginning.begin(lines);
  Reader reader = beginning;
  const std::size_t first = reader.heights().size();
  const double spacing = beginning.profile().length / static_cast<double>(first);

  double bytes = 0;
  for (std::size_t i = 0; i < kSamples; ++i) {
    const double part = (static_cast<double>(i) + 0.5) / static_cast<double>(kSamples);
    const auto offset = static_cast<std::uint64_t>(part * static_cast<double>(file.size()));
    const std::string text = file.read(offset, kOfSample);
    const std::string_view line = nextLine(text);
    bytes += static_cast<double>(line.size());
    reader.take(line);
  }
  const std::size_t spread = reader.heights().size() - first;
  if (spread == 0) return {};
  const double expected =
      static_cast<double>(first) +
      static_cast<double>(file.size() - lines.size()) * static_cast<double>(spread) / bytes;
  const std::vector<double>& heights = reader.heights();
  ProfileExtent extent{std::llround(expected), 0, rmsOf(std::span(heights).subspan(first))};

  const std::string end = file.read(file.size() - kOfEnd, kOfEnd);
  reader.take(fromNextLine(end));
  if (reader.heights().size() == first + spread) return {};  // the last row is further up
  if (spacing > 0) {
    const double distance = reader.positions().back() - reader.positions().front();
    extent.rows = std::llround(distance / spacing) + 1;
    extent.length = spacing * static_cast<double>(extent.rows);
    const double ofExpected = static_cast<double>(extent.rows) / expected;
    if (ofExpected < 0.5 || ofExpected > 2) return {};
  }
  if (extent.rows > static_cast<std::int64_t>(kMaxRows)) return {};
  return extent;
}

}  // namespace

Profile parseProfile(std::string_view text, const std::string& name) {
  Reader reader(name);
  reader.begin(text);
  return reader.profile();
}

Profile readProfile(const std::filesystem::path& file) {
  return parseProfile(readRegularFile(file, kLargestProfile), file.string());
}

ProfileExtent profileExtent(const std::filesystem::path& file) {
  const RegularFile regular(file);
  if (regular.size() > kSmallFile && regular.size() <= kLargestProfile) {
    try {
      if (const auto extent = extentOfParts(regular, file.string())) return *extent;
    } catch (const InputError&) {
      // The number of a wrong row is not known here; reading the whole file finds it.
    }
  }
  return extentOf(readProfile(file));
}

Profile readProfileStart(const std::filesystem::path& file, std::int64_t rows) {
  const RegularFile regular(file);
  const auto wanted = static_cast<std::size_t>(rows);
  Reader reader(file.string());
  std::string text;
  for (std::uint64_t offset = 0; offset < regular.size() && reader.heights().size() < wanted;) {
    const std::string part = regular.read(offset, kOfBeginning);
    if (part.empty()) break;  // it has become shorter
    text += part;
    const bool isFirst = offset == 0;
    offset += part.size();
    const std::string_view lines = offset < regular.size() ? wholeLines(text) : text;
    if (isFirst)
      reader.begin(lines);
    else
      reader.take(lines);
    text.erase(0, lines.size());
  }
  return reader.profile(wanted);
}

}  // namespace asperity
