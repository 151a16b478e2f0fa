// What a file that the program wrote says of itself, found by the file's own structure: the text
// chunk "asperity" of a PNG, the metadata of SVG, PDF, GIF, WebP, MP4 and WebM, the first line of a
// table. What else stands in the file (a title, a label) is not looked at, whatever it says.
// Pure; any thread. Time and memory grow with the bytes, for any bytes.
#pragma once

#include <string>
#include <string_view>

namespace asperity {

/// The text as it was given to the writer of the file, without the entities of XML; empty where
/// there is none. `bytes`: the file, or its first and its last bytes where it is very large.
std::string carriedText(std::string_view bytes);

}  // namespace asperity
