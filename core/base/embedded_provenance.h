// The provenance in a file that the program wrote, found by the structure of the file: in the text
// chunk "asperity" of a PNG, the metadata of SVG, PDF, EPS, TIFF, GIF, WebP, MP4 and WebM, the
// first line of a table. Other texts in the file (a title, a label) are ignored. Pure; any thread.
// Time and memory grow linearly with the bytes, whatever they are.
#pragma once

#include <string>
#include <string_view>

namespace asperity {

/// Returns the text that was given to the writer of the file, without XML entities; empty where
/// there is none. `bytes`: the file, or its first and its last bytes where it is very large.
std::string embeddedProvenance(std::string_view bytes);

}  // namespace asperity
