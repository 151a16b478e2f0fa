// Decodes text files to UTF-8 with plain line ends, whatever program wrote them. Pure; any thread.
#pragma once

#include <string>
#include <string_view>

namespace asperity {

/// The text of a file in UTF-8, without its byte order mark, each line ended by LF or CR LF.
struct DecodedText {
  std::string_view text;      // of the bytes given, or of `converted`
  std::string_view encoding;  // "UTF-8", "UTF-16" or "Latin-1"
  std::string converted{};    // where the bytes could not stay as they are

  /// Decodes UTF-8, UTF-16 (with a mark, or without one where every other byte is 0) or, where the
  /// bytes are not UTF-8, Latin-1 in Microsoft's variant. The bytes must outlive the object. Throws
  /// InputError that names the file `name` where the bytes are no text.
  DecodedText(std::string_view bytes, const std::string& name);
  DecodedText(const DecodedText&) = delete;  // the text may be its own
  DecodedText& operator=(const DecodedText&) = delete;
};

/// Returns whether the whole text is UTF-8.
bool isUtf8(std::string_view text);

}  // namespace asperity
