// Numbers in binary files, checked against the end of the bytes. Pure; any thread.
#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "core/measured/surface_draft.h"

namespace asperity {

static_assert(std::endian::native == std::endian::little, "binary files are read as they are");

template <class Number>
Number swapped(Number number) {
  char bytes[sizeof(Number)];
  std::memcpy(bytes, &number, sizeof number);
  for (std::size_t i = 0; i < sizeof(Number) / 2; ++i)
    std::swap(bytes[i], bytes[sizeof(Number) - 1 - i]);
  std::memcpy(&number, bytes, sizeof number);
  return number;
}

/// Reads one number after another. Throws InputError where the file ends too early.
class ByteReader {
 public:
  ByteReader(const SurfaceSource& source, std::string_view bytes, bool bigEndian = false)
      : source_(source), bytes_(bytes), bigEndian_(bigEndian) {}

  std::size_t place() const { return place_; }
  std::size_t left() const { return bytes_.size() - place_; }
  bool atEnd() const { return left() == 0; }

  /// The next bytes.
  std::string_view take(std::size_t count) {
    if (count > left())
      source_.fail(message("ends too early: {} bytes are needed from byte {} on, and {} are there",
                           count, place_, left()));
    place_ += count;
    return bytes_.substr(place_ - count, count);
  }
  void skip(std::size_t count) { take(count); }

  template <class Number>
  Number read() {
    Number number{};
    std::memcpy(&number, take(sizeof(Number)).data(), sizeof(Number));
    return bigEndian_ ? swapped(number) : number;
  }

 private:
  const SurfaceSource& source_;
  std::string_view bytes_;
  std::size_t place_ = 0;
  bool bigEndian_;
};

/// Appends all numbers of the bytes to `heights`, times `scale`. isGap says of the number as it is
/// stored whether there was no height; what is not finite is a gap in any case.
template <class Number, class IsGap>
void appendHeights(const SurfaceSource& source, std::string_view bytes, bool bigEndian,
                   double scale, std::vector<double>& heights, const IsGap& isGap) {
  const std::size_t count = bytes.size() / sizeof(Number);
  constexpr std::size_t kStep = std::size_t{1} << 20;
  const std::size_t before = heights.size();
  heights.resize(before + count);
  for (std::size_t i = 0; i < count; ++i) {
    if (i % kStep == 0) source.report(static_cast<double>(i) / static_cast<double>(count));
    Number number{};
    std::memcpy(&number, bytes.data() + i * sizeof(Number), sizeof(Number));
    if (bigEndian) number = swapped(number);
    bool none = isGap(number);
    if constexpr (std::is_floating_point_v<Number>) none = none || !std::isfinite(number);
    double height = none ? 0.0 : static_cast<double>(number) * scale;
    heights[before + i] =
        none || !std::isfinite(height) ? std::numeric_limits<double>::quiet_NaN() : height;
  }
}

}  // namespace asperity
