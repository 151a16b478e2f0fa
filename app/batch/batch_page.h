// The summaries of a batch: sheets with the pictures of all scenes, an HTML page that needs no
// network, and a table. Pure; any thread.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/batch/batch_file.h"
#include "core/friction/curve_point.h"
#include "core/scene/data_table.h"

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
  int picturesOn(int sheet) const;

  int count_, cellWidth_, cellHeight_;
  int columns_ = 1, rows_ = 1;  // of a full sheet
};

/// Returns whether a file of this name may be a contact sheet.
bool isSheetName(const std::string& name);

/// An item that was run, with its results.
struct BatchResult {
  BatchItem item;  // with its error, if there was one
  /// Means over the scene's lines in steady sliding at its velocity. It is empty for a motion.
  std::optional<CurvePoint> mean;
  /// Results of the line in the picture, at the time of the picture.
  double lineMu = kNotApplicable, lineIndentation = kNotApplicable;
  double lineContactFraction = kNotApplicable;
  std::vector<std::string> files;  // names in the folder; the picture first
  std::vector<Message> reading{};  // how the file of its surface was read (readingFacts)
  /// Why its curve or its mean misses the target of its scene; empty: neither does.
  Message missed{};

  /// Returns what is wrong with it: its error, or what it misses.
  const Message& fault() const { return item.error.empty() ? missed : item.error; }
};

/// Returns the page in HTML. sheets: names of the files with the pictures of all scenes.
std::string batchPage(const Batch& batch, const std::vector<BatchResult>& results,
                      const std::vector<std::string>& sheets);

/// Returns a table with one row for each item: name, the keys varied in any item, means over the
/// scene's lines, number of lines, results of the line in the picture, error or missed target.
DataTable batchTable(const std::vector<BatchResult>& results);

}  // namespace asperity
