// Reads little-endian numbers from the bytes of a file, with a check against their end. Pure; any
// thread.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/measured/surface_draft.h"

namespace asperity {

static_assert(std::endian::native == std::endian::little, "binary files are read as they are");

/// Returns the number with which the bytes begin. A NaN is quiet, because arithmetic on one that
/// signals is an invalid operation.
template <class Number>
Number storedNumber(std::string_view bytes) {
  Number number{};
  std::memcpy(&number, bytes.data(), sizeof(Number));
  if constexpr (std::is_floating_point_v<Number>) {
    using Bits = std::conditional_t<sizeof(Number) == 4, std::uint32_t, std::uint64_t>;
    constexpr Number kQuiet = std::numeric_limits<Number>::quiet_NaN();
    constexpr auto kInfinity = std::bit_cast<Bits>(std::numeric_limits<Number>::infinity());
    // Compares bits, and not numbers, beside the sign.
    if (std::bit_cast<Bits>(number) << 1 > kInfinity << 1) return kQuiet;
  }
  return number;
}

/// Reads one number after another. Throws InputError where the file ends too early.
class ByteReader {
 public:
  ByteReader(const SurfaceSource& source, std::string_view bytes)
      : source_(source), bytes_(bytes) {}

  std::size_t position() const { return position_; }
  std::size_t left() const { return bytes_.size() - position_; }
  bool atEnd() const { return left() == 0; }

  /// Returns the next bytes and moves on after them.
  std::string_view take(std::size_t count) {
    if (count > left())
      source_.fail(message("ends too early: {} bytes are needed from byte {} on, and {} are there",
                           count, position_, left()));
    position_ += count;
    return bytes_.substr(position_ - count, count);
  }
  void skip(std::size_t count) { take(count); }

  template <class Number>
  Number read() {
    return storedNumber<Number>(take(sizeof(Number)));
  }

 private:
  const SurfaceSource& source_;
  std::string_view bytes_;
  std::size_t position_ = 0;
};

/// Returns the numbers of this size with the bytes of each in reverse order.
inline std::string reversedBytes(std::string_view bytes, std::size_t size) {
  std::string reversed(bytes);
  for (std::size_t i = 0; i + size <= reversed.size(); i += size)
    std::reverse(reversed.data() + i, reversed.data() + i + size);
  return reversed;
}

/// The gaps of files without a number that stands for one.
struct NoGaps {
  bool operator()(auto) const { return false; }
};

/// Appends all numbers in the bytes to `heights`, times `scale`. isGap(number) tells from the
/// number as it is stored whether no height was measured there; a number that is not finite is a
/// gap in any case.
template <class Number, class IsGap = NoGaps>
void appendHeights(const SurfaceSource& source, std::string_view bytes, double scale,
                   std::vector<double>& heights, const IsGap& isGap = {}) {
  const std::size_t count = bytes.size() / sizeof(Number);
  const std::size_t before = heights.size();
  heights.resize(before + count);
  for (std::size_t i = 0; i < count; ++i) {
    source.reportPoint(i, count);
    const auto number = storedNumber<Number>(bytes.substr(i * sizeof(Number)));
    const bool isNone = !std::isfinite(static_cast<double>(number)) || isGap(number);
    const double height = isNone ? std::nan("") : static_cast<double>(number) * scale;
    heights[before + i] = std::isfinite(height) ? height : std::nan("");
  }
}

}  // namespace asperity
