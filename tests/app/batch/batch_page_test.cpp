// Contact sheets of any number of pictures of any proportions.
#include "app/batch/batch_page.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

namespace asperity {
namespace {

TEST(ContactSheets, EveryPictureHasAPlaceOfItsOwnOnASheetThatCanBeDrawn) {
  for (const auto& [width, height] :
       {std::pair{960, 900}, {160, 16384}, {16384, 160}, {300, 300}, {1280, 720}, {200, 4000}})
    for (const int count : {1, 2, 3, 17, 306, 307, 1000}) {
      const ContactSheets sheets(count, width, height);
      std::set<std::tuple<int, int, int>> places;
      for (int i = 0; i < count; ++i) {
        const auto [sheet, left, top] = sheets.cell(i);
        places.insert({sheet, left, top});
        ASSERT_LT(sheet, sheets.sheets());
        EXPECT_LE(left + sheets.cellWidth(), sheets.widthOf(sheet)) << count;
        EXPECT_LE(top + sheets.cellHeight(), sheets.heightOf(sheet)) << count;
      }
      EXPECT_EQ(places.size(), static_cast<std::size_t>(count));
      EXPECT_EQ(sheets.names().size(), static_cast<std::size_t>(sheets.sheets()));
      for (int sheet = 0; sheet < sheets.sheets(); ++sheet) {
        EXPECT_GT(sheets.widthOf(sheet), 0);
        EXPECT_LE(sheets.widthOf(sheet), kLargestSheet);
        EXPECT_GT(sheets.heightOf(sheet), 0);
        EXPECT_LE(sheets.heightOf(sheet), kLargestSheet);
      }
    }
}

TEST(ContactSheets, ProportionsAreThoseOfThePictures) {
  EXPECT_EQ(ContactSheets(4, 960, 900).cellWidth(), 480);
  EXPECT_EQ(ContactSheets(4, 960, 900).cellHeight(), 450);
  const ContactSheets tall(4, 200, 4000);
  EXPECT_NEAR(static_cast<double>(tall.cellHeight()) / tall.cellWidth(), 20, 1);
}

/// As in the pictures and in the window.
TEST(BatchPage, ValuesHaveTheNotationOfPictures) {
  BatchResult result;
  result.item.name = "a";
  result.item.varied = {{"load.normal_force", "0.001"}, {"elastomer.temperature", "298.15"}};
  result.mean.emplace();
  result.mean->mu = 0.019143815;
  result.mean->muStandardError = 0.0025359;
  result.mean->realizations = 3;
  result.files = {"a.png"};
  const std::string page = batchPage({}, {result}, {});
  for (const char* text : {"<td>1 mN</td>", "<td>298.15 K</td>", "<td>0.0191 \u00B1 0.0025 ("})
    EXPECT_NE(page.find(text), std::string::npos) << text << " in\n" << page;
}

TEST(ContactSheets, NamesOfSheetsAreKnown) {
  const ContactSheets many(700, 960, 900);
  EXPECT_GT(many.sheets(), 2);
  EXPECT_EQ(many.names().front(), "contact_sheet.png");
  for (const std::string& name : many.names()) EXPECT_TRUE(isSheetName(name)) << name;
  for (const char* name :
       {"contact_sheet.csv", "contact_sheets.png", "contact_sheet_a.png", "a.png"})
    EXPECT_FALSE(isSheetName(name)) << name;
}

}  // namespace
}  // namespace asperity
