#include "core/base/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <pthread.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <tuple>
#include <utility>

#include "core/base/input_error.h"
#include "core/base/text.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

/// Returns the file to write: the target of a link, so that the link stays. Throws InputError where
/// the link leads nowhere.
fs::path targetOf(const fs::path& file) {
  std::error_code error;
  if (!fs::is_symlink(file, error)) return file;
  fs::path target = fs::canonical(file, error);
  if (!error) return target;
  const fs::path next = fs::read_symlink(file, error);
  throw InputError(file.string(), "",
                   message("is a link to '{}', which does not exist", next.string()));
}

fs::path folderOf(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

/// Blocks interruptions of this thread while an object lives: a handler that waits for it runs on
/// another thread.
class NoInterruption {
 public:
  NoInterruption() {
    sigset_t interruptions;
    sigemptyset(&interruptions);
    sigaddset(&interruptions, SIGINT);
    sigaddset(&interruptions, SIGTERM);
    ::pthread_sigmask(SIG_BLOCK, &interruptions, &before_);
  }
  ~NoInterruption() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  NoInterruption(const NoInterruption&) = delete;
  NoInterruption& operator=(const NoInterruption&) = delete;

 private:
  sigset_t before_;
};

/// The hidden names of files that are being written, in memory that is never freed, so that a
/// signal handler can read them. Files beyond the table's size are not listed; the next write of
/// the same file removes what they leave.
class UnfinishedNames {
 public:
  /// Returns a slot for a name that a file is about to get, or -1. removeAll() waits until
  /// settle().
  int claim(const std::string& name) {
    waitIfEnding();
    if (name.size() >= sizeof Slot::name) return -1;
    for (std::size_t i = 0; i < slots_.size(); ++i) {
      State free = State::Free;
      if (!slots_[i].state.compare_exchange_strong(free, State::Claimed)) continue;
      if (isEnding_) slots_[i].state = State::Free;
      waitIfEnding();
      std::memcpy(slots_[i].name, name.c_str(), name.size() + 1);
      return static_cast<int>(i);
    }
    return -1;
  }
  void settle(int slot, bool hasName) {
    if (slot >= 0)
      slots_[static_cast<std::size_t>(slot)].state = hasName ? State::Listed : State::Free;
  }
  void removeAll() {
    constexpr timespec kMoment{0, 1000000};
    isEnding_ = true;
    for (Slot& slot : slots_) {
      for (int moments = 0; slot.state == State::Claimed && moments < 1000; ++moments)
        ::nanosleep(&kMoment, nullptr);
      if (slot.state == State::Listed) ::unlink(slot.name);
    }
  }
  void waitIfEnding() const {
    while (isEnding_) ::pause();
  }

 private:
  enum class State { Free, Claimed, Listed };
  struct Slot {
    std::atomic<State> state{State::Free};
    char name[PATH_MAX];
  };
  std::array<Slot, 32> slots_;
  std::atomic<bool> isEnding_{false};
};
UnfinishedNames unfinishedNames;

/// Returns the hidden name that every write of this file uses if it needs one, so that the next
/// write finds the rest of a killed one. It is a number, because a name of 255 bytes cannot be made
/// longer.
std::string partOf(const fs::path& target) {
  const std::string name = target.filename().string();
  std::uint64_t number = 14695981039346656037U;  // FNV-1a hash (Fowler, Noll and Vo)
  for (const unsigned char byte : name) number = (number ^ byte) * 1099511628211U;
  return (target.parent_path() / fmt::format(".asperity.{:016x}.part", number)).string();
}

/// Returns another name, for the moment when two writes of the same file run at once.
std::string partOfItsOwn(const fs::path& target) {
  static std::atomic<unsigned> count{0};
  return (target.parent_path() / fmt::format(".asperity.{}_{}.part", ::getpid(), count++)).string();
}

/// Locks the file for its writer. The end of a process releases the lock, however it ends.
bool lock(int descriptor) {
  return ::flock(descriptor, LOCK_EX | LOCK_NB) == 0;
}

bool isNamed(int descriptor, const std::string& name) {
  struct stat open, named;
  return ::fstat(descriptor, &open) == 0 && ::lstat(name.c_str(), &named) == 0 &&
         open.st_ino == named.st_ino && open.st_dev == named.st_dev;
}

/// Removes a part whose writer has ended.
void removeStale(const std::string& part) {
  const int found = ::open(part.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (found < 0) return;
  if (lock(found) && isNamed(found, part)) ::unlink(part.c_str());
  ::close(found);
}

}  // namespace

void checkWritable(const fs::path& file) {
  std::error_code ignored;
  if (file.empty()) throw InputError("", "", "an output needs a name");
  if (!file.has_filename() || fs::is_directory(file, ignored))
    throw InputError(file.string(), "", "is a folder; a file name is needed");
  if (fs::exists(file, ignored) && !fs::is_regular_file(file, ignored))
    throw InputError(file.string(), "", "is not a plain file and would be replaced");
  const fs::path folder = folderOf(targetOf(file));
  if (!fs::is_directory(folder, ignored))
    throw InputError(file.string(), "", message("folder {} does not exist", folder.string()));
  if (::access(folder.c_str(), W_OK | X_OK) != 0)
    throw InputError(file.string(), "", message("folder {} cannot be written to", folder.string()));
}

bool isAnyOf(const fs::path& file, std::span<const fs::path> inputs) {
  std::error_code ignored;  // A file that does not exist is not equivalent to any other.
  return std::any_of(inputs.begin(), inputs.end(),
                     [&](const fs::path& input) { return fs::equivalent(file, input, ignored); });
}

void checkReplacesNone(const fs::path& file, std::span<const fs::path> inputs) {
  if (isAnyOf(file, inputs))
    throw InputError(file.string(), "", "is also an input file and would be replaced");
}

AtomicFile::AtomicFile(const fs::path& file) {
  checkWritable(file);
  target_ = targetOf(file);
  name_ = partOf(target_);
  removeStale(name_);
  const fs::path folder = folderOf(target_);
  // A file without a name gets one through /proc, which may be missing after chroot.
  if (::access("/proc/self/fd", X_OK) == 0)
    descriptor_ = ::open(folder.c_str(), O_RDWR | O_TMPFILE | O_CLOEXEC, 0666);
  if (descriptor_ >= 0)
    lock(descriptor_);
  else if (!openNamed() && (name_ = partOfItsOwn(target_), !openNamed()))
    fail();
  takePermissions();
}

/// Sets the permissions before anything is written, so that private content is never readable by
/// others. Where owner or group cannot be passed on, this process' own get only the rights of all
/// others.
void AtomicFile::takePermissions() const {
  struct stat old, own;
  if (::stat(target_.c_str(), &old) != 0 || ::fstat(descriptor_, &own) != 0) return;
  mode_t mode = old.st_mode & 0777U;
  if (own.st_gid != old.st_gid && ::fchown(descriptor_, static_cast<uid_t>(-1), old.st_gid) != 0)
    mode &= ~static_cast<mode_t>(S_IRWXG) | (mode & S_IRWXO) << 3;
  // Only the superuser can give a file to another owner; for other users the new file is their own.
  if (own.st_uid != old.st_uid)
    std::ignore = ::fchown(descriptor_, old.st_uid, static_cast<gid_t>(-1));
  ::fchmod(descriptor_, mode);
}

/// Gives the file the name name_, which a signal handler knows from the first moment.
template <class Give>
bool AtomicFile::giveHiddenName(const Give& give) {
  const NoInterruption whole;
  listed_ = unfinishedNames.claim(name_);
  hasName_ = give();
  const int why = errno;
  unfinishedNames.settle(listed_, hasName_);
  if (!hasName_) listed_ = -1;
  errno = why;
  return hasName_;
}

bool AtomicFile::openNamed() {
  return giveHiddenName([this] {
    descriptor_ = ::open(name_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ < 0) return false;
    // Another write may find the file before it is locked, and treat it as the rest of a killed
    // write.
    const bool isTaken = !lock(descriptor_) && errno == EWOULDBLOCK;
    const bool isOurs = !isTaken && isNamed(descriptor_, name_);
    if (!isOurs) ::close(std::exchange(descriptor_, -1));
    return isOurs;
  });
}

AtomicFile::~AtomicFile() {
  if (hasName_) ::unlink(name_.c_str());  // while it is locked
  unfinishedNames.settle(listed_, false);
  if (descriptor_ >= 0) ::close(descriptor_);
}

void AtomicFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail();
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

std::string AtomicFile::content(std::size_t most) const {
  std::string bytes;
  char buffer[1 << 16];
  while (bytes.size() < most) {
    const ssize_t count = ::pread(descriptor_, buffer, std::min(most - bytes.size(), sizeof buffer),
                                  static_cast<off_t>(bytes.size()));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail();
    if (count == 0) break;
    bytes.append(buffer, static_cast<std::size_t>(count));
  }
  return bytes;
}

void AtomicFile::replace(std::string_view bytes) {
  if (::ftruncate(descriptor_, 0) != 0 || ::lseek(descriptor_, 0, SEEK_SET) != 0) fail();
  write(bytes);
}

void AtomicFile::commit() {
  if (::fsync(descriptor_) != 0 && errno != EINVAL && errno != EROFS) fail();
  // Some file systems report errors only when a file is closed; the lock lasts until the second
  // closing.
  if (::close(::dup(descriptor_)) != 0) fail();
  if (hasName_ || !linkAsNew()) {
    if (::rename(name_.c_str(), target_.c_str()) != 0) fail();
    hasName_ = false;
    unfinishedNames.settle(std::exchange(listed_, -1), false);
  }
  ::close(std::exchange(descriptor_, -1));
}

/// Tries to link the file as a new one. A link cannot replace a file, but renaming can; a new file
/// needs no temporary name, which a kill would leave behind. Returns whether the file has its name.
bool AtomicFile::linkAsNew() {
  const std::string self = fmt::format("/proc/self/fd/{}", descriptor_);
  const auto linkAs = [&self](const char* name) {
    return ::linkat(AT_FDCWD, self.c_str(), AT_FDCWD, name, AT_SYMLINK_FOLLOW) == 0;
  };
  if (linkAs(target_.c_str())) return true;
  if (errno != EEXIST) fail();
  const auto linkAsPart = [&] { return linkAs(name_.c_str()); };
  if (!giveHiddenName(linkAsPart) && errno == EEXIST) {
    name_ = partOfItsOwn(target_);
    giveHiddenName(linkAsPart);
  }
  if (!hasName_) fail();
  return false;
}

void AtomicFile::fail() const {
  const int why = errno;
  unfinishedNames.waitIfEnding();
  throw TextError(message("cannot be written: {}", Message(std::strerror(why))),
                  {printable(target_.string())});
}

void removeUnfinishedFiles() {
  unfinishedNames.removeAll();
}

void writeFileAtomically(const fs::path& file, std::string_view bytes) {
  AtomicFile whole(file);
  whole.write(bytes);
  whole.commit();
}

}  // namespace asperity
