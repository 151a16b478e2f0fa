#include "core/base/embedded_provenance.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "core/base/text_encoding.h"

namespace asperity {
namespace {

using std::literals::operator""sv;

/// Returns the bytes after the first `mark`; empty where there is none.
std::string_view after(std::string_view bytes, std::string_view mark) {
  const std::size_t at = bytes.find(mark);
  return at == std::string_view::npos ? std::string_view{} : bytes.substr(at + mark.size());
}

/// Returns the bytes before the first `mark`; empty where there is none.
std::string_view before(std::string_view bytes, std::string_view mark) {
  const std::size_t at = bytes.find(mark);
  return at == std::string_view::npos ? std::string_view{} : bytes.substr(0, at);
}

std::uint64_t bigEndian(std::string_view bytes) {
  std::uint64_t number = 0;
  for (const char byte : bytes) number = number << 8 | static_cast<unsigned char>(byte);
  return number;
}

/// Returns the first `size` bytes; empty where there are fewer.
std::string_view first(std::string_view bytes, std::uint64_t size) {
  return size <= bytes.size() ? bytes.substr(0, size) : std::string_view{};
}

/// Returns the text chunk before the image data.
std::string_view textOfPng(std::string_view bytes) {
  constexpr std::string_view kKey = "asperity\0\0\0\0\0"sv;  // not compressed, no language
  constexpr std::size_t kSignature = 8, kAround = 12;        // length, type and checksum
  for (std::size_t at = kSignature; at + kAround <= bytes.size();) {
    const std::uint64_t size = bigEndian(bytes.substr(at, 4));
    const std::string_view type = bytes.substr(at + 4, 4);
    if (type == "IDAT" || size > bytes.size() - at - kAround) return {};
    const std::string_view data = bytes.substr(at + 8, size);
    if (type == "iTXt" && data.starts_with(kKey)) return data.substr(kKey.size());
    at += size + kAround;
  }
  return {};
}

/// Returns the comment of MP4: a box that contains one box of data.
std::string_view textOfMp4(std::string_view bytes) {
  constexpr std::string_view kUtf8 = "data\0\0\0\1\0\0\0\0"sv;
  while (!(bytes = after(bytes,
                         "\xA9"
                         "cmt"))
              .empty()) {
    if (bytes.size() < 16 || bytes.substr(4, kUtf8.size()) != kUtf8) continue;
    const std::uint64_t size = bigEndian(bytes.substr(0, 4));
    if (size >= 16) return first(bytes.substr(16), size - 16);
  }
  return {};
}

/// Returns the string after the tag of this name of WebM. The number of leading zero bits in the
/// length's first byte, plus one, is the number of bytes of the length.
std::string_view textOfWebm(std::string_view bytes) {
  const std::string_view rest = after(bytes,
                                      "\x45\xA3\x87"
                                      "COMMENT"
                                      "\x44\x87");
  if (rest.empty()) return {};
  const auto head = static_cast<unsigned char>(rest[0]);
  std::size_t width = 1;
  while (width < 8 && (head & 0x80U >> (width - 1)) == 0) ++width;
  if (rest.size() < width) return {};
  const std::uint64_t marked = bigEndian(rest.substr(0, width));
  return first(rest.substr(width), marked & ((std::uint64_t{1} << 7 * width) - 1));
}

/// Returns the text from the first element of this name to its end; escaped text has no other
/// bracket.
std::string_view textOfElement(std::string_view bytes, std::string_view beginning) {
  return before(after(after(bytes, beginning), ">"), "<");
}

/// Returns the description in an XMP packet of PDF, GIF and WebP.
std::string_view textOfXmp(std::string_view bytes) {
  return textOfElement(after(bytes, "<dc:description>"), "<rdf:li");
}

/// Replaces the entities that a writer of XML may have used for characters of JSON.
std::string withoutEntities(std::string_view xml) {
  constexpr std::array<std::pair<std::string_view, char>, 7> kEntities{{{"&quot;", '"'},
                                                                        {"&amp;", '&'},
                                                                        {"&lt;", '<'},
                                                                        {"&gt;", '>'},
                                                                        {"&apos;", '\''},
                                                                        {"&#34;", '"'},
                                                                        {"&#x22;", '"'}}};
  std::string text;
  text.reserve(xml.size());
  for (std::size_t i = 0; i < xml.size();) {
    std::size_t taken = 1;
    char letter = xml[i];
    if (letter == '&')
      for (const auto& [entity, meant] : kEntities)
        if (xml.substr(i, entity.size()) == entity) {
          letter = meant;
          taken = entity.size();
        }
    text += letter;
    i += taken;
  }
  return text;
}

/// Returns the first line of a table.
std::string_view textOfTable(std::string_view bytes) {
  constexpr std::string_view kBeginning = "# asperity: ";
  if (!bytes.starts_with(kBeginning)) return {};
  bytes.remove_prefix(kBeginning.size());
  return bytes.substr(0, bytes.find_first_of("\r\n"));
}

/// Returns the description of the image of TIFF, a text that ends with a zero byte.
std::string_view textOfTiff(std::string_view bytes) {
  const std::string_view rest = after(bytes, "asperity: {");
  return rest.empty() ? rest : before({rest.data() - 1, rest.size() + 1}, "\0"sv);
}

/// Returns the text in the comments after the header of EPS, each of which has a part of it.
std::string textOfEps(std::string_view bytes) {
  constexpr std::string_view kBeginning = "\n%asperity: ";
  std::string text;
  std::size_t at = bytes.find(kBeginning);
  while (at != std::string_view::npos && bytes.substr(at).starts_with(kBeginning)) {
    const std::size_t begin = at + kBeginning.size();
    at = bytes.find('\n', begin);
    text += bytes.substr(begin, at == std::string_view::npos ? at : at - begin);
  }
  return text;
}

}  // namespace

std::string embeddedProvenance(std::string_view bytes) {
  bytes = withoutByteOrderMark(bytes);
  if (bytes.starts_with("\x89PNG\r\n\x1A\n")) return std::string(textOfPng(bytes));
  if (bytes.substr(0, 8).ends_with("ftyp")) return std::string(textOfMp4(bytes));
  if (bytes.starts_with("\x1A\x45\xDF\xA3")) return std::string(textOfWebm(bytes));
  if (bytes.starts_with("%PDF") || bytes.starts_with("GIF8") || bytes.starts_with("RIFF"))
    return withoutEntities(textOfXmp(bytes));
  if (bytes.substr(0, bytes.find_first_not_of(" \t\r\n") + 1).ends_with('<'))
    return withoutEntities(textOfElement(bytes, "<metadata"));
  if (bytes.starts_with("II*\0"sv) || bytes.starts_with("MM\0*"sv))
    return std::string(textOfTiff(bytes));
  if (bytes.starts_with("%!PS")) return textOfEps(bytes);
  return std::string(textOfTable(bytes));
}

}  // namespace asperity
