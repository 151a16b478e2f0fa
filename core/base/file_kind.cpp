#include "core/base/file_kind.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace asperity {
namespace {

using namespace std::string_view_literals;

struct Signature {
  std::string_view bytes;
  std::string_view kind;
};

/// The longer ones before those that they begin with.
constexpr std::array<Signature, 18> kSignatures{
    {{"\xFF\xFE\0\0"sv, "text in UTF-32"},
     {"\0\0\xFE\xFF"sv, "text in UTF-32"},
     {"\xFF\xFE"sv, "text in UTF-16"},
     {"\xFE\xFF"sv, "text in UTF-16"},
     {"\x89PNG"sv, "a PNG picture"},
     {"\xFF\xD8\xFF"sv, "a JPEG picture"},
     {"GIF8"sv, "a GIF picture"},
     {"II*\0"sv, "a TIFF picture"},
     {"MM\0*"sv, "a TIFF picture"},
     {"RIFF"sv, "a RIFF file (as WebP is)"},
     {"%PDF-"sv, "a PDF document"},
     {"PK\3\4"sv, "a ZIP archive (as of a spreadsheet)"},
     {"\xD0\xCF\x11\xE0"sv, "an old Office document"},
     {"\x1F\x8B"sv, "a gzip archive"},
     {"\xFD"
      "7zXZ\0"sv,
      "an xz archive"},
     {"\x28\xB5\x2F\xFD"sv, "a zstd archive"},
     {"\x89HDF"sv, "an HDF5 file"},
     {"\x1A\x45\xDF\xA3"sv, "a WebM film"}}};

/// UTF-16 without its mark: of mostly Latin letters every other byte is 0.
bool looksLikeUtf16(std::string_view beginning) {
  std::array<std::size_t, 2> zeros{};
  for (std::size_t i = 0; i < beginning.size(); ++i) zeros[i % 2] += beginning[i] == '\0' ? 1 : 0;
  const auto [few, many] = std::minmax(zeros[0], zeros[1]);
  return many > beginning.size() / 4 && few <= many / 8;
}

}  // namespace

std::string_view foreignKindOf(std::string_view bytes) {
  constexpr std::size_t kLookedAt = 4096;
  for (const Signature& signature : kSignatures)
    if (bytes.starts_with(signature.bytes)) return signature.kind;
  const std::string_view beginning = bytes.substr(0, kLookedAt);
  if (beginning.find('\0') == std::string_view::npos) return {};
  return looksLikeUtf16(beginning) ? "text in UTF-16"sv : "a binary file"sv;
}

}  // namespace asperity
