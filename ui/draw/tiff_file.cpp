#include "ui/draw/picture_file.h"

#include <stdexcept>

#include "core/base/destroyer.h"

#ifdef ASPERITY_HAS_TIFF
#include <tiffio.h>
#include <algorithm>
#include <cstring>
#include <memory>
#endif

namespace asperity {

#ifdef ASPERITY_HAS_TIFF

namespace {

/// A file in memory, as libtiff reads and writes it.
struct MemoryFile {
  std::string bytes;
  std::size_t position = 0;
};

MemoryFile& memoryFile(thandle_t handle) {
  return *static_cast<MemoryFile*>(handle);
}

tmsize_t readBytes(thandle_t handle, void* to, tmsize_t count) {
  MemoryFile& file = memoryFile(handle);
  const std::size_t known = file.bytes.size() - std::min(file.position, file.bytes.size());
  const std::size_t taken = std::min(static_cast<std::size_t>(count), known);
  std::memcpy(to, file.bytes.data() + file.position, taken);
  file.position += taken;
  return static_cast<tmsize_t>(taken);
}

tmsize_t writeBytes(thandle_t handle, void* from, tmsize_t count) {
  MemoryFile& file = memoryFile(handle);
  const auto size = static_cast<std::size_t>(count);
  if (file.bytes.size() < file.position + size) file.bytes.resize(file.position + size);
  std::memcpy(file.bytes.data() + file.position, from, size);
  file.position += size;
  return count;
}

toff_t moveTo(thandle_t handle, toff_t offset, int whence) {
  MemoryFile& file = memoryFile(handle);
  const std::size_t start = whence == SEEK_SET   ? 0
                            : whence == SEEK_CUR ? file.position
                                                 : file.bytes.size();
  file.position = start + static_cast<std::size_t>(offset);
  return file.position;
}

int closeFile(thandle_t) {
  return 0;
}

toff_t fileSize(thandle_t handle) {
  return memoryFile(handle).bytes.size();
}

}  // namespace

std::string tiffBytes(const QImage& given, const PictureProperties& properties) {
  if (given.isNull()) throw std::runtime_error("An empty picture cannot be a TIFF file.");
  const QImage rgba = given.convertToFormat(QImage::Format_RGBA8888);
  const bool hasAlpha = !isOpaque(rgba);
  const QImage image = hasAlpha ? rgba : rgba.convertToFormat(QImage::Format_RGB888);
  MemoryFile file;
  {
    const std::unique_ptr<TIFF, Destroyer<TIFFClose>> tiff(
        TIFFClientOpen("picture", "wl", static_cast<thandle_t>(&file), readBytes, writeBytes,
                       moveTo, closeFile, fileSize, nullptr, nullptr));
    if (!tiff) throw std::runtime_error("A TIFF file cannot be begun.");
    const auto set = [&](std::uint32_t tag, auto value) { TIFFSetField(tiff.get(), tag, value); };
    set(TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(image.width()));
    set(TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(image.height()));
    set(TIFFTAG_BITSPERSAMPLE, 8);
    set(TIFFTAG_SAMPLESPERPIXEL, hasAlpha ? 4 : 3);
    set(TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_RGB);
    set(TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    set(TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
    set(TIFFTAG_COMPRESSION, COMPRESSION_LZW);
    set(TIFFTAG_PREDICTOR, PREDICTOR_HORIZONTAL);
    set(TIFFTAG_SOFTWARE, "Asperity");
    if (hasAlpha) {
      const std::uint16_t alpha = EXTRASAMPLE_UNASSALPHA;
      TIFFSetField(tiff.get(), TIFFTAG_EXTRASAMPLES, 1, &alpha);
    }
    set(TIFFTAG_XRESOLUTION, properties.dotsPerInch());
    set(TIFFTAG_YRESOLUTION, properties.dotsPerInch());
    set(TIFFTAG_RESOLUTIONUNIT, RESUNIT_INCH);
    if (!properties.title.empty()) set(TIFFTAG_DOCUMENTNAME, properties.title.c_str());
    const std::string description = "asperity: " + properties.metadata;
    if (!properties.metadata.empty()) set(TIFFTAG_IMAGEDESCRIPTION, description.c_str());
    set(TIFFTAG_ROWSPERSTRIP, TIFFDefaultStripSize(tiff.get(), 0));
    // libtiff changes the row that it is given.
    std::string row;
    const auto size = static_cast<std::size_t>(image.width()) * (hasAlpha ? 4 : 3);
    for (int i = 0; i < image.height(); ++i) {
      row.assign(reinterpret_cast<const char*>(image.constScanLine(i)), size);
      if (TIFFWriteScanline(tiff.get(), row.data(), static_cast<std::uint32_t>(i)) < 0)
        throw std::runtime_error("A TIFF file cannot be written.");
    }
  }
  return std::move(file.bytes);
}

bool canWriteTiff() {
  return true;
}

#else

std::string tiffBytes(const QImage&, const PictureProperties&) {
  throw std::runtime_error("This program was built without libtiff and writes no TIFF.");
}

bool canWriteTiff() {
  return false;
}

#endif

}  // namespace asperity
