// The files of a ZIP archive in memory, whose sizes and checksums are not trusted. Not thread-safe.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "core/measured/surface_draft.h"

struct zip;

namespace asperity {

class ZipArchive {
 public:
  /// Throws InputError where the bytes of the source are no whole archive.
  explicit ZipArchive(const SurfaceSource& source);

  bool has(const std::string& file) const;

  /// Returns the folder, with "/" at its end, in which the archive has the file: empty where it is
  /// in none, or in no folder or several ones.
  std::string folderOf(const std::string& file) const;

  /// Returns all bytes of a file in the archive. Throws InputError where there are more than
  /// `limit`, or where they cannot be unpacked.
  std::string read(const std::string& file, std::uint64_t limit) const;

 private:
  struct Close {
    void operator()(zip* archive) const;
  };

  /// Returns the index of a file; below 0 where the archive does not have it.
  std::int64_t indexOf(const std::string& file) const;
  [[noreturn]] void fail(const std::string& file) const;

  const SurfaceSource& source_;
  std::unique_ptr<zip, Close> archive_;
};

}  // namespace asperity
