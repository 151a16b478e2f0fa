#include "core/scene/range.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/scene/sweep.h"

namespace asperity {
namespace {

[[noreturn]] void refuse(std::string_view key, const Message& what) {
  throw InputError("", std::string(key), what);
}

std::vector<std::string_view> splitAtColons(std::string_view text) {
  std::vector<std::string_view> parts;
  for (std::size_t colon; (colon = text.find(':')) != std::string_view::npos;
       text.remove_prefix(colon + 1))
    parts.push_back(text.substr(0, colon));
  parts.push_back(text);
  return parts;
}

}  // namespace

const Parameter& numberRow(std::string_view key) {
  const Parameter& row = knownParameter(key);
  if (!allowedRange(row)) refuse(key, message("is not a number, so it has no range"));
  return row;
}

bool isWholeNumber(const Parameter& row) {
  return std::holds_alternative<IntegerField>(row.field);
}

double parameterNumber(const Parameter& row, const Scene& scene) {
  const ParameterValue value = parameterValue(row, scene);
  const auto* whole = std::get_if<std::int64_t>(&value);
  return whole ? static_cast<double>(*whole) : std::get<double>(value);
}

void setNumber(const Parameter& row, Scene& scene, double number) {
  setValue(row, scene, isWholeNumber(row) ? std::round(number) : number);
}

double parseNumber(const Parameter& row, std::string_view text) {
  Scene scratch;
  setFromText(row, scratch, text);
  return parameterNumber(row, scratch);
}

bool hasLogarithmicSlider(const Parameter& row) {
  if (const auto* real = std::get_if<RealField>(&row.field)) return real->scale != Scale::Linear;
  if (const auto* whole = std::get_if<IntegerField>(&row.field))
    return whole->scale != Scale::Linear;
  return false;
}

ParameterRange parseRange(std::string_view key, std::string_view text) {
  const Parameter& row = numberRow(key);
  const std::vector<std::string_view> parts = splitAtColons(text);
  const auto refuseText = [&] {
    refuse(key,
           message("'{}' is not FROM:TO:N, such as 0.001:10:41, with :log or :linear behind it "
                   "where wanted",
                   shortened(text)));
  };
  if (parts.size() != 3 && parts.size() != 4) refuseText();
  ParameterRange range{&row, 0, 0, 1, hasLogarithmicSlider(row)};
  range.from = parseNumber(row, parts[0]);
  range.to = parseNumber(row, parts[1]);
  if (!readNumber(parts[2], range.points)) refuseText();
  if (range.points < 1 || range.points > kMostRangePoints)
    refuse(key, message("{} points are outside 1 to {}", range.points, kMostRangePoints));
  if (parts.size() == 4) {
    if (parts[3] != "log" && parts[3] != "linear") refuseText();
    range.isLogarithmic = parts[3] == "log";
  } else if (!(range.from > 0 && range.to > 0)) {
    range.isLogarithmic = false;
  }
  return range;
}

ParameterRange parseRangeOption(const std::string& option, std::string_view text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos || equals == 0)
    throw InputError("", option,
                     message("'{}' is not KEY=FROM:TO:N, such as load.normal_force=0.001:10:41",
                             shortened(text)));
  return parseRange(text.substr(0, equals), text.substr(equals + 1));
}

void checkRange(const ParameterRange& range, const Scene& scene) {
  if (!isApplicable(*range.row, scene))
    refuse(range.key(), message("has no meaning in this scene, so nothing depends on it"));
  if (range.isLogarithmic && !(range.from > 0 && range.to > 0))
    refuse(range.key(), message("a logarithmic range needs ends above 0; {} is not",
                                plain(range.from > 0 ? range.to : range.from)));
}

std::vector<double> rangeValues(const ParameterRange& range) {
  std::vector<double> values = range.isLogarithmic
                                   ? logSpaced(range.from, range.to, range.points)
                                   : linearSpaced(range.from, range.to, range.points);
  if (isWholeNumber(*range.row)) {
    for (double& value : values) value = std::round(value);
    values.erase(std::unique(values.begin(), values.end()), values.end());
  }
  return values;
}

std::string formatRange(const ParameterRange& range) {
  return fmt::format("{}:{}:{}:{}", plainNumber(range.from), plainNumber(range.to), range.points,
                     range.isLogarithmic ? "log" : "linear");
}

}  // namespace asperity
