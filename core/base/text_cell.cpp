#include "core/base/text_cell.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/number_text.h"
#include "core/base/text.h"
#include "core/base/text_number.h"
#include "core/base/text_units.h"

namespace asperity {
namespace {

/// A number at the beginning of a text.
struct Beginning {
  std::string_view digits;
  double number = 0;
  std::string_view rest;
};

/// Takes the longest beginning that is a number; no thousands, because what stands after them may
/// be anything.
std::optional<Beginning> takeNumber(std::string_view text, char decimal) {
  text = trimmedBlanks(text);
  for (std::size_t size = std::min(text.find_first_not_of(kBytesOfNumbers), text.size()); size > 0;
       --size) {
    double number = 0;
    if (readTextNumber(text.substr(0, size), decimal, number))
      return Beginning{text.substr(0, size), number, text.substr(size)};
  }
  return {};
}

/// Returns whether a text can be the unit of a cell. One that begins with a digit is the end of a
/// number, "1 000 mm/s", or another remark, "0.31 (2)".
bool isCellUnit(std::string_view text) {
  text = withoutBrackets(text);
  return !text.empty() && !isDigit(text.front()) && text != "-" && isKnownUnit(text);
}

/// Reads the error in brackets after a number: "0.31(2)", "0.31(0.02)". Returns what stands after
/// it.
std::optional<std::string_view> takeConcise(const Beginning& value, char decimal, double& error) {
  const std::size_t end = value.rest.find(')');
  if (end == std::string_view::npos) return {};
  const std::string_view inner = value.rest.substr(1, end - 1);
  if (!readTextNumber(inner, decimal, error) || !isDigit(inner.front())) return {};
  if (value.digits.find_first_of("eEdD") != std::string_view::npos) return {};
  const std::size_t mark = value.digits.find(decimal);
  if (inner.find(decimal) == std::string_view::npos && mark != std::string_view::npos)
    readTextNumber(fmt::format("{}e-{}", inner, value.digits.size() - mark - 1), '.', error);
  if (!(error < std::abs(value.number))) return {};
  return trimmedBlanks(value.rest.substr(end + 1));
}

bool isImaginaryUnit(std::string_view text) {
  return isOneOf(text, "i j");
}

/// Takes an imaginary part with its sign, "+0.3i", "- j*0.3"; returns what stands after it.
std::optional<std::string_view> takeImaginary(std::string_view text, char decimal,
                                              double& imaginary) {
  text = trimmedBlanks(text);
  double sign = 1;
  for (const std::string_view minus : {kMinusSign, std::string_view("-"), std::string_view("+")})
    if (text.starts_with(minus)) {
      sign = minus == "+" ? 1 : -1;
      text = trimmedBlanks(text.substr(minus.size()));
      const bool isInFront = !text.empty() && isImaginaryUnit(text.substr(0, 1));
      if (isInFront) text = trimmedBlanks(text.substr(1));
      if (isInFront && text.starts_with('*')) text.remove_prefix(1);
      const auto part = takeNumber(text, decimal);
      if (!part || !(part->number >= 0)) return {};
      std::string_view rest = trimmedBlanks(part->rest);
      if (!isInFront) {
        if (rest.starts_with('*')) rest = trimmedBlanks(rest.substr(1));
        if (rest.empty() || !isImaginaryUnit(rest.substr(0, 1))) return {};
        rest.remove_prefix(1);
      }
      imaginary = sign * part->number;
      return trimmedBlanks(rest);
    }
  return {};
}

/// Reads "1.2, 0.3" within brackets as a real and an imaginary part.
std::optional<double> readPair(std::string_view rest, char decimal) {
  rest = trimmedBlanks(rest);
  const bool isSeparated = rest.starts_with(';') || (rest.starts_with(',') && decimal != ',');
  double imaginary = 0;
  if (!isSeparated || !readTextNumber(trimmedBlanks(rest.substr(1)), decimal, imaginary)) return {};
  return imaginary;
}

/// Reads a sign of errors with the error after it, and the unit of one or both.
bool takeTolerance(std::string_view text, double number, char decimal, TextCell& rest) {
  const auto sides = splitAtErrorSign(text);
  if (!sides) return false;
  const std::string_view own = trimmedBlanks(sides->number);
  const auto error = takeNumber(sides->error, decimal);
  if (!error || !(error->number >= 0) || !(own.empty() || isCellUnit(own))) return false;
  const std::string_view unit = trimmedBlanks(error->rest);
  const bool isShare = unit == "%" && own != "%";
  rest.error = isShare ? std::abs(number) * error->number / 100 : error->number;
  rest.unit = withoutBrackets(own.empty() ? unit : own);
  if (own.empty()) return unit.empty() || (!isShare && isCellUnit(unit));
  return isShare || unit == own;
}

}  // namespace

std::optional<ErrorSides> splitAtErrorSign(std::string_view text) {
  for (const std::string_view sign : kErrorSigns)
    if (const std::size_t at = text.find(sign); at != text.npos)
      return ErrorSides{text.substr(0, at), text.substr(at + sign.size())};
  return {};
}

std::optional<CellQuantity> readCell(std::string_view text, char decimal) {
  text = trimmedField(text);
  CellQuantity cell;
  cell.rest.text = text;
  std::string_view behind;
  const bool isInBrackets = text.starts_with('(');
  if (const std::size_t end = text.rfind(')'); isInBrackets && end != text.npos) {
    behind = trimmedBlanks(text.substr(end + 1));
    text = text.substr(1, end - 1);
    if (!behind.empty() && !isCellUnit(behind)) return {};
  }
  const auto value = takeNumber(text, decimal);
  if (!value) return {};
  cell.digits = value->digits;
  cell.number = value->number;
  const std::string_view rest = trimmedBlanks(value->rest);
  if (containsOneOf(rest, kErrorSigns)) {
    if (!takeTolerance(rest, cell.number, decimal, cell.rest)) return {};
  } else if (const auto left = takeImaginary(rest, decimal, cell.rest.imaginary)) {
    if (!left->empty() && !isCellUnit(*left)) return {};
    cell.rest.unit = withoutBrackets(*left);
  } else if (const auto pair = isInBrackets ? readPair(rest, decimal) : std::nullopt) {
    cell.rest.imaginary = *pair;
  } else {
    std::string_view unit = rest;
    if (value->rest.starts_with('(')) {
      const auto afterError = takeConcise(*value, decimal, cell.rest.error);
      if (!afterError) return {};
      unit = *afterError;
    }
    if (unit.empty() ? std::isnan(cell.rest.error) : !isCellUnit(unit)) return {};
    cell.rest.unit = withoutBrackets(unit);
  }
  // "(0.31 \u00B1 0.02) N"
  if (!behind.empty() && !cell.rest.unit.empty()) return {};
  if (!behind.empty()) cell.rest.unit = behind;
  return cell;
}

namespace {

/// Returns whether a text is a number times the imaginary unit.
bool isImaginary(std::string_view text) {
  return (isImaginaryUnit(text.substr(0, 1)) && isDigit(text.back())) ||
         (isImaginaryUnit(text.substr(text.size() - 1)) && isDigit(text.front()));
}

}  // namespace

void joinCells(std::vector<std::string_view>& fields) {
  std::size_t count = 0;  // of the fields that are left
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const bool isSign = count > 0 && i + 1 < fields.size() &&
                        (isOneOf(fields[i], kErrorSigns) ||
                         (isOneOf(fields[i], "+ - \u2212") && isImaginary(fields[i + 1])));
    const bool isUnit = count > 0 && fields[i].size() > 1 && isDigit(fields[count - 1].back()) &&
                        isCellUnit(fields[i]);
    if (!isSign && !isUnit) {
      fields[count++] = fields[i];
      continue;
    }
    if (isSign) ++i;  // the error
    const char* const begin = fields[count - 1].data();
    const char* const end = fields[i].data() + fields[i].size();
    fields[count - 1] = {begin, static_cast<std::size_t>(end - begin)};
  }
  fields.resize(count);
}

}  // namespace asperity
