#include "core/base/suggestions.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

namespace asperity {
namespace {

std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row[b.size()];
}

}  // namespace

std::string shortened(std::string_view text) {
  constexpr std::size_t kMost = 60;
  const auto isInside = [&text](std::size_t i) { return (text[i] & 0xC0) == 0x80; };  // of a letter
  if (text.size() <= kMost) return std::string(text);
  std::size_t end = kMost;
  while (end > 0 && isInside(end)) --end;
  return std::string(text.substr(0, end)) + "...";
}

std::string_view nearestOf(std::string_view word, std::span<const std::string_view> known) {
  const std::string_view start = word.substr(0, 100);
  const auto nearest = std::ranges::min_element(
      known, {}, [start](std::string_view one) { return editDistance(start, one); });
  if (nearest == known.end() || 2 * editDistance(start, *nearest) > start.size()) return {};
  return *nearest;
}

std::string notOneOf(std::string_view given, std::span<const std::string_view> known) {
  return fmt::format("{} is not one of {}", shortened(given), fmt::join(known, ", "));
}

}  // namespace asperity
