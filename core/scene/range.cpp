#include "core/scene/range.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/input_error.h"
#include "core/base/json_text.h"
#include "core/base/number_text.h"
#include "core/base/text.h"

namespace asperity {
namespace {

[[noreturn]] void refuse(std::string_view key, const Message& what) {
  throw InputError("", std::string(key), what);
}

int decadeOf(double value) {
  return static_cast<int>(std::floor(std::log10(std::abs(value))));
}

/// Rounds to the 15th digit of `largest`; what is smaller than that is 0.
double roundedBeside(double value, double largest) {
  if (value == 0) return 0;
  const int digits = 15 - (decadeOf(largest) - decadeOf(value));
  return digits > 0 ? roundedToDigits(value, digits) : 0;
}

}  // namespace

std::vector<double> logSpaced(double from, double to, std::int64_t points) {
  std::vector<double> values{from};
  // In higher precision, so that 15 digits are right: decades of a sweep are met exactly.
  const long double ratio = static_cast<long double>(to) / from;
  for (std::int64_t i = 1; i + 1 < points; ++i) {
    const long double part = static_cast<long double>(i) / static_cast<long double>(points - 1);
    values.push_back(roundedToDigits(static_cast<double>(from * std::pow(ratio, part)), 15));
  }
  if (points > 1) values.push_back(to);
  return values;
}

std::vector<double> linearSpaced(double from, double to, std::int64_t points) {
  std::vector<double> values{from};
  const double largest = std::max(std::abs(from), std::abs(to));
  for (std::int64_t i = 1; i + 1 < points; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(points - 1);
    values.push_back(roundedBeside(from + (to - from) * part, largest));
  }
  if (points > 1) values.push_back(to);
  return values;
}

ParameterRange parseRange(std::string_view key, std::string_view text) {
  const Parameter& row = numberRow(key);
  const std::vector<std::string_view> parts = splitText(text, ":");
  const auto refuseText = [&] {
    refuse(key,
           message("'{}' is not FROM:TO:N, such as 0.001:10:41, optionally followed by :log or "
                   ":linear",
                   shortened(text)));
  };
  if (parts.size() != 3 && parts.size() != 4) refuseText();
  ParameterRange range{&row, 0, 0, 1, hasLogarithmicSlider(row)};
  range.from = parseNumber(row, parts[0]);
  range.to = parseNumber(row, parts[1]);
  if (!readNumber(parts[2], range.points)) refuseText();
  if (range.points < 1 || range.points > kMaxRangePoints)
    refuse(key, message("{} points are outside 1 to {}", range.points, kMaxRangePoints));
  if (parts.size() == 4) {
    if (parts[3] != "log" && parts[3] != "linear") refuseText();
    range.isLogarithmic = parts[3] == "log";
  } else if (!(range.from > 0 && range.to > 0)) {
    range.isLogarithmic = false;
  }
  return range;
}

double parseMember(const Parameter& row, const std::string& text, const std::string& where) {
  try {
    return parseNumber(row, text);
  } catch (const InputError& error) {
    refuseMember(where, error.message());
  }
}

double rangeEnd(const Parameter& row, const nlohmann::ordered_json& range, const std::string& where,
                const char* member) {
  const auto found = range.find(member);
  if (found == range.end() || !found->is_string()) return numberMember(range, where, member);
  return parseMember(row, found->get_ref<const std::string&>(), where + "." + member);
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
