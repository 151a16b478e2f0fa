// What a file is that cannot be read as text in UTF-8. Pure; any thread.
#pragma once

#include <string_view>

namespace asperity {

/// "text in UTF-16", "a PNG picture", "a ZIP archive (as of a spreadsheet)", "a binary file"; empty
/// where the bytes may be text in UTF-8. Looks at the beginning alone.
std::string_view foreignKindOf(std::string_view bytes);

}  // namespace asperity
