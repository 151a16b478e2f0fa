#include "ui/picture/png_file.h"

#include <QBuffer>
#include <QByteArray>
#include <stdexcept>
#include <string_view>

#include "core/scene/atomic_file.h"

namespace asperity {
namespace {

constexpr int kCompression = 80;  // Qt's scale: 100 is uncompressed, 0 is slow

}  // namespace

void writePng(const std::filesystem::path& path, const QImage& image) {
  QByteArray encoded;
  QBuffer buffer(&encoded);
  buffer.open(QIODevice::WriteOnly);
  if (image.isNull() || !image.save(&buffer, "PNG", kCompression))
    throw std::runtime_error(path.string() + ": the picture cannot be encoded as PNG");
  writeFileAtomically(path, encoded.toStdString());
}

}  // namespace asperity
