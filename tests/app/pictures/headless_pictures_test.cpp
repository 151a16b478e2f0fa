#include "app/pictures/headless_pictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "core/base/input_error.h"
#include "tests/core/temporary_folder.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

DrawList picture() {
  DrawList list;
  list.width = 60;
  list.height = 40;
  list.background = {1, 1, 1, 1};
  DrawText text;
  text.utf8 = "words";
  text.x = 5;
  text.y = 20;
  list.texts.push_back(text);
  return list;
}

/// One program, one Qt application: everything in one test.
TEST(HeadlessPictures, WriteWhatTheExtensionSays) {
  const TemporaryFolder folder;
  {
    HeadlessPictures pictures;
    for (const char* name : {"a.png", "a.SVG", "a.pdf"})
      pictures.write((folder / name).string(), picture(), {"A title", "made by a test"});
    EXPECT_THROW(pictures.write((folder / "a.gif").string(), picture()), InputError);
    EXPECT_THROW(pictures.write((folder / "nowhere" / "a.svg").string(), picture()), InputError);
    pictures.finish();
  }
  EXPECT_THAT(TemporaryFolder::read(folder / "a.png"), StartsWith("\x89PNG"));
  const std::string svg = TemporaryFolder::read(folder / "a.SVG"),
                    pdf = TemporaryFolder::read(folder / "a.pdf");
  EXPECT_THAT(svg, HasSubstr("<title>A title</title>"));
  EXPECT_THAT(svg, HasSubstr(">words</text>"));
  EXPECT_THAT(pdf, StartsWith("%PDF-"));
  for (const std::string& file : {svg, pdf}) EXPECT_THAT(file, HasSubstr("made by a test"));
  EXPECT_FALSE(fs::exists(folder / "a.gif"));
}

}  // namespace
}  // namespace asperity
