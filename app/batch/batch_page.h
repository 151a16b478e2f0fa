// The summaries of a batch: an HTML page that needs no network, and a table. Pure; any thread.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/batch/batch_file.h"
#include "core/friction/curve_point.h"

namespace asperity {

/// An item that was run, with its results.
struct BatchResult {
  BatchItem item;  // with its error, if there was one
  /// Means over the scene's lines in steady sliding at its velocity. It is empty for a motion.
  std::optional<CurvePoint> mean;
  /// Results of the line in the picture, at the time of the picture.
  double lineMu = kNotApplicable, lineIndentation = kNotApplicable;
  double lineContactFraction = kNotApplicable;
  std::vector<std::string> files;  // names in the folder; the picture first
};

/// Returns the page in HTML. sheets: names of the files with the pictures of all scenes.
std::string batchPage(const Batch& batch, const std::vector<BatchResult>& results,
                      const std::vector<std::string>& sheets);

/// Returns a table with one row for each item: name, the keys varied in any item, means over the
/// scene's lines, number of lines, results of the line in the picture, error.
std::string batchTable(const std::vector<BatchResult>& results);

}  // namespace asperity
