#include "core/base/file_digest.h"

#include <nettle/md5.h>
#include <nettle/sha2.h>

#include <array>
#include <cstdint>
#include <map>
#include <mutex>
#include <span>

#include "core/base/regular_file.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

const std::uint8_t* asBytes(std::string_view text) {
  return reinterpret_cast<const std::uint8_t*>(text.data());
}

/// Returns two hexadecimal digits for each byte.
std::string hexadecimal(std::span<const std::uint8_t> bytes) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (const std::uint8_t byte : bytes) {
    text += kDigits[byte >> 4];
    text += kDigits[byte & 15];
  }
  return text;
}

class Sha256 {
 public:
  Sha256() { sha256_init(&context_); }
  void add(std::string_view bytes) { sha256_update(&context_, bytes.size(), asBytes(bytes)); }
  std::string digest() {
    std::array<std::uint8_t, SHA256_DIGEST_SIZE> bytes{};
    sha256_digest(&context_, bytes.size(), bytes.data());
    return hexadecimal(bytes);
  }

 private:
  sha256_ctx context_{};
};

struct Known {
  std::uintmax_t size = 0;
  fs::file_time_type time{};
  std::string digest{};
};

}  // namespace

std::string sha256(std::string_view bytes) {
  Sha256 sha;
  sha.add(bytes);
  return sha.digest();
}

std::string md5(std::string_view bytes) {
  md5_ctx context;
  md5_init(&context);
  md5_update(&context, bytes.size(), asBytes(bytes));
  std::array<std::uint8_t, MD5_DIGEST_SIZE> digest{};
  md5_digest(&context, digest.size(), digest.data());
  return hexadecimal(digest);
}

std::string sha256OfFile(const fs::path& file) {
  static std::mutex lock;
  static std::map<std::string, Known> known;
  const RegularFile open(file);
  std::error_code error;
  const fs::file_time_type time = fs::last_write_time(file, error);
  const std::string name = fs::absolute(file, error).string();
  {
    const std::lock_guard guard(lock);
    const auto found = known.find(name);
    if (found != known.end() && found->second.size == open.size() && found->second.time == time)
      return found->second.digest;
  }
  constexpr std::size_t kPart = std::size_t{1} << 20;
  Sha256 sha;
  for (std::uint64_t offset = 0;; offset += kPart) {
    const std::string part = open.read(offset, kPart);
    sha.add(part);
    if (part.size() < kPart) break;
  }
  Known now{open.size(), time, sha.digest()};
  const std::lock_guard guard(lock);
  return (known[name] = std::move(now)).digest;
}

}  // namespace asperity
