// What a batch gives to look at: a page that needs no network, and a table. Pure; any thread.
#pragma once

#include <string>
#include <vector>

#include "app/batch_file.h"
#include "core/friction/curve_point.h"

namespace asperity {

/// An item that was run.
struct BatchResult {
  BatchItem item;  // with its error, if there was one
  double mu = kNotApplicable, indentation = kNotApplicable, contactFraction = kNotApplicable;
  std::vector<std::string> files;  // names in the folder; the picture first
};

std::string batchPage(const Batch& batch, const std::vector<BatchResult>& results);

/// One row for each item: name, the keys varied in any of them, results.
std::string batchTable(const std::vector<BatchResult>& results);

}  // namespace asperity
