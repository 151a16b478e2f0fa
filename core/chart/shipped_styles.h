// The shipped styles of figures: the files of resources/styles as they are. Constant; any thread.
#pragma once

#include <span>
#include <string_view>

namespace asperity {

struct ShippedStyle {
  std::string_view name, json;
};

std::span<const ShippedStyle> shippedStyleFiles();

}  // namespace asperity
