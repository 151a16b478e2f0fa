#include "ui/draw/picture_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

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
  for (const auto& [name, mark] : {std::pair("a.png", "PNG"),
                                   {"b.PNG", "PNG"},
                                   {"a.Svg", "<svg"},
                                   {"a.pdf", "%PDF-"},
                                   {"b.PDF", "%PDF-"}}) {
    writePicture(folder / name, list, {});
    EXPECT_THAT(TemporaryFolder::read(folder / name).substr(0, 200), HasSubstr(mark)) << name;
  }
  EXPECT_THROW(writePicture(folder / "a.gif", list, {}), InputError);
}

}  // namespace
}  // namespace asperity
