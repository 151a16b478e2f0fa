// Names of columns with line breaks, as spreadsheets write long ones in quotes. Pure; any thread.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// A text whose quoted fields with line breaks, as spreadsheets write long names of columns, stand
/// in one line each.
struct JoinedText {
  std::string_view text{};            // of the text given, or of `joined`
  std::string joined{};               // where there are such fields
  std::vector<std::size_t> breaks{};  // positions in it at which a line of the file ended

  explicit JoinedText(std::string_view written);
  JoinedText(const JoinedText&) = delete;  // the text may be its own
  JoinedText& operator=(const JoinedText&) = delete;
};

}  // namespace asperity
