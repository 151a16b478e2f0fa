// Reads numbers from the bytes of a file, with a check against their end, and the heights of a grid
// that are stored so. Pure; any thread.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>
#include <type_traits>

#include "core/base/statistics.h"
#include "core/measured/surface_draft.h"

namespace asperity {

/// Returns the number with which the bytes begin. A NaN is quiet, because arithmetic on one that
/// signals is an invalid operation.
template <class Number>
Number storedNumber(std::string_view bytes, std::endian order = std::endian::little) {
  std::array<char, sizeof(Number)> stored{};
  std::copy_n(bytes.data(), sizeof(Number), stored.begin());
  if (order != std::endian::native) std::ranges::reverse(stored);
  const auto number = std::bit_cast<Number>(stored);
  if constexpr (std::is_floating_point_v<Number>) {
    using Bits = std::conditional_t<sizeof(Number) == 4, std::uint32_t, std::uint64_t>;
    constexpr Number kQuiet = std::numeric_limits<Number>::quiet_NaN();
    constexpr auto kInfinity = std::bit_cast<Bits>(std::numeric_limits<Number>::infinity());
    // Compares bits, and not numbers, beside the sign.
    if (std::bit_cast<Bits>(number) << 1 > kInfinity << 1) return kQuiet;
  }
  return number;
}

/// A type of stored numbers.
struct StoredType {
  std::size_t size;  // bytes
  double lowest;     // NaN where numbers have no sign
  double (*read)(std::string_view bytes, std::endian order);
};

template <class Number>
inline constexpr StoredType kStored{
    sizeof(Number),
    std::numeric_limits<Number>::is_signed
        ? static_cast<double>(std::numeric_limits<Number>::lowest())
        : kNaN,
    [](std::string_view bytes, std::endian order) {
      return static_cast<double>(storedNumber<Number>(bytes, order));
    }};

/// Reads one number after another. Throws InputError where the file ends too early.
class ByteReader {
 public:
  ByteReader(const SurfaceSource& source, std::string_view bytes,
             std::endian order = std::endian::little)
      : source_(source), bytes_(bytes), order_(order) {}

  std::size_t position() const { return position_; }
  std::size_t left() const { return bytes_.size() - position_; }
  bool atEnd() const { return left() == 0; }
  std::string_view rest() const { return bytes_.substr(position_); }

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
    return storedNumber<Number>(take(sizeof(Number)), order_);
  }
  double read(const StoredType& type) { return type.read(take(type.size), order_); }

 private:
  const SurfaceSource& source_;
  std::string_view bytes_;
  std::endian order_;
  std::size_t position_ = 0;
};

/// Heights as a file stores them.
struct StoredHeights {
  std::string_view bytes;  // others may follow them
  StoredType type;
  std::endian order = std::endian::little;
  double scale = 1;  // of each number
  HeightGaps gaps{};
};

/// Takes the heights of a grid whose numbers of columns and rows are known. Throws InputError where
/// the bytes are too few.
void takeHeights(const SurfaceSource& source, const StoredHeights& stored, Topography& grid);

}  // namespace asperity
