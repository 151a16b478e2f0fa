#include "core/base/regular_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstring>

#include "core/base/input_error.h"

namespace asperity {
namespace {

/// Throws where `status` is not that of a regular file.
void requireRegular(const struct stat& status, const std::string& name) {
  if (S_ISDIR(status.st_mode)) throw InputError(name, "", "is a folder, not a file");
  if (!S_ISREG(status.st_mode))
    throw InputError(name, "", "is a pipe or a device; only regular files are read here");
}

}  // namespace

RegularFile::RegularFile(const std::filesystem::path& file) : name_(file.string()) {
  const auto requireSuccess = [this](int result) {
    if (result < 0)
      throw InputError(name_, "", message("cannot be opened: {}", Message(std::strerror(errno))));
  };
  if (file.native().find('\0') != std::string::npos)
    throw InputError(name_, "", "is no name of a file");
  // Opening a special file may wait (pipes) or act (tapes), so the kind is checked before; and
  // again afterwards, because the name may then mean another file.
  struct stat status;
  requireSuccess(::stat(file.c_str(), &status));
  requireRegular(status, name_);
  descriptor_ = ::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  requireSuccess(descriptor_);
  try {
    requireSuccess(::fstat(descriptor_, &status));
    requireRegular(status, name_);
  } catch (const InputError&) {
    ::close(descriptor_);
    throw;
  }
  size_ = static_cast<std::uint64_t>(status.st_size);
}

RegularFile::~RegularFile() {
  ::close(descriptor_);
}

std::string RegularFile::read(std::uint64_t offset, std::size_t count) const {
  std::string bytes(std::min<std::uint64_t>(count, offset < size_ ? size_ - offset : 0), '\0');
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t now = ::pread(descriptor_, bytes.data() + done, bytes.size() - done,
                                static_cast<off_t>(offset + done));
    if (now < 0 && errno == EINTR) continue;
    if (now < 0)
      throw InputError(name_, "", message("cannot be read: {}", Message(std::strerror(errno))));
    if (now == 0) break;  // the file has become shorter
    done += static_cast<std::size_t>(now);
  }
  bytes.resize(done);
  return bytes;
}

std::string readRegularFile(const std::filesystem::path& file, std::size_t limit) {
  const RegularFile regular(file);
  if (regular.size() > limit)
    throw InputError(file.string(), "", message("is larger than the {} bytes allowed", limit));
  return regular.read(0, limit);
}

namespace {

using namespace std::string_view_literals;

struct Signature {
  std::string_view bytes;
  std::string_view kind;
};

/// A longer signature comes before one that is its beginning.
constexpr std::array<Signature, 18> kSignatures{
    {{"\xFF\xFE\0\0"sv, "text in UTF-32"},
     {"\0\0\xFE\xFF"sv, "text in UTF-32"},
     {"\xFF\xFE"sv, "text in UTF-16"},
     {"\xFE\xFF"sv, "text in UTF-16"},
     {"\x89PNG"sv, "a PNG picture"},
     {"\xFF\xD8\xFF"sv, "a JPEG picture"},
     {"GIF8"sv, "a GIF picture"},
     {"II*\0"sv, "a TIFF picture"},
     {"MM\0*"sv, "a TIFF picture"},
     {"RIFF"sv, "a RIFF file (as WebP is)"},
     {"%PDF-"sv, "a PDF document"},
     {"PK\3\4"sv, "a ZIP archive (as of a spreadsheet)"},
     {"\xD0\xCF\x11\xE0"sv, "an old Office document"},
     {"\x1F\x8B"sv, "a gzip archive"},
     {"\xFD"
      "7zXZ\0"sv,
      "an xz archive"},
     {"\x28\xB5\x2F\xFD"sv, "a zstd archive"},
     {"\x89HDF"sv, "an HDF5 file"},
     {"\x1A\x45\xDF\xA3"sv, "a WebM film"}}};

/// UTF-16 without a byte order mark: in mostly Latin text every second byte is 0.
bool looksLikeUtf16(std::string_view beginning) {
  std::array<std::size_t, 2> zeros{};
  for (std::size_t i = 0; i < beginning.size(); ++i) zeros[i % 2] += beginning[i] == '\0' ? 1 : 0;
  const auto [few, many] = std::minmax(zeros[0], zeros[1]);
  return many > beginning.size() / 4 && few <= many / 8;
}

}  // namespace

std::string_view detectNonText(std::string_view bytes) {
  constexpr std::size_t kLookedAt = 4096;
  for (const Signature& signature : kSignatures)
    if (bytes.starts_with(signature.bytes)) return signature.kind;
  const std::string_view beginning = bytes.substr(0, kLookedAt);
  const std::size_t zero = beginning.find('\0');
  if (zero == std::string_view::npos) return {};
  // Zeros behind a text alone fill up its last block.
  if (zero > 1 && !looksLikeUtf16(beginning) &&
      bytes.find_first_not_of('\0', zero) == std::string_view::npos)
    return {};
  return looksLikeUtf16(beginning) ? "text in UTF-16"sv : "a binary file"sv;
}

}  // namespace asperity
