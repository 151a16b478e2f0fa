#include <libdeflate.h>
#include <QtEndian>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <vector>

#include "core/base/atomic_file.h"
#include "core/base/embedded_provenance.h"
#include "ui/draw/picture_file.h"

namespace asperity {
namespace {

constexpr std::string_view kSignature = "\x89PNG\r\n\x1A\n";
constexpr std::string_view kMetadataKey = "asperity";
// The program's pictures are smooth in the vertical direction: the difference to the row above is
// mostly zero, and more effort saves almost nothing. Qt's own writer, which tries all filters,
// takes five times as long.
constexpr char kUpFilter = 2;
constexpr int kEffort = 2;

std::string bigEndian(std::uint32_t number) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift & 255U);
  return bytes;
}

void addChunk(std::string& png, std::string_view type, std::string_view data) {
  png += bigEndian(static_cast<std::uint32_t>(data.size()));
  const std::size_t start = png.size();
  png += type;
  png += data;
  png += bigEndian(libdeflate_crc32(0, png.data() + start, png.size() - start));
}

/// Adds uncompressed UTF-8 text, so that any program can find it.
void addText(std::string& png, std::string_view key, const std::string& text) {
  if (text.empty()) return;
  std::string data(key);
  data += std::string(5, '\0');  // end of key, not compressed (2), no language, no translated key
  addChunk(png, "iTXt", data + text);
}

constexpr std::size_t kTogether = 16;  // pixels that are compared at once

/// Filters rows of colours. Most pixels are equal to those above them, which is detected fast. The
/// number of channels is known at compile time, which is ten times faster.
template <std::size_t kChannels>
std::vector<std::uint8_t> filteredRows(const QImage& image) {
  const auto width = static_cast<std::size_t>(image.width());
  const auto height = static_cast<std::size_t>(image.height());
  std::vector<std::uint8_t> rows((width * kChannels + 1) * height);
  const std::vector<uchar> none(4 * width);
  const uchar* above = none.data();
  std::uint8_t* out = rows.data();
  for (std::size_t y = 0; y < height; ++y) {
    const uchar* pixels = image.constScanLine(static_cast<int>(y));
    *out++ = kUpFilter;
    for (std::size_t first = 0; first < width; first += kTogether) {
      const std::size_t count = std::min(kTogether, width - first);
      const uchar *here = pixels + 4 * first, *there = above + 4 * first;
      if (std::memcmp(here, there, 4 * count) != 0)
        for (std::size_t x = 0; x < count; ++x)
          for (std::size_t c = 0; c < kChannels; ++c)
            out[x * kChannels + c] = static_cast<std::uint8_t>(here[4 * x + c] - there[4 * x + c]);
      out += count * kChannels;
    }
    above = pixels;
  }
  return rows;
}

std::string deflated(const std::vector<std::uint8_t>& rows) {
  const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
      libdeflate_alloc_compressor(kEffort), &libdeflate_free_compressor);
  if (!compressor) throw std::bad_alloc();
  std::string data(libdeflate_zlib_compress_bound(compressor.get(), rows.size()), '\0');
  const std::size_t size = libdeflate_zlib_compress(compressor.get(), rows.data(), rows.size(),
                                                    data.data(), data.size());
  if (size == 0) throw std::runtime_error("the picture cannot be encoded as PNG");
  data.resize(size);
  return data;
}

}  // namespace

bool isOpaque(const QImage& image) {
  const int width = image.width(), height = image.height();
  const QRgb opaque = qToBigEndian(QRgb{255});  // RGBA in memory
  for (int y = 0; y < height; ++y) {
    const auto* pixels = reinterpret_cast<const QRgb*>(image.constScanLine(y));
    QRgb common = opaque;
    for (int x = 0; x < width; ++x) common &= pixels[x];
    if (common != opaque) return false;
  }
  return true;
}

std::string encodePng(const QImage& given, const PictureProperties& properties) {
  if (given.isNull()) throw std::runtime_error("an empty picture cannot be encoded as PNG");
  // In an opaque picture, both formats have the same bytes.
  const bool isRgba = given.format() == QImage::Format_RGBA8888_Premultiplied;
  const bool opaque = isRgba && isOpaque(given);
  const QImage image = opaque ? given : given.convertToFormat(QImage::Format_RGBA8888);
  const std::size_t channels = opaque || isOpaque(image) ? 3 : 4;

  std::string png(kSignature);
  const char kind = channels == 3 ? 2 : 6;
  addChunk(png, "IHDR",
           bigEndian(static_cast<std::uint32_t>(image.width())) +
               bigEndian(static_cast<std::uint32_t>(image.height())) +
               std::string{8, kind, 0, 0, 0});
  if (properties.scale > 0) {
    const std::string density =
        bigEndian(static_cast<std::uint32_t>(std::lround(properties.dotsPerInch() / 0.0254)));
    addChunk(png, "pHYs", density + density + '\1');  // pixels per metre
  }
  addText(png, "Title", properties.title);
  addText(png, kMetadataKey, properties.metadata);
  addChunk(png, "IDAT", deflated(channels == 3 ? filteredRows<3>(image) : filteredRows<4>(image)));
  addChunk(png, "IEND", {});
  return png;
}

void writePng(const std::filesystem::path& path, const QImage& image,
              const PictureProperties& properties) {
  if (image.isNull())
    throw std::runtime_error(path.string() + ": the picture cannot be encoded as PNG");
  writeFileAtomically(path, encodePng(image, properties));
}

std::string pngMetadata(std::string_view bytes) {
  return bytes.starts_with(kSignature) ? embeddedProvenance(bytes) : std::string();
}

}  // namespace asperity
