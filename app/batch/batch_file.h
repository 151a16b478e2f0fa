// The file of `asperity batch`. Its entries are scenes with sweeps of their keys; reading spreads
// them out into the single scenes to be run. The functions are pure but for reading; any thread.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/message.h"
#include "core/scene/scene.h"

namespace asperity {

/// One scene to run, or the reason why it cannot run.
struct BatchItem {
  std::string name;                                         // first part of the names of its files
  std::vector<std::pair<std::string, std::string>> varied;  // key and value of each swept parameter
  std::string show;                                         // layout of the picture
  Scene scene;
  std::vector<std::filesystem::path> inputs;  // files from which the item is read
  std::string ownTitle;                       // title of the scene without them
  Message title;                              // title of the scene, and its values in the sweep
  Message error;                              // one sentence; empty: the item can run
};

/// Returns the files that an item can write: its picture, table and scene.
std::vector<std::string> outputFiles(const BatchItem& item);

struct Batch {
  std::string title;
  std::string size = "960x900";  // of each picture
  std::vector<BatchItem> items;
};

/// Describes for users what the file may contain.
extern const char* const kBatchFormat;

/// Reads a batch. An invalid entry becomes an item with an error. Throws InputError where the file
/// as a whole cannot be read, or where two entries would write the same file, or one entry a file
/// of the whole batch.
Batch readBatch(const std::filesystem::path& file);
/// Reads the same from a text; `file` is named in errors and gives the folder of its scenes.
Batch readBatch(std::string_view json, const std::filesystem::path& file);

/// Returns the members of an item except its scene, for the provenance of its files: {"name",
/// "show", "title", "varied"}, or {"name", "varied", "error"}.
nlohmann::ordered_json itemJson(const BatchItem& item);

struct FoundScene;
/// Returns the batch, of one item or of all, that made a file. Throws InputError where the file
/// does not contain it.
Batch restoreBatch(const FoundScene& found);

}  // namespace asperity
