// Arrangement of the pictures of many scenes on contact sheets. Each sheet is about as wide as it
// is high, and no sheet is larger than the renderer can draw. Pure; any thread.
#pragma once

#include <string>
#include <vector>

namespace asperity {

/// Maximum length in pixels of a sheet's longer side; a quarter of the area that can be drawn.
inline constexpr int kLargestSheet = 8192;

class ContactSheets {
 public:
  /// Arranges `count` pictures, each with the proportions of width x height pixels.
  ContactSheets(int count, int width, int height);

  int cellWidth() const { return cellWidth_; }  // width in pixels of one picture on a sheet
  int cellHeight() const { return cellHeight_; }
  int sheets() const { return (count_ + perSheet() - 1) / perSheet(); }
  int widthOf(int sheet) const;
  int heightOf(int sheet) const;

  struct Cell {
    int sheet = 0, left = 0, top = 0;  // pixels
  };
  Cell cell(int picture) const;

  /// Returns the file names "contact_sheet.png", "contact_sheet_2.png" and so on.
  std::vector<std::string> names() const;

 private:
  int perSheet() const { return columns_ * rows_; }
  int on(int sheet) const;  // number of pictures on this sheet

  int count_, cellWidth_, cellHeight_;
  int columns_ = 1, rows_ = 1;  // of a full sheet
};

/// Returns whether a file of this name may be a contact sheet.
bool isSheetName(const std::string& name);

}  // namespace asperity
