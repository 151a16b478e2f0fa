// Reads files; most of them only where they are plain ones on a disk, because a pipe or a device
// might never answer.
// Failure: InputError that names the file, but contains nothing of its content.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace asperity {

/// An open file. Opening and reading never wait for another program. One thread at a time.
class RegularFile {
 public:
  /// Throws InputError where the file is missing or is not a regular one.
  explicit RegularFile(const std::filesystem::path& file);
  ~RegularFile();
  RegularFile(const RegularFile&) = delete;
  RegularFile& operator=(const RegularFile&) = delete;

  std::uint64_t size() const { return size_; }  // bytes, at the time of opening

  /// Returns at most `count` bytes from `offset` on; fewer where the file ends.
  std::string read(std::uint64_t offset, std::size_t count) const;

 private:
  std::string name_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
};

/// Returns the content of a regular file of at most `limit` bytes.
std::string readRegularFile(const std::filesystem::path& file, std::size_t limit);

/// Returns the content of a file of at most `limit` bytes, which may be a pipe.
std::string readWholeFile(const std::filesystem::path& file, std::size_t limit);

}  // namespace asperity
