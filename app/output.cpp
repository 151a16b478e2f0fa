#include "app/output.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>

#include "core/scene/atomic_file.h"
#include "core/scene/input_error.h"

namespace asperity {

std::string extensionOf(const std::string& file) {
  std::string extension = std::filesystem::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return extension;
}

void checkOutputs(const std::vector<std::string>& files,
                  std::initializer_list<std::string_view> extensions) {
  for (const std::string& file : files) {
    checkWritable(file);
    const std::string extension = extensionOf(file);
    if (std::find(extensions.begin(), extensions.end(), extension) == extensions.end())
      throw InputError(
          file, "", fmt::format("'{}' is not one of {}", extension, fmt::join(extensions, ", ")));
  }
}

void makeFolder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder))
    throw InputError(folder, "", "is not a folder and cannot be made one");
}

void printSummary(bool machineReads, bool quiet, const std::string& text) {
  if (quiet) return;
  if (machineReads)
    std::fputs(text.c_str(), stderr);
  else
    fmt::print("{}", text);
}

}  // namespace asperity
