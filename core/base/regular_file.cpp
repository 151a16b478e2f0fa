#include "core/base/regular_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
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
  // The opening alone may wait (pipes) or act (tapes), so the kind is asked first; and again
  // afterwards, because the name may mean another file by then.
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
    if (now == 0) break;  // it has become shorter
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

}  // namespace asperity
