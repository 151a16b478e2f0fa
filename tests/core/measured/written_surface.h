// A known surface and what the writers of the tests share: bytes, ZIP archives and MD5 of their
// own, so that no code of the readers is checked with itself.
#pragma once

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

namespace asperity::written {

inline constexpr int kColumns = 7, kRows = 4;
inline constexpr double kColumnSpacing = 2e-6, kRowSpacing = 5e-6;  // m
inline constexpr int kGapRow = 2, kGapColumn = 5;

/// Micrometres; every row and every column differs from every other one, forwards and backwards.
inline double micrometres(int row, int column) {
  return 0.125 * (column * column) - 1.5 * row + 0.25 * ((3 * column + 5 * row) % 4) - 2;
}

inline bool isGap(int row, int column) {
  return row == kGapRow && column == kGapColumn;
}

/// Metres; NaN in the gap, if one is wanted.
inline double height(int row, int column, bool withGap = false) {
  return withGap && isGap(row, column) ? std::numeric_limits<double>::quiet_NaN()
                                       : 1e-6 * micrometres(row, column);
}

template <class Number>
void put(std::string& bytes, Number number, bool bigEndian = false) {
  std::array<char, sizeof(Number)> raw{};
  std::memcpy(raw.data(), &number, sizeof number);
  if (bigEndian) std::reverse(raw.begin(), raw.end());
  bytes.append(raw.data(), raw.size());
}

inline void putText(std::string& bytes, std::string text, std::size_t size, char fill = ' ') {
  text.resize(size, fill);
  bytes += text;
}

// ---- ZIP ---------------------------------------------------------------------------------------

struct ZippedFile {
  std::string name, content;
};

/// Raw deflate of zlib, as ZIP has it.
inline std::string deflated(const std::string& content) {
  z_stream stream{};
  deflateInit2(&stream, 9, Z_DEFLATED, -15, 9, Z_DEFAULT_STRATEGY);
  std::string packed(deflateBound(&stream, content.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(content.data()));
  stream.avail_in = static_cast<uInt>(content.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

/// claimedSize: what the archive says of each size; 0: the truth.
inline std::string zipped(const std::vector<ZippedFile>& files, bool packed = true,
                          std::uint32_t claimedSize = 0) {
  std::string bytes, directory;
  for (const ZippedFile& file : files) {
    const std::string content = packed ? deflated(file.content) : file.content;
    const auto crc =
        static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(file.content.data()),
                                         static_cast<uInt>(file.content.size())));
    const auto size =
        claimedSize != 0 ? claimedSize : static_cast<std::uint32_t>(file.content.size());
    const auto offset = static_cast<std::uint32_t>(bytes.size());
    const auto common = [&](std::string& into) {
      put<std::uint16_t>(into, 20);
      put<std::uint16_t>(into, 0);
      put<std::uint16_t>(into, packed ? 8 : 0);
      put<std::uint32_t>(into, 0x21 << 16);  // 1 January 1980
      put<std::uint32_t>(into, crc);
      put<std::uint32_t>(into, static_cast<std::uint32_t>(content.size()));
      put<std::uint32_t>(into, size);
      put<std::uint16_t>(into, static_cast<std::uint16_t>(file.name.size()));
      put<std::uint16_t>(into, 0);
    };
    bytes += "PK\3\4";
    common(bytes);
    bytes += file.name + content;
    directory += "PK\1\2";
    put<std::uint16_t>(directory, 20);
    common(directory);
    put<std::uint16_t>(directory, 0);
    put<std::uint16_t>(directory, 0);
    put<std::uint16_t>(directory, 0);
    put<std::uint32_t>(directory, 0);
    put<std::uint32_t>(directory, offset);
    directory += file.name;
  }
  const auto begin = static_cast<std::uint32_t>(bytes.size());
  bytes += directory + "PK\5\6";
  put<std::uint32_t>(bytes, 0);
  put<std::uint16_t>(bytes, static_cast<std::uint16_t>(files.size()));
  put<std::uint16_t>(bytes, static_cast<std::uint16_t>(files.size()));
  put<std::uint32_t>(bytes, static_cast<std::uint32_t>(directory.size()));
  put<std::uint32_t>(bytes, begin);
  put<std::uint16_t>(bytes, 0);
  return bytes;
}

// ---- MD5 (RFC 1321) ----------------------------------------------------------------------------

inline std::string md5(std::string message) {
  constexpr std::array<int, 16> shifts{7, 12, 17, 22, 5, 9, 14, 20, 4, 11, 16, 23, 6, 10, 15, 21};
  std::array<std::uint32_t, 4> state{0x67452301, 0xefcdab89, 0x98badcfe, 0x10325476};
  const std::uint64_t bits = 8 * static_cast<std::uint64_t>(message.size());
  message += '\x80';
  while (message.size() % 64 != 56) message += '\0';
  put(message, bits);
  for (std::size_t block = 0; block < message.size(); block += 64) {
    std::array<std::uint32_t, 16> words{};
    std::memcpy(words.data(), message.data() + block, 64);
    auto [a, b, c, d] = state;
    for (std::uint32_t i = 0; i < 64; ++i) {
      const std::uint32_t round = i / 16;
      const std::uint32_t mixed = round == 0   ? (b & c) | (~b & d)
                                  : round == 1 ? (d & b) | (~d & c)
                                  : round == 2 ? b ^ c ^ d
                                               : c ^ (b | ~d);
      const std::uint32_t word = round == 0   ? i
                                 : round == 1 ? 5 * i + 1
                                 : round == 2 ? 3 * i + 5
                                              : 7 * i;
      const auto sine =
          static_cast<std::uint32_t>(std::floor(4294967296.0 * std::abs(std::sin(i + 1.0))));
      const std::uint32_t sum = a + mixed + sine + words[word % 16];
      const int shift = shifts[4 * round + i % 4];
      a = d;
      d = c;
      c = b;
      b += sum << shift | sum >> (32 - shift);
    }
    state[0] += a;
    state[1] += b;
    state[2] += c;
    state[3] += d;
  }
  std::string text;
  for (const std::uint32_t part : state)
    for (int byte = 0; byte < 4; ++byte) {
      const unsigned value = part >> (8 * byte) & 0xFF;
      text += "0123456789abcdef"[value >> 4];
      text += "0123456789abcdef"[value & 0xF];
    }
  return text;
}

}  // namespace asperity::written
