// What a batch gives to look at: a page that needs no network, and a table. Pure; any thread.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/batch_file.h"
#include "core/friction/curve_point.h"

namespace asperity {

/// An item that was run.
struct BatchResult {
  BatchItem item;  // with its error, if there was one
  /// Means over the scene's lines in steady sliding at its velocity; of a motion, none.
  std::optional<CurvePoint> mean;
  /// Of the line shown, at the moment shown.
  double lineMu = kNotApplicable, lineIndentation = kNotApplicable;
  double lineContactFraction = kNotApplicable;
  std::vector<std::string> files;  // names in the folder; the picture first
};

/// sheets: names of the files with the pictures of all scenes.
std::string batchPage(const Batch& batch, const std::vector<BatchResult>& results,
                      const std::vector<std::string>& sheets);

/// One row for each item: name, the keys varied in any of them, means over the scene's lines, their
/// number, results of the line shown, error.
std::string batchTable(const std::vector<BatchResult>& results);

}  // namespace asperity
