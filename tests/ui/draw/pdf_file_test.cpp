#include "ui/draw/picture_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>

#include "tests/core/temporary_folder.h"
#include "tests/ui/chart/sample_sheets.h"
#include "tests/ui/contact/sample_frame.h"
#include "ui/chart/diagram_picture.h"
#include "ui/contact/contact_picture.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

class PdfFile : public testing::Test {
 protected:
  /// What a program of poppler says of a picture written as PDF.
  std::string said(const std::string& program, const DrawList& list,
                   const PictureProperties& properties = {}) {
    const fs::path path = folder_ / "picture.pdf";
    writePicture(path, list, properties);
    const std::string command =
        program + " '" + path.string() + "'" + (program == "pdftotext" ? " -" : "") + " 2>&1";
    std::FILE* const pipe = popen(command.c_str(), "r");
    std::string answer;
    std::array<char, 4096> block;
    while (const std::size_t size = std::fread(block.data(), 1, block.size(), pipe))
      answer.append(block.data(), size);
    EXPECT_EQ(pclose(pipe), 0) << answer;
    return answer;
  }

  TemporaryFolder folder_;
};

TEST_F(PdfFile, EmbedsItsFonts) {
  const std::string fonts = said("pdffonts", composeDiagrams(figureSheets()[0].sheet, {}));
  for (const char* font : {"DejaVuSans ", "DejaVuSans-Bold "}) {
    const std::size_t at = fonts.find(font);
    ASSERT_NE(at, std::string::npos) << fonts;
    const std::string line = fonts.substr(at, fonts.find('\n', at) - at);
    EXPECT_THAT(line, HasSubstr("yes")) << fonts;  // embedded
  }
  EXPECT_THAT(fonts, Not(HasSubstr("Type 3")));
}

TEST_F(PdfFile, HoldsTextsAsTexts) {
  const std::string words = said("pdftotext", composeDiagrams(figureSheets()[0].sheet, {}));
  for (const char* part : {"sliding velocity (m/s)", "Eq. (11)", "variant 2", "III"})
    EXPECT_THAT(words, HasSubstr(part));
}

TEST_F(PdfFile, IsOnePageOfThePicturesSizeAndSaysWhatItIs) {
  const DrawList list = composeDiagrams(figureSheets()[0].sheet, {});
  const std::string facts = said("pdfinfo", list, {"Fig. 2", ""});
  EXPECT_THAT(facts, HasSubstr("Title:           Fig. 2"));
  EXPECT_THAT(facts, HasSubstr("900 x 600 pts"));
  EXPECT_THAT(facts, HasSubstr("Pages:           1"));
  EXPECT_THAT(facts, Not(HasSubstr("CreationDate")));
  EXPECT_THAT(pdfBytes(list, {"", "<seed & scene>"}), HasSubstr("&lt;seed &amp; scene&gt;"));
}

TEST_F(PdfFile, SamePictureSameBytes) {
  for (const DrawList& list : {composeDiagrams(figureSheets()[2].sheet, {}),
                               composeContact(*sampleFrame({.points = 300}), {})}) {
    const std::string bytes = pdfBytes(list, {"title", "metadata"});
    EXPECT_EQ(pdfBytes(list, {"title", "metadata"}), bytes);
    // The date is the one thing that would differ a second later.
    EXPECT_THAT(bytes, Not(HasSubstr("(D:")));
    EXPECT_THAT(bytes, Not(HasSubstr("uuid:")));
  }
}

}  // namespace
}  // namespace asperity
