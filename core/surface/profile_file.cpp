#include "core/surface/profile_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/regular_file.h"
#include "core/surface/profile_header.h"

namespace asperity {
namespace {

constexpr std::size_t kLargestProfile = std::size_t{1} << 28;  // bytes
constexpr double kFarthest = 1e6;                              // m, of positions and heights
constexpr double kUniform = 1e-6;  // relative deviation of a spacing that is accepted
constexpr std::size_t kMostRows = std::size_t{1} << 24;

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n\"";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

constexpr std::size_t kMostFields = 3;  // of a row that are looked at; more than two are refused

/// The line's first fields, split at commas, semicolons or tabs.
std::vector<std::string_view> fieldsOf(std::string_view line) {
  std::vector<std::string_view> fields;
  while (true) {
    const std::size_t end = line.find_first_of(",;\t");
    fields.push_back(trimmed(line.substr(0, end)));
    if (end == std::string_view::npos || fields.size() == kMostFields) return fields;
    line.remove_prefix(end + 1);
  }
}

/// As instruments write it, too: +1.5.
bool readField(std::string_view text, double& number) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  return readNumber(text, number);
}

bool isDigit(char letter) {
  return letter >= '0' && letter <= '9';
}

/// Whether the comma between two fields may as well stand within one number: "0,05", whose second
/// half no program writes for a whole number, and, where no header says that there are two columns,
/// "1,250", or any two whole numbers under the name of one column.
bool mayBeOneNumber(std::string_view line, std::size_t namedColumns) {
  const std::size_t comma = line.find(',');
  if (comma == std::string_view::npos) return false;
  if (line.find_first_of(";\t") != std::string_view::npos) return true;
  std::string_view before = line.substr(0, comma), after = line.substr(comma + 1);
  if (!before.empty() && (before.front() == '-' || before.front() == '+')) before.remove_prefix(1);
  const auto isWhole = [](std::string_view text) {
    return !text.empty() && std::ranges::all_of(text, isDigit);
  };
  if (!isWhole(before)) return false;
  if (after.size() > 1 && after.front() == '0' && isDigit(after[1])) return true;
  if (!isWhole(after) || namedColumns == 2) return false;
  const bool isGrouped = before.size() <= 3 && before.front() != '0' && after.size() == 3;
  return isGrouped || namedColumns == 1;
}

class Reader {
 public:
  Reader(std::string_view text, const std::string& name) : rest_(text), name_(name) {
    if (const std::string_view kind = foreignKindOf(text); !kind.empty())
      fail(message("is {}; a profile is CSV in UTF-8", Message(kind)));
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
  }

  Profile read() {
    while (!rest_.empty()) takeLine();
    if (height_.size() < 3)
      fail(message("has {} rows of numbers; at least 3 are needed", height_.size()));
    return {position_.empty() ? 0 : lengthOfPositions(), std::move(height_)};
  }

 private:
  /// Messages name places, not what stands there: a scene may name any file.
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
          numbers.size() < kMostFields
              ? message("row {}: has {} columns; position and height, or height alone, are needed",
                        row_, numbers.size())
              : message("row {}: has {} columns or more; position and height, or height alone, are "
                        "needed",
                        row_, numbers.size()));
    if (height_.size() == kMostRows) fail(message("has more than {} rows", kMostRows));
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
                     i + 1, unit));
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

}  // namespace

Profile parseProfile(std::string_view text, const std::string& name) {
  return Reader(text, name).read();
}

Profile readProfile(const std::filesystem::path& file) {
  return parseProfile(readRegularFile(file, kLargestProfile), file.string());
}

std::int64_t expectedRows(const std::filesystem::path& file) {
  constexpr std::uintmax_t kBytesOfRow = 24;
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  return error ? 0 : static_cast<std::int64_t>(size / kBytesOfRow);
}

}  // namespace asperity
