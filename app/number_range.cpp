#include "app/number_range.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string_view>

#include "core/scene/input_error.h"

namespace asperity {
namespace {

bool readNumber(std::string_view text, double& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size() && std::isfinite(number);
}

}  // namespace

NumberRange rangeFrom(const std::string& option, const std::string& text, const std::string& unit) {
  const std::string_view all = text;
  const std::size_t colon = all.find(':');
  NumberRange range;
  if (colon == std::string_view::npos || !readNumber(all.substr(0, colon), range.from) ||
      !readNumber(all.substr(colon + 1), range.to) || !(range.from < range.to))
    throw InputError("", option,
                     fmt::format("{} is not FROM:TO{} with FROM below TO", text.substr(0, 60),
                                 unit.empty() ? "" : " in " + unit));
  return range;
}

}  // namespace asperity
