#include "ui/draw/picture_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/base/input_error.h"
#include "tests/core/temporary_folder.h"

namespace asperity {
namespace {

using testing::HasSubstr;

TEST(PictureFile, HasTheFormatOfItsExtensionInSmallOrCapitalLetters) {
  const TemporaryFolder folder;
  DrawList list;
  list.width = 40;
  list.height = 30;
  std::vector<std::pair<std::string, std::string>> files{{"a.png", "PNG"},
                                                         {"b.PNG", "PNG"},
                                                         {"a.Svg", "<svg"},
                                                         {"a.pdf", "%PDF-"},
                                                         {"b.PDF", "%PDF-"}};
  if (canWriteEps()) files.emplace_back("a.eps", "%!PS");
  if (canWriteTiff()) files.emplace_back("a.tif", "II*");
  if (canWriteTiff()) files.emplace_back("b.TIFF", "II*");
  for (const auto& [name, mark] : files) {
    writePicture(folder / name, list, {});
    EXPECT_THAT(TemporaryFolder::read(folder / name).substr(0, 200), HasSubstr(mark)) << name;
  }
  EXPECT_THROW(writePicture(folder / "a.gif", list, {}), InputError);
}

}  // namespace
}  // namespace asperity
