#include "app/number_range.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "core/base/input_error.h"
#include "core/base/read_number.h"
#include "core/base/suggestions.h"

namespace asperity {
namespace {

bool readFinite(std::string_view text, double& number) {
  return readNumber(text, number) && std::isfinite(number);
}

}  // namespace

NumberRange rangeFrom(const std::string& option, const std::string& text, const std::string& unit) {
  const std::string_view all = text;
  const std::size_t colon = all.find(':');
  NumberRange range;
  if (colon == std::string_view::npos || !readFinite(all.substr(0, colon), range.from) ||
      !readFinite(all.substr(colon + 1), range.to) || !(range.from < range.to))
    throw InputError("", option,
                     message("{} is not FROM:TO{} with FROM below TO", shortened(text),
                             unit.empty() ? "" : " in " + unit));
  return range;
}

}  // namespace asperity
