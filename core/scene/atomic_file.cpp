#include "core/scene/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "core/scene/input_error.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

/// Through a link the file it points to is written, and the link stays.
fs::path targetOf(const fs::path& file) {
  std::error_code ignored;
  return fs::is_symlink(file, ignored) ? fs::canonical(file) : file;
}

}  // namespace

void checkWritable(const fs::path& file) {
  std::error_code ignored;
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  if (file.empty()) throw InputError("", "", "an output needs a name");
  if (!file.has_filename() || fs::is_directory(file, ignored))
    throw InputError(file.string(), "", "is a folder; a file name is needed");
  if (fs::exists(file, ignored) && !fs::is_regular_file(file, ignored))
    throw InputError(file.string(), "", "is not a plain file and would be replaced");
  if (!fs::is_directory(folder, ignored))
    throw InputError(file.string(), "", fmt::format("folder {} does not exist", folder.string()));
  if (::access(folder.c_str(), W_OK | X_OK) != 0)
    throw InputError(file.string(), "",
                     fmt::format("folder {} cannot be written to", folder.string()));
}

AtomicFile::AtomicFile(const fs::path& file) {
  checkWritable(file);
  target_ = targetOf(file);
  const fs::path folder = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
  static std::atomic<unsigned> number{0};
  name_ = (folder / fmt::format(".asperity.{}_{}.part", ::getpid(), number++)).string();
  // A file without a name gets one through /proc, which a bare chroot has not.
  if (::access("/proc/self/fd", X_OK) == 0)
    descriptor_ = ::open(folder.c_str(), O_RDWR | O_TMPFILE | O_CLOEXEC, 0666);
  if (descriptor_ >= 0) return;
  descriptor_ = ::open(name_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor_ < 0) fail();
  hasName_ = true;
}

AtomicFile::~AtomicFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (hasName_) ::unlink(name_.c_str());
}

void AtomicFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail();
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

std::string AtomicFile::content() const {
  std::string bytes;
  char buffer[1 << 16];
  for (off_t at = 0;;) {
    const ssize_t count = ::pread(descriptor_, buffer, sizeof buffer, at);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail();
    if (count == 0) return bytes;
    bytes.append(buffer, static_cast<std::size_t>(count));
    at += count;
  }
}

void AtomicFile::replace(std::string_view bytes) {
  if (::ftruncate(descriptor_, 0) != 0 || ::lseek(descriptor_, 0, SEEK_SET) != 0) fail();
  write(bytes);
}

void AtomicFile::commit() {
  bool isLinked = false;  // under its final name already
  if (::fsync(descriptor_) != 0 && errno != EINVAL && errno != EROFS) fail();
  if (!hasName_) {
    // A link cannot replace a file, a renaming can; a new file needs no name in between, which a
    // kill would leave behind.
    const std::string self = fmt::format("/proc/self/fd/{}", descriptor_);
    const auto linkAs = [&self](const char* name) {
      return ::linkat(AT_FDCWD, self.c_str(), AT_FDCWD, name, AT_SYMLINK_FOLLOW) == 0;
    };
    isLinked = linkAs(target_.c_str());
    if (!isLinked && (errno != EEXIST || !linkAs(name_.c_str()))) fail();
    hasName_ = !isLinked;
  }
  const int closed = ::close(descriptor_);
  descriptor_ = -1;
  if (closed != 0 || (!isLinked && ::rename(name_.c_str(), target_.c_str()) != 0)) fail();
  hasName_ = false;
}

void AtomicFile::fail() const {
  throw std::runtime_error(
      fmt::format("{}: cannot be written: {}", target_.string(), std::strerror(errno)));
}

void writeFileAtomically(const fs::path& file, std::string_view bytes) {
  AtomicFile whole(file);
  whole.write(bytes);
  whole.commit();
}

std::string readWholeFile(const fs::path& file, std::size_t limit) {
  std::error_code error;
  if (fs::is_directory(file, error)) throw InputError(file.string(), "", "is a folder, not a file");
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> handle(std::fopen(file.c_str(), "rb"),
                                                               &std::fclose);
  if (!handle)
    throw InputError(file.string(), "", fmt::format("cannot be opened: {}", std::strerror(errno)));
  const auto refuseAbove = [&](std::uintmax_t size) {
    if (size > limit)
      throw InputError(file.string(), "",
                       fmt::format("is larger than the {} bytes allowed", limit));
  };
  // What says how large it is need not be read to be refused; a pipe does not.
  const std::uintmax_t size = fs::file_size(file, error);
  if (!error) refuseAbove(size);
  std::string bytes;
  char buffer[1 << 16];
  while (const std::size_t count = std::fread(buffer, 1, sizeof buffer, handle.get())) {
    bytes.append(buffer, count);
    refuseAbove(bytes.size());
  }
  if (std::ferror(handle.get())) throw InputError(file.string(), "", "cannot be read");
  return bytes;
}

}  // namespace asperity
