#include "core/base/text_encoding.h"

#include <iconv.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>

#include "core/base/input_error.h"
#include "core/base/text.h"

namespace asperity {
namespace {

using namespace std::string_view_literals;

struct Signature {
  std::string_view bytes;
  std::string_view kind;
};

/// A longer signature comes before one that is its beginning.
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

/// UTF-16 without a byte order mark: in mostly Latin text every second byte is 0.
bool looksLikeUtf16(std::string_view beginning) {
  std::array<std::size_t, 2> zeros{};
  for (std::size_t i = 0; i < beginning.size(); ++i) zeros[i % 2] += beginning[i] == '\0' ? 1 : 0;
  const auto [few, many] = std::minmax(zeros[0], zeros[1]);
  return many > beginning.size() / 4 && few <= many / 8;
}

unsigned char byteAt(std::string_view text, std::size_t index) {
  return static_cast<unsigned char>(text[index]);
}

void appendUtf8(std::string& text, std::uint32_t code) {
  const auto add = [&text](std::uint32_t byte) { text += static_cast<char>(byte); };
  if (code < 0x80) return add(code);
  if (code < 0x800) {
    add(0xC0 | code >> 6);
  } else {
    if (code < 0x10000) {
      add(0xE0 | code >> 12);
    } else {
      add(0xF0 | code >> 18);
      add(0x80 | (code >> 12 & 0x3F));
    }
    add(0x80 | (code >> 6 & 0x3F));
  }
  add(0x80 | (code & 0x3F));
}

std::string utf8OfUtf16(std::string_view bytes, bool littleEndian) {
  const std::size_t count = bytes.size() / 2;
  const auto unit = [&](std::size_t i) -> std::uint32_t {
    const std::uint32_t first = byteAt(bytes, 2 * i), second = byteAt(bytes, 2 * i + 1);
    return littleEndian ? second << 8 | first : first << 8 | second;
  };
  std::string text;
  text.reserve(count + count / 8);
  for (std::size_t i = 0; i < count; ++i) {
    std::uint32_t code = unit(i);
    if (code >= 0xD800 && code < 0xDC00 && i + 1 < count && (unit(i + 1) & 0xFC00U) == 0xDC00) {
      code = 0x10000 + ((code - 0xD800) << 10) + (unit(i + 1) - 0xDC00);
      ++i;
    } else if ((code & 0xF800U) == 0xD800) {
      code = 0xFFFD;  // half of a pair
    }
    appendUtf8(text, code);
  }
  return text;
}

/// The bytes 0x80 to 0x9F of Microsoft's variant; unused ones are as in Latin-1.
constexpr std::array<std::uint16_t, 32> kMicrosoft{
    0x20AC, 0x81,   0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
    0x2039, 0x0152, 0x8D,   0x017D, 0x8F,   0x90,   0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
    0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0x9D,   0x017E, 0x0178};

std::string utf8OfLatin1(std::string_view bytes) {
  std::string text;
  text.reserve(bytes.size() + bytes.size() / 16);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const unsigned char byte = byteAt(bytes, i);
    appendUtf8(text, byte >= 0x80 && byte < 0xA0 ? kMicrosoft[byte - 0x80U] : byte);
  }
  return text;
}

/// A code page, and words of measurements in it, separated by blanks; in Latin-1 they would be
/// letters that no language puts together.
struct CodePage {
  std::string_view encoding;  // as a user knows it
  const char* name;           // of the converter: the variant of Microsoft
  WordList words;
};
constexpr CodePage kCodePages[] = {
    // Japanese: temperature, frequency, modulus, loss, measurement, velocity, friction, load,
    // height, roughness.
    {"Shift-JIS", "CP932",
     "\x89\xB7\x93x "
     "\x8E\xFC\x94g\x90\x94 "
     "\x92"
     "e\x90\xAB\x97\xA6 "
     "\x91\xB9\x8E\xB8 "
     "\x91\xAA\x92\xE8 "
     "\x91\xAC\x93x "
     "\x96\x80\x8E"
     "C "
     "\x89\xD7\x8F"
     "d "
     "\x8D\x82\x82\xB3 "
     "\x91"
     "e\x82\xB3"},
    // Chinese: frequency, temperature, modulus, friction, velocity, load, height, roughness.
    {"GBK", "CP936",
     "\xC6\xB5\xC2\xCA "
     "\xCE\xC2\xB6\xC8 "
     "\xC4\xA3\xC1\xBF "
     "\xC4\xA6\xB2\xC1 "
     "\xCB\xD9\xB6\xC8 "
     "\xD4\xD8\xBA\xC9 "
     "\xB8\xDF\xB6\xC8 "
     "\xB4\xD6\xB2\xDA"},
    // Korean: frequency, temperature, elastic, friction, velocity, load, height.
    {"EUC-KR", "CP949",
     "\xC1\xD6\xC6\xC4\xBC\xF6 "
     "\xBF\xC2\xB5\xB5 "
     "\xC5\xBA\xBC\xBA "
     "\xB8\xB6\xC2\xFB "
     "\xBC\xD3\xB5\xB5 "
     "\xC7\xCF\xC1\xDF "
     "\xB3\xF4\xC0\xCC"},
    // Czech and Polish: friction, coefficient, load, storage, loss; velocity, frequency, modulus,
    // coefficient.
    {"Windows-1250", "CP1250",
     "t\xF8"
     "en\xED "
     "ou\xE8initel "
     "at\xED\x9E"
     "en\xED "
     "am\xEC\x9Dov\xFD "
     "tr\xE1tov\xFD "
     "pr\xEA"
     "dko\x9C\xE6 "
     "r\xEA"
     "dko\x9C\xE6 "
     "stotliwo\x9C Modu\xB3 modu\xB3 "
     "wsp\xF3\xB3"
     "czynnik"},
    // Turkish: temperature, velocity, friction, loss, angular, height.
    {"Windows-1254", "CP1254",
     "\xFD"
     "cakl\xFDk "
     "h\xFDz "
     "H\xFDz "
     "\xFCrt\xFCnme "
     "ay\xFDp "
     "\xE7\xFDsal "
     "\xFCkseklik"}};

/// Returns whether a text is in the code page of Windows for Russian: the letters would all be
/// accented ones in Latin-1.
bool isRussian(std::string_view bytes) {
  constexpr std::size_t kLetters = 5;
  std::size_t run = 0;
  return std::ranges::any_of(bytes, [&run](char letter) {
    run = static_cast<unsigned char>(letter) >= 0xC0 ? run + 1 : 0;
    return run == kLetters;
  });
}

/// Returns the code page of a text by the words at its beginning; nothing where it is not known.
std::optional<CodePage> codePageOf(std::string_view bytes) {
  constexpr std::size_t kLookedAt = std::size_t{1} << 16;
  bytes = bytes.substr(0, kLookedAt);
  for (const CodePage& page : kCodePages)
    if (containsOneOf(bytes, page.words)) return page;
  if (isRussian(bytes)) return CodePage{"Windows-1251", "CP1251", ""};
  return {};
}

/// Returns a text in a code page as UTF-8; empty where it is none.
std::string utf8OfCodePage(std::string_view bytes, const char* codePage) {
  const iconv_t converter = iconv_open("UTF-8", codePage);
  if (converter == reinterpret_cast<iconv_t>(-1)) return {};
  constexpr std::size_t kMaxBytes = 3;  // of UTF-8 for one in any of these code pages
  std::string from(bytes), text(kMaxBytes * bytes.size(), '\0');
  char *in = from.data(), *out = text.data();
  std::size_t left = from.size(), room = text.size();
  const std::size_t failed = iconv(converter, &in, &left, &out, &room);
  iconv_close(converter);
  if (failed == static_cast<std::size_t>(-1) || left > 0) return {};
  text.resize(text.size() - room);
  return text;
}

/// Returns a text that was encoded in UTF-8 twice, the second time as if it were Latin-1, as it was
/// before: with "\u00B0C" for "\u00C2\u00B0C". Empty where it was not.
std::string encodedOnce(std::string_view text) {
  if (text.find("\u00C2") == text.npos && text.find("\u00C3") == text.npos) return {};
  std::string bytes;
  bytes.reserve(text.size());
  while (!text.empty()) {
    const auto [code, size] = firstCharacter(text);
    const auto* const found = std::ranges::find(kMicrosoft, code);
    if (code < 0x100)
      bytes += static_cast<char>(code);
    else if (found != kMicrosoft.end())
      bytes += static_cast<char>(0x80 + (found - kMicrosoft.begin()));
    else
      return {};
    text.remove_prefix(size);
  }
  return isUtf8(bytes) ? bytes : std::string();
}

/// Returns whether some carriage return is not followed by a line feed.
bool hasLoneReturn(std::string_view text) {
  for (std::size_t at = 0; (at = text.find('\r', at)) != std::string_view::npos; ++at)
    if (at + 1 == text.size() || text[at + 1] != '\n') return true;
  return false;
}

std::string withLineFeeds(std::string_view text) {
  std::string changed;
  changed.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool isPair = text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n';
    if (!isPair) changed += text[i] == '\r' ? '\n' : text[i];
  }
  return changed;
}

}  // namespace

std::string_view detectNonText(std::string_view bytes) {
  constexpr std::size_t kLookedAt = 4096;
  for (const Signature& signature : kSignatures)
    if (bytes.starts_with(signature.bytes)) return signature.kind;
  const std::string_view beginning = bytes.substr(0, kLookedAt);
  const std::size_t zero = beginning.find('\0');
  if (zero == std::string_view::npos) return {};
  // Zeros after a text alone fill up its last block.
  if (zero > 1 && !looksLikeUtf16(beginning) &&
      bytes.find_first_not_of('\0', zero) == std::string_view::npos)
    return {};
  return looksLikeUtf16(beginning) ? "text in UTF-16"sv : "a binary file"sv;
}

Utf8Character firstCharacter(std::string_view text) {
  constexpr std::array<std::uint32_t, 5> kMin{0, 0, 0x80, 0x800, 0x10000};
  const unsigned char first = byteAt(text, 0);
  if (first < 0x80) return {first, 1};
  const std::size_t bytes = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC0 || first >= 0xF8 || text.size() < bytes) return {};
  std::uint32_t code = first & (0xFFU >> (bytes + 1));
  for (std::size_t i = 1; i < bytes; ++i) {
    if (beginsCharacter(text[i])) return {};
    code = code << 6 | (byteAt(text, i) & 0x3FU);
  }
  const bool isCharacter =
      code >= kMin[bytes] && code <= 0x10FFFF && !(code >= 0xD800 && code <= 0xDFFF);
  return isCharacter ? Utf8Character{code, bytes} : Utf8Character{};
}

bool isUtf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    // This tests eight letters of ASCII at once.
    std::uint64_t eight = 0;
    while (i + 8 <= text.size()) {
      std::memcpy(&eight, text.data() + i, 8);
      if ((eight & 0x8080808080808080U) != 0) break;
      i += 8;
    }
    if (i == text.size()) break;
    const std::size_t bytes = firstCharacter(text.substr(i)).bytes;
    if (bytes == 0) return false;
    i += bytes;
  }
  return true;
}

DecodedText::DecodedText(std::string_view bytes, const std::string& name)
    : text(bytes), encoding("UTF-8") {
  constexpr std::string_view kMarkLittle = "\xFF\xFE", kMarkBig = "\xFE\xFF";
  const std::string_view kind = detectNonText(bytes);
  if (kind == "text in UTF-16") {
    const bool hasMark = bytes.starts_with(kMarkLittle) || bytes.starts_with(kMarkBig);
    const bool isLittle = hasMark ? bytes.starts_with(kMarkLittle) : byteAt(bytes, 0) != 0;
    converted = utf8OfUtf16(bytes.substr(hasMark ? 2 : 0), isLittle);
    text = converted;
    encoding = "UTF-16";
  } else if (!kind.empty()) {
    throw InputError(name, "", message("is {}, not a table of numbers as text", Message(kind)));
  } else {
    text = withoutByteOrderMark(bytes);
  }
  if (encoding == "UTF-8" && !isUtf8(text)) {
    const auto page = codePageOf(text);
    if (page) converted = utf8OfCodePage(text, page->name);
    encoding = converted.empty() ? "Latin-1" : page->encoding;
    if (converted.empty()) converted = utf8OfLatin1(text);
    text = converted;
  }
  if (encoding == "UTF-8")
    if (std::string once = encodedOnce(text); !once.empty()) {
      converted = std::move(once);
      text = converted;
    }
  // The padding of the last block of a file is no text.
  const std::size_t end = text.find_last_not_of(std::string_view("\0\x1A", 2));
  text = text.substr(0, end == std::string_view::npos ? 0 : end + 1);
  if (hasLoneReturn(text)) {
    converted = withLineFeeds(text);
    text = converted;
  }
}

}  // namespace asperity
