// How the pictures of many scenes share contact sheets: so many in a row and on a sheet that each
// sheet is about as wide as high and none larger than can be drawn. Pure; any thread.
#pragma once

#include <string>
#include <vector>

namespace asperity {

/// Pixels of a sheet's longer side, at most: a quarter of the area that the renderer could draw.
inline constexpr int kLargestSheet = 8192;

class ContactSheets {
 public:
  /// For `count` pictures of the same proportions as one of width x height pixels.
  ContactSheets(int count, int width, int height);

  int cellWidth() const { return cellWidth_; }  // pixels, of one picture on a sheet
  int cellHeight() const { return cellHeight_; }
  int sheets() const { return (count_ + perSheet() - 1) / perSheet(); }
  int widthOf(int sheet) const;
  int heightOf(int sheet) const;

  struct Cell {
    int sheet = 0, left = 0, top = 0;  // pixels
  };
  Cell cell(int picture) const;

  /// "contact_sheet.png", "contact_sheet_2.png" and on.
  std::vector<std::string> names() const;

 private:
  int perSheet() const { return columns_ * rows_; }
  int on(int sheet) const;  // pictures

  int count_, cellWidth_, cellHeight_;
  int columns_ = 1, rows_ = 1;  // of a whole sheet
};

/// Whether a file of this name may be a contact sheet.
bool isSheetName(const std::string& name);

}  // namespace asperity
