#include "core/base/regular_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <memory>

#include "core/base/input_error.h"

namespace asperity {
namespace {

void refuseAbove(std::uintmax_t size, std::size_t limit, const std::filesystem::path& file) {
  if (size > limit)
    throw InputError(file.string(), "", message("is larger than the {} bytes allowed", limit));
}

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
    throw InputError(name_, "", "is not a valid file name");
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
  refuseAbove(regular.size(), limit, file);
  return regular.read(0, limit);
}

std::string readWholeFile(const std::filesystem::path& file, std::size_t limit) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error))
    throw InputError(file.string(), "", "is a folder, not a file");
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> handle(std::fopen(file.c_str(), "rb"),
                                                               &std::fclose);
  if (!handle)
    throw InputError(file.string(), "",
                     message("cannot be opened: {}", Message(std::strerror(errno))));
  // A file that reports too large a size is refused without reading it; a pipe reports no size.
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (!error) refuseAbove(size, limit, file);
  std::string bytes;
  char buffer[1 << 16];
  while (const std::size_t count = std::fread(buffer, 1, sizeof buffer, handle.get())) {
    bytes.append(buffer, count);
    refuseAbove(bytes.size(), limit, file);
  }
  if (std::ferror(handle.get())) throw InputError(file.string(), "", "cannot be read");
  return bytes;
}

}  // namespace asperity
