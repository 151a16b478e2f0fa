// A range of values of one parameter, as an axis of a chart or a map: "FROM:TO:N", logarithmic
// where the parameter's slider is; "FROM:TO:N:linear" or ":log" overrides that. FROM and TO may
// have units ("1mN:10N:41"). All such options share this syntax. Pure; any thread.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/parameters.h"

namespace asperity {

struct ParameterRange {
  const Parameter* row = nullptr;  // with a RealField or an IntegerField
  double from = 0, to = 0;         // in the row's unit; `from` above `to` runs downwards
  std::int64_t points = 1;
  bool isLogarithmic = false;

  std::string_view key() const { return row->key; }
  bool operator==(const ParameterRange&) const = default;
};

inline constexpr std::int64_t kMaxRangePoints = 100000;

/// A usual range reaches from the scene's own value over this factor, two decades, to each side.
inline constexpr double kUsualRangeFactor = 100;

/// Returns x_i = from (to / from)^(i / (points - 1)), with the last one exactly `to`.
std::vector<double> logSpaced(double from, double to, std::int64_t points);

/// Returns x_i = from + (to - from) i / (points - 1), with the last one exactly `to`.
std::vector<double> linearSpaced(double from, double to, std::int64_t points);

/// Reads "FROM:TO:N" optionally followed by ":log" or ":linear". Throws InputError with the
/// key.
ParameterRange parseRange(std::string_view key, std::string_view text);

/// Reads the number of a text with a unit, "20 mN", in the member `where` of a file. Throws
/// InputError with that path.
double parseMember(const Parameter& row, const std::string& text, const std::string& where);

/// Reads an end of a range from an object {"from", "to", ...}: a number, or a text with a unit such
/// as "1 mN". where: the object in errors. Throws InputError with the path of the member.
double rangeEnd(const Parameter& row, const nlohmann::ordered_json& range, const std::string& where,
                const char* member);

/// Reads "KEY=FROM:TO:N". Throws InputError with the key, or with the option's name.
ParameterRange parseRangeOption(const std::string& option, std::string_view text);

/// Throws InputError with the key where the parameter has no meaning in the scene, a logarithmic
/// range touches 0, or there are too few or too many points.
void checkRange(const ParameterRange& range, const Scene& scene);

/// Returns the values, spaced evenly in their logarithm or evenly. Whole numbers are rounded and
/// repeats left out; one point is `from`.
std::vector<double> rangeValues(const ParameterRange& range);

/// Returns the range as text that reads back to the same range.
std::string formatRange(const ParameterRange& range);

}  // namespace asperity
