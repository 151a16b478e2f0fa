#include "core/measured/zip_archive.h"

#include <zip.h>

#include <algorithm>

#include "core/base/destroyer.h"
#include "core/base/text.h"
#include "core/base/text_number.h"

namespace asperity {

void ZipArchive::Close::operator()(zip* archive) const {
  zip_discard(archive);
}

ZipArchive::ZipArchive(const SurfaceSource& source) : source_(source) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* bytes =
      zip_source_buffer_create(source.bytes.data(), source.bytes.size(), 0, &error);
  if (bytes != nullptr) {
    archive_.reset(zip_open_from_source(bytes, ZIP_RDONLY, &error));
    if (!archive_) zip_source_free(bytes);
  }
  zip_error_fini(&error);
  if (!archive_) source.fail(message("is not a whole {} archive", "ZIP"));
}

bool ZipArchive::has(const std::string& file) const {
  return indexOf(file) >= 0;
}

std::string ZipArchive::folderOf(const std::string& file) const {
  if (has(file)) return {};
  std::string folder;
  const zip_int64_t count = zip_get_num_entries(archive_.get(), 0);
  for (zip_int64_t i = 0; i < count; ++i) {
    const char* given = zip_get_name(archive_.get(), static_cast<zip_uint64_t>(i), 0);
    std::string name = given ? given : "";
    std::ranges::replace(name, '\\', '/');
    if (!lowerCase(name).ends_with("/" + file)) continue;
    if (!folder.empty()) return {};
    folder = name.substr(0, name.size() - file.size());
  }
  return folder;
}

std::string ZipArchive::read(const std::string& file, std::uint64_t limit) const {
  const zip_int64_t index = indexOf(file);
  if (index < 0) source_.fail(message("has no file '{}' in its archive", shortened(file)));
  zip_stat_t stat;
  zip_stat_init(&stat);
  const bool isKnown =
      zip_stat_index(archive_.get(), static_cast<zip_uint64_t>(index), 0, &stat) == 0 &&
      (stat.valid & ZIP_STAT_SIZE) != 0;
  if (!isKnown) fail(file);
  if (stat.size > limit)
    source_.fail(
        message("'{}' in its archive is larger than the {} bytes allowed", shortened(file), limit));
  // Deflate packs at most about a thousand bytes into one: a directory that states more is wrong.
  constexpr std::uint64_t kMaxDeflated = 1100, kAllowance = 4096;
  if ((stat.valid & ZIP_STAT_COMP_SIZE) == 0 ||
      stat.size / kMaxDeflated > stat.comp_size + kAllowance)
    fail(file);
  const std::unique_ptr<zip_file_t, Destroyer<zip_fclose>> open(
      zip_fopen_index(archive_.get(), static_cast<zip_uint64_t>(index), 0));
  if (!open) fail(file);
  std::string bytes;
  bytes.reserve(stat.size);
  constexpr std::size_t kStep = std::size_t{1} << 20;
  while (bytes.size() < stat.size) {
    const std::size_t before = bytes.size();
    // The memory grows with the bytes that are really there, whatever the directory states.
    bytes.resize(before + std::min<std::size_t>(kStep, stat.size - before));
    const zip_int64_t got = zip_fread(open.get(), bytes.data() + before, bytes.size() - before);
    if (got <= 0) fail(file);
    bytes.resize(before + static_cast<std::size_t>(got));
    source_.report(0.5 * static_cast<double>(bytes.size()) / static_cast<double>(stat.size));
  }
  // Reading on at the end makes the library compare the checksum.
  char more = 0;
  if (zip_fread(open.get(), &more, 1) != 0) fail(file);
  return bytes;
}

std::int64_t ZipArchive::indexOf(const std::string& file) const {
  // Some programs separate folders by "\\".
  std::string forward = file, backward = file;
  std::ranges::replace(forward, '\\', '/');
  std::ranges::replace(backward, '/', '\\');
  const std::int64_t index = zip_name_locate(archive_.get(), forward.c_str(), ZIP_FL_NOCASE);
  return index >= 0 ? index : zip_name_locate(archive_.get(), backward.c_str(), ZIP_FL_NOCASE);
}

void ZipArchive::fail(const std::string& file) const {
  source_.fail(message("'{}' in its archive cannot be unpacked", shortened(file)));
}

}  // namespace asperity
