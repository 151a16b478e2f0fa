// Files that are either whole or not there: written beside their final name, flushed to the disk
// and renamed. A failed or killed write leaves whatever stood under the name before.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace asperity {

/// Throws InputError (file, "", why) where nothing can ever be written under this name: a folder
/// that is missing, or something there that is not a plain file. Call before long work.
void checkWritable(const std::filesystem::path& file);

/// A file without a name in the folder of the final one: killed, it leaves nothing behind, save in
/// the moment of replacing a file, when it has a hidden name. Where the file system knows no files
/// without names it has the hidden name all the while. The next write of the same file removes what
/// a kill left under that name, and nothing that another process is writing.
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
  std::string content() const;
  void replace(std::string_view bytes);

  /// Flushed to the disk and under its final name. The last call.
  void commit();

 private:
  [[noreturn]] void fail() const;
  bool openNamed();
  bool linkAsNew();

  std::filesystem::path target_;
  std::string name_;
  int descriptor_ = -1;
  bool hasName_ = false;
};

/// Throws what checkWritable throws, and std::runtime_error in one sentence with the file's name
/// where writing fails.
void writeFileAtomically(const std::filesystem::path& file, std::string_view bytes);

/// The whole of a file of at most `limit` bytes. Throws InputError.
std::string readWholeFile(const std::filesystem::path& file, std::size_t limit);

}  // namespace asperity
