// Files that are either whole or not there: written beside their final name, flushed to the disk
// and renamed. A failed or killed write leaves whatever stood under the name before.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace asperity {

/// Throws InputError (file, "", why) where nothing can ever be written under this name: a folder
/// that is missing, something there that is not a plain file, or a link to what is not there. Call
/// before long work.
void checkWritable(const std::filesystem::path& file);

/// A file without a name in the folder of the final one: killed, it leaves nothing behind, save in
/// the moment of replacing a file, when it has a hidden name. Where the file system knows no files
/// without names it has the hidden name all the while. The next write of the same file removes what
/// a kill left under that name, and nothing that another process is writing. A file that is
/// replaced hands its owner and its permissions on.
/// Every member throws std::runtime_error in one sentence with the file's name where it fails.
class AtomicFile {
 public:
  /// Throws what checkWritable throws.
  explicit AtomicFile(const std::filesystem::path& file);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(std::string_view bytes);

  /// Open for reading and writing; another program may be given it.
  int descriptor() const { return descriptor_; }
  /// What is written so far, at most so many bytes of it.
  std::string content(std::size_t most = static_cast<std::size_t>(-1)) const;
  void replace(std::string_view bytes);

  /// Flushed to the disk and under its final name. The last call.
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
  int listed_ = -1;  // place of the hidden name among those of unfinished files
};

/// Removes the hidden names of all files that are being written, for a process that is about to
/// end: a thread that gives a file such a name from then on, or whose writing fails, waits for the
/// end. May be called in a handler of SIGINT and SIGTERM.
void removeUnfinishedFiles();

/// Throws what checkWritable throws, and std::runtime_error in one sentence with the file's name
/// where writing fails.
void writeFileAtomically(const std::filesystem::path& file, std::string_view bytes);

/// The whole of a file of at most `limit` bytes. Throws InputError.
std::string readWholeFile(const std::filesystem::path& file, std::size_t limit);

}  // namespace asperity
