// The content of a file by its bytes: which kind it is where it is no text, and text decoded to
// UTF-8 with plain line ends, whatever program wrote it. Pure; any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace asperity {

/// Returns "text in UTF-16", "a PNG picture", "a ZIP archive (as of a spreadsheet)" or "a binary
/// file"; empty where the bytes may be text in UTF-8. It examines only the beginning.
std::string_view detectNonText(std::string_view bytes);

/// Returns the bytes without the byte order mark of UTF-8 at their beginning.
constexpr std::string_view withoutByteOrderMark(std::string_view bytes) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  return bytes.starts_with(kMark) ? bytes.substr(kMark.size()) : bytes;
}

/// The text of a file in UTF-8, without its byte order mark, each line ended by LF or CR LF.
struct DecodedText {
  std::string_view text;      // of the bytes given, or of `converted`
  std::string_view encoding;  // "UTF-8", "UTF-16", "Shift-JIS", "GBK", ..., or "Latin-1"
  std::string converted{};    // where the bytes could not stay as they are

  /// Decodes UTF-8, UTF-16 (with a mark, or without one where every other byte is 0) or, where the
  /// bytes are not UTF-8, a code page of which it has words of measurements or a row of letters,
  /// else Latin-1 in Microsoft's variant. The bytes must outlive the object. Throws InputError that
  /// names the file `name` where the bytes are no text.
  DecodedText(std::string_view bytes, const std::string& name);
  DecodedText(const DecodedText&) = delete;  // the text may be its own
  DecodedText& operator=(const DecodedText&) = delete;
};

struct Utf8Character {
  std::uint32_t code = 0;
  std::size_t bytes = 0;  // 0: the first byte does not begin a UTF-8 character
};

/// Returns the first character of a text that is not empty. Only the shortest encoding is UTF-8,
/// and half of a UTF-16 surrogate pair is not a character.
Utf8Character firstCharacter(std::string_view text);

/// Returns whether a byte of UTF-8 begins a character, and does not continue one.
constexpr bool beginsCharacter(char byte) {
  return (byte & 0xC0) != 0x80;
}

/// Returns whether the whole text is UTF-8.
bool isUtf8(std::string_view text);

}  // namespace asperity
