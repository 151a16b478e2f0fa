// The progress of a batch: one line for each finished scene in a hidden file of its folder, so that
// the same command continues after an interruption. A scene counts as finished only if nothing that
// influences its files has changed and the files exist. Main thread.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "app/batch/batch_page.h"

namespace asperity {

/// A finished scene: its numbers, its curve and its files. One that misses its target accuracy is
/// not kept: another run computes it again, and tells it again.
struct BatchProgressEntry {
  BatchResult result;  // without the item
  std::vector<CurvePoint> curve;
};

class BatchProgress {
 public:
  /// Reads what an earlier run of the program has left in the folder; a damaged line ends it.
  explicit BatchProgress(const std::filesystem::path& folder);

  /// Returns the entry of a finished scene; null where there is none. key: a digest of everything
  /// that influences the files of the scene.
  const BatchProgressEntry* find(const std::string& key) const;
  /// Adds a line. A failure to write it is no error: the scene would be computed again.
  void add(const std::string& key, const BatchProgressEntry& entry);
  /// Removes the file, when everything is done.
  void remove() const;

 private:
  std::filesystem::path folder_, file_;
  std::map<std::string, BatchProgressEntry> entries_;
};

}  // namespace asperity
