#include "ui/draw/picture_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "core/base/input_error.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::string bytesOf(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(PictureFile, HasTheFormatOfItsExtensionInSmallOrCapitalLetters) {
  const fs::path folder = fs::temp_directory_path() / ("asperity_file_" + std::to_string(getpid()));
  fs::create_directories(folder);
  DrawList list;
  list.width = 40;
  list.height = 30;
  for (const auto& [name, mark] : {std::pair("a.png", "PNG"),
                                   {"b.PNG", "PNG"},
                                   {"a.Svg", "<svg"},
                                   {"a.pdf", "%PDF-"},
                                   {"b.PDF", "%PDF-"}}) {
    writePicture(folder / name, list, {});
    EXPECT_THAT(bytesOf(folder / name).substr(0, 200), HasSubstr(mark)) << name;
  }
  EXPECT_THROW(writePicture(folder / "a.gif", list, {}), InputError);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace asperity
