// Files that are either complete or absent: they are written beside their final name, flushed to
// the disk and renamed. A failed or killed write leaves the earlier file of that name as it was.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace asperity {

/// Throws InputError (file, "", why) where nothing can ever be written under this name: a missing
/// folder, an existing object that is not a plain file, or a link to a missing file. Call it before
/// long work.
void checkWritable(const std::filesystem::path& file);

/// Returns whether the file is one of these inputs, which writing would replace.
bool isAnyOf(const std::filesystem::path& file, std::span<const std::filesystem::path> inputs);

/// Throws InputError (file, "", why) where the file is one of these inputs.
void checkReplacesNone(const std::filesystem::path& file,
                       std::span<const std::filesystem::path> inputs);

/// A file without a name in the folder of the final one. If the process is killed it leaves nothing
/// behind, except at the moment of replacing a file, when it has a hidden name. Where the file
/// system has no files without names it has the hidden name all the time. The next write of the
/// same file removes what a kill left under that name, but nothing that another process is writing.
/// The owner and the permissions of a replaced file are kept. Every member throws
/// std::runtime_error in one sentence with the file's name where it fails.
class AtomicFile {
 public:
  /// Throws what checkWritable throws.
  explicit AtomicFile(const std::filesystem::path& file);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(std::string_view bytes);

  /// The descriptor is open for reading and writing; it may be passed to another program.
  int descriptor() const { return descriptor_; }
  /// Returns the content written so far, at most this many bytes of it.
  std::string content(std::size_t most = static_cast<std::size_t>(-1)) const;
  void replace(std::string_view bytes);

  /// Flushes the file to the disk and gives it its final name. It must be the last call.
  void commit();

 private:
  [[noreturn]] void fail() const;
  void takePermissions() const;
  bool openNamed();
  bool linkAsNew();
  template <class Give>
  bool giveHiddenName(const Give& give);

  std::filesystem::path target_;
  std::string name_;
  int descriptor_ = -1;
  bool hasName_ = false;
  int listed_ = -1;  // slot in the list of hidden names of unfinished files
};

/// Removes the hidden names of all files that are being written, for a process that is about to
/// end. A thread that gives a file such a name later, or whose writing fails, waits for the end. It
/// may be called in a handler of SIGINT and SIGTERM.
void removeUnfinishedFiles();

/// Writes a whole file. Throws what checkWritable throws, and std::runtime_error in one sentence
/// with the file's name where writing fails.
void writeFileAtomically(const std::filesystem::path& file, std::string_view bytes);

}  // namespace asperity
